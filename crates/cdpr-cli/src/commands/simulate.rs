//! `cdpr simulate`: virtual measurements from a study.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_model::control::simulate::Simulation;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;
use crate::study_file::StudyFile;
use crate::tension_method::TensionMethodArgument;
use cdpr_reports::answers::{SimulationAnswer, simulated_by};

const EXAMPLES: &str = "\
Examples:
  cdpr simulate study.toml --out samples.csv
  cdpr simulate study.toml --out samples.csv --seed 7 --format json
  cdpr simulate study.toml --out samples.csv --motor-angles";

/// Drive a machine by a control model through the poses of a study, and record what its sensors see.
///
/// Beside DATA.csv a sidecar DATA.meta.toml with the sensor accuracies is written, which `identify` and `select` read.
/// Elastic machines record tensions too.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Study file (TOML); `cdpr schema study` describes it.
    #[arg(value_name = "STUDY")]
    study: PathBuf,

    /// Measurement file to write (CSV).
    #[arg(long, value_name = "FILE")]
    out: PathBuf,

    /// Record the angles of the winches' motors in place of cable lengths; control model or machine needs the effect `drum`.
    #[arg(long)]
    motor_angles: bool,

    #[command(flatten)]
    choice: TensionMethodArgument,

    /// Seed of random poses and noise.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let study_file = StudyFile::read(&arguments.study)?.with_tension_method(arguments.choice.tension_method);
    study_file.introduce(output);
    let progress = Progress::spinner("measuring");
    let commands = study_file.commands(arguments.seed)?;
    let Simulation { mut samples, left_out, .. } = study_file.accepted(study_file.record(&commands, arguments.seed))?;
    drop(progress);
    if samples.is_empty() {
        let reason = left_out.first().map(|(_, reason)| reason.clone()).unwrap_or_default();
        let message = format!("{}: no pose gave a sample: {reason}", arguments.study.display());
        return Err(Failure::input(
            "study::no-samples",
            message,
            "`cdpr accuracy STUDY` counts what happens at the poses",
        ));
    }
    if arguments.motor_angles {
        samples = study_file.accepted(study_file.with_motor_angles(&samples))?;
    }
    let sidecar = arguments.out.with_extension("meta.toml");
    let (known, table) =
        (study_file.sidecar(simulated_by(), arguments.seed).to_toml(), samples.to_csv(study_file.machine.robot()));
    files::write_all(&[(&sidecar, known.as_bytes()), (&arguments.out, table.as_bytes())])?;
    let files = [&arguments.out, &sidecar].map(|path| path.display().to_string());
    output.answer(&SimulationAnswer::new(&study_file, &commands, &left_out, arguments.seed, files))
}
