//! The best optimum over several starts, with weights that agree with it.

use super::adjust::{Adjust, NEAR_PROMISE};
use super::descent::{End, Problem};
use super::linearization::Linearization;
use super::measurement_noise::sigmas;
use super::robust;
use super::rows::recorded_state;
use crate::fit::{InputError, Settings};
use crate::misfit::Misfit;
use crate::norms::Norms;
use crate::progress::{Progress, Stopped};
use crate::starts::{self, Landscape, Part, Starts};
use crate::stopping::StoppedBy;
use crate::trail::Trail;
use cdpr_model::geometry::Wrench;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{ExternalWrench, Parameter, ParameterKind, Robot};
use cdpr_model::statics::{Load, StaticsError, cable_state};

/// Share of the cost that the next step may still promise where optima of several starts are told apart.
const SEARCH_PROMISE: f64 = 1e-9;

/// The optimum and what belongs to it.
pub(crate) struct Optimum {
    /// The model before the fit; with a free wrench its robot states a constant one.
    pub(super) start_model: Model,
    pub(super) calibrated: Model,
    pub(super) tensions: Vec<f64>,
    pub(super) linearization: Linearization,
    /// False when no sensor accuracy is known, so that only the ratio of the rows' weights is assumed.
    pub(super) absolute: bool,
    /// Noise that the weights stand for, as a multiple of what is stated or assumed.
    pub(super) noise: f64,
    /// Misfit in units of the weights.
    pub(super) misfit: Misfit,
    /// Norms of the samples' residuals, with the loss.
    pub(super) norms: Norms,
    pub(super) end: End,
    pub(super) starts: Starts,
}

impl Optimum {
    pub(crate) fn calibrated(&self) -> &Model {
        &self.calibrated
    }

    /// Weighted squares of data and priors.
    pub(crate) fn cost(&self) -> f64 {
        self.end.cost
    }

    pub(crate) fn converged(&self) -> bool {
        self.end.converged()
    }

    pub(super) fn stopped(&self) -> StoppedBy {
        self.end.stopped
    }

    pub(crate) fn iterations(&self) -> u32 {
        self.end.iterations
    }

    pub(crate) fn trail(&self) -> &Trail {
        &self.end.trail
    }
}

/// Finds the optimum of an elastic model; `progress` is called after each start.
pub(crate) fn find(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
    progress: &Progress<'_>,
) -> Result<Optimum, InputError> {
    let tensions = checked_tensions(model, samples)?;
    let start_model = with_constant_wrench(model, samples, &tensions, parameters)?;
    check_paths(&start_model, samples, &tensions)?;
    let (sigmas, absolute) = sigmas(samples, tensions.iter().sum::<f64>() / tensions.len() as f64);
    let problem = Problem::new(&start_model, samples, &tensions, parameters, settings);
    let mut adjust = Adjust { problem: &problem, sigmas, noise: 1.0 };
    let mut linearization = adjust.measured(&start_model)?;
    let (mut end, starts) = search(&problem, &linearization, progress)?;
    if !parameters.is_empty() {
        adjust.settle(&mut end, &mut linearization)?;
        if !absolute && !settings.priors.is_empty() {
            adjust.agree_with_noise(&mut end, &mut linearization)?;
        }
    }
    let mut norms = Norms::default();
    let mut misfit = problem.misfit(&end, &linearization);
    if !parameters.is_empty() {
        norms = adjust.norms(&end, &linearization, absolute)?;
        if let Some(tail) = norms.to_ask(settings.loss, end.converged()) {
            let found = robust::minimise(tail, &adjust, &end, &linearization, &norms)?;
            if found.norms.answer(settings.loss) {
                misfit = found.misfit;
                (end, linearization, norms, adjust.noise) = (found.end, found.linearization, found.norms, found.noise);
            }
        }
    }
    let noise = adjust.noise;
    let calibrated = problem.model_at(&end.values).ok_or(InputError::NotFinite)?;
    Ok(Optimum { calibrated, linearization, absolute, noise, misfit, norms, end, starts, tensions, start_model })
}

/// Descends from the file's values and from other starts; the lowest end wins.
pub(super) fn search(
    problem: &Problem<'_>,
    linearization: &Linearization,
    progress: &Progress<'_>,
) -> Result<(End, Starts), Stopped> {
    // one start only has to come near; several must be told apart
    let stop = if problem.settings.starts > 1 { SEARCH_PROMISE } else { NEAR_PROMISE };
    let part =
        Part { parameters: problem.parameters.to_vec(), start: problem.start.clone(), scale: problem.scale().to_vec() };
    let tension = problem.tensions.iter().sum::<f64>() / problem.tensions.len().max(1) as f64;
    let search = starts::Search { parts: &[part], settings: problem.settings, samples: problem.samples.len(), tension };
    let mut together = Together { problem, linearization, stop };
    let mut best = [problem.descend(&problem.start, linearization, stop)];
    let starts = search.run(&mut together, &mut best, progress)?;
    let [best] = best;
    Ok((best, starts))
}

