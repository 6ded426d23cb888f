//! Plateaus that do not belong to the others.

use super::least_squares::Fit;
use super::plateaus::Plateau;

/// Size of a normal deviate, by which a residual lies off in so few of all records that it is none of them: 1.7e-5 of plateaus.
const FAR: f64 = 4.3;

/// Share of the plateaus that may be outliers.
pub(super) const MOST: f64 = 0.2;

/// Plateaus beyond the rank that judge one.
const FEWEST: usize = 4;

/// The plateau that lies farthest off, if that is no chance.
pub(super) fn farthest(fit: &Fit, plateaus: &[&Plateau], least: f64) -> Option<usize> {
    let count = plateaus.len();
    if count < fit.rank + FEWEST || fit.squares() <= least {
        return None;
    }
    let freedom = (count - fit.rank) as f64;
    let deviates = fit.leverages(plateaus).into_iter().zip(&fit.residuals).map(|(share, residual)| {
        let own = residual * residual / (1.0 - share).max(1e-9);
        let others = (fit.squares() - own).max(least) / (freedom - 1.0);
        normal(own / others, freedom - 1.0)
    });
    let (row, deviate) = deviates.enumerate().max_by(|one, other| one.1.total_cmp(&other.1))?;
    (deviate > FAR).then_some(row)
}

/// The normal deviate that is as rare as one of Student's t, by its square (Wallace 1959).
fn normal(square: f64, freedom: f64) -> f64 {
    (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0) * (freedom * (1.0 + square / freedom).ln()).sqrt()
}
