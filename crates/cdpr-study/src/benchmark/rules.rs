//! Rules of the benchmark, and errors of robots that cannot take part.

use thiserror::Error;

use crate::ExperimentError;
use cdpr_calibration::fit;
use cdpr_model::control::InputError;
use cdpr_model::geometry::PatternError;
use cdpr_model::model::{ModelError, ParameterError};

/// Deviations of machines, positions of poses and sensors of the benchmark, the same for all robots.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BenchmarkRules {
    /// Standard deviation of anchors per axis: for frame anchors as a fraction of their mean distance from their
    /// middle, for platform anchors of their distance from the platform origin.
    pub anchor_deviation: f64,
    /// Standard deviation of stiffnesses, as a fraction of the stiffness.
    pub stiffness_deviation: f64,
    /// Strain at the largest tension, for cables whose file states no stiffness.
    pub strain_at_largest_tension: f64,
    /// Fraction of the travel box, about the home pose, that the poses cover: a grid of 5 along each translation, 3
    /// along the last of three.
    pub box_share: f64,
    /// Count of poses with random orientations within ± `turn_rad`, for robots that turn.
    pub turned_poses: usize,
    /// Largest turn (rad).
    pub turn_rad: f64,
    /// Count of measured poses, chosen at random.
    pub measured_poses: usize,
    /// Standard deviation of measured positions per axis (m).
    pub position_m: f64,
    /// Standard deviation of measured orientations per axis (rad).
    pub rotation_rad: f64,
    /// Standard deviation of measured lengths (m).
    pub length_m: f64,
    /// Standard deviation of measured tensions, as a fraction of the largest tension.
    pub tension_share: f64,
    /// Seed of deviations, poses and noise.
    pub seed: u64,
}

impl Default for BenchmarkRules {
    fn default() -> Self {
        Self {
            anchor_deviation: 0.005,
            stiffness_deviation: 0.1,
            // 9000 N at EA = 2 MN, as for the CableRobot Simulator (eq. 6.17)
            strain_at_largest_tension: 0.0045,
            box_share: 0.5,
            turned_poses: 16,
            turn_rad: 5.0_f64.to_radians(),
            measured_poses: 40,
            position_m: 1e-4,
            rotation_rad: 1e-4,
            length_m: 2e-4,
            tension_share: 0.005,
            seed: 0,
        }
    }
}

/// Reason for which a robot cannot take part.
#[derive(Clone, Debug, PartialEq, Error)]
#[error(transparent)]
pub(super) enum BenchmarkError {
    Model(#[from] ModelError),
    Experiment(#[from] ExperimentError),
    Machine(#[from] InputError),
    Parameters(#[from] ParameterError),
    Fit(#[from] fit::InputError),
    Pattern(#[from] PatternError),
    #[error(
        "its cables balance the load within their limits at only {there} of {all} poses of the box: {least} are the least"
    )]
    TooFewPoses {
        there: usize,
        all: usize,
        least: usize,
    },
    #[error("its file states no tension limits, so that nothing says how stiff its cables are")]
    NoLimits,
}
