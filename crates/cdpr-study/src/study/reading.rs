//! Reading of a study from its file.

use super::{Study, checks};
use cdpr_model::reading::{ReadError, Size, TomlDocument, text_from_bytes};

impl Study {
    /// Reads a study file.
    pub fn from_toml_bytes(bytes: &[u8], file_name: &str) -> Result<Self, ReadError> {
        let document = TomlDocument::parse(text_from_bytes(bytes, Size::Text, file_name)?, file_name)?;
        let study: Self = document.deserialize()?;
        checks::check(&study, &document)?;
        Ok(study)
    }
}
