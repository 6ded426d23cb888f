//! One descent from one start, cables in lanes.

use super::Settings;
use crate::equilibrium::pose_step::{Measure, displaced};
use crate::geometry::Pose;
use crate::model::Model;
use crate::scalar::{Kernel, LANES, Lanes, Real, Select, constants, cross, dispatch_narrow, dot, ldl};
pub(super) use crate::solve::Stop;
use crate::solve::{self, Control, Rules, Step, StepRule, Trial, descend};

/// A model with given lengths.
pub(super) struct Problem<'a> {
    pub(super) model: &'a Model,
    pub(super) settings: &'a Settings,
    /// Given lengths, packed like the model's groups.
    pub(super) targets: &'a [[f64; LANES]],
    pub(super) mean_length: f64,
    pub(super) platform_radius: f64,
}

/// Residuals of the cables (m), packed like the model's groups, at the accepted pose and at the trial.
#[derive(Clone, Debug)]
pub(super) struct Residuals {
    pub(super) accepted: Vec<[f64; LANES]>,
    pub(super) trial: Vec<[f64; LANES]>,
}

impl Residuals {
    /// Writes one accepted residual per cable.
    pub(super) fn unpack(&self, residuals: &mut [f64]) {
        for (chunk, lanes) in residuals.chunks_mut(LANES).zip(&self.accepted) {
            chunk.copy_from_slice(&lanes[..chunk.len()]);
        }
    }
}

/// Ratio of successive steps above which the descent uses second derivatives.
pub(super) const SLOW_CONTRACTION: f64 = 0.1;

/// End of one descent.
pub(super) struct PoseEnd {
    pub(super) pose: Pose,
    pub(super) rms: f64,
    pub(super) iterations: u32,
    pub(super) stop: Stop,
    /// Smallest pivot of the scaled normal equations: near 0 if lengths do not determine the pose.
    pub(super) pivot_ratio: f64,
}

impl Problem<'_> {
    /// Descends from one start.
    pub(super) fn descend(&self, start: &Pose, residuals: &mut Residuals) -> PoseEnd {
        match self.model.dof() {
            2 => dispatch_narrow(PoseDescent::<2> { problem: self, start, residuals }),
            3 => dispatch_narrow(PoseDescent::<3> { problem: self, start, residuals }),
            _ => dispatch_narrow(PoseDescent::<6> { problem: self, start, residuals }),
        }
    }

    #[inline]
    fn measure(&self) -> Measure<f64> {
        let translations = self.model.axes().len();
        Measure { translations, mean_length: self.mean_length, platform_radius: self.platform_radius }
    }
}

/// The descent as a kernel over lanes of cables, for N degrees of freedom.
pub(super) struct PoseDescent<'a, const N: usize> {
    pub(super) problem: &'a Problem<'a>,
    pub(super) start: &'a Pose,
    pub(super) residuals: &'a mut Residuals,
}

/// Sum of squares, gradient side and normal matrix at one pose, in the robot's N degrees of freedom.
#[derive(Clone, Copy)]
struct Normal<const N: usize> {
    cost: f64,
    /// S ρ: minus the gradient, since ∂ρ/∂x = −Sᵀ.
    right: [f64; N],
    /// S Sᵀ, lower triangle.
    matrix: [[f64; N]; N],
}

