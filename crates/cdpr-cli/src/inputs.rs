//! The robot that most commands are about, its pose, load and tension limits.

use std::path::{Path, PathBuf};

use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::measurement::poses_from_csv;
use cdpr_model::model::{Composition, Model};
use cdpr_model::reading::{Size, did_you_mean};
use cdpr_model::robot::{LAWS, Robot, builtin};
use cdpr_model::statics::Load;
use cdpr_model::tension::{Limits, LimitsError};
use clap::Args;

use crate::commands::new::template_names;
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::files;
use crate::numbers::NumberList;

/// Said when angles become lengths without a drum.
pub(crate) const IDEAL_WINCH: &str = "motor angles are taken for those of ideal winches, drum_start_length_m + drum_radius_m · angle: \
                                      the effect `drum` takes pitch and place of the drums into account";

/// `ROBOT` of every command.
#[derive(Clone, Debug, Args)]
pub(crate) struct RobotArgument {
    /// Robot file (TOML), or the name of a built-in robot (see `cdpr robots`).
    #[arg(value_name = "ROBOT")]
    robot: String,
}

/// `ROBOT` and `--model`.
#[derive(Clone, Debug, Args)]
pub(crate) struct ModelArguments {
    #[command(flatten)]
    robot: RobotArgument,

    #[arg(long, default_value_t = Composition::STANDARD, value_name = "MODEL")]
    #[arg(help = model_help(false), long_help = model_help(true))]
    model: Composition,
}

impl RobotArgument {
    /// The robot: a name with a dot or a separator is a path, any other first a built-in robot.
    pub(crate) fn read(&self) -> Result<Robot, Failure> {
        read_robot(&self.robot)
    }

    /// The robot with these effects.
    pub(crate) fn model(&self, composition: Composition) -> Result<Model, Failure> {
        Model::new(self.read()?, composition).map_err(|error| Failure::refused(&self.robot, &error))
    }
}

impl ModelArguments {
    /// The robot with the effects asked for.
    pub(crate) fn read(&self) -> Result<Model, Failure> {
        self.robot.model(self.model)
    }
}

/// Words that make up a model; the long help has a line on every law of stretch, too.
fn model_help(is_long: bool) -> String {
    let single = Composition::all().filter(|composition| composition.effects().count() == 1);
    let words: Vec<String> = single.map(|composition| composition.to_string()).collect();
    let help = format!("Effects of the model: `standard`, or effects joined by `+`: {}", words.join(", "));
    match is_long {
        true => {
            let laws = LAWS.iter().map(|law| format!("{} ({})", law.word, law.summary));
            format!("{help}. One law of stretch at most: {}.", laws.collect::<Vec<_>>().join(", "))
        }
        false => help,
    }
}

/// Reads a robot by path or built-in name.
pub(crate) fn read_robot(text: &str) -> Result<Robot, Failure> {
    let path = Path::new(text);
    let looks_like_path = text.contains(['/', '\\', '.']);
    if !looks_like_path && let Some(robot) = Robot::builtin(text) {
        return Ok(robot);
    }
    if looks_like_path || files::is_there(path) {
        let bytes = files::read(path, Size::Text).map_err(|failure| failure.with_help(help_for_missing_robot(text)))?;
        return Robot::from_toml_bytes(&bytes, text).map_err(|error| FileKind::Robot.refusal(&bytes, error));
    }
    let message = format!("there is neither a built-in robot nor a file named `{text}`");
    Err(Failure::input("robot::unknown-name", message, help_for_unknown_robot(text)))
}

/// Poses of a table, as the robot's motion pattern has them.
pub(crate) fn read_poses(path: &Path, robot: &Robot) -> Result<Vec<Pose>, Failure> {
    let bytes = files::read(path, Size::Table)?;
    poses_from_csv(&bytes, &path.display().to_string(), robot).map_err(|error| FileKind::Table.refusal(&bytes, error))
}

