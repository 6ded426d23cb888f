//! `cdpr advise`: which control model is good enough for a robot and a task.

use std::hint::black_box;
use std::process::ExitCode;
use std::time::Instant;

use cdpr::geometry::Pose;
use cdpr::metamodel::advice::{Advice, Candidate, advise};
use cdpr::metamodel::effects;
use cdpr::metamodel::errors::PoseError;
use cdpr::metamodel::{Control, Operation};
use cdpr::model::{Composition, Model};
use cdpr::tension::Method;
use cdpr::workspace::Bounds;
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::RobotArgument;
use crate::number_format::significant;
use crate::numbers::{NumberList, finite_number};
use crate::progress::Progress;
use crate::table::{Table, cell};
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

#[derive(Serialize)]
struct Advised {
    status: &'static str,
    reason: Option<String>,
    robot: String,
    machine: String,
    task_m: Vec<f64>,
    poses: usize,
    accuracy_m: f64,
    recommended: Option<String>,
    must_be_modelled: Vec<EffectAnswer>,
    may_be_left_out: Vec<EffectAnswer>,
    candidates: Vec<CandidateAnswer>,
    missing: Vec<String>,
    timing: Timing,
}

/// What differs from run to run.
#[derive(Serialize)]
struct Timing {
    /// Mean time of one command of each candidate (ns), in their order.
    command_ns: Vec<f64>,
}

/// One effect, left out of the machine's model on its own.
#[derive(Serialize)]
struct EffectAnswer {
    effect: &'static str,
    position_error_mean_m: f64,
    position_error_max_m: f64,
    rotation_error_max_rad: f64,
    #[serde(rename = "tension_error_N")]
    tension_error: Option<f64>,
    reached_share: f64,
    parameter_count: usize,
    cost: &'static str,
}

#[derive(Serialize)]
struct CandidateAnswer {
    model: String,
    left_out: Vec<&'static str>,
    position_error_m: PoseError,
    rotation_error_rad: PoseError,
    #[serde(rename = "tension_error_N")]
    tension_error: Option<f64>,
    reached_share: f64,
    share_within_tension_limits: f64,
    parameter_count: usize,
    reason: Option<String>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let robot = arguments.robot.read()?;
    if !(arguments.accuracy > 0.0) {
        let message = format!("--accuracy: {} m is no largest error", arguments.accuracy);
        return Err(Failure::usage("usage::value", message).with_help("give a positive number in metres, 0.005 for 5 mm"));
    }
    let refused = |error: &dyn cdpr::error_code::ErrorCode| Failure::refused("ROBOT", error);
    let supported = Composition::supported(&robot).map_err(|error| refused(&error))?;
    let machine = Model::new(robot, supported.richest).map_err(|error| refused(&error))?;
    let task = task(&arguments.task, &machine)?;
    let poses = poses(&task, &machine, arguments.count as usize);
    let tension_method = arguments.choice.tension_method.unwrap_or_default();
    let progress = Progress::spinner("driving the machine with every control model");
    let advice = advise(&machine, &supported, &poses, arguments.accuracy, tension_method).map_err(|error| refused(&error))?;
    let command_ns = advice.candidates.iter().map(|candidate| command_time(&machine, candidate, tension_method, &poses)).collect();
    drop(progress);
    let missing = supported.missing.iter().map(|(effect, reason)| format!("{effect}: {reason}")).collect();
    let timing = Timing { command_ns };
    output.answer(&Advised::new(&machine, &advice, &task, poses.len(), arguments.accuracy, missing, timing))
}

/// The box of the task.
fn task(text: &str, machine: &Model) -> Result<Bounds, Failure> {
    let refused = |message: String| Failure::input("advice::task", message, "give the ends of a box in metres, as --task=-1,1,-1,1,0.5,2");
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
        let mut position = cdpr::nalgebra::Vector3::zeros();
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
    let Ok(mut operation) = Operation::new(Control { model: &control, tension_method }, machine, &offsets) else { return f64::NAN };
    let start = Instant::now();
    let rounds = (2000 / poses.len()).clamp(1, 200);
    for _ in 0..rounds {
        for pose in poses {
            let _ = black_box(operation.command(black_box(pose)));
        }
    }
    start.elapsed().as_secs_f64() * 1e9 / (rounds * poses.len()) as f64
}

