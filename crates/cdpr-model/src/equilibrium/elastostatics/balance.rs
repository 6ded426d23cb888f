//! Residual wrench, stiffness and energy at one pose, cables in lanes.

use super::problem::{LoadParts, Problem};
use super::springs::Springs;
use crate::cable::wrench::{moment_columns, turned_row, wrench};
use crate::geometry::Pose;
use crate::scalar::{Kernel, LANES, Lanes, Real, Select, dot, scale};

/// Forces and their derivatives at one pose.
#[derive(Clone, Copy, Debug)]
pub(super) struct Balance {
    /// Aᵀ f + w (N, N·m; world axes): minus the gradient of the energy.
    pub(super) residual: [f64; 6],
    /// Symmetric part of K_wx = K_C − K_G − ∂w/∂x, lower triangle.
    pub(super) stiffness: [[f64; 6]; 6],
    /// Elastic energy of the cables minus the work of forces and weight (N·m); constant moments are not counted.
    pub(super) energy: f64,
}

/// Terms that one group of cables contributes: energy 1, residual 6, stiffness 6 + 9 + 6.
pub(super) const TERMS: usize = 28;
/// The first terms, energy and residual, rounded up to a multiple of four.
const FORCE_TERMS: usize = 8;

/// The balance at a pose: a kernel of its own, shared by descents of any degrees of freedom.
pub(super) struct AtPose<'a> {
    pub(super) problem: &'a Problem<'a>,
    pub(super) pose: &'a Pose,
    /// Output: tensions, packed like the model's groups (N).
    pub(super) tensions: &'a mut [[f64; LANES]],
    /// Output: lengths, packed alike (m).
    pub(super) lengths: &'a mut [[f64; LANES]],
    /// False leaves the stiffness at zero.
    pub(super) with_stiffness: bool,
}

impl Kernel for AtPose<'_> {
    type Output = Balance;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Balance {
        let Self { problem, pose, tensions, lengths, with_stiffness } = self;
        let rotation = pose.rotation_rows();
        let position = pose.position.into();
        let mut totals = [0.0; TERMS];
        let cables = problem.model.groups().iter().zip(problem.springs).zip(tensions).zip(lengths);
        for (((group, springs), tensions), lengths) in cables {
            let (path, moment_arm) = group.paths(lanes, position, &rotation);
            let pull = problem.pull(path.length, group.elasticity(lanes).by_length, springs);
            pull.tension.store(tensions);
            path.length.store(lengths);
            let zero = lanes.constant(0.0);
            let mut terms = [zero; TERMS];
            terms[0] = pull.energy;
            force_terms(&mut terms, path.direction, moment_arm, pull.tension);
            if with_stiffness {
                stiffness_terms(&mut terms, &path.direction_gradient, path.direction, moment_arm, &pull);
            }
            let count = if with_stiffness { TERMS } else { FORCE_TERMS };
            for first in (0..count).step_by(4) {
                let sums = L::sums([terms[first], terms[first + 1], terms[first + 2], terms[first + 3]]);
                for k in 0..4 {
                    totals[first + k] += sums[k];
                }
            }
        }
        let (mut residual, mut stiffness) = unpack(&totals);
        if !with_stiffness {
            stiffness = [[0.0; 6]; 6];
        }
        let LoadParts { constant, weight, .. } = problem.load;
        let center = problem.load.add_to(&mut residual, &mut stiffness, &rotation);
        let mut energy = totals[0];
        for k in 0..3 {
            energy -= constant[k] * position[k] + weight[k] * (position[k] + center[k]);
        }
        Balance { residual, stiffness, energy }
    }
}

impl Problem<'_> {
    #[inline(always)]
    fn pull<L: Lanes>(&self, length: L, by_length: L, springs: &Springs) -> Pull<L> {
        let lanes = length;
        let zero = lanes.constant(0.0);
        let floor = lanes.constant(self.floor);
        let at_rest = lanes.load(&springs.stiffness);
        let stretch = (length - lanes.load(&springs.rest_length)).max(floor);
        let taut = floor.is_less(stretch);
        let pull = Pull::without_energy(at_rest, by_length, stretch);
        let force_at_rest = at_rest * stretch;
        let fraction = energy_share(lanes, by_length * force_at_rest);
        Pull { stiffness: pull.stiffness.select(taut, zero), energy: force_at_rest * stretch * fraction, ..pull }
    }
}

/// Strain above which the short form of the energy is not exact enough.
const LARGE_STRAIN: f64 = 0.1;

/// (z − ln(1 + z))/z² of the strain z = κ_q k₀ e, to 1e-7 and without a logarithm, which differs between machines.
///
/// With 1 + z = (1 + t)², z − ln(1 + z) = t² + 2 (t − ln(1 + t)): large strains become small by taking roots.
#[inline(always)]
fn energy_share<L: Select>(lanes: L, strain: L) -> L {
    let is_large = lanes.constant(LARGE_STRAIN).is_less(strain.abs());
    if !lanes.any(is_large) {
        return share_of_small(lanes, strain);
    }
    let one = lanes.constant(1.0);
    // −1 only by rounding: the compliance is positive at every length
    let mut root = (one + strain).max(lanes.constant(f64::MIN_POSITIVE));
    let (mut sum, mut weight, mut t) = (lanes.constant(0.0), 1.0, strain);
    for _ in 0..4 {
        root = root.sqrt();
        t = t / (one + root);
        sum = sum + lanes.constant(weight) * (t * t);
        weight *= 2.0;
    }
    let exact = (sum + lanes.constant(weight) * (t * t) * share_of_small(lanes, t)) / (strain * strain);
    // without a strain the quotient is not defined
    exact.select(is_large, share_of_small(lanes, strain))
}

