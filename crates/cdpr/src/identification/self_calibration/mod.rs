//! Calibration by sensors inside the machine: lengths, or their changes, at poses that nobody measured.
//!
//! Every pose takes the place where its lengths fit best and leaves m minus its unknown components equations for the parameters (sec. 4.1). What moves or mirrors the
//! robot as a whole changes no length: such gauge motions are found, named, and fixed by parameters that stay at the file's values.

mod gauge;

use super::evaluation::Evaluation;
use super::fit::{Fit, InputError, Settings, checked_parameters};
use super::objective::{PoselessVectors, Stacked, Vectors, check_recording, report, search};
use super::worth::joint_worths;
use crate::geometry::Pose;
use crate::measurement::{InternalSamples, Samples};
use crate::model::{FreeParameters, Model};
use crate::robot::Parameter;
use gauge::Gauge;
pub use gauge::GaugeFixing;

/// Length noise that is assumed where none is stated (m).
const ASSUMED: f64 = 1e-3;

/// A robot calibrated without measured poses.
#[must_use = "check the status of the fit before using the parameters"]
#[derive(Clone, Debug)]
pub struct SelfCalibration {
    /// The fit; parameters that the gauge holds are none of its own.
    pub fit: Fit,
    /// The samples with the poses at which their lengths fit best, lengths counted from nothing.
    pub samples: Samples,
    /// Σ of the squared length residuals (m²).
    pub cost_m2: f64,
    /// Their root mean square (m).
    pub length_rms_m: f64,
    /// Equations that the poses leave for the parameters.
    pub equations: usize,
    /// Free parameters, those that the gauge holds included.
    pub parameter_count: usize,
    /// Motions of everything that the data leave free, and parameters that fix them.
    pub gauge: GaugeFixing,
}

/// Identifies parameters of a rigid model from lengths at unknown poses; `progress` is called after each start.
pub fn self_calibrate(
    model: &Model,
    internal: &InternalSamples,
    free: &FreeParameters,
    settings: &Settings,
    progress: &dyn Fn(),
) -> Result<SelfCalibration, InputError> {
    if model.needs_tensions() {
        return Err(InputError::PoselessOfElastic);
    }
    check_recording(free, settings)?;
    let all = checked_parameters(model, &internal.samples, free, settings)?;
    let samples = &internal.samples;
    let sigma = samples.sigmas.length.filter(|sigma| *sigma > 0.0).unwrap_or(ASSUMED);
    let mut vectors = PoselessVectors::new(model, internal, &all, sigma);
    let unknown = vectors.unknowns();
    if unknown >= samples.lengths.len() {
        let (cables, dof) = (model.cable_count(), model.dof());
        return Err(InputError::NoEquationLeft { cables, dof });
    }
    let at_start = stacked(&mut vectors, model, &all)?;
    let gauge = Gauge::of(model, &all, &at_start);
    let kept: Vec<Parameter> = (0..all.len()).filter(|place| !gauge.held.contains(place)).map(|k| all[k]).collect();
    let equations = samples.lengths.len() - unknown;
    if kept.len() > equations {
        return Err(InputError::TooFewEquations { parameters: kept.len(), equations, samples: samples.len() });
    }
    let mut vectors = PoselessVectors::new(model, internal, &kept, sigma);
    stacked(&mut vectors, model, &kept)?;
    let scale = joint_worths(model, &kept, &as_found(model, internal, vectors.poses())?.lengths, &[]);
    let optimum = search(&mut vectors, (model, &kept), (scale, Some(sigma), 0.0), settings, progress)?;
    let stacked_at_end = optimum.stacked(&mut vectors)?;
    let calibrated = optimum.calibrated().clone();
    let mut vectors = PoselessVectors::new(&calibrated, internal, &all, sigma);
    let at_end = stacked(&mut vectors, &calibrated, &all)?;
    let cost_m2 = at_end.residuals.norm_squared() * sigma * sigma;
    let mut found = as_found(&calibrated, internal, vectors.poses())?;
    let mut fit = report((optimum, &stacked_at_end), &found, &kept, settings);
    // angles from a common start are those of no start length
    found.motor_angles = found.motor_angles.filter(|_| !internal.are_changes);
    fit.tell_nominal_values(model);
    if let Some(words) = gauge.scale_warning() {
        fit.warnings.insert(0, words);
    }
    Ok(SelfCalibration {
        cost_m2,
        length_rms_m: (cost_m2 / samples.lengths.len() as f64).sqrt(),
        equations,
        parameter_count: all.len(),
        gauge: gauge.told(model, &all, internal),
        samples: found,
        fit,
    })
}

/// Errors of a rigid model's lengths at the poses where they fit best; known components of poses stay. There are no errors of poses.
pub fn evaluate_lengths(model: &Model, internal: &InternalSamples) -> Result<Evaluation, InputError> {
    if model.needs_tensions() {
        return Err(InputError::PoselessOfElastic);
    }
    let (robot, data) = (model.cable_count(), internal.samples.cable_count);
    if robot != data {
        return Err(InputError::CableCount { robot, data });
    }
    let mut vectors = PoselessVectors::new(model, internal, &[], ASSUMED);
    stacked(&mut vectors, model, &[])?;
    let found = as_found(model, internal, vectors.poses())?;
    let count = found.len();
    let error = |(k, recorded): (usize, &f64)| modelled_length(model, k % robot, &found.poses[k / robot]) - recorded;
    Ok(Evaluation {
        position: vec![f64::NAN; count],
        position_vector: vec![[f64::NAN; 3]; count],
        rotation: vec![f64::NAN; count],
        length: found.lengths.iter().enumerate().map(error).collect(),
        cable_count: robot,
        ..Evaluation::default()
    })
}

/// Length as it is recorded at a pose (m).
fn modelled_length(model: &Model, cable: usize, pose: &Pose) -> f64 {
    model.recorded_length(cable, model.path_or_nan(cable, pose).0.length)
}

/// Rows at the values of a model.
fn stacked(vectors: &mut PoselessVectors<'_>, model: &Model, parameters: &[Parameter]) -> Result<Stacked, InputError> {
    let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value(model.robot())).collect();
    let mut stacked = Stacked::new(vectors, parameters.len());
    match vectors.write(&values, &mut stacked) {
        true => Ok(stacked),
        false => Err(InputError::NoPoses),
    }
}

/// Samples at poses that were found, lengths counted from nothing and as the model's winches have them.
fn as_found(model: &Model, internal: &InternalSamples, poses: &[Pose]) -> Result<Samples, InputError> {
    let lengths = model.with_lengths(&internal.samples).map_err(InputError::Winch)?;
    let mut samples = Samples { poses: poses.to_vec(), ..lengths.into_owned() };
    if internal.are_changes {
        let origin: Vec<f64> =
            (0..model.cable_count()).map(|cable| modelled_length(model, cable, &Pose::identity())).collect();
        samples.lengths.iter_mut().zip(origin.iter().cycle()).for_each(|(length, origin)| *length += origin);
    }
    Ok(samples)
}
