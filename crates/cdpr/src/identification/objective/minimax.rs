//! The least largest norm of all residual vectors (eq. 3.10), with the proof that it is the least.
//!
//! min over p and s of s where ‖r_j(p)‖² ≤ s for every sample j: an interior-point method (Boyd and Vandenberghe 2004, section 11.3). At a weight μ of
//! the barrier −μ Σ ln(s − ‖r_j‖²) the multipliers λ_j = μ/(s − ‖r_j‖²) sum to one, Σ λ_j ∂‖r_j‖²/∂p = 0, and s lies above the least by μ for each
//! sample and bound at most where the vectors are linear.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::vectors::{Stacked, Vectors};
use crate::robot::Parameter;

/// Gap at the end, relative to the largest square.
pub(super) const GAP: f64 = 1e-8;
/// Factor of the barrier's weight from one centre to the next.
const SHRINK: f64 = 0.1;
/// Most Newton steps to a centre.
const STEPS: u32 = 60;
/// Newton's decrement, squared, at a centre: what is left adds this share of one sample's part of the gap.
const CENTRED: f64 = 1e-4;
/// Share of the largest norm from which on a sample holds it up.
const ACTIVE: f64 = 1.0 - 1e-5;

/// The least largest norm.
#[derive(Clone, Debug)]
pub(super) struct Minimax {
    pub(super) values: Vec<f64>,
    /// The largest norm at each centre.
    pub(super) history: Vec<f64>,
    pub(super) iterations: u32,
    pub(super) converged: bool,
    pub(super) certificate: Certificate,
}

/// Samples whose norms no change of the parameters makes smaller together.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct Certificate {
    /// The largest norm.
    pub largest: f64,
    /// Samples (from 1) that have it, with their multipliers, which sum to one over all samples.
    pub active: Vec<ActiveSample>,
    /// ‖Σ λ ∂‖r‖²/∂p‖/Σ λ ‖∂‖r‖²/∂p‖: 0 where nothing makes all of them smaller to first order.
    pub subgradient: f64,
    /// Bound of what the largest norm lies above the least near here, relative; not a number where the search did not end there.
    pub gap: f64,
}

/// A sample that holds the largest norm up.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct ActiveSample {
    /// Number of the sample, from 1.
    pub sample: usize,
    /// λ.
    pub multiplier: f64,
}

/// Parameters and the bound s of all squares.
#[derive(Clone)]
struct Point {
    values: Vec<f64>,
    bound: f64,
}

struct Barrier<'a, V> {
    vectors: &'a mut V,
    parameters: &'a [Parameter],
    /// Metres that one unit of each parameter is worth.
    scale: &'a [f64],
    stacked: Stacked,
    /// Memory for the same, each sample weighted by its slack.
    weighted: Stacked,
}

/// Finds it from these values; nothing where they have no residuals.
pub(super) fn minimise<V: Vectors>(
    vectors: &mut V,
    parameters: &[Parameter],
    scale: &[f64],
    from: &[f64],
    max_iterations: u32,
) -> Option<Minimax> {
    let stacked = Stacked::new(vectors, parameters.len());
    let mut barrier = Barrier { vectors, parameters, scale, weighted: stacked.clone(), stacked };
    let values = barrier.inside(from);
    let largest = barrier.largest_square(&values)?;
    let mut point = Point { values, bound: 1.2 * largest + f64::MIN_POSITIVE };
    let constraints = (barrier.stacked.samples() + parameters.len()) as f64;
    let mut weight = 0.1 * point.bound / constraints;
    let (mut history, mut iterations) = (vec![largest.sqrt()], 0);
    let mut converged = largest == 0.0;
    while !converged && iterations < max_iterations {
        let (centred, steps) = barrier.centre(&mut point, weight)?;
        iterations += steps;
        history.push(barrier.largest_square(&point.values)?.sqrt());
        if constraints * weight <= GAP * point.bound {
            converged = centred;
            break;
        }
        weight *= SHRINK;
    }
    let gap = if converged { constraints * weight / point.bound } else { f64::NAN };
    let certificate = barrier.certificate(&point, gap)?;
    Some(Minimax { values: point.values, history, iterations, converged, certificate })
}

