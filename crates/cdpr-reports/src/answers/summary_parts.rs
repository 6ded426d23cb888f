//! Parts that the summaries of comparisons and identifications share: doubts, largest changes, worst cable, range of the samples.

use cdpr_calibration::fit::Estimate;
use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{Coverage, PoseRange, Verdict, WorstCable};
use cdpr_model::finding::Severity;

use crate::number_format::{NONE, decimals_for, fixed, signed, significant};
use crate::paragraphs::{Paragraphs, Tone};
use crate::table::Table;

/// Parameters that a summary shows.
pub(super) const MOST_CHANGES: usize = 10;

/// Parameters that a fit changed most, as a table; empty where nothing changed.
pub(super) fn changes(largest: &[Estimate], all: usize, width: usize) -> String {
    if largest.is_empty() {
        return String::new();
    }
    let mut table = Table::new(["parameter", "unit", "value", "change", "± σ"]).left_column(1);
    for estimate in largest {
        let (factor, unit) = match estimate.unit {
            "m" => (1e3, "mm"),
            "rad" => (1.0_f64.to_degrees(), "°"),
            // compliances per newton have more zeros than anybody wants to count
            "1/N" => (1e9, "1/GN"),
            other => (1.0, other),
        };
        let sigma = estimate.sigma.map(|sigma| factor * sigma);
        let plain = if unit.is_empty() { 6 } else { 3 };
        let decimals = sigma.filter(|sigma| *sigma > 0.0).map_or(plain, |sigma| decimals_for(Some(sigma)));
        table.row(vec![
            format!("{}{}", estimate.name, if estimate.at_bound { " (at its bound)" } else { "" }),
            unit.to_owned(),
            fixed(factor * estimate.value, decimals),
            signed(factor * estimate.change, decimals),
            sigma.map_or_else(|| NONE.to_owned(), |sigma| significant(sigma, 2)),
        ]);
    }
    let heading = match largest.len() {
        count if count < all => format!("largest changes ({count} of {all} parameters)"),
        _ => "changes of the parameters".to_owned(),
    };
    format!("{heading}\n{}", table.text(Some(width)))
}

/// The tone of an outcome.
pub(super) fn tone(verdict: Verdict) -> Tone {
    match verdict {
        Verdict::Sound => Tone::Bold,
        Verdict::WithCaution => Tone::Caution,
        _ => Tone::Refusal,
    }
}

/// Adds the doubts about an answer, each with the tone of its weight.
pub(super) fn add_doubts(page: &mut Paragraphs, warnings: &Warnings) {
    for doubt in &warnings.doubts {
        let (tone, word) = match doubt.finding.severity {
            Severity::Remark => (Tone::Plain, "note"),
            Severity::Caution => (Tone::Caution, "caution"),
            Severity::Distrust => (Tone::Refusal, "caution"),
        };
        // the outcome above says it already
        let words = doubt.words();
        page.add(tone, &format!("{word}: {}", words.strip_prefix("not to be trusted: ").unwrap_or(words)));
    }
}

/// The cable whose lengths are worst, beside the others.
pub(super) fn worst_cable(worst: Option<WorstCable>) -> Option<String> {
    let WorstCable { cable, rms, others_rms } = worst?;
    let others = match others_rms.is_finite() {
        true => format!(", the others {} mm", significant(1e3 * others_rms, 3)),
        false => String::new(),
    };
    Some(format!("worst cable: {}, lengths to {} mm rms{others}\n", cable + 1, significant(1e3 * rms, 3)))
}

/// Ranges of the poses that the fit saw, and how many samples are judged beyond them.
pub(super) fn ranges(coverage: &Coverage) -> String {
    let part = |unit: &str, shown: &str, factor: f64, decimals: i32| {
        let own = coverage.ranges.iter().filter(|range| range.unit == unit && range.fit_min.is_finite());
        let words: Vec<String> = own
            .map(|PoseRange { name, fit_min, fit_max, .. }| {
                format!("{name} {} to {}", fixed(factor * fit_min, decimals), fixed(factor * fit_max, decimals))
            })
            .collect();
        (!words.is_empty()).then(|| format!("{} {shown}", words.join(", ")))
    };
    let parts = [part("m", "m", 1.0, 2), part("rad", "°", 1.0_f64.to_degrees(), 1)];
    let words: Vec<String> = parts.into_iter().flatten().collect();
    if words.is_empty() {
        return String::new();
    }
    let beyond = match (coverage.outside, coverage.validation) {
        (0, _) | (_, 0) => String::new(),
        (outside, all) => format!("; {outside} of {all} validation samples lie beyond those that their fit saw"),
    };
    format!("poses of the fit: {}{beyond}\n", words.join("; "))
}

/// Number of things with their noun.
pub(super) fn counted(count: usize, noun: &str) -> String {
    format!("{count} {noun}{}", if count == 1 { "" } else { "s" })
}
