//! Poses at which a platform hangs at a position.

use crate::keys::table_schema::nullable_numbers;
use cdpr_model::equilibrium::hanging::{Hanging, HangingPoses};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::Stability;
use schemars::JsonSchema;
use serde::Serialize;

use super::answer::Answer;
use super::pose_answer::PoseAnswer;

/// Pose in equilibrium with lengths and tensions.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(transform = nullable_numbers)]
pub(super) struct HangingPose {
    pose: PoseAnswer,
    cable_lengths_m: Vec<f64>,
    #[serde(rename = "tensions_N")]
    tensions: Vec<f64>,
    /// stable, indifferent or unstable, at constant lengths.
    stability: &'static str,
    /// Smallest stiffness against motions that keep all lengths.
    #[serde(rename = "stiffness_N_per_m")]
    stiffness: f64,
}

/// All poses at which the platform hangs at a position, stable ones first.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub(super) struct HangingKeys {
    /// Poses in equilibrium, stable ones first.
    solutions: Vec<HangingPose>,
    /// Dimensions of the family of poses that the position leaves; 0 where they are single.
    freedom: usize,
}

impl HangingKeys {
    pub(super) fn new(model: &Model, poses: &HangingPoses) -> Self {
        let one = |own: &Hanging| HangingPose {
            pose: PoseAnswer::new(model.robot(), &own.pose),
            cable_lengths_m: model.cable_lengths(&own.pose).unwrap_or_default(),
            tensions: own.tensions.clone(),
            stability: word(own.stability),
            stiffness: own.stiffness,
        };
        Self { solutions: poses.found.iter().map(one).collect(), freedom: poses.freedom }
    }

    /// Sentences about the first pose and those besides.
    pub(super) fn words(&self) -> String {
        let Some((first, others)) = self.solutions.split_first() else { return String::new() };
        let mut text = format!(
            "the load decides the orientation: {}, {:.1} N/m against motions at constant lengths\n",
            first.stability, first.stiffness
        );
        if self.freedom > 0 {
            text.push_str(&format!(
                "the position leaves a family of {} dimension{}: a pose near the orientation of the home pose is taken\n",
                self.freedom,
                if self.freedom == 1 { "" } else { "s" }
            ));
        }
        for other in others {
            let tensions: Vec<String> = other.tensions.iter().map(|tension| format!("{tension:.3}")).collect();
            text.push_str(&format!(
                "also: {}, {}, tensions {} N\n",
                other.pose.words(),
                other.stability,
                tensions.join(", ")
            ));
        }
        text
    }
}

fn word(stability: Stability) -> &'static str {
    match stability {
        Stability::Stable => "stable",
        Stability::Indifferent => "indifferent",
        Stability::Unstable => "unstable",
    }
}

/// Answer where no orientation lets the platform hang at a position.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "NoHangingPose")]
pub struct NoHangingAnswer {
    robot: String,
    model: String,
    status: &'static str,
    reason: String,
    /// Position that was asked about (m).
    position_m: Vec<f64>,
    #[serde(flatten)]
    poses: HangingKeys,
}

impl NoHangingAnswer {
    /// The answer for the position of a pose.
    pub fn new(model: &Model, at: &Pose, poses: &HangingPoses) -> Self {
        let robot = model.robot();
        let mut components = robot.motion_pattern.pose_to_components(robot.plane, at);
        components.truncate(robot.motion_pattern.translations());
        let pushing = match poses.pushing {
            0 => "no orientation was found at which cables balance the load".to_owned(),
            1 => "at the one orientation in balance a cable would have to push".to_owned(),
            count => format!("at all {count} orientations in balance a cable would have to push"),
        };
        Self {
            robot: robot.name.clone(),
            model: model.composition().to_string(),
            status: "no-equilibrium",
            reason: format!("{pushing}: the platform cannot hang there"),
            position_m: components,
            poses: HangingKeys::new(model, poses),
        }
    }
}

impl Answer for NoHangingAnswer {
    fn is_negative(&self) -> bool {
        true
    }

    fn words(&self, _: Option<usize>) -> String {
        let numbers: Vec<String> = self.position_m.iter().map(|number| format!("{number}")).collect();
        format!("{}, model {}, at {} m\n{}: {}\n", self.robot, self.model, numbers.join(", "), self.status, self.reason)
    }
}
