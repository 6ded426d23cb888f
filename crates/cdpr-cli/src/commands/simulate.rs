//! `cdpr simulate`: virtual measurements from a study.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr::metamodel::simulate::Simulation;
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;
use crate::study_file::StudyFile;
use crate::tension_method::TensionMethodArgument;
use cdpr_reports::answers::simulated_by;

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

#[derive(Serialize)]
struct Simulated {
    samples: usize,
    left_out: usize,
    reasons: Vec<String>,
    seed: u64,
    winch_offsets_m: Vec<f64>,
    out: String,
    sidecar: String,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let study_file = StudyFile::read(&arguments.study)?.with_tension_method(arguments.choice.tension_method);
    study_file.introduce(output);
    let progress = Progress::spinner("measuring");
    let Simulation { mut samples, left_out, .. } =
        study_file.accepted(study_file.record(&study_file.commands(arguments.seed)?, arguments.seed))?;
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
    output.answer(&Simulated {
        samples: samples.len(),
        left_out: left_out.len(),
        reasons: left_out.iter().map(|(pose, reason)| format!("pose {}: {reason}", pose + 1)).collect(),
        seed: arguments.seed,
        winch_offsets_m: study_file.offsets.clone(),
        out: arguments.out.display().to_string(),
        sidecar: sidecar.display().to_string(),
    })
}

impl Answer for Simulated {
    fn words(&self, _width: Option<usize>) -> String {
        let mut text =
            format!("{} samples written to {}, sensor accuracies to {}\n", self.samples, self.out, self.sidecar);
        if self.left_out > 0 {
            text.push_str(&format!("{} commands gave no sample:\n", self.left_out));
            self.reasons.iter().take(10).for_each(|reason| text.push_str(&format!("  {reason}\n")));
        }
        text
    }
}
