//! Candidates by several criteria side by side.

use cdpr_calibration::selection::SelectionCriterion;
use minijinja::{Value, context};

use super::table::{Cell, Table};
use super::{Purpose, ReportPage, criterion};
use crate::answers::{SelectionAnswer, above_least, has_others, largest};
use crate::html_page::prose;
use crate::number_format::{self as number, NONE};

/// Agreement in words and the table; `None` if no candidates are compared.
pub(super) fn rating(page: &ReportPage<'_>) -> Option<Value> {
    let rating = &page.answer.rating;
    if page.report.purpose != Purpose::Selection || rating.words.is_empty() {
        return None;
    }
    let words = prose(&format!("{}.", capital(rating.words)));
    Some(context! { words, table => has_others(rating.criteria).then(|| table(page)) })
}

fn capital(words: &str) -> String {
    let mut letters = words.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn table(page: &ReportPage<'_>) -> Value {
    let SelectionAnswer { candidates, rating, places, criterion: kind, .. } = &page.answer;
    let (criteria, kind) = (rating.criteria, *kind);
    let turns = largest(criteria, SelectionCriterion::Rotation, 0).is_some();
    let regions = candidates.iter().any(|one| one.judged.is_some_and(|own| own.regions.is_some()));
    let (of_regions, error) =
        (format!("#regions left out, {}", kind.unit()), format!("#± standard error, {}", kind.unit()));
    let mut columns = vec![
        ("#", ""),
        ("candidate", "def-candidate"),
        ("#ΔAIC", "def-information"),
        ("#ΔBIC", "def-information"),
        ("#independent rows", "def-information"),
        ("#relative error, %", "def-relative"),
        ("#largest, mm", "def-max"),
    ];
    columns.extend(turns.then_some(("#largest, °", "def-max")));
    columns.extend(
        regions.then_some([(of_regions.as_str(), "def-regions"), (&error, "def-standard-error")]).into_iter().flatten(),
    );
    let mut table = Table::new("Candidates by other criteria than the one that decides", &columns);
    for (index, candidate) in candidates.iter().enumerate() {
        let Some(own) = candidate.judged else { continue };
        let figure = |value: Option<f64>| value.map_or_else(|| NONE.to_owned(), |value| number::significant(value, 3));
        let mut cells = vec![
            above_least(criteria, "aic", index),
            above_least(criteria, "bic", index),
            figure(own.information.map(|one| one.effective_rows)),
            figure(own.relative_position_error.map(|share| 1e2 * share)),
            largest(criteria, SelectionCriterion::Position, index).unwrap_or_else(|| NONE.to_owned()),
        ];
        cells.extend(largest(criteria, SelectionCriterion::Rotation, index).filter(|_| turns));
        if regions {
            let (value, error) = own.regions.map_or_else(
                || (NONE.to_owned(), NONE.to_owned()),
                |held| criterion::value_and_error(kind, held.criterion, held.standard_error),
            );
            cells.extend([value, error]);
        }
        let class = if places.recommended == Some(index) { "chosen" } else { "" };
        let first = [Cell::number((index + 1).to_string()), Cell::code(candidate.name)];
        table.push(class, first.into_iter().chain(cells.into_iter().map(Cell::number)).collect());
    }
    table.into_value()
}
