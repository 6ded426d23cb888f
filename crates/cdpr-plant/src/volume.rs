//! Volume of a run's records, known before its first step.

use super::log::LogFormat;
use super::plant::Plant;
use super::scenario::Time;
use super::sensors::Sensors;

/// Fraction of a step below which times are equal.
pub(super) const SAME_TIME: f64 = 1e-6;

/// Characters of a number in a CSV file, comma included.
const NUMBER: u64 = 19;

/// Volume of a run's records, if it gets to its end.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Volume {
    /// Duration of the whole run (s).
    pub duration: f64,
    /// Time between two rows of log.csv (s).
    pub record_interval: f64,
    /// Rows of log.csv.
    pub log_rows: u64,
    /// Rows of all CSV files, those of the sensors included.
    pub rows: u64,
    /// Approximate bytes of these files.
    pub bytes: u64,
}

impl Volume {
    /// Volume of log and sensors.
    pub(super) fn of(plant: &Plant, time: &Time, sensors: Option<&Sensors>) -> Self {
        let (steps, every) = grid(time);
        let (duration, record_interval) = (time.duration_s, every as f64 * time.step_s);
        let mut volume = Self { duration, record_interval, log_rows: 1 + steps.div_ceil(every), rows: 0, bytes: 0 };
        volume.add(volume.log_rows, LogFormat::new(plant).column_count());
        for (rate, columns) in sensors.iter().flat_map(|sensors| sensors.rates(&plant.model)) {
            volume.add(1 + (rate * duration).min(steps as f64) as u64, columns);
        }
        volume
    }

    /// Adds a file.
    fn add(&mut self, rows: u64, columns: usize) {
        self.rows = self.rows.saturating_add(rows);
        self.bytes = self.bytes.saturating_add(rows.saturating_mul(NUMBER * columns as u64));
    }
}

/// Count of steps of the grid, and count of steps from one record to the next.
pub(super) fn grid(time: &Time) -> (u64, u64) {
    let Time { duration_s: duration, step_s: step, record_s, .. } = *time;
    let every = (record_s.unwrap_or(10.0 * step) / step).round().max(1.0) as u64;
    ((duration / step - SAME_TIME).ceil().max(1.0) as u64, every)
}
