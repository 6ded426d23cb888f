//! Methods for the least squares of parameters within bounds, by the kind of their steps.

use cdpr_core::solve::bounded::{Room, bounded_step, clamped, stopped};
use nalgebra::{Cholesky, DMatrix, DVector};

use super::{Control, OF_SINGULAR, StepRule};

use crate::reading::keywords;

/// Method for the least squares of parameters. All methods end at the same optimum; they differ in their steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Minimizer {
    /// Damped Gauss–Newton steps (Levenberg 1944, Marquardt 1963), bounds by an active set.
    #[default]
    LevenbergMarquardt,
    /// Gauss–Newton steps, halved until the cost falls; bounds by an active set.
    GaussNewton,
    /// Powell's dogleg in a trust region (Nocedal and Wright 2006, section 4.1), bounds by an active set.
    Dogleg,
    /// Interior steps in a trust region, reflected at bounds (Branch, Coleman and Li 1999).
    TrustRegion,
}

/// Gradient and Gauss–Newton Hessian of a sum of squares.
pub trait NormalSystem {
    /// Half the derivative of the cost by one parameter.
    fn gradient(&self, k: usize) -> f64;

    /// Half the second derivative of the cost by two parameters.
    fn entry(&self, i: usize, j: usize) -> f64;

    /// Half the second derivatives of the cost by parameter `j` and any other.
    #[inline]
    fn column(&self, j: usize) -> impl Fn(usize) -> f64 {
        move |i| self.entry(i, j)
    }

    /// Writes the damped step of the parameters that are not held, zeros for the others; `None` if it is not
    /// determined.
    fn damped(&self, held: &[bool], damping: f64, step: &mut [f64]) -> Option<()>;
}

/// Distances to the bounds, and scales, of the parameters.
#[derive(Clone, Copy)]
pub struct Surroundings<'a> {
    /// Differences to the lower and upper bound of each parameter.
    pub room: &'a [Room],
    /// Scale of each parameter: the length that one unit of it corresponds to (m).
    pub scale: &'a [f64],
}

keywords!(Minimizer: LevenbergMarquardt = "levenberg-marquardt", GaussNewton = "gauss-newton", Dogleg = "dogleg", TrustRegion = "trust-region");

impl Minimizer {
    /// Rule by which the descent loop shortens the method's steps.
    pub fn rule(self) -> StepRule {
        match self {
            Self::LevenbergMarquardt => StepRule::Damping,
            Self::GaussNewton => StepRule::Shortening,
            Self::Dogleg | Self::TrustRegion => StepRule::TrustRegion,
        }
    }

    /// Writes the method's step within the bounds. Returns true if a trust region or a bound shortened it, `None` if
    /// the equations do not determine it. `held` is scratch memory.
    #[inline]
    pub fn step(
        self,
        system: &impl NormalSystem,
        around: Surroundings<'_>,
        control: &Control<f64>,
        held: &mut [bool],
        step: &mut [f64],
    ) -> Option<bool> {
        let gradient = |k: usize| system.gradient(k);
        match self {
            Self::LevenbergMarquardt => {
                let damped = |held: &[bool], step: &mut [f64]| system.damped(held, control.damping, step);
                bounded_step(gradient, around.room, held, step, damped)?;
                clamped(around.room, step);
                Some(false)
            }
            Self::GaussNewton => {
                bounded_step(gradient, around.room, held, step, |held, step| newton(system, held, step))?;
                Some(stopped(around.room, step))
            }
            Self::Dogleg => {
                bounded_step(gradient, around.room, held, step, |held, step| newton(system, held, step))?;
                let is_cut = dogleg(system, around.scale, control.radius, held, step);
                Some(stopped(around.room, step) || is_cut)
            }
            Self::TrustRegion => reflective(system, around, control.radius, step),
        }
    }

