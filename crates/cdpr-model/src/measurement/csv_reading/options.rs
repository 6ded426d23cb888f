//! Options of reading a measurement file.

use std::collections::BTreeMap;

/// Options of reading a measurement file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadingOptions {
    /// Names of the file's columns, by the names of measurements (`x_m` → `X_world`).
    pub columns: BTreeMap<String, String>,
    /// True leaves rows with gaps or text instead of numbers out and counts them; false makes them errors.
    pub skip_invalid: bool,
}
