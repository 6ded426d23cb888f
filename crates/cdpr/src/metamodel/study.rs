//! Study files: which control model drives which machine, through which poses, measured with which noise.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::Deserialize;

use crate::geometry::{Pose, Twist};
use crate::measurement::SensorSigmas;
use crate::model::Composition;
use crate::reading::{ReadError, Step, TomlDocument, text_from_bytes};
use crate::robot::Robot;

/// Most poses a study may ask for.
const POSE_LIMIT: usize = 1_000_000;

/// A study as its file states it; robots are named, not read.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// The model that computes the controlled lengths.
    pub control: RobotModel,
    /// What answers: same or higher complexity, own parameters.
    pub machine: RobotModel,
    /// Where the winches are set.
    pub initial: Initial,
    /// Tension limits and the largest position error, for machines that know tensions.
    pub limits: Option<Limits>,
    /// Poses to command.
    pub poses: Option<Poses>,
    /// Sensor noise of `cdpr simulate`.
    pub noise: Option<SensorSigmas>,
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

fn standard() -> String {
    Composition::STANDARD.to_string()
}

/// The pose at which the winches are set, and how.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct Initial {
    /// Pose components of the motion pattern (m, rad).
    pub pose: Vec<f64>,
    /// Initial tensions (N); without meaning for a rigid machine.
    pub tensions_N: Option<Vec<f64>>,
    /// How initial tensions are found; without meaning for a rigid machine.
    pub tension_method: Option<String>,
    /// `"none"`: the control model's lengths go to the machine as they are.
    pub offset: Option<String>,
    /// Winch offsets, one per cable (m).
    pub offset_m: Option<Vec<f64>>,
    /// The robot whose model was in use when the winches were set.
    pub offset_robot: Option<String>,
}

/// Limits of the machine.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
pub struct Limits {
    /// Least tension (N).
    pub tension_min_N: Option<f64>,
    /// Largest tension (N).
    pub tension_max_N: Option<f64>,
    /// Largest position error of the reachable workspace (m).
    pub position_error_max_m: Option<f64>,
}

/// Poses to command.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Poses {
    /// A regular grid.
    pub grid: Option<Grid>,
    /// A file with one pose a row.
    pub file: Option<PoseFile>,
    /// Random poses in the box of the grid.
    pub random: Option<Random>,
    /// Single cables shortened at some poses; for machines that know tensions.
    pub tension_tests: Option<TensionTests>,
}

/// A grid over pose components, first component slowest.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Grid {
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

/// Random poses, uniform in the box of the grid.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Random {
    /// How many.
    pub count: usize,
    /// Each angle is uniform within ± this (rad), one per rotation of the pattern; the grid's box counts when missing.
    pub rotation_rad: Option<Vec<f64>>,
    /// Written to the column `set` of the samples.
    pub set: Option<String>,
}

/// Single cables shortened at some poses.
#[derive(Clone, Debug, PartialEq, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TensionTests {
    /// By how much (m).
    pub shorten_m: f64,
    /// At how many poses.
    pub count: usize,
}

/// A pose to command, with the subset its sample belongs to.
#[derive(Clone, Debug, PartialEq)]
pub struct CommandedPose {
    /// The pose.
    pub pose: Pose,
    /// Name of the subset.
    pub set: Option<String>,
    /// A cable whose winch pulls in more than the control model asks for.
    pub shortened: Option<Shortening>,
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
        Self { pose, set: None, shortened: None }
    }
}

/// JSON Schema of study files.
pub fn schema() -> schemars::Schema {
    schemars::schema_for!(Study)
}

impl Study {
    /// Reads a study file.
    pub fn from_toml_bytes(bytes: &[u8], file_name: &str) -> Result<Self, ReadError> {
        let document = TomlDocument::parse(text_from_bytes(bytes, file_name)?, file_name)?;
        let study: Self = document.deserialize()?;
        study.check(&document)?;
        Ok(study)
    }

    fn check(&self, document: &TomlDocument<'_>) -> Result<(), ReadError> {
        let error = |path: &[&str], message: String| {
            let steps: Vec<Step<'_>> = path.iter().map(|key| Step::Key(key)).collect();
            document.error_at(&steps, "study::value", message)
        };
        for (section, model) in [("control", &self.control), ("machine", &self.machine)] {
            if let Err(reason) = model.model.parse::<Composition>() {
                return Err(error(&[section, "model"], reason.to_string()));
            }
        }
        let initial = &self.initial;
        if let Some(word) = initial.offset.as_ref().filter(|word| *word != "none") {
            return Err(error(&["initial", "offset"], format!("`{word}` is not an offset; the only word is \"none\"")));
        }
        let choices = [initial.offset.is_some(), initial.offset_m.is_some(), initial.offset_robot.is_some()];
        if choices.iter().filter(|&&chosen| chosen).count() > 1 {
            let message = "offset, offset_m and offset_robot exclude each other".to_owned();
            return Err(error(&["initial"], message).with_help("keep one of them"));
        }
        if let Some(tests) = self.poses.as_ref().and_then(|poses| poses.tension_tests.as_ref())
            && tests.count > 0
        {
            let message = "tension tests need an elastic machine, which is not part of this version".to_owned();
            return Err(error(&["poses", "tension_tests"], message).with_help("remove [poses.tension_tests]"));
        }
        self.check_grid(&error)
    }

