//! Laws of a cable's stretch from a record of a test bench.

use cdpr::identification::test_bench::{Misfit, Solution};
use cdpr::robot::HysteresisTable;
use serde::Serialize;

use super::Answer;
use crate::number_format::cell;
use crate::table::Table;

/// Error of one law (N, and % of the range of tensions).
#[derive(Serialize)]
struct ErrorAnswer {
    #[serde(rename = "rms_N")]
    rms: f64,
    #[serde(rename = "max_N")]
    max: f64,
    rms_percent_of_range: f64,
}

/// Laws of a cable with their errors.
#[derive(Serialize)]
#[expect(non_snake_case, reason = "keys carry their units")]
pub struct TestBenchAnswer {
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

impl TestBenchAnswer {
    /// Laws from a record of a name with so many samples; their keys, and the name of the file that these were written to.
    pub fn new(solution: Solution, (record, samples): (String, usize), keys: String, out: Option<String>) -> Self {
        let range = solution.tensions[1] - solution.tensions[0];
        let error = |misfit: Misfit| ErrorAnswer {
            rms: misfit.rms,
            max: misfit.max,
            rms_percent_of_range: 100.0 * misfit.rms / range,
        };
        Self {
            record,
            samples,
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
            out,
            keys,
        }
    }
}

/// The keys of the robot file.
#[derive(Serialize)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
struct Keys<'a> {
    axial_stiffness_EA_N: f64,
    tension_of_strain_N: Option<&'a [f64]>,
}

/// Keys for a table [[cable]] of a robot file, from a record of a name (TOML).
pub fn cable_keys(solution: &Solution, record: &str) -> Result<String, toml::ser::Error> {
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
    fn words(&self, width: Option<usize>) -> String {
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
        format!("{heading}\n\n{}\n{stiffness}\n{loss}\n\n{end}", table.text(width))
    }
}
