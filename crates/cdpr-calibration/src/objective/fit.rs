//! Optimum of an objective under any cost.

use crate::progress::Progress;
use std::borrow::Cow;

use super::cost::{Cost, Ridge, Shape};
use super::dense::DenseEquations;
use super::minimax::{self, Certificate};
use super::problem::ObjectiveVectors;
use super::vectors::{Latent, Stacked, Vectors};
use super::{Minimize, Objective};
use crate::elastostatic::checked_start;
use crate::fit::{InputError, Settings, prior_sigma};
use crate::joint_descent::{Around, End, descend};
use crate::loss::Loss;
use crate::norms::Norms;
use crate::starts::{self, Ending, Landscape, Part, Starts};
use crate::stopping::{StoppedBy, StoppingRule};
use crate::trail::Trail;
use crate::unit_scale::joint_scales;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, Model, RecordingParameter};
use cdpr_model::robot::Parameter;
use cdpr_model::solve::{ROUNDING_GAIN, Rules};

/// The optimum and what belongs to it.
pub(crate) struct Optimum {
    /// Values before the fit; a free wrench starts from the constant one of the robot's load.
    pub(super) start: Vec<f64>,
    pub(super) calibrated: Model,
    pub(super) end: End,
    pub(super) starts: Starts,
    pub(super) scale: Vec<f64>,
    /// Metres that are one unit of the vectors; `None` where these are standard deviations of several quantities.
    pub(super) unit: Option<f64>,
    pub(super) absolute: bool,
    /// Norms of the samples' vectors, with the loss.
    pub(super) norms: Norms,
    pub(super) certificate: Option<Certificate>,
}

impl Optimum {
    pub(crate) fn calibrated(&self) -> &Model {
        &self.calibrated
    }

    pub(crate) fn into_calibrated(self) -> Model {
        self.calibrated
    }

    pub(crate) fn end(&self) -> &End {
        &self.end
    }

    /// Vectors at the optimum.
    pub(crate) fn stacked(&self, vectors: &mut impl Vectors) -> Result<Stacked, InputError> {
        let mut stacked = Stacked::new(vectors, self.end.values.len());
        vectors.write(&self.end.values, &mut stacked).then_some(stacked).ok_or(InputError::NotFinite)
    }
}

/// Refuses what cannot be combined.
fn check(settings: &Settings) -> Result<(), InputError> {
    if settings.minimize != Minimize::Squares && !matches!(settings.loss, Loss::Auto | Loss::Squared) {
        return Err(InputError::RobustCost { loss: settings.loss, minimize: settings.minimize });
    }
    if settings.minimize != Minimize::Squares && !settings.priors.is_empty() {
        return Err(InputError::PriorCost { minimize: settings.minimize });
    }
    Ok(())
}

/// Refuses parameters of the recording, which only squares of lengths tell.
pub(crate) fn check_recording(free: &FreeParameters, settings: &Settings) -> Result<(), InputError> {
    let of_recording =
        [RecordingParameter::ClockOffset, RecordingParameter::TrackerFrame, RecordingParameter::MarkerFrame];
    let freed = of_recording
        .into_iter()
        .find(|parameter| free.names_recording(*parameter) && !settings.hold.names_recording(*parameter));
    freed.map_or(Ok(()), |parameter| Err(InputError::RecordingCost { name: parameter.name() }))
}

/// Finds the optimum; `progress` is called after each start.
pub(crate) fn optimum(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
    progress: &Progress<'_>,
) -> Result<Optimum, InputError> {
    let nothing = |_: &Optimum, _: &mut ObjectiveVectors<'_>| Ok(());
    find(model, samples, parameters, settings, progress, nothing).map(|(optimum, ())| optimum)
}

