//! `--compensation FILE` of commands that use a map.

use std::path::{Path, PathBuf};

use cdpr_model::compensation::{Compensation, MapError};
use cdpr_model::model::Model;
use cdpr_model::reading::Size;
use clap::Args;

use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::files;

/// A map of `cdpr compensate`.
#[derive(Clone, Debug, Args)]
pub(crate) struct CompensationOption {
    /// Map of `cdpr compensate`, made for this robot and model, that corrects its lengths.
    #[arg(long, value_name = "FILE")]
    compensation: Option<PathBuf>,
}

impl CompensationOption {
    pub(crate) fn is_asked(&self) -> bool {
        self.compensation.is_some()
    }

    /// The map that is asked for.
    pub(crate) fn read(&self, model: &Model) -> Result<Option<(Compensation, String)>, Failure> {
        self.compensation.as_deref().map(|path| read(path, model)).transpose()
    }
}

/// A map with the name of its file; refuses that of another model.
pub(crate) fn read(path: &Path, model: &Model) -> Result<(Compensation, String), Failure> {
    let name = path.display().to_string();
    let bytes = files::read(path, Size::Table)?;
    let map = Compensation::from_toml_bytes(&bytes, &name, model);
    let map = map.map_err(|error| match error {
        MapError::Read(error) => FileKind::Map.refusal(&bytes, *error),
        error => Failure::refused(&name, &error),
    })?;
    Ok((map, name))
}
