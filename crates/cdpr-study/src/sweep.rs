//! Sweeps: the reachable workspace as a function of parameters of control model, machine and study (sec. 3.7, 3.8).

mod calibration_table;
mod files;
mod key;
mod point;
mod point_error;
mod pulleys;
mod set_up;
mod subjects;
#[cfg(test)]
mod tests;

use serde::{Deserialize, Serialize};
use thiserror::Error;

pub use calibration_table::{CalibratedModel, CalibrationOutcome, CalibrationPoint, CalibrationTable, PoseSensor};
pub(crate) use key::Key;
pub use key::{KeyError, KeyReason};
pub use point::Row;
pub use point_error::PointError;
pub use set_up::{PreparedSweep, check};
pub use subjects::Subjects;

use cdpr_model::reading::{ReadError, Size, Step, TomlDocument, text_from_bytes};
use cdpr_model::tension::Method;

/// A sweep as its file states it.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sweep {
    /// The study that is varied; its path is relative to the sweep.
    pub study: String,
    /// Largest position errors to judge by in turn (m), beside the tensions alone.
    #[serde(default)]
    pub position_error_max_m: Vec<f64>,
    /// Box to look in, ends along each translation (m); one around the machine when missing.
    pub bounds_m: Option<Vec<f64>>,
    /// Largest side of a cell (m); a hundredth of the longest side of the box in a plane, a fiftieth in space, when missing.
    pub step_m: Option<f64>,
    /// How a control model that commands tensions chooses them, in place of `[control] tension_method` of the study.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tension_method: Option<Method>,
    /// Sensors, numbers of poses and models to calibrate with: the sweep then answers with the cost of accuracy
    /// instead of the reachable workspace.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub calibration: Option<CalibrationTable>,
    /// Parameters that change: one table each; every value meets every value of the others.
    #[serde(default)]
    pub parameter: Vec<Parameter>,
}

/// One parameter with its values.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Parameter {
    /// `machine.`, `control.` or `both.` before the name of a robot's parameter or a key of robot files, `study.` before a key of study
    /// files: as `machine.axial-stiffness` of all cables, `control.frame-anchor[1].x`, `both.platform.mass_kg` or
    /// `study.initial.tension_limits_N[1]`.
    /// `placed_pulley_radius_m` gives every cable a pulley of that radius that touches where the anchor is at the initial pose.
    pub key: String,
    /// The values, in the unit of the key.
    pub values: Option<Vec<f64>>,
    /// First of `count` evenly spaced values, instead of `values`.
    pub from: Option<f64>,
    /// Last of `count` evenly spaced values.
    pub to: Option<f64>,
    /// Number of evenly spaced values from `from` to `to`.
    pub count: Option<usize>,
    /// Spacing of these values: `linear` (when missing) or `logarithmic`.
    #[serde(default)]
    pub spacing: Spacing,
    /// Swivel axis of placed pulleys, from the winch into the pulley (components in the robot's plane, or three); that of each cable
    /// in the machine's file when missing.
    pub swivel_axis: Option<Vec<f64>>,
}

/// How values of a row are spaced.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Spacing {
    /// Equal differences.
    #[default]
    Linear,
    /// Equal ratios.
    Logarithmic,
}

/// Most points of a sweep; a larger number is taken for a typing error.
const MOST_POINTS: usize = 100_000;

