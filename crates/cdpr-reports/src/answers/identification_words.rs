//! An identification in tables and sentences.

use cdpr_calibration::fit::{Estimate, Fit};
use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{Analysis, ClockOffset, Doubt, ErrorBlocks, Outlier, Verdict};
use cdpr_model::finding::Severity;
use cdpr_study::Identification;

use super::error_table::{Source, error_table};
use super::frame_words::{frame_words, shift_words};
use super::identification_answer::IdentificationAnswer as Identified;
use super::reduction_answer::ReductionAnswer;
use super::start_words::start_words;
use crate::number_format::{cell, decimals_for};
use crate::table::Table;

/// All words of an identification.
pub(super) fn all_words(answer: &Identified, width: Option<usize>) -> String {
    let Identified { robot, model, told, found, .. } = answer;
    let (fit, data, samples) = (&found.fit, &told.data, found.sample_count);
    let (parameter_count, iterations, reason) = (fit.parameters.len(), fit.iterations, &fit.reason);
    let status = verdict_words(answer.verdict);
    let mut text = format!("{robot}, model {model}: {parameter_count} parameters from {samples} samples of {data}\n");
    // what must be known before the outcome
    let Warnings { doubts, remarks } = &told.warnings;
    text.push_str(&doubt_words(doubts));
    text.push_str(&format!("{status} after {iterations} iterations: {reason}\n"));
    if answer.verdict != Verdict::NotConverged && !fit.parameters.is_empty() {
        text.push_str(&format!("ended by {}\n", fit.stopped_by));
    }
    if !fit.parameters.is_empty() {
        text.push_str(&format!(
            "\n{}\n{}",
            parameters(&fit.parameters, width),
            identifiability(&fit.analysis, parameter_count, fit.noise_factor)
        ));
    }
    let clocks = clock_words(fit);
    if !clocks.is_empty() {
        text.push_str(&format!("\n{clocks}"));
    }
    if let Some(frames) = &fit.frames {
        text.push_str(&format!("\n{}", frame_words(frames)));
    }
    if !fit.shifts.is_empty() {
        text.push_str(&format!("\n{}", shift_words(&fit.shifts)));
    }
    text.extend(answer.course.iter().map(|course| course.words(width)));
    text.push_str(&answer.uncertainty.words(width));
    text.push_str(&format!("\n{}", errors(answer, width)));
    text.push_str(&answer.objective.words(found, answer.pattern, width));
    text.extend(answer.path.iter().map(|path| path.words(width)));
    text.extend(answer.reduction.iter().map(ReductionAnswer::words));
    text.extend(answer.scaling.iter().map(|scaling| scaling.words(width)));
    if !fit.outliers.is_empty() {
        text.push_str(&format!("\n{}", outliers(&fit.outliers, width)));
    }
    if !remarks.is_empty() {
        text.push_str("\nwarnings\n");
        remarks.iter().for_each(|warning| text.push_str(&format!("  {warning}\n")));
    }
    text.push_str(&start_words(&fit.starts, width));
    if let Some(path) = &told.out {
        text.push_str(&format!("\ncalibrated robot written to {path}\n"));
    }
    text
}

/// How far a fit may be relied on.
pub(super) fn verdict_words(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Sound => "converged",
        Verdict::WithCaution => "converged, to be used with caution,",
        Verdict::NotIdentifiable => "not identifiable",
        Verdict::NotTrusted => "not to be trusted",
        Verdict::NotPredictive => "no forward problem",
        Verdict::NotConverged => "not converged",
    }
}

/// Reason of an answer that is a no: the first doubt that makes it one.
pub(super) fn reason_of(verdict: Verdict, doubts: &[Doubt]) -> Option<String> {
    let decides = |doubt: &&Doubt| verdict.is_negative() && doubt.kind.verdict() == verdict;
    doubts.iter().find(decides).map(|doubt| doubt.words().to_owned())
}

/// Doubts about an answer, which stand before it.
pub(super) fn doubt_words(doubts: &[Doubt]) -> String {
    let line = |doubt: &Doubt| {
        let word = if doubt.finding.severity == Severity::Remark { "note" } else { "caution" };
        format!("{word}: {}\n", doubt.words())
    };
    doubts.iter().map(line).collect()
}

