//! Friction that falls with speed, from standing to sliding, where plateaus show it.

use super::law::Law;
use super::least_squares::{Fit, SAME};
use super::plateaus::Plateau;

/// Gain of Akaike's criterion, corrected for few rows, from which on the part is there: odds of e³ = 20 for it.
pub(super) const LEAST_GAIN: f64 = 6.0;

/// Stribeck speeds that are tried, and their range as shares of the lowest and the highest speed.
const TRIED: (i32, f64, f64) = (24, 0.3, 0.5);

/// Largest standard deviation of the Stribeck speed as a share of it, and of the excess as a share of it, to tell them.
const KNOWN: (f64, f64) = (0.5, 1.0 / 3.0);

/// Share of the excess that a plateau still has, to be one that shows it.
const SHOWS: f64 = 0.1;

/// Judgement of plateaus on the part.
#[derive(Clone, Debug)]
pub(super) struct Judged {
    /// The law with the part, where the plateaus show it.
    pub(super) fit: Option<Fit>,
    /// True where standing friction and Stribeck speed are told by them.
    pub(super) is_told: bool,
    /// Gain of Akaike's corrected criterion; `None` where there are too few plateaus to ask.
    pub(super) gain: Option<f64>,
    /// Different speeds that show the excess.
    pub(super) speeds: usize,
}

/// Judges the part against a fit without it. `least` is the sum of squares that counts as none (N²·m²).
pub(super) fn judge(base: &Fit, plateaus: &[&Plateau], least: f64) -> Judged {
    let mut judged = Judged { fit: None, is_told: false, gain: None, speeds: 0 };
    let count = plateaus.len();
    let sizes = || plateaus.iter().map(|plateau| plateau.speed.abs());
    let (lowest, highest) = (sizes().fold(f64::INFINITY, f64::min), sizes().fold(0.0, f64::max));
    let law = Law { stribeck: true, ..base.law };
    let Some(place) = law.excess().filter(|_| count >= base.rank + 4) else { return judged };
    let (from, to) = ((TRIED.1 * lowest).ln(), (TRIED.2 * highest).ln());
    let mut best: Option<(Vec<f64>, f64)> = None;
    for k in 0..=TRIED.0 {
        let speed = from + (to - from) * f64::from(k) / f64::from(TRIED.0);
        let Some((excess, squares)) = along(base, plateaus, speed) else { continue };
        if excess > 0.0 && best.as_ref().is_none_or(|(_, least)| squares < *least) {
            let mut start = base.parameters.clone();
            start.splice(place..place, [excess, speed]);
            best = Some((start, squares));
        }
    }
    let criterion = |squares: f64, parameters: usize| {
        let (n, k) = (count as f64, parameters as f64 + 1.0);
        n * (squares.max(least) / n).ln() + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0)
    };
    let Some((start, _)) = best else {
        judged.gain = Some(criterion(base.squares(), base.rank) - criterion(base.squares(), base.rank + 2));
        return judged;
    };
    let fit = Fit::of(law, plateaus, start);
    let gain = criterion(base.squares(), base.rank) - criterion(fit.squares(), base.rank + 2);
    judged.gain = Some(gain);
    let (excess, speed) = (fit.parameters[place], fit.parameters[place + 1].exp());
    let is_within = speed >= 0.1 * lowest && speed <= 0.8 * highest;
    if !(gain >= LEAST_GAIN && excess > 0.0 && is_within) {
        return judged;
    }
    let mut shown: Vec<f64> = sizes().filter(|own| (-(own / speed).powi(2)).exp() >= SHOWS).collect();
    shown.sort_by(f64::total_cmp);
    shown.dedup_by(|one, other| (*one - *other).abs() <= SAME * *one);
    judged.speeds = shown.len();
    let variance = fit.squares().max(least) / (count - base.rank - 2) as f64;
    let sigma = |k: usize| {
        let mut gradient = vec![0.0; law.count()];
        gradient[k] = 1.0;
        fit.variance(&gradient).map_or(f64::INFINITY, |own| (own * variance).sqrt())
    };
    judged.is_told = judged.speeds >= 2 && sigma(place + 1) <= KNOWN.0 && sigma(place) <= KNOWN.1 * excess;
    judged.fit = Some(fit);
    judged
}

/// Excess, and sum of squares, if the law has the part at a Stribeck speed (its logarithm), by the derivatives of the fit without it.
fn along(base: &Fit, plateaus: &[&Plateau], speed: f64) -> Option<(f64, f64)> {
    let column: Vec<f64> = plateaus
        .iter()
        .map(|plateau| plateau.speed.signum() * (-(plateau.speed / speed.exp()).powi(2)).exp())
        .collect();
    let rest = base.without(plateaus, &column);
    let size: f64 = rest.iter().map(|value| value * value).sum();
    let whole: f64 = column.iter().map(|value| value * value).sum();
    if size <= 1e-9 * whole {
        return None;
    }
    let product: f64 = rest.iter().zip(&base.residuals).map(|(own, residual)| own * residual).sum();
    Some((product / size, base.squares() - product * product / size))
}
