//! `cdpr capability`: payload, acceleration and speed everywhere in a box.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_reports::answers::{AskedCapability, CapabilityAnswer};
use cdpr_workspace::capability::{Capability, Settings};
use cdpr_workspace::{Bounds, WorkspaceError};
use clap::Args;

use super::workspace::rotation;
use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::{ModelArguments, limits_of, load_of};
use crate::numbers::{NumberList, finite_number};
use crate::progress::Progress;
use crate::session::command_line;

const EXAMPLES: &str = "\
Examples:
  cdpr capability planar-example --box=-1,1,3,5
  cdpr capability cogiro --box=-3,3,-2,2,1,3 --report capability.html
  cdpr capability robot.toml --box=-1,1,-1,1,0.5,2 --payload-place 0.2 --gap 0.001
  cdpr capability robot.toml --box=-1,1,-1,1,0.5,2 --rotation 0,0,0.3 --min 50 --max 2000 --format json";

/// Payload, acceleration and speed that a robot has everywhere in a box of positions, and which limit fails first where.
///
/// Payload: the largest mass besides the robot's own load for which tensions within the limits balance the weight.
/// Acceleration: the largest one from rest, in any direction and in both senses of each axis, without turning. Speed: the
/// largest one in any direction at which no cable is faster than speed_max_m_s and the speed of its drive
/// (motor_speed_max_rad_per_s). Each with a lower bound that holds for every pose of the box. The answer is negative (exit
/// code 1) when the robot does not hold its own load somewhere in the box.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    /// Box of positions of the platform origin, ends along each translation x0,x1,y0,y1(,z0,z1) (m); those of its plane for a
    /// planar robot.
    #[arg(long = "box", value_name = "BOX", allow_hyphen_values = true)]
    bounds: NumberList,

    /// Orientation of the platform: rx,ry,rz with R = Rx Ry Rz, or the angle in a plane (rad); that of the home pose when left
    /// out.
    #[arg(long, value_name = "ROTATION", allow_hyphen_values = true)]
    rotation: Option<NumberList>,

    /// How far from the platform origin the payload may lie along each axis of the platform (m), anywhere in ± this.
    #[arg(long, value_name = "M", value_parser = finite_number, allow_hyphen_values = true, default_value_t = 0.0)]
    payload_place: f64,

    /// Least tension of all cables (N), in place of the file's.
    #[arg(long, value_name = "N", value_parser = finite_number, allow_hyphen_values = true)]
    min: Option<f64>,

    /// Largest tension of all cables (N), in place of the file's.
    #[arg(long, value_name = "N", value_parser = finite_number, allow_hyphen_values = true)]
    max: Option<f64>,

    /// Constant load in place of the robot's wrench and weight: fx,fy | fx,fy,m | fx,fy,fz | fx,fy,fz,mx,my,mz (N, N·m).
    #[arg(long, value_name = "WRENCH", allow_hyphen_values = true)]
    wrench: Option<NumberList>,

    /// Largest gap between value and lower bound, as a share of the value.
    #[arg(long, value_name = "SHARE", value_parser = finite_number, allow_hyphen_values = true, default_value_t = Settings::default().gap)]
    gap: f64,

    /// Poses that may be judged; the answer states the gap that is left.
    #[arg(long, value_name = "N", default_value_t = Settings::default().poses)]
    poses: u64,

    /// Writes a page with a map of each quantity.
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let robot = model.robot();
    let load = load_of(robot, arguments.wrench.as_ref())?;
    let limits = limits_of(robot, arguments.min, arguments.max)?;
    let turned = match &arguments.rotation {
        Some(numbers) => rotation(&model, "--rotation", &numbers.0)?,
        None => robot.home_or_middle().rotation,
    };
    let bounds = Bounds::new(model.axes().len(), &arguments.bounds.0);
    let bounds = bounds.map_err(|error| Failure::refused("--box", &error))?;
    let capability = Capability::new(&model, &load, &limits, turned, arguments.payload_place);
    let capability = capability.map_err(|error| refused(&error))?;
    let settings = Settings { gap: arguments.gap, poses: arguments.poses };
    let progress = Progress::spinner("searching the box");
    let solution = capability.solve(&bounds, &settings).map_err(|error| refused(&error))?;
    drop(progress);
    let payload_place = arguments.payload_place;
    let asked =
        AskedCapability { model: &model, capability: &capability, bounds: &bounds, settings: &settings, payload_place };
    let name = arguments.report.as_ref().map(|path| path.display().to_string());
    let answer = CapabilityAnswer::new(&asked, &solution).with_report(name);
    if let Some(path) = &arguments.report {
        let page = answer.page(&asked, &solution, &command_line(), env!("CARGO_PKG_VERSION"));
        let page = page.map_err(|error| Failure::unwritable("the page of the capability", &error))?;
        files::write(path, page.as_bytes())?;
    }
    output.answer(&answer)
}

/// The mistake, with the option that makes it.
fn refused(error: &WorkspaceError) -> Failure {
    let option = match error {
        WorkspaceError::Capability { setting: "gap", .. } => "--gap",
        WorkspaceError::Capability { setting: "number of poses", .. } => "--poses",
        WorkspaceError::Capability { .. } => "--payload-place",
        WorkspaceError::SaggingCables { .. } => "--model",
        _ => "ROBOT",
    };
    Failure::refused(option, error)
}
