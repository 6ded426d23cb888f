//! The derivative of tensions that minimize a sum of functions of one cable each.
//!
//! min Σ φᵢ(fᵢ) with Aᵀ f + w = 0: φ′ = A λ for every cable that is on no limit. Differentiated: φ″ df − A dλ = dA λ
//! and Aᵀ df = −dAᵀ f − dw; a cable on its limit stays there.

use nalgebra::{DMatrix, DVector};

use crate::tension::Limits;
use crate::tension::distribute::{Chosen, Derivative, NoDerivative, Written};

/// An optimum with the quantities that its derivatives need.
#[derive(Clone, Debug)]
pub(in crate::tension) struct Optimum {
    tensions: Vec<f64>,
    /// Cables that are on no limit.
    free: Vec<usize>,
    /// λ.
    multipliers: DVector<f64>,
    /// Inverse of \[φ″, −A; Aᵀ, 0\] of the free cables.
    inverse: DMatrix<f64>,
}

/// Newtons of tension per newton of load above which the free cables count as unable to keep the balance.
const LARGEST_GAIN: f64 = 1e9;

impl Optimum {
    /// The balanced tensions nearest to a reference (N); `None` if the free cables cannot balance a small change.
    pub(in crate::tension) fn nearest(
        matrix: &DMatrix<f64>,
        tensions: &[f64],
        free: Vec<usize>,
        reference: &dyn Fn(usize) -> f64,
    ) -> Option<Self> {
        Self::of(matrix, tensions, free, &|cable| (tensions[cable] - reference(cable), 1.0))
    }

    /// The analytic centre; `None` if a cable with a range has its tension on a limit.
    pub(in crate::tension) fn barrier(matrix: &DMatrix<f64>, tensions: &[f64], limits: &Limits) -> Option<Self> {
        let ends = |cable: usize| (limits.minimum()[cable], limits.maximum()[cable]);
        let has_range = |cable: &usize| ends(*cable).1 - ends(*cable).0 > limits.tolerance();
        let free: Vec<usize> = (0..tensions.len()).filter(has_range).collect();
        let distances = |cable: usize| (tensions[cable] - ends(cable).0, ends(cable).1 - tensions[cable]);
        let least = free.iter().map(|&cable| distances(cable).0.min(distances(cable).1)).fold(f64::INFINITY, f64::min);
        if !(least > limits.tolerance()) && !free.is_empty() {
            return None;
        }
        let largest = free.iter().map(|&cable| ends(cable).1 - ends(cable).0).fold(0.0, f64::max);
        // in units of the largest range, in which no curvature is below 2
        Self::of(matrix, tensions, free, &|cable| {
            let (below, above) = (largest / distances(cable).0, largest / distances(cable).1);
            (largest * (above - below), below * below + above * above)
        })
    }

    /// The optimum for this slope and curvature of φ per cable.
    pub(in crate::tension) fn of(
        matrix: &DMatrix<f64>,
        tensions: &[f64],
        free: Vec<usize>,
        slope_and_curvature: &dyn Fn(usize) -> (f64, f64),
    ) -> Option<Self> {
        let (count, n) = (free.len(), matrix.nrows());
        let mut system = DMatrix::zeros(count + n, count + n);
        let mut right = DVector::zeros(count + n);
        for (row, &cable) in free.iter().enumerate() {
            let (slope, curvature) = slope_and_curvature(cable);
            system[(row, row)] = curvature;
            right[row] = curvature * tensions[cable] - slope;
            for axis in 0..n {
                let entry = matrix[(axis, cable)];
                system[(row, count + axis)] = -entry;
                system[(count + axis, row)] = entry;
                right[count + axis] += entry * tensions[cable];
            }
        }
        let inverse = system.try_inverse().filter(|inverse| inverse.rows(0, count).amax() < LARGEST_GAIN)?;
        // the multipliers are those of the quadratic programme with the same slopes, whose optimum these tensions are
        // too
        let multipliers = (&inverse * right).rows(count, n).into_owned();
        Some(Self { tensions: tensions.to_vec(), free, multipliers, inverse })
    }

    fn solved(&self, right: &DVector<f64>) -> DVector<f64> {
        let solution = &self.inverse * right;
        let mut change = DVector::zeros(self.tensions.len());
        self.free.iter().enumerate().for_each(|(row, &cable)| change[cable] = solution[row]);
        change
    }
}

/// Derivative of the tensions nearest to a reference (N), with some cables free and the others on their limits.
pub(in crate::tension) fn nearest(chosen: &Chosen<'_>, free: Vec<usize>, reference: &dyn Fn(usize) -> f64) -> Written {
    let optimum = Optimum::nearest(chosen.problem.structure_matrix, chosen.tensions, free, reference);
    Ok(Some(Box::new(optimum.ok_or(NoDerivative::Pinned)?)))
}

impl Derivative for Optimum {
    fn change(&self, cable: usize, column: &[f64], wrench: &[f64]) -> DVector<f64> {
        let count = self.free.len();
        let mut right = DVector::zeros(self.inverse.nrows());
        let row = self.free.iter().position(|&free| free == cable);
        for (axis, (entry, force)) in column.iter().zip(wrench).enumerate() {
            right[count + axis] = -(entry * self.tensions[cable] + force);
            if let Some(row) = row {
                right[row] += entry * self.multipliers[axis];
            }
        }
        self.solved(&right)
    }

    /// Solves with φ′ of the cable lowered by 1.
    fn change_by_reference(&self, cable: usize) -> DVector<f64> {
        let mut right = DVector::zeros(self.inverse.nrows());
        if let Some(row) = self.free.iter().position(|&free| free == cable) {
            right[row] = 1.0;
        }
        self.solved(&right)
    }
}
