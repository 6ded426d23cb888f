//! The plan of a sweep.

use cdpr_model::robot::Robot;
use cdpr_study::Study;
use cdpr_study::sweep::{PreparedSweep, Row, Subjects, Sweep};
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use crate::answer::Output;
use crate::failure::Failure;
use cdpr_reports::answers::PROGRAM;

/// Everything that decides the result of a sweep.
#[derive(Deserialize, Serialize)]
pub(super) struct SweepPlan {
    /// SHA-256 of all the rest.
    pub(super) fingerprint: String,
    /// The program that planned it; another one may compute other digits.
    program: String,
    pub(super) sweep: Sweep,
    pub(super) subjects: Subjects,
    /// Values of the parameters, point by point.
    pub(super) points: Vec<Vec<f64>>,
}

impl SweepPlan {
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

    /// True if the fingerprint is that of all the rest.
    pub(super) fn is_whole(&self) -> bool {
        self.fingerprint == self.digest() && self.points == self.sweep.points()
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
