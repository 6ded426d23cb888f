//! Drawings of a report that no choice of the reader changes.

use minijinja::{Value, context};

use super::{Report, Shown};
use crate::figures::{Figure, Ladder, convergence, correlations, spectrum};

/// Each drawing as an element; null if there is nothing to draw.
pub(super) fn all(report: &Report<'_>, shown: &Shown<'_>) -> Value {
    let fit = &shown.judgement.fit;
    let names: Vec<String> = fit.parameters.iter().map(|estimate| estimate.parameter.name(report.robot)).collect();
    let is_free = !fit.parameters.is_empty();
    let element = |figure: Option<Figure>| figure.map(|figure| Value::from_safe_string(figure.inline()));
    context! {
        ladder => element(ladder(report).and_then(|ladder| ladder.svg())),
        narrow_ladder => element(ladder(report).and_then(|ladder| ladder.narrow_svg())),
        spectrum => element(is_free.then(|| spectrum(&fit.analysis.singular_values, fit.analysis.rank)).flatten()),
        correlation => element(correlations(&names, &fit.analysis.correlation_rows)),
        convergence => element(convergence(&fit.history)),
    }
}

/// The candidates, where there are several.
fn ladder(report: &Report<'_>) -> Option<Ladder> {
    let selection = report.selection;
    if selection.candidates.len() < 2 {
        return None;
    }
    let all: Vec<_> = selection
        .candidates
        .iter()
        .map(|candidate| {
            let judged = candidate.outcome.as_ref().ok();
            (candidate.name.as_str(), judged.map(|judged| judged.criterion), judged.map(|judged| judged.standard_error))
        })
        .collect();
    Some(Ladder::of(report.criterion, report.data_words(), &all, [selection.best, selection.recommended]))
}
