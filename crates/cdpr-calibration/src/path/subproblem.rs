//! Least value of a quadratic function with penalties on norms of groups, within bounds.

use nalgebra::{Cholesky, DMatrix, DVector, SymmetricEigen};

use crate::minimize::dense::DenseEquations;

/// Most rounds of sweeps and Newton steps; the set of groups that are not zero seldom takes five to settle.
const ROUNDS: usize = 200;
/// Share of the diagonal that makes matrices of collinear parameters regular, and what it grows by.
const RIDGE: (f64, f64) = (1e-10, 1e3);
/// Most halvings of a step or of an interval of norms: to rounding.
const HALVINGS: usize = 60;

/// Parameters that are penalised together by the norm of their changes.
#[derive(Clone, Debug)]
pub(super) struct Group {
    pub(super) members: Vec<usize>,
    /// Factor of λ; 0 without penalty.
    pub(super) weight: f64,
}

/// Quadratic function of d beside Σ λ weight ‖z‖ of groups of z = at + d.
pub(super) struct Subproblem<'a> {
    pub(super) quadratic: &'a DenseEquations,
    pub(super) at: &'a DVector<f64>,
    pub(super) groups: &'a [Group],
    pub(super) lambda: f64,
    pub(super) bounds: &'a [(f64, f64)],
}

impl Group {
    /// λ times the weight; 0 without penalty, whatever λ.
    fn strength(&self, lambda: f64) -> f64 {
        if self.weight > 0.0 { lambda * self.weight } else { 0.0 }
    }

    pub(super) fn norm(&self, z: &DVector<f64>) -> f64 {
        self.members.iter().map(|&k| z[k] * z[k]).sum::<f64>().sqrt()
    }

    /// Penalty; 0 for 0, even times infinity.
    pub(super) fn penalty(&self, lambda: f64, z: &DVector<f64>) -> f64 {
        let norm = self.norm(z);
        if norm > 0.0 { self.strength(lambda) * norm } else { 0.0 }
    }

    /// Distance of a gradient of the smooth part from the condition of the least value (Karush, Kuhn and Tucker).
    pub(super) fn violation(
        &self,
        lambda: f64,
        z: &DVector<f64>,
        gradient: &DVector<f64>,
        bounds: &[(f64, f64)],
    ) -> f64 {
        let (strength, norm) = (self.strength(lambda), self.norm(z));
        let is_held = |k: usize, pull: f64| (z[k] <= bounds[k].0 && pull > 0.0) || (z[k] >= bounds[k].1 && pull < 0.0);
        if strength > 0.0 && norm == 0.0 {
            let free = self.members.iter().filter(|&&k| !is_held(k, gradient[k]));
            return (free.map(|&k| gradient[k] * gradient[k]).sum::<f64>().sqrt() - strength).max(0.0);
        }
        let pull = |k: usize| gradient[k] + if strength > 0.0 { strength * z[k] / norm } else { 0.0 };
        let free = self.members.iter().map(|&k| (k, pull(k))).filter(|&(k, pull)| !is_held(k, pull));
        free.map(|(_, pull)| pull * pull).sum::<f64>().sqrt()
    }
}

