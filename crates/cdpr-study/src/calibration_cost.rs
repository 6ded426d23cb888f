//! Costs of accuracy (sec. 7.2): a machine is calibrated with a sensor, a control model and a number of poses, then
//! validated and driven.

#[cfg(test)]
mod tests;

use cdpr_calibration::unobserved;
use nalgebra::{Matrix3, Vector3};
use rand::SeedableRng;
use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use thiserror::Error;

use crate::Experiment;
use crate::sweep::{CalibrationOutcome, CalibrationPoint, PointError, PreparedSweep, Row};
use cdpr_calibration::evaluation::{ErrorBlocks, EvaluationError, evaluate_fitted};
use cdpr_calibration::fit::{self, Prior, fit};
use cdpr_calibration::{evaluate_lengths, self_calibrate};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::PoseErrorStatistics;
use cdpr_model::control::{InputError, Status};
use cdpr_model::geometry::Pose;
use cdpr_model::geometry::nearest_rotation;
use cdpr_model::measurement::{InternalSamples, Samples, SensorSigmas};
use cdpr_model::model::{Model, ModelError, ParameterError};

/// Offset between the seeds of records for validation and of records for fits.
const JUDGING: u64 = 1_000_003;

/// Reason for which a calibration cannot be made.
#[derive(Clone, Debug, PartialEq, Error)]
enum CostError {
    #[error(transparent)]
    Point(#[from] PointError),
    #[error(transparent)]
    Machine(#[from] InputError),
    #[error(transparent)]
    Model(#[from] ModelError),
    #[error(transparent)]
    Parameters(#[from] ParameterError),
    #[error(transparent)]
    Fit(#[from] fit::InputError),
    #[error(transparent)]
    Evaluation(#[from] EvaluationError),
    #[error("the study has {there} poses, fewer than the {asked} to measure")]
    TooFewPoses { there: usize, asked: usize },
}

impl PreparedSweep {
    /// Answers a point of a sweep over calibrations; a point that cannot be calibrated has a reason instead of an
    /// outcome.
    pub fn calibration_row(&self, point: usize, values: &[f64]) -> Row {
        let outcome = self.calibrated(values);
        let mut row = Row::without_answer(point, values, String::new());
        match outcome {
            Ok(found) => (row.calibration, row.reason) = (Some(found), None),
            Err(error) => row.reason = Some(error.to_string()),
        }
        row
    }

    fn calibrated(&self, values: &[f64]) -> Result<CalibrationOutcome, CostError> {
        let table = self.sweep.calibration.as_ref();
        let found = table.and_then(|table| Some((table.records, table.at(values)?)));
        let Some((records, asked)) = found else { return Err(InputError::NoPoses.into()) };
        let experiment = self.experiment(self.sweep.values_of(values))?;
        let calibration = Calibration::new(&experiment, asked)?;
        let all = (0..u64::from(records)).map(|seed| calibration.outcome(seed)).collect::<Result<Vec<_>, _>>()?;
        Ok(mean(&all))
    }
}

/// A machine to calibrate.
struct Calibration<'a> {
    experiment: Experiment,
    asked: CalibrationPoint<'a>,
    model: Model,
    settings: fit::Settings,
    /// Accuracies of the sensors; position and rotation are `None` if poses are not measured.
    sigmas: SensorSigmas,
    /// Commands from which poses are chosen, with tension tests if the model is elastic.
    commands: Vec<CommandedPose>,
    /// Poses that count for accuracy.
    poses: Vec<CommandedPose>,
}

impl<'a> Calibration<'a> {
    fn new(experiment: &Experiment, asked: CalibrationPoint<'a>) -> Result<Self, CostError> {
        let composition = asked.model.model.parse().map_err(InputError::from)?;
        let model = Model::new(experiment.control.robot().clone(), composition)?;
        let priors = asked.model.prior.iter().map(|text| text.parse()).collect::<Result<Vec<Prior>, _>>()?;
        let of_study = experiment.study.noise.unwrap_or_default();
        let without = SensorSigmas { position: None, rotation: None, ..of_study };
        let poses = experiment.poses(Vec::new(), 0)?;
        let commands = if model.needs_tensions() { experiment.commands(Vec::new(), 0)? } else { poses.clone() };
        if commands.len() < asked.poses {
            return Err(CostError::TooFewPoses { there: commands.len(), asked: asked.poses });
        }
        let sigmas = asked.sensor.sigmas(of_study, model.platform_radius()).unwrap_or(without);
        let mut experiment = experiment.clone();
        experiment.study.noise = Some(sigmas);
        let settings = fit::Settings { priors, ..fit::Settings::default() };
        Ok(Self { experiment, asked, model, settings, sigmas, commands, poses })
    }

    /// Fits to one record and judges the result.
    fn outcome(&self, seed: u64) -> Result<CalibrationOutcome, CostError> {
        let mut commands = self.commands.clone();
        commands.shuffle(&mut ChaCha8Rng::seed_from_u64(seed));
        commands.truncate(self.asked.poses);
        let record = self.experiment.record(&commands, seed)?.samples;
        let judging = self.experiment.record(&self.poses, JUDGING.wrapping_add(seed))?.samples;
        let free = self.asked.model.free.parse()?;
        let is_measured = self.sigmas.position.is_some();
        let (fitted, errors, count): (Model, ErrorBlocks, usize) = match is_measured {
            true => {
                let found = fit(&self.model, &record, &free, &self.settings)?;
                let errors = evaluate_fitted(&found.model, &judging)?.blocks();
                (found.model, errors, found.parameters.len())
            }
            false => {
                let found =
                    self_calibrate(&self.model, &unknown(&record, &self.model), &free, &self.settings, &unobserved)?;
                let errors = evaluate_lengths(&found.fit.model, &unknown(&judging, &self.model))?.blocks();
                (found.fit.model, errors, found.parameter_count)
            }
        };
        let driven = self.experiment.with_control(fitted).assess(&self.poses)?;
        let emerged: Vec<(Pose, Pose)> = self
            .poses
            .iter()
            .zip(&driven.outcomes)
            .filter(|(_, outcome)| outcome.status == Status::Converged)
            .map(|(commanded, outcome)| (commanded.pose, outcome.pose))
            .collect();
        // without measured poses the only known frame is the robot's own
        let robot = self.model.robot();
        let normal = robot.motion_pattern.is_planar().then(|| robot.plane.normal());
        let frame = if is_measured { Pose::identity() } else { best_frame(&emerged, normal) };
        let position = PoseErrorStatistics::of(&missed(&emerged, &frame));
        let turned: Vec<f64> = emerged
            .iter()
            .map(|(commanded, emerging)| (frame.rotation * emerging.rotation).angle_to(&commanded.rotation))
            .collect();
        Ok(CalibrationOutcome {
            parameter_count: count,
            validation_position_m: is_measured.then_some(errors.position_error_m.mean),
            validation_length_m: errors.length_error_m.rms,
            driven_position_m: position.mean,
            driven_position_max_m: position.max,
            driven_rotation_rad: PoseErrorStatistics::of(&turned).mean,
            driven_tension_N: driven.accuracy.tension_error_N.map(|error| error.mean_norm),
        })
    }
}

/// Distances between commanded positions and emerging ones transformed by `frame` (m).
fn missed(emerged: &[(Pose, Pose)], frame: &Pose) -> Vec<f64> {
    emerged
        .iter()
        .map(|(commanded, emerging)| (frame.transform(&emerging.position) - commanded.position).norm())
        .collect()
}

/// Rigid motion that brings emerging positions nearest to commanded ones (least squares); for a planar robot a rotation
/// about the normal of its plane.
fn best_frame(emerged: &[(Pose, Pose)], normal: Option<Vector3<f64>>) -> Pose {
    let count = emerged.len().max(1) as f64;
    let commanded = emerged.iter().map(|pair| pair.0.position).sum::<Vector3<f64>>() / count;
    let emerging = emerged.iter().map(|pair| pair.1.position).sum::<Vector3<f64>>() / count;
    let product: Matrix3<f64> =
        emerged.iter().map(|pair| (pair.0.position - commanded) * (pair.1.position - emerging).transpose()).sum();
    let rotation = nearest_rotation(product, normal);
    Pose { position: commanded - rotation * emerging, rotation }
}

/// Samples without measured poses.
fn unknown(samples: &Samples, model: &Model) -> InternalSamples {
    let poses = vec![Pose::identity(); samples.len()];
    InternalSamples::without_poses(Samples { poses, ..samples.clone() }, model.dof(), false)
}

/// Means over records; the largest error is the largest of all records.
fn mean(all: &[CalibrationOutcome]) -> CalibrationOutcome {
    let count = all.len() as f64;
    let mean = |own: fn(&CalibrationOutcome) -> f64| all.iter().map(own).sum::<f64>() / count;
    let known = |own: fn(&CalibrationOutcome) -> Option<f64>| -> Option<f64> {
        Some(all.iter().map(own).sum::<Option<f64>>()? / count)
    };
    CalibrationOutcome {
        parameter_count: all.first().map_or(0, |one| one.parameter_count),
        validation_position_m: known(|one| one.validation_position_m),
        validation_length_m: mean(|one| one.validation_length_m),
        driven_position_m: mean(|one| one.driven_position_m),
        driven_position_max_m: all.iter().map(|one| one.driven_position_max_m).fold(0.0, f64::max),
        driven_rotation_rad: mean(|one| one.driven_rotation_rad),
        driven_tension_N: known(|one| one.driven_tension_N),
    }
}
