//! Smaller models that data cannot tell from the one that was asked for.

#[cfg(test)]
mod tests;

use nalgebra::{Quaternion, UnitQuaternion};

use super::bootstrap::standard_error;
use super::cross_validation::reported_part;
use super::evaluation::evaluate_fitted;
use super::fit::{self, Fit, InputError, checked_parameters, optimum_of};
use super::paired::{Difference, repeated_poses};
use super::path::{PenaltyPath, is_path_of};
use super::point_robot::{as_point, point_robot, without_rotation};
use cdpr_model::geometry::MotionPattern;
use cdpr_model::measurement::{Fold, Samples, decimals};
use cdpr_model::model::{FreeParameters, Model};
use cdpr_model::reading::keywords;
use cdpr_model::robot::{Parameter, ParameterKind};

/// Angle below which orientations are the same (rad).
const SAME: f64 = 1e-9;
/// Multiple of the stated deviation up to which orientations differ no more than their noise, all three components together.
const NOISE: f64 = 3.0;

/// Evidence that a smaller model is enough.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Evidence {
    /// Rank of the Jacobian.
    Rank,
    /// Orientations that differ no more than their noise.
    Noise,
    /// Parameters that leave a path of a penalty.
    Path,
}

keywords!(Evidence: Rank = "rank", Noise = "noise", Path = "path");

/// Smaller model that predicts what was held out as well as the one asked for, on the same samples.
#[derive(Clone, Debug)]
pub struct Reduction {
    /// Evidence.
    pub evidence: Evidence,
    /// The same in words.
    pub reason: String,
    /// Motion patterns of the model asked for and of the smaller one.
    pub patterns: [MotionPattern; 2],
    /// Numbers of their parameters.
    pub parameter_count: [usize; 2],
    /// Names of the parameters that are left out.
    pub left: Vec<String>,
    /// Mean position errors of both on data held out (m).
    pub position_mean_m: [f64; 2],
    /// Standard error of the first.
    pub standard_error: f64,
    /// The second minus the first on the same samples, and the standard error of that (m).
    pub difference: Difference,
    /// The smaller model as given.
    pub nominal: Model,
    /// The smaller model, identified from all samples of the fit.
    pub model: Model,
}

/// A smaller model before it has shown itself.
struct Candidate {
    evidence: Evidence,
    reason: String,
    nominal: Model,
    kept: Vec<Parameter>,
    left: Vec<Parameter>,
}

/// The smaller model that a path of a penalty shows, else the rank of the fit or the noise of orientations; `None` where nothing does, or where what
/// is shown predicts worse. Fits of frames, clocks, other objectives and robust losses have none.
pub fn propose_reduction(
    model: &Model,
    samples: &Samples,
    fit: &Fit,
    settings: &fit::Settings,
    free: &FreeParameters,
    path: Option<&PenaltyPath>,
    folds: &[Fold],
) -> Result<Option<Reduction>, InputError> {
    if is_path_of(free, settings).is_err() {
        return Ok(None);
    }
    let settings = &fit::Settings { starts: 1, loss: super::Loss::Squared, ..settings.clone() };
    let parameters = checked_parameters(model, samples, free, settings)?;
    let by_path = path.and_then(|path| of_path(model, &parameters, path));
    let Some(found) = by_path.or_else(|| of_orientation(model, samples, fit, &parameters)) else { return Ok(None) };
    let trial = Trial { model, parameters: &parameters, settings, found: &found };
    let Some((errors, standard_error, difference)) = trial.held_out(samples, folds)? else { return Ok(None) };
    if !difference.is_none(errors[0]) {
        return Ok(None);
    }
    let part = samples.subset(&reported_part(samples, folds));
    let name = |parameter: &Parameter| parameter.name(model.robot());
    Ok(Some(Reduction {
        patterns: [model, &found.nominal].map(|model| model.robot().motion_pattern),
        parameter_count: [parameters.len(), found.kept.len()],
        left: found.left.iter().map(name).collect(),
        position_mean_m: errors,
        standard_error,
        difference,
        model: trial.reduced(&part)?,
        evidence: found.evidence,
        reason: found.reason,
        nominal: found.nominal,
    }))
}

/// Parameters that stay at the centre of a path are held there.
fn of_path(model: &Model, parameters: &[Parameter], path: &PenaltyPath) -> Option<Candidate> {
    let chosen = path.points.get(path.chosen?)?;
    let is_left = |place: &usize| path.left.contains(&path.parameters[*place].name);
    let (left, kept): (Vec<usize>, Vec<usize>) = (0..parameters.len()).partition(is_left);
    if left.is_empty() {
        return None;
    }
    let of = |places: &[usize]| places.iter().map(|&place| parameters[place]).collect::<Vec<Parameter>>();
    let centres: Vec<f64> = left.iter().map(|&place| path.parameters[place].centre).collect();
    let (left, kept) = (of(&left), of(&kept));
    let nominal = model.with_parameters(&left, &centres)?;
    let reason = format!(
        "{} of {} parameters leave the path at the largest penalty that is as good as the best on the samples held out (λ = {:.*})",
        left.len(),
        parameters.len(),
        decimals(2.0, chosen.lambda),
        chosen.lambda
    );
    Some(Candidate { evidence: Evidence::Path, reason, nominal: as_point(&nominal).unwrap_or(nominal), kept, left })
}

