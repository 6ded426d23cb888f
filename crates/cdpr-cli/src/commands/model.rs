//! `cdpr model`: what each effect that a robot's file supports changes at a pose.

use std::process::ExitCode;

use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::statics::{Load, LoadError, balanced_wrench};
use cdpr_study::effects::{EffectState, contributions};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::inputs::{PoseArgument, RobotArgument, load_of};
use crate::numbers::NumberList;
use crate::statics_failure::refused;
use crate::tension_choice::{Chosen, tensions_of};
use cdpr_reports::answers::EffectsAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr model cablerobot-simulator-helicopter --pose 1,0.5,1.7,0,0,0
  cdpr model planar-example --pose 0.5,4 --wrench 0,-3000
  cdpr model robot.toml --pose 0,0,2,0,0,0 --tensions 3678,2169,4250,1708,3985,2394,4715,1684 --format json";

/// Effects that matter: what each one changes at a pose, before any study.
///
/// The machine has all effects at once that the robot file has the keys for; the control model lacks one of them, or has a
/// simpler one in its place. The answer is the difference of the controlled lengths, of the tensions, and of the pose that the
/// platform takes when the control model's lengths drive the machine.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    robot: RobotArgument,

    #[command(flatten)]
    pose: PoseArgument,

    /// Constant load in place of the robot's wrench and weight: fx,fy | fx,fy,m | fx,fy,fz | fx,fy,fz,mx,my,mz (N, N·m).
    #[arg(long, value_name = "WRENCH", allow_hyphen_values = true)]
    wrench: Option<NumberList>,

    /// Cable tensions, one per cable (N), and with them the load that they balance; those nearest the middle of the limits that
    /// balance the robot's load when left out.
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true, conflicts_with = "wrench")]
    tensions: Option<NumberList>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let robot = arguments.robot.read()?;
    let supported = Composition::supported(&robot).map_err(|error| Failure::refused("ROBOT", &error))?;
    let model = Model::new(robot, supported.richest).map_err(|error| Failure::refused("ROBOT", &error))?;
    let pose = arguments.pose.of(model.robot())?;
    let answer = EffectsAnswer::new(&model, &supported, &pose);
    if let Err(path) = model.cable_lengths(&pose) {
        return output.answer(&answer.refused("singular", path.to_string()));
    }
    let tensions = match tensions(&model, &pose, &arguments)? {
        Chosen::Tensions(tensions) => (!tensions.is_empty()).then_some(tensions),
        Chosen::None { status, reason } => return output.answer(&answer.refused(status, reason)),
    };
    let load = load(&model, &pose, &arguments)?;
    let state = EffectState { pose, load, tensions };
    let found = contributions(&model, &supported, &state).map_err(|error| Failure::refused("ROBOT", &error))?;
    output.answer(&answer.compared(&found, model.robot(), state.tensions))
}

/// The tensions of the state; no tensions if lengths do not depend on them.
fn tensions(model: &Model, pose: &Pose, arguments: &Arguments) -> Result<Chosen, Failure> {
    if arguments.tensions.is_none() && model.lengths_without_tensions(pose).is_some() {
        return Ok(Chosen::Tensions(Vec::new()));
    }
    tensions_of(model, pose, arguments.wrench.as_ref(), arguments.tensions.as_ref())
}

/// Load that given tensions balance, or the one asked for.
fn load(model: &Model, pose: &Pose, arguments: &Arguments) -> Result<Result<Load, LoadError>, Failure> {
    match &arguments.tensions {
        Some(NumberList(tensions)) => {
            let wrench = balanced_wrench(model, pose, tensions).map_err(|error| refused("--tensions", &error))?;
            Ok(Ok(Load::constant(wrench)))
        }
        None if arguments.wrench.is_none() => Ok(Load::of(model.robot())),
        None => load_of(model.robot(), arguments.wrench.as_ref()).map(Ok),
    }
}
