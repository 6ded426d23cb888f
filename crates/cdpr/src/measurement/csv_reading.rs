//! Reader of measurement CSV files; every mistake with its line and column.

mod complaints;
mod plane_columns;
mod rows;

use csv::{ByteRecord, ReaderBuilder};

use super::Samples;
use super::columns::{Column, Quantity, meaning, position_columns};
use super::header_mistakes;
use super::magnitudes::{self, Finding};
use crate::geometry::{MotionPattern, Pose};
use crate::reading::{MAGNITUDE_LIMIT, Place, ReadError, Size, text_from_bytes};
use crate::robot::Robot;
use complaints::{help_for_text, shortened};
use rows::{Columns, CsvFile, Row};

/// A data set with what its reader noticed.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The samples.
    pub samples: Samples,
    /// Remarks for the user, e.g. on ignored columns.
    pub notices: Vec<String>,
}

impl Samples {
    /// Reads a measurement CSV of a robot (columns: interface of `cdpr`, `measurement::schema`).
    pub fn from_csv(bytes: &[u8], file_name: &str, robot: &Robot) -> Result<Reading, ReadError> {
        let text = text_from_bytes(bytes, Size::Table, file_name)?;
        CsvFile { text: text.trim_start_matches('\u{feff}'), file_name, robot }.read()
    }
}

/// Poses of a CSV with the pose columns of measurements; other columns are ignored.
pub fn poses_from_csv(bytes: &[u8], file_name: &str, robot: &Robot) -> Result<Vec<Pose>, ReadError> {
    let text = text_from_bytes(bytes, Size::Table, file_name)?;
    let file = CsvFile { text: text.trim_start_matches('\u{feff}'), file_name, robot };
    let mut poses = Vec::new();
    let mut notices = Vec::new();
    file.rows(&mut notices, &|_| Ok(()), &mut |columns, row| {
        poses.push(file.pose(columns, row)?);
        Ok(())
    })?;
    Ok(poses)
}

