//! How well a model predicts measured samples.

use serde::Serialize;

use crate::equilibrium::forward_kinematics::{self, Solver, Status};
use crate::measurement::Samples;
use crate::metamodel::errors::{LengthError, PoseError};
use crate::model::Model;

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
    /// Number of cables.
    pub cable_count: usize,
    /// Samples whose forward problem did not converge, from 0, with the reason.
    pub not_converged: Vec<(usize, String)>,
}

/// Compares a model with samples: its forward problem from the recorded lengths with the measured poses, its inverse at the
/// measured poses with the recorded lengths.
pub fn evaluate(model: &Model, samples: &Samples) -> Evaluation {
    let mut evaluation = Evaluation { cable_count: model.cable_count(), ..Evaluation::default() };
    // the measured pose is near the solution: a residual there is the model's, not a wrong minimum's
    let defaults = forward_kinematics::Settings::default();
    let settings = forward_kinematics::Settings { suspicious_residual: defaults.plausible_residual, ..defaults };
    let mut solver = Solver::new(model, &settings).expect("the default settings are valid");
    let mut controlled = vec![0.0; model.cable_count()];
    for (sample, pose) in samples.poses.iter().enumerate() {
        let recorded = samples.lengths_of(sample);
        for (cable, length) in controlled.iter_mut().enumerate() {
            *length = model.controlled_length(cable, recorded[cable]);
        }
        let predicted = match solver.solve(&controlled, pose) {
            Ok(solution) if solution.status == Status::Converged => Some(solution.pose),
            Ok(solution) => {
                evaluation.not_converged.push((sample, solution.reason.clone().unwrap_or_default()));
                Some(solution.pose)
            }
            Err(error) => {
                evaluation.not_converged.push((sample, error.to_string()));
                None
            }
        };
        let shift = predicted.map_or([f64::NAN; 3], |predicted| (predicted.position - pose.position).into());
        evaluation.position.push(nalgebra::Vector3::from(shift).norm());
        evaluation.position_vector.push(shift);
        evaluation.rotation.push(predicted.map_or(f64::NAN, |predicted| predicted.angle_to(pose)));
        for (cable, &length) in recorded.iter().enumerate() {
            let modelled = model.course(cable, pose).map_or(f64::NAN, |(course, _)| course.length);
            evaluation.length.push(model.recorded_length(cable, modelled) - length);
        }
    }
    evaluation
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

    /// Appends the samples of another evaluation.
    pub fn extend(&mut self, other: &Self) {
        let offset = self.len();
        self.cable_count = other.cable_count;
        self.position.extend(&other.position);
        self.position_vector.extend(&other.position_vector);
        self.rotation.extend(&other.rotation);
        self.length.extend(&other.length);
        self.not_converged.extend(other.not_converged.iter().map(|(sample, why)| (sample + offset, why.clone())));
    }

    /// The statistics.
    pub fn blocks(&self) -> ErrorBlocks {
        ErrorBlocks {
            samples: self.len(),
            position_error_m: PoseError::of(&self.position),
            rotation_error_rad: PoseError::of(&self.rotation),
            length_error_m: LengthError::of(&self.length),
            not_converged: self.not_converged.len(),
        }
    }
}