    /// Predicted decrease of the cost by a step, as a fraction of the cost.
    pub fn gain(self, system: &impl NormalSystem, step: &[f64], cost: f64) -> f64 {
        let slope = -step.iter().enumerate().map(|(k, step)| step * system.gradient(k)).sum::<f64>();
        if self.rule() != StepRule::TrustRegion {
            // 2 · slope − bend, and both are equal for a whole step
            return slope / cost;
        }
        let along = |i: usize| step.iter().enumerate().map(|(j, step)| step * system.entry(i, j)).sum::<f64>();
        let bend: f64 = step.iter().enumerate().map(|(i, step)| step * along(i)).sum();
        (2.0 * slope - bend) / cost
    }
}

/// Writes the Gauss–Newton step, regularized if some directions are not determined.
fn newton(system: &impl NormalSystem, held: &[bool], step: &mut [f64]) -> Option<()> {
    [0.0, OF_SINGULAR, 1e3 * OF_SINGULAR].into_iter().find_map(|damping| system.damped(held, damping, step))
}

/// Size of a step: its largest entry in scaled units (m).
pub fn size(step: &[f64], scale: &[f64]) -> f64 {
    step.iter().zip(scale).map(|(step, scale)| (step * scale).abs()).fold(0.0, f64::max)
}

/// Shortens the Gauss–Newton step to the point on the border of the trust region along Powell's dogleg, by the minimum
/// along the gradient. Returns false if the step is inside the region.
fn dogleg(system: &impl NormalSystem, scale: &[f64], radius: f64, held: &[bool], step: &mut [f64]) -> bool {
    if size(step, scale) <= radius {
        return false;
    }
    let count = step.len();
    // the gradient direction, in metres
    let down = |k: usize| if held[k] { 0.0 } else { -system.gradient(k) / (scale[k] * scale[k]) };
    let slope: f64 = (0..count).map(|k| -system.gradient(k) * down(k)).sum();
    let along = |i: usize| (0..count).map(|j| system.entry(i, j) * down(j)).sum::<f64>();
    let bend: f64 = (0..count).map(|i| down(i) * along(i)).sum();
    let cauchy: Vec<f64> = (0..count).map(|k| slope / bend * down(k)).collect();
    let length = size(&cauchy, scale);
    if !(length < radius) {
        (0..count).for_each(|k| step[k] = cauchy[k] * (radius / length));
        return true;
    }
    let at = |step_fraction: f64| -> Vec<f64> {
        (0..count).map(|k| cauchy[k] + step_fraction * (step[k] - cauchy[k])).collect()
    };
    let (mut inside, mut outside) = (0.0, 1.0);
    for _ in 0..50 {
        let middle = 0.5 * (inside + outside);
        *(if size(&at(middle), scale) <= radius { &mut inside } else { &mut outside }) = middle;
    }
    step.copy_from_slice(&at(inside));
    true
}

/// Largest fraction of the distance to a bound in one step, so that the search stays inside.
const INSIDE: f64 = 0.995;

/// Quadratic model of the cost in metres; its Hessian has a term that keeps steps off the bounds towards which the
/// gradient points.
struct Quadratic {
    gradient: DVector<f64>,
    hessian: DMatrix<f64>,
    room: Vec<Room>,
}

impl Quadratic {
    fn new(system: &impl NormalSystem, around: Surroundings<'_>) -> Self {
        let Surroundings { room, scale } = around;
        let count = scale.len();
        let gradient = DVector::from_fn(count, |k, _| system.gradient(k) / scale[k]);
        let room: Vec<Room> = room.iter().zip(scale).map(|((low, high), scale)| (low * scale, high * scale)).collect();
        let mut hessian = DMatrix::from_fn(count, count, |i, j| system.entry(i, j) / (scale[i] * scale[j]));
        let plain = Self { gradient, hessian: DMatrix::zeros(0, 0), room };
        for k in 0..count {
            let distance = plain.distance(k);
            if distance.is_finite() {
                hessian[(k, k)] += plain.gradient[k].abs() / distance.max(f64::MIN_POSITIVE);
            }
        }
        Self { hessian, ..plain }
    }

    /// Distance to the bound towards which the negative gradient points (m).
    fn distance(&self, k: usize) -> f64 {
        if self.gradient[k] < 0.0 { self.room[k].1 } else { -self.room[k].0 }
    }

