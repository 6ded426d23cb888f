//! Points of a planned sweep, computed by any program.

use std::fmt;

use cdpr_model::reading::ErrorCode;
use cdpr_study::sweep::PreparedSweep;

use super::folder::{Plan, RowFile};
use crate::failure::Failure;

/// A planned sweep, prepared to compute its points: what schedulers of any kind hand out. Every row is the same bytes wherever it is
/// computed, and `cdpr sweep merge` joins them.
pub struct PreparedPlan {
    plan: Plan,
    prepared: PreparedSweep,
}

/// A plan that cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PlanRefused {
    code: &'static str,
    message: String,
    help: Option<String>,
}

impl fmt::Display for PlanRefused {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let help = self.help.as_ref().map_or_else(String::new, |help| format!("; {help}"));
        write!(formatter, "{}{help}", self.message)
    }
}

impl std::error::Error for PlanRefused {}

impl ErrorCode for PlanRefused {
    fn code(&self) -> &'static str {
        self.code
    }
}

impl From<Failure> for PlanRefused {
    fn from(failure: Failure) -> Self {
        let (code, help) = (failure.code(), failure.help().map(str::to_owned));
        Self { code, message: failure.message().to_owned(), help }
    }
}

impl PreparedPlan {
    /// The plan of the bytes of a `plan.json`.
    pub fn new(plan: &[u8]) -> Result<Self, PlanRefused> {
        let plan = Plan::of_bytes(plan, "plan.json")?;
        let prepared = PreparedSweep::new(&plan.sweep, &plan.subjects);
        let prepared = prepared.map_err(|error| Failure::refused("plan.json", &error))?;
        Ok(Self { plan, prepared })
    }

    /// SHA-256 of the plan, by which rows know it.
    pub fn fingerprint(&self) -> &str {
        &self.plan.fingerprint
    }

    /// Values of the parameters, point by point.
    pub fn points(&self) -> &[Vec<f64>] {
        &self.plan.points
    }

    /// Name of the file of a point's row, in the folder `rows` beside the plan; `None` if there is no such point.
    pub fn row_name(&self, point: usize) -> Option<String> {
        (point < self.plan.points.len()).then(|| self.plan.row_name(point))
    }

    /// Content of that file; `None` if there is no such point.
    pub fn row(&self, point: usize) -> Result<Option<Vec<u8>>, PlanRefused> {
        if point >= self.plan.points.len() {
            return Ok(None);
        }
        Ok(Some(RowFile::bytes(&self.plan, self.plan.row(&self.prepared, point))?))
    }
}
