//! Drawings of a report that no choice of the reader changes.

use cdpr_calibration::selection::Judgement;
use minijinja::{Value, context};

use super::{ReportPage, Shown};
use crate::answers::{CandidateAnswer, SelectionAnswer};
use crate::figures::{Figure, Ladder, NamedError, convergence, correlations, spectrum};

/// Each drawing as an element; null if there is nothing to draw.
pub(super) fn all(page: &ReportPage<'_>, shown: &Shown<'_>) -> Value {
    let fit = &shown.judgement.fit;
    let names: Vec<String> = fit.parameters.iter().map(|estimate| estimate.parameter.name(page.report.robot)).collect();
    let is_free = !fit.parameters.is_empty();
    let element = |figure: Option<Figure>| figure.map(|figure| Value::from_safe_string(figure.inline()));
    context! {
        ladder => element(ladder(page).and_then(|ladder| ladder.svg())),
        narrow_ladder => element(ladder(page).and_then(|ladder| ladder.narrow_svg())),
        spectrum => element(is_free.then(|| spectrum(&fit.analysis.singular_values, fit.analysis.rank)).flatten()),
        correlation => element(correlations(&names, &fit.analysis.correlation_rows)),
        convergence => element(convergence(&fit.history)),
    }
}

/// The candidates, where there are several.
fn ladder<'a>(page: &ReportPage<'a>) -> Option<Ladder> {
    let SelectionAnswer { candidates, criterion, places, .. } = &page.answer;
    if candidates.len() < 2 {
        return None;
    }
    let named = |own: &CandidateAnswer<'a>| NamedError {
        name: own.name,
        compared: own.judged.and_then(Judgement::compared_error),
    };
    let all: Vec<_> = candidates.iter().map(named).collect();
    Some(Ladder::of(*criterion, page.report.data_words(), &all, places.recommended))
}
