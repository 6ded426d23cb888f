//! Sums of squares, norms and robust losses of residual vectors, with priors.

use nalgebra::DMatrix;

use super::dense::DenseEquations;
use super::vectors::{Stacked, Vectors};
use crate::joint_descent::System;
use crate::loss::RobustLoss;

/// Vectors shorter than this have no direction.
const LEAST_NORM: f64 = 1e-12;

/// Ridge on one parameter.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ridge {
    pub(super) parameter: usize,
    pub(super) centre: f64,
    /// 1/σ².
    pub(super) weight: f64,
}

/// Cost of the norm of a sample's vector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Shape {
    /// ‖r‖².
    Square,
    /// ‖r‖, rounded at zero by so much.
    Norm(f64),
    /// C² ρ(‖r‖²/C²).
    Robust(RobustLoss),
}

/// Costs of all residual vectors and ridges together.
pub(super) struct Cost<'a, V> {
    pub(super) vectors: &'a mut V,
    /// Memory for the vectors.
    pub(super) stacked: Option<Stacked>,
    pub(super) shape: Shape,
    pub(super) ridges: &'a [Ridge],
}

impl<V: Vectors> System for Cost<'_, V> {
    type Equations = DenseEquations;

    fn write(&mut self, values: &[f64], equations: &mut DenseEquations) -> bool {
        if self.shape != Shape::Square || !self.vectors.write_squares(values, equations) {
            let stacked = self.stacked.get_or_insert_with(|| Stacked::new(self.vectors, values.len()));
            if !self.vectors.write(values, stacked) {
                return false;
            }
            match self.shape {
                Shape::Square => write_squares(stacked, equations),
                Shape::Norm(smoothing) => write_norms(stacked, smoothing, equations),
                Shape::Robust(loss) => write_losses(stacked, &loss, equations),
            }
        }
        for ridge in self.ridges {
            let change = values[ridge.parameter] - ridge.centre;
            equations.cost += ridge.weight * change * change;
            equations.gradient[ridge.parameter] += ridge.weight * change;
            equations.hessian[(ridge.parameter, ridge.parameter)] += ridge.weight;
        }
        equations.cost.is_finite()
    }
}

/// Σ rᵀr, Jᵀr and JᵀJ.
pub(super) fn write_squares(stacked: &Stacked, equations: &mut DenseEquations) {
    equations.cost = stacked.residuals.norm_squared();
    equations.gradient.gemv_tr(1.0, &stacked.jacobian, &stacked.residuals, 0.0);
    for j in 0..stacked.jacobian.ncols() {
        for i in 0..=j {
            let product = stacked.jacobian.column(i).dot(&stacked.jacobian.column(j));
            (equations.hessian[(i, j)], equations.hessian[(j, i)]) = (product, product);
        }
    }
}

/// Σ C² ρ(‖r‖²/C²) and half its derivatives, without the second ones of ρ: those of squares with the weights of the place.
///
/// Weighted squares lie above a loss that is concave in ‖r‖² and touch it there (Huber 1981, section 7.8).
fn write_losses(stacked: &mut Stacked, loss: &RobustLoss, equations: &mut DenseEquations) {
    let mut cost = 0.0;
    for sample in 0..stacked.samples() {
        let square = stacked.square(sample);
        cost += loss.cost(square);
        stacked.scale(sample, loss.weight(square).sqrt());
    }
    write_squares(stacked, equations);
    equations.cost = cost;
}

/// Σ (t − μ ln(2 μ t)) with t = μ + √(μ² + ‖r‖²) and half its derivatives, those by r exact.
///
/// It is what the barrier −μ Σ ln(t² − ‖r‖²) makes of min Σ t where ‖r‖ ≤ t, so that the least sum of norms is followed as μ falls; with
/// fewer than 2 μ a sample too much. Sums of norms have kinks where vectors vanish, and their least value is often there.
fn write_norms(stacked: &mut Stacked, smoothing: f64, equations: &mut DenseEquations) {
    let mut along = DMatrix::zeros(stacked.jacobian.ncols(), stacked.samples());
    let mut cost = 0.0;
    for sample in 0..stacked.samples() {
        let root = smoothing.hypot(stacked.square(sample).sqrt());
        let bound = smoothing + root;
        cost += bound - smoothing * (2.0 * smoothing * bound).ln();
        along.set_column(sample, &(stacked.gradient(sample) / (bound * root.sqrt())));
        stacked.scale(sample, bound.sqrt().recip());
    }
    write_squares(stacked, equations);
    equations.cost = cost;
    equations.gradient *= 0.5;
    equations.hessian.gemm(-0.5, &along, &along.transpose(), 0.5);
}

/// Standard deviations of parameters that a sum of norms leads to, from the scatter of what each sample pulls: diag(A⁻¹ B A⁻¹), A the second
/// derivative and B = Σ g gᵀ with g = Jᵀr/‖r‖ (Huber 1967); `None` if A is singular.
pub(super) fn deviations_of_norms(stacked: &Stacked) -> Option<Vec<Option<f64>>> {
    let (samples, count) = (stacked.samples(), stacked.jacobian.ncols());
    let mut pulls = DMatrix::zeros(count, samples);
    for sample in 0..samples {
        let norm = stacked.square(sample).sqrt().max(LEAST_NORM);
        pulls.set_column(sample, &(stacked.gradient(sample) / norm));
    }
    let mut equations = DenseEquations::new(count);
    write_norms(&mut stacked.clone(), LEAST_NORM, &mut equations);
    let inverse = (equations.hessian * 2.0).try_inverse()?;
    // as many samples as the parameters take away tell nothing
    let left = samples as f64 * (1.0 - count as f64 / stacked.free_rows() as f64);
    let covariance = &inverse * (&pulls * pulls.transpose()) * &inverse * (samples as f64 / left.max(1.0));
    Some((0..count).map(|k| Some(covariance[(k, k)].max(0.0).sqrt())).collect())
}
