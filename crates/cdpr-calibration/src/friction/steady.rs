//! Stretches of a run in which the speed is constant.
//!
//! A plateau is the longest stretch in which the smoothed speed stays in a band; what is left beside it is searched again. A stretch
//! whose speed drifts through its band is a ramp. Ends of a plateau, where speed and torque still settle, are no part of it.

use std::collections::VecDeque;
use std::ops::Range;

/// Speeds below this share of the largest one are rest.
pub(super) const REST: f64 = 2e-4;

/// Half width of the band: share of the speed, noise of smoothed speeds in standard deviations, share of the fastest speed.
const BAND: (f64, f64, f64) = (0.05, 4.0, 1e-3);

/// Change over a plateau that is no drift: share of its speed, standard deviations. Beyond it the plateau's slope is this share of the steepest of the
/// run: a slow controller, not a ramp.
const DRIFT: (f64, f64, f64) = (0.07, 2.5, 0.03);

/// Change over a plateau that its samples have to exclude, at two standard deviations: share of its speed, share of the fastest speed.
const EXCLUDED: (f64, f64) = (0.15, 0.02);

/// Share of the longest plateau of a run, in time and in way, below which another one is a stop on the way between speeds.
const PASSING: f64 = 1.0 / 6.0;

/// Share of a plateau that is left out at its start and at its end.
const SETTLING: f64 = 0.1;

/// Samples of a plateau at least.
const FEWEST: usize = 8;

/// Speeds that differ by this share are one plateau, where they follow each other.
const SAME: f64 = 0.05;

/// A run in the order of time.
pub(super) struct Stretch<'a> {
    /// Times (s).
    pub(super) times: &'a [f64],
    /// Speeds (rad/s).
    pub(super) speeds: &'a [f64],
    /// Fastest speed of all records (rad/s).
    pub(super) fastest: f64,
}

/// Rows of a run that are one of these.
pub(super) enum Found {
    /// Rows at constant speed, settled.
    Steady(Range<usize>),
    /// Rows of changing speed.
    Accelerating(Range<usize>),
}

/// Plateaus and ramps of a run, in the order of time.
pub(super) fn find(stretch: &Stretch<'_>) -> Vec<Found> {
    let count = stretch.speeds.len();
    if count < FEWEST {
        return Vec::new();
    }
    let width = (count / 40).clamp(2, 15);
    let smooth = smoothed(stretch.speeds, width);
    let noise = noise(stretch.speeds);
    let allowed = |level: f64| {
        let by_noise = BAND.1 * noise / ((2 * width + 1) as f64).sqrt();
        2.0 * (BAND.0 * level.abs()).max(by_noise).max(BAND.2 * stretch.fastest)
    };
    let steepest = stretch.steepest(&smooth, width);
    let (mut open, mut steady, mut ramps) = (Vec::new(), Vec::new(), Vec::new());
    open.push(0..count);
    while let Some(rows) = open.pop() {
        let longest = longest_in_band(&smooth[rows.clone()], allowed);
        if longest.len() < FEWEST {
            if !rows.is_empty() {
                ramps.push(rows);
            }
            continue;
        }
        let found = rows.start + longest.start..rows.start + longest.end;
        open.push(rows.start..found.start);
        open.push(found.end..rows.end);
        if stretch.drifts(&found, noise, steepest) { ramps.push(found) } else { steady.push(found) }
    }
    steady.sort_by_key(|rows| rows.start);
    let mut all: Vec<Found> =
        stretch.lasting(stretch.merged(steady)).into_iter().filter_map(settled).map(Found::Steady).collect();
    all.extend(ramps.into_iter().filter(|rows| !rows.is_empty()).map(Found::Accelerating));
    // a ramp between two parts of one plateau belongs to that
    let steady: Vec<Range<usize>> = all
        .iter()
        .filter_map(|found| match found {
            Found::Steady(rows) => Some(rows.clone()),
            Found::Accelerating(_) => None,
        })
        .collect();
    all.retain(|found| match found {
        Found::Steady(_) => true,
        Found::Accelerating(rows) => !steady.iter().any(|own| own.start < rows.end && rows.start < own.end),
    });
    all
}

