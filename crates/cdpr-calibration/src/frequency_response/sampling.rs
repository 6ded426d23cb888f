//! Series on an even grid of times, without mean and drift.

use super::{InputError, Record};

/// Rows that are needed at least.
const FEWEST: usize = 64;

/// Part of a step by which gaps may differ from it before sampling counts as uneven.
const JITTER: f64 = 0.2;

/// Part of a step by which rows may lie beside the even grid and count as on it: rounded times.
const ROUNDED: f64 = 0.01;

/// Series at equal steps of time, mean and linear drift removed.
pub(super) struct Even {
    /// Distance of samples (s).
    pub(super) step: f64,
    pub(super) input: Vec<f64>,
    pub(super) output: Vec<f64>,
    /// Largest distance of a row from the grid where the series were interpolated onto it (s).
    pub(super) jitter: Option<f64>,
}

/// Refuses times that do not rise, or whose gaps differ from each other by more than jitter.
pub(super) fn check_times(times: &[f64]) -> Result<(), InputError> {
    if let Some(row) = (1..times.len()).find(|&row| !(times[row] > times[row - 1])) {
        return Err(InputError::TimeOrder { row: row + 1, before: times[row - 1], after: times[row] });
    }
    let mut gaps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let off = |gap: f64, usual: f64| (gap / usual - 1.0).abs();
    if gaps.is_empty() {
        return Ok(());
    }
    let middle = gaps.len() / 2;
    let usual = *gaps.clone().select_nth_unstable_by(middle, f64::total_cmp).1;
    let worst = (0..gaps.len()).fold(0, |a, b| if off(gaps[b], usual) > off(gaps[a], usual) { b } else { a });
    let gap = gaps.swap_remove(worst);
    if off(gap, usual) > JITTER {
        return Err(InputError::Uneven { row: worst + 2, gap, usual });
    }
    Ok(())
}

impl Even {
    pub(super) fn of(record: &Record) -> Result<Self, InputError> {
        let Record { times, input, output } = record;
        let count = times.len();
        if input.len() != count || output.len() != count {
            return Err(InputError::Lengths { times: count, input: input.len(), output: output.len() });
        }
        if let Some(row) = (0..count).find(|&row| ![times, input, output].iter().all(|all| all[row].is_finite())) {
            return Err(InputError::NotFinite { row: row + 1 });
        }
        check_times(times)?;
        if count < FEWEST {
            return Err(InputError::TooFewRows { found: count, needed: FEWEST });
        }
        let step = (times[count - 1] - times[0]) / (count - 1) as f64;
        let beside = |row: usize| (times[row] - times[0] - step * row as f64).abs();
        let jitter = Some((0..count).map(beside).fold(0.0, f64::max)).filter(|jitter| *jitter > ROUNDED * step);
        let even = |series: &[f64]| match jitter {
            None => series.to_vec(),
            Some(_) => interpolated(times, series, step),
        };
        let (input, output) = (without_drift(even(input)), without_drift(even(output)));
        for (what, series) in [("input", record.input.as_slice()), ("output", record.output.as_slice())] {
            if series.iter().all(|value| *value == series[0]) {
                return Err(InputError::NoRange { what });
            }
        }
        Ok(Self { step, input, output, jitter })
    }

    pub(super) fn len(&self) -> usize {
        self.input.len()
    }

    /// Length of the record (s).
    pub(super) fn duration(&self) -> f64 {
        self.step * self.len() as f64
    }
}

/// Values at equal steps from the first time on, linearly between rows.
fn interpolated(times: &[f64], series: &[f64], step: f64) -> Vec<f64> {
    let mut behind = 1;
    let at = |k: usize| {
        let time = times[0] + step * k as f64;
        while behind + 1 < times.len() && times[behind] < time {
            behind += 1;
        }
        let fraction = (time - times[behind - 1]) / (times[behind] - times[behind - 1]);
        series[behind - 1] + fraction.clamp(0.0, 1.0) * (series[behind] - series[behind - 1])
    };
    (0..times.len()).map(at).collect()
}

/// The series less the straight line that fits it best.
pub(super) fn without_drift(mut series: Vec<f64>) -> Vec<f64> {
    let middle = 0.5 * (series.len() as f64 - 1.0);
    let mean = series.iter().sum::<f64>() / series.len() as f64;
    let place = |k: usize| k as f64 - middle;
    let (mut along, mut squares) = (0.0, 0.0);
    for (k, value) in series.iter().enumerate() {
        along += place(k) * (value - mean);
        squares += place(k) * place(k);
    }
    let slope = along / squares;
    series.iter_mut().enumerate().for_each(|(k, value)| *value -= mean + slope * place(k));
    series
}
