//! Tables of a result's folder that figures are drawn from and no other file holds.

use std::fmt::Write;

use super::Comparison;
use super::files::{judged, shown};

/// Singular values of every candidate's Jacobian, from large to small (SI units).
pub(super) fn singular_values(comparison: &Comparison) -> String {
    let mut text = String::from("candidate,number,singular_value\n");
    for (candidate, judgement) in judged(comparison) {
        for (index, value) in judgement.fit.analysis.singular_values.iter().enumerate() {
            let _ = writeln!(text, "{},{},{value}", quoted(&candidate.name), index + 1);
        }
    }
    text
}

/// The weighted sum of squares of every candidate after each step of its fit.
pub(super) fn convergence(comparison: &Comparison) -> String {
    let mut text = String::from("candidate,step,weighted_sum_of_squares\n");
    for (candidate, judgement) in judged(comparison) {
        for (step, cost) in judgement.fit.history.iter().enumerate() {
            let _ = writeln!(text, "{},{step},{cost}", quoted(&candidate.name));
        }
    }
    text
}

/// Correlation coefficients of the recommended (else the best) candidate's parameters: the whole matrix, empty where one
/// of the two is not determined.
pub(super) fn correlations(comparison: &Comparison) -> String {
    let Some(judgement) = shown(comparison) else { return "parameter\n".to_owned() };
    let fit = &judgement.fit;
    let rows = &fit.analysis.correlation_rows;
    let names: Vec<String> = fit.parameters.iter().map(|estimate| quoted(&estimate.name)).collect();
    let mut text = ["parameter".to_owned()].into_iter().chain(names.clone()).collect::<Vec<_>>().join(",") + "\n";
    for (i, name) in names.iter().enumerate() {
        let entry = |j: usize| rows.get(i.max(j)).and_then(|row| row.get(i.min(j))).filter(|value| value.is_finite());
        let entries = (0..names.len()).map(|j| entry(j).map(f64::to_string).unwrap_or_default());
        let _ = writeln!(text, "{name},{}", entries.collect::<Vec<_>>().join(","));
    }
    text
}

/// A field of text.
fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "\"\""))
}
