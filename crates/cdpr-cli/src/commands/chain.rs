//! `cdpr chain`: chapter 6 as one study.

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::numbers::NumberList;
use crate::progress::Progress;
use crate::study_file::StudyFile;
use cdpr_model::control::CommandedPose;
use cdpr_model::geometry::Pose;
use cdpr_reports::answers::ChainAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr chain studies/twin-chain.toml --region=-2,2,-2,2,0.75,2.75 --report chain.html
  cdpr chain study.toml --seed 4 --format json";

/// Part of the largest extent of the poses by which the larger region goes beyond them on every side.
const BEYOND: f64 = 1.0 / 6.0;

/// Difference of the seeds of the first and the second record.
const NEXT_SEED: u64 = 2;

/// Run the whole chain from a nominal controller to force control on one machine.
///
/// Nominal controller, frame anchors identified, driven with them, identified again, constant orientation, nominal elastostatic model
/// (`[prediction]` of the study), elastostatic model identified, and exact force control by both on the poses of the study and by the
/// identified one on the edges of a larger region. Tensions that follow worse than before the identification are a caution before all else
/// (status done-with-caution, exit code 0). The answer lists the errors of every stage beside those that the study quotes from a publication (`[[published]]`).
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Study file (TOML): nominal controller, machine, `[prediction]` with the nominal elastostatic model, poses, noise.
    #[arg(value_name = "STUDY")]
    study: PathBuf,

    /// Larger region for force control: smallest and largest coordinate along each axis of the robot; the box of the poses and a sixth of its
    /// largest extent on every side when left out.
    #[arg(long, value_name = "BOX", allow_hyphen_values = true)]
    region: Option<NumberList>,

    /// Seed of random poses and of the noise; the second record has this plus 2.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,

    /// Page to write: every stage in one HTML file.
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let study_file = StudyFile::read(&arguments.study)?;
    study_file.introduce(output);
    let commands = study_file.commands(arguments.seed)?;
    let region = region(&study_file, &arguments, &commands)?;
    let progress = Progress::spinner("running the chain");
    let seeds = [arguments.seed, arguments.seed.wrapping_add(NEXT_SEED)];
    let again = study_file.commands(seeds[1])?;
    let chain = study_file.chain([&commands, &again], &region, seeds).map_err(|error| study_file.refused(&error))?;
    drop(progress);
    chain.left_out.iter().for_each(|why| output.remark(why));
    let name = arguments.report.as_ref().map(|path| path.display().to_string());
    let answer = ChainAnswer::new(&study_file, chain, &region, arguments.seed).with_report(name);
    if let Some(path) = &arguments.report {
        let page = answer.page(&crate::session::command_line(), env!("CARGO_PKG_VERSION"));
        let page = page.map_err(|error| Failure::unwritable("the page of the chain", &error))?;
        files::write(path, page.as_bytes())?;
    }
    output.answer(&answer)
}

/// The larger region in the directions of the motion pattern.
fn region(study_file: &StudyFile, arguments: &Arguments, commands: &[CommandedPose]) -> Result<Vec<[f64; 2]>, Failure> {
    let axes = study_file.machine.axes();
    if let Some(NumberList(numbers)) = &arguments.region {
        let pairs: Vec<[f64; 2]> = numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
        let is_box = numbers.len() == 2 * axes.len() && pairs.iter().all(|[low, high]| low < high);
        return match is_box {
            true => Ok(pairs),
            false => {
                let message = format!("--region: {} numbers, smallest before largest, expected", 2 * axes.len());
                Err(Failure::input("usage::value", message, "e.g. --region=-2,2,-2,2,0.75,2.75"))
            }
        };
    }
    let ranges: Vec<[f64; 2]> = axes
        .iter()
        .map(|axis| {
            let along = |pose: &Pose| pose.position.dot(axis);
            let values = || commands.iter().map(|command| along(&command.pose));
            [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
        })
        .collect();
    let beyond = BEYOND * ranges.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
    Ok(ranges.into_iter().map(|[low, high]| [low - beyond, high + beyond]).collect())
}
