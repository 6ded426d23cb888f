//! Reader of measurement CSV files; every error with its line and column.

mod complaints;
mod content;
mod header;
mod internal;
mod layout;
mod merging;
mod options;
mod plane_columns;
mod rows;
mod skipping;
#[cfg(test)]
mod tests;
mod values;

use super::Samples;
use super::columns::Quantity;
use super::magnitudes::{self, UnitVerdict};
use super::mix_ups;
use super::tension_units;
use crate::finding::Finding;
use crate::geometry::Pose;
use crate::reading::{ReadError, table_text};
use crate::robot::Robot;
use content::{Content, by_angle};
use layout::Layout;
pub use options::ReadingOptions;
use rows::{CsvFile, Format};
use skipping::Skipped;

/// A data set with the remarks of its reader.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The samples.
    pub samples: Samples,
    /// Remarks for the user, e.g. on ignored columns.
    pub notices: Vec<String>,
    /// Mistakes of recording that explain a disagreement of poses, lengths and tensions; reasons to doubt all results.
    pub findings: Vec<Finding>,
}

/// A measurement file in memory, with the options of reading.
#[derive(Clone, Copy, Debug)]
pub struct MeasurementFile<'a> {
    /// The bytes: UTF-8, UTF-16 or Latin-1; separated by commas, semicolons or tabs.
    pub bytes: &'a [u8],
    /// Its name in messages.
    pub name: &'a str,
    /// Options of reading.
    pub options: &'a ReadingOptions,
}

impl MeasurementFile<'_> {
    /// The samples of a robot (columns: interface of `cdpr`, `measurement::schema`).
    pub fn samples(&self, robot: &Robot) -> Result<Reading, ReadError> {
        self.with_content(Content::Samples, robot, |file| {
            let table = file.table()?;
            file.judged(table)
        })
    }

    /// Passes the file to `take` as text.
    fn with_content<T>(
        &self,
        content: Content,
        robot: &Robot,
        take: impl FnOnce(&CsvFile<'_>) -> Result<T, ReadError>,
    ) -> Result<T, ReadError> {
        let decoded = table_text(self.bytes, self.name)?;
        let text = decoded.text.as_ref();
        let Self { name: file_name, options, .. } = *self;
        take(&CsvFile {
            text,
            file_name,
            robot,
            options,
            content,
            layout: Layout::of(text),
            encoding: decoded.encoding,
        })
    }
}

impl Samples {
    /// Reads a measurement CSV of a robot (columns: interface of `cdpr`, `measurement::schema`).
    pub fn from_csv(bytes: &[u8], file_name: &str, robot: &Robot) -> Result<Reading, ReadError> {
        MeasurementFile { bytes, name: file_name, options: &ReadingOptions::default() }.samples(robot)
    }
}

/// Poses of a CSV with the pose columns of measurements; other columns are ignored.
pub fn poses_from_csv(bytes: &[u8], file_name: &str, robot: &Robot) -> Result<Vec<Pose>, ReadError> {
    let file = MeasurementFile { bytes, name: file_name, options: &ReadingOptions::default() };
    file.with_content(Content::Poses, robot, |file| Ok(file.table()?.samples.poses))
}

/// All rows of a file, with the remarks of its reader.
struct Table {
    /// The samples; poses are the identity if the file has none.
    samples: Samples,
    notices: Vec<String>,
    format: Format,
    /// Known components of the poses, for files of internal sensors.
    known: Vec<Vec<bool>>,
    /// Swivel angles, cable by cable (rad); empty if the file has none.
    swivels: Vec<f64>,
    /// Masses, sample by sample (kg); empty if the file has none.
    masses: Vec<f64>,
    too_far: TooFar,
    skipped: Skipped,
}

/// Rows with a number far beyond the robot's size.
#[derive(Default)]
struct TooFar {
    /// Indices of their samples, increasing.
    rows: Vec<usize>,
    /// The error of the first.
    first: Option<ReadError>,
}

/// The numbers of one row.
#[derive(Default)]
struct Numbers {
    pose: Option<Pose>,
    known: Vec<bool>,
    angles: Option<[f64; 3]>,
    recorded: Vec<f64>,
    tensions: Vec<f64>,
    swivels: Vec<f64>,
    mass: Option<f64>,
    time: Option<f64>,
    set: Option<String>,
}

