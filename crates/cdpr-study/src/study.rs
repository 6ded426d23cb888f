//! Study files: the control model, the machine, the poses and the sensor noise.

mod campaign_table;
#[cfg(feature = "files")]
mod checks;
mod poses;
mod published;
#[cfg(feature = "files")]
mod reading;
mod tolerances;

use serde::Deserialize;

pub use campaign_table::{CampaignRecord, CampaignTable};
pub use cdpr_model::control::{CommandedPose, History, Initial, Reach, Shortening};
pub use published::PublishedStage;
#[cfg(test)]
pub(crate) use published::STAGES;
pub use tolerances::{AccuracyOf, Distribution, ModelTolerances, Tolerances, WinchTolerances};

use super::poorer::remark_on_poorer;
use cdpr_model::geometry::{PatternError, Pose};
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Composition;
use cdpr_model::robot::Robot;

/// A study as its file states it; robots are named, not read.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// The model that computes the controlled lengths.
    pub control: ControlModel,
    /// The model that answers: same or higher complexity, own parameters.
    pub machine: RobotModel,
    /// A model that predicts the emerging pose and tensions from the lengths that were sent, as `cdpr evaluate` does
    /// from measurements. `cdpr accuracy` only.
    pub prediction: Option<RobotModel>,
    /// Pose and tensions at which the winches are set.
    pub initial: Initial,
    /// Tension limits and the largest position error; the robot files' limits apply without.
    pub limits: Option<StudyLimits>,
    /// Poses to command.
    pub poses: Option<Poses>,
    /// Sensor noise of `cdpr simulate`.
    pub noise: Option<SensorSigmas>,
    /// Path on which a machine with the effect `hysteresis` comes to the poses.
    pub history: Option<History>,
    /// How far the numbers of control model, machine and winches may be off.
    pub tolerances: Option<Tolerances>,
    /// Rounds of planned measurements. `cdpr campaign` only.
    pub campaign: Option<CampaignTable>,
    /// Positions that the robot works at, where poses count fully with the objective `pose-in-task`. `cdpr identify`, `cdpr select` only.
    pub task: Option<Task>,
    /// Errors that a publication prints of the stages of its machine. `cdpr chain` only.
    #[serde(default)]
    pub published: Vec<PublishedStage>,
}

/// Box of positions that the robot works at.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Task {
    /// Lower corner (world, m).
    pub min: [f64; 3],
    /// Upper corner (world, m).
    pub max: [f64; 3],
}

/// The model that computes the controlled lengths.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ControlModel {
    /// Path (relative to the study) or built-in name.
    pub robot: String,
    /// Composition; `standard` when missing.
    #[serde(default = "standard")]
    pub model: String,
    /// How an elastic model chooses the tensions that it commands, within their limits; `qp` when missing: the nearest to the middle
    /// of the limits.
    pub tension_method: Option<cdpr_model::tension::Method>,
    /// Map of `cdpr compensate`, made for this robot and model, that corrects the lengths it sends: path relative to the study. The winches stay
    /// as they were set without it, and poses beyond its samples are driven without correction.
    pub compensation: Option<String>,
}

impl ControlModel {
    /// Robot and composition of the control model.
    pub(crate) fn robot_model(&self) -> RobotModel {
        RobotModel { robot: self.robot.clone(), model: self.model.clone() }
    }
}

/// A robot file or built-in robot with a composition of effects.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobotModel {
    /// Path (relative to the study) or built-in name.
    pub robot: String,
    /// Composition; `standard` when missing.
    #[serde(default = "standard")]
    pub model: String,
}

impl RobotModel {
    /// The composition of the effects; `None` if the word is invalid.
    fn composition(&self) -> Option<Composition> {
        self.model.parse().ok()
    }

    /// True if its lengths depend on tensions, see [`Composition::needs_tensions`].
    fn needs_tensions(&self) -> bool {
        self.composition().is_some_and(Composition::needs_tensions)
    }
}

fn standard() -> String {
    Composition::STANDARD.to_string()
}

/// Limits of the machine; they replace those of the robot files.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct StudyLimits {
    /// Least tension (N).
    pub tension_min_N: Option<f64>,
    /// Largest tension (N).
    pub tension_max_N: Option<f64>,
    /// Largest position error of the reachable workspace (m).
    pub position_error_max_m: Option<f64>,
    /// Largest rotation error of the reachable workspace (rad).
    pub rotation_error_max_rad: Option<f64>,
    /// Largest difference between an emerging and its commanded tension in the reachable workspace (N); for control models that command
    /// tensions.
    pub tension_error_max_N: Option<f64>,
}

/// Poses to command.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Poses {
    /// A regular grid.
    pub grid: Option<PoseGrid>,
    /// A file with one pose a row.
    pub file: Option<PoseFile>,
    /// Random poses in a box of their own, or that of the grid.
    pub random: Option<RandomPoses>,
    /// Single cables shortened at some poses of elastic machines: such samples distinguish stiffness from geometry.
    pub tension_tests: Option<TensionTests>,
    /// Which of all these poses count: every one when missing.
    pub only: Option<PoseFilter>,
}