impl CsvFile<'_> {
    fn read(&self) -> Result<Reading, ReadError> {
        let m = self.robot.cable_count();
        let mut samples = Samples { cable_count: m, ..Samples::default() };
        let mut notices = Vec::new();
        let (mut tensions, mut set, mut time) = (Vec::new(), Vec::new(), Vec::new());
        let mut motor_angles = Vec::new();
        let (mut angles, mut too_far) = (Vec::new(), None);
        let columns = self.rows(&mut notices, &|columns| self.check_cables(columns), &mut |columns, row| {
            samples.poses.push(self.pose(columns, row)?);
            angles.extend(self.angles(columns, row)?);
            too_far = too_far.take().or_else(|| self.too_far(columns, row));
            for cable in 0..m {
                match by_angle(columns) {
                    true => motor_angles.push(self.number(columns, row, Quantity::MotorAngle(cable))?),
                    false => samples.lengths.push(self.number(columns, row, Quantity::Length(cable))?),
                }
                if columns.contains_key(&Quantity::Tension(cable)) {
                    tensions.push(self.number(columns, row, Quantity::Tension(cable))?);
                }
            }
            if let Some(&(index, _)) = columns.get(&Quantity::Set) {
                set.push(String::from_utf8_lossy(&row.record[index]).trim().to_owned());
            }
            if columns.contains_key(&Quantity::Time) {
                time.push(self.number(columns, row, Quantity::Time)?);
            }
            Ok(())
        })?;
        samples.tensions = (!tensions.is_empty()).then_some(tensions);
        samples.set = (!set.is_empty()).then_some(set);
        samples.time = (!time.is_empty()).then_some(time);
        let has_motor_angles = columns.keys().any(|quantity| matches!(quantity, Quantity::MotorAngle(_)));
        if has_motor_angles && motor_angles.is_empty() {
            notices.push(format!("{}: the motor angles are not needed, since the lengths are given", self.file_name));
        }
        if !motor_angles.is_empty() {
            samples.lengths = vec![f64::NAN; motor_angles.len()];
            samples.motor_angles = Some(motor_angles);
            return too_far.map_or(Ok(Reading { samples, notices }), Err);
        }
        match magnitudes::judge(self.robot, &samples, &angles) {
            Finding::Wrong { quantity, message, help } => {
                return Err(self.column_error(&columns, quantity, message).with_help(help));
            }
            Finding::Doubtful(words) => notices.push(format!("{}: {words}", self.file_name)),
            Finding::Plausible => {}
        }
        too_far.map_or(Ok(Reading { samples, notices }), Err)
    }

    /// Reads the header, checks it, hands over every row, and returns the columns.
    fn rows(
        &self,
        notices: &mut Vec<String>,
        check: &dyn Fn(&Columns) -> Result<(), ReadError>,
        take: &mut dyn FnMut(&Columns, &Row<'_>) -> Result<(), ReadError>,
    ) -> Result<Columns, ReadError> {
        if self.text.trim().is_empty() {
            return Err(self.error("csv::empty", "the file is empty").with_help("the first line names the columns"));
        }
        if let Some(mistake) = header_mistakes::of_first_line(self.first_line()) {
            let place = Place::on_line(self.first_line(), 1, mistake.column, mistake.width);
            return Err(self.error("csv::separator", mistake.message).at(place).with_help(mistake.help));
        }
        let mut reader = ReaderBuilder::new().flexible(true).from_reader(self.text.as_bytes());
        let header = reader.byte_headers().map_err(|error| self.unreadable(&error))?.clone();
        let columns = self.columns(&header, notices)?;
        self.check_pose_columns(&columns)?;
        check(&columns)?;
        let mut record = ByteRecord::new();
        let mut count = 0;
        while reader.read_byte_record(&mut record).map_err(|error| self.unreadable(&error))? {
            let line = record.position().map_or(0, |position| position.line() as usize);
            let row = Row { record: &record, header: &header, line };
            if record.len() != header.len() {
                return Err(self.ragged(&row));
            }
            take(&columns, &row)?;
            count += 1;
        }
        if count == 0 {
            return Err(self.error("csv::no-rows", "the file has column names but no rows"));
        }
        Ok(columns)
    }

    fn columns(&self, header: &ByteRecord, notices: &mut Vec<String>) -> Result<Columns, ReadError> {
        let mut columns = Columns::new();
        let mut ignored = Vec::new();
        let row = Row { record: header, header, line: 1 };
        for (index, name) in header.iter().enumerate() {
            let name = String::from_utf8_lossy(name).trim().to_owned();
            let Column { quantity, factor } = match meaning(&name) {
                Ok(Some(column)) => column,
                Ok(None) => {
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
        if !ignored.is_empty() {
            notices.push(format!("{}: ignored columns {}", self.file_name, ignored.join(", ")));
        }
        self.in_plane(&row, columns, notices)
    }

    fn check_pose_columns(&self, columns: &Columns) -> Result<(), ReadError> {
        let pattern = self.robot.motion_pattern;
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
        Ok(())
    }

    fn require(&self, columns: &Columns, quantity: Quantity, name: &str) -> Result<(), ReadError> {
        if columns.contains_key(&quantity) {
            return Ok(());
        }
        Err(self.missing_column(name))
    }

    fn pose(&self, columns: &Columns, row: &Row<'_>) -> Result<Pose, ReadError> {
        let pattern = self.robot.motion_pattern;
        let mut components = Vec::with_capacity(6);
        for axis in 0..pattern.translations() {
            components.push(self.number(columns, row, Quantity::Position(axis))?);
        }
        match pattern {
            MotionPattern::Planar => components.push(self.number(columns, row, Quantity::Angle)?),
            MotionPattern::Spatial if columns.contains_key(&Quantity::Euler(0)) => {
                for k in 0..3 {
                    components.push(self.number(columns, row, Quantity::Euler(k))?);
                }
            }
            MotionPattern::Spatial => components.extend([0.0; 3]),
            _ => {}
        }
        let place_of_mistake = |message: String| self.at(row, 0, "csv::pose", message);
        let pose = pattern.pose(self.robot.plane, &components).map_err(|error| place_of_mistake(error.to_string()))?;
        if pattern != MotionPattern::Spatial || columns.contains_key(&Quantity::Euler(0)) {
            return Ok(pose);
        }
        let mut xyzw = [0.0; 4];
        for (k, value) in xyzw.iter_mut().enumerate() {
            *value = self.number(columns, row, Quantity::Quaternion(k))?;
        }
        let Some(rotation) = Pose::rotation_from_xyzw(xyzw) else {
            let norm = xyzw.iter().map(|x| x * x).sum::<f64>().sqrt();
            let index = columns.get(&Quantity::Quaternion(0)).map_or(0, |column| column.0);
            let message = format!("the quaternion has norm {norm}; a rotation has norm 1 (within 1 %)");
            return Err(self
                .at(row, index, "csv::quaternion", message)
                .with_help("columns are qx, qy, qz, qw, scalar last"));
        };
        Ok(Pose { rotation, ..pose })
    }

    /// The angles of a row as the file gives them (rad), which a pose knows only within a turn.
    fn angles(&self, columns: &Columns, row: &Row<'_>) -> Result<Option<[f64; 3]>, ReadError> {
        match self.robot.motion_pattern {
            MotionPattern::Planar => Ok(Some([self.number(columns, row, Quantity::Angle)?, 0.0, 0.0])),
            MotionPattern::Spatial if columns.contains_key(&Quantity::Euler(0)) => {
                let angle = |k| self.number(columns, row, Quantity::Euler(k));
                Ok(Some([angle(0)?, angle(1)?, angle(2)?]))
            }
            _ => Ok(None),
        }
    }

    /// The error for the first length or coordinate of a row that is beyond all measure of the robot.
    fn too_far(&self, columns: &Columns, row: &Row<'_>) -> Option<ReadError> {
        let farthest = magnitudes::farthest(self.robot);
        let lengths = (0..self.robot.cable_count()).map(Quantity::Length);
        let positions = (0..self.robot.motion_pattern.translations()).map(Quantity::Position);
        positions.chain(lengths).find_map(|quantity| {
            let value = self.number(columns, row, quantity).ok().filter(|value| value.abs() > farthest)?;
            let index = columns.get(&quantity)?.0;
            let column = String::from_utf8_lossy(&row.header[index]).trim().to_owned();
            let message = format!("column `{column}`: {value} m is more than 50 times the size of the robot");
            let help = "is this value in another unit than its column, or is its decimal point lost?";
            Some(self.at(row, index, "csv::magnitude", message).with_help(help))
        })
    }

    /// A finite number in SI units.
    fn number(&self, columns: &Columns, row: &Row<'_>, quantity: Quantity) -> Result<f64, ReadError> {
        let Some(&(index, factor)) = columns.get(&quantity) else {
            return Err(self.header_error("csv::missing-column", format!("a column for {quantity:?} is missing")));
        };
        let written = String::from_utf8_lossy(&row.record[index]);
        let column = String::from_utf8_lossy(&row.header[index]);
        let error = |message: String| self.at(row, index, "csv::not-a-number", message);
        match written.trim().parse::<f64>() {
            Ok(value) if value.is_finite() && value.abs() <= MAGNITUDE_LIMIT => Ok(value * factor),
            Ok(value) => Err(error(format!("column `{column}`: {value} is not a number to calculate with"))
                .with_help("remove the row, or write the number that was measured")),
            Err(_) if written.trim().is_empty() => {
                Err(error(format!("column `{column}` is empty here")).with_help("remove the row, or write the number"))
            }
            Err(_) => Err(error(format!("column `{column}`: `{}` is not a number", shortened(&written)))
                .with_help(help_for_text(&written, row))),
        }
    }
}

/// True for a file that gives motor angles in place of lengths.
fn by_angle(columns: &Columns) -> bool {
    let has = |wanted: fn(&Quantity) -> bool| columns.keys().any(wanted);
    has(|quantity| matches!(quantity, Quantity::MotorAngle(_)))
        && !has(|quantity| matches!(quantity, Quantity::Length(_)))
}
