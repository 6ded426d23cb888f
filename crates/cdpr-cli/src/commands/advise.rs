//! `cdpr advise`: which control model is good enough for a robot and a task.

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use cdpr_model::control::{Control, Operation};
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::tension::Method;
use cdpr_reports::answers::{AdviceAnswer, AdviceTiming};
use cdpr_study::advice::{Candidate, advise};
use cdpr_workspace::Bounds;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::inputs::RobotArgument;
use crate::numbers::{NumberList, finite_number};
use crate::progress::Progress;
use crate::tension_method::TensionMethodArgument;

const EXAMPLES: &str = "\
Examples:
  cdpr advise planar-example --task=-1,1,4,6 --accuracy 0.005
  cdpr advise cablerobot-simulator-helicopter --task=-1,1,-1,1,1.2,2 --accuracy 0.005
  cdpr advise robot.toml --task box --accuracy 0.002 --format json";

/// Which control model is good enough for this robot, and what each effect that it leaves out costs.
///
/// The machine has all effects that the robot file has the keys for. Every simpler control model drives it over the task, with
/// the same robot and winches set at the home pose; the simplest one that reaches as much of the task as a control model like the
/// machine is recommended. Errors of parameters come on top: see `cdpr sensitivity` and `cdpr identify`. The answer is negative
/// (exit code 1) when not even that one reaches all of the task.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    robot: RobotArgument,

    /// The task: a box of positions x0,x1,y0,y1(,z0,z1) (m), or `box` for the travel that the robot file states; in the
    /// orientation of the home pose.
    #[arg(long, value_name = "BOX", allow_hyphen_values = true)]
    task: String,

    /// Largest position error (m).
    #[arg(long, value_name = "M", value_parser = finite_number, allow_hyphen_values = true)]
    accuracy: f64,

    #[command(flatten)]
    choice: TensionMethodArgument,

    /// Poses along each side of the box.
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(2..=100))]
    count: u32,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let robot = arguments.robot.read()?;
    if !(arguments.accuracy > 0.0) {
        let message = format!("--accuracy: {} m is no largest error", arguments.accuracy);
        return Err(
            Failure::usage("usage::value", message).with_help("give a positive number in metres, 0.005 for 5 mm")
        );
    }
    let refused = |error: &dyn cdpr_model::reading::ErrorCode| Failure::refused("ROBOT", error);
    let supported = Composition::supported(&robot).map_err(|error| refused(&error))?;
    let machine = Model::new(robot, supported.richest).map_err(|error| refused(&error))?;
    let task = task(&arguments.task, &machine)?;
    let poses = poses(&task, &machine, arguments.count as usize);
    let tension_method = arguments.choice.tension_method.unwrap_or_default();
    let progress = Progress::spinner("driving the machine with every control model");
    let advice =
        advise(&machine, &supported, &poses, arguments.accuracy, tension_method).map_err(|error| refused(&error))?;
    let command_ns =
        advice.candidates.iter().map(|candidate| command_time(&machine, candidate, tension_method, &poses)).collect();
    drop(progress);
    let missing = supported.missing.iter().map(|(effect, reason)| format!("{effect}: {reason}")).collect();
    let timing = AdviceTiming { command_ns };
    output.answer(&AdviceAnswer::new(&machine, &advice, &task, arguments.accuracy, missing, timing))
}

/// The box of the task.
fn task(text: &str, machine: &Model) -> Result<Bounds, Failure> {
    let refused = |message: String| {
        Failure::input("advice::task", message, "give the ends of a box in metres, as --task=-1,1,-1,1,0.5,2")
    };
    let ends = match (text, &machine.robot().travel) {
        ("box", Some(travel)) => {
            machine.axes().iter().flat_map(|axis| [axis.dot(&travel.min), axis.dot(&travel.max)]).collect()
        }
        ("box", None) => return Err(refused("--task box: the robot file states no travel".to_owned())),
        _ => text.parse::<NumberList>().map_err(|reason| refused(format!("--task: {reason}")))?.0,
    };
    Bounds::new(machine.axes().len(), &ends).map_err(|error| Failure::refused("--task", &error))
}

/// A grid over the box, faces included.
fn poses(task: &Bounds, machine: &Model, count: usize) -> Vec<Pose> {
    let dimension = task.dimension();
    let rotation = machine.robot().home_or_middle().rotation;
    let at = |mut cell: usize| {
        let mut position = nalgebra::Vector3::zeros();
        for (axis, direction) in machine.axes().iter().enumerate() {
            let share = (cell % count) as f64 / (count - 1) as f64;
            cell /= count;
            position += direction * (task.least()[axis] + share * task.extent(axis));
        }
        Pose { position, rotation }
    };
    (0..count.pow(dimension as u32)).map(at).collect()
}

/// Mean time of the control model for one pose (ns).
fn command_time(machine: &Model, candidate: &Candidate, tension_method: Method, poses: &[Pose]) -> f64 {
    let Ok(control) = Model::new(machine.robot().clone(), candidate.control) else { return f64::NAN };
    let offsets = vec![0.0; machine.cable_count()];
    let Ok(mut operation) = Operation::new(Control { tension_method, ..Control::from(&control) }, machine, &offsets)
    else {
        return f64::NAN;
    };
    let start = Instant::now();
    let rounds = (2000 / poses.len()).clamp(1, 200);
    for _ in 0..rounds {
        for pose in poses {
            let _ = black_box(operation.command(black_box(pose)));
        }
    }
    start.elapsed().as_secs_f64() * 1e9 / (rounds * poses.len()) as f64
}