impl Advised {
    fn new(
        machine: &Model,
        advice: &Advice,
        task: &Bounds,
        poses: usize,
        accuracy: f64,
        missing: Vec<String>,
        timing: Timing,
    ) -> Self {
        let full = advice.candidates.last();
        let best = full.map_or(0.0, |full| full.reached_share);
        let recommended = advice.recommended.map(|index| advice.candidates[index].control.to_string());
        let mut effects = [Vec::new(), Vec::new()];
        for effect in advice.machine.words() {
            let without = advice.machine.without(effect);
            let Some(candidate) = advice.candidates.iter().find(|candidate| candidate.control == without) else { continue };
            let answer = EffectAnswer::new(effect, candidate, machine.cable_count());
            effects[usize::from(candidate.reached_share >= best)].push(answer);
        }
        let [must_be_modelled, may_be_left_out] = effects;
        let reason = (best < 1.0).then(|| {
            let why = full.and_then(|full| full.reason.clone()).map_or_else(String::new, |why| format!(": {why}"));
            format!("even a control model like the machine reaches only {:.1} % of the task{why}", 100.0 * best)
        });
        Self {
            status: if reason.is_none() { "advised" } else { "out-of-reach" },
            reason,
            robot: machine.robot().name.clone(),
            machine: advice.machine.to_string(),
            task_m: task.ends(),
            poses,
            accuracy_m: accuracy,
            recommended,
            must_be_modelled,
            may_be_left_out,
            candidates: advice.candidates.iter().map(CandidateAnswer::new).collect(),
            missing,
            timing,
        }
    }
}

impl EffectAnswer {
    fn new(effect: &'static str, without: &Candidate, cables: usize) -> Self {
        let (per_cable, cost) = effects::cost(effect);
        Self {
            effect,
            position_error_mean_m: without.position_error.mean,
            position_error_max_m: without.position_error.max,
            rotation_error_max_rad: without.rotation_error.max,
            tension_error: without.tension_error,
            reached_share: without.reached_share,
            parameter_count: per_cable * cables,
            cost,
        }
    }

    fn sentence(&self) -> String {
        let turn = self.rotation_error_max_rad.to_degrees();
        let turn = if turn > 1e-6 { format!(", {}°", significant(turn, 2)) } else { String::new() };
        let tension = self.tension_error.map_or_else(String::new, |error| format!(", {} N of tension", significant(error, 3)));
        let parameters = match self.parameter_count {
            0 => String::new(),
            count => format!("{count} parameters, "),
        };
        format!(
            "  {}: left out it costs up to {} mm{turn}{tension} and leaves {:.0} % of the task; with it: {parameters}{}\n",
            self.effect,
            significant(1e3 * self.position_error_max_m, 3),
            100.0 * self.reached_share,
            self.cost
        )
    }
}

impl CandidateAnswer {
    fn new(candidate: &Candidate) -> Self {
        Self {
            model: candidate.control.to_string(),
            left_out: candidate.left_out.clone(),
            position_error_m: candidate.position_error,
            rotation_error_rad: candidate.rotation_error,
            tension_error: candidate.tension_error,
            reached_share: candidate.reached_share,
            share_within_tension_limits: candidate.commanded_share,
            parameter_count: candidate.parameter_count,
            reason: candidate.reason.clone(),
        }
    }
}

impl Answer for Advised {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self) -> String {
        let mut text = format!(
            "{}: control models against the machine {}, {} poses of the task, {} mm required\n\n",
            self.robot,
            self.machine,
            self.poses,
            significant(1e3 * self.accuracy_m, 3)
        );
        let mut table =
            Table::new(["control model", "mean mm", "max mm", "max °", "tension N", "reached", "parameters", "ns"]);
        for (candidate, time) in self.candidates.iter().zip(&self.timing.command_ns) {
            let finite = |number: f64| Some(number).filter(|number| number.is_finite());
            let mark = if self.recommended.as_ref() == Some(&candidate.model) { " ←" } else { "" };
            table.row(vec![
                format!("{}{mark}", candidate.model),
                cell(finite(1e3 * candidate.position_error_m.mean), 3),
                cell(finite(1e3 * candidate.position_error_m.max), 3),
                cell(finite(candidate.rotation_error_rad.max.to_degrees()), 4),
                cell(candidate.tension_error, 1),
                format!("{:.0} %", 100.0 * candidate.reached_share),
                candidate.parameter_count.to_string(),
                cell(finite(*time), 0),
            ]);
        }
        text.push_str(&table.text());
        if let Some(reason) = &self.reason {
            text.push_str(&format!("\n{reason}\n"));
        }
        if let Some(recommended) = &self.recommended {
            text.push_str(&format!("\nrecommended: {recommended}, the simplest that reaches as much as a model like the machine\n"));
        }
        for (title, effects) in [("must be modelled", &self.must_be_modelled), ("may be left out", &self.may_be_left_out)] {
            if !effects.is_empty() {
                text.push_str(&format!("\n{title}\n"));
                effects.iter().for_each(|effect| text.push_str(&effect.sentence()));
            }
        }
        if !self.missing.is_empty() {
            text.push_str(&format!("\nnot judged, since the robot file lacks their keys\n  {}\n", self.missing.join("\n  ")));
        }
        text
    }
}
