//! Poses between what a tracker tells and the platform.

use cdpr_model::geometry::{Pose, inverse, product};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;

/// Poses between the tracker's numbers and the robot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Frames {
    /// The tracker's world in the frame of the robot.
    pub(super) tracker: Pose,
    /// The marker on the platform.
    pub(super) marker: Pose,
    /// False for point platforms, whose measured orientation means nothing.
    pub(super) turns: bool,
}

impl Frames {
    pub(super) fn identity(model: &Model) -> Self {
        let turns = model.robot().motion_pattern.has_rotation();
        Self { tracker: Pose::identity(), marker: Pose::identity(), turns }
    }

    /// Pose of the platform in the robot's frame.
    pub(super) fn platform(&self, measured: &Pose) -> Pose {
        match self.turns {
            true => product(&product(&self.tracker, measured), &inverse(&self.marker)),
            false => Pose { position: self.tracker.transform(&measured.position), rotation: measured.rotation },
        }
    }

    /// The samples with the poses of the platform in the robot's frame.
    pub(crate) fn apply(&self, samples: &Samples) -> Samples {
        Samples { poses: samples.poses.iter().map(|pose| self.platform(pose)).collect(), ..samples.clone() }
    }
}
