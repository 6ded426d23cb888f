//! The pace of work in parts: what is done, and how long the rest takes where the parts so far tell.

use std::time::Duration;

/// Parts from which on a time left is told.
const LEARNT: usize = 3;

/// Parts, the latest, by which the cost of the next ones is told.
const LATEST: usize = 8;

/// Largest cost of one of them, over their mean, at which their costs count as even.
const EVEN: f64 = 2.0;

/// Parts of some work, with the times at which they were done.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pace {
    /// Number of parts; `None` where it is not known.
    pub(crate) parts: Option<usize>,
    /// Times since the beginning at which parts were done.
    done: Vec<Duration>,
}

impl Pace {
    /// Work in so many parts.
    pub(crate) fn of(parts: Option<usize>) -> Self {
        Self { parts, done: Vec::new() }
    }

    /// One more part is done, so long after the beginning.
    pub(crate) fn step(&mut self, now: Duration) {
        self.done.push(now);
    }

    /// Parts that are done.
    pub(crate) fn count(&self) -> usize {
        self.done.len()
    }

    /// True where all parts are done.
    pub(crate) fn is_done(&self) -> bool {
        self.parts.is_some_and(|parts| parts > 0 && self.done.len() >= parts)
    }

    /// Parts done and the time so far, with the time left where the latest parts took about as long as each other and the one at work
    /// does not take longer: `22 of 24, 11 s, about 2 s left`.
    pub(crate) fn words(&self, now: Duration) -> String {
        let elapsed = time(now);
        let Some(parts) = self.parts else { return elapsed };
        let left = self.left(now).map_or_else(String::new, |left| format!(", about {} left", time(left)));
        format!("{} of {parts}, {elapsed}{left}", self.done.len())
    }

    fn left(&self, now: Duration) -> Option<Duration> {
        let count = self.done.len();
        let rest = self.parts?.checked_sub(count).filter(|rest| *rest > 0)?;
        if count < LEARNT {
            return None;
        }
        let first = count.saturating_sub(LATEST);
        let begun = if first == 0 { Duration::ZERO } else { self.done[first - 1] };
        let ends = self.done[first..].iter();
        let costs: Vec<f64> = ends
            .scan(begun, |before, end| Some((*end).saturating_sub(std::mem::replace(before, *end)).as_secs_f64()))
            .collect();
        let mean = costs.iter().sum::<f64>() / costs.len() as f64;
        let largest = costs.iter().copied().fold(0.0, f64::max);
        let at_work = now.saturating_sub(self.done[count - 1]).as_secs_f64();
        let is_even = mean > 0.0 && largest <= EVEN * mean && at_work <= largest;
        is_even.then(|| Duration::from_secs_f64((mean * rest as f64 - at_work).max(0.0)))
    }
}

/// A time in the unit that people would take.
pub(crate) fn time(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    match seconds {
        short if short < 9.95 => format!("{short:.1} s"),
        long if long < 119.5 => format!("{long:.0} s"),
        minutes if minutes < 7170.0 => format!("{:.0} min", minutes / 60.0),
        hours => format!("{:.1} h", hours / 3600.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pace(parts: usize, ends: &[f64]) -> Pace {
        let mut pace = Pace::of(Some(parts));
        ends.iter().for_each(|end| pace.step(Duration::from_secs_f64(*end)));
        pace
    }

    #[test]
    fn even_parts_tell_how_long_the_rest_takes() {
        let words = |ends: &[f64], now: f64| pace(10, ends).words(Duration::from_secs_f64(now));
        assert_eq!(words(&[1.0, 2.0], 2.0), "2 of 10, 2.0 s");
        assert_eq!(words(&[1.0, 2.0, 3.0], 3.0), "3 of 10, 3.0 s, about 7.0 s left");
        assert_eq!(words(&[1.0, 2.0, 3.0], 3.5), "3 of 10, 3.5 s, about 6.5 s left");
    }

    /// The last points of a sweep take 40 s where the others took half a second: nothing is told that would be 0 s for all that time.
    #[test]
    fn a_part_that_takes_longer_than_those_before_leaves_no_promise() {
        let ends: Vec<f64> = (1..=22).map(|part| 0.5 * f64::from(part)).collect();
        assert_eq!(pace(24, &ends).words(Duration::from_secs(12)), "22 of 24, 12 s");
        assert_eq!(pace(24, &ends).words(Duration::from_secs(51)), "22 of 24, 51 s");
        let mut uneven = ends.clone();
        uneven.push(51.0);
        assert_eq!(pace(24, &uneven).words(Duration::from_secs(51)), "23 of 24, 51 s");
    }

    #[test]
    fn times_have_the_unit_of_people() {
        let words = [0.04, 5.62, 9.96, 119.0, 600.0, 9000.0].map(|seconds| time(Duration::from_secs_f64(seconds)));
        assert_eq!(words, ["0.0 s", "5.6 s", "10 s", "119 s", "10 min", "2.5 h"]);
    }
}
