//! Reading of a scenario from its file.

use super::{Scenario, checks};
use crate::error::PlantError;
use cdpr_model::reading::{ReadError, Size, Step, TomlDocument, text_from_bytes};

impl Scenario {
    /// Reads a scenario file; `file_name` is only used in errors.
    pub fn from_toml_bytes(bytes: &[u8], file_name: &str) -> Result<Self, ReadError> {
        let document = TomlDocument::parse(text_from_bytes(bytes, Size::Text, file_name)?, file_name)?;
        let scenario: Self = document.deserialize()?;
        checks::check(&scenario, &document)?;
        Ok(scenario)
    }
}

/// The error with its position in the file that the scenario was read from; `None` if it has none there.
pub fn located(error: &PlantError, code: &'static str, bytes: &[u8], file_name: &str) -> Option<ReadError> {
    let key = error.key()?;
    let document = TomlDocument::parse(text_from_bytes(bytes, Size::Text, file_name).ok()?, file_name).ok()?;
    let mut path: Vec<Step<'_>> = key.table.split('.').map(Step::Key).collect();
    path.extend(key.index.map(Step::Index));
    if !key.key.is_empty() {
        path.push(Step::Key(key.key));
    }
    Some(document.error_at(&path, code, error.to_string()))
}
