//! Answer of an inverse problem.

use crate::geometry::Pose;
use crate::model::WinchError;
use crate::statics::StaticsError;

/// Command of one cable; numbers without a value are NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CableCommand {
    /// Strained length from frame anchor to platform anchor, wrapped part included (m).
    pub length: f64,
    /// Controlled length q_θ (m).
    pub controlled_length: f64,
    /// Length that the robot records: length_scale · q_θ + length_offset (m).
    pub recorded_length: f64,
    /// Direction of the pull at the platform anchor (unit vector, world).
    pub direction: [f64; 3],
    /// Wrap angle β on the pulley (rad); 0 without one.
    pub wrap_angle: f64,
    /// Tension at the outlet (N); NaN if none was given.
    pub outlet_tension: f64,
    /// Tension at the platform anchor (N) of a cable with weight; `None` for others, where it equals that at the
    /// outlet.
    pub platform_tension: Option<f64>,
    /// Motor angle (rad); `None` without the effect `drum`.
    pub motor_angle: Option<f64>,
    /// Encoder counts of the motor angle; `None` if the file does not state the counts of its encoder.
    pub encoder_counts: Option<f64>,
}

impl CableCommand {
    pub(super) const NONE: Self = Self {
        length: f64::NAN,
        controlled_length: f64::NAN,
        recorded_length: f64::NAN,
        direction: [f64::NAN; 3],
        wrap_angle: f64::NAN,
        outlet_tension: f64::NAN,
        platform_tension: None,
        motor_angle: None,
        encoder_counts: None,
    };
}

/// Answer of an inverse problem.
#[must_use = "check `failures` before using the lengths"]
#[derive(Clone, Debug, PartialEq)]
pub struct InverseSolution {
    /// Pose for which the problem was solved.
    pub pose: Pose,
    /// Command of every cable.
    pub cables: Vec<CableCommand>,
    /// Reasons that cables have no path, or no length for their tension; empty if the problem is solved.
    pub failures: Vec<StaticsError>,
    /// Reasons that drums have no angle for a length; empty without the effect `drum`.
    pub winch_failures: Vec<WinchError>,
}

impl InverseSolution {
    /// Room for this many cables.
    pub(super) fn unsolved(cables: usize) -> Self {
        Self {
            pose: Pose::identity(),
            cables: vec![CableCommand::NONE; cables],
            failures: Vec::new(),
            winch_failures: Vec::new(),
        }
    }

    /// Controlled lengths q_θ of all cables (m); the first failure if there is one.
    pub fn controlled_lengths(&self) -> Result<Vec<f64>, StaticsError> {
        self.numbers(|cable| cable.controlled_length)
    }

    /// Recorded lengths of all cables (m); the first failure if there is one.
    pub fn recorded_lengths(&self) -> Result<Vec<f64>, StaticsError> {
        self.numbers(|cable| cable.recorded_length)
    }

    /// True if a cable with a path has no controlled length because its tension is missing.
    pub fn needs_tensions(&self) -> bool {
        self.cables.iter().any(|cable| cable.length.is_finite() && cable.controlled_length.is_nan())
    }

    fn numbers(&self, of: impl Fn(&CableCommand) -> f64) -> Result<Vec<f64>, StaticsError> {
        match self.failures.first() {
            Some(failure) => Err(failure.clone()),
            None => Ok(self.cables.iter().map(of).collect()),
        }
    }
}
