//! The folder of a plan: what was planned, and a file for each row.

use std::path::{Path, PathBuf};

use cdpr_model::reading::Size;
use serde::{Deserialize, Serialize};
use serde_json::value::RawValue;
use sha2::{Digest, Sha256};

use super::command_plan::CommandPlan;
use super::sweep_plan::SweepPlan;
use crate::failure::Failure;
use crate::files;

const HELP: &str = "plan it again into another folder";

/// Work that is planned.
#[derive(Serialize)]
#[serde(untagged)]
pub(super) enum Planned {
    /// A sweep.
    Sweep(Box<SweepPlan>),
    /// A command whose work has parts.
    Command(CommandPlan),
}

impl Planned {
    /// The plan of the bytes of a `plan.json`, named for messages.
    pub(super) fn of_bytes(bytes: &[u8], name: &str) -> Result<Self, Failure> {
        #[derive(Deserialize)]
        struct Kind {
            command: Option<Vec<String>>,
        }
        let unreadable = |error| Failure::input("sweep::plan", format!("{name}: this is no plan: {error}"), HELP);
        let kind: Kind = serde_json::from_slice(bytes).map_err(unreadable)?;
        let plan = match kind.command {
            Some(_) => Self::Command(serde_json::from_slice(bytes).map_err(unreadable)?),
            None => Self::Sweep(Box::new(serde_json::from_slice(bytes).map_err(unreadable)?)),
        };
        let is_whole = match &plan {
            Self::Sweep(sweep) => sweep.is_whole(),
            Self::Command(command) => command.is_whole(),
        };
        if !is_whole {
            let message = format!("{name}: the plan was changed by hand or by another program");
            return Err(Failure::input("sweep::plan-changed", message, HELP));
        }
        Ok(plan)
    }

    /// The plan in a folder.
    pub(super) fn read(folder: &Path) -> Result<Self, Failure> {
        let path = folder.join("plan.json");
        let bytes = files::read_if_there(&path, Size::Table)?.ok_or_else(|| {
            let help = "write one: cdpr sweep plan SWEEP.toml --out DIR";
            Failure::input("sweep::plan", format!("{}: there is no plan", path.display()), help)
        })?;
        Self::of_bytes(&bytes, &path.display().to_string())
    }

    /// Writes the plan, unless the folder has another one with rows.
    pub(super) fn write(&self, folder: &Path) -> Result<(), Failure> {
        let path = folder.join("plan.json");
        let has_rows = !RowFile::all(folder)?.is_empty();
        if has_rows
            && files::read_if_there(&path, Size::Table)?.is_some()
            && Self::read(folder)?.fingerprint() != self.fingerprint()
        {
            let message = format!("{} holds rows of another plan", folder.display());
            return Err(Failure::input("sweep::plan-changed", message, "give another folder, or remove this one"));
        }
        files::make_folder(folder)?;
        let text = serde_json::to_vec_pretty(self).map_err(|error| Failure::unwritable("the plan", &error))?;
        files::write(&path, &text)
    }

    /// SHA-256 of the plan, by which rows know it.
    pub(super) fn fingerprint(&self) -> &str {
        match self {
            Self::Sweep(sweep) => &sweep.fingerprint,
            Self::Command(command) => &command.fingerprint,
        }
    }

    /// Number of points, or of parts.
    pub(super) fn count(&self) -> usize {
        match self {
            Self::Sweep(sweep) => sweep.points.len(),
            Self::Command(command) => command.parts,
        }
    }

    /// Name of a point's row in the folder `rows`: rows are addressed by what they are, point and plan.
    pub(super) fn row_name(&self, point: usize) -> String {
        let address = Sha256::digest(format!("{} {point}", self.fingerprint()));
        let short: String = address.iter().take(8).map(|byte| format!("{byte:02x}")).collect();
        format!("{point:05}-{short}.json")
    }

    /// Names of all rows, point by point.
    pub(super) fn row_names(&self) -> Vec<String> {
        (0..self.count()).map(|point| self.row_name(point)).collect()
    }
}

/// A computed row in its file.
#[derive(Deserialize, Serialize)]
pub(super) struct RowFile {
    /// Fingerprint of the plan that the row belongs to.
    plan: String,
    row: Box<RawValue>,
}

/// The number of a row.
#[derive(Deserialize)]
struct Numbered {
    point: usize,
}

impl RowFile {
    fn path(folder: &Path, plan: &Planned, point: usize) -> PathBuf {
        folder.join("rows").join(plan.row_name(point))
    }

    /// Content of a row's file.
    pub(super) fn bytes(plan: &Planned, row: &impl Serialize) -> Result<Vec<u8>, Failure> {
        let unwritable = |error| Failure::unwritable("the row", &error);
        let row = serde_json::value::to_raw_value(row).map_err(unwritable)?;
        serde_json::to_vec(&Self { plan: plan.fingerprint().to_owned(), row }).map_err(unwritable)
    }

    /// The row of a point, as JSON; `None` if it was not computed.
    pub(super) fn read(folder: &Path, plan: &Planned, point: usize) -> Result<Option<Box<RawValue>>, Failure> {
        let path = Self::path(folder, plan, point);
        let Some(bytes) = files::read_if_there(&path, Size::Table)? else { return Ok(None) };
        let stored: Option<Self> = serde_json::from_slice(&bytes).ok();
        let is_right = |stored: &Self| {
            let own: Option<Numbered> = serde_json::from_str(stored.row.get()).ok();
            stored.plan == plan.fingerprint() && own.is_some_and(|own| own.point == point)
        };
        match stored.filter(is_right) {
            Some(stored) => Ok(Some(stored.row)),
            None => {
                let message = format!("{}: this is no row of the plan", path.display());
                Err(Failure::input("sweep::plan-changed", message, "remove the file and run the shard again"))
            }
        }
    }

    /// Writes the content of a row's file of this name.
    pub(super) fn write(folder: &Path, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        let rows = folder.join("rows");
        files::make_folder(&rows)?;
        files::write(&rows.join(name), bytes)
    }

    /// Number of rows in the folder that belong to no point of the plan.
    pub(super) fn strangers(folder: &Path, plan: &Planned) -> Result<usize, Failure> {
        let own: std::collections::BTreeSet<PathBuf> =
            (0..plan.count()).map(|point| Self::path(folder, plan, point)).collect();
        Ok(Self::all(folder)?.iter().filter(|path| !own.contains(*path)).count())
    }

    /// Returns the paths of all rows in the folder, those of other plans too.
    fn all(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
        let is_row = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "json");
        Ok(files::listed(&folder.join("rows"))?.into_iter().filter(is_row).collect())
    }
}
