//! Rows of a log in which a pose is held: ranges between changes.
//!
//! At every row the mean over a window before it is compared with the mean over the window from it on, coordinate by
//! coordinate and length by length. If they differ by more than noise and resolution explain, the platform moves; a
//! range of a second or more between such changes is held. A range with means that wander farther than a held pose may
//! is searched again with longer windows, which detect slower motions. If nothing is held so, lengths alone decide: a
//! platform may swing while its cables hold their lengths. Last, each end is extended row by row as long as rows, and
//! their mean, are like the rows inside.

use std::ops::Range;

use super::Samples;

/// Least duration of a held pose (s) …
pub(super) const HELD: f64 = 1.0;
/// … as a fraction, to allow for rows lost at the ends of a log and in gaps.
const NEARLY: f64 = 0.85;
/// Half width of the windows that are compared (s), at least one row, and the number of times it is doubled for slow
/// motions.
const WINDOW: f64 = 0.2;
const DOUBLINGS: u32 = 4;
/// Difference of means, in standard deviations, above which it is not noise.
const SIGNIFICANT: f64 = 5.0;
/// The same limit for single rows, and for the mean of the rows at an end.
const EDGE: f64 = 4.0;
/// Fraction of the diagonal of the anchors' box below which a difference is no motion.
const FLOOR_SHARE: f64 = 1e-5;
/// A held pose stays within this fraction of the diagonal, or within this many standard deviations.
const STILL_SHARE: f64 = 3e-4;
const STILL_NOISE: f64 = 8.0;
/// Largest difference between the halves of a swing, as a fraction of its width.
const TO_AND_FRO: f64 = 0.25;
/// Pauses longer than this end a range (typical intervals).
pub(super) const LONGEST_PAUSE: f64 = 20.0;
/// Lower quartile of the magnitude of a normal number, in standard deviations.
const QUARTILE: f64 = 0.3186;

/// Coordinates and lengths of a log over time.
pub(super) struct Log<'a> {
    time: &'a [f64],
    channels: Vec<Channel>,
    /// Typical interval (s).
    interval: f64,
    /// Diagonal of the anchors' box (m).
    diagonal: f64,
}

/// One coordinate of the position, or one length.
struct Channel {
    /// Numbers relative to the first one (m).
    values: Vec<f64>,
    /// Sums of all numbers before each row (m).
    sums: Vec<f64>,
    /// Standard deviation of a row (m).
    noise: f64,
    /// Resolution, the least difference between rows (m).
    step: f64,
    is_position: bool,
}

impl Channel {
    fn new(values: Vec<f64>, is_position: bool) -> Self {
        let mut sums = vec![0.0];
        for value in &values {
            sums.push(sums[sums.len() - 1] + value);
        }
        let differences = values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).filter(|size| *size > 0.0);
        let step = differences.fold(f64::INFINITY, f64::min);
        let step = if step.is_finite() { step } else { 0.0 };
        // a smooth motion cancels in second differences, of variance 1 + 4 + 1, and few of them are at bends
        let mut sizes: Vec<f64> = values.windows(3).map(|v| (v[0] - 2.0 * v[1] + v[2]).abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let noise = sizes.get(sizes.len() / 4).map_or(0.0, |quartile| quartile / (QUARTILE * 6.0_f64.sqrt()));
        Self { values, sums, noise, step, is_position }
    }

    fn mean(&self, rows: &Range<usize>) -> f64 {
        (self.sums[rows.end] - self.sums[rows.start]) / rows.len() as f64
    }

    /// Largest less least number in a range of rows.
    fn span(&self, rows: &Range<usize>) -> f64 {
        let values = &self.values[rows.clone()];
        values.iter().copied().fold(f64::NEG_INFINITY, f64::max) - values.iter().copied().fold(f64::INFINITY, f64::min)
    }

    /// Standard deviation of a row about the mean of a range of rows, at least the noise.
    fn scatter(&self, rows: &Range<usize>) -> f64 {
        let mean = self.mean(rows);
        let squares = self.values[rows.clone()].iter().map(|value| (value - mean).powi(2)).sum::<f64>();
        (squares / rows.len() as f64).sqrt().max(self.noise)
    }
}

