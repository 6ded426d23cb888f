//! Poses to command.

use crate::geometry::Pose;

/// A pose to command, with the subset its sample belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct CommandedPose {
    /// The pose.
    pub pose: Pose,
    /// Name of the subset.
    pub set: Option<String>,
    /// A cable whose winch pulls in more than the control model asks for.
    pub shortened: Option<Shortening>,
    /// Tensions that an elastic control model commands in place of its own choice, one a cable (N).
    pub tensions: Option<Vec<f64>>,
}

/// One cable of a tension test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shortening {
    /// The cable, from 0.
    pub cable: usize,
    /// By how much it is shortened (m).
    pub by: f64,
}

impl CommandedPose {
    /// This pose, in no subset and with all cables as the control model wants them.
    pub fn at(pose: Pose) -> Self {
        Self { pose, set: None, shortened: None, tensions: None }
    }
}