    fn check_grid(&self, error: &dyn Fn(&[&str], String) -> ReadError) -> Result<(), ReadError> {
        let Some(poses) = &self.poses else { return Ok(()) };
        let path = ["poses", "grid"];
        let Some(grid) = &poses.grid else {
            return match poses.random {
                Some(_) => Err(error(&["poses", "random"], "random poses need the box of [poses.grid]".to_owned())),
                None => Ok(()),
            };
        };
        let dimension = grid.min.len();
        if grid.max.len() != dimension || grid.count.len() != dimension {
            let (max, count) = (grid.max.len(), grid.count.len());
            let message =
                format!("min has {dimension} components, max {max}, count {count}; they must be equally many");
            return Err(error(&path, message));
        }
        for (index, (min, max)) in grid.min.iter().zip(&grid.max).enumerate() {
            if !(min <= max) {
                return Err(error(&path, format!("component {}: min {min} is above max {max}", index + 1)));
            }
        }
        let points = grid.count.iter().try_fold(1_usize, |all, &count| all.checked_mul(count)).unwrap_or(usize::MAX);
        let random = poses.random.as_ref().map_or(0, |random| random.count);
        if points.saturating_add(random) > POSE_LIMIT {
            return Err(error(&path, format!("the study asks for more than {POSE_LIMIT} poses")));
        }
        Ok(())
    }

    /// What the study states without effect, since rigid machines know no tensions.
    pub fn remarks(&self) -> Vec<String> {
        let stated = [
            ("[initial] tensions_N", self.initial.tensions_N.is_some()),
            ("[initial] tension_method", self.initial.tension_method.is_some()),
            ("[limits]", self.limits.is_some()),
            ("[noise] tension_N", self.noise.is_some_and(|noise| noise.tension.is_some())),
        ];
        let names: Vec<&str> = stated.into_iter().filter(|(_, stated)| *stated).map(|(name, _)| name).collect();
        if names.is_empty() {
            return Vec::new();
        }
        vec![format!("a rigid machine has no tensions: {} without effect", names.join(", "))]
    }

    /// The initial pose of a robot.
    pub fn initial_pose(&self, robot: &Robot) -> Result<Pose, crate::geometry::PatternError> {
        robot.motion_pattern.pose(robot.plane, &self.initial.pose)
    }

    /// All poses to command: those of the file (given by the caller), the grid, then the random ones.
    pub fn commanded_poses(
        &self,
        robot: &Robot,
        from_file: Vec<Pose>,
        seed: u64,
    ) -> Result<Vec<CommandedPose>, crate::geometry::PatternError> {
        let Some(poses) = &self.poses else { return Ok(Vec::new()) };
        let file_set = poses.file.as_ref().and_then(|file| file.set.clone());
        let mut all: Vec<CommandedPose> = from_file
            .into_iter()
            .map(|pose| CommandedPose { set: file_set.clone(), ..CommandedPose::at(pose) })
            .collect();
        let Some(grid) = &poses.grid else { return Ok(all) };
        let pattern = robot.motion_pattern;
        for components in grid.points() {
            all.push(CommandedPose {
                set: grid.set.clone(),
                ..CommandedPose::at(pattern.pose(robot.plane, &components)?)
            });
        }
        // an empty grid still has to fit the pattern
        pattern.pose(robot.plane, &grid.min)?;
        if let Some(random) = &poses.random {
            let mut rng = ChaCha8Rng::seed_from_u64(seed);
            for _ in 0..random.count {
                let components = random.components(grid, pattern.translations(), &mut rng);
                all.push(CommandedPose {
                    set: random.set.clone(),
                    ..CommandedPose::at(pattern.pose(robot.plane, &components)?)
                });
            }
        }
        Ok(all)
    }
}

impl Grid {
    fn points(&self) -> Vec<Vec<f64>> {
        let mut points = vec![Vec::new()];
        for ((&min, &max), &count) in self.min.iter().zip(&self.max).zip(&self.count) {
            let value = |index: usize| match count {
                1 => 0.5 * (min + max),
                _ => min + (max - min) * index as f64 / (count - 1) as f64,
            };
            let extended =
                |point: &Vec<f64>| (0..count).map(|index| [point.as_slice(), &[value(index)]].concat()).collect();
            points = points.iter().flat_map(|point| -> Vec<Vec<f64>> { extended(point) }).collect();
        }
        points
    }
}

impl Random {
    fn components(&self, grid: &Grid, translations: usize, rng: &mut ChaCha8Rng) -> Vec<f64> {
        let mut uniform = |low: f64, high: f64| low + (high - low) * rng.random::<f64>();
        let component = |(index, (&min, &max)): (usize, (&f64, &f64))| {
            let angle = index.checked_sub(translations).and_then(|angle| self.rotation_rad.as_ref()?.get(angle));
            angle.map_or_else(|| (min, max), |&limit| (-limit.abs(), limit.abs()))
        };
        let ranges: Vec<(f64, f64)> = grid.min.iter().zip(&grid.max).enumerate().map(component).collect();
        ranges.into_iter().map(|(low, high)| uniform(low, high)).collect()
    }
}

/// A pose measured with noise: normal errors per axis of the motion pattern.
pub(super) fn with_pose_noise(
    pose: &Pose,
    basis: &[Twist],
    sigmas: &SensorSigmas,
    normal: &mut impl FnMut() -> f64,
) -> Pose {
    let (position, rotation) = (sigmas.position.unwrap_or(0.0), sigmas.rotation.unwrap_or(0.0));
    let mut error = Twist::zeros();
    for direction in basis {
        let is_turn = Vector3::from(direction.fixed_rows::<3>(3)).norm() > 0.0;
        error += direction * (if is_turn { rotation } else { position } * normal());
    }
    pose.displaced(&error)
}