/// Poses that count.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum PoseFilter {
    /// Those at which tensions of the machine within their limits balance the load (eq. 3.29).
    WrenchFeasible,
}

/// A grid over pose components, first component slowest.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseGrid {
    /// Lower corner (m, rad).
    pub min: Vec<f64>,
    /// Upper corner (m, rad).
    pub max: Vec<f64>,
    /// Points per component, limits included; 1 takes the middle, 0 leaves the grid out and keeps its box.
    pub count: Vec<usize>,
    /// Written to the column `set` of the samples.
    pub set: Option<String>,
}

/// A file of poses.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseFile {
    /// Path relative to the study: a CSV with the pose columns of measurements.
    pub path: String,
    /// Written to the column `set` of the samples.
    pub set: Option<String>,
}

/// Random poses, uniform in a box.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RandomPoses {
    /// How many.
    pub count: usize,
    /// Lower corner of the box (m, rad); that of the grid when missing.
    pub min: Option<Vec<f64>>,
    /// Upper corner of the box (m, rad); that of the grid when missing.
    pub max: Option<Vec<f64>>,
    /// Each angle is uniform within ± this (rad), one per rotation of the pattern; the box counts when missing.
    pub rotation_rad: Option<Vec<f64>>,
    /// Written to the column `set` of the samples.
    pub set: Option<String>,
}

/// Single cables shortened at some poses: at each of them every cable in turn, one sample a cable.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TensionTests {
    /// By how much (m).
    pub shorten_m: f64,
    /// At how many poses, spread evenly over the list of all poses.
    pub count: usize,
    /// Written to the column `set` of the samples; that of the pose when missing.
    pub set: Option<String>,
}

/// JSON Schema of study files.
pub fn schema() -> schemars::Schema {
    schemars::schema_for!(Study)
}

impl Study {
    /// True if a side of the study has tensions.
    fn is_elastic(&self) -> bool {
        [&self.control.robot_model(), &self.machine].iter().any(|side| side.needs_tensions())
    }

    /// Remarks for the user: a machine poorer than its control model, and keys without effect.
    pub fn remarks(&self) -> Vec<String> {
        let poorer = self.control.robot_model().composition().zip(self.machine.composition());
        poorer
            .and_then(|(control, machine)| remark_on_poorer(control, machine))
            .into_iter()
            .chain(self.idle())
            .chain(self.idle_method())
            .collect()
    }

    /// Remark on a tension method where no tensions are commanded; else `None`.
    fn idle_method(&self) -> Option<String> {
        let commands = self.control.robot_model().needs_tensions();
        let model = &self.control.model;
        (self.control.tension_method.is_some() && !commands)
            .then(|| format!("a `{model}` control model commands no tensions: [control] tension_method without effect"))
    }

    /// Remarks on keys of the study without effect.
    fn idle(&self) -> Vec<String> {
        let initial = &self.initial;
        let tensions = [
            ("[initial] tensions_N", initial.tensions_N.is_some()),
            ("[initial] tension_method", initial.tension_method.is_some()),
        ];
        let list = |stated: &[(&'static str, bool)]| -> Option<String> {
            let names: Vec<&str> = stated.iter().filter(|(_, stated)| *stated).map(|(name, _)| *name).collect();
            (!names.is_empty()).then(|| names.join(", "))
        };
        let (has_offsets, has_limits) = (initial.offset.is_some() || initial.offset_m.is_some(), self.limits.is_some());
        let has_noise = self.noise.is_some_and(|noise| noise.tension.is_some());
        if !self.is_elastic() {
            let all = [tensions[0], tensions[1], ("[limits]", has_limits), ("[noise] tension_N", has_noise)];
            let names = list(&all).map(|names| format!("a rigid machine has no tensions: {names} without effect"));
            return names.into_iter().collect();
        }
        match (has_offsets, list(&tensions)) {
            (true, Some(names)) => vec![format!("the study states the winch offsets: {names} without effect")],
            _ => Vec::new(),
        }
    }

    /// The robot with the limits of the study instead of those in its file.
    #[must_use]
    pub(crate) fn limited(&self, mut robot: Robot) -> Robot {
        let Some(limits) = &self.limits else { return robot };
        for cable in &mut robot.cables {
            cable.tension_min = limits.tension_min_N.or(cable.tension_min);
            cable.tension_max = limits.tension_max_N.or(cable.tension_max);
        }
        robot
    }

    /// The initial pose of a robot.
    pub fn initial_pose(&self, robot: &Robot) -> Result<Pose, PatternError> {
        robot.motion_pattern.pose(robot.plane, &self.initial.pose)
    }
}
