//! How well a model predicts measured samples.

use serde::Serialize;

use thiserror::Error;

use crate::equilibrium::{elastostatics, forward_kinematics};
use crate::geometry::Pose;
use crate::measurement::Samples;
use crate::metamodel::errors::{LengthError, PoseError, TensionError};
use crate::model::{Model, WinchError};
use crate::statics::{Load, LoadError};

/// All errors of a model on a data set, SI units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ErrorBlocks {
    /// Number of samples.
    pub samples: usize,
    /// Distance between predicted and measured position (m).
    pub position_error_m: PoseError,
    /// Geodesic angle between predicted and measured orientation (rad).
    pub rotation_error_rad: PoseError,
    /// Modelled minus recorded lengths at the measured poses (m).
    pub length_error_m: LengthError,
    /// Predicted minus recorded tensions; `None` for a model that knows none, or data without.
    #[serde(rename = "tension_error_N", skip_serializing_if = "Option::is_none")]
    pub tension_error: Option<TensionError>,
    /// Samples whose forward problem did not converge; their best pose found counts.
    pub not_converged: usize,
}

/// Errors sample by sample.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Evaluation {
    /// Distance between predicted and measured position (m).
    pub position: Vec<f64>,
    /// Predicted minus measured position (world, m).
    pub position_vector: Vec<[f64; 3]>,
    /// Geodesic angle between predicted and measured orientation (rad).
    pub rotation: Vec<f64>,
    /// Modelled minus recorded lengths at the measured pose, sample by sample (m); NaN where the model has none.
    pub length: Vec<f64>,
    /// Predicted minus recorded tensions, sample by sample (N); empty for a model that knows none, or data without.
    pub tension: Vec<f64>,
    /// Number of cables.
    pub cable_count: usize,
    /// Samples whose forward problem did not converge, from 0, with the reason.
    pub not_converged: Vec<(usize, String)>,
}

