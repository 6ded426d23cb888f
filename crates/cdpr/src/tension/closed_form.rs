//! The closed form: tensions nearest to the middle of their limits, whether or not they keep them.

use nalgebra::{DMatrix, DVector};

use super::Limits;
use super::error::{InputError, check_sizes};
use crate::scalar::decomposition::svd;

/// Tensions in closed form, and what they are worth.
#[must_use = "check `within_limits` before using the tensions"]
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// Tension per cable (N); it may be negative or above its limit.
    pub tensions: Vec<f64>,
    /// True when every tension keeps its limits.
    pub within_limits: bool,
    /// Aᵀ f + w (N, N·m): zero to rounding unless the structure matrix has lost rank.
    pub wrench_residual: Vec<f64>,
    /// True when the tensions balance the load to rounding.
    pub balanced: bool,
    /// Rank of the structure matrix.
    pub rank: usize,
}

impl Solution {
    /// Why the tensions are not to be used: cables beyond their limits, or a load that stays unbalanced.
    pub fn reason(&self, limits: &Limits) -> Option<String> {
        let tolerance = limits.tolerance();
        let beyond = |(index, &f): (usize, &f64)| {
            let (least, largest) = (limits.minimum()[index], limits.maximum()[index]);
            match (f < least - tolerance, f > largest + tolerance) {
                (true, _) => Some(format!("cable {} has {f:.1} N, its least tension is {least} N", index + 1)),
                (_, true) => Some(format!("cable {} has {f:.1} N, its largest tension is {largest} N", index + 1)),
                _ => None,
            }
        };
        let mut reasons: Vec<String> = self.tensions.iter().enumerate().filter_map(beyond).collect();
        if !self.balanced {
            let rest: Vec<String> = self.wrench_residual.iter().map(|rest| format!("{rest:.3}")).collect();
            reasons.push(format!(
                "the cables leave [{}] of the load unbalanced: the structure matrix has rank {} of {}",
                rest.join(", "),
                self.rank,
                self.wrench_residual.len()
            ));
        }
        (!reasons.is_empty()).then(|| reasons.join("; "))
    }
}

/// f = f_m − A⁺ᵀ (w + Aᵀ f_m) with f_m = ½ (f_min + f_max) (Miermeister 2021, eq. 3.41).
///
/// Of all tensions that balance the load these are the nearest to f_m. Where the cables cannot balance it, the rest is
/// the least possible one, its rows compared after division by those of the structure matrix.
pub fn solve(structure_matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits) -> Result<Solution, InputError> {
    check_sizes(structure_matrix, wrench, limits, None)?;
    let middle = DVector::from_fn(limits.cable_count(), |cable, _| limits.middle(cable));
    let w = DVector::from_column_slice(wrench);
    let mut rows = structure_matrix.clone();
    let mut unbalanced = structure_matrix * &middle + &w;
    if !rows.norm_squared().is_finite() {
        return Err(InputError::NotFinite { what: "structure matrix" });
    }
    if !unbalanced.norm_squared().is_finite() {
        return Err(InputError::NotFinite { what: "wrench" });
    }
    // rows of length 1: forces and moments have different units, and the rank should not depend on them
    let largest = rows.row_iter().map(|row| row.norm()).fold(0.0, f64::max);
    for (mut row, rest) in rows.row_iter_mut().zip(unbalanced.iter_mut()) {
        let length = row.norm();
        if length > LOST * largest {
            row /= length;
            *rest /= length;
        }
    }
    let (correction, rank) = shortest(rows, &unbalanced);
    let tensions = middle - correction;
    let residual = structure_matrix * &tensions + &w;
    let within_limits = limits.contain(tensions.as_slice(), limits.tolerance());
    let size = structure_matrix.abs() * tensions.abs() + w.abs();
    let balanced = residual.iter().zip(size.iter()).all(|(rest, size)| rest.abs() <= 1e-9 * size);
    let (tensions, wrench_residual) = (tensions.as_slice().to_vec(), residual.as_slice().to_vec());
    Ok(Solution { tensions, within_limits, wrench_residual, balanced, rank })
}

/// Rows or singular values below this part of the largest are rounding of zero.
const LOST: f64 = 1e-12;

/// Shortest x with the least ‖rows x − right‖, and the rank of the rows.
fn shortest(rows: DMatrix<f64>, right: &DVector<f64>) -> (DVector<f64>, usize) {
    let cables = rows.ncols();
    // rows of numbers whose products overflow carry nothing
    let Some(decomposition) = svd(rows, true, true) else { return (DVector::zeros(cables), 0) };
    let values = &decomposition.singular_values;
    let least = LOST * values.max();
    let rank = values.iter().filter(|&&value| value > least).count();
    let solution = decomposition.solve(right, least).unwrap_or_else(|_| DVector::zeros(cables));
    (solution, rank)
}
