//! Standard errors of a mean over samples that may be correlated.

use std::collections::HashMap;

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::autocorrelation::lag_one;

/// Replicates of the bootstrap.
const REPLICATES: usize = 1000;

/// Standard error of the mean of a series by the circular block bootstrap (Politis and Romano 1992).
///
/// The block length is the one that is optimal for a first-order autoregressive process with the series' lag-one
/// correlation (Politis and White 2004): (2ρ/(1 − ρ²))^⅔ (3N/2)^⅓, at least 1. Seeded: the same series gives the same error.
pub fn standard_error(series: &[f64], seed: u64) -> f64 {
    let whole: Vec<usize> = (0..series.len()).collect();
    standard_error_of_groups(series, &whole, seed)
}

/// The same where values belong together, such as those at one pose: each value has the number of its group, and a group is drawn whole.
pub(super) fn standard_error_of_groups(series: &[f64], groups: &[usize], seed: u64) -> f64 {
    let mut place_of: HashMap<usize, usize> = HashMap::new();
    let (mut sums, mut sizes) = (Vec::new(), Vec::new());
    for (value, group) in series.iter().zip(groups) {
        let place = *place_of.entry(*group).or_insert(sums.len());
        if place == sums.len() {
            sums.push(0.0);
            sizes.push(0_usize);
        }
        sums[place] += value;
        sizes[place] += 1;
    }
    let count = sums.len();
    if count < 2 {
        return f64::NAN;
    }
    let of_groups: Vec<f64> = sums.iter().zip(&sizes).map(|(sum, size)| sum / *size as f64).collect();
    let block = block_length(&of_groups);
    let blocks = count.div_ceil(block);
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut means = Vec::with_capacity(REPLICATES);
    for _ in 0..REPLICATES {
        let (mut sum, mut values) = (0.0, 0);
        for index in 0..blocks {
            let start = rng.random_range(0..count);
            // the last block is cut so that every replicate has `count` groups
            let length = block.min(count - index * block);
            sum += (start..start + length).map(|at| sums[at % count]).sum::<f64>();
            values += (start..start + length).map(|at| sizes[at % count]).sum::<usize>();
        }
        means.push(sum / values as f64);
    }
    let mean = means.iter().sum::<f64>() / REPLICATES as f64;
    (means.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / (REPLICATES - 1) as f64).sqrt()
}

/// Length of the blocks in samples.
pub(super) fn block_length(series: &[f64]) -> usize {
    let count = series.len();
    let rho = lag_one(series).clamp(0.0, 0.99);
    let length = (2.0 * rho / (1.0 - rho * rho)).powf(2.0 / 3.0) * (1.5 * count as f64).cbrt();
    (length.ceil() as usize).clamp(1, count.div_ceil(4).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uniform(count: usize) -> Vec<f64> {
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        (0..count).map(|_| rng.random_range(0.0..1.0)).collect()
    }

    /// For independent samples it is σ/√N; 1000 replicates estimate it within a few percent.
    #[test]
    fn independent_samples_give_the_textbook_error() {
        let expected = (1.0_f64 / 12.0).sqrt() / 1000_f64.sqrt();
        let found = standard_error(&uniform(1000), 1);
        assert!((found / expected - 1.0).abs() < 0.15, "{found} {expected}");
    }

    /// Every value five times, anywhere in the series: drawn whole they count once.
    #[test]
    fn groups_are_drawn_whole() {
        let values = uniform(200);
        let scattered: Vec<f64> = (0..1000).map(|at| values[at % 200]).collect();
        let groups: Vec<usize> = (0..1000).map(|at| at % 200).collect();
        let expected = (1.0_f64 / 12.0).sqrt() / 200_f64.sqrt();
        let found = standard_error_of_groups(&scattered, &groups, 1);
        assert!((found / expected - 1.0).abs() < 0.15, "{found} {expected}");
        assert!(standard_error(&scattered, 1) < 0.6 * expected);
    }

    /// Every value ten times over: a tenth of the information, so the error is √10 larger.
    #[test]
    fn repeated_samples_do_not_count_as_new_ones() {
        let repeated: Vec<f64> = uniform(200).into_iter().flat_map(|x| [x; 10]).collect();
        let expected = (1.0_f64 / 12.0).sqrt() / 200_f64.sqrt();
        let found = standard_error(&repeated, 1);
        assert!((found / expected - 1.0).abs() < 0.25, "{found} {expected}");
    }
}