/// A model whose predictions cannot be computed.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum EvaluationError {
    /// An elastic model of a robot whose load is unknown.
    #[error("an elastic model predicts poses and tensions under load: {0}")]
    Load(#[from] LoadError),
    /// An elastic model whose forward problem has no answer, such as one of rigid cables.
    #[error("the model cannot predict poses: {0}")]
    Forward(#[from] elastostatics::InputError),
    /// Motor angles that the robot's winches cannot have.
    #[error(transparent)]
    Winch(#[from] WinchError),
    /// Not one length per cable.
    #[error("the robot has {robot} cables, the data have {data}")]
    CableCount {
        /// Cables of the robot.
        robot: usize,
        /// Cables in the data.
        data: usize,
    },
}

/// Pose and tensions that a model predicts for one sample.
struct Prediction {
    pose: Option<Pose>,
    /// Real tensions (N); `None` for a rigid model.
    tensions: Option<Vec<f64>>,
    /// Why the forward problem failed.
    failure: Option<String>,
}

/// The forward problem of a model, for one sample after the other.
enum Predictor<'a> {
    Rigid(Box<forward_kinematics::Solver<'a>>),
    Elastic(Box<elastostatics::Solver<'a>>),
}

impl<'a> Predictor<'a> {
    fn new(model: &'a Model) -> Result<Self, EvaluationError> {
        if model.composition().depends_on_tension() {
            let load = Load::of(model.robot())?;
            let settings = elastostatics::Settings::default();
            return Ok(Self::Elastic(Box::new(elastostatics::Solver::new(model, &load, &settings)?)));
        }
        // the measured pose is near the solution: a residual there is the model's, not a wrong minimum's
        let defaults = forward_kinematics::Settings::default();
        let settings = forward_kinematics::Settings { suspicious_residual: defaults.plausible_residual, ..defaults };
        let solver = forward_kinematics::Solver::new(model, &settings).expect("the default settings are valid");
        Ok(Self::Rigid(Box::new(solver)))
    }

    fn predict(&mut self, controlled: &[f64], near: &Pose) -> Prediction {
        let failed = |reason: String| Prediction { pose: None, tensions: None, failure: Some(reason) };
        match self {
            Self::Rigid(solver) => match solver.solve(controlled, near) {
                Ok(found) => {
                    let good = found.status == forward_kinematics::Status::Converged;
                    let failure = (!good).then(|| found.reason.clone().unwrap_or_default());
                    Prediction { pose: Some(found.pose), tensions: None, failure }
                }
                Err(error) => failed(error.to_string()),
            },
            Self::Elastic(solver) => match solver.solve(controlled, near) {
                Ok(found) => {
                    let good = found.status == elastostatics::Status::Converged;
                    let failure = (!good).then(|| found.reason.clone().unwrap_or_default());
                    Prediction { pose: Some(found.pose), tensions: Some(found.tensions.clone()), failure }
                }
                Err(error) => failed(error.to_string()),
            },
        }
    }
}

/// Compares a model with samples: its forward problem from the recorded lengths with the measured poses (and tensions), its
/// inverse at the measured poses (and tensions, predicted ones where none are recorded) with the recorded lengths.
pub fn evaluate(model: &Model, samples: &Samples) -> Result<Evaluation, EvaluationError> {
    let cables = model.cable_count();
    if cables != samples.cable_count {
        return Err(EvaluationError::CableCount { robot: cables, data: samples.cable_count });
    }
    let samples = &*model.with_lengths(samples)?;
    let mut evaluation = Evaluation { cable_count: cables, ..Evaluation::default() };
    let mut predictor = Predictor::new(model)?;
    let mut controlled = vec![0.0; cables];
    for (sample, pose) in samples.poses.iter().enumerate() {
        let recorded = samples.lengths_of(sample);
        for (cable, length) in controlled.iter_mut().enumerate() {
            *length = model.controlled_length(cable, recorded[cable]);
        }
        let predicted = predictor.predict(&controlled, pose);
        if let Some(reason) = predicted.failure {
            evaluation.not_converged.push((sample, reason));
        }
        let shift = predicted.pose.map_or([f64::NAN; 3], |predicted| (predicted.position - pose.position).into());
        evaluation.position.push(nalgebra::Vector3::from(shift).norm());
        evaluation.position_vector.push(shift);
        evaluation.rotation.push(predicted.pose.map_or(f64::NAN, |predicted| predicted.angle_to(pose)));
        let measured = samples.tensions.as_ref().map(|tensions| &tensions[sample * cables..][..cables]);
        for (cable, &length) in recorded.iter().enumerate() {
            let measured = measured.map(|tensions| model.real_tension(cable, tensions[cable]));
            let predicted = predicted.tensions.as_ref().map(|tensions| tensions[cable]);
            let tension = measured.or(predicted).unwrap_or(0.0);
            let controlled = modelled_length(model, cable, pose, tension);
            evaluation.length.push(model.recorded_length(cable, controlled) - length);
        }
        if let Some(measured) = measured.filter(|_| model.composition().depends_on_tension()) {
            let error = |cable: usize| {
                let predicted = predicted.tensions.as_ref().map_or(f64::NAN, |tensions| tensions[cable]);
                model.recorded_tension(cable, predicted) - measured[cable]
            };
            evaluation.tension.extend((0..cables).map(error));
        }
    }
    Ok(evaluation)
}

/// Controlled length of a cable with this tension at a pose (m); NaN where there is none.
fn modelled_length(model: &Model, cable: usize, pose: &Pose, tension: f64) -> f64 {
    if model.composition().has_closed_form() {
        let length = model.course(cable, pose).map_or(f64::NAN, |(course, _)| course.length);
        return model.elasticity(cable).controlled_length(length, tension);
    }
    let known = model.known_tension(cable, tension);
    model.hold(cable, pose, known).map_or(f64::NAN, |(hold, _)| hold.controlled_length)
}

impl Evaluation {
    /// Number of samples.
    pub fn len(&self) -> usize {
        self.position.len()
    }

    /// True without samples.
    pub fn is_empty(&self) -> bool {
        self.position.is_empty()
    }

    /// Root mean square of one sample's length errors (m).
    pub fn length_rms_of(&self, sample: usize) -> f64 {
        let errors = &self.length[sample * self.cable_count..][..self.cable_count];
        (errors.iter().map(|x| x * x).sum::<f64>() / errors.len() as f64).sqrt()
    }

    /// 2-norm over the cables of one sample's tension errors (N); NaN where there are none.
    pub fn tension_norm_of(&self, sample: usize) -> f64 {
        let errors = self.tension.get(sample * self.cable_count..(sample + 1) * self.cable_count);
        errors.map_or(f64::NAN, |errors| errors.iter().map(|x| x * x).sum::<f64>().sqrt())
    }

    /// Appends the samples of another evaluation.
    pub fn extend(&mut self, other: &Self) {
        let offset = self.len();
        self.cable_count = other.cable_count;
        self.position.extend(&other.position);
        self.position_vector.extend(&other.position_vector);
        self.rotation.extend(&other.rotation);
        self.length.extend(&other.length);
        self.tension.extend(&other.tension);
        self.not_converged.extend(other.not_converged.iter().map(|(sample, why)| (sample + offset, why.clone())));
    }

    /// The statistics.
    pub fn blocks(&self) -> ErrorBlocks {
        ErrorBlocks {
            samples: self.len(),
            position_error_m: PoseError::of(&self.position),
            rotation_error_rad: PoseError::of(&self.rotation),
            length_error_m: LengthError::of(&self.length),
            tension_error: (!self.tension.is_empty()).then(|| TensionError::of(&self.tension, self.cable_count)),
            not_converged: self.not_converged.len(),
        }
    }
}
