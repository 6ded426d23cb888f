//! How well a model predicts measured samples.

use serde::Serialize;

use crate::equilibrium::forward_kinematics::{self, Solver, Status};
use crate::measurement::Samples;
use crate::model::Model;

/// Mean, root mean square and more of a non-negative error over poses.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PoseError {
    /// Mean (eq. 3.4).
    pub mean: f64,
    /// Root mean square.
    pub rms: f64,
    /// Median.
    pub median: f64,
    /// 95 % of the poses are better.
    pub p95: f64,
    /// Largest.
    pub max: f64,
}

/// Error of the cable lengths over poses and cables (m).
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct LengthError {
    /// Mean of the magnitudes.
    pub mean_abs: f64,
    /// Root mean square.
    pub rms: f64,
    /// 95 % of the lengths are better.
    pub p95: f64,
    /// Largest magnitude.
    pub max: f64,
}

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
            position_error_m: pose_error(&self.position),
            rotation_error_rad: pose_error(&self.rotation),
            length_error_m: length_error(&self.length),
            not_converged: self.not_converged.len(),
        }
    }
}

fn pose_error(values: &[f64]) -> PoseError {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    PoseError {
        mean: mean(values),
        rms: mean_square(values).sqrt(),
        median: quantile(&sorted, 0.5),
        p95: quantile(&sorted, 0.95),
        max: sorted.last().copied().unwrap_or(f64::NAN),
    }
}

fn length_error(values: &[f64]) -> LengthError {
    let mut sorted: Vec<f64> = values.iter().map(|x| x.abs()).collect();
    sorted.sort_by(f64::total_cmp);
    LengthError {
        mean_abs: mean(&sorted),
        rms: mean_square(values).sqrt(),
        p95: quantile(&sorted, 0.95),
        max: sorted.last().copied().unwrap_or(f64::NAN),
    }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn mean_square(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64
}

/// Quantile by linear interpolation between order statistics (the default of NumPy and R).
fn quantile(sorted: &[f64], share: f64) -> f64 {
    if sorted.is_empty() {
        return f64::NAN;
    }
    let place = share * (sorted.len() - 1) as f64;
    let below = place.floor() as usize;
    let above = (below + 1).min(sorted.len() - 1);
    sorted[below] + (place - below as f64) * (sorted[above] - sorted[below])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_interpolate_between_order_statistics() {
        assert_eq!(quantile(&[1.0, 2.0, 3.0, 4.0], 0.5), 2.5);
        assert_eq!(quantile(&[1.0], 0.95), 1.0);
        assert!((quantile(&[0.0, 1.0, 2.0], 0.95) - 1.9).abs() < 1e-15);
    }

    #[test]
    fn statistics_of_a_known_list() {
        let error = length_error(&[-3.0, 4.0]);
        assert_eq!((error.mean_abs, error.max), (3.5, 4.0));
        assert!((error.rms - 12.5_f64.sqrt()).abs() < 1e-15);
    }
}
