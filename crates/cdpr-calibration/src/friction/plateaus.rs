//! Stretches of constant speed in records, and what is left out beside them.

use std::ops::Range;

use super::Record;
use super::steady::{Found, REST, Stretch, find};

/// Rows without times are samples from this number on, where consecutive speeds differ by less than this share of their magnitude.
const SAMPLES: (usize, f64) = (60, 0.1);

/// One constant speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Plateau {
    /// Number of its record, from 0.
    pub record: usize,
    /// First and last line of its rows.
    pub lines: [usize; 2],
    /// Rows that it is the mean of.
    pub samples: usize,
    /// Mean speed, lifting positive (rad/s).
    pub speed: f64,
    /// Mean torque, against the load positive (N·m).
    pub torque: f64,
    /// Torque of the load where the record gives it (N·m).
    pub load: Option<f64>,
    /// Number of its load among the loads of all records.
    pub group: usize,
    /// Standard error of the mean torque, by means of blocks of its samples (N·m); `None` for a row that is a mean already.
    pub standard_error: Option<f64>,
    /// Speed by the positions over the mean speed; `None` without positions.
    pub speed_ratio: Option<f64>,
}

/// Rows that tell nothing about sliding friction, and why.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct LeftOut {
    /// Rows at rest: they only bound the break-away torque.
    pub at_rest: usize,
    /// Rows of changing speed.
    pub accelerating: usize,
    /// Rows next to a change of speed, and stretches too short for a mean.
    pub unsettled: usize,
    /// Rows, or stretches, that are there twice.
    pub duplicates: usize,
}

/// Plateaus of all records.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Plateaus {
    pub(super) sliding: Vec<Plateau>,
    pub(super) resting: Vec<Plateau>,
    pub(super) left_out: LeftOut,
}

impl Plateaus {
    /// Plateaus of records; `group` tells the load of a row of a record.
    pub(super) fn of(records: &[Record], group: impl Fn(usize, usize) -> usize) -> Self {
        let mut all = Self::default();
        let fastest =
            records.iter().flat_map(|record| &record.speeds).fold(0.0, |most: f64, speed| most.max(speed.abs()));
        for (number, record) in records.iter().enumerate() {
            let part = match (&record.times, looks_sampled(record)) {
                (Some(times), _) => sampled(record, number, times, fastest, &group),
                (None, true) => {
                    let times: Vec<f64> = (0..record.len()).map(|row| row as f64).collect();
                    let part = sampled(record, number, &times, fastest, &group);
                    let used: usize = part.sliding.iter().chain(&part.resting).map(|plateau| plateau.samples).sum();
                    if 2 * used >= record.len() { part } else { rows(record, number, fastest, &group) }
                }
                (None, false) => rows(record, number, fastest, &group),
            };
            all.sliding.extend(part.sliding);
            all.resting.extend(part.resting);
            all.left_out.at_rest += part.left_out.at_rest;
            all.left_out.accelerating += part.left_out.accelerating;
            all.left_out.unsettled += part.left_out.unsettled;
            all.left_out.duplicates += part.left_out.duplicates;
        }
        all.drop_duplicates();
        all
    }

    /// Counts plateaus with the same numbers once: copies of rows or of files.
    ///
    /// Numbers with few digits may agree by chance, and leaving them out would weigh them wrongly: copies are at most a quarter of all
    /// plateaus, or all are there equally often.
    fn drop_duplicates(&mut self) {
        let same = |one: &Plateau, other: &Plateau| {
            one.speed == other.speed
                && one.torque == other.torque
                && one.load == other.load
                && one.samples == other.samples
        };
        let mut unique: Vec<(Plateau, usize)> = Vec::new();
        // the same numbers stand next to each other; order of the rows is kept
        let mut order: Vec<usize> = (0..self.sliding.len()).collect();
        let key = |row: &usize| (self.sliding[*row].speed, self.sliding[*row].torque);
        order.sort_by(|one, other| {
            key(one).partial_cmp(&key(other)).unwrap_or(std::cmp::Ordering::Equal).then(one.cmp(other))
        });
        let mut first = vec![true; self.sliding.len()];
        for pair in order.chunk_by(|one, other| key(one) == key(other)) {
            let mut kept: Vec<usize> = Vec::new();
            for &row in pair {
                match kept.iter().position(|&one| same(&self.sliding[one], &self.sliding[row])) {
                    Some(_) => first[row] = false,
                    None => kept.push(row),
                }
            }
            for one in kept {
                let count = pair.iter().filter(|&&row| same(&self.sliding[one], &self.sliding[row])).count();
                unique.push((self.sliding[one].clone(), count));
            }
        }
        let copies = self.sliding.len() - unique.len();
        let equally = unique.iter().all(|(_, count)| *count == unique[0].1);
        if copies > 0 && (equally || 4 * copies <= self.sliding.len()) {
            let mut place = 0..;
            let dropped = std::mem::take(&mut self.sliding);
            self.sliding = dropped.into_iter().filter(|_| place.next().is_some_and(|row| first[row])).collect();
            self.left_out.duplicates += copies;
        }
    }
}

/// True for rows without times that follow each other as samples do.
fn looks_sampled(record: &Record) -> bool {
    if record.len() < SAMPLES.0 {
        return false;
    }
    let mut steps: Vec<f64> = record.speeds.windows(2).map(|pair| (pair[1] - pair[0]).abs()).collect();
    let mut sizes: Vec<f64> = record.speeds.iter().map(|speed| speed.abs()).collect();
    super::steady::median(&mut steps) < SAMPLES.1 * super::steady::median(&mut sizes)
}

