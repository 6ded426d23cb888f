//! Cases of property tests: the same in every run and on every machine, or fresh ones where `cargo xtask soak` asks.
//!
//! The only place that reads `CDPR_SEED` (where random cases begin) and `CDPR_CASES` (how many times as many there are).

use std::ops::Range;

use proptest::test_runner::{Config, RngSeed};

/// A property test's settings with this many cases. A failure prints the smallest case that fails.
pub fn cases(count: u32) -> Config {
    Config {
        cases: count.saturating_mul(factor()),
        rng_seed: RngSeed::Fixed(seed().unwrap_or(11)),
        failure_persistence: None,
        ..Config::default()
    }
}

/// The number that a test adds to the seeds of its own cases.
pub fn first_seed() -> u64 {
    // rounds of a soak follow each other by one
    seed().map_or(0, |seed| (seed % (1 << 24)) << 32)
}

/// Seeds of a test's own cases: 0 to `count`, or as many fresh ones.
pub fn seeds(count: u64) -> Range<u64> {
    let first = first_seed();
    first..first + count.saturating_mul(u64::from(factor())).min(1 << 32)
}

/// Size of a sample: what `cargo xtask test` draws, or as many times as many.
pub fn sample(count: usize) -> usize {
    count.saturating_mul(usize::try_from(factor()).unwrap_or(usize::MAX))
}

fn seed() -> Option<u64> {
    number("CDPR_SEED")
}

fn factor() -> u32 {
    number("CDPR_CASES").map_or(1, |factor| u32::try_from(factor).unwrap_or(u32::MAX).max(1))
}

fn number(variable: &str) -> Option<u64> {
    let text = std::env::var(variable).ok()?;
    Some(text.parse().unwrap_or_else(|_| panic!("{variable} is `{text}`, it has to be a whole number")))
}
