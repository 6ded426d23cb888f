//! A frequency response in sentences and a table.

use cdpr_calibration::frequency_response::{Banded, Model, Root};

use super::Answer;
use super::frequency_response_answer::FrequencyResponseAnswer;
use super::identification_words::doubt_words;
use crate::number_format::{cell, significant};
use crate::table::Table;

impl Answer for FrequencyResponseAnswer {
    fn is_negative(&self) -> bool {
        self.verdict.is_negative()
    }

    fn words(&self, width: Option<usize>) -> String {
        words(self, width)
    }
}

/// All words of a response, doubts first.
fn words(answer: &FrequencyResponseAnswer, width: Option<usize>) -> String {
    let mut text = format!("{}\n{}", answer.heading(), doubt_words(&answer.warnings().doubts));
    figures(answer).iter().for_each(|line| text.push_str(&format!("{line}\n")));
    if let Some(model) = &answer.solution.model {
        text.push_str(&format!("\n{}\n{}", model_words(model), roots(model, width)));
    }
    if !answer.warnings().remarks.is_empty() {
        text.push_str("\nwarnings\n");
        answer.warnings().remarks.iter().for_each(|remark| text.push_str(&format!("  {remark}\n")));
    }
    text
}

/// Band, cut-off and peak, a sentence each.
pub(super) fn figures(answer: &FrequencyResponseAnswer) -> Vec<String> {
    let solution = &answer.solution;
    let band = solution.band.map(|[first, last]| {
        format!(
            "band: {} to {} Hz, where the coherence is {} or more ({:.0} % of the excited frequencies on a logarithmic scale)",
            significant(first, 3),
            significant(last, 3),
            solution.coherence_limit,
            100.0 * solution.trusted_share
        )
    });
    let unit = gain_unit(&answer.input, &answer.output);
    let reference = solution.reference_gain.zip(solution.band).map(|(gain, [first, _])| {
        format!("reference: gain {} {unit} at {} Hz, the lowest trusted frequency", told(gain), significant(first, 3))
    });
    let cutoff = solution.cutoff.map(|cutoff| format!("cut-off: {} Hz, 3 dB below the reference", told(cutoff)));
    let peak = solution.peak.map(|peak| match peak.frequency {
        Some(frequency) => format!("peak: gain {} {unit} at {} Hz", told(peak.gain), told(frequency)),
        None => format!("largest gain: {} {unit}, at the edge of the band", told(peak.gain)),
    });
    [band, reference, cutoff, peak].into_iter().flatten().collect()
}

/// Unit of a gain between two columns.
pub(super) fn gain_unit(input: &str, output: &str) -> String {
    format!("{} per {}", unit_of(output), unit_of(input))
}

/// Unit at the end of a column's name; the name where there is none.
fn unit_of(column: &str) -> String {
    let unit = column.rsplit_once('_').map_or(column, |(_, unit)| unit);
    match unit {
        "Nm" => "N·m".to_owned(),
        "m" | "N" | "kN" | "mm" | "s" | "rad" | "A" | "V" => unit.to_owned(),
        _ => column.to_owned(),
    }
}

/// A number with its interval.
fn told(number: Banded) -> String {
    let [low, high] = number.band();
    format!("{} (95 %: {} to {})", significant(number.value, 4), significant(low, 4), significant(high, 4))
}

pub(super) fn model_words(model: &Model) -> String {
    let delay = match model.delay {
        Some(delay) => {
            format!("delay {} ± {} ms", significant(1e3 * delay.value, 3), significant(1e3 * delay.sigma, 2))
        }
        None => "no delay".to_owned(),
    };
    format!(
        "model: {}; gain {} ± {} at zero frequency, {delay}; residuals {} standard deviations",
        model.transfer.orders(),
        significant(model.gain.value, 4),
        significant(model.gain.sigma, 2),
        significant(model.misfit.sqrt(), 2)
    )
}

/// Cells of the poles and zeros, a row each.
pub(super) fn root_rows(model: &Model) -> Vec<Vec<String>> {
    let row = |kind: &str, root: &Root| {
        let numbers = [root.value.re, root.sigma[0], root.value.im, root.sigma[1], root.frequency()];
        let cells = numbers.map(|number| cell(Some(number), 2));
        [vec![kind.to_owned()], cells.to_vec(), vec![cell(Some(root.damping()), 3)]].concat()
    };
    let poles = model.poles.iter().map(|root| row("pole", root));
    poles.chain(model.zeros.iter().map(|root| row("zero", root))).collect()
}

/// Names of their columns.
pub(super) const ROOT_COLUMNS: [&str; 7] =
    ["root", "real rad/s", "± sigma", "imaginary rad/s", "± sigma", "Hz", "damping"];

fn roots(model: &Model, width: Option<usize>) -> String {
    let mut table = Table::new(ROOT_COLUMNS);
    let rows = root_rows(model);
    if rows.is_empty() {
        return String::new();
    }
    rows.into_iter().for_each(|row| table.row(row));
    table.text(width)
}
