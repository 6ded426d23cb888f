//! The least largest norm of all residual vectors (eq. 3.10), with the proof that it is the least.
//!
//! min over p and s of s where ‖r_j(p)‖² ≤ s for every sample j: an interior-point method (Boyd and Vandenberghe 2004, section 11.3). At a weight μ of
//! the barrier −μ Σ ln(s − ‖r_j‖²) the best s of any p makes the multipliers λ_j = μ/(s − ‖r_j‖²) sum to one, which leaves a smooth function of p
//! alone: no step is too long for the barrier, and no slack is below μ. Where it is least Σ λ_j ∂‖r_j‖²/∂p = 0, and s lies above the least by μ for each
//! sample and bound at most among all p near it where Σ λ_j ‖r_j‖² is convex.

use nalgebra::{Cholesky, DMatrix, DVector};

use super::bends::Bends;
use super::vectors::{Stacked, Vectors};
use cdpr_model::robot::Parameter;

/// Gap at the end, relative to the largest square.
pub(super) const GAP: f64 = 1e-8;
/// Factor of the barrier's weight from one centre to the next.
const SHRINK: f64 = 0.1;
/// Most Newton steps to a centre.
const STEPS: u32 = 60;
/// Newton steps to a centre after which the bends of vectors are taken, to follow them.
const PATIENCE: u32 = 8;
/// Multiplier from which on a sample holds the bound up.
const HOLDING: f64 = 1e-3;
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
#[derive(Clone, Debug, PartialEq)]
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
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ActiveSample {
    /// Number of the sample, from 1.
    pub sample: usize,
    /// λ.
    pub multiplier: f64,
}

struct Barrier<'a, V> {
    vectors: &'a mut V,
    parameters: &'a [Parameter],
    /// Metres that one unit of each parameter is worth.
    scale: &'a [f64],
    stacked: Stacked,
    /// Memory for the same, each sample weighted by its slack.
    weighted: Stacked,
    bends: Bends,
    /// s − ‖r‖² of each sample where the merit was last asked.
    slacks: Vec<f64>,
    /// The largest ‖r‖² there.
    largest: f64,
}

/// Finds it from these values; `None` if they have no residuals.
pub(super) fn minimise<V: Vectors>(
    vectors: &mut V,
    parameters: &[Parameter],
    scale: &[f64],
    from: &[f64],
    max_iterations: u32,
) -> Option<Minimax> {
    let mut barrier = Barrier::new(vectors, parameters, scale);
    let mut values = barrier.inside(from);
    let start = barrier.largest_square(&values)?;
    barrier.largest = start;
    let constraints = (barrier.stacked.samples() + parameters.len()) as f64;
    let mut weight = 0.1 * start / constraints + f64::MIN_POSITIVE;
    let (mut history, mut iterations) = (vec![start.sqrt()], 0);
    let mut converged = start == 0.0;
    while !converged && iterations < max_iterations {
        let (centred, steps) = barrier.centre(&mut values, weight)?;
        iterations += steps;
        history.push(barrier.largest.sqrt());
        if constraints * weight <= GAP * barrier.largest {
            converged = centred;
            break;
        }
        if centred {
            barrier.follow(&mut values, weight)?;
        }
        weight *= SHRINK;
    }
    let gap = if converged { constraints * weight / barrier.largest } else { f64::NAN };
    let certificate = barrier.certificate(&values, gap)?;
    Some(Minimax { values, history, iterations, converged, certificate })
}

impl<'a, V: Vectors> Barrier<'a, V> {
    fn new(vectors: &'a mut V, parameters: &'a [Parameter], scale: &'a [f64]) -> Self {
        let stacked = Stacked::new(vectors, parameters.len());
        let slacks = vec![0.0; stacked.samples()];
        let (weighted, bends) = (stacked.clone(), Bends::default());
        Self { vectors, parameters, scale, stacked, weighted, bends, slacks, largest: f64::NAN }
    }

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

    /// Newton steps to the centre of a weight: whether it is reached, and their number.
    fn centre(&mut self, values: &mut Vec<f64>, weight: f64) -> Option<(bool, u32)> {
        let from = self.largest;
        let mut merit = self.merit(values, (from, weight))?;
        for step_count in 0..STEPS {
            if step_count > 0 && step_count % PATIENCE == 0 {
                self.bend(values, weight);
            }
            let (gradient, hessian) = self.derivatives(values, weight);
            let step = self.newton(&gradient, hessian)?;
            let decrement = -gradient.dot(&step);
            if !(decrement > CENTRED) {
                return Some((true, step_count));
            }
            let mut fraction = 1.0;
            loop {
                let trial = self.moved(values, &step, fraction);
                match self.merit(&trial, (from, weight)) {
                    Some(reached) if reached < merit - 1e-4 * fraction * decrement => {
                        (*values, merit) = (trial, reached);
                        break;
                    }
                    _ if fraction * decrement.min(1.0) < 1e-6 => {
                        self.merit(values, (from, weight))?;
                        // only rounding is left of the slacks
                        return Some((decrement < 1.0, step_count));
                    }
                    _ => fraction *= 0.5,
                }
            }
        }
        Some((false, STEPS))
    }

    /// Goes from a centre along the tangent of all centres to where the next one is expected, if that is better than to stay.
    fn follow(&mut self, values: &mut Vec<f64>, weight: f64) -> Option<()> {
        let (mut gradient, hessian) = self.derivatives(values, weight);
        gradient.fill(0.0);
        gradient[values.len()] = (1.0 - SHRINK) / weight;
        let step = self.newton(&gradient, hessian)?;
        let (trial, at) = (self.moved(values, &step, 1.0), (self.largest, SHRINK * weight));
        let stay = self.merit(values, at)?;
        if self.merit(&trial, at).is_some_and(|reached| reached < stay) {
            *values = trial;
        }
        Some(())
    }

