//! `cdpr test-bench`: from a record of elongation and tension to a cable's laws of stretch.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr::identification::test_bench::{Misfit, Record, Settings, Solution, identify};
use cdpr::reading::Size;
use cdpr::robot::HysteresisTable;
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::files;
use crate::numbers::finite_number;
use crate::table::{Table, cell};

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
}

fn positive_length(text: &str) -> Result<f64, String> {
    match finite_number(text)? {
        length if length > 0.0 => Ok(length),
        length => Err(format!("{length} is no length of a sample: it must be above 0")),
    }
}

/// Error of one law (N, and % of the range of tensions).
#[derive(Serialize)]
struct ErrorAnswer {
    #[serde(rename = "rms_N")]
    rms: f64,
    #[serde(rename = "max_N")]
    max: f64,
    rms_percent_of_range: f64,
}

#[derive(Serialize)]
#[expect(non_snake_case, reason = "keys carry their units")]
struct TestBenchAnswer {
    record: String,
    samples: usize,
    loading_strokes: usize,
    unloading_strokes: usize,
    tension_min_N: f64,
    tension_max_N: f64,
    elongation_min_m: f64,
    elongation_max_m: f64,
    zero_elongation_m: f64,
    hysteresis_error: ErrorAnswer,
    loading_error: ErrorAnswer,
    unloading_error: ErrorAnswer,
    polynomial_error: Option<ErrorAnswer>,
    linear_error: ErrorAnswer,
    linear_stiffness_N_per_m: f64,
    axial_stiffness_EA_N: f64,
    tension_of_strain_N: Option<Vec<f64>>,
    stiffness_min_N_per_m: f64,
    stiffness_max_N_per_m: f64,
    loss_per_cycle_J: f64,
    recorded_loss_per_cycle_J: f64,
    hysteresis: HysteresisTable,
    out: Option<String>,
    #[serde(skip)]
    keys: String,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let name = arguments.record.display().to_string();
    let bytes = files::read(&arguments.record, Size::Table)?;
    let reading = Record::from_csv(&bytes, &name).map_err(|error| Failure::File(Box::new(error)))?;
    reading.notices.iter().for_each(|notice| output.remark(notice));
    let settings = Settings { pieces: arguments.pieces.into(), ..Settings::of_length(arguments.length) };
    let solution = identify(&reading.record, &settings).map_err(|error| Failure::refused(&name, &error))?;
    let keys = keys(&solution, &name).map_err(|error| Failure::unwritable("the table", &error))?;
    if let Some(path) = &arguments.out {
        files::write(path, keys.as_bytes())?;
    }
    let out = arguments.out.map(|path| path.display().to_string());
    output.answer(&TestBenchAnswer { samples: reading.record.elongations.len(), out, ..answer(solution, name, keys) })
}

fn answer(solution: Solution, record: String, keys: String) -> TestBenchAnswer {
    let range = solution.tensions[1] - solution.tensions[0];
    let error = |misfit: Misfit| ErrorAnswer {
        rms: misfit.rms,
        max: misfit.max,
        rms_percent_of_range: 100.0 * misfit.rms / range,
    };
    TestBenchAnswer {
        record,
        samples: 0,
        loading_strokes: solution.strokes[0],
        unloading_strokes: solution.strokes[1],
        tension_min_N: solution.tensions[0],
        tension_max_N: solution.tensions[1],
        elongation_min_m: solution.elongations[0],
        elongation_max_m: solution.elongations[1],
        zero_elongation_m: solution.zero,
        hysteresis_error: error(solution.hysteresis),
        loading_error: error(solution.loading),
        unloading_error: error(solution.unloading),
        polynomial_error: solution.polynomial.as_ref().map(|fit| error(fit.misfit)),
        linear_error: error(solution.linear.misfit),
        linear_stiffness_N_per_m: solution.linear.stiffness,
        axial_stiffness_EA_N: solution.linear.axial_stiffness,
        tension_of_strain_N: solution.polynomial.map(|fit| fit.coefficients),
        stiffness_min_N_per_m: solution.stiffness[0],
        stiffness_max_N_per_m: solution.stiffness[1],
        loss_per_cycle_J: solution.loss,
        recorded_loss_per_cycle_J: solution.measured_loss,
        hysteresis: solution.table,
        out: None,
        keys,
    }
}

/// The keys of the robot file.
#[derive(Serialize)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
struct Keys<'a> {
    axial_stiffness_EA_N: f64,
    tension_of_strain_N: Option<&'a [f64]>,
}

fn keys(solution: &Solution, record: &str) -> Result<String, toml::ser::Error> {
    let flat = toml::to_string(&Keys {
        axial_stiffness_EA_N: solution.linear.axial_stiffness,
        tension_of_strain_N: solution.polynomial.as_ref().map(|fit| fit.coefficients.as_slice()),
    })?;
    let table = toml::to_string(&solution.table)?;
    // a line break in a name would end the comment
    let record: String = record.chars().filter(|character| !character.is_control()).collect();
    Ok(format!("# keys for a table [[cable]], from {record}\n{flat}\n[cable.hysteresis]\n{table}"))
}

impl Answer for TestBenchAnswer {
    fn words(&self) -> String {
        let mut table = Table::new(["law", "effect", "rms N", "max N", "rms % of range"]).left_column(1);
        let mut row = |law: &str, effect: &str, error: &ErrorAnswer| {
            let numbers =
                [cell(Some(error.rms), 1), cell(Some(error.max), 1), cell(Some(error.rms_percent_of_range), 2)];
            table.row([vec![law.to_owned(), effect.to_owned()], numbers.to_vec()].concat());
        };
        row("straight line", "elastic", &self.linear_error);
        self.polynomial_error.iter().for_each(|error| row("polynomial", "polynomial", error));
        row("both branches", "hysteresis", &self.hysteresis_error);
        row("  loading", "", &self.loading_error);
        row("  unloading", "", &self.unloading_error);
        let heading = format!(
            "{}: {} samples, {} full loading and {} full unloading strokes, {:.0} to {:.0} N over {:.2} mm",
            self.record,
            self.samples,
            self.loading_strokes,
            self.unloading_strokes,
            self.tension_min_N,
            self.tension_max_N,
            1e3 * (self.elongation_max_m - self.elongation_min_m),
        );
        let stiffness = format!(
            "stiffness of the sample: {:.1} kN/m by the straight line, {:.1} to {:.1} kN/m on the loading branch",
            1e-3 * self.linear_stiffness_N_per_m,
            1e-3 * self.stiffness_min_N_per_m,
            1e-3 * self.stiffness_max_N_per_m,
        );
        let loss = format!(
            "energy lost per full cycle: {:.2} J by the law, {:.2} J recorded",
            self.loss_per_cycle_J, self.recorded_loss_per_cycle_J
        );
        let end = match &self.out {
            Some(path) => format!("written to {path}\n"),
            None => self.keys.clone(),
        };
        format!("{heading}\n\n{}\n{stiffness}\n{loss}\n\n{end}", table.text())
    }
}
