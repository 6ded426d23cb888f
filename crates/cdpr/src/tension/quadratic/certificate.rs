//! The proof that no tensions within limits balance a load.

use nalgebra::DMatrix;

use crate::tension::Limits;

/// A direction y in which the load asks for more than the cables can give (Farkas).
///
/// In equilibrium Σ cᵢ fᵢ = −yᵀ w with c = A y, whatever the distribution. Within limits the sum is at most
/// Σ max(cᵢ f_min,i, cᵢ f_max,i), and this is less.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// y, one entry per row of the structure matrix.
    pub direction: Vec<f64>,
    /// c = A y per cable, the largest by amount 1; zero for cables that do not matter. Rounding alone when no cable acts in
    /// the direction at all (lost rank); then the largest entry of y is 1.
    pub weights: Vec<f64>,
    /// −yᵀ w: what equilibrium asks of Σ cᵢ fᵢ (N).
    pub required: f64,
    /// The largest Σ cᵢ fᵢ within limits (N), less than required.
    pub reachable: f64,
    /// The limit at which each cable gives most (N).
    pub(super) best: Vec<f64>,
    /// True when no cable acts in the direction.
    pub(super) is_unresisted: bool,
}

/// Part of the largest weight that is rounding.
pub(super) const ROUNDING: f64 = 1e-9;

impl Certificate {
    pub(super) fn new(cable_count: usize, dof: usize) -> Self {
        Self {
            direction: vec![0.0; dof],
            weights: vec![0.0; cable_count],
            required: 0.0,
            reachable: 0.0,
            best: vec![0.0; cable_count],
            is_unresisted: false,
        }
    }

    /// Computes everything else from the direction.
    pub(super) fn complete(&mut self, structure_matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits) {
        let dof = self.direction.len();
        let mut size = 0.0_f64;
        for (weight, column) in self.weights.iter_mut().zip(structure_matrix.as_slice().chunks_exact(dof)) {
            let terms = self.direction.iter().zip(column).map(|(y, entry)| y * entry);
            let (sum, largest) = terms.fold((0.0, 0.0_f64), |(sum, most), term| (sum + term, most.max(term.abs())));
            *weight = sum;
            size = size.max(largest);
        }
        let largest = self.weights.iter().fold(0.0_f64, |most, weight| most.max(weight.abs()));
        self.is_unresisted = largest <= ROUNDING * size;
        let amount = |most: f64, y: &f64| most.max(y.abs());
        let factor = if self.is_unresisted { self.direction.iter().fold(0.0, amount) } else { largest };
        self.direction.iter_mut().for_each(|y| *y /= factor);
        self.weights.iter_mut().for_each(|weight| *weight /= factor);
        self.required = self.direction.iter().zip(wrench).map(|(y, w)| -y * w).sum();
        self.reachable = 0.0;
        for (cable, (weight, best)) in self.weights.iter().zip(&mut self.best).enumerate() {
            *best = if *weight > 0.0 { limits.maximum()[cable] } else { limits.minimum()[cable] };
            self.reachable += weight * *best;
        }
    }

    /// Checks the proof from scratch: true when it shows that the load cannot be balanced within the limits.
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
