//! Poses of platforms that hang: of a position, and those that a pose becomes which the load does not allow.

use cdpr_model::equilibrium::hanging::{HangingPoses, hanging_poses, unbalanced_share};
use cdpr_model::equilibrium::{ForwardSettings, State, Status};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_model::statics::Load;

use crate::failure::Failure;
use crate::inputs::{load_of, pose_of};
use crate::numbers::NumberList;
use cdpr_reports::answers::PoseAnswer;

/// A pose with the position of an option and the orientation of the home pose.
pub(crate) fn position_of(robot: &Robot, option: &str, position: &NumberList) -> Result<Pose, Failure> {
    let pattern = robot.motion_pattern;
    let translations = pattern.translations();
    if position.0.len() != translations {
        let (name, found) = (pattern.name(), position.0.len());
        let message = format!(
            "{option}: motion pattern {name} takes {translations} coordinates of a position, found {found} numbers"
        );
        return Err(Failure::input("pose::component-count", message, "the rest of the pose follows from the load"));
    }
    let mut components = pattern.pose_to_components(robot.plane, &robot.home_or_middle());
    components[..translations].copy_from_slice(&position.0);
    pose_of(robot, option, &NumberList(components))
}

/// Poses at which the platform hangs at the position of a pose, under the load of an option or its own.
pub(crate) fn hanging_at(model: &Model, at: &Pose, wrench: Option<&NumberList>) -> Result<HangingPoses, Failure> {
    let load = load_of(model.robot(), wrench)?;
    hanging_poses(model, &load, at).map_err(|error| Failure::refused("--position", &error))
}

/// Pose at which the platform comes to rest with the lengths of a pose that its load does not allow.
pub(crate) struct Elsewhere {
    pub(crate) pose: Pose,
    /// Distance (m) and turn (rad) from the pose that was wanted.
    pub(crate) distance: f64,
    pub(crate) turn: f64,
}

impl Elsewhere {
    /// `None` where cables fix the pose, the load is unknown or holds the pose, or no pose is found.
    pub(crate) fn of(model: &Model, pose: &Pose) -> Option<Self> {
        let load = Load::of(model.robot()).ok()?;
        unbalanced_share(model, &load, pose).ok()??;
        let lengths = model.cable_lengths(pose).ok()?;
        let mut state = State::at(model, pose);
        let found =
            model.forward_with(&ForwardSettings::default(), &lengths, Some(&load), Some(pose), &mut state).ok()?;
        let end = found.pose;
        (found.status == Status::Converged).then(|| Self {
            pose: end,
            distance: (end.position - pose.position).norm(),
            turn: end.rotation.angle_to(&pose.rotation),
        })
    }

    /// The pose in words, with its distance and turn.
    pub(crate) fn words(&self, robot: &Robot) -> String {
        format!(
            "{}, {:.1} mm and {:.1}° away",
            PoseAnswer::new(robot, &self.pose).words(),
            1e3 * self.distance,
            self.turn.to_degrees()
        )
    }
}
