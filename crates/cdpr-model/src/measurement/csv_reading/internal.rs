//! Files of sensors inside the machine, with partly known or unknown poses.

use super::content::Content;
use super::rows::{CsvFile, Format, Row};
use super::{MeasurementFile, Numbers};
use crate::geometry::{MotionPattern, Pose};
use crate::measurement::InternalSamples;
use crate::measurement::columns::{Quantity, meaning};
use crate::measurement::header_mistakes;
use crate::reading::ReadError;
use crate::robot::Robot;

/// Columns of orientations.
const ORIENTATIONS: [&str; 8] = ["qx", "qy", "qz", "qw", "rx_rad", "ry_rad", "rz_rad", "angle_rad"];
/// Remark on positions without orientations.
const POSITIONS_ALONE: &str = "positions without orientation, as of one reflector: orientations are found with the parameters; if the reflector is not at the \
    platform's origin free `marker-frame`, if the tracker's world is not the robot's free `tracker-frame`";

impl MeasurementFile<'_> {
    /// True for a file without whole poses: no column is, or probably was meant to be, a position (it may have those of an
    /// inclinometer), or there are positions and no orientation of a platform that turns (a reflector).
    pub fn lacks_poses(&self, robot: &Robot) -> Result<bool, ReadError> {
        self.with_content(Content::Internal, robot, |file| {
            let has_position = file.has(|quantity| matches!(quantity, Quantity::Position(_)));
            Ok(file.has_positions_alone() || !has_position && file.refuse_without_poses().is_err())
        })
    }

    /// Lengths or their changes, with the known components of poses, and remarks: empty cells of a pose are unknown
    /// components.
    pub fn internal_samples(&self, robot: &Robot) -> Result<(InternalSamples, Vec<String>), ReadError> {
        self.with_content(Content::Internal, robot, |file| {
            let mut table = file.table()?;
            let are_changes = file.has_changes_only();
            let known = std::mem::take(&mut table.known);
            let swivels = Some(std::mem::take(&mut table.swivels)).filter(|angles| !angles.is_empty());
            let masses = Some(std::mem::take(&mut table.masses)).filter(|masses| !masses.is_empty());
            let rows = table.samples.len() + table.skipped.count();
            if let Some(error) = table.too_far.first {
                return Err(error);
            }
            table.notices.extend(table.skipped.words(file.file_name, rows));
            if file.has_positions_alone() {
                table.notices.push(format!("{}: {POSITIONS_ALONE}", file.file_name));
            }
            Ok((
                InternalSamples { samples: table.samples, known, swivels, masses, facts: Vec::new(), are_changes },
                table.notices,
            ))
        })
    }
}

impl CsvFile<'_> {
    /// Names of the columns after the name map.
    fn meant_names(&self) -> impl Iterator<Item = &str> {
        let names = self.layout.fields().into_iter().map(|name| name.trim().trim_matches('"'));
        names.map(|name| {
            let mapped = self.options.columns.iter().find(|(_, column)| column.as_str() == name);
            mapped.map_or(name, |(meant, _)| meant.as_str())
        })
    }

    /// True if some column is of a quantity.
    fn has(&self, wanted: fn(Quantity) -> bool) -> bool {
        self.meant_names().any(|name| meaning(name).is_ok_and(|column| column.is_some_and(|c| wanted(c.quantity))))
    }

    /// True for positions of a platform that turns without a column that is, or probably was meant to be, of its orientation.
    fn has_positions_alone(&self) -> bool {
        let unclaimed: Vec<&str> = self.meant_names().filter(|name| matches!(meaning(name), Ok(None))).collect();
        let is_meant = |name: &&str| header_mistakes::probably_meant(name, &unclaimed).is_some();
        self.robot.motion_pattern.has_rotation()
            && self.has(|quantity| matches!(quantity, Quantity::Position(_)))
            && !self.has(|quantity| matches!(quantity, Quantity::Angle | Quantity::Euler(_) | Quantity::Quaternion(_)))
            && self.meant_names().all(|name| meaning(name).is_ok())
            && !ORIENTATIONS.iter().any(is_meant)
    }

    /// True if lengths are given only by their changes, or by motor angles of winches with unknown start lengths.
    fn has_changes_only(&self) -> bool {
        let counts_from_nothing = || self.robot.cables.iter().any(|cable| cable.winch.start_length.is_some());
        !self.has(|quantity| matches!(quantity, Quantity::Length(_)))
            && (self.has(|quantity| matches!(quantity, Quantity::LengthChange(_)))
                || self.has(|quantity| matches!(quantity, Quantity::MotorAngle(_))) && !counts_from_nothing())
    }

    /// Reads the known components of a row's pose; the others are those of the identity.
    pub(super) fn known_components(
        &self,
        format: &Format,
        row: &Row<'_>,
        numbers: &mut Numbers,
    ) -> Result<(), ReadError> {
        let pattern = self.robot.motion_pattern;
        let is_given = |quantity: Quantity| {
            let column = format.columns.get(&quantity);
            column.is_some_and(|(index, _)| !row.record[*index].trim_ascii().is_empty())
        };
        let mut components = Vec::with_capacity(6);
        numbers.known.clear();
        for axis in 0..pattern.translations() {
            let is_known = is_given(Quantity::Position(axis));
            numbers.known.push(is_known);
            components.push(if is_known { self.number(format, row, Quantity::Position(axis))? } else { 0.0 });
        }
        let is_turn_known = match pattern {
            MotionPattern::Planar => is_given(Quantity::Angle),
            MotionPattern::Spatial => is_given(Quantity::Euler(0)) || is_given(Quantity::Quaternion(0)),
            _ => false,
        };
        numbers.known.resize(pattern.dof(), is_turn_known);
        if is_turn_known && numbers.known.iter().all(|known| *known) {
            numbers.pose = Some(self.pose(format, row)?);
            return Ok(());
        }
        components.resize(pattern.dof(), 0.0);
        let mut pose = pattern.pose(self.robot.plane, &components).unwrap_or_else(|_| Pose::identity());
        if is_turn_known {
            pose.rotation = self.orientation(format, row)?;
        }
        numbers.pose = Some(pose);
        Ok(())
    }
}
