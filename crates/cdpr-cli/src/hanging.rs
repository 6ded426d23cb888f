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

/// Doubt about a pose that the load of a hanging platform does not allow.
pub(crate) struct NotAtRest {
    /// Part of the load that the cables leave, as a share of its force.
    share: f64,
    /// Pose at which the platform comes to rest with the lengths of the one that was wanted; `None` if none is found.
    rest: Option<Pose>,
    wanted: Pose,
}

impl NotAtRest {
    /// `None` where cables fix the pose, the load is unknown or holds the pose.
    pub(crate) fn of(model: &Model, wanted: &Pose) -> Option<Self> {
        let load = Load::of(model.robot()).ok()?;
        let share = unbalanced_share(model, &load, wanted).ok()??;
        let rest = || {
            let lengths = model.cable_lengths(wanted).ok()?;
            let mut state = State::at(model, wanted);
            let settings = ForwardSettings::default();
            let found = model.forward_with(&settings, &lengths, Some(&load), Some(wanted), &mut state).ok()?;
            (found.status == Status::Converged).then_some(found.pose)
        };
        Some(Self { share, rest: rest(), wanted: *wanted })
    }

    /// Distance from the pose that was wanted (m); infinite where no pose at rest is found.
    pub(crate) fn distance(&self) -> f64 {
        self.rest.map_or(f64::INFINITY, |rest| (rest.position - self.wanted.position).norm())
    }

    /// The pose at rest in words, with its distance and turn.
    pub(crate) fn words(&self, robot: &Robot) -> String {
        match &self.rest {
            Some(rest) => format!(
                "with these lengths it comes to rest at {}, {:.1} mm and {:.1}° away",
                PoseAnswer::new(robot, rest).words(),
                1e3 * self.distance(),
                rest.rotation.angle_to(&self.wanted.rotation).to_degrees()
            ),
            None => format!(
                "cables that pull leave {:.0} % of it, and no pose is found at which the platform comes to rest with these lengths",
                1e2 * self.share
            ),
        }
    }
}