/// Each row is a plateau.
fn rows(record: &Record, number: usize, fastest: f64, group: impl Fn(usize, usize) -> usize) -> Plateaus {
    let mut part = Plateaus::default();
    for row in 0..record.len() {
        let plateau = mean(record, number, row..row + 1, group(number, row));
        if record.speeds[row].abs() <= REST * fastest {
            part.left_out.at_rest += 1;
            part.resting.push(plateau);
        } else {
            part.sliding.push(plateau);
        }
    }
    part
}

/// Plateaus of samples in the order of time.
fn sampled(
    record: &Record,
    number: usize,
    times: &[f64],
    fastest: f64,
    group: impl Fn(usize, usize) -> usize,
) -> Plateaus {
    let mut part = Plateaus::default();
    for rows in runs(record, times, |row| group(number, row)) {
        let rows: Vec<usize> = distinct(record, times, rows, &mut part.left_out);
        let pick = |from: &[f64]| rows.iter().map(|&row| from[row]).collect::<Vec<f64>>();
        let (times, speeds) = (pick(times), pick(&record.speeds));
        let stretch = Stretch { times: &times, speeds: &speeds, fastest };
        let mut used = 0;
        for found in find(&stretch) {
            match found {
                Found::Accelerating(inner) => {
                    used += inner.len();
                    part.left_out.accelerating += inner.len();
                }
                Found::Steady(inner) => {
                    used += inner.len();
                    let [first, last] = [rows[inner.start], rows[inner.end - 1] + 1];
                    let mut plateau = mean(record, number, first..last, group(number, first));
                    plateau.speed_ratio = ratio(record, &times, &rows, &inner, plateau.speed);
                    if stretch.is_rest(&inner) {
                        part.left_out.at_rest += inner.len();
                        part.resting.push(plateau);
                    } else {
                        part.sliding.push(plateau);
                    }
                }
            }
        }
        part.left_out.unsettled += rows.len() - used;
    }
    part
}

/// Rows of each run: times go forward, without a long gap, at one load.
fn runs(record: &Record, times: &[f64], group: impl Fn(usize) -> usize) -> Vec<Range<usize>> {
    let mut steps: Vec<f64> = times.windows(2).map(|pair| pair[1] - pair[0]).filter(|step| *step > 0.0).collect();
    let gap = 30.0 * super::steady::median(&mut steps);
    let begins = |row: &usize| {
        let step = times[*row] - times[row - 1];
        let is_other = record.runs.as_ref().is_some_and(|runs| runs[*row] != runs[row - 1]);
        step < 0.0 || step > gap || is_other || group(*row) != group(row - 1)
    };
    let mut starts: Vec<usize> = (1..times.len()).filter(begins).collect();
    starts.insert(0, 0);
    starts.push(times.len());
    starts.windows(2).map(|pair| pair[0]..pair[1]).filter(|rows| !rows.is_empty()).collect()
}

/// Rows without those that repeat the one before.
fn distinct(record: &Record, times: &[f64], rows: Range<usize>, left_out: &mut LeftOut) -> Vec<usize> {
    let (start, count) = (rows.start, rows.len());
    let repeats = |row: usize| {
        row > start
            && times[row] == times[row - 1]
            && record.speeds[row] == record.speeds[row - 1]
            && record.torques[row] == record.torques[row - 1]
    };
    let kept: Vec<usize> = rows.filter(|row| !repeats(*row)).collect();
    left_out.duplicates += count - kept.len();
    kept
}

/// Means over rows.
fn mean(record: &Record, number: usize, rows: Range<usize>, group: usize) -> Plateau {
    let average = |from: &[f64]| from[rows.clone()].iter().sum::<f64>() / rows.len() as f64;
    Plateau {
        record: number,
        lines: [record.lines[rows.start], record.lines[rows.end - 1]],
        samples: rows.len(),
        speed: average(&record.speeds),
        torque: average(&record.torques),
        load: record.loads.as_deref().map(average),
        group,
        standard_error: error_of_blocks(&record.torques[rows.clone()]),
        speed_ratio: None,
    }
}

/// Standard error of a mean of samples that hang together, by means of blocks of them: eight blocks, four of fewer samples.
fn error_of_blocks(values: &[f64]) -> Option<f64> {
    let blocks = if values.len() >= 32 { 8 } else { 4 };
    if values.len() < 2 * blocks {
        return None;
    }
    let bound = |block: usize| block * values.len() / blocks;
    let means: Vec<f64> = (0..blocks)
        .map(|block| &values[bound(block)..bound(block + 1)])
        .map(|block| block.iter().sum::<f64>() / block.len() as f64)
        .collect();
    let mean = means.iter().sum::<f64>() / blocks as f64;
    let variance = means.iter().map(|own| (own - mean).powi(2)).sum::<f64>() / (blocks - 1) as f64;
    Some((variance / blocks as f64).sqrt())
}

/// Speed by the first and the last position over the mean speed.
fn ratio(record: &Record, times: &[f64], rows: &[usize], inner: &Range<usize>, speed: f64) -> Option<f64> {
    let positions = record.positions.as_ref()?;
    record.times.as_ref()?;
    let (first, last) = (inner.start, inner.end - 1);
    let by_position = (positions[rows[last]] - positions[rows[first]]) / (times[last] - times[first]);
    let ratio = by_position / speed;
    ratio.is_finite().then_some(ratio)
}
