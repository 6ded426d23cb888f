//! The header of a measurement file: the quantities of its columns.

use std::collections::BTreeMap;

use csv::ByteRecord;

use super::content::{Columns, Content, by_angle};
use super::layout::Layout;
use super::rows::{CsvFile, Row, plain};
use crate::geometry::MotionPattern;
use crate::measurement::columns::{Column, Quantity, meaning};
use crate::measurement::position_columns;
use crate::reading::{ReadError, did_you_mean};

/// Columns that a name map gives, by their names in the file.
type Mapped<'a> = BTreeMap<&'a str, (&'a str, Column)>;

impl CsvFile<'_> {
    pub(super) fn columns(&self, header: &ByteRecord, notices: &mut Vec<String>) -> Result<Columns, ReadError> {
        let mapped = self.mapped(header)?;
        let is_mapped = |quantity: Quantity| mapped.values().any(|(_, column)| column.quantity == quantity);
        let mut columns = Columns::new();
        let mut ignored = Vec::new();
        let Layout { header_line, header_start, .. } = self.layout;
        let row = Row { record: header, header, line: header_line, start: header_start };
        for (index, name) in header.iter().enumerate() {
            let name = plain(name).into_owned();
            let own = match mapped.get(name.as_str()) {
                Some((_, column)) => Ok(Some(*column)),
                None => meaning(&name).map(|column| column.filter(|column| !is_mapped(column.quantity))),
            };
            let Column { quantity, factor } = match own {
                Ok(Some(column)) if self.content.takes(column.quantity) => column,
                Ok(_) => {
                    let unnamed = || format!("{} (without a name)", index + 1);
                    ignored.push(if name.is_empty() { unnamed() } else { format!("`{name}`") });
                    continue;
                }
                Err(unknown) => {
                    let message = format!("column `{name}`: the unit `{}` is not known", unknown.unit);
                    return Err(self.at(&row, index, "csv::unknown-unit", message).with_help(unknown.help));
                }
            };
            if columns.insert(quantity, (index, factor)).is_some() {
                let message = format!("column `{name}` repeats a quantity that another column already gives");
                return Err(self.at(&row, index, "csv::repeated-column", message).with_help("remove one of the two"));
            }
        }
        if !ignored.is_empty() && self.content != Content::Poses {
            notices.push(format!("{}: ignored columns {}", self.file_name, ignored.join(", ")));
        }
        let columns = self.in_plane(&row, columns, notices)?;
        self.lengths_from_changes(columns, notices)
    }

    /// The columns in the name map; an error if a name has no quantity or the file has no such column.
    fn mapped(&self, header: &ByteRecord) -> Result<Mapped<'_>, ReadError> {
        let code = "csv::columns";
        let names: Vec<String> = header.iter().map(|name| plain(name).into_owned()).collect();
        let mut mapped = Mapped::new();
        for (name, column) in &self.options.columns {
            let Ok(Some(meant)) = meaning(name) else {
                let message = format!("columns: `{name}` is no column of measurements");
                let help = "names on the left are x_m, qx, angle_rad, cable_length_m_1, tension_N_1, t_s, set …, \
                            on the right those of the file";
                return Err(self.header_error(code, message).with_help(help));
            };
            if !names.iter().any(|known| known == column) {
                if self.content.is_one_of_two() {
                    continue;
                }
                let message = format!("columns: there is no column `{column}`, which is to be `{name}`");
                let meant = did_you_mean(column, names.iter().map(String::as_str));
                let hint = meant.map(|meant| format!("did you mean `{meant}`? ")).unwrap_or_default();
                let help = format!("{hint}the file has {}", names.join(", "));
                return Err(self.header_error(code, message).with_help(help));
            }
            if let Some((other, _)) = mapped.insert(column, (name, meant)) {
                let message = format!("columns: `{column}` is to be both `{other}` and `{name}`");
                return Err(self.header_error(code, message).with_help("one column gives one quantity"));
            }
        }
        Ok(mapped)
    }

    /// Columns of length changes used as lengths if there are none: both are equal up to an offset of each cable.
    fn lengths_from_changes(&self, mut columns: Columns, notices: &mut Vec<String>) -> Result<Columns, ReadError> {
        let of_change = |(quantity, column): (&Quantity, &(usize, f64))| match quantity {
            Quantity::LengthChange(cable) => Some((*cable, *column)),
            _ => None,
        };
        let changes: Vec<(usize, (usize, f64))> = columns.iter().filter_map(of_change).collect();
        columns.retain(|quantity, _| !matches!(quantity, Quantity::LengthChange(_)));
        let has = |quantity| columns.contains_key(&quantity);
        if changes.is_empty() || has(Quantity::Length(0)) || has(Quantity::MotorAngle(0)) {
            return Ok(columns);
        }
        columns.extend(changes.into_iter().map(|(cable, column)| (Quantity::Length(cable), column)));
        if self.content == Content::Internal {
            return Ok(columns);
        }
        notices.push(format!(
            "{}: the columns cable_length_change_… count from an unknown pose: each cable's length-offset is unknown, free it",
            self.file_name
        ));
        Ok(columns)
    }

    /// Refuses a file that lacks columns needed by the content.
    pub(super) fn check_columns(&self, columns: &Columns) -> Result<(), ReadError> {
        if matches!(self.content, Content::Log | Content::Track) {
            self.require(columns, Quantity::Time, "t_s")?;
        }
        if self.content.has_poses() {
            self.check_pose_columns(columns)?;
        }
        if self.content.has_cables() {
            self.check_cables(columns)?;
        }
        Ok(())
    }

    fn check_pose_columns(&self, columns: &Columns) -> Result<(), ReadError> {
        let pattern = self.robot.motion_pattern;
        if !columns.keys().any(|quantity| quantity.is_of_pose()) {
            self.refuse_without_poses()?;
        }
        for (axis, name) in position_columns(self.robot, "m").iter().enumerate() {
            self.require(columns, Quantity::Position(axis), name)?;
        }
        match pattern {
            MotionPattern::Planar => self.require(columns, Quantity::Angle, "angle_rad"),
            MotionPattern::Spatial if columns.contains_key(&Quantity::Euler(0)) => {
                (0..3).try_for_each(|k| self.require(columns, Quantity::Euler(k), ["rx_rad", "ry_rad", "rz_rad"][k]))
            }
            MotionPattern::Spatial => {
                (0..4).try_for_each(|k| self.require(columns, Quantity::Quaternion(k), ["qx", "qy", "qz", "qw"][k]))
            }
            _ => Ok(()),
        }
    }

    fn check_cables(&self, columns: &Columns) -> Result<(), ReadError> {
        self.refuse_cables_from_0()?;
        let m = self.robot.cable_count();
        let (build, name): (fn(usize) -> Quantity, _) = match by_angle(columns) {
            true => (Quantity::MotorAngle, "motor_angle_rad"),
            false => (Quantity::Length, "cable_length_m"),
        };
        let is_same = |quantity: &Quantity| std::mem::discriminant(quantity) == std::mem::discriminant(&build(0));
        let lengths = columns.keys().filter(|quantity| is_same(quantity)).count();
        let contiguous = (0..lengths).all(|cable| columns.contains_key(&build(cable)));
        if lengths > 0 && lengths != m && contiguous {
            let message = format!("the data have {lengths} cables, robot \"{}\" has {m}", self.robot.name);
            return Err(self.header_error("csv::cable-count", message).with_help("is it the right robot file?"));
        }
        (0..m).try_for_each(|cable| self.require(columns, build(cable), &format!("{name}_{}", cable + 1)))?;
        let has_tensions = columns.keys().any(|quantity| matches!(quantity, Quantity::Tension(_)));
        if has_tensions {
            (0..m).try_for_each(|cable| {
                self.require(columns, Quantity::Tension(cable), &format!("tension_N_{}", cable + 1))
            })?;
        }
        if columns.keys().any(|quantity| matches!(quantity, Quantity::Swivel(_))) {
            (0..m).try_for_each(|cable| {
                self.require(columns, Quantity::Swivel(cable), &format!("swivel_rad_{}", cable + 1))
            })?;
        }
        Ok(())
    }

    fn require(&self, columns: &Columns, quantity: Quantity, name: &str) -> Result<(), ReadError> {
        if columns.contains_key(&quantity) {
            return Ok(());
        }
        Err(self.missing_column(name))
    }
}
