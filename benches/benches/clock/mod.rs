//! Times of candidates that take turns.

use std::time::Instant;

/// Nanoseconds per item over some rounds, by the wall clock.
#[derive(Clone, Copy)]
pub(crate) struct Time {
    /// What the machine gave.
    pub(crate) median: f64,
    /// The least: what it gives with nothing else on it, where rounds are short.
    pub(crate) best: f64,
}

/// Time per item of each candidate, in rounds that last this long at least (s).
pub(crate) fn times(items: usize, rounds: usize, least: f64, candidates: &mut [&mut dyn FnMut()]) -> Vec<Time> {
    let mut times = vec![Vec::with_capacity(rounds); candidates.len()];
    for _ in 0..rounds {
        for (candidate, times) in candidates.iter_mut().zip(&mut times) {
            let (begin, mut calls) = (Instant::now(), 0);
            while begin.elapsed().as_secs_f64() < least {
                candidate();
                calls += 1;
            }
            times.push(begin.elapsed().as_secs_f64() * 1e9 / (calls * items) as f64);
        }
    }
    for times in &mut times {
        times.sort_by(f64::total_cmp);
    }
    times.iter().map(|times| Time { median: times[rounds / 2], best: times[0] }).collect()
}