    /// Takes the bends of the samples that hold the bound up where the merit was last asked.
    fn bend(&mut self, values: &[f64], weight: f64) {
        let Self { vectors, parameters, scale, stacked, weighted, bends, slacks, .. } = self;
        let samples = (0..slacks.len()).filter(|&sample| slacks[sample] * HOLDING < weight);
        let found = Bends::of(*vectors, parameters, scale, values, stacked, samples, weighted);
        *bends = found.unwrap_or_default();
    }

    /// The Newton step with as much of the bends as leaves the Hessian positive.
    fn newton(&self, gradient: &DVector<f64>, hessian: DMatrix<f64>) -> Option<DVector<f64>> {
        if !self.bends.is_empty() {
            let count = self.parameters.len();
            let bent = self.bends.sum(count, |sample| 2.0 / self.slacks[sample]);
            for share in [1.0, 0.5, 0.25, 0.1] {
                let mut whole = hessian.clone();
                let mut corner = whole.view_mut((0, 0), (count, count));
                corner += &bent * share;
                if let Some(step) = newton(gradient, whole, &[0.0]) {
                    return Some(step);
                }
            }
        }
        newton(gradient, hessian, &[1e-15, 1e-13, 1e-11, 1e-9])
    }

    fn moved(&self, values: &[f64], step: &DVector<f64>, fraction: f64) -> Vec<f64> {
        let value = |((value, scale), step): ((&f64, &f64), &f64)| value + fraction * step / scale;
        values.iter().zip(self.scale).zip(step.iter()).map(value).collect()
    }

    /// (s − s₀)/μ − Σ ln(s − ‖r‖²) − Σ ln of the room to the bounds at the best s; nothing outside. s₀ keeps the digits that s/μ would take.
    fn merit(&mut self, values: &[f64], (from, weight): (f64, f64)) -> Option<f64> {
        let mut merit = 0.0;
        for (parameter, value) in self.parameters.iter().zip(values) {
            let (low, high) = parameter.bounds();
            for room in [value - low, high - value].into_iter().filter(|room| room.is_finite()) {
                (room > 0.0).then_some(())?;
                merit -= room.ln();
            }
        }
        self.largest = self.largest_square(values)?;
        for (sample, slack) in self.slacks.iter_mut().enumerate() {
            *slack = self.largest - self.stacked.square(sample);
        }
        let above = above_the_largest(&self.slacks, weight);
        self.slacks.iter_mut().for_each(|slack| *slack += above);
        let of_slacks: f64 = self.slacks.iter().map(|slack| slack.ln()).sum();
        Some(merit + (self.largest - from + above) / weight - of_slacks)
    }

    /// Gradient and Gauss–Newton Hessian of the merit where it was last asked, parameters in metres, then s.
    fn derivatives(&mut self, values: &[f64], weight: f64) -> (DVector<f64>, DMatrix<f64>) {
        let (count, samples) = (self.parameters.len(), self.stacked.samples());
        self.weighted.clone_from(&self.stacked);
        let mut of_squares = DMatrix::zeros(count + 1, samples);
        for sample in 0..samples {
            let slack = self.slacks[sample];
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
        for (k, (parameter, value)) in self.parameters.iter().zip(values).enumerate() {
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

    fn certificate(&self, values: &[f64], gap: f64) -> Option<Certificate> {
        let (stacked, slacks, largest) = (&self.stacked, &self.slacks, self.largest);
        let sum: f64 = slacks.iter().map(|slack| slack.recip()).sum();
        let is_free = |k: usize| {
            let ((low, high), near) = (self.parameters[k].bounds(), 1e-6 / self.scale[k]);
            values[k] - low > near && high - values[k] > near
        };
        let free: Vec<usize> = (0..self.parameters.len()).filter(|&k| is_free(k)).collect();
        let gradient = |sample: usize| {
            let whole = stacked.gradient(sample);
            DVector::from_iterator(free.len(), free.iter().map(|&k| whole[k] / self.scale[k]))
        };
        let samples: Vec<usize> =
            (0..stacked.samples()).filter(|&sample| stacked.square(sample).sqrt() >= ACTIVE * largest.sqrt()).collect();
        let gradients: Vec<DVector<f64>> = samples.iter().map(|&sample| gradient(sample)).collect();
        let of_barrier = || samples.iter().map(|&sample| slacks[sample].recip() / sum).collect();
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

/// Height of the best bound above the largest square: at these slacks of that square it makes multipliers sum to one.
fn above_the_largest(slacks: &[f64], weight: f64) -> f64 {
    // the sum falls and bends upward: Newton steps from below stay below, until rounding ends them
    let mut above = weight;
    loop {
        let sums = slacks.iter().fold((0.0, 0.0), |(sum, slope), slack| {
            let multiplier = weight / (slack + above);
            (sum + multiplier, slope + multiplier * multiplier)
        });
        let next = above + weight * (sums.0 - 1.0) / sums.1;
        if !(next > above * (1.0 + 1e-15)) {
            return above;
        }
        above = next;
    }
}

/// Weights from 0 that sum to one and make the weighted sum of gradients the least; `None` if the least has weights below 0.
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
fn newton(gradient: &DVector<f64>, hessian: DMatrix<f64>, ridges: &[f64]) -> Option<DVector<f64>> {
    let count = gradient.len();
    let scale: Vec<f64> =
        (0..count).map(|k| if hessian[(k, k)] > 0.0 { hessian[(k, k)].sqrt().recip() } else { 0.0 }).collect();
    ridges.iter().find_map(|ridge| {
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
