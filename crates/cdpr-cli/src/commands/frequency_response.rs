//! `cdpr frequency-response`: from a record of input and output to a frequency response.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_calibration::frequency_response::{Columns, Method, OrderChoice, Orders, Record, Settings, identify};
use cdpr_model::reading::Size;
use cdpr_reports::answers::FrequencyResponseAnswer;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::files;
use crate::keyword::keyword;
use crate::numbers::{Unreadable, finite_number};
use crate::session::command_line;

const EXAMPLES: &str = "\
Examples:
  cdpr frequency-response record.csv
  cdpr frequency-response record.csv --report response.html
  cdpr frequency-response record.csv --window 4 --coherence 0.8
  cdpr frequency-response record.csv --input current_A --output tension_N_3 --orders 2,0,delay
  cdpr frequency-response stepped.csv --method sine --format json";

/// Estimate gain, phase and coherence between two columns of a record, and fit a transfer function with poles, zeros and a delay.
///
/// The record is a CSV at an even rate with the time t_s, the input (motor_torque_Nm) and the output (tension_N), other columns by
/// --input and --output. Sweeps, noise and sums of sines are averaged over windows that overlap by half; a stepped sine is recognised. Cut-off (−3 dB
/// against the lowest trusted frequency), peak and poles are told with 95 % intervals. The answer is negative (exit code 1) where the coherence is bad over most of the
/// frequencies, or the record does not reach the cut-off or is too short.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Record (CSV).
    #[arg(value_name = "RECORD")]
    record: PathBuf,

    /// Column of what the machine is told; taken as free of noise.
    #[arg(long, value_name = "COLUMN", default_value = "motor_torque_Nm")]
    input: String,

    /// Column of what it answers.
    #[arg(long, value_name = "COLUMN", default_value = "tension_N")]
    output: String,

    /// Way to estimate the points: h1 (averaged windows) or sine (steps of one frequency); left out: sine for a stepped sine, h1 for all else.
    #[arg(long, value_name = "METHOD", value_parser = keyword::<Method>())]
    method: Option<Method>,

    /// Length of a window (s); an eighth of the record when left out. Longer windows resolve sharper resonances, shorter ones average more.
    #[arg(long, value_name = "SECONDS", value_parser = finite_number, allow_hyphen_values = true)]
    window: Option<f64>,

    /// Least coherence of a trusted point, 0 to 1.
    #[arg(long, value_name = "SHARE", value_parser = finite_number, allow_hyphen_values = true, default_value_t = Settings::default().coherence)]
    coherence: f64,

    /// Most poles of the transfer function, of which Schwarz's criterion chooses.
    #[arg(long, value_name = "COUNT", default_value_t = 4, value_parser = clap::value_parser!(u8).range(0..=6), conflicts_with = "orders")]
    max_poles: u8,

    /// Numbers of poles and zeros in place of a choice: 2,0 or with a delay 2,0,delay.
    #[arg(long, value_name = "ORDERS", value_parser = orders)]
    orders: Option<Orders>,

    /// Writes a page with gain, phase and coherence over frequency.
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

/// Orders as `2,0` or `2,0,delay`.
fn orders(text: &str) -> Result<Orders, Unreadable> {
    let parts: Vec<&str> = text.split(',').map(str::trim).collect();
    let (numbers, has_delay) = match parts.as_slice() {
        [numbers @ .., "delay"] => (numbers, true),
        numbers => (numbers, false),
    };
    match numbers {
        [poles, zeros] => match (poles.parse(), zeros.parse()) {
            (Ok(poles), Ok(zeros)) => Ok(Orders { poles, zeros, has_delay }),
            _ => Err(format!("`{text}` has numbers that are no counts: write poles,zeros as 2,0").into()),
        },
        _ => Err(format!("`{text}` is not poles,zeros as 2,0 or poles,zeros,delay as 2,0,delay").into()),
    }
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let name = arguments.record.display().to_string();
    let bytes = files::read(&arguments.record, Size::Table)?;
    let columns = Columns { input: arguments.input, output: arguments.output };
    let reading = Record::from_csv(&bytes, &name, &columns).map_err(|error| FileKind::Table.refusal(&bytes, error))?;
    reading.notices.iter().for_each(|notice| output.remark(notice));
    let orders = match arguments.orders {
        Some(orders) => OrderChoice::Given(orders),
        None => OrderChoice::UpTo(arguments.max_poles.into()),
    };
    let Arguments { method, window, coherence, .. } = arguments;
    let settings = Settings { method, window, coherence, orders };
    let solution = identify(&reading.record, &settings).map_err(|error| Failure::refused(&name, &error))?;
    let samples = reading.record.times.len();
    let report = arguments.report.as_ref().map(|path| path.display().to_string());
    let answer = FrequencyResponseAnswer::new(solution, name, samples, columns.input, columns.output);
    let answer = answer.with_report(report);
    if let Some(path) = &arguments.report {
        let page = answer.page(&command_line(), env!("CARGO_PKG_VERSION"));
        let page = page.map_err(|error| Failure::unwritable("the page of the response", &error))?;
        files::write(path, page.as_bytes())?;
    }
    output.answer(&answer)
}
