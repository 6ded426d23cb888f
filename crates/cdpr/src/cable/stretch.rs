//! Laws of stretch of a robot's cable: what its file says, checked and made the law of [`cdpr_core::cable::stretch`].

pub use cdpr_core::cable::stretch::{Stretch, hysteresis, polynomial};

#[cfg(test)]
mod hysteresis_tests;
#[cfg(test)]
mod motion_tests;
#[cfg(test)]
mod polynomial_tests;

use hysteresis::{Hysteresis, Piece, StopOperator};
use polynomial::Polynomial;

use crate::robot::{HysteresisTable, StretchError, rising_range};

/// The law f = Σ cₖ εᵏ with `coefficients` c₁, c₂, … (N).
///
/// A polynomial whose slope turns somewhere is accepted if it reaches `largest_tension` (N) before, and is used up to
/// there; it is refused otherwise, with the strain where the slope turns.
pub fn polynomial_law(coefficients: &[f64], largest_tension: Option<f64>) -> Result<Polynomial, StretchError> {
    let end = rising_range(coefficients, largest_tension)?;
    Ok(Polynomial::rising_to(end, coefficients.iter().copied().collect()))
}

/// The law of a table, refused where it is none.
pub fn hysteresis_law(table: &HysteresisTable) -> Result<Hysteresis, StretchError> {
    let checked = table.pieces()?;
    let halved = |a: [f64; 4], b: [f64; 4], sign: f64| std::array::from_fn(|k| 0.5 * (a[k] + sign * b[k]));
    let pieces = checked.iter().map(|piece| Piece {
        start: piece.start,
        middle: halved(piece.loading.0, piece.unloading.0, 1.0),
        half: halved(piece.loading.0, piece.unloading.0, -1.0),
    });
    let shares = table.shares();
    let total: f64 = shares.iter().sum();
    let stops = table.transition_strain.iter().zip(shares);
    let stops = stops.map(|(strain, share)| StopOperator { rate: 2.0 / strain, weight: share / total });
    let last_width = checked.last().map_or(0.0, |piece| piece.width);
    Hysteresis::new(pieces.collect(), last_width, stops.collect()).ok_or(StretchError::Entries {
        key: "strain",
        found: checked.len(),
        allowed: "two or more",
    })
}