/// (z − ln(1 + z))/z² = ½ − z/3 + z²/4 − …, by a rational function that agrees to the fifth term.
#[inline(always)]
fn share_of_small<L: Select>(lanes: L, strain: L) -> L {
    let number = |x: f64| lanes.constant(x);
    (number(0.5) + strain * (number(1.0 / 3.0) + strain * number(1.0 / 180.0)))
        / (number(1.0) + strain * (number(4.0 / 3.0) + strain * number(0.4)))
}

/// Tension (N), stiffness (N/m) and energy (J) of eight cables at their lengths.
pub(super) struct Pull<L> {
    pub(super) tension: L,
    /// ∂f/∂q (N/m); 0 if slack.
    pub(super) stiffness: L,
    pub(super) energy: L,
}

impl<L: Real> Pull<L> {
    /// Pull for a stretch e (m) of linear cables with the stiffness k₀ at rest: f = k₀ e/(1 + κ_q k₀ e), taut or
    /// pushing like a bar; the energy stays zero.
    #[inline(always)]
    pub(super) fn without_energy(at_rest: L, by_length: L, stretch: L) -> Self {
        let one = stretch.constant(1.0);
        let force_at_rest = at_rest * stretch;
        let softer = one / (one + by_length * force_at_rest);
        let (tension, stiffness) = (force_at_rest * softer, at_rest * softer * softer);
        Self { tension, stiffness, energy: stretch.constant(0.0) }
    }
}

/// Writes the terms of the wrench f \[u; b × u\].
#[inline(always)]
pub(super) fn force_terms<L: Lanes>(terms: &mut [L; TERMS], u: [L; 3], moment_arm: [L; 3], tension: L) {
    let column = wrench(moment_arm, u);
    for k in 0..6 {
        terms[1 + k] = tension * column[k];
    }
}

/// Writes the terms of K_C − K_G from M = −∂t/∂p_B = k u uᵀ − f ∂u/∂p_B of the pull t = f u.
#[inline(always)]
pub(super) fn stiffness_terms<L: Lanes>(
    terms: &mut [L; TERMS],
    direction_gradient: &[[L; 3]; 3],
    u: [L; 3],
    moment_arm: [L; 3],
    pull: &Pull<L>,
) {
    let f = pull.tension;
    let ku = [pull.stiffness * u[0], pull.stiffness * u[1], pull.stiffness * u[2]];
    let zero = f.constant(0.0);
    let mut tangent = [[zero; 3]; 3];
    for i in 0..3 {
        for j in 0..=i {
            tangent[i][j] = ku[i] * u[j] - f * direction_gradient[i][j];
            tangent[j][i] = tangent[i][j];
        }
    }
    let columns = moment_columns(&tangent, moment_arm);
    let fu = [f * u[0], f * u[1], f * u[2]];
    let half_b = scale(f.constant(0.5), moment_arm);
    let along = dot(moment_arm, fu);
    let mut count = 7;
    for i in 0..3 {
        let turned = turned_row(&columns, moment_arm, i);
        for j in 0..=i {
            terms[count] = tangent[i][j];
            // the moment arm turns under the pull: (b·t) I − ½ (b tᵀ + t bᵀ)
            terms[count + 1] = turned[j] - (half_b[i] * fu[j] + half_b[j] * fu[i]);
            if i == j {
                terms[count + 1] = terms[count + 1] + along;
            }
            count += 2;
        }
    }
    for i in 0..3 {
        for j in 0..3 {
            terms[count] = columns[j][i];
            count += 1;
        }
    }
}

/// Wrench, and lower triangle of the stiffness, from the sums of the terms, in their usual order.
#[inline(always)]
pub(super) fn unpack<T: Real>(totals: &[T; TERMS]) -> ([T; 6], [[T; 6]; 6]) {
    let zero = totals[0].constant(0.0);
    let (mut residual, mut stiffness) = ([zero; 6], [[zero; 6]; 6]);
    residual.copy_from_slice(&totals[1..7]);
    let mut count = 7;
    for i in 0..3 {
        for j in 0..=i {
            stiffness[i][j] = totals[count];
            stiffness[3 + i][3 + j] = totals[count + 1];
            count += 2;
        }
    }
    for i in 0..3 {
        for j in 0..3 {
            stiffness[3 + i][j] = totals[count];
            count += 1;
        }
    }
    (residual, stiffness)
}

#[cfg(test)]
mod tests {
    use super::energy_share;

    /// From cables compressed to a hundredth of their length to cables stretched a thousandfold.
    #[test]
    fn the_energy_is_that_of_the_logarithm() {
        for step in 0..200 {
            let strain = 0.01 * 1.06_f64.powi(step) - 1.0;
            if strain.abs() < 1e-3 {
                continue; // there rounding removes all digits of the logarithm itself
            }
            let exact = (strain - strain.ln_1p()) / (strain * strain);
            let error = energy_share(1.0, strain) / exact - 1.0;
            assert!(error.abs() < 1e-6, "{strain}: {error:e}");
        }
    }
}