impl CsvFile<'_> {
    fn table(&self) -> Result<Table, ReadError> {
        let mut samples = Samples { cable_count: self.robot.cable_count(), ..Samples::default() };
        let (mut recorded, mut tensions, mut set, mut time) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let (mut lines, mut angles, mut known) = (Vec::new(), Vec::new(), Vec::new());
        let (mut swivels, mut masses) = (Vec::new(), Vec::new());
        let (mut too_far, farthest) = (TooFar::default(), magnitudes::farthest(self.robot));
        let (mut notices, mut numbers) = (Vec::new(), Numbers::default());
        let (format, skipped) = self.rows(&mut notices, &mut |format, row| {
            self.numbers(format, row, &mut numbers)?;
            if let Some((quantity, value)) = self.too_far(format, row, farthest) {
                too_far.rows.push(lines.len());
                too_far.first.get_or_insert_with(|| self.too_far_error(format, row, quantity, value));
            }
            lines.push(row.line);
            samples.poses.push(numbers.pose.unwrap_or_else(Pose::identity));
            angles.extend(numbers.angles);
            if self.content == Content::Internal {
                known.push(numbers.known.clone());
            }
            recorded.extend(&numbers.recorded);
            tensions.extend(&numbers.tensions);
            swivels.extend(&numbers.swivels);
            masses.extend(numbers.mass);
            time.extend(numbers.time);
            set.extend(numbers.set.take());
            Ok(())
        })?;
        samples.lines = Some(lines);
        samples.tensions = (!tensions.is_empty()).then_some(tensions);
        samples.set = (!set.is_empty()).then_some(set);
        samples.time = (!time.is_empty()).then_some(time);
        if self.content.has_cables() && by_angle(&format.columns) {
            samples.lengths = vec![f64::NAN; recorded.len()];
            samples.motor_angles = Some(recorded);
        } else {
            samples.lengths = recorded;
            if format.columns.keys().any(|quantity| matches!(quantity, Quantity::MotorAngle(_))) {
                notices
                    .push(format!("{}: the motor angles are not needed, since the lengths are given", self.file_name));
            }
        }
        samples.angles = (!angles.is_empty()).then_some(angles);
        Ok(Table { samples, notices, format, known, swivels, masses, too_far, skipped })
    }

    /// Reads all numbers of a row; the error is the first one in the row.
    fn numbers(&self, format: &Format, row: &rows::Row<'_>, numbers: &mut Numbers) -> Result<(), ReadError> {
        let columns = &format.columns;
        if self.content == Content::Internal {
            self.known_components(format, row, numbers)?;
        }
        if self.content.has_poses() {
            numbers.pose = Some(self.pose(format, row)?);
            numbers.angles = self.angles(format, row)?;
        }
        numbers.recorded.clear();
        numbers.tensions.clear();
        numbers.swivels.clear();
        if self.content.has_cables() {
            let recorded = if by_angle(columns) { Quantity::MotorAngle } else { Quantity::Length };
            for cable in 0..self.robot.cable_count() {
                numbers.recorded.push(self.number(format, row, recorded(cable))?);
                if columns.contains_key(&Quantity::Tension(cable)) {
                    numbers.tensions.push(self.number(format, row, Quantity::Tension(cable))?);
                }
                if columns.contains_key(&Quantity::Swivel(cable)) {
                    numbers.swivels.push(self.number(format, row, Quantity::Swivel(cable))?);
                }
            }
        }
        if columns.contains_key(&Quantity::Mass) {
            numbers.mass = Some(self.number(format, row, Quantity::Mass)?);
        }
        if columns.contains_key(&Quantity::Time) {
            numbers.time = Some(self.number(format, row, Quantity::Time)?);
        }
        numbers.set = self.set(format, row)?;
        Ok(())
    }

    /// Samples of a table with numbers of the robot's size, with all remarks.
    fn judged(&self, table: Table) -> Result<Reading, ReadError> {
        let Table { mut samples, mut notices, format, too_far, mut skipped, .. } = table;
        let (rows, mut findings) = (samples.len() + skipped.count(), Vec::new());
        if samples.motor_angles.is_none() {
            let factor = |quantity| format.columns.get(&quantity).map_or(1.0, |column| column.1);
            match magnitudes::judge(self.robot, &samples, &factor) {
                UnitVerdict::Wrong { quantity, message, help } => {
                    return Err(self.column_error(&format.columns, quantity, message).with_help(help));
                }
                UnitVerdict::Doubtful(words) => notices.push(format!("{}: {words}", self.file_name)),
                UnitVerdict::Plausible => {
                    findings.extend(mix_ups::found(self.robot, &samples));
                    findings.extend(tension_units::judged(self.robot, &samples));
                    findings.iter_mut().for_each(|found: &mut Finding| {
                        found.text = format!("{}: {}", self.file_name, found.text);
                    });
                }
            }
        }
        samples = self.without_too_far(samples, too_far, &mut skipped)?;
        notices.extend(skipped.words(self.file_name, rows));
        Ok(Reading { samples, notices, findings })
    }

    /// Samples without rows far beyond the robot's size, which are an error unless invalid rows are to be skipped.
    fn without_too_far(&self, samples: Samples, too_far: TooFar, skipped: &mut Skipped) -> Result<Samples, ReadError> {
        let TooFar { rows, first: Some(first) } = too_far else { return Ok(samples) };
        // if most rows are too far, the file as a whole is wrong
        if !self.options.skip_invalid || 2 * rows.len() > samples.len() {
            return Err(first);
        }
        let is_kept = |sample: &usize| rows.binary_search(sample).is_err();
        skipped.add_all(rows.len(), first);
        Ok(samples.subset(&(0..samples.len()).filter(is_kept).collect::<Vec<_>>()))
    }
}