/// A row for every parameter.
pub(super) fn parameters(estimates: &[Estimate], width: Option<usize>) -> String {
    let mut table =
        Table::new(["parameter", "unit", "start", "value", "± sigma", "change", ""]).left_column(1).left_column(6);
    for estimate in estimates {
        // compliances per newton have more zeros than anybody wants to count
        let (unit, factor, decimals) = match estimate.unit {
            "1/N" => ("1/GN", 1e9, 2),
            unit @ ("N" | "N·m") => (unit, 1.0, 1),
            unit => (unit, 1.0, 6),
        };
        // no finer than the deviation allows, where one is known
        let sigma = estimate.sigma.map(|sigma| factor * sigma).filter(|sigma| *sigma > 0.0);
        let decimals = sigma.map_or(decimals, |sigma| decimals_for(Some(sigma)) as usize);
        table.row(vec![
            estimate.name.clone(),
            unit.to_owned(),
            cell(Some(factor * estimate.start), decimals),
            cell(Some(factor * estimate.value), decimals),
            cell(estimate.sigma.map(|sigma| factor * sigma), decimals),
            cell(Some(factor * estimate.change), decimals),
            if estimate.at_bound { "at its bound".to_owned() } else { String::new() },
        ]);
    }
    table.text(width)
}

/// Outliers that a table shows before it refers to the others.
const MOST_OUTLIERS: usize = 20;

fn outliers(outliers: &[Outlier], width: Option<usize>) -> String {
    let mut table = Table::new(["outlier", "line", "residual mm", "weight", ""]).left_column(4);
    for outlier in outliers.iter().take(MOST_OUTLIERS) {
        table.row(vec![
            format!("sample {}", outlier.sample),
            outlier.line.map_or_else(String::new, |line| line.to_string()),
            cell(Some(1e3 * outlier.residual_m), 1),
            cell(Some(outlier.weight), 3),
            outlier.reason.clone(),
        ]);
    }
    let more = match outliers.len().saturating_sub(MOST_OUTLIERS) {
        0 => String::new(),
        more => format!("and {more} more (see --format json)\n"),
    };
    table.text(width) + &more
}

/// Half width of a 95 % interval, in standard deviations, from which on text and page print it: that of twenty degrees of freedom.
const WIDE: f64 = 2.085;

/// Rank, condition, weak directions.
pub(super) fn identifiability(analysis: &Analysis, parameter_count: usize, noise_factor: f64) -> String {
    let mut text = format!(
        "rank {} of {parameter_count}, condition {}, with unit columns {}, noise factor {}\n",
        analysis.rank,
        condition_number(analysis.condition),
        condition_number(analysis.condition_scaled),
        cell(Some(noise_factor), 3)
    );
    if analysis.quantile_95 > WIDE {
        let quantile = cell(Some(analysis.quantile_95), 2);
        text.push_str(&format!(
            "intervals of 95 % are value ± {quantile} sigma: few residuals tell the noise, so that it may be larger than it looks\n"
        ));
    }
    for direction in &analysis.weak_directions {
        text.push_str(&format!("weak direction: {direction}\n"));
    }
    let correlations = analysis.correlations.len();
    if correlations > 0 {
        let pairs = if correlations == 1 { "pair" } else { "pairs" };
        text.push_str(&format!(
            "{correlations} {pairs} of parameters with a correlation above 0.95 (see --format json)\n"
        ));
    }
    text
}

fn condition_number(number: f64) -> String {
    match number {
        infinite if !infinite.is_finite() => "∞".to_owned(),
        large if large >= 1e5 => format!("{large:.2e}"),
        number => format!("{number:.1}"),
    }
}

/// Offset of the clocks in a line; empty where it was not free.
pub(super) fn clock_words(fit: &Fit) -> String {
    let Some(ClockOffset { seconds: offset, sigma, .. }) = fit.clock_offset else { return String::new() };
    let side = if offset > 0.0 { "late" } else { "early" };
    format!("clocks: poses are recorded {:.2} ± {:.2} ms {side}\n", 1e3 * offset.abs(), 1e3 * sigma)
}

/// Errors before and after, of the fit and of what it did not see.
pub(super) fn error_columns(found: &Identification) -> Vec<(&'static str, &ErrorBlocks)> {
    let mut columns = vec![("train before", &found.train_before), ("train after", &found.train)];
    if let (Some(before), Some(after)) = (&found.validation_before, &found.validation) {
        columns.extend([("validation before", before), ("validation after", after)]);
    }
    columns
}

fn errors(answer: &Identified, width: Option<usize>) -> String {
    let columns = error_columns(&answer.found);
    let note = answer.told.validation_data.iter().map(|name| format!("validation: {name}, not fitted to\n"));
    error_table(answer.pattern, &columns, Source::Measurements, width) + &note.collect::<String>()
}
