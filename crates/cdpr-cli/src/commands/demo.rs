//! `cdpr demo`: the main job on the built-in virtual robot.

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use cdpr::metamodel::Study;
use cdpr::robot::Robot;
use clap::Args;

use super::simulate::{Laboratory, Recorded};
use crate::answer::Output;
use crate::failure::Failure;
use crate::selecting::{Comparison, NamedFile, Parted, Selected, SelectionArguments, two_files, write_folder};

const EXAMPLES: &str = "\
Examples:
  cdpr demo
  cdpr demo --out first-steps --require position_mean_m=0.005
  cdpr demo --format json";

/// Measurements to fit to: the 5 × 5 × 3 grid of sec. 6.1 and 16 turned poses, 91 samples as in the dissertation.
const TRAINING: &str = include_str!("demo/training.toml");

/// Measurements to judge by: random poses in the same box.
const VALIDATION: &str = include_str!("demo/validation.toml");

/// Show the main job on virtual measurements of the CableRobot Simulator.
///
/// The machine is the calibrated robot of the dissertation (eq. 6.7), the control model starts from the nominal one (eq.
/// 6.1). Candidates are identified from 91 noisy measurements and judged on 60 others; one is recommended.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    selection: SelectionArguments,

    /// Folder for the result and the measurements.
    #[arg(long, value_name = "DIR", default_value = "cdpr-demo")]
    out: PathBuf,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let (training, validation) = (record(TRAINING, 1)?, record(VALIDATION, 2)?);
    let robot = nominal_robot()?;
    let parted = two_files(&training.simulation.samples, &validation.simulation.samples, "validation.csv")?;
    let mut inputs = vec![NamedFile::new("robot.toml", robot.to_toml())];
    inputs.extend(measurement_files("training", TRAINING, &training, 1));
    inputs.extend(measurement_files("validation", VALIDATION, &validation, 2));
    let Parted { samples, folds, words } = parted;
    let compared = arguments.selection.compare(Comparison {
        robot,
        samples,
        folds,
        data_name: "training.csv (virtual measurements of the CableRobot Simulator)".to_owned(),
        validation_name: words,
        command: "cdpr select robot.toml training.csv --validation validation.csv --out .".to_owned(),
        warnings: vec!["these measurements are virtual: a machine with known parameters and sensor noise made them".to_owned()],
        inputs,
    })?;
    let mut answer = Selected::with_timing(&compared);
    let own_files = compared.comparison.inputs.iter().map(|file| NamedFile::new(&file.name, file.content.clone()));
    write_folder(&arguments.out, &compared, own_files.collect())?;
    answer.out = Some(arguments.out.display().to_string());
    output.answer(&answer)
}

fn record(study: &str, seed: u64) -> Result<Recorded, Failure> {
    let study = Study::from_toml_bytes(study.as_bytes(), "built-in study")?;
    Laboratory::new(&study, Path::new(""), "built-in study")?.run(seed)
}

fn nominal_robot() -> Result<Robot, Failure> {
    crate::inputs::read_robot("cablerobot-simulator-helicopter")
}

/// Samples, their sidecar and the study that made them.
fn measurement_files(name: &str, study: &str, recorded: &Recorded, seed: u64) -> [NamedFile; 3] {
    [
        NamedFile::new(format!("{name}-study.toml"), study),
        NamedFile::new(format!("{name}.meta.toml"), recorded.sidecar(seed).to_toml()),
        NamedFile::new(format!("{name}.csv"), recorded.simulation.samples.to_csv(recorded.machine.robot())),
    ]
}