impl<'a> Log<'a> {
    /// The positions of samples with times and, if they were recorded, the lengths.
    pub(super) fn new(samples: &Samples, time: &'a [f64], diagonal: f64) -> Self {
        let of_axis = |axis: usize| {
            let first = samples.poses.first().map_or(0.0, |pose| pose.position[axis]);
            Channel::new(samples.poses.iter().map(|pose| pose.position[axis] - first).collect(), true)
        };
        let cables = if samples.motor_angles.is_some() { 0 } else { samples.cable_count };
        let of_cable = |cable: usize| {
            let lengths = samples.lengths.iter().skip(cable).step_by(samples.cable_count);
            let first = samples.lengths.get(cable).copied().unwrap_or(0.0);
            Channel::new(lengths.map(|length| length - first).collect(), false)
        };
        let channels = (0..3).map(of_axis).chain((0..cables).map(of_cable)).collect();
        Self { time, channels, interval: typical_interval(time), diagonal }
    }

    /// Ranges of rows of one pose each, held for a second or more.
    pub(super) fn holds(&self) -> Vec<Range<usize>> {
        let mut found = Vec::new();
        let parts = self.parts();
        parts.iter().for_each(|part| self.search(part, (WINDOW, DOUBLINGS), false, &mut found));
        // a platform that swings while its cables hold their lengths, if lengths change at all
        let all = 0..self.time.len();
        let still = STILL_SHARE * self.diagonal;
        if self.channels.iter().any(|channel| !channel.is_position && channel.span(&all) > still) {
            let mut swinging = Vec::new();
            parts.iter().for_each(|part| self.search(part, (WINDOW, DOUBLINGS), true, &mut swinging));
            found = with_swings(found, swinging);
        }
        found
    }

    /// Ranges of rows with rising times and without long pauses.
    fn parts(&self) -> Vec<Range<usize>> {
        let pause = LONGEST_PAUSE * self.interval;
        let (mut parts, mut start) = (Vec::new(), 0);
        for row in 1..=self.time.len() {
            let goes_on = row < self.time.len() && (0.0..=pause).contains(&(self.time[row] - self.time[row - 1]));
            if !goes_on {
                parts.push(start..row);
                start = row;
            }
        }
        parts
    }

    /// Adds the holds in a range of rows, with windows of a half width (s) that may be doubled this many times; with
    /// `swings` by lengths alone.
    fn search(
        &self,
        part: &Range<usize>,
        (window, doublings): (f64, u32),
        swings: bool,
        found: &mut Vec<Range<usize>>,
    ) {
        for run in self.runs(part, window.max(1.01 * self.interval), swings) {
            let held = self.extended(&run, part, window);
            if self.time[held.end - 1] - self.time[held.start] < NEARLY * HELD {
                continue;
            }
            if !(self.wanders(&run, window, swings) || swings && self.drifts(&run)) {
                found.push(held);
            } else if doublings > 0 {
                self.search(&run, (2.0 * window, doublings - 1), swings, found);
            }
        }
    }

    /// Ranges of rows between changes.
    fn runs(&self, part: &Range<usize>, window: f64, swings: bool) -> Vec<Range<usize>> {
        let (mut runs, mut start, mut begin, mut end) = (Vec::new(), None, part.start, part.start);
        for row in part.clone() {
            begin += self.time[begin..row].iter().take_while(|t| self.time[row] - **t > window).count();
            end += self.time[end..part.end].iter().take_while(|t| **t - self.time[row] < window).count();
            match (self.changes(begin..row, row..end, swings), start) {
                (true, Some(first)) => {
                    runs.push(first..row);
                    start = None;
                }
                (false, None) => start = Some(row),
                _ => {}
            }
        }
        runs.extend(start.map(|first| first..part.end));
        runs
    }

    /// The channels that decide: all, or with `swings` the lengths only.
    fn asked(&self, swings: bool) -> impl Iterator<Item = &Channel> {
        self.channels.iter().filter(move |channel| !(swings && channel.is_position))
    }

