//! Laws of a cable's stretch from a record of a test bench.

use cdpr_calibration::Verdict;
use cdpr_calibration::selection::Warnings;
use cdpr_calibration::test_bench::{Misfit, Solution};
use cdpr_model::robot::HysteresisTable;
use schemars::JsonSchema;
use serde::Serialize;

use super::Answer;
use super::identification_words::{doubt_words, reason_of};
use crate::keys::WarningKeys;
use crate::number_format::cell;
use crate::table::Table;

/// Error of one law (N, and % of the range of tensions).
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "LawError")]
struct ErrorAnswer {
    /// Root mean square (N).
    #[serde(rename = "rms_N")]
    rms: f64,
    /// Largest magnitude (N).
    #[serde(rename = "max_N")]
    max: f64,
    /// Root mean square as a percentage of the range of tensions.
    rms_percent_of_range: f64,
}

/// Laws of a cable with their errors.
#[derive(Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "keys carry their units")]
#[schemars(rename = "TestBench")]
pub struct TestBenchAnswer {
    status: &'static str,
    /// False where nobody should work with the laws; the warnings say why.
    trusted: bool,
    #[serde(skip)]
    verdict: Verdict,
    /// Reason not to trust the laws.
    reason: Option<String>,
    /// File of the record.
    record: String,
    /// Number of samples.
    samples: usize,
    /// Number of full strokes with growing elongation.
    loading_strokes: usize,
    /// Number of full strokes with shrinking elongation.
    unloading_strokes: usize,
    /// Smallest tension of the record (N).
    tension_min_N: f64,
    /// Largest tension of the record (N).
    tension_max_N: f64,
    /// Smallest elongation of the record (m).
    elongation_min_m: f64,
    /// Largest elongation of the record (m).
    elongation_max_m: f64,
    /// Elongation at which the cable has no tension, extrapolated (m).
    zero_elongation_m: f64,
    /// Errors of the law with hysteresis.
    hysteresis_error: ErrorAnswer,
    /// Its errors while the elongation grows.
    loading_error: ErrorAnswer,
    /// Its errors while the elongation shrinks.
    unloading_error: ErrorAnswer,
    /// Errors of the polynomial from no tension.
    polynomial_error: Option<ErrorAnswer>,
    /// Errors of the polynomial that need not come from no tension.
    intercept_polynomial_error: Option<ErrorAnswer>,
    /// Errors of the straight line.
    linear_error: ErrorAnswer,
    /// Slope of the straight line (N/m).
    linear_stiffness_N_per_m: f64,
    /// Axial stiffness EA of the cable (N).
    axial_stiffness_EA_N: f64,
    /// Coefficients of the polynomial in the strain (N), from the first power on.
    tension_of_strain_N: Option<Vec<f64>>,
    /// Strain at the record's least elongation by the polynomial, and its tension there.
    preload_strain: Option<f64>,
    /// Tension at the preload (N).
    preload_N: Option<f64>,
    /// Of the polynomial that need not come from no tension: strains from the record's least elongation.
    intercept_N: Option<f64>,
    /// Its coefficients in the strain (N), from the first power on.
    intercept_coefficients_N: Option<Vec<f64>>,
    /// Smallest slope of the loading branch over the record (N/m).
    stiffness_min_N_per_m: f64,
    /// Largest slope of the loading branch over the record (N/m).
    stiffness_max_N_per_m: f64,
    /// Energy that a cycle over the whole record loses by the law (J).
    loss_per_cycle_J: f64,
    /// The same by the areas under the full strokes of the record (J).
    recorded_loss_per_cycle_J: f64,
    /// Table of the branches, as robot files have it.
    hysteresis: HysteresisTable,
    out: Option<String>,
    /// Doubts about the laws.
    #[serde(flatten, with = "WarningKeys")]
    #[schemars(with = "WarningKeys")]
    warnings: Warnings,
    #[serde(skip)]
    keys: String,
}

