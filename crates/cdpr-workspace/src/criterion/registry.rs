//! Every criterion under its name, with its constructor from a robot and numbers: one entry each.

use std::str::FromStr;

use thiserror::Error;

pub use super::entries::ENTRIES;
pub use super::entry::{CriterionRequest, Entry, Number, Setting};
use super::wrench_feasible::WRENCH_FEASIBLE;
use super::{All, Criterion};
use crate::WorkspaceError;
use cdpr_model::reading::did_you_mean;

/// Words that request no criterion.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum WantedError {
    /// No criterion has the name.
    #[error("there is no criterion `{name}`; {cure}")]
    Unknown {
        /// Name given.
        name: String,
        /// The likely intended name, or all names.
        cure: String,
    },
    /// Text that is no number, or a number that the criterion does not take.
    #[error("`{part}` is no number of the criterion `{name}`; {cure}")]
    Number {
        /// Part given.
        part: String,
        /// Name of the criterion.
        name: &'static str,
        /// The numbers that the criterion takes.
        cure: String,
    },
    /// A required number is missing.
    #[error("the criterion `{name}` needs the number `{number}` ({unit}), as in {name}:{number}=…")]
    Missing {
        /// Name of the criterion.
        name: &'static str,
        /// Name of the number.
        number: &'static str,
        /// Unit of the number.
        unit: &'static str,
    },
}

impl FromStr for CriterionRequest {
    type Err = WantedError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (name, rest) = text.split_once(':').unwrap_or((text, ""));
        let entry = ENTRIES.iter().find(|entry| entry.name == name).ok_or_else(|| unknown(name))?;
        let mut wanted = Self { name: entry.name, numbers: Vec::new() };
        for part in rest.split(',').filter(|part| !part.is_empty()) {
            let number = part.split_once('=').and_then(|(name, value)| {
                let known = entry.numbers.iter().find(|number| number.name == name.trim())?;
                let value: f64 = value.trim().parse().ok()?;
                value.is_finite().then_some((known.name, value))
            });
            wanted.numbers.push(number.ok_or_else(|| no_number(part, entry))?);
        }
        match entry.numbers.iter().find(|number| number.is_required && wanted.number(number.name).is_none()) {
            Some(Number { name: number, unit, .. }) => Err(WantedError::Missing { name: entry.name, number, unit }),
            None => Ok(wanted),
        }
    }
}

fn unknown(name: &str) -> WantedError {
    let names = || ENTRIES.iter().map(|entry| entry.name);
    let cure = match did_you_mean(name, names()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None => format!("there are {}", names().collect::<Vec<_>>().join(", ")),
    };
    WantedError::Unknown { name: name.to_owned(), cure }
}

fn no_number(part: &str, entry: &Entry) -> WantedError {
    let known = entry.numbers.iter().map(|number| format!("{}= ({})", number.name, number.unit));
    let known: Vec<String> = known.collect();
    let cure = if known.is_empty() { "it takes none".to_owned() } else { format!("it takes {}", known.join(", ")) };
    WantedError::Number { part: part.to_owned(), name: entry.name, cure }
}

impl CriterionRequest {
    /// Wrench feasibility (eq. 3.29).
    pub(crate) fn wrench_feasible() -> Self {
        Self { name: WRENCH_FEASIBLE, numbers: Vec::new() }
    }

    /// Name of the criterion.
    pub fn name(&self) -> &'static str {
        self.name
    }

    /// A given number; `None` if it was not given.
    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        self.numbers.iter().rev().find(|(known, _)| *known == name).map(|(_, value)| *value)
    }

    /// A number that [`Number::is_required`]; NaN, which every criterion refuses, if it is missing.
    pub(crate) fn required(&self, name: &str) -> f64 {
        self.number(name).unwrap_or(f64::NAN)
    }

    /// The criterion for a robot.
    pub(crate) fn make<'a>(&self, setting: &Setting<'a>) -> Result<Box<dyn Criterion + 'a>, WorkspaceError> {
        let entry = ENTRIES.iter().find(|entry| entry.name == self.name).ok_or(WorkspaceError::NoCriterion)?;
        (entry.make)(setting, self)
    }
}

/// The criterion that requires all of these.
pub fn all<'a>(wanted: &[CriterionRequest], setting: &Setting<'a>) -> Result<Box<dyn Criterion + 'a>, WorkspaceError> {
    let mut criteria = wanted.iter().map(|wanted| wanted.make(setting)).collect::<Result<Vec<_>, _>>()?;
    match criteria.len() {
        1 => criteria.pop().ok_or(WorkspaceError::NoCriterion),
        _ => Ok(Box::new(All::new(criteria)?)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_name_and_a_wrong_number_are_answered_by_what_there_is() {
        let words = |text: &str| text.parse::<CriterionRequest>().unwrap_err().to_string();
        assert!(words("wrench-feasable").contains("did you mean `wrench-feasible`"));
        assert!(words("wrench-closure:least=1").contains("takes none"));
        assert_eq!("wrench-closure".parse::<CriterionRequest>().unwrap().name(), "wrench-closure");
    }

    #[test]
    fn names_are_unique() {
        for (index, entry) in ENTRIES.iter().enumerate() {
            assert!(ENTRIES[..index].iter().all(|other| other.name != entry.name), "{}", entry.name);
        }
    }
}
