//! Other starts of an identification, and the optima that they lead to.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde::Serialize;

use crate::robot::{Parameter, ParameterKind};

/// How far other starts move anchors from the file's values, in every direction (m).
const ANCHOR_SPREAD: f64 = 0.5;
/// By which factor other starts change compliances, up or down.
const COMPLIANCE_SPREAD: f64 = 10.0 / 3.0;
/// Ends of descents that differ by less than this share of their cost, or of one per sample, are the same optimum.
const SAME_BASIN: f64 = 1e-6;

/// An optimum that some of the starts led to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Basin {
    /// Weighted sum of squared residuals and priors.
    pub cost: f64,
    /// Starts that ended here.
    pub starts: usize,
    /// True when the descents that ended here converged.
    pub converged: bool,
}

/// Random starts around values that a file states.
pub(super) struct Starts {
    random: ChaCha8Rng,
}

impl Starts {
    pub(super) fn new(seed: u64) -> Self {
        Self { random: ChaCha8Rng::seed_from_u64(seed) }
    }

    /// The next start, a value for each parameter.
    pub(super) fn next(&mut self, parameters: &[Parameter], values: &[f64]) -> Vec<f64> {
        parameters.iter().zip(values).map(|(parameter, &value)| self.moved(parameter, value)).collect()
    }

    fn moved(&mut self, parameter: &Parameter, value: f64) -> f64 {
        let amount = 2.0 * self.random.random::<f64>() - 1.0;
        match parameter.kind {
            kind if kind.is_anchor() => value + ANCHOR_SPREAD * amount,
            ParameterKind::Compliance => value * COMPLIANCE_SPREAD.powf(amount),
            _ => value,
        }
    }
}

/// Difference of costs that is none, for an end of a fit to so many samples.
pub(super) fn same_cost(cost: f64, samples: usize) -> f64 {
    SAME_BASIN * (cost + samples as f64)
}

/// Counts an end among the optima found before.
pub(super) fn count(basins: &mut Vec<Basin>, cost: f64, converged: bool, samples: usize) {
    match basins.iter_mut().find(|basin| (basin.cost - cost).abs() <= same_cost(cost, samples)) {
        Some(basin) => basin.starts += 1,
        None => basins.push(Basin { cost, starts: 1, converged }),
    }
}
