//! Sizes of changes of recorded lengths, and lengths without them.

use cdpr_model::measurement::Samples;
use cdpr_model::model::{LengthShift, ShiftCourse};

/// Change of recorded lengths inside a record, as identified.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShiftEstimate {
    /// Cable and course.
    pub shift: LengthShift,
    /// Change of the recorded length: after the line less before it, or at the end of the record less at its beginning (m).
    pub change: f64,
    /// Standard deviation, frames and clock as found (m).
    pub sigma: f64,
    /// Length offset of the cable after it, which the calibrated robot has (m).
    pub offset_after: f64,
    /// Times of the first and the last sample (s), or their lines where rows have no times.
    pub record: [f64; 2],
    /// True where `record` are times.
    pub is_timed: bool,
}

impl ShiftEstimate {
    /// Length offset of the cable before the change (m).
    pub fn offset_before(&self) -> f64 {
        self.offset_after - self.change
    }

    /// Line from which on the lengths are changed; `None` of a drift.
    pub fn line(&self) -> Option<usize> {
        match self.shift.course {
            ShiftCourse::StepAt(line) => Some(line),
            ShiftCourse::Drift => None,
        }
    }

    /// Speed of a drift (m/s); `None` of a step, or where rows have no times.
    pub fn rate(&self) -> Option<f64> {
        let [first, last] = self.record;
        (self.line().is_none() && self.is_timed).then(|| self.change / (last - first))
    }

    /// Share of the change that comes after each sample: 1 before a step, 0 after it. Samples of another record are after it.
    pub(super) fn remaining(&self, samples: &Samples) -> Vec<f64> {
        let [first, last] = self.record;
        let clock = clock(samples, self.is_timed);
        let of_sample = |(sample, at): (usize, f64)| match self.shift.course {
            _ if samples.is_appended(sample) => 0.0,
            ShiftCourse::StepAt(line) => f64::from(u8::from(line_of(samples, sample) < line)),
            ShiftCourse::Drift => (last - at) / (last - first),
        };
        clock.into_iter().enumerate().map(of_sample).collect()
    }
}

fn line_of(samples: &Samples, sample: usize) -> usize {
    samples.lines.as_ref().map_or(sample + 2, |lines| lines[sample])
}

/// Times of the samples (s), or their lines.
pub(super) fn clock(samples: &Samples, is_timed: bool) -> Vec<f64> {
    match samples.time.as_ref().filter(|_| is_timed) {
        Some(time) => time.clone(),
        None => (0..samples.len()).map(|sample| line_of(samples, sample) as f64).collect(),
    }
}

/// Samples with recorded lengths as at the end of their record.
pub(in crate::fit) fn undone(samples: &Samples, shifts: &[ShiftEstimate]) -> Samples {
    let mut lengths = samples.lengths.clone();
    for estimate in shifts {
        let own = lengths.iter_mut().skip(estimate.shift.cable).step_by(samples.cable_count.max(1));
        own.zip(estimate.remaining(samples)).for_each(|(length, remaining)| *length += remaining * estimate.change);
    }
    Samples { lengths, motor_angles: None, ..samples.clone() }
}