impl TestBenchAnswer {
    /// Laws from a record of a name with so many samples; their keys, and the name of the file that these were written to.
    pub fn new(solution: Solution, record: String, samples: usize, keys: String, out: Option<String>) -> Self {
        let warnings = Warnings { doubts: solution.doubts(), remarks: Vec::new() };
        let verdict = Verdict::of_fit(&warnings.doubts);
        let range = solution.tensions[1] - solution.tensions[0];
        let error = |misfit: Misfit| ErrorAnswer {
            rms: misfit.rms,
            max: misfit.max,
            rms_percent_of_range: 100.0 * misfit.rms / range,
        };
        Self {
            status: verdict.fit_status(),
            trusted: verdict.is_trusted(),
            verdict,
            reason: reason_of(verdict, &warnings.doubts),
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
            intercept_polynomial_error: solution.with_intercept.as_ref().map(|fit| error(fit.misfit)),
            linear_error: error(solution.linear.misfit),
            linear_stiffness_N_per_m: solution.linear.stiffness,
            axial_stiffness_EA_N: solution.linear.axial_stiffness,
            preload_strain: solution.polynomial.as_ref().map(|fit| fit.preload_strain),
            preload_N: solution.polynomial.as_ref().map(|fit| fit.preload),
            tension_of_strain_N: solution.polynomial.map(|fit| fit.coefficients),
            intercept_N: solution.with_intercept.as_ref().map(|fit| fit.intercept),
            intercept_coefficients_N: solution.with_intercept.map(|fit| fit.coefficients),
            stiffness_min_N_per_m: solution.stiffness[0],
            stiffness_max_N_per_m: solution.stiffness[1],
            loss_per_cycle_J: solution.loss,
            recorded_loss_per_cycle_J: solution.measured_loss,
            hysteresis: solution.table,
            out,
            warnings,
            keys,
        }
    }
}

/// A record that begins below this share of its largest tension has the way from no tension.
const PRELOADED: f64 = 0.01;

/// Ratio of a polynomial's error to that of the one with an intercept from which on an answer warns of it.
const POOR: f64 = 1.1;

/// Remarks on a record that begins under tension, and on polynomials that are no law.
pub fn preload_remarks(solution: &Solution) -> Vec<String> {
    let free = solution.with_intercept.as_ref().map(|fit| fit.misfit.rms);
    let Some(fit) = &solution.polynomial else {
        let best = free.map_or_else(String::new, |rms| format!(" (with an intercept one errs by {rms:.1} N rms)"));
        return vec![format!(
            "no polynomial of degree 1 to 4 rises from no tension to the largest{best}, so tension_of_strain_N is not written: \
             record from no tension on, or use the hysteresis"
        )];
    };
    let mut remarks = Vec::new();
    if fit.preload > PRELOADED * solution.tensions[1] {
        remarks.push(format!(
            "the record begins under tension: {:.1} N by the polynomial, a preload strain of {:.4e}; the way there from no tension, \
             where tension_of_strain_N begins, is extrapolated: record from no tension on if the cable is used below",
            fit.preload, fit.preload_strain
        ));
    }
    remarks.extend(free.filter(|rms| fit.misfit.rms > POOR * rms).map(|rms| {
        format!(
            "the best polynomial that rises from no tension errs by {:.1} N rms, one with an intercept by {rms:.1} N: the record's \
             preload has no polynomial way there; record from no tension on",
            fit.misfit.rms
        )
    }));
    remarks
}

/// The keys of the robot file.
#[derive(Serialize)]
#[expect(non_snake_case, reason = "the fields are the file's keys, units included")]
struct Keys<'a> {
    axial_stiffness_EA_N: f64,
    tension_of_strain_N: Option<&'a [f64]>,
}

/// Keys for a table `[[cable]]` of a robot file, from a record of a name (TOML).
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
    fn is_negative(&self) -> bool {
        self.verdict.is_negative()
    }

    fn may_be_accepted(&self) -> bool {
        self.verdict.may_be_accepted()
    }

    fn words(&self, width: Option<usize>) -> String {
        let mut table = Table::new(["law", "effect", "rms N", "max N", "rms % of range"]).left_column(1);
        let mut row = |law: &str, effect: &str, error: &ErrorAnswer| {
            let numbers =
                [cell(Some(error.rms), 1), cell(Some(error.max), 1), cell(Some(error.rms_percent_of_range), 2)];
            table.row([vec![law.to_owned(), effect.to_owned()], numbers.to_vec()].concat());
        };
        row("straight line", "elastic", &self.linear_error);
        self.polynomial_error.iter().for_each(|error| row("polynomial", "polynomial", error));
        self.intercept_polynomial_error.iter().for_each(|error| row("polynomial with intercept", "", error));
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
        let doubts = doubt_words(&self.warnings.doubts);
        format!("{heading}\n{doubts}\n{}\n{stiffness}\n{loss}\n\n{end}", table.text(width))
    }
}