impl Subproblem<'_> {
    /// Moves z to the least value, until every group fulfils its condition to a tolerance.
    pub(super) fn solve(&self, z: &mut DVector<f64>, tolerance: f64) {
        for _ in 0..ROUNDS {
            self.newton(z);
            if self.violation(z) <= tolerance {
                break;
            }
            let mut gradient = self.gradient(z);
            self.groups.iter().for_each(|group| self.settle(group, z, &mut gradient));
        }
    }

    fn gradient(&self, z: &DVector<f64>) -> DVector<f64> {
        &self.quadratic.gradient + &self.quadratic.hessian * (z - self.at)
    }

    fn violation(&self, z: &DVector<f64>) -> f64 {
        let gradient = self.gradient(z);
        let of = |group: &Group| group.violation(self.lambda, z, &gradient, self.bounds);
        self.groups.iter().map(of).fold(0.0, f64::max)
    }

    /// Moves one group to its own least value, the others held, and the gradient along.
    fn settle(&self, group: &Group, z: &mut DVector<f64>, gradient: &mut DVector<f64>) {
        let found = match &group.members[..] {
            &[k] => vec![self.settled_alone(group, k, z[k], gradient[k])],
            _ => self.settled_together(group, z, gradient),
        };
        for (&k, found) in group.members.iter().zip(found) {
            let change = found.clamp(self.bounds[k].0, self.bounds[k].1) - z[k];
            if change != 0.0 {
                gradient.axpy(change, &self.quadratic.hessian.column(k), 1.0);
                z[k] += change;
            }
        }
    }

    fn settled_alone(&self, group: &Group, k: usize, z: f64, gradient: f64) -> f64 {
        let (curvature, strength) = (self.quadratic.hessian[(k, k)], group.strength(self.lambda));
        let slope = gradient - curvature * z;
        match strength > 0.0 && slope.abs() <= strength {
            true => 0.0,
            false if curvature > 0.0 => -(slope - strength.copysign(slope)) / curvature,
            false => z,
        }
    }

    /// z = −ρ (ρ B + w)⁻¹ c with ρ = ‖z‖, found by halving.
    fn settled_together(&self, group: &Group, z: &DVector<f64>, gradient: &DVector<f64>) -> Vec<f64> {
        let members = &group.members;
        let own = |i: usize, j: usize| self.quadratic.hessian[(members[i], members[j])];
        let curvature = DMatrix::from_fn(members.len(), members.len(), own);
        let here = DVector::from_fn(members.len(), |i, _| z[members[i]]);
        let slope = DVector::from_fn(members.len(), |i, _| gradient[members[i]]) - &curvature * &here;
        let strength = group.strength(self.lambda);
        if slope.norm() <= strength {
            return vec![0.0; members.len()];
        }
        let eigen = SymmetricEigen::new(curvature);
        let along = eigen.eigenvectors.tr_mul(&slope);
        let fraction = |i: usize, norm: f64| along[i] / (eigen.eigenvalues[i].max(0.0) * norm + strength);
        let is_short = |norm: f64| (0..members.len()).map(|i| fraction(i, norm).powi(2)).sum::<f64>() > 1.0;
        let (mut low, mut high) = (0.0, 1.0);
        let mut doublings = 0;
        while is_short(high) {
            (low, high, doublings) = (high, 2.0 * high, doublings + 1);
            if doublings > HALVINGS {
                return here.iter().copied().collect();
            }
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if is_short(middle) { low = middle } else { high = middle }
        }
        let found = &eigen.eigenvectors * DVector::from_fn(members.len(), |i, _| -high * fraction(i, high));
        found.iter().copied().collect()
    }

    /// Newton step of the groups that are not zero, as far as it helps; coefficients that reach zero or a bound stay there.
    fn newton(&self, z: &mut DVector<f64>) {
        let gradient = self.gradient(z);
        let moving = self.moving(z, &gradient);
        let Some(step) = self.newton_step(z, &gradient, &moving) else { return };
        let steepness = gradient.dot(&step);
        let curvature = step.dot(&(&self.quadratic.hessian * &step));
        let penalty = |z: &DVector<f64>| self.groups.iter().map(|group| group.penalty(self.lambda, z)).sum::<f64>();
        let start = penalty(z);
        let gain = |t: f64| start - penalty(&(&*z + &step * t)) - t * steepness - 0.5 * t * t * curvature;
        let limit = self.limit(z, &step);
        let places = self.kinks(z, &step).into_iter().filter(|&t| t < limit).chain([limit]);
        let best = places.map(|t| (t, gain(t))).max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((mut t, mut gained)) = best else { return };
        for _ in 0..HALVINGS {
            if gained >= 0.0 {
                break;
            }
            t *= 0.5;
            gained = gain(t);
        }
        if gained < 0.0 {
            return;
        }
        for group in self.groups {
            for &k in &group.members {
                let (low, high) = self.bounds[k];
                let to = z[k] + t * step[k];
                let is_kink = group.members.len() == 1 && group.weight > 0.0 && z[k] != 0.0 && -z[k] / step[k] == t;
                z[k] = if is_kink { 0.0 } else { to.clamp(low, high) };
            }
        }
    }

    /// Members of groups that are not zero or not penalised, without those that a bound holds.
    fn moving(&self, z: &DVector<f64>, gradient: &DVector<f64>) -> Vec<(usize, usize)> {
        let mut moving = Vec::new();
        for (place, group) in self.groups.iter().enumerate() {
            let (strength, norm) = (group.strength(self.lambda), group.norm(z));
            if strength > 0.0 && norm == 0.0 {
                continue;
            }
            for &k in &group.members {
                let pull = gradient[k] + if strength > 0.0 { strength * z[k] / norm } else { 0.0 };
                let (low, high) = self.bounds[k];
                if !((z[k] <= low && pull > 0.0) || (z[k] >= high && pull < 0.0)) {
                    moving.push((k, place));
                }
            }
        }
        moving
    }

    fn newton_step(
        &self,
        z: &DVector<f64>,
        gradient: &DVector<f64>,
        moving: &[(usize, usize)],
    ) -> Option<DVector<f64>> {
        if moving.is_empty() {
            return None;
        }
        let norms: Vec<f64> = self.groups.iter().map(|group| group.norm(z)).collect();
        let strength = |place: usize| self.groups[place].strength(self.lambda);
        let of_penalty = |(i, group): (usize, usize), (j, other): (usize, usize)| {
            let (strength, norm) = (strength(group), norms[group]);
            if group != other || strength == 0.0 || self.groups[group].members.len() == 1 {
                return 0.0;
            }
            strength / norm * (f64::from(u8::from(i == j)) - z[i] * z[j] / (norm * norm))
        };
        let count = moving.len();
        let entry =
            |a: usize, b: usize| self.quadratic.hessian[(moving[a].0, moving[b].0)] + of_penalty(moving[a], moving[b]);
        let scale: Vec<f64> = (0..count).map(|a| entry(a, a).max(f64::MIN_POSITIVE).sqrt().recip()).collect();
        let pull = |(k, place): (usize, usize)| {
            gradient[k] + if strength(place) > 0.0 { strength(place) * z[k] / norms[place] } else { 0.0 }
        };
        let right = DVector::from_fn(count, |a, _| -pull(moving[a]) * scale[a]);
        let mut ridge = RIDGE.0;
        let solution = loop {
            let matrix = DMatrix::from_fn(count, count, |a, b| {
                entry(a, b) * scale[a] * scale[b] + if a == b { ridge } else { 0.0 }
            });
            match Cholesky::new(matrix) {
                Some(factor) => break factor.solve(&right),
                None if ridge < 1.0 => ridge *= RIDGE.1,
                None => return None,
            }
        };
        let mut step = DVector::zeros(z.len());
        moving.iter().enumerate().for_each(|(a, &(k, _))| step[k] = solution[a] * scale[a]);
        step.iter().all(|part| part.is_finite()).then_some(step)
    }

    /// Shares of a step at which a coefficient with a penalty of its own passes zero.
    fn kinks(&self, z: &DVector<f64>, step: &DVector<f64>) -> Vec<f64> {
        let alone = self.groups.iter().filter(|group| group.weight > 0.0 && group.members.len() == 1);
        let fraction = alone.map(|group| group.members[0]).map(|k| -z[k] / step[k]);
        fraction.filter(|t| *t > 0.0 && *t < 1.0).collect()
    }

    /// Share of a step up to the first bound.
    fn limit(&self, z: &DVector<f64>, step: &DVector<f64>) -> f64 {
        let room = |k: usize| match step[k] {
            up if up > 0.0 => (self.bounds[k].1 - z[k]) / up,
            down if down < 0.0 => (self.bounds[k].0 - z[k]) / down,
            _ => f64::INFINITY,
        };
        (0..z.len()).map(room).fold(1.0, f64::min).max(0.0)
    }
}
