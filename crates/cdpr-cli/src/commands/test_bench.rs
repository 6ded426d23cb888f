//! `cdpr test-bench`: from a record of elongation and tension to a cable's laws of stretch.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_calibration::test_bench::{Record, Settings, identify};
use cdpr_model::reading::Size;
use clap::Args;

use crate::answer::{Output, TrustArguments};
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::files;
use crate::numbers::{Unreadable, finite_number};
use cdpr_reports::answers::{TestBenchAnswer, cable_keys, preload_remarks};

const EXAMPLES: &str = "\
Examples:
  cdpr test-bench record.csv --length 20
  cdpr test-bench record.csv --length 20 --pieces 8 --out cable.toml
  cdpr test-bench record.csv --length 0.5 --format json";

/// Identify how a cable stretches, with its hysteresis, from a record of a test bench.
///
/// The record is a CSV in the order of time with elongation_m (or _mm), tension_N (or _kN) and perhaps direction (1 loading,
/// -1 unloading, 0 at rest). It holds at least one whole cycle; elongations count from anywhere.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Record of the test bench (CSV).
    #[arg(value_name = "RECORD")]
    record: PathBuf,

    /// Free length of the sample, without tension (m).
    #[arg(long, value_name = "LENGTH", value_parser = positive_length)]
    length: f64,

    /// Cubic pieces of each branch over the elongations of the record.
    #[arg(long, value_name = "COUNT", default_value_t = 6, value_parser = clap::value_parser!(u8).range(1..=40))]
    pieces: u8,

    /// File to write with the keys for a table [[cable]] of a robot file.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,

    #[command(flatten)]
    trust: TrustArguments,
}

fn positive_length(text: &str) -> Result<f64, Unreadable> {
    match finite_number(text)? {
        length if length > 0.0 => Ok(length),
        length => Err(format!("{length} is no length of a sample: it must be above 0").into()),
    }
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let name = arguments.record.display().to_string();
    let bytes = files::read(&arguments.record, Size::Table)?;
    let reading = Record::from_csv(&bytes, &name).map_err(|error| FileKind::Table.refusal(&bytes, error))?;
    reading.notices.iter().for_each(|notice| output.remark(notice));
    let settings = Settings { pieces: arguments.pieces.into(), ..Settings::of_length(arguments.length) };
    let solution = identify(&reading.record, &settings).map_err(|error| Failure::refused(&name, &error))?;
    preload_remarks(&solution).iter().for_each(|remark| output.remark(remark));
    let keys = cable_keys(&solution, &name).map_err(|error| Failure::unwritable("the table", &error))?;
    if let Some(path) = &arguments.out {
        files::write(path, keys.as_bytes())?;
    }
    let out = arguments.out.map(|path| path.display().to_string());
    let answer = TestBenchAnswer::new(solution, name, reading.record.elongations.len(), keys, out);
    output.answer_accepting(&answer, arguments.trust)
}
