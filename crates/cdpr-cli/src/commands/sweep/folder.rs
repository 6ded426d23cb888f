//! The folder of a sweep: its plan, and a file for each point.

use std::path::{Path, PathBuf};

use cdpr_model::reading::Size;
use cdpr_model::robot::Robot;
use cdpr_study::Study;
use cdpr_study::sweep::{PreparedSweep, Row, Subjects, Sweep};
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
        let bytes = files::read_if_there(&path, Size::Table)?.ok_or_else(|| {
            let help = "write one: cdpr sweep plan SWEEP.toml --out DIR";
            Failure::input("sweep::plan", format!("{}: there is no plan", path.display()), help)
        })?;
        Self::of_bytes(&bytes, &path.display().to_string())
    }

    /// The plan of the bytes of a `plan.json`, named for messages.
    pub(super) fn of_bytes(bytes: &[u8], name: &str) -> Result<Self, Failure> {
        let help = "plan the sweep again into another folder";
        let plan: Self = serde_json::from_slice(bytes)
            .map_err(|error| Failure::input("sweep::plan", format!("{name}: this is no plan: {error}"), help))?;
        if plan.fingerprint != plan.digest() || plan.points != plan.sweep.points() {
            let message = format!("{name}: the plan was changed by hand or by another program");
            return Err(Failure::input("sweep::plan-changed", message, help));
        }
        Ok(plan)
    }

    /// Name of a point's row in the folder `rows`: rows are addressed by what they are, point and plan.
    pub(super) fn row_name(&self, point: usize) -> String {
        let address = Sha256::digest(format!("{} {point}", self.fingerprint));
        let short: String = address.iter().take(8).map(|byte| format!("{byte:02x}")).collect();
        format!("{point:05}-{short}.json")
    }

    /// Names of all rows, point by point.
    pub(super) fn row_names(&self) -> Vec<String> {
        (0..self.points.len()).map(|point| self.row_name(point)).collect()
    }

    /// The row of a point.
    pub(super) fn row(&self, prepared: &PreparedSweep, point: usize) -> Row {
        match self.sweep.calibration {
            Some(_) => prepared.calibration_row(point, &self.points[point]),
            None => prepared.row(point, &self.points[point]),
        }
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
    fn path(folder: &Path, plan: &Plan, point: usize) -> PathBuf {
        folder.join("rows").join(plan.row_name(point))
    }

    /// Content of a row's file.
    pub(super) fn bytes(plan: &Plan, row: Row) -> Result<Vec<u8>, Failure> {
        let stored = Self { plan: plan.fingerprint.clone(), row };
        serde_json::to_vec(&stored).map_err(|error| Failure::unwritable("the row", &error))
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
        files::write(&path, &Self::bytes(plan, row)?)
    }

    /// Rows in the folder that belong to no point of the plan.
    pub(super) fn strangers(folder: &Path, plan: &Plan) -> Result<usize, Failure> {
        let own: std::collections::BTreeSet<PathBuf> =
            (0..plan.points.len()).map(|point| Self::path(folder, plan, point)).collect();
        Ok(Self::all(folder)?.iter().filter(|path| !own.contains(*path)).count())
    }

    /// All rows in the folder, of whatever plan.
    fn all(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
        let is_row = |path: &PathBuf| path.extension().is_some_and(|ending| ending == "json");
        Ok(files::listed(&folder.join("rows"))?.into_iter().filter(is_row).collect())
    }
}
