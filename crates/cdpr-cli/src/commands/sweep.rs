//! `cdpr sweep`: reachable workspaces over parameters, or what accuracy costs, in parts that several machines can compute.

mod folder;
mod merged;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cdpr_model::reading::Size;
use cdpr_study::sweep::{PreparedSweep, Subjects, Sweep, check};
use clap::{Args, Subcommand};
use folder::{Plan, RowFile};
use merged::merge;

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
  cdpr sweep merge stiffness";

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
    /// Write the plan of a sweep into a folder.
    Plan {
        /// Sweep file (TOML): the study, the parameters and their values; `cdpr schema sweep` describes it.
        #[arg(value_name = "SWEEP")]
        sweep: PathBuf,
        /// Folder for plan, rows and result.
        #[arg(long, value_name = "DIR")]
        out: PathBuf,
    },
    /// Compute the points of a planned sweep that are not there yet.
    Run {
        /// Folder that `plan` wrote.
        #[arg(value_name = "DIR")]
        folder: PathBuf,
        /// Compute only shard i of n: points i, i + n, i + 2n, … of the plan.
        #[arg(long, value_name = "i/n", default_value = "1/1", value_parser = shard)]
        shard: Shard,
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
            let plan = Plan::read(&out)?;
            compute(&out, &plan, Shard { number: 1, count: 1 })?;
            merge(&out, &plan, output)
        }
        StepOfSweep::Plan { sweep, out } => {
            let planned = plan(&sweep, &out, output)?;
            output.answer(&planned)
        }
        StepOfSweep::Run { folder, shard } => {
            let plan = Plan::read(&folder)?;
            plan.introduce(output)?;
            output.answer(&compute(&folder, &plan, shard)?)
        }
        StepOfSweep::Merge { folder } => {
            let plan = Plan::read(&folder)?;
            plan.introduce(output)?;
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
    let plan = Plan::new(sweep, subjects);
    plan.introduce(output)?;
    plan.write(out)?;
    Ok(SweepProgress::planned(out.display().to_string(), plan.points.len()))
}

fn compute(folder: &Path, plan: &Plan, shard: Shard) -> Result<SweepProgress, Failure> {
    let mine: Vec<usize> = (shard.number - 1..plan.points.len()).step_by(shard.count).collect();
    let prepared = PreparedSweep::new(&plan.sweep, &plan.subjects);
    let prepared = prepared.map_err(|error| Failure::refused(&folder.display().to_string(), &error))?;
    let name = quoted(&folder.display().to_string());
    let next = match shard.count {
        1 => format!("`cdpr sweep run {name}`"),
        count => format!("`cdpr sweep run {name} --shard {}/{count}`", shard.number),
    };
    let (mut missing, mut computed) = (Vec::new(), 0);
    for &point in &mine {
        if RowFile::read(folder, plan, point)?.is_none() {
            missing.push(point);
        }
    }
    let already_there = mine.len() - missing.len();
    // points that are there cost nothing and tell nothing of the others
    let progress = Progress::of(missing.len(), "sweeping");
    for point in missing {
        interruption::keeps(format!(
            "{} of {} points are kept in {}; {next} goes on",
            already_there + computed,
            mine.len(),
            folder.display()
        ));
        let row = match plan.sweep.calibration {
            Some(_) => prepared.calibration_row(point, &plan.points[point]),
            None => prepared.row(point, &plan.points[point]),
        };
        RowFile::write(folder, plan, row)?;
        computed += 1;
        progress.step();
    }
    drop(progress);
    Ok(SweepProgress::computed(folder.display().to_string(), computed, already_there))
}
