//! Candidates rated by several criteria side by side.

use cdpr_calibration::selection::{Preference, Rating, SelectionCriterion};
use schemars::JsonSchema;
use serde::Serialize;

use crate::keys::{Each, PreferenceKeys};
use crate::number_format::{NONE, significant};

/// Choices of all criteria, and whether they agree.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Rating")]
pub struct RatingAnswer<'a> {
    /// Whether all criteria choose the same candidate.
    pub agrees: bool,
    /// Agreement or disagreement in words.
    pub words: &'a str,
    /// Every criterion with its choice.
    #[serde(with = "Each::<PreferenceKeys>")]
    pub criteria: &'a [Preference],
}

impl<'a> RatingAnswer<'a> {
    pub(super) fn new(rating: &'a Rating) -> Self {
        Self { agrees: rating.agrees, words: &rating.words, criteria: &rating.criteria }
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
