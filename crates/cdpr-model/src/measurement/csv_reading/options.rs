//! Choices in reading a measurement file.

use std::collections::BTreeMap;

/// Choices in reading a measurement file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadingOptions {
    /// Names of the file's columns, by the names that measurements have (`x_m` → `X_world`).
    pub columns: BTreeMap<String, String>,
    /// Rows with gaps or text in place of numbers are left out and counted; otherwise they are mistakes.
    pub skip_invalid: bool,
}