/// All parameters of an elastic model.
struct Together<'a> {
    problem: &'a Problem<'a>,
    linearization: &'a Linearization,
    stop: f64,
}

impl Landscape for Together<'_> {
    type End = End;

    fn descend(&mut self, _: usize, change: &[f64]) -> End {
        let from: Vec<f64> = self.problem.start.iter().zip(change).map(|(start, change)| start + change).collect();
        self.problem.descend(&from, self.linearization, self.stop)
    }

    fn cost(&mut self, _: usize, place: &[f64], _: &End) -> f64 {
        self.problem.cost(place, self.linearization)
    }
}

/// Recorded tensions, refused where they are missing or cables push by more than the sensors' noise.
pub(super) fn checked_tensions(model: &Model, samples: &Samples) -> Result<Vec<f64>, InputError> {
    let tensions = samples.tensions.clone().ok_or(InputError::NoTensions)?;
    let allowance = 5.0 * samples.sigmas.tension.unwrap_or(0.0);
    let m = model.cable_count();
    let pushing: Vec<usize> = (0..samples.len())
        .filter(|sample| (0..m).any(|cable| model.real_tension(cable, tensions[sample * m + cable]) < -allowance))
        .collect();
    match pushing.first() {
        None => Ok(tensions),
        Some(&first) => {
            let rows = &tensions[first * m..][..m];
            let worst = (0..m).min_by(|a, b| rows[*a].total_cmp(&rows[*b])).unwrap_or(0);
            Err(InputError::NegativeTension {
                samples: pushing.iter().map(|sample| sample + 1).collect(),
                cable: worst + 1,
                tension: rows[worst],
            })
        }
    }
}

pub(super) fn check_paths(model: &Model, samples: &Samples, tensions: &[f64]) -> Result<(), InputError> {
    let m = model.cable_count();
    for (sample, pose) in samples.poses.iter().enumerate() {
        for cable in 0..model.cable_count() {
            let tension = model.real_tension(cable, tensions[sample * m + cable]);
            match cable_state(model, pose, cable, tension) {
                Err(StaticsError::CablePath(reason)) => {
                    return Err(InputError::Degenerate { sample: sample + 1, reason });
                }
                Err(StaticsError::CableState { cable, reason }) => {
                    return Err(InputError::CableState { sample: sample + 1, cable, reason });
                }
                _ => {}
            }
        }
    }
    Ok(())
}

/// A free wrench is the constant total in world axes: it replaces the weight, and starts at what the file states for the
/// mean pose, or, where the file is silent, at what the recorded tensions balance in the mean.
pub(crate) fn with_constant_wrench(
    model: &Model,
    samples: &Samples,
    tensions: &[f64],
    parameters: &[Parameter],
) -> Result<Model, InputError> {
    let stated = Load::of(model.robot());
    if !parameters.iter().any(|parameter| parameter.kind == ParameterKind::Wrench) {
        return stated.map(|_| model.clone()).map_err(InputError::from);
    }
    let mean = |wrench: &dyn Fn(usize) -> Wrench| (0..samples.len()).map(wrench).sum::<Wrench>() / samples.len() as f64;
    let wrench = match stated {
        Ok(load) => mean(&|sample| load.wrench(&samples.poses[sample])),
        Err(_) => mean(&|sample| -pull(model, samples, tensions, sample)),
    };
    let external = ExternalWrench { wrench, includes_gravity: true, note: Some("identified".to_owned()) };
    let robot = Robot { external_wrench: Some(external), ..model.robot().clone() };
    Ok(Model::new(robot, model.composition())?)
}

/// Wrench of all cables on the platform (world).
fn pull(model: &Model, samples: &Samples, tensions: &[f64], sample: usize) -> Wrench {
    let m = model.cable_count();
    let mut sum = Wrench::zeros();
    for cable in 0..m {
        let pose = &samples.poses[sample];
        let state = recorded_state(model, cable, pose, &pose.rotation_rows(), tensions[sample * m + cable]);
        sum += state.map_or_else(|| Wrench::repeat(f64::NAN), |state| state.wrench());
    }
    sum
}