impl Sweep {
    /// Reads a sweep file.
    pub fn from_toml_bytes(bytes: &[u8], file_name: &str) -> Result<Self, ReadError> {
        let document = TomlDocument::parse(text_from_bytes(bytes, Size::Text, file_name)?, file_name)?;
        let sweep: Self = document.deserialize()?;
        let error = |path: &[Step<'_>], message: String| document.error_at(path, "sweep::value", message);
        if let Some(table) = &sweep.calibration {
            table.check().map_err(|reason| error(&[Step::Key("calibration")], reason.to_string()))?;
        }
        if sweep.parameter.is_empty() && sweep.calibration.is_none() {
            return Err(error(&[], "a sweep changes at least one parameter: add [[parameter]]".to_owned()));
        }
        if let Some(wrong) = sweep.position_error_max_m.iter().find(|most| !(**most > 0.0 && most.is_finite())) {
            return Err(error(&[Step::Key("position_error_max_m")], format!("{wrong} m is no largest error")));
        }
        for (index, parameter) in sweep.parameter.iter().enumerate() {
            let place = [Step::Key("parameter"), Step::Index(index)];
            parameter.key.parse::<Key>().map_err(|reason| error(&place, reason.to_string()))?;
            parameter.all_values().map_err(|reason| error(&place, reason.to_string()))?;
        }
        match sweep.points().len() {
            count if count > MOST_POINTS => {
                Err(error(&[], format!("the sweep has {count} points, more than {MOST_POINTS}")))
            }
            _ => Ok(sweep),
        }
    }

    /// Values of all parameters at every point; the last parameter changes first. A calibration appends the numbers of
    /// sensor and model, from 1, and the number of poses.
    pub fn points(&self) -> Vec<Vec<f64>> {
        let mut points = vec![Vec::new()];
        for parameter in &self.parameter {
            let values = parameter.all_values().unwrap_or_default();
            let extended = |point: &Vec<f64>| -> Vec<Vec<f64>> {
                values.iter().map(|value| [point.as_slice(), &[*value]].concat()).collect()
            };
            points = points.iter().flat_map(extended).collect();
        }
        match &self.calibration {
            Some(table) => points.iter().flat_map(|point| table.points(point)).collect(),
            None => points,
        }
    }

    /// The values of a point that belong to parameters.
    pub(crate) fn values_of<'v>(&self, point: &'v [f64]) -> &'v [f64] {
        &point[..self.parameter.len().min(point.len())]
    }
}

/// Error of a parameter's values.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("{key}: {reason}")]
pub(crate) struct ValuesError {
    /// Key of the parameter.
    pub key: String,
    /// Reason for which the values are wrong.
    pub reason: ValuesReason,
}

/// Reason for which a parameter's values are wrong.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub(crate) enum ValuesReason {
    /// Neither a list nor a range, or both.
    #[error("give either `values`, or `from`, `to` and `count`")]
    Form,
    /// An empty list, or a number that is NaN or infinite.
    #[error("values are finite numbers, one at least")]
    NotFinite,
    /// A range of too few or too many points.
    #[error("count is a whole number from 2 to {MOST_POINTS}")]
    Count,
    /// Equal ratios from or to a number that is not positive.
    #[error("logarithmic spacing needs ends above 0")]
    Logarithm,
}

impl Parameter {
    /// The values, listed or spaced.
    pub(crate) fn all_values(&self) -> Result<Vec<f64>, ValuesError> {
        self.values_or_reason().map_err(|reason| ValuesError { key: self.key.clone(), reason })
    }

    fn values_or_reason(&self) -> Result<Vec<f64>, ValuesReason> {
        let values = match (&self.values, self.from, self.to, self.count) {
            (Some(values), None, None, None) => values.clone(),
            (None, Some(from), Some(to), Some(count)) => self.spaced(from, to, count)?,
            _ => return Err(ValuesReason::Form),
        };
        match values.is_empty() || values.iter().any(|value| !value.is_finite()) {
            true => Err(ValuesReason::NotFinite),
            false => Ok(values),
        }
    }

    fn spaced(&self, from: f64, to: f64, count: usize) -> Result<Vec<f64>, ValuesReason> {
        if !(2..=MOST_POINTS).contains(&count) {
            return Err(ValuesReason::Count);
        }
        let fraction = |index: usize| index as f64 / (count - 1) as f64;
        match self.spacing {
            Spacing::Linear => Ok((0..count).map(|index| from + (to - from) * fraction(index)).collect()),
            Spacing::Logarithmic if from > 0.0 && to > 0.0 => {
                Ok((0..count).map(|index| from * (to / from).powf(fraction(index))).collect())
            }
            Spacing::Logarithmic => Err(ValuesReason::Logarithm),
        }
    }
}

/// JSON Schema of sweep files.
pub fn schema() -> schemars::Schema {
    schemars::schema_for!(Sweep)
}
