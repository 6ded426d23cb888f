//! Numbers of laws of stretch that are plain keys of a cable: read, written, named and identified by the entry of their
//! law.

use std::collections::BTreeMap;

use super::StretchError;

/// A number of a law of stretch, above zero: a key of `[[cable]]`, and a parameter of every cable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LawNumber {
    /// Name of the parameter, e.g. in lists of free ones.
    pub name: &'static str,
    /// Key in the robot file.
    pub key: &'static str,
    /// Unit, empty for a ratio.
    pub unit: &'static str,
    /// Description in the schema.
    pub about: &'static str,
}

/// Values of the numbers of a law in the order of its entry; `None` if a cable states none, an error if it states only
/// some.
pub(super) fn all_stated<const N: usize>(
    numbers: &[LawNumber; N],
    stated: &BTreeMap<&'static str, f64>,
) -> Result<Option<[f64; N]>, StretchError> {
    let values = numbers.map(|number| stated.get(number.key).copied());
    let Some(present) = values.iter().position(Option::is_some) else { return Ok(None) };
    match values.iter().position(Option::is_none) {
        Some(missing) => Err(StretchError::Incomplete { key: numbers[present].key, missing: numbers[missing].key }),
        None => Ok(Some(values.map(Option::unwrap_or_default))),
    }
}
