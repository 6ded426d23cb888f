//! Work in parts that may be computed elsewhere: each is a function of its number alone.

use cdpr_model::scalar::map_all;

/// Computes the parts 0 to count - 1 of some work, or takes them from where they were computed; the results stand in this order.
///
/// ```
/// use cdpr_study::parts::{Parts, here};
///
/// let squares = |parts: &Parts<'_, usize>| -> usize { parts(4, &|part| part * part).iter().sum() };
/// assert_eq!(squares(&here), 14);
/// // rows that another machine computed
/// assert_eq!(squares(&|count, _| (0..count).map(|part| part * part).collect()), 14);
/// ```
pub type Parts<'a, T> = dyn Fn(usize, &(dyn Fn(usize) -> T + Sync)) -> Vec<T> + 'a;

/// All parts in this process, on its threads.
pub fn here<T: Send>(count: usize, part: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    map_all(count, part)
}

/// Numbers in files that may be NaN, which JSON has no word for: they are null there.
pub(crate) mod nullable {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(crate) fn serialize<S: Serializer>(number: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        Some(number).filter(|number| number.is_finite()).serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
        Ok(Option::deserialize(deserializer)?.unwrap_or(f64::NAN))
    }
}