impl<const N: usize> Kernel for PoseDescent<'_, N> {
    type Output = PoseEnd;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> PoseEnd {
        let Self { problem, start, residuals } = self;
        let tolerance = problem.settings.pose_tolerance * problem.mean_length.max(1.0);
        let max_iterations = problem.settings.max_iterations;
        let normal = Normal { cost: f64::INFINITY, right: [0.0; N], matrix: [[0.0; N]; N] };
        let (pose, trial, next) = (*start, *start, normal);
        let mut descent =
            Descent { lanes, problem, residuals, pose, trial, normal, next, slow: false, pivot_ratio: f64::NAN };
        let rules = Rules { tolerance, max_iterations, least_gain: 0.0, rule: StepRule::Damping };
        let end = descend(&mut descent, &rules);
        let stop = match end.stop() {
            // a singular system is the end: some direction changes no length
            Stop::Singular => Stop::Stationary,
            stop => stop,
        };
        if stop != Stop::Degenerate && descent.pivot_ratio.is_nan() {
            // neither damping nor curvature may hide that lengths do not determine the pose
            let Normal { mut matrix, mut right, .. } = descent.normal;
            descent.pivot_ratio = ldl::solve(&mut matrix, &mut right).unwrap_or(0.0);
        }
        let rms = (descent.normal.cost / problem.model.cable_count() as f64).sqrt();
        let rms = if stop == Stop::Degenerate { f64::NAN } else { rms };
        PoseEnd { pose: descent.pose, rms, iterations: end.iterations as u32, stop, pivot_ratio: descent.pivot_ratio }
    }
}

/// Least squares of the lengths, as a problem of the common descent loop.
struct Descent<'a, L, const N: usize> {
    lanes: L,
    problem: &'a Problem<'a>,
    residuals: &'a mut Residuals,
    pose: Pose,
    trial: Pose,
    normal: Normal<N>,
    next: Normal<N>,
    /// True while steps shrink slowly, so that second derivatives are used.
    slow: bool,
    /// Smallest pivot of the last plain step.
    pivot_ratio: f64,
}

impl<L: Lanes, const N: usize> solve::Problem for Descent<'_, L, N> {
    type Number = f64;

    /// A damped Gauss–Newton step, with the curvature of the residuals if steps shrink slowly.
    #[inline]
    fn step(&mut self, control: &Control<f64>) -> Step<f64> {
        let Self { problem, normal, .. } = &*self;
        let mut matrix = if self.slow { normal.with(&problem.curvature(&self.pose)) } else { normal.matrix };
        for k in 0..N {
            matrix[k][k] += control.damping * normal.matrix[k][k];
        }
        let mut amounts = normal.right;
        let pivot_ratio = ldl::solve(&mut matrix, &mut amounts);
        let size = problem.measure().shorten(&mut amounts);
        self.trial = displaced(problem.model, &self.pose, &amounts);
        let is_plain = !self.slow && control.damping == 0.0;
        self.pivot_ratio = if is_plain { pivot_ratio.unwrap_or(f64::NAN) } else { f64::NAN };
        Step::whole(size, pivot_ratio.is_some())
    }

    #[inline]
    fn evaluate(&mut self, _: f64, is_last: bool) -> Trial<f64> {
        let Self { lanes, problem, trial, .. } = self;
        let residuals = &mut self.residuals.trial;
        self.next.cost = match is_last {
            // the normal equations of the end are those before its last step
            true => {
                self.next = self.normal;
                lanes.apart(AtPose::<N> { problem, pose: trial, residuals, normal: None })
            }
            false => lanes.apart(AtPose { problem, pose: trial, residuals, normal: Some(&mut self.next) }),
        };
        Trial::new(1.0, is_no_higher(self.next.cost, self.normal.cost, rounding_of(problem.mean_length)))
    }

    #[inline]
    fn accept(&mut self, helps: bool, contraction: f64) {
        self.slow = !helps || (contraction.is_finite() && contraction > SLOW_CONTRACTION);
        if helps {
            (self.pose, self.normal) = (self.trial, self.next);
            let Residuals { accepted, trial } = &mut *self.residuals;
            for (accepted, trial) in accepted.iter_mut().zip(trial) {
                *accepted = *trial;
            }
        }
    }
}

/// Sum of squared residuals that counts as rounding (m²).
#[inline(always)]
pub(super) fn rounding_of<T: Real>(mean_length: T) -> T {
    mean_length.constant(1e-29) * mean_length * mean_length
}

