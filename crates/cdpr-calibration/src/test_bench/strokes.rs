//! Turning points of a test bench's motion, and the elongations without the noise between them.

use std::ops::Range;

use super::record::Record;

/// A turn is one that goes back by this share of all elongations; less is noise.
const TURN: f64 = 0.01;

/// Rows between two turns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stroke {
    /// The rows.
    pub(super) rows: Range<usize>,
    /// Whether the elongation grows.
    pub(super) is_loading: bool,
}

impl Stroke {
    /// Elongation from end to end (m).
    pub(super) fn width(&self, record: &Record) -> f64 {
        range(&record.elongations[self.rows.clone()]).map_or(0.0, |range| range[1] - range[0])
    }

    /// ∫ f de by trapezoids (J); negative while unloading.
    pub(super) fn area(&self, record: &Record) -> f64 {
        let (elongations, tensions) = (&record.elongations[self.rows.clone()], &record.tensions[self.rows.clone()]);
        let pairs = elongations.windows(2).zip(tensions.windows(2));
        pairs.map(|(e, f)| 0.5 * (f[0] + f[1]) * (e[1] - e[0])).sum()
    }
}

/// The strokes of a record, in order: by its column of directions, or by where the elongation turns.
pub(super) fn strokes(record: &Record) -> Vec<Stroke> {
    let turns = match &record.directions {
        Some(directions) => turns_of_directions(directions),
        None => turns_of_elongations(&record.elongations),
    };
    let ends = turns.iter().skip(1).map(|turn| turn.0).chain([record.elongations.len()]);
    let strokes = turns.iter().zip(ends).map(|(&(begin, is_loading), end)| Stroke { rows: begin..end, is_loading });
    strokes.filter(|stroke| !stroke.rows.is_empty()).collect()
}

/// First rows of the strokes; a row at rest belongs to the stroke before.
fn turns_of_directions(directions: &[f64]) -> Vec<(usize, bool)> {
    let first = directions.iter().find(|&&direction| direction != 0.0).is_none_or(|&direction| direction > 0.0);
    let mut turns = vec![(0, first)];
    for (row, &direction) in directions.iter().enumerate() {
        let is_loading = turns.last().is_some_and(|turn| turn.1);
        if direction != 0.0 && (direction > 0.0) != is_loading {
            turns.push((row, !is_loading));
        }
    }
    turns
}

fn turns_of_elongations(elongations: &[f64]) -> Vec<(usize, bool)> {
    let threshold = TURN * range(elongations).map_or(0.0, |range| range[1] - range[0]);
    let (mut least, mut largest) = (0, 0);
    let mut turns: Vec<(usize, bool)> = Vec::new();
    for (row, &elongation) in elongations.iter().enumerate() {
        if elongation < elongations[least] {
            least = row;
        }
        if elongation > elongations[largest] {
            largest = row;
        }
        let is_loading = turns.last().map(|turn| turn.1);
        // the stroke began at the last extreme, which is known only now
        if is_loading != Some(true) && elongation - elongations[least] > threshold {
            turns.push((if turns.is_empty() { 0 } else { least + 1 }, true));
            largest = row;
        } else if is_loading != Some(false) && elongations[largest] - elongation > threshold {
            turns.push((if turns.is_empty() { 0 } else { largest + 1 }, false));
            least = row;
        }
    }
    turns
}

/// Elongations that do not turn within a stroke: the nearest such in the sense of least squares (pooling neighbours that
/// are the wrong way round), so that noise does not work the memory.
pub(super) fn smoothed(record: &Record, strokes: &[Stroke]) -> Vec<f64> {
    let mut smooth = record.elongations.clone();
    for stroke in strokes {
        let sign = if stroke.is_loading { 1.0 } else { -1.0 };
        let mut pools: Vec<(f64, usize)> = Vec::new();
        for &elongation in &record.elongations[stroke.rows.clone()] {
            let mut pool = (sign * elongation, 1);
            while let Some(&(mean, count)) = pools.last().filter(|before| before.0 > pool.0) {
                pools.pop();
                let sum = mean * count as f64 + pool.0 * pool.1 as f64;
                pool = (sum / (count + pool.1) as f64, count + pool.1);
            }
            pools.push(pool);
        }
        let values = pools.into_iter().flat_map(|(mean, count)| std::iter::repeat_n(sign * mean, count));
        for (target, value) in smooth[stroke.rows.clone()].iter_mut().zip(values) {
            *target = value;
        }
    }
    smooth
}

/// Least and largest number; `None` unless they differ.
pub(super) fn range(numbers: &[f64]) -> Option<[f64; 2]> {
    let least = numbers.iter().copied().fold(f64::INFINITY, f64::min);
    let largest = numbers.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    (largest > least).then_some([least, largest])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(elongations: &[f64]) -> Record {
        Record { elongations: elongations.to_vec(), tensions: vec![1.0; elongations.len()], directions: None }
    }

    #[test]
    fn turns_are_found_in_spite_of_noise() {
        let wave = |k: usize| -(k as f64 * 0.05).cos() + 1e-3 * ((k * 7919) % 13) as f64 / 13.0;
        let elongations: Vec<f64> = (0..=251).map(wave).collect();
        let found = strokes(&record(&elongations));
        // −cos turns at π, 2π, 3π and 4π: rows 63, 126, 188, 251
        let ways: Vec<bool> = found.iter().map(|stroke| stroke.is_loading).collect();
        assert_eq!(ways[..4], [true, false, true, false], "{found:?}");
        assert!(found[1].rows.start.abs_diff(63) < 4 && found[3].rows.end.abs_diff(251) < 4, "{found:?}");
    }

    #[test]
    fn a_column_of_directions_decides_where_there_is_one() {
        let with = Record { directions: Some(vec![0.0, 1.0, 1.0, 0.0, -1.0, -1.0]), ..record(&[0.0; 6]) };
        let found = strokes(&with);
        assert_eq!(found.iter().map(|stroke| stroke.rows.clone()).collect::<Vec<_>>(), [0..4, 4..6]);
    }

    #[test]
    fn smoothed_elongations_keep_their_mean_and_do_not_turn() {
        let record = record(&[0.0, 2.0, 1.0, 3.0, 2.5, 4.0, 3.0, 1.0]);
        let strokes = [Stroke { rows: 0..6, is_loading: true }, Stroke { rows: 6..8, is_loading: false }];
        assert_eq!(smoothed(&record, &strokes), [0.0, 1.5, 1.5, 2.75, 2.75, 4.0, 3.0, 1.0]);
    }
}
