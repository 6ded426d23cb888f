//! Candidates rated by several criteria side by side.

use cdpr::identification::selection::{Preference, Rating, SelectionCriterion};
use serde::Serialize;

use super::SelectionAnswer;
use crate::number_format::{NONE, significant};
use crate::report::value_and_error;
use crate::table::Table;

/// Choices of all criteria, and whether they agree.
#[derive(Serialize)]
pub struct RatingAnswer {
    /// Whether all criteria choose the same candidate.
    pub agrees: bool,
    /// Agreement or disagreement in words.
    pub words: String,
    /// Every criterion with its choice.
    pub criteria: Vec<Preference>,
}

impl RatingAnswer {
    pub(super) fn new(rating: &Rating) -> Self {
        Self { agrees: rating.agrees, words: rating.words.clone(), criteria: rating.criteria.clone() }
    }
}

/// How far a candidate's value of this criterion lies above the least one; a dash where there is none.
pub(crate) fn above_least(criteria: &[Preference], name: &str, candidate: usize) -> String {
    let Some(values) = criteria.iter().find(|one| one.name == name).map(|one| &one.values) else {
        return NONE.to_owned();
    };
    let least = values.iter().copied().fold(f64::NAN, f64::min);
    match values[candidate] - least {
        above if above.is_nan() => NONE.to_owned(),
        above => significant(above, 3),
    }
}

/// Largest error of a kind, in its unit for people.
pub(crate) fn largest(criteria: &[Preference], kind: SelectionCriterion, candidate: usize) -> Option<String> {
    let name = if kind == SelectionCriterion::Rotation { "rotation-max" } else { "position-max" };
    let values = &criteria.iter().find(|one| one.name == name)?.values;
    Some(significant(kind.in_unit(values[candidate]), 3))
}

/// True where another criterion than the errors that decide has a value, as those of lengths alone have none.
pub(crate) fn has_others(criteria: &[Preference]) -> bool {
    let decides = |one: &&Preference| !["one-standard-error", "least-error"].contains(&one.name);
    criteria.iter().filter(decides).any(|one| one.values.iter().any(|value| value.is_finite()))
}

/// The candidates by all criteria, for people; nothing where none rates them.
pub(super) fn table(answer: &SelectionAnswer, width: Option<usize>) -> Option<String> {
    let criteria = &answer.rating.criteria;
    if !has_others(criteria) || answer.candidates.len() < 2 {
        return None;
    }
    let turns = largest(criteria, SelectionCriterion::Rotation, 0).is_some();
    let regions =
        answer.candidates.iter().any(|one| one.judged.as_ref().is_some_and(|own| own.leave_region_out.is_some()));
    let unit = answer.criterion.unit();
    let mut heading = vec!["candidate".to_owned(), "ΔAIC".to_owned(), "ΔBIC".to_owned(), "relative %".to_owned()];
    heading.push("largest mm".to_owned());
    heading.extend(turns.then(|| "largest °".to_owned()));
    heading.extend(regions.then(|| format!("regions {unit}")));
    heading.extend(regions.then(|| format!("± std. error {unit}")));
    let mut table = Table::with_heading(heading);
    for (index, candidate) in answer.candidates.iter().enumerate() {
        let Some(own) = &candidate.judged else { continue };
        let marker = if Some(&candidate.name) == answer.recommended.as_ref() { "→ " } else { "  " };
        let relative = own.relative_position_error.map_or_else(|| NONE.to_owned(), |share| significant(1e2 * share, 3));
        let mut cells = vec![format!("{marker}{}", candidate.name)];
        cells.extend([above_least(criteria, "aic", index), above_least(criteria, "bic", index), relative]);
        cells.push(largest(criteria, SelectionCriterion::Position, index).unwrap_or_else(|| NONE.to_owned()));
        cells.extend(largest(criteria, SelectionCriterion::Rotation, index).filter(|_| turns));
        if let Some(held) = own.leave_region_out {
            cells.extend(<[String; 2]>::from(value_and_error(answer.criterion, held.criterion, held.standard_error)));
        }
        table.row(cells);
    }
    Some(format!("rated by other criteria (ΔAIC, ΔBIC: above the least of the same rows)\n\n{}", table.text(width)))
}