/// Finds the optimum and what is asked of it with its vectors.
pub(super) fn find<T>(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
    progress: &Progress<'_>,
    of_optimum: impl FnOnce(&Optimum, &mut ObjectiveVectors<'_>) -> Result<T, InputError>,
) -> Result<(Optimum, T), InputError> {
    check(settings)?;
    if settings.objective == Objective::Pose && model.needs_tensions() && samples.tensions.is_none() {
        return Err(InputError::PosesWithoutTensions);
    }
    let start_model = match model.needs_tensions() {
        true => Cow::Owned(checked_start(model, samples, parameters)?),
        false => Cow::Borrowed(model),
    };
    let tensions = samples.tensions.as_deref().unwrap_or_default();
    let mean_tension = tensions.iter().sum::<f64>() / tensions.len().max(1) as f64;
    let scale = joint_scales(&start_model, parameters, &samples.lengths, tensions);
    let (mut vectors, unit) = ObjectiveVectors::of(&start_model, samples, parameters, settings)?;
    let absolute = are_stated(model, samples, settings);
    let units = Units { scale, unit, absolute, mean_tension };
    let found = search(&mut vectors, &start_model, parameters, units, settings, progress, None).and_then(|optimum| {
        let answer = of_optimum(&optimum, &mut vectors)?;
        Ok((optimum, answer))
    });
    found.map_err(|error| match vectors.unpredicted() {
        Some((sample, reason)) if error == InputError::NotFinite => {
            InputError::NoPrediction { sample: sample + 1, reason }
        }
        _ => error,
    })
}

/// True where the accuracies are stated that weigh the vectors of an objective.
fn are_stated(model: &Model, samples: &Samples, settings: &Settings) -> bool {
    let is_stated = |sigma: Option<f64>| sigma.is_some_and(|sigma| sigma > 0.0);
    let sigmas = &samples.sigmas;
    let turns = model.robot().motion_pattern.has_rotation();
    match (settings.objective, model.needs_tensions()) {
        (Objective::Length, false) => is_stated(sigmas.length),
        // rotations count beside positions by a length that is none of their accuracies
        (Objective::Pose, false) if turns && (settings.rotation_length.is_some() || !is_stated(sigmas.rotation)) => {
            false
        }
        _ => is_stated(sigmas.position),
    }
}

/// Sizes of parameters and vectors.
pub(crate) struct Units {
    /// Metres of one unit of each parameter.
    pub(crate) scale: Vec<f64>,
    /// Metres of one unit of the vectors; `None` where these are standard deviations of several quantities.
    pub(crate) unit: Option<f64>,
    /// True where these deviations are stated, so that smaller residuals are luck.
    pub(crate) absolute: bool,
    /// Mean recorded tension, 0 without (N).
    pub(crate) mean_tension: f64,
}

/// Finds the optimum of vectors from a model's values, with a first descent `from` others where these are known to lead there.
pub(crate) fn search(
    vectors: &mut impl Vectors,
    start_model: &Model,
    parameters: &[Parameter],
    Units { scale, unit, absolute, mean_tension }: Units,
    settings: &Settings,
    progress: &Progress<'_>,
    from: Option<&[f64]>,
) -> Result<Optimum, InputError> {
    let start: Vec<f64> = parameters.iter().map(|parameter| parameter.value(start_model.robot())).collect();
    let search = Search { parameters, scale: &scale, start: &start, settings };
    let (end, starts) = search.run(vectors, from.unwrap_or(&start), mean_tension, progress)?;
    let (mut end, mut norms, mut certificate) = (end, Norms::default(), None);
    match settings.minimize {
        Minimize::Squares => (end, norms) = search.under_loss(vectors, end, absolute)?,
        Minimize::Mean => {}
        Minimize::Max => (end, certificate) = search.minimax(vectors, &end)?,
    }
    let calibrated = start_model.with_parameters(parameters, &end.values).ok_or(InputError::NotFinite)?;
    Ok(Optimum { start, calibrated, end, starts, scale, unit, absolute, norms, certificate })
}

/// Searches for better places of what is eliminated from the vectors, at most.
const SEARCHES: u32 = 10;

/// Times that norms are smoothed less: the last sum of norms is the least to a billionth.
const SMOOTHINGS: u32 = 9;

/// Σ ‖r‖ at these values; not a number where there are no vectors.
fn sum_of_norms(vectors: &mut impl Vectors, values: &[f64]) -> f64 {
    let mut stacked = Stacked::new(vectors, values.len());
    match vectors.write(values, &mut stacked) {
        true => (0..stacked.samples()).map(|sample| stacked.square(sample).sqrt()).sum(),
        false => f64::NAN,
    }
}

/// End of a descent, with what was eliminated from the samples' vectors there.
#[derive(Clone)]
struct Settled {
    end: End,
    latents: Vec<Latent>,
}

impl Ending for Settled {
    fn cost(&self) -> f64 {
        self.end.cost
    }

    fn converged(&self) -> bool {
        self.end.converged()
    }

    fn place(&self) -> &[f64] {
        &self.end.values
    }
}

/// All parameters under an objective.
struct Together<'a, 's, V> {
    search: &'a Search<'s>,
    vectors: &'a mut V,
}

impl<V: Vectors> Landscape for Together<'_, '_, V> {
    type End = Settled;

    fn descend(&mut self, _: usize, change: &[f64]) -> Settled {
        let from: Vec<f64> = self.search.start.iter().zip(change).map(|(start, change)| start + change).collect();
        let patience = self.vectors.patience();
        self.search.settle(self.vectors, &from, patience)
    }

    fn cost(&mut self, _: usize, place: &[f64], near: &Settled) -> f64 {
        self.vectors.go_on_from(&near.latents);
        self.search.cost(self.vectors, place)
    }
}

/// Unknowns and start of a search.
pub(super) struct Search<'a> {
    parameters: &'a [Parameter],
    pub(super) scale: &'a [f64],
    start: &'a [f64],
    pub(super) settings: &'a Settings,
}

