//! `cdpr friction`: friction and load of a winch from records at constant speeds.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_calibration::friction::{Record, identify};
use cdpr_model::reading::Size;
use clap::Args;

use crate::answer::{Output, TrustArguments};
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::files;
use cdpr_reports::answers::FrictionAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr friction winch.csv
  cdpr friction light.csv heavy.csv
  cdpr friction winch.csv --format json";

/// Identify friction and load of a winch from records of lifting and lowering at constant speeds.
///
/// A record is a CSV with motor_speed_rad_per_s (lifting positive; or _rpm, _deg_per_s) and motor_torque_Nm (against the load
/// positive; or _mNm), and perhaps load_Nm, the torque m g r of the hanging load. With t_s rows are samples: stretches of constant speed are
/// looked for in them, and acceleration and settling are left out; otherwise a row is the mean of such a stretch. Each record without load_Nm has a load
/// of its own. Both directions are needed: lifting alone cannot tell friction from the load.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Records of one winch (CSV), each with a load of its own where load_Nm is not given.
    #[arg(value_name = "RECORD", required = true)]
    records: Vec<PathBuf>,

    #[command(flatten)]
    trust: TrustArguments,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let mut records = Vec::new();
    let mut names = Vec::new();
    for path in &arguments.records {
        let name = path.display().to_string();
        let bytes = files::read(path, Size::Table)?;
        let reading = Record::from_csv(&bytes, &name).map_err(|error| FileKind::Table.refusal(&bytes, error))?;
        reading.notices.iter().for_each(|notice| output.remark(notice));
        records.push(reading.record);
        names.push(name);
    }
    let solution = identify(&records).map_err(|error| Failure::refused(&names.join(", "), &error))?;
    output.answer_accepting(&FrictionAnswer::new(solution, names), arguments.trust)
}
