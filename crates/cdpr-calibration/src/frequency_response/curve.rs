//! Cut-off and peak of a transfer function in a band.

use super::transfer::Transfer;

/// Frequencies over the band at which the curve is looked at first.
const COARSE: usize = 400;

/// Halvings of an interval: to rounding.
const HALVINGS: usize = 60;

/// Figures of a transfer function in a band.
pub(super) struct Curve {
    /// First frequency at which the gain is below that at the band's beginning by 3 dB (Hz), a factor √½; `None` if it is nowhere.
    pub(super) cutoff: Option<f64>,
    /// Frequency of the largest gain (Hz).
    pub(super) peak: f64,
    /// True where the gain falls to both sides of the peak inside the band.
    pub(super) has_peak: bool,
}

impl Curve {
    pub(super) fn of(transfer: &Transfer, band: [f64; 2]) -> Self {
        let gain = |frequency: f64| transfer.response(frequency).norm();
        let at = |k: usize| band[0] * (band[1] / band[0]).powf(k as f64 / COARSE as f64);
        let gains: Vec<f64> = (0..=COARSE).map(|k| gain(at(k))).collect();
        let wanted = gains[0] * 0.5_f64.sqrt();
        let crossing = (1..=COARSE).find(|&k| gains[k] < wanted);
        let cutoff = crossing.map(|k| bisected(at(k - 1), at(k), |frequency| gain(frequency) < wanted));
        let top = (0..=COARSE).fold(0, |best, k| if gains[k] > gains[best] { k } else { best });
        let has_peak = 0 < top && top < COARSE;
        let rising = |frequency: f64| slope(transfer, frequency) < 0.0;
        let peak = if has_peak { bisected(at(top - 1), at(top + 1), rising) } else { at(top) };
        Self { cutoff, peak, has_peak }
    }
}

/// The place between two at which a condition that holds at the second begins to hold.
fn bisected(mut before: f64, mut behind: f64, holds: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (before + behind);
        *(if holds(middle) { &mut behind } else { &mut before }) = middle;
    }
    0.5 * (before + behind)
}

/// Derivative of the logarithm of the gain by the frequency (1/Hz).
pub(super) fn slope(transfer: &Transfer, frequency: f64) -> f64 {
    transfer.logarithmic_slope(frequency).re
}