impl Stretch<'_> {
    /// True where the speed of rows is none that differs from rest.
    pub(super) fn is_rest(&self, rows: &Range<usize>) -> bool {
        let (mean, deviation) = moments(&self.speeds[rows.clone()]);
        mean.abs() <= (1.5 * deviation).max(REST * self.fastest)
    }

    /// Largest slope of smoothed speeds (rad/s²).
    fn steepest(&self, smooth: &[f64], width: usize) -> f64 {
        let slope = |row: usize| (smooth[row + width] - smooth[row]) / (self.times[row + width] - self.times[row]);
        let slopes = (0..smooth.len() - width).map(|row| slope(row).abs());
        slopes.filter(|slope| slope.is_finite()).fold(0.0, f64::max)
    }

    /// True where a line through the speeds changes by more than noise and tolerance, or may do so.
    fn drifts(&self, rows: &Range<usize>, noise: f64, steepest: f64) -> bool {
        let (times, speeds) = (&self.times[rows.clone()], &self.speeds[rows.clone()]);
        let (centre, spread) = moments(times);
        let (mean, _) = moments(speeds);
        let products: f64 = times.iter().zip(speeds).map(|(time, speed)| (time - centre) * (speed - mean)).sum();
        let count = rows.len() as f64;
        let duration = times[times.len() - 1] - times[0];
        let slope = products / (spread * spread * count);
        if !slope.is_finite() {
            return false;
        }
        let (change, sigma) = ((slope * duration).abs(), noise * duration / (spread * count.sqrt()));
        let tolerated = (DRIFT.0 * mean.abs()).max(DRIFT.1 * sigma).max(BAND.2 * self.fastest);
        let is_still = change <= tolerated || slope.abs() <= DRIFT.2 * steepest;
        let excluded = (EXCLUDED.0 * mean.abs()).max(EXCLUDED.1 * self.fastest);
        !(is_still && change + 2.0 * sigma <= excluded)
    }

    /// Plateaus without stops on the way between two speeds.
    fn lasting(&self, all: Vec<Range<usize>>) -> Vec<Range<usize>> {
        let time = |rows: &Range<usize>| self.times[rows.end - 1] - self.times[rows.start];
        let way = |rows: &Range<usize>| moments(&self.speeds[rows.clone()]).0.abs() * time(rows);
        let longest = |of: &dyn Fn(&Range<usize>) -> f64| all.iter().map(of).fold(0.0, f64::max);
        let (duration, farthest) = (longest(&time), longest(&way));
        let lasts = |rows: &Range<usize>| {
            self.is_rest(rows) || time(rows) >= PASSING * duration || way(rows) >= PASSING * farthest
        };
        let (lasting, _) = all.iter().cloned().partition::<Vec<_>, _>(lasts);
        lasting
    }

    /// Neighbours at one speed as one.
    fn merged(&self, all: Vec<Range<usize>>) -> Vec<Range<usize>> {
        let mut merged: Vec<Range<usize>> = Vec::new();
        for rows in all {
            if let Some(last) = merged.last_mut() {
                let (one, other) = (moments(&self.speeds[last.clone()]).0, moments(&self.speeds[rows.clone()]).0);
                let gap = rows.start - last.end;
                let is_near = (one - other).abs() <= SAME * one.abs().max(other.abs());
                if is_near && gap <= last.len().min(rows.len()) / 2 {
                    last.end = rows.end;
                    continue;
                }
            }
            merged.push(rows);
        }
        merged
    }
}

/// A plateau without its ends; `None` where too little remains.
fn settled(rows: Range<usize>) -> Option<Range<usize>> {
    let end = ((SETTLING * rows.len() as f64).ceil() as usize).max(1);
    let inner = rows.start + end..rows.end - end;
    (inner.len() >= FEWEST - 2).then_some(inner)
}

/// The longest stretch whose largest and least value differ by no more than allowed at their middle.
fn longest_in_band(values: &[f64], allowed: impl Fn(f64) -> f64) -> Range<usize> {
    let (mut least, mut most): (VecDeque<usize>, VecDeque<usize>) = (VecDeque::new(), VecDeque::new());
    let (mut start, mut best) = (0, 0..0);
    for (end, &value) in values.iter().enumerate() {
        while least.back().is_some_and(|&row| values[row] >= value) {
            least.pop_back();
        }
        while most.back().is_some_and(|&row| values[row] <= value) {
            most.pop_back();
        }
        least.push_back(end);
        most.push_back(end);
        while let (Some(&low), Some(&high)) = (least.front(), most.front()) {
            let [low, high] = [values[low], values[high]];
            if high - low <= allowed(0.5 * (high + low)) {
                break;
            }
            start += 1;
            while least.front().is_some_and(|&row| row < start) {
                least.pop_front();
            }
            while most.front().is_some_and(|&row| row < start) {
                most.pop_front();
            }
        }
        if end + 1 - start > best.len() {
            best = start..end + 1;
        }
    }
    best
}

/// Means over so many values on both sides.
fn smoothed(values: &[f64], width: usize) -> Vec<f64> {
    let mut sums = vec![0.0];
    for value in values {
        sums.push(sums[sums.len() - 1] + value);
    }
    let at = |row: usize| {
        // fewer at the ends, as many on both sides
        let width = width.min(row).min(values.len() - 1 - row);
        (sums[row + width + 1] - sums[row - width]) / (2 * width + 1) as f64
    };
    (0..values.len()).map(at).collect()
}

/// Standard deviation of noise, by differences of neighbours.
fn noise(values: &[f64]) -> f64 {
    let mut steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let middle = median(&mut steps);
    let mut away: Vec<f64> = steps.iter().map(|step| (step - middle).abs()).collect();
    median(&mut away) / (0.6745 * std::f64::consts::SQRT_2)
}

/// Median; 0 of nothing.
pub(super) fn median(values: &mut [f64]) -> f64 {
    if values.is_empty() {
        return 0.0;
    }
    let middle = values.len() / 2;
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// Mean and standard deviation.
fn moments(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let variance = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / count;
    (mean, variance.sqrt())
}