/// Point that lengths at one orientation R tell: a − R b of every cable.
fn of_orientation(model: &Model, samples: &Samples, fit: &Fit, parameters: &[Parameter]) -> Option<Candidate> {
    let (left, kept): (Vec<Parameter>, Vec<Parameter>) =
        parameters.iter().partition(|parameter| parameter.kind == ParameterKind::PlatformAnchor);
    let frame = kept.iter().filter(|parameter| parameter.kind == ParameterKind::FrameAnchor).count();
    if model.needs_tensions() || left.is_empty() || left.len() != frame {
        return None;
    }
    let rotation = mean_rotation(samples);
    let angle = samples.poses.iter().map(|pose| pose.rotation.angle_to(&rotation).powi(2)).sum::<f64>();
    let angle = (angle / samples.len() as f64).sqrt();
    let (rank, count) = (fit.analysis.rank, parameters.len());
    let noise = samples.sigmas.rotation.unwrap_or(0.0);
    let (evidence, why) = match angle {
        same if same <= SAME && rank + left.len() <= count => {
            (Evidence::Rank, format!("the rank is {rank} of {count}"))
        }
        small if small <= NOISE * 3.0_f64.sqrt() * noise => {
            let angles = [angle, noise].map(f64::to_degrees);
            let words =
                format!("orientations differ by {:.3}° rms, their noise is {:.3}° per axis", angles[0], angles[1]);
            (Evidence::Noise, words)
        }
        _ => return None,
    };
    let nominal = Model::new(point_robot(model.robot(), &rotation)?, model.composition()).ok()?;
    let reason = format!(
        "all poses have one orientation, so that lengths tell frame and platform anchors only together ({why}): the robot as a point, with \
         anchors a − R b and b = 0, has what is left"
    );
    Some(Candidate { evidence, reason, nominal, kept, left })
}

/// Normalised sum of the quaternions, signs alike.
fn mean_rotation(samples: &Samples) -> UnitQuaternion<f64> {
    let first = samples.poses.first().map_or_else(UnitQuaternion::identity, |pose| pose.rotation);
    let alike = |rotation: &UnitQuaternion<f64>| {
        let sign = if rotation.coords.dot(&first.coords) < 0.0 { -1.0 } else { 1.0 };
        rotation.coords * sign
    };
    let sum = samples.poses.iter().map(|pose| alike(&pose.rotation)).sum();
    UnitQuaternion::from_quaternion(Quaternion::from_vector(sum))
}

/// A candidate beside the model that was asked for.
struct Trial<'a> {
    model: &'a Model,
    parameters: &'a [Parameter],
    settings: &'a fit::Settings,
    found: &'a Candidate,
}

impl Trial<'_> {
    /// Samples as the smaller model sees them.
    fn seen(&self, samples: &Samples) -> Samples {
        match self.found.nominal.robot().motion_pattern == self.model.robot().motion_pattern {
            true => samples.clone(),
            false => without_rotation(samples),
        }
    }

    fn reduced(&self, samples: &Samples) -> Result<Model, InputError> {
        let Candidate { nominal, kept, .. } = self.found;
        Ok(optimum_of(nominal, &self.seen(samples), kept, self.settings)?.model)
    }

    /// Mean position errors of both models on data held out, the standard error of the first, and their difference; `None` where one predicts no pose.
    fn held_out(&self, samples: &Samples, folds: &[Fold]) -> Result<Option<([f64; 2], f64, Difference)>, InputError> {
        let mut series = [Vec::new(), Vec::new()];
        for fold in folds {
            let (train, held) = (samples.subset(&fold.train), samples.subset(&fold.validation));
            let full = optimum_of(self.model, &train, self.parameters, self.settings)?.model;
            let reduced = self.reduced(&train)?;
            for (errors, (model, held)) in series.iter_mut().zip([(&full, &held), (&reduced, &self.seen(&held))]) {
                let Ok(found) = evaluate_fitted(model, held) else { return Ok(None) };
                errors.extend(found.position);
            }
        }
        let common: Vec<usize> =
            (0..series[0].len()).filter(|&sample| series.iter().all(|errors| errors[sample].is_finite())).collect();
        if common.is_empty() {
            return Ok(None);
        }
        let of_common = |errors: &Vec<f64>| common.iter().map(|&sample| errors[sample]).collect::<Vec<f64>>();
        let series = series.each_ref().map(of_common);
        let means = series.each_ref().map(|errors| errors.iter().sum::<f64>() / errors.len() as f64);
        let poses = repeated_poses(self.model.robot(), samples);
        let held: Vec<usize> = folds.iter().flat_map(|fold| fold.validation.iter().copied()).collect();
        let groups: Vec<usize> = common.iter().map(|&place| poses[held[place]]).collect();
        let difference = Difference::to_best(&series[0], &series[1], &groups, self.settings.seed);
        Ok(Some((means, standard_error(&series[0], self.settings.seed), difference)))
    }
}
