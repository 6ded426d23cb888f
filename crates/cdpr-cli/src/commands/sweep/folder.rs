//! The folder of a sweep: its plan, and a file for each point.

use std::path::{Path, PathBuf};

use cdpr_model::reading::Size;
use cdpr_model::robot::Robot;
use cdpr_study::Study;
use cdpr_study::sweep::{Row, Subjects, Sweep};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use cdpr_reports::answers::PROGRAM;

/// Everything that decides the result of a sweep.
#[derive(Deserialize, Serialize)]
pub(super) struct Plan {
    /// SHA-256 of all the rest.
    pub(super) fingerprint: String,
    /// The program that planned it; another one may compute other digits.
    program: String,
    pub(super) sweep: Sweep,
    pub(super) subjects: Subjects,
    /// Values of the parameters, point by point.
    pub(super) points: Vec<Vec<f64>>,
}

impl Plan {
    pub(super) fn new(sweep: Sweep, subjects: Subjects) -> Self {
        let program = PROGRAM.to_owned();
        let points = sweep.points();
        let mut plan = Self { fingerprint: String::new(), program, sweep, subjects, points };
        plan.fingerprint = plan.digest();
        plan
    }

    fn digest(&self) -> String {
        let rest = serde_json::json!([self.program, self.sweep, self.subjects, self.points]);
        Sha256::digest(rest.to_string()).iter().fold(String::new(), |text, byte| format!("{text}{byte:02x}"))
    }

    /// Tells which robot the study is about, and the remarks on the study.
    pub(super) fn introduce(&self, output: &Output) -> Result<(), Failure> {
        let Subjects { study, machine, .. } = &self.subjects;
        output.about(&machine_of(machine)?.name);
        let study = Study::from_toml_bytes(study.as_bytes(), "the study of the plan")?;
        study.remarks().iter().for_each(|remark| output.remark(remark));
        Ok(())
    }

    /// True if the machine moves in a plane.
    pub(super) fn is_planar(&self) -> Result<bool, Failure> {
        Ok(machine_of(&self.subjects.machine)?.motion_pattern.is_planar())
    }

    /// Writes the plan, unless the folder has another one with rows.
    pub(super) fn write(&self, folder: &Path) -> Result<(), Failure> {
        let path = folder.join("plan.json");
        let has_rows = !RowFile::all(folder)?.is_empty();
        if has_rows
            && files::read_if_there(&path, Size::Table)?.is_some()
            && Self::read(folder)?.fingerprint != self.fingerprint
        {
            let message = format!("{} holds rows of another plan", folder.display());
            return Err(Failure::input("sweep::plan-changed", message, "give another folder, or remove this one"));
        }
        files::make_folder(folder)?;
        let text = serde_json::to_vec_pretty(self).map_err(|error| Failure::unwritable("the plan", &error))?;
        files::write(&path, &text)
    }

    pub(super) fn read(folder: &Path) -> Result<Self, Failure> {
        let path = folder.join("plan.json");
        let refused = |what: String, help: &str| {
            Failure::input("sweep::plan", format!("{}: {what}", path.display()), help.to_owned())
        };
        let bytes = files::read_if_there(&path, Size::Table)?;
        let bytes = bytes
            .ok_or_else(|| refused("there is no plan".to_owned(), "write one: cdpr sweep plan SWEEP.toml --out DIR"))?;
        let plan: Self = serde_json::from_slice(&bytes).map_err(|error| {
            refused(format!("this is no plan: {error}"), "plan the sweep again into another folder")
        })?;
        if plan.fingerprint != plan.digest() || plan.points != plan.sweep.points() {
            let message = format!("{}: the plan was changed by hand or by another program", path.display());
            return Err(Failure::input("sweep::plan-changed", message, "plan the sweep again into another folder"));
        }
        Ok(plan)
    }
}

fn machine_of(text: &str) -> Result<Robot, Failure> {
    Ok(Robot::from_toml_bytes(text.as_bytes(), "the machine of the plan")?)
}

/// A computed point in its file.
#[derive(Deserialize, Serialize)]
pub(super) struct RowFile {
    /// Fingerprint of the plan that the row belongs to.
    plan: String,
    row: Row,
}

impl RowFile {
    /// Rows are addressed by what they are: point and plan.
    fn path(folder: &Path, plan: &Plan, point: usize) -> PathBuf {
        let address = Sha256::digest(format!("{} {point}", plan.fingerprint));
        let short: String = address.iter().take(8).map(|byte| format!("{byte:02x}")).collect();
        folder.join("rows").join(format!("{point:05}-{short}.json"))
    }

    /// The row of a point; `None` if it was not computed.
    pub(super) fn read(folder: &Path, plan: &Plan, point: usize) -> Result<Option<Row>, Failure> {
        let path = Self::path(folder, plan, point);
        let Some(bytes) = files::read_if_there(&path, Size::Table)? else { return Ok(None) };
        let stored: Option<Self> = serde_json::from_slice(&bytes).ok();
        let is_right = |stored: &Self| stored.plan == plan.fingerprint && stored.row.point == point;
        match stored.filter(is_right) {
            Some(stored) => Ok(Some(stored.row)),
            None => {
                let message = format!("{}: this is no row of the plan", path.display());
                Err(Failure::input("sweep::plan-changed", message, "remove the file and run the shard again"))
            }
        }
    }

    pub(super) fn write(folder: &Path, plan: &Plan, row: Row) -> Result<(), Failure> {
        files::make_folder(&folder.join("rows"))?;
        let path = Self::path(folder, plan, row.point);
        let stored = Self { plan: plan.fingerprint.clone(), row };
        let text = serde_json::to_vec(&stored).map_err(|error| Failure::unwritable("the row", &error))?;
        files::write(&path, &text)
    }

    /// Rows in the folder that belong to no point of the plan.
    pub(super) fn strangers(folder: &Path, plan: &Plan) -> Result<usize, Failure> {
        let own: std::collections::BTreeSet<PathBuf> =
            (0..plan.points.len()).map(|point| Self::path(folder, plan, point)).collect();
        Ok(Self::all(folder)?.iter().filter(|path| !own.contains(*path)).count())
    }

    /// All rows in the folder, of whatever plan.
    fn all(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
        let rows = folder.join("rows");
        let listed = match std::fs::read_dir(&rows) {
            Ok(listed) => listed,
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
            Err(error) => return Err(Failure::io("read", &rows.display().to_string(), &error)),
        };
        let is_row = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "json");
        Ok(listed.flatten().map(|entry| entry.path()).filter(is_row).collect())
    }
}