impl<V: Vectors> Barrier<'_, V> {
    /// Values moved off the bounds that they lie on.
    fn inside(&self, from: &[f64]) -> Vec<f64> {
        let moved = |((parameter, &value), scale): ((&Parameter, &f64), &f64)| {
            let ((low, high), least) = (parameter.bounds(), 1e-6 / scale);
            value.max(low + least).min(high - least)
        };
        self.parameters.iter().zip(from).zip(self.scale).map(moved).collect()
    }

    /// The largest square of a norm at these values.
    fn largest_square(&mut self, values: &[f64]) -> Option<f64> {
        let is_finite = self.vectors.write(values, &mut self.stacked);
        is_finite.then(|| (0..self.stacked.samples()).map(|sample| self.stacked.square(sample)).fold(0.0, f64::max))
    }

    /// Newton steps to the centre of a weight; whether it is reached, and their number.
    fn centre(&mut self, point: &mut Point, weight: f64) -> Option<(bool, u32)> {
        let from = point.bound;
        let mut merit = self.merit(point, (from, weight))?;
        for step_count in 0..STEPS {
            let (gradient, hessian) = self.derivatives(point, weight);
            let step = newton(&gradient, hessian)?;
            let decrement = -gradient.dot(&step);
            if !(decrement > CENTRED) {
                return Some((true, step_count));
            }
            let mut fraction = 1.0;
            loop {
                let trial = self.moved(point, &step, fraction);
                match self.merit(&trial, (from, weight)) {
                    Some(reached) if reached < merit - 1e-4 * fraction * decrement => {
                        (*point, merit) = (trial, reached);
                        break;
                    }
                    _ if fraction < 1e-10 => {
                        self.merit(point, (from, weight))?;
                        // only rounding is left of the slacks
                        return Some((decrement < 1.0, step_count));
                    }
                    _ => fraction *= 0.5,
                }
            }
        }
        Some((false, STEPS))
    }

    fn moved(&self, point: &Point, step: &DVector<f64>, fraction: f64) -> Point {
        let value = |((value, scale), step): ((&f64, &f64), &f64)| value + fraction * step / scale;
        let values = point.values.iter().zip(self.scale).zip(step.iter()).map(value).collect();
        Point { values, bound: point.bound + fraction * step[point.values.len()] }
    }

    /// (s − s₀)/μ − Σ ln(s − ‖r‖²) − Σ ln of the room to the bounds; nothing outside. s₀ keeps the digits that s/μ would take.
    fn merit(&mut self, point: &Point, (from, weight): (f64, f64)) -> Option<f64> {
        let mut merit = (point.bound - from) / weight;
        for (parameter, value) in self.parameters.iter().zip(&point.values) {
            let (low, high) = parameter.bounds();
            for room in [value - low, high - value].into_iter().filter(|room| room.is_finite()) {
                (room > 0.0).then_some(())?;
                merit -= room.ln();
            }
        }
        self.vectors.write(&point.values, &mut self.stacked).then_some(())?;
        for sample in 0..self.stacked.samples() {
            let slack = point.bound - self.stacked.square(sample);
            (slack > 0.0).then_some(())?;
            merit -= slack.ln();
        }
        Some(merit)
    }

    /// Gradient and Gauss–Newton Hessian of the merit where it was last asked, parameters in metres, then s.
    fn derivatives(&mut self, point: &Point, weight: f64) -> (DVector<f64>, DMatrix<f64>) {
        let (count, samples) = (self.parameters.len(), self.stacked.samples());
        self.weighted.clone_from(&self.stacked);
        let mut of_squares = DMatrix::zeros(count + 1, samples);
        for sample in 0..samples {
            let slack = point.bound - self.stacked.square(sample);
            let gradient = self.stacked.gradient(sample) * (2.0 / slack);
            of_squares.view_mut((0, sample), (count, 1)).copy_from(&gradient);
            of_squares[(count, sample)] = -1.0 / slack;
            self.weighted.scale(sample, (2.0 / slack).sqrt());
        }
        // the derivative of −ln(s − ‖r‖²) is its column, the outer product of which is one part of the second
        let mut gradient = of_squares.column_sum();
        gradient[count] += 1.0 / weight;
        let mut hessian = &of_squares * of_squares.transpose();
        let mut corner = hessian.view_mut((0, 0), (count, count));
        corner.gemm_tr(1.0, &self.weighted.jacobian, &self.weighted.jacobian, 1.0);
        for (k, (parameter, value)) in self.parameters.iter().zip(&point.values).enumerate() {
            let (low, high) = parameter.bounds();
            let (below, above) = (1.0 / (value - low), 1.0 / (high - value));
            gradient[k] += above - below;
            hessian[(k, k)] += below * below + above * above;
        }
        for k in 0..count {
            gradient[k] /= self.scale[k];
            hessian.row_mut(k).scale_mut(self.scale[k].recip());
            hessian.column_mut(k).scale_mut(self.scale[k].recip());
        }
        (gradient, hessian)
    }

    fn certificate(&mut self, point: &Point, gap: f64) -> Option<Certificate> {
        let largest = self.largest_square(&point.values)?;
        let stacked = &self.stacked;
        let slack = |sample: usize| point.bound - stacked.square(sample);
        let sum: f64 = (0..stacked.samples()).map(|sample| slack(sample).recip()).sum();
        let is_free = |k: usize| {
            let ((low, high), near) = (self.parameters[k].bounds(), 1e-6 / self.scale[k]);
            point.values[k] - low > near && high - point.values[k] > near
        };
        let free: Vec<usize> = (0..self.parameters.len()).filter(|&k| is_free(k)).collect();
        let gradient = |sample: usize| {
            let whole = stacked.gradient(sample);
            DVector::from_iterator(free.len(), free.iter().map(|&k| whole[k] / self.scale[k]))
        };
        let samples: Vec<usize> =
            (0..stacked.samples()).filter(|&sample| stacked.square(sample).sqrt() >= ACTIVE * largest.sqrt()).collect();
        let gradients: Vec<DVector<f64>> = samples.iter().map(|&sample| gradient(sample)).collect();
        let of_barrier = || samples.iter().map(|&sample| slack(sample).recip() / sum).collect();
        let multipliers = least_sum(&gradients).unwrap_or_else(of_barrier);
        let pairs = || gradients.iter().zip(&multipliers);
        let total = pairs().fold(DVector::zeros(free.len()), |total, (gradient, weight)| total + gradient * *weight);
        let sizes: f64 = pairs().map(|(gradient, weight)| weight * gradient.norm()).sum();
        let subgradient = if sizes > 0.0 { total.norm() / sizes } else { 0.0 };
        let active = samples.iter().zip(&multipliers);
        let active = active.map(|(sample, multiplier)| ActiveSample { sample: sample + 1, multiplier: *multiplier });
        Some(Certificate { largest: largest.sqrt(), active: active.collect(), subgradient, gap: 0.5 * gap })
    }
}

