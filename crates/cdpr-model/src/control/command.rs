//! Poses to command.

use crate::geometry::Pose;

/// A pose to command, with the subset to which its sample belongs.
#[derive(Clone, Debug, PartialEq)]
pub struct CommandedPose {
    /// The pose.
    pub pose: Pose,
    /// Name of the subset.
    pub set: Option<String>,
    /// A cable that its winch shortens beyond the control model's length.
    pub shortened: Option<Shortening>,
    /// Tensions that an elastic control model commands instead of its own choice, one per cable (N).
    pub tensions: Option<Vec<f64>>,
}

/// The shortened cable of a tension test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shortening {
    /// The cable, from 0.
    pub cable: usize,
    /// Length by which it is shortened (m).
    pub by: f64,
}

impl CommandedPose {
    /// This pose, in no subset and with the control model's lengths and tensions.
    pub fn at(pose: Pose) -> Self {
        Self { pose, set: None, shortened: None, tensions: None }
    }
}
