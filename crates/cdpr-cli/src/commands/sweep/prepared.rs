//! Points of a plan, computed by any program.

use std::fmt;

use cdpr_model::reading::ErrorCode;
use cdpr_study::sweep::PreparedSweep;
use serde::Serialize;
use serde_json::value::RawValue;

use super::planned::{Planned, RowFile};
use crate::failure::Failure;

/// A plan of `cdpr sweep plan`, prepared to compute its points: what schedulers of any kind hand out. Every row is the same bytes wherever it
/// is computed, and `cdpr sweep merge` joins them.
pub struct PreparedPlan {
    plan: Planned,
    /// The study, read once for all points of a sweep.
    sweep: Option<PreparedSweep>,
}

/// A part of a command as a row.
#[derive(Serialize)]
struct PartRow {
    point: usize,
    part: Box<RawValue>,
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
        Ok(Self::of(Planned::of_bytes(plan, "plan.json")?)?)
    }

    pub(super) fn of(plan: Planned) -> Result<Self, Failure> {
        let sweep = match &plan {
            Planned::Sweep(own) => Some(PreparedSweep::new(&own.sweep, &own.subjects)),
            Planned::Command(_) => None,
        };
        let sweep = sweep.transpose().map_err(|error| Failure::refused("plan.json", &error))?;
        Ok(Self { plan, sweep })
    }

    /// SHA-256 of the plan, by which rows know it.
    pub fn fingerprint(&self) -> &str {
        self.plan.fingerprint()
    }

    /// Number of points.
    pub fn count(&self) -> usize {
        self.plan.count()
    }

    /// Values of a sweep's parameters, point by point; `None` for a command's parts, which have none.
    pub fn points(&self) -> Option<&[Vec<f64>]> {
        match &self.plan {
            Planned::Sweep(sweep) => Some(&sweep.points),
            Planned::Command(_) => None,
        }
    }

    /// The command that is planned, without the program's name; `None` for a sweep.
    pub fn command(&self) -> Option<&[String]> {
        match &self.plan {
            Planned::Sweep(_) => None,
            Planned::Command(command) => Some(&command.command),
        }
    }

    /// Name of the file of a point's row, in the folder `rows` beside the plan; `None` if there is no such point.
    pub fn row_name(&self, point: usize) -> Option<String> {
        (point < self.count()).then(|| self.plan.row_name(point))
    }

    /// Content of that file; `None` if there is no such point.
    pub fn row(&self, point: usize) -> Result<Option<Vec<u8>>, PlanRefused> {
        if point >= self.count() { Ok(None) } else { Ok(Some(self.row_bytes(point)?)) }
    }

    pub(super) fn row_bytes(&self, point: usize) -> Result<Vec<u8>, Failure> {
        match (&self.plan, &self.sweep) {
            (Planned::Sweep(sweep), Some(prepared)) => RowFile::bytes(&self.plan, &sweep.row(prepared, point)),
            (Planned::Command(command), _) => {
                let part = String::from_utf8_lossy(&command.part(point)?).into_owned();
                let part = RawValue::from_string(part).map_err(|error| Failure::unwritable("the row", &error))?;
                RowFile::bytes(&self.plan, &PartRow { point, part })
            }
            (Planned::Sweep(_), None) => Err(Failure::numerical("the sweep was not prepared")),
        }
    }
}