/// Weights from 0 that sum to one and make the weighted sum of gradients the least; nothing where the least has weights below 0.
fn least_sum(gradients: &[DVector<f64>]) -> Option<Vec<f64>> {
    let count = gradients.len();
    let products = DMatrix::from_fn(count, count, |i, j| gradients[i].dot(&gradients[j]));
    let ridge = 1e-14 * products.trace();
    let factor = Cholesky::new(products + DMatrix::identity(count, count) * ridge)?;
    let weights = factor.solve(&DVector::repeat(count, 1.0));
    let weights = &weights / weights.sum();
    weights.iter().all(|weight| *weight >= 0.0).then(|| weights.iter().copied().collect())
}

/// −H⁻¹ g, columns scaled to a unit diagonal, with a ridge of rounding's size for directions that nothing determines.
fn newton(gradient: &DVector<f64>, hessian: DMatrix<f64>) -> Option<DVector<f64>> {
    let count = gradient.len();
    let scale: Vec<f64> =
        (0..count).map(|k| if hessian[(k, k)] > 0.0 { hessian[(k, k)].sqrt().recip() } else { 0.0 }).collect();
    [1e-15, 1e-13, 1e-11, 1e-9].into_iter().find_map(|ridge| {
        let scaled = DMatrix::from_fn(count, count, |i, j| match i == j {
            true => 1.0 + ridge,
            false => hessian[(i, j)] * scale[i] * scale[j],
        });
        let right = DVector::from_fn(count, |k, _| -gradient[k] * scale[k]);
        let mut step = Cholesky::new(scaled)?.solve(&right);
        (0..count).for_each(|k| step[k] *= scale[k]);
        step.iter().all(|entry| entry.is_finite()).then_some(step)
    })
}

impl Certificate {
    /// The same with the largest norm in metres, of vectors whose unit is so many.
    pub(super) fn in_metres(self, unit: Option<f64>) -> Self {
        Self { largest: self.largest * unit.unwrap_or(1.0), ..self }
    }
}
