//! The proof that no tensions within limits balance a load.

use crate::tension::Limits;
use nalgebra::DMatrix;

/// A direction y in which the load asks for more than the cables can give (Farkas).
///
/// In equilibrium Σ cᵢ fᵢ = −yᵀ w with c = A y, whatever the distribution. Within limits the sum is at most
/// Σ max(cᵢ f_min,i, cᵢ f_max,i), and this is less.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// y, one entry per row of the structure matrix.
    pub direction: Vec<f64>,
    /// c = A y per cable, the largest by amount 1; zero for cables that do not take part. Only rounding if no cable
    /// acts in the direction at all (lost rank); then the largest entry of y is 1.
    pub weights: Vec<f64>,
    /// −yᵀ w: the value of Σ cᵢ fᵢ in equilibrium (N).
    pub required: f64,
    /// The largest Σ cᵢ fᵢ within limits (N), less than `required`.
    pub reachable: f64,
    /// The limit at which each cable contributes most to Σ cᵢ fᵢ (N).
    pub(super) best: Vec<f64>,
    /// True if no cable acts in the direction.
    pub(super) is_unresisted: bool,
}

/// Fraction of the largest weight that is rounding.
pub(super) const ROUNDING: f64 = 1e-9;

impl Certificate {
    pub(in crate::tension) fn new(cable_count: usize, dof: usize) -> Self {
        Self {
            direction: vec![0.0; dof],
            weights: vec![0.0; cable_count],
            required: 0.0,
            reachable: 0.0,
            best: vec![0.0; cable_count],
            is_unresisted: false,
        }
    }

    /// Copies another certificate of the same size, without claiming memory.
    pub(in crate::tension) fn copy_from(&mut self, other: &Self) {
        self.direction.copy_from_slice(&other.direction);
        self.weights.copy_from_slice(&other.weights);
        self.best.copy_from_slice(&other.best);
        (self.required, self.reachable, self.is_unresisted) = (other.required, other.reachable, other.is_unresisted);
    }

    /// Computes all other fields from the direction. Checks whether any cable acts in it only if the rank is not full.
    pub(super) fn complete(&mut self, matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits, has_full_rank: bool) {
        match self.direction.len() {
            2 => self.weigh::<2>(matrix.as_slice()),
            3 => self.weigh::<3>(matrix.as_slice()),
            6 => self.weigh::<6>(matrix.as_slice()),
            dof => matrix.as_slice().chunks_exact(dof).zip(&mut self.weights).for_each(|(column, weight)| {
                *weight = self.direction.iter().zip(column).map(|(y, entry)| y * entry).sum();
            }),
        }
        let largest = largest_amount(&self.weights);
        self.is_unresisted = !has_full_rank && largest <= ROUNDING * self.largest_term(matrix);
        let factor = 1.0 / if self.is_unresisted { largest_amount(&self.direction) } else { largest };
        self.direction.iter_mut().for_each(|y| *y *= factor);
        self.required = self.direction.iter().zip(wrench).map(|(y, w)| -y * w).sum();
        self.reachable = 0.0;
        let ends = limits.minimum().iter().zip(limits.maximum());
        for ((weight, best), (least, largest)) in self.weights.iter_mut().zip(&mut self.best).zip(ends) {
            *weight *= factor;
            *best = if *weight > 0.0 { *largest } else { *least };
            self.reachable += *weight * *best;
        }
    }

    /// c = A y, for a number of rows known to the compiler.
    fn weigh<const N: usize>(&mut self, structure_matrix: &[f64]) {
        let mut y = [0.0; N];
        y.copy_from_slice(&self.direction);
        for (column, weight) in structure_matrix.chunks_exact(N).zip(&mut self.weights) {
            let mut sum = 0.0;
            for row in 0..N {
                sum += y[row] * column[row];
            }
            *weight = sum;
        }
    }

    /// The largest term of the sums in c = A y, to which their rounding is relative.
    fn largest_term(&self, structure_matrix: &DMatrix<f64>) -> f64 {
        let rows = structure_matrix.row_iter().zip(&self.direction);
        rows.map(|(row, y)| row.amax() * y.abs()).fold(0.0, f64::max)
    }

    /// True if its own numbers are finite and `reachable` is below `required`.
    pub(super) fn holds(&self) -> bool {
        self.reachable < self.required && self.required.is_finite() && self.reachable.is_finite()
    }

    /// Checks the proof from scratch: true if it shows that the load cannot be balanced within the limits.
    pub fn proves(&self, structure_matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits) -> bool {
        let (dof, cables) = structure_matrix.shape();
        if (dof, cables) != (self.direction.len(), limits.cable_count()) || wrench.len() != dof {
            return false;
        }
        let required: f64 = self.direction.iter().zip(wrench).map(|(y, w)| -y * w).sum();
        let mut reachable = 0.0;
        for (cable, column) in structure_matrix.column_iter().enumerate() {
            let weight: f64 = self.direction.iter().zip(&column).map(|(y, entry)| y * entry).sum();
            reachable += (weight * limits.minimum()[cable]).max(weight * limits.maximum()[cable]);
        }
        reachable < required
    }
}

fn largest_amount(numbers: &[f64]) -> f64 {
    numbers.iter().fold(0.0, |most, number| if number.abs() > most { number.abs() } else { most })
}
