//! `cdpr sweep`: reachable workspaces over parameters, or what accuracy costs, in parts that several machines can compute.

mod command_plan;
mod merged;
mod planned;
mod prepared;
mod sweep_plan;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cdpr_model::reading::Size;
use cdpr_study::sweep::{Subjects, Sweep, check};
use clap::{Args, Subcommand};
use command_plan::CommandPlan;
use merged::merge;
use planned::{Planned, RowFile};
pub use prepared::{PlanRefused, PreparedPlan};
use sweep_plan::SweepPlan;

use crate::answer::Output;
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::files;
use crate::interruption;
use crate::numbers::Unreadable;
use crate::progress::Progress;
use crate::session::quoted;
use crate::study_file::{robot_of_study, study_of};
use cdpr_reports::sweep_progress::SweepProgress;

const EXAMPLES: &str = "\
Examples:
  cdpr sweep all studies/sweep-planar-tension.toml --out tension
  cdpr sweep all studies/sweep-twin-cost.toml --out cost
  cdpr sweep plan studies/sweep-planar-stiffness.toml --out stiffness
  cdpr sweep run stiffness
  cdpr sweep run stiffness --shard 1/2
  cdpr sweep run stiffness --points 3,7,11
  cdpr sweep merge stiffness
  cdpr sweep plan --out benchmark -- benchmark --seed 3";

/// How the reachable workspace changes with parameters of control model, machine and study; or what accuracy costs.
///
/// With a table [calibration] every sensor, model and number of poses calibrates the machine of the study, and the cheapest for a wanted accuracy is
/// told.
/// `plan` writes a folder with everything that a sweep needs; `run` computes its points, or one shard of them, and goes on
/// where it was interrupted; `merge` joins the rows to result.json, result.csv and, for one parameter, result.svg; `all` does
/// the three in turn. The result does not depend on how many shards and threads computed it.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    step: StepOfSweep,
}

#[derive(Debug, Subcommand)]
enum StepOfSweep {
    /// Plan, compute and merge a sweep at once.
    All {
        /// Sweep file (TOML), as for `plan`.
        #[arg(value_name = "SWEEP")]
        sweep: PathBuf,
        /// Folder for plan, rows and result.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
    },
    /// Write the plan of a sweep into a folder, or of a command whose work has parts.
    Plan {
        /// Sweep file (TOML): the study, the parameters and their values; `cdpr schema sweep` describes it.
        #[arg(value_name = "SWEEP", required_unless_present = "command", conflicts_with = "command")]
        sweep: Option<PathBuf>,
        /// Folder for plan, rows and result.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
        /// Instead of a sweep: a command with its options, behind two dashes. `benchmark` has a part for each robot, `sensitivity` for sixteen drawn
        /// robots, `campaign --repeats` for each repetition.
        #[arg(last = true, value_name = "COMMAND")]
        command: Vec<String>,
    },
    /// Compute the points of a planned sweep that are not there yet.
    Run {
        /// Folder that `plan` wrote.
        #[arg(value_name = "DIR")]
        folder: PathBuf,
        /// Compute only shard i of n: points i, i + n, i + 2n, … of the plan.
        #[arg(long, value_name = "i/n", default_value = "1/1", value_parser = shard)]
        shard: Shard,
        /// Compute only these points of the plan, counted from 0.
        #[arg(long, value_name = "LIST", value_delimiter = ',', conflicts_with = "shard")]
        points: Option<Vec<usize>>,
    },
    /// Join the rows of all shards.
    Merge {
        /// Folder with plan and rows.
        #[arg(value_name = "DIR")]
        folder: PathBuf,
    },
}

/// Part `number` (from 1) of `count`.
#[derive(Clone, Copy, Debug)]
struct Shard {
    number: usize,
    count: usize,
}

/// Points that a run computes.
#[derive(Clone, Debug)]
enum Part {
    Shard(Shard),
    Points(Vec<usize>),
}

impl Part {
    /// The points among so many, each once and in the order of the plan.
    fn points(&self, count: usize) -> Result<Vec<usize>, Failure> {
        match self {
            Self::Shard(Shard { number, count: shards }) => Ok((number - 1..count).step_by(*shards).collect()),
            Self::Points(points) => match points.iter().find(|point| **point >= count) {
                Some(point) => {
                    let message = format!("--points: there is no point {point}");
                    let help = format!("the plan has the points 0 to {}", count.saturating_sub(1));
                    Err(Failure::input("sweep::no-point", message, help))
                }
                None => Ok(points.iter().copied().collect::<BTreeSet<_>>().into_iter().collect()),
            },
        }
    }