    /// True if the means of rows before and after a row differ by more than noise and resolution explain.
    fn changes(&self, before: Range<usize>, after: Range<usize>, swings: bool) -> bool {
        if before.is_empty() || after.is_empty() {
            return false;
        }
        let fraction = SIGNIFICANT * (1.0 / before.len() as f64 + 1.0 / after.len() as f64).sqrt();
        let floor = FLOOR_SHARE * self.diagonal;
        self.asked(swings).any(|channel| {
            let difference = (channel.mean(&after) - channel.mean(&before)).abs();
            difference > floor + channel.step + fraction * channel.noise
        })
    }

    /// True if the means of windows in a range differ by more than a held pose may.
    fn wanders(&self, run: &Range<usize>, window: f64, swings: bool) -> bool {
        let rows = ((window / self.interval).ceil() as usize).clamp(1, run.len());
        let starts = || (run.start..=run.end - rows).step_by(rows).chain([run.end - rows]);
        self.asked(swings).any(|channel| {
            let allowed = (STILL_SHARE * self.diagonal).max(STILL_NOISE * channel.noise);
            let means = || starts().map(|start| channel.mean(&(start..start + rows)));
            means().fold(f64::NEG_INFINITY, f64::max) - means().fold(f64::INFINITY, f64::min) > allowed
        })
    }

    /// True if positions move in one direction in a range, rather than to and fro.
    fn drifts(&self, run: &Range<usize>) -> bool {
        let middle = run.start + run.len() / 2;
        self.channels.iter().filter(|channel| channel.is_position).any(|channel| {
            let way = (channel.mean(&(run.start..middle)) - channel.mean(&(middle..run.end))).abs();
            way > (STILL_SHARE * self.diagonal).max(TO_AND_FRO * channel.span(run))
        })
    }

    /// A range extended, within a window, by the rows beside it that are like the rows inside.
    fn extended(&self, run: &Range<usize>, part: &Range<usize>, window: f64) -> Range<usize> {
        let inside: Vec<(f64, f64)> = self.channels.iter().map(|c| (c.mean(run), c.scatter(run))).collect();
        let belongs = |row: usize, so_far: &Range<usize>| {
            self.channels.iter().zip(&inside).all(|(channel, (mean, scatter))| {
                let allowed = FLOOR_SHARE * self.diagonal + channel.step;
                let of_all = (channel.mean(so_far) - mean).abs();
                !((channel.values[row] - mean).abs() > allowed + EDGE * scatter)
                    && !(of_all > allowed + EDGE * scatter / (so_far.len() as f64).sqrt())
            })
        };
        let (mut start, mut end) = (run.start, run.end);
        let near = |row: usize, from: usize| (self.time[row] - self.time[from]).abs() <= window + self.interval;
        while start > part.start && near(start - 1, run.start) && belongs(start - 1, &(start - 1..run.start)) {
            start -= 1;
        }
        while end < part.end && near(end, run.end - 1) && belongs(end, &(run.end..end + 1)) {
            end += 1;
        }
        start..end
    }
}

/// Ranges at rest and ranges of held lengths in one list: of overlapping ones the range of lengths, unless the platform
/// is at rest for most of it.
fn with_swings(at_rest: Vec<Range<usize>>, held: Vec<Range<usize>>) -> Vec<Range<usize>> {
    let meet = |one: &Range<usize>, other: &Range<usize>| one.start < other.end && other.start < one.end;
    let (inside, mut all): (Vec<_>, Vec<_>) =
        at_rest.into_iter().partition(|rest| held.iter().any(|lengths| meet(rest, lengths)));
    for lengths in held {
        let mut own = inside.iter().filter(|rest| meet(rest, &lengths));
        all.push(match (own.next(), own.next()) {
            (Some(rest), None) if 2 * rest.len() > lengths.len() => rest.clone(),
            _ => lengths,
        });
    }
    all.sort_by_key(|rows| rows.start);
    all
}

/// Median interval between rows (s).
pub(super) fn typical_interval(time: &[f64]) -> f64 {
    let mut intervals: Vec<f64> = time.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    intervals.sort_by(f64::total_cmp);
    intervals.get(intervals.len() / 2).copied().unwrap_or(f64::INFINITY)
}

#[cfg(test)]
mod tests;