/// True if a cost is finite and no higher than the one before, except for rounding: equal costs near the optimum are no
/// failure.
#[inline(always)]
pub(super) fn is_no_higher<T: Select>(cost: T, before: T, rounding: T) -> T::Mask {
    let most = before * cost.constant(1.0 + 1e-12) + rounding;
    cost.without(cost.is_less(cost.constant(f64::INFINITY)), most.is_less(cost))
}

/// Sum of squared residuals at a pose, eight cables at a time, with the normal equations unless the descent ends here.
struct AtPose<'a, const N: usize> {
    problem: &'a Problem<'a>,
    pose: &'a Pose,
    /// Output: residuals (m).
    residuals: &'a mut [[f64; LANES]],
    normal: Option<&'a mut Normal<N>>,
}

impl<const N: usize> Kernel for AtPose<'_, N> {
    type Output = f64;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> f64 {
        let Self { problem, pose, residuals, mut normal } = self;
        let rotation = pose.rotation_rows();
        let position = pose.position.into();
        let mut cost = 0.0;
        if let Some(normal) = &mut normal {
            (normal.right, normal.matrix) = ([0.0; N], [[0.0; N]; N]);
        }
        let groups = problem.model.groups();
        for ((group, targets), residuals) in groups.iter().zip(problem.targets).zip(residuals) {
            let (path, moment_arm) = group.paths(lanes, position, &rotation);
            let residual = path.length - lanes.load(targets);
            residual.store(residuals);
            let weight = lanes.load(&group.weight);
            let residual = residual * weight;
            cost += (residual * residual).sum();
            if let Some(normal) = &mut normal {
                let u = [path.direction[0] * weight, path.direction[1] * weight, path.direction[2] * weight];
                normal.add(in_basis(problem.model, lanes, u, cross(moment_arm, u)), residual);
            }
        }
        cost
    }
}

/// Columns [u; b × u] in the robot's degrees of freedom.
#[inline(always)]
fn in_basis<L: Lanes, const N: usize>(model: &Model, lanes: L, u: [L; 3], moment: [L; 3]) -> [L; N] {
    let mut rows = [lanes; N];
    if N == 6 {
        let spatial = [u[0], u[1], u[2], moment[0], moment[1], moment[2]];
        rows.copy_from_slice(&spatial[..N]);
        return rows;
    }
    let basis = model.twist_basis();
    for row in 0..N {
        let t = &basis[row];
        let (shift, turn) = (constants(lanes, [t[0], t[1], t[2]]), constants(lanes, [t[3], t[4], t[5]]));
        rows[row] = dot(shift, u) + dot(turn, moment);
    }
    rows
}

/// Number of products of N rows and a residual with each other, for the spatial case as the largest.
const PRODUCTS: usize = 28;

impl<const N: usize> Normal<N> {
    /// The matrix plus another one.
    fn with(&self, other: &[[f64; N]; N]) -> [[f64; N]; N] {
        let mut sum = self.matrix;
        for (row, other) in sum.iter_mut().zip(other) {
            row.iter_mut().zip(other).for_each(|(entry, other)| *entry += other);
        }
        sum
    }

    /// Adds a group of cables: the products of `rows` with each other and with the residual, summed four at a time.
    #[inline(always)]
    fn add<L: Lanes>(&mut self, rows: [L; N], residual: L) {
        let mut products = [residual * residual; PRODUCTS];
        let mut count = 0;
        for i in 0..N {
            products[count] = rows[i] * residual;
            for j in 0..=i {
                products[count + 1 + j] = rows[i] * rows[j];
            }
            count += i + 2;
        }
        let mut sums = [0.0; PRODUCTS];
        for first in (0..count).step_by(4) {
            let four = L::sums([products[first], products[first + 1], products[first + 2], products[first + 3]]);
            sums[first..first + 4].copy_from_slice(&four);
        }
        let mut count = 0;
        for i in 0..N {
            self.right[i] += sums[count];
            for j in 0..=i {
                self.matrix[i][j] += sums[count + 1 + j];
            }
            count += i + 2;
        }
    }
}