    /// The option that asks for this part; empty for all points.
    fn option(&self) -> String {
        match self {
            Self::Shard(Shard { count: 1, .. }) => String::new(),
            Self::Shard(Shard { number, count }) => format!(" --shard {number}/{count}"),
            Self::Points(points) => {
                format!(" --points {}", points.iter().map(usize::to_string).collect::<Vec<_>>().join(","))
            }
        }
    }
}

fn shard(text: &str) -> Result<Shard, Unreadable> {
    let parts = text.split_once('/').and_then(|(number, count)| Some((number.parse().ok()?, count.parse().ok()?)));
    match parts {
        Some((number, count)) if (1..=count).contains(&number) => Ok(Shard { number, count }),
        _ => Err(format!("`{text}` is no shard: write 1/2 for the first of two").into()),
    }
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    match arguments.step {
        StepOfSweep::All { sweep, out } => {
            plan(&sweep, &out, output)?;
            compute(&out, Planned::read(&out)?, &Part::Shard(Shard { number: 1, count: 1 }))?;
            merge(&out, &Planned::read(&out)?, output)
        }
        StepOfSweep::Plan { sweep: Some(sweep), out, .. } => {
            let planned = plan(&sweep, &out, output)?;
            output.answer(&planned)
        }
        StepOfSweep::Plan { sweep: None, out, command } => {
            let plan = Planned::Command(CommandPlan::new(command)?);
            plan.write(&out)?;
            output.answer(&SweepProgress::planned(out.display().to_string(), plan.row_names()))
        }
        StepOfSweep::Run { folder, shard, points } => {
            let part = points.map_or(Part::Shard(shard), Part::Points);
            let plan = Planned::read(&folder)?;
            introduce(&plan, output)?;
            output.answer(&compute(&folder, plan, &part)?)
        }
        StepOfSweep::Merge { folder } => {
            let plan = Planned::read(&folder)?;
            introduce(&plan, output)?;
            merge(&folder, &plan, output)
        }
    }
}

fn plan(path: &Path, out: &Path, output: &mut Output) -> Result<SweepProgress, Failure> {
    let name = path.display().to_string();
    let bytes = files::read(path, Size::Text)?;
    let sweep = Sweep::from_toml_bytes(&bytes, &name).map_err(|error| FileKind::Sweep.refusal(&bytes, error))?;
    let study_path = path.parent().unwrap_or(Path::new("")).join(&sweep.study);
    let study_bytes = files::read(&study_path, Size::Text)?;
    let study = study_of(&study_bytes, &study_path.display().to_string())?;
    let folder = study_path.parent().unwrap_or(Path::new(""));
    let robot = |name: &str| Ok::<String, Failure>(robot_of_study(name, folder)?.to_toml());
    let subjects = Subjects {
        study: String::from_utf8_lossy(&study_bytes).into_owned(),
        control: robot(&study.control.robot)?,
        machine: robot(&study.machine.robot)?,
        offset_robot: study.initial.offset_robot.as_deref().map(robot).transpose()?,
    };
    check(&sweep, &subjects).map_err(|error| Failure::refused(&name, &error))?;
    let plan = SweepPlan::new(sweep, subjects);
    plan.introduce(output)?;
    let plan = Planned::Sweep(Box::new(plan));
    plan.write(out)?;
    Ok(SweepProgress::planned(out.display().to_string(), plan.row_names()))
}

/// Tells which robot a sweep is about, and the remarks on its study.
fn introduce(plan: &Planned, output: &Output) -> Result<(), Failure> {
    match plan {
        Planned::Sweep(sweep) => sweep.introduce(output),
        Planned::Command(_) => Ok(()),
    }
}

fn compute(folder: &Path, plan: Planned, part: &Part) -> Result<SweepProgress, Failure> {
    let mine = part.points(plan.count())?;
    let name = quoted(&folder.display().to_string());
    let next = format!("`cdpr sweep run {name}{}`", part.option());
    let (mut missing, mut computed) = (Vec::new(), 0);
    for &point in &mine {
        if RowFile::read(folder, &plan, point)?.is_none() {
            missing.push(point);
        }
    }
    let already_there = mine.len() - missing.len();
    let (names, prepared) = (plan.row_names(), PreparedPlan::of(plan)?);
    // points that are there cost nothing and tell nothing of the others
    let progress = Progress::of(missing.len(), "sweeping");
    for point in missing {
        interruption::keeps(format!(
            "{} of {} points are kept in {}; {next} goes on",
            already_there + computed,
            mine.len(),
            folder.display()
        ));
        RowFile::write(folder, &names[point], &prepared.row_bytes(point)?)?;
        computed += 1;
        progress.step();
    }
    drop(progress);
    Ok(SweepProgress::computed(folder.display().to_string(), computed, already_there))
}
