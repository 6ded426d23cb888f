//! Rows of the sensors that share a file and its clock.

use std::fmt::Write;

use super::entry::{Seen, Sensor};
use super::signal::Clock;
use cdpr_model::model::Model;

/// Sensors of a file with their rows.
#[derive(Clone, Debug)]
pub(super) struct Record {
    /// Name of the file.
    pub(super) file: &'static str,
    clock: Clock,
    sensors: Vec<Box<dyn Sensor>>,
    /// Times (s) and numbers.
    rows: Vec<(f64, Vec<f64>)>,
}

impl Record {
    /// An empty file with `rate` rows per second.
    pub(super) fn new(file: &'static str, rate: f64) -> Self {
        Self { file, clock: Clock::new(rate), sensors: Vec::new(), rows: Vec::new() }
    }

    /// Adds a sensor, with its columns after the existing ones.
    pub(super) fn add(&mut self, sensor: Box<dyn Sensor>) {
        self.sensors.push(sensor);
    }

    /// Updates the sensors after a step, and adds a row if one is due.
    pub(super) fn look(&mut self, seen: &Seen<'_>) {
        self.sensors.iter_mut().for_each(|sensor| sensor.follow(seen));
        if !self.clock.is_due(seen.state.time) {
            return;
        }
        let mut row = Some(Vec::new());
        for sensor in &mut self.sensors {
            let read = sensor.read(seen);
            row = row.zip(read).map(|(mut row, numbers)| {
                row.extend(numbers);
                row
            });
        }
        let time = self.sensors.iter().fold(seen.state.time, |time, sensor| sensor.time_of_row(time));
        self.rows.extend(row.map(|row| (time, row)));
    }

    /// Names of the columns after the time.
    pub(super) fn columns(&self, model: &Model) -> Vec<String> {
        self.sensors.iter().flat_map(|sensor| sensor.columns(model)).collect()
    }

    /// Time (s) and numbers of the last row; `None` before the first.
    pub(super) fn last(&self) -> Option<(f64, &[f64])> {
        self.rows.last().map(|(time, numbers)| (*time, numbers.as_slice()))
    }

    /// Rows per second, and numbers in a row.
    pub(super) fn rate_and_columns(&self, model: &Model) -> (f64, usize) {
        (self.clock.rate(), 1 + self.columns(model).len())
    }

    /// The file as text, in the columns of measurement files.
    pub(super) fn csv(&self, model: &Model) -> String {
        let names: Vec<String> = std::iter::once("t_s".to_owned()).chain(self.columns(model)).collect();
        let mut text = names.join(",") + "\n";
        for (time, numbers) in &self.rows {
            let _ = write!(text, "{time}");
            for number in numbers {
                let _ = if number.is_nan() { write!(text, ",") } else { write!(text, ",{}", number + 0.0) };
            }
            text.push('\n');
        }
        text
    }
}

/// Names of one column per cable.
pub(super) fn cable_columns(stem: &str, model: &Model) -> Vec<String> {
    (1..=model.cable_count()).map(|cable| format!("{stem}_{cable}")).collect()
}