/// The built-in robot or the template that a wrong name probably meant.
pub(crate) fn help_for_unknown_robot(text: &str) -> String {
    let of_template = |template: &str| {
        format!(
            "`{template}` is a template: `cdpr new {template}` writes a folder of this name, and its robot is `{template}/robot.toml`"
        )
    };
    if template_names().any(|template| template == text) {
        return of_template(text);
    }
    let names: Vec<&str> = builtin::names().collect();
    match (did_you_mean(text, names.iter().copied()), did_you_mean(text, template_names())) {
        (Some(meant), _) => format!("did you mean `{meant}`? `cdpr robots` lists the built-in robots"),
        (None, Some(template)) => of_template(template),
        (None, None) => format!("give the path of a robot file, or one of the built-in robots: {}", names.join(", ")),
    }
}

fn help_for_missing_robot(text: &str) -> String {
    let folder = std::env::current_dir().map_or_else(|_| String::new(), |folder| folder.display().to_string());
    let stem = PathBuf::from(text).file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
    let looked = format!("looked from the folder {folder}");
    match builtin::names().find(|name| *name == stem) {
        Some(name) => format!("{looked}; the built-in robot of this name is called `{name}`, without path and ending"),
        None => format!("{looked}; `cdpr robots` lists the built-in robots"),
    }
}

/// `--pose`.
#[derive(Clone, Debug, Args)]
pub(crate) struct PoseArgument {
    /// Platform pose (m, rad): x,y | x,y,angle | x,y,z | x,y,z,rx,ry,rz, as the robot's motion pattern has it.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    pose: NumberList,
}

impl PoseArgument {
    /// The pose of this robot.
    pub(crate) fn of(&self, robot: &Robot) -> Result<Pose, Failure> {
        pose_of(robot, "--pose", &self.pose)
    }
}

/// The pose that an option gives by its components.
pub(crate) fn pose_of(robot: &Robot, option: &str, numbers: &NumberList) -> Result<Pose, Failure> {
    robot.motion_pattern.pose(robot.plane, &numbers.0).map_err(|error| Failure::refused(option, &error))
}

/// The pose that an option gives, or the robot's home pose.
pub(crate) fn pose_or_home(robot: &Robot, option: &str, numbers: Option<&NumberList>) -> Result<Pose, Failure> {
    numbers.map_or_else(|| Ok(robot.home_or_middle()), |numbers| pose_of(robot, option, numbers))
}

/// The load that `--wrench` gives, or the robot's own.
pub(crate) fn load_of(robot: &Robot, wrench: Option<&NumberList>) -> Result<Load, Failure> {
    match wrench {
        Some(numbers) => Ok(Load::constant(wrench_of(robot, "--wrench", numbers)?)),
        None => Load::of(robot).map_err(|error| Failure::refused("ROBOT", &error)),
    }
}

/// The twist or acceleration that an option gives by its components; none without it.
pub(crate) fn twist_of(robot: &Robot, option: &str, numbers: Option<&NumberList>) -> Result<Twist, Failure> {
    let Some(numbers) = numbers else { return Ok(Twist::zeros()) };
    robot.motion_pattern.twist(robot.plane, &numbers.0).map_err(|error| Failure::refused(option, &error))
}

/// The wrench that an option gives by its components: world axes, those of the file for a planar robot.
pub(crate) fn wrench_of(robot: &Robot, option: &str, numbers: &NumberList) -> Result<Wrench, Failure> {
    let pattern = robot.motion_pattern;
    if numbers.0.len() != pattern.dof() {
        let (name, found) = (pattern.name(), numbers.0.len());
        let components = pattern.wrench_names(robot.plane).join(",");
        let message =
            format!("{option}: motion pattern {name} takes the wrench components {components}, found {found} numbers");
        return Err(Failure::input(
            "wrench::component-count",
            message,
            "forces in N, moments about the platform origin in N·m, world axes",
        ));
    }
    let basis = pattern.twist_basis(robot.plane);
    Ok(basis.iter().zip(&numbers.0).map(|(unit, number)| unit * *number).sum())
}

/// The tension limits that `--min` and `--max` give, or the robot's own.
pub(crate) fn limits_of(robot: &Robot, minimum: Option<f64>, maximum: Option<f64>) -> Result<Limits, Failure> {
    Limits::of(robot, minimum, maximum).map_err(|error| {
        let source = match error {
            LimitsError::MissingKey { .. } => "ROBOT",
            _ => "--min, --max",
        };
        Failure::refused(source, &error)
    })
}
