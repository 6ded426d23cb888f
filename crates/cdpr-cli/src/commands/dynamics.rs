//! `cdpr dynamics`: forward and inverse dynamics at a pose.

use std::process::ExitCode;

use cdpr_model::robot::Body;
use cdpr_plant::{Inertia, Plant, Winches};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::inputs::{ModelArguments, PoseArgument, load_of, twist_of};
use crate::numbers::NumberList;
use crate::statics_failure::refused;
use crate::tension_choice::{Chosen, tensions_of};
use cdpr_model::finding::{Finding, FindingKind, Severity};
use cdpr_reports::answers::{DynamicsAnswer, needed_wrench, placeholder_words};

const EXAMPLES: &str = "\
Examples:
  cdpr dynamics studies/robots/simulator-in-motion.toml --pose 0,0,1.5,0,0,0 --acceleration 0,0,2,0,0,0
  cdpr dynamics robot.toml --pose 0,0,1.5,0,0,0 --twist 1,0,0,0,0,0.5 --tensions 3678,2169,4250,1708,3985,2394,4715,1684";

/// Forward and inverse dynamics of the platform at a pose: M [v̇; ω̇] + n = wrench of the cables + load.
///
/// With --acceleration the wrench that the cables must exert, and the tensions for it nearest the middle of the robot's limits; otherwise the
/// acceleration under --tensions, or under those of cables with --lengths (law and damper together; the model must stretch). Mass, centre of mass
/// and inertia are those of the robot file; twist and acceleration are of the platform origin, translations then turns, world axes.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pose: PoseArgument,

    /// Velocity and angular velocity (m/s, rad/s); 0 when left out.
    #[arg(long, value_name = "TWIST", allow_hyphen_values = true)]
    twist: Option<NumberList>,

    /// Inverse dynamics: acceleration and angular acceleration wanted (m/s², rad/s²).
    #[arg(long, value_name = "ACCELERATION", allow_hyphen_values = true, conflicts_with_all = ["tensions", "lengths"])]
    acceleration: Option<NumberList>,

    /// Forward dynamics: cable tensions, one per cable (N); those that balance the load when left out.
    #[arg(long, value_name = "TENSIONS", allow_hyphen_values = true, conflicts_with = "lengths")]
    tensions: Option<NumberList>,

    /// Forward dynamics: controlled lengths that winches hold, one per cable (m).
    #[arg(long, value_name = "LENGTHS", allow_hyphen_values = true)]
    lengths: Option<NumberList>,

    /// Constant load in place of the robot's wrench and weight: fx,fy | fx,fy,m | fx,fy,fz | fx,fy,fz,mx,my,mz (N, N·m).
    #[arg(long, value_name = "WRENCH", allow_hyphen_values = true)]
    wrench: Option<NumberList>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let robot = model.robot();
    let pose = arguments.pose.of(robot)?;
    let twist = twist_of(robot, "--twist", arguments.twist.as_ref())?;
    let load = load_of(robot, arguments.wrench.as_ref())?;
    let body = Body::of(robot).map_err(|error| Failure::refused("ROBOT", &error))?;
    placeholder_words(robot, &body)
        .into_iter()
        .for_each(|words| output.doubt(&Finding::new(FindingKind::Load, Severity::Caution, words)));
    let inertia = Inertia::new(&model, body);
    let answer = if let Some(lengths) = &arguments.lengths {
        let plant = Plant::new(model, Winches::Ideal).map_err(|error| Failure::refused("ROBOT", &error))?;
        DynamicsAnswer::by_lengths(&plant, &pose, &twist, &load, &lengths.0)
            .map_err(|error| Failure::refused("--lengths", &error))?
    } else {
        let wanted = twist_of(robot, "--acceleration", arguments.acceleration.as_ref())?;
        let needed = needed_wrench(&inertia, &pose, &twist, &load, &wanted);
        let asked = NumberList(model.twist_basis().iter().map(|basis| -basis.dot(&needed)).collect());
        let wrench = if arguments.acceleration.is_some() { Some(&asked) } else { arguments.wrench.as_ref() };
        match tensions_of(&model, &pose, wrench, arguments.tensions.as_ref())? {
            Chosen::None { status, reason } => {
                DynamicsAnswer::new(&model, &inertia, &pose, &twist, &wanted, &needed).refused(status, reason)
            }
            Chosen::Tensions(tensions) => DynamicsAnswer::by_tensions(&model, &inertia, &pose, &twist, &load, tensions)
                .map_err(|error| refused("--tensions", &error))?,
        }
    };
    if !answer.is_finite() {
        return Err(Failure::numerical("the motion overflows; check the units of tensions, lengths and twist"));
    }
    output.answer(&answer)
}
