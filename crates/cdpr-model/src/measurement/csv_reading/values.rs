//! Numbers of a row: its pose, its angles, and a check against the robot's size.

use std::num::ParseFloatError;

use nalgebra::UnitQuaternion;

use super::complaints::shortened;
use super::rows::{CsvFile, Format, Row, plain};
use crate::geometry::{MotionPattern, Pose};
use crate::measurement::Split;
use crate::measurement::columns::Quantity;
use crate::reading::{MAGNITUDE_LIMIT, ReadError};

/// Words for no number, besides an empty field and NaN.
const NO_VALUE: &[&str] = &["-", "--", "#N/A", "n/a", "NA", "null", "none", "nil", "missing", "?"];
/// Advice for a row without one of its numbers.
const LEAVE_OUT: &str = "remove the row, or have rows with mistakes left out";

impl CsvFile<'_> {
    pub(super) fn pose(&self, format: &Format, row: &Row<'_>) -> Result<Pose, ReadError> {
        let mut components = Vec::with_capacity(6);
        for axis in 0..self.robot.motion_pattern.translations() {
            components.push(self.number(format, row, Quantity::Position(axis))?);
        }
        self.pose_with(format, row, components)
    }

    /// The orientation of a row with a possibly unknown position.
    pub(super) fn orientation(&self, format: &Format, row: &Row<'_>) -> Result<UnitQuaternion<f64>, ReadError> {
        let at_origin = vec![0.0; self.robot.motion_pattern.translations()];
        Ok(self.pose_with(format, row, at_origin)?.rotation)
    }

    /// The pose of a row with these components of its position.
    fn pose_with(&self, format: &Format, row: &Row<'_>, mut components: Vec<f64>) -> Result<Pose, ReadError> {
        let pattern = self.robot.motion_pattern;
        match pattern {
            MotionPattern::Planar => components.push(self.number(format, row, Quantity::Angle)?),
            MotionPattern::Spatial if format.columns.contains_key(&Quantity::Euler(0)) => {
                for k in 0..3 {
                    components.push(self.number(format, row, Quantity::Euler(k))?);
                }
            }
            MotionPattern::Spatial => components.extend([0.0; 3]),
            _ => {}
        }
        let place_of_mistake = |message: String| self.at(row, 0, "csv::pose", message);
        let pose = pattern.pose(self.robot.plane, &components).map_err(|error| place_of_mistake(error.to_string()))?;
        if pattern != MotionPattern::Spatial || format.columns.contains_key(&Quantity::Euler(0)) {
            return Ok(pose);
        }
        let mut xyzw = [0.0; 4];
        for (k, value) in xyzw.iter_mut().enumerate() {
            *value = self.number(format, row, Quantity::Quaternion(k))?;
        }
        let Some(rotation) = Pose::rotation_from_xyzw(xyzw) else {
            let norm = xyzw.iter().map(|x| x * x).sum::<f64>().sqrt();
            let index = format.columns.get(&Quantity::Quaternion(0)).map_or(0, |column| column.0);
            let message = format!("the quaternion has norm {norm}; a rotation has norm 1 (within 1 %)");
            return Err(self
                .at(row, index, "csv::quaternion", message)
                .with_help("columns are qx, qy, qz, qw, scalar last"));
        };
        Ok(Pose { rotation, ..pose })
    }

    /// The angles of a row as in the file (rad), which a pose keeps only up to full turns; `None` if it has none.
    pub(super) fn angles(&self, format: &Format, row: &Row<'_>) -> Result<Option<[f64; 3]>, ReadError> {
        match self.robot.motion_pattern {
            MotionPattern::Planar => Ok(Some([self.number(format, row, Quantity::Angle)?, 0.0, 0.0])),
            MotionPattern::Spatial if format.columns.contains_key(&Quantity::Euler(0)) => {
                let angle = |k| self.number(format, row, Quantity::Euler(k));
                Ok(Some([angle(0)?, angle(1)?, angle(2)?]))
            }
            _ => Ok(None),
        }
    }

    /// The first length or coordinate of a row beyond the largest possible one (m).
    pub(super) fn too_far(&self, format: &Format, row: &Row<'_>, farthest: f64) -> Option<(Quantity, f64)> {
        let lengths = (0..self.robot.cable_count()).map(Quantity::Length);
        let positions = (0..self.robot.motion_pattern.translations()).map(Quantity::Position);
        let given = positions.chain(lengths).filter(|quantity| format.columns.contains_key(quantity));
        let mut values = given.filter_map(|quantity| Some((quantity, self.number(format, row, quantity).ok()?)));
        values.find(|(_, value)| value.abs() > farthest)
    }

    /// The error for that value.
    pub(super) fn too_far_error(&self, format: &Format, row: &Row<'_>, quantity: Quantity, value: f64) -> ReadError {
        let index = format.columns.get(&quantity).map_or(0, |column| column.0);
        let column = plain(&row.header[index]);
        let message = format!("column `{column}`: {value} m is more than 50 times the size of the robot");
        let help = "is this value in another unit than its column, or is its decimal point lost?";
        self.at(row, index, "csv::magnitude", message).with_help(help)
    }

    /// A finite number in SI units.
    pub(super) fn number(&self, format: &Format, row: &Row<'_>, quantity: Quantity) -> Result<f64, ReadError> {
        let Some(&(index, factor)) = format.columns.get(&quantity) else {
            return Err(self.header_error("csv::missing-column", format!("a column for {quantity:?} is missing")));
        };
        let written = plain(&row.record[index]);
        let column = plain(&row.header[index]);
        let error = |message: String| self.at(row, index, "csv::not-a-number", message);
        match self.parsed(format, &written) {
            Ok(value) if value.is_finite() && value.abs() <= MAGNITUDE_LIMIT => Ok(value * factor),
            Ok(value) => {
                Err(error(format!("column `{column}`: {value} is not a number to calculate with")).with_help(LEAVE_OUT))
            }
            Err(_) if written.is_empty() => Err(error(format!("column `{column}` is empty here")).with_help(LEAVE_OUT)),
            Err(_) if NO_VALUE.iter().any(|word| written.eq_ignore_ascii_case(word)) => {
                Err(error(format!("column `{column}`: `{written}` stands where a number belongs")).with_help(LEAVE_OUT))
            }
            Err(_) => Err(error(format!("column `{column}`: `{}` is not a number", shortened(&written)))
                .with_help(self.help_for_text(&written, row, format.decimals))),
        }
    }

    /// The part of the data that a row belongs to; empty if the row names none, `None` if the file has no such column.
    pub(super) fn set(&self, format: &Format, row: &Row<'_>) -> Result<Option<String>, ReadError> {
        let Some(&(index, _)) = format.columns.get(&Quantity::Set) else { return Ok(None) };
        let word = plain(&row.record[index]);
        if word.is_empty() || Split::SETS.contains(&word.as_ref()) {
            return Ok(Some(word.into_owned()));
        }
        let [train, validation, test] = Split::SETS;
        let column = plain(&row.header[index]);
        let message = format!("column `{column}`: `{}` is no part of the data that is known", shortened(&word));
        let help = format!(
            "the words are `{train}`, and `{validation}` or `{test}`; name the column otherwise if it means something else"
        );
        Err(self.at(row, index, "csv::set", message).with_help(help))
    }

    /// Parses a number with the decimal mark of the file; the other mark is an error.
    fn parsed(&self, format: &Format, written: &str) -> Result<f64, ParseFloatError> {
        if format.decimals.mark == b'.' {
            return written.parse();
        }
        // both marks in one number, or another mark than before, are not guessed at
        let swapped: String = written
            .chars()
            .map(|c| {
                if c == ',' {
                    '.'
                } else if c == '.' {
                    ','
                } else {
                    c
                }
            })
            .collect();
        swapped.parse()
    }
}
