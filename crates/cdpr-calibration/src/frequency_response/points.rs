//! Points of a frequency response with what they are worth.

use nalgebra::Complex;

/// Response at one frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Frequency (Hz).
    pub frequency: f64,
    /// Output per input: gain and phase, a late output having a negative phase.
    pub response: Complex<f64>,
    /// Share of the output's power that the input explains, 0 to 1.
    pub coherence: f64,
    /// Standard deviation of the gain, and of the response across it: that of the phase (rad) is `sigma / gain`.
    pub sigma: f64,
    /// False where coherence is below the limit of the settings.
    pub is_trusted: bool,
}

impl Point {
    /// Gain (output's unit per input's unit).
    pub fn gain(&self) -> f64 {
        self.response.norm()
    }

    /// Phase (rad), −π to π.
    pub fn phase(&self) -> f64 {
        self.response.arg()
    }
}

/// Points of a method, and those of them that a model is fitted to.
#[derive(Clone)]
pub(super) struct Points {
    /// All points, ascending.
    pub(super) all: Vec<Point>,
    /// Indices of the points that carry all information and depend on each other least.
    pub(super) fitted: Vec<usize>,
    /// For each of these, the covariance of its error with that of the next one, E(e eʹ*); 0 behind the last.
    pub(super) next: Vec<Complex<f64>>,
    /// Resolution of frequencies (Hz).
    pub(super) resolution: f64,
}

/// Least standard deviation relative to the gain: what the input does between samples is not known any better.
pub(super) const LEAST_SIGMA: f64 = 5e-4;

impl Points {
    /// The points, trusted from a coherence on.
    pub(super) fn trusted_from(mut self, limit: f64) -> Self {
        self.all.iter_mut().for_each(|point| point.is_trusted = point.coherence >= limit);
        self
    }

    /// Number of fitted points that count as one for a smooth function, as neighbours err together.
    pub(super) fn dependence(&self) -> f64 {
        let variance = |k: usize| 2.0 * self.all[self.fitted[k]].sigma.powi(2);
        let count = self.fitted.len();
        let pairs = (1..count).map(|k| self.next[k - 1].norm() / (variance(k - 1) * variance(k)).sqrt());
        1.0 + 2.0 * pairs.sum::<f64>() / count.max(1) as f64
    }

    /// Part of the points, by their width on a logarithmic scale of frequency, that are trusted.
    pub(super) fn trusted_share(&self) -> f64 {
        let width = |k: usize| {
            let at = |k: usize| self.all[k.min(self.all.len() - 1)].frequency;
            (at(k + 1) / at(k.saturating_sub(1))).ln()
        };
        let sum = |only_trusted: bool| -> f64 {
            (0..self.all.len()).filter(|&k| !only_trusted || self.all[k].is_trusted).map(width).sum()
        };
        if self.all.is_empty() {
            0.0
        } else {
            // a sum of nothing is −0
            (sum(true) + 0.0) / sum(false).max(f64::MIN_POSITIVE)
        }
    }
}