    fn value(&self, step: &DVector<f64>) -> f64 {
        self.gradient.dot(step) + 0.5 * step.dot(&(&self.hessian * step))
    }

    /// The minimum within the trust region: (H + λ I) step = −g with the least λ for which the step fits; true if λ is
    /// above 0.
    fn within(&self, radius: f64) -> Option<(DVector<f64>, bool)> {
        let unit = self.hessian.diagonal().max();
        let at = |lambda: f64| {
            let mut matrix = self.hessian.clone();
            (0..matrix.nrows()).for_each(|k| matrix[(k, k)] += lambda * unit);
            let found = Cholesky::new(matrix).map(|factor| -factor.solve(&self.gradient));
            found.filter(|step| step.amax().is_finite())
        };
        let plain = [0.0, OF_SINGULAR, 1e3 * OF_SINGULAR].into_iter().find_map(at)?;
        if plain.amax() <= radius {
            return Some((plain, false));
        }
        // the length falls with λ: bisection on its logarithm, until the length is near the region's radius
        let (mut long, mut short) = (1e-16_f64, 1e16_f64);
        for _ in 0..100 {
            let middle = (long * short).sqrt();
            match at(middle) {
                Some(step) if step.amax() <= radius && step.amax() > 0.9 * radius => return Some((step, true)),
                Some(step) if step.amax() <= radius => short = middle,
                _ => long = middle,
            }
        }
        at(short).map(|step| (step, true))
    }

    /// The minimum along the negative gradient, scaled by the distances to the bounds, inside region and bounds.
    fn downhill(&self, radius: f64) -> DVector<f64> {
        let down = DVector::from_fn(self.gradient.len(), |k, _| -self.gradient[k] * self.distance(k).min(1.0));
        let bend = down.dot(&(&self.hessian * &down));
        let (bound, _) = self.first_bound(&DVector::zeros(down.len()), &down);
        let least = -self.gradient.dot(&down) / bend;
        let step_fraction = least.min(radius / down.amax()).min(INSIDE * bound);
        if step_fraction.is_finite() { down * step_fraction } else { down * 0.0 }
    }

    /// Fraction of a step at which it meets its first bound, and the parameter that meets it.
    fn first_bound(&self, from: &DVector<f64>, step: &DVector<f64>) -> (f64, usize) {
        let step_fraction = |k: usize| {
            let bound = if step[k] < 0.0 { self.room[k].0 } else { self.room[k].1 };
            if step[k] == 0.0 { f64::INFINITY } else { ((bound - from[k]) / step[k]).max(0.0) }
        };
        (0..step.len()).map(|k| (step_fraction(k), k)).fold((f64::INFINITY, 0), |a, b| if b.0 < a.0 { b } else { a })
    }
}

/// Writes the best interior step by the quadratic model: the one that stops before the first bound, the one reflected
/// there, or the one along the negative gradient, which leads away from bounds towards which only other parameters
/// lead.
fn reflective(system: &impl NormalSystem, around: Surroundings<'_>, radius: f64, step: &mut [f64]) -> Option<bool> {
    let model = Quadratic::new(system, around);
    let (wanted, is_limited) = model.within(radius)?;
    let start = DVector::zeros(step.len());
    let (step_fraction, hit) = model.first_bound(&start, &wanted);
    let best = if step_fraction > 1.0 {
        wanted.clone()
    } else {
        let mut back = &wanted * (1.0 - step_fraction);
        back[hit] = -back[hit];
        let corner = &wanted * step_fraction;
        let (second, _) = model.first_bound(&corner, &back);
        let reflected = corner + back * (INSIDE * second.min(1.0));
        let candidates = [&wanted * (INSIDE * step_fraction), reflected, model.downhill(radius)];
        let [first, others @ ..] = candidates;
        others.into_iter().fold(first, |a, b| if model.value(&b) < model.value(&a) { b } else { a })
    };
    step.iter_mut().zip(best.iter().zip(around.scale)).for_each(|(step, (best, scale))| *step = best / scale);
    // near a bound, steps of the model end just before it: a difference of a tenth does not count
    Some(is_limited || (&best - &wanted).amax() > 0.1 * wanted.amax())
}
