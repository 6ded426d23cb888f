//! Sums of squares, norms and robust losses of residual vectors, with priors.

use nalgebra::DMatrix;

use super::dense::DenseEquations;
use super::descent::{End, System, descend};
use super::unknowns::{Pace, Shape, Unknowns};
use crate::loss::RobustLoss;
use crate::residual::Residual;
use crate::residual::rows::Rows;

/// Searches for better places of what is eliminated from the rows, at most.
const SEARCHES: u32 = 10;

/// Vectors shorter than this have no direction.
const LEAST_NORM: f64 = 1e-12;

/// Costs of all rows of a block and of its priors together.
pub(super) struct Cost<'a> {
    pub(super) residual: &'a mut dyn Residual,
    pub(super) block: usize,
    pub(super) unknowns: &'a Unknowns<'a>,
    pub(super) shape: Shape,
    /// Memory for the rows.
    pub(super) rows: Option<Rows>,
}

impl System for Cost<'_> {
    type Equations = DenseEquations;

    fn write(&mut self, values: &[f64], equations: &mut DenseEquations) -> bool {
        let Self { residual, block, unknowns, shape, rows } = self;
        if *shape != Shape::Square || !residual.normal(*block, values, equations) {
            let rows = rows.get_or_insert_with(|| Rows::new(residual.layout(), values.len()));
            if !residual.write(values, rows) {
                return false;
            }
            match shape {
                Shape::Square => write_squares(rows, equations),
                Shape::Norm(smoothing) => write_norms(rows, *smoothing, equations),
                Shape::Robust(loss) => write_losses(rows, loss, equations),
            }
        }
        unknowns.add_priors(values, equations);
        equations.cost.is_finite()
    }
}

/// Descends in a block by a cost of the norms, and on from better places of what is eliminated.
pub(super) fn descend_in(
    residual: &mut dyn Residual,
    block: usize,
    own: &Unknowns<'_>,
    from: &[f64],
    pace: &Pace,
) -> End {
    residual.restart();
    if let Some(end) = residual.descend(block, from, own, pace) {
        return end;
    }
    let (around, rules) = (own.around(pace.shape == Shape::Square), own.rules(pace));
    let mut cost = Cost { residual, block, unknowns: own, shape: pace.shape, rows: None };
    let mut end = descend(&mut cost, &around, from, DenseEquations::new(from.len()), &rules);
    for _ in 0..SEARCHES {
        if !end.cost.is_finite() || !cost.residual.seek_again(&end.values) {
            break;
        }
        let next = descend(&mut cost, &around, &end.values, DenseEquations::new(from.len()), &rules);
        let trail = end.trail.then(next.trail);
        end = End { iterations: end.iterations + next.iterations, trail, ..next };
    }
    end
}

/// Σ rᵀr, Jᵀr and JᵀJ.
pub(crate) fn write_squares(rows: &Rows, equations: &mut DenseEquations) {
    equations.cost = rows.residuals.norm_squared();
    equations.gradient.gemv_tr(1.0, &rows.jacobian, &rows.residuals, 0.0);
    for j in 0..rows.jacobian.ncols() {
        for i in 0..=j {
            let product = rows.jacobian.column(i).dot(&rows.jacobian.column(j));
            (equations.hessian[(i, j)], equations.hessian[(j, i)]) = (product, product);
        }
    }
}

/// Σ C² ρ(‖r‖²/C²) and half its derivatives, without the second ones of ρ: those of squares with the weights of the place.
///
/// Weighted squares lie above a loss that is concave in ‖r‖² and touch it there (Huber 1981, section 7.8).
fn write_losses(rows: &mut Rows, loss: &RobustLoss, equations: &mut DenseEquations) {
    let mut cost = 0.0;
    for sample in 0..rows.samples() {
        let square = rows.square(sample);
        cost += loss.cost(square);
        rows.scale(sample, loss.weight(square).sqrt());
    }
    write_squares(rows, equations);
    equations.cost = cost;
}

/// Σ (t − μ ln(2 μ t)) with t = μ + √(μ² + ‖r‖²) and half its derivatives, those by r exact.
///
/// It is what the barrier −μ Σ ln(t² − ‖r‖²) makes of min Σ t where ‖r‖ ≤ t, so that the least sum of norms is followed as μ falls; with
/// fewer than 2 μ a sample too much. Sums of norms have kinks where vectors vanish, and their least value is often there.
fn write_norms(rows: &mut Rows, smoothing: f64, equations: &mut DenseEquations) {
    let mut along = DMatrix::zeros(rows.jacobian.ncols(), rows.samples());
    let mut cost = 0.0;
    for sample in 0..rows.samples() {
        let root = smoothing.hypot(rows.square(sample).sqrt());
        let bound = smoothing + root;
        cost += bound - smoothing * (2.0 * smoothing * bound).ln();
        along.set_column(sample, &(rows.gradient(sample) / (bound * root.sqrt())));
        rows.scale(sample, bound.sqrt().recip());
    }
    write_squares(rows, equations);
    equations.cost = cost;
    equations.gradient *= 0.5;
    equations.hessian.gemm(-0.5, &along, &along.transpose(), 0.5);
}

/// Standard deviations of parameters that a sum of norms leads to, from the scatter of what each sample pulls: diag(A⁻¹ B A⁻¹), A the second
/// derivative and B = Σ g gᵀ with g = Jᵀr/‖r‖ (Huber 1967); `None` if A is singular.
pub(crate) fn deviations_of_norms(rows: &Rows) -> Option<Vec<Option<f64>>> {
    let (samples, count) = (rows.samples(), rows.jacobian.ncols());
    let mut pulls = DMatrix::zeros(count, samples);
    for sample in 0..samples {
        let norm = rows.square(sample).sqrt().max(LEAST_NORM);
        pulls.set_column(sample, &(rows.gradient(sample) / norm));
    }
    let mut equations = DenseEquations::new(count);
    write_norms(&mut rows.clone(), LEAST_NORM, &mut equations);
    let inverse = (equations.hessian * 2.0).try_inverse()?;
    // as many samples as the parameters take away tell nothing
    let left = samples as f64 * (1.0 - count as f64 / rows.layout.free_rows() as f64);
    let covariance = &inverse * (&pulls * pulls.transpose()) * &inverse * (samples as f64 / left.max(1.0));
    Some((0..count).map(|k| Some(covariance[(k, k)].max(0.0).sqrt())).collect())
}