impl Search<'_> {
    /// Descends from the file's values and from other starts; the lowest end wins. The largest norm starts from least squares.
    fn run(
        &self,
        vectors: &mut impl Vectors,
        from: &[f64],
        tension: f64,
        progress: &Progress<'_>,
    ) -> Result<(End, Starts), InputError> {
        let part =
            Part { parameters: self.parameters.to_vec(), start: self.start.to_vec(), scale: self.scale.to_vec() };
        let samples = vectors.samples();
        let mut best = [self.settle(vectors, from, None)];
        if !best[0].cost().is_finite() {
            return Err(InputError::NotFinite);
        }
        let search = starts::Search { parts: &[part], settings: self.settings, samples, tension };
        let starts = search.run(&mut Together { search: self, vectors }, &mut best, progress)?;
        let [best] = best;
        // the answer is told where it was found, whatever other starts led to
        vectors.go_on_from(&best.latents);
        Ok((best.end, starts))
    }

    /// Cost that descents make small; not a number where there are no vectors.
    fn cost(&self, vectors: &mut impl Vectors, values: &[f64]) -> f64 {
        if self.settings.minimize == Minimize::Mean {
            return sum_of_norms(vectors, values);
        }
        let mut stacked = Stacked::new(vectors, values.len());
        let of_ridge = |ridge: Ridge| ridge.weight * (values[ridge.parameter] - ridge.centre).powi(2);
        match vectors.write(values, &mut stacked) {
            true => stacked.residuals.norm_squared() + self.ridges().into_iter().map(of_ridge).sum::<f64>(),
            false => f64::NAN,
        }
    }

    fn settle(&self, vectors: &mut impl Vectors, from: &[f64], patience: Option<u32>) -> Settled {
        let end = self.descend(vectors, from, patience);
        Settled { end, latents: vectors.latents() }
    }

    fn descend(&self, vectors: &mut impl Vectors, from: &[f64], patience: Option<u32>) -> End {
        let squares = self.descend_under(Shape::Square, vectors, from, patience);
        match self.settings.minimize {
            Minimize::Mean => self.follow_norms(vectors, squares),
            _ => squares,
        }
    }

    /// The least sum of norms, from an optimum of least squares by ever less smoothing.
    fn follow_norms(&self, vectors: &mut impl Vectors, squares: End) -> End {
        let start = sum_of_norms(vectors, &squares.values);
        let mut smoothing = start / vectors.samples() as f64;
        let mut end = End { cost: start, ..squares };
        end.trail.costs = vec![start];
        for _ in 0..SMOOTHINGS {
            if !end.converged() || !(smoothing > 0.0) {
                break;
            }
            smoothing *= 0.1;
            let next = self.descend_under(Shape::Norm(smoothing), vectors, &end.values, None);
            let cost = sum_of_norms(vectors, &next.values);
            let trail = end.trail.joined(Trail { costs: vec![cost], ..next.trail });
            end = End { cost, iterations: end.iterations + next.iterations, trail, ..next };
        }
        end
    }

    fn ridges(&self) -> Vec<Ridge> {
        let ridge = |(parameter, of): (usize, &Parameter)| {
            let sigma = prior_sigma(self.settings, of.kind)?;
            Some(Ridge { parameter, centre: self.start[parameter], weight: 1.0 / (sigma * sigma) })
        };
        self.parameters.iter().enumerate().filter_map(ridge).collect()
    }

    /// Descends by a cost of the norms, by so many steps at most, and on from better places of what is eliminated.
    pub(super) fn descend_under(
        &self,
        shape: Shape,
        vectors: &mut impl Vectors,
        from: &[f64],
        patience: Option<u32>,
    ) -> End {
        let ridges = self.ridges();
        vectors.restart();
        let mut cost = Cost { vectors, stacked: None, shape, ridges: &ridges };
        let Settings { minimizer, keeps_course, .. } = *self.settings;
        let around = Around {
            parameters: self.parameters,
            scale: self.scale,
            minimizer,
            keeps_course,
            ends_ahead: shape == Shape::Square,
        };
        let rules = Rules {
            tolerance: self.settings.tolerance,
            max_iterations: patience.unwrap_or(u32::MAX).min(self.settings.max_iterations),
            least_gain: ROUNDING_GAIN,
            rule: self.settings.minimizer.rule(),
        };
        let mut end = descend(&mut cost, &around, from, DenseEquations::new(from.len()), &rules);
        for _ in 0..SEARCHES {
            if !end.cost.is_finite() || !cost.vectors.seek_again(&end.values) {
                break;
            }
            let next = descend(&mut cost, &around, &end.values, DenseEquations::new(from.len()), &rules);
            let trail = end.trail.then(next.trail);
            end = End { iterations: end.iterations + next.iterations, trail, ..next };
        }
        end
    }

    /// The least largest norm, from an optimum of least squares.
    fn minimax(&self, vectors: &mut impl Vectors, squares: &End) -> Result<(End, Option<Certificate>), InputError> {
        // Newton steps of all centres
        let limit = 10 * self.settings.max_iterations;
        let found = minimax::minimise(vectors, self.parameters, self.scale, &squares.values, limit);
        let found = found.ok_or(InputError::NotFinite)?;
        let stopped = match found.converged {
            true => StoppedBy { rule: StoppingRule::Gap, value: found.certificate.gap, limit: minimax::GAP },
            false => StoppedBy {
                rule: StoppingRule::IterationLimit,
                value: f64::from(found.iterations),
                limit: f64::from(limit),
            },
        };
        let end = End {
            cost: found.certificate.largest,
            values: found.values,
            iterations: squares.iterations + found.iterations,
            trail: squares.trail.clone().then(Trail { costs: found.history, ..Trail::default() }),
            stopped,
        };
        Ok((end, Some(found.certificate)))
    }
}
