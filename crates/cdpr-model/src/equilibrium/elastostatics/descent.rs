//! One descent of the energy from one start, by damped Newton steps.

use super::balance::{AtPose, Balance};
use super::problem::{Problem, squared};
use super::unsymmetric;
use crate::equilibrium::pose_step::{Measure, displaced, twist_of};
use crate::geometry::Pose;
use crate::scalar::{Kernel, LANES, Lanes, dispatch_narrow, ldl};
pub(super) use crate::solve::Stop;
use crate::solve::{self, Control, Rules, Step, StepRule, Trial, descend};

/// Tensions (N) and geometric lengths (m) packed like the model's groups, at the accepted pose and at the trial.
#[derive(Clone, Debug)]
pub(super) struct Tensions {
    pub(super) accepted: Vec<[f64; LANES]>,
    pub(super) trial: Vec<[f64; LANES]>,
    pub(super) accepted_lengths: Vec<[f64; LANES]>,
    pub(super) trial_lengths: Vec<[f64; LANES]>,
}

/// End of one descent.
#[derive(Clone, Copy, Debug)]
pub(super) struct EquilibriumEnd {
    pub(super) pose: Pose,
    /// Aᵀ f + w (N, N·m).
    pub(super) residual: [f64; 6],
    /// Symmetric part of K_wx in the robot's degrees of freedom, lower triangle.
    pub(super) stiffness: [[f64; 6]; 6],
    pub(super) iterations: u32,
    pub(super) stop: Stop,
}

impl Tensions {
    pub(super) fn new(groups: usize) -> Self {
        let room = vec![[0.0; LANES]; groups];
        Self { accepted: room.clone(), trial: room.clone(), accepted_lengths: room.clone(), trial_lengths: room }
    }
}

impl Problem<'_> {
    /// Descends from one start.
    pub(super) fn descend(&self, start: &Pose, tensions: &mut Tensions) -> EquilibriumEnd {
        match self.model.dof() {
            2 => dispatch_narrow(EquilibriumDescent::<2> { problem: self, start, tensions }),
            3 => dispatch_narrow(EquilibriumDescent::<3> { problem: self, start, tensions }),
            _ => dispatch_narrow(EquilibriumDescent::<6> { problem: self, start, tensions }),
        }
    }
}

/// The descent as a kernel over lanes of cables, for N degrees of freedom.
pub(super) struct EquilibriumDescent<'a, const N: usize> {
    pub(super) problem: &'a Problem<'a>,
    pub(super) start: &'a Pose,
    pub(super) tensions: &'a mut Tensions,
}

/// The balance at one pose in the robot's degrees of freedom.
#[derive(Clone, Copy)]
struct Point<const N: usize> {
    /// Minus the gradient.
    right: [f64; N],
    /// Lower triangle.
    matrix: [[f64; N]; N],
    energy: f64,
    residual: [f64; 6],
}

impl<const N: usize> Kernel for EquilibriumDescent<'_, N> {
    type Output = EquilibriumEnd;

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> EquilibriumEnd {
        let Self { problem, start, tensions } = self;
        let tolerance = problem.settings.pose_tolerance * problem.mean_length.max(1.0);
        let max_iterations = problem.settings.max_iterations;
        // any finite energy is lower
        let point = Point { right: [0.0; N], matrix: [[0.0; N]; N], energy: f64::INFINITY, residual: [0.0; 6] };
        let (pose, trial, amounts) = (*start, *start, [0.0; N]);
        let (points, has_stiffness) = ([point; 2], false);
        let mut descent =
            Descent { lanes, problem, tensions, pose, trial, points, here: 0, stiffness: 0, has_stiffness, amounts };
        let rules = Rules { tolerance, max_iterations, least_gain: 0.0, rule: StepRule::Damping };
        let ended = descend(&mut descent, &rules);
        // a degenerate start is reported as it is
        let here = if ended.stop() == Stop::Degenerate { 1 } else { descent.here };
        let mut stiffness = [[0.0; 6]; 6];
        for row in 0..N {
            stiffness[row][..N].copy_from_slice(&descent.points[descent.stiffness].matrix[row]);
        }
        let (residual, iterations) = (descent.points[here].residual, ended.iterations as u32);
        EquilibriumEnd { pose: descent.pose, residual, stiffness, iterations, stop: ended.stop() }
    }
}

/// Energy of the cables under the load, as a problem of the common descent loop.
struct Descent<'a, L, const N: usize> {
    lanes: L,
    problem: &'a Problem<'a>,
    tensions: &'a mut Tensions,
    pose: Pose,
    trial: Pose,
    /// Balances at the pose and at the trial, in alternating order.
    points: [Point<N>; 2],
    here: usize,
    /// Index of the last point with a stiffness.
    stiffness: usize,
    /// True if the trial has its stiffness.
    has_stiffness: bool,
    /// Step in the robot's degrees of freedom.
    amounts: [f64; N],
}

impl<L: Lanes, const N: usize> solve::Problem for Descent<'_, L, N> {
    type Number = f64;

    /// Newton's step, damped by a fraction of the cables' stiffness.
    #[inline]
    fn step(&mut self, control: &Control<f64>) -> Step<f64> {
        let Self { problem, points, here, .. } = &*self;
        let point = &points[*here];
        let damping = control.damping;
        let (mut matrix, mut amounts) = (point.matrix, point.right);
        for k in 0..N {
            let radius = self.radius(k);
            matrix[k][k] += damping * problem.stiffness_scale * radius * radius;
        }
        let pivot = ldl::solve(&mut matrix, &mut amounts);
        let is_regular = pivot.is_some_and(|pivot| pivot > 1e-13 || damping > 0.0);
        if N == 6 && damping == 0.0 && problem.has_moment && is_regular {
            amounts = unsymmetric::solve(N, &point.matrix, &point.right, &problem.load.constant);
        }
        let size = problem.measure().shorten(&mut amounts);
        self.trial = displaced(problem.model, &self.pose, &amounts);
        self.amounts = amounts;
        Step::whole(size, is_regular)
    }

    #[inline]
    fn evaluate(&mut self, _: f64, is_last: bool) -> Trial<f64> {
        self.write_trial(!is_last);
        Trial::new(1.0, self.is_better())
    }

    #[inline]
    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            self.pose = self.trial;
            self.here = 1 - self.here;
            self.stiffness = if self.has_stiffness { self.here } else { self.stiffness };
            let Tensions { accepted, trial, accepted_lengths, trial_lengths } = &mut *self.tensions;
            accepted.copy_from_slice(trial);
            accepted_lengths.copy_from_slice(trial_lengths);
        }
    }

    /// True if the residual is rounding; a step that is short because of damping does not show that.
    #[inline(never)] // seldom needed: the kernel stays small without it
    fn rests(&mut self, size: f64, tolerance: f64) -> bool {
        let undecided = self.problem.undecided(self.tensions);
        size <= tolerance && self.size_of(&self.points[self.here].right) <= undecided * undecided
    }
}

impl Problem<'_> {
    #[inline]
    fn measure(&self) -> Measure<f64> {
        let translations = self.model.axes().len();
        Measure { translations, mean_length: self.mean_length, platform_radius: self.platform_radius }
    }
}

impl<L: Lanes, const N: usize> Descent<'_, L, N> {
    /// The balance at the trial; the stiffness at the end is the one before the last step, over which it hardly
    /// changes.
    #[inline]
    fn write_trial(&mut self, with_stiffness: bool) {
        let Tensions { trial, trial_lengths, .. } = &mut *self.tensions;
        let (lanes, problem, pose) = (self.lanes, self.problem, &self.trial);
        let Balance { residual, stiffness, energy } =
            lanes.apart(AtPose { problem, pose, tensions: trial, lengths: trial_lengths, with_stiffness });
        let point = &mut self.points[1 - self.here];
        (point.residual, point.energy, self.has_stiffness) = (residual, energy, with_stiffness);
        if N == 6 {
            point.right.copy_from_slice(&residual[..N]);
            if with_stiffness {
                for row in 0..N {
                    point.matrix[row].copy_from_slice(&stiffness[row][..N]);
                }
            }
            return;
        }
        let basis = problem.model.twist_basis();
        for i in 0..N {
            let mut rows = [0.0; 6];
            point.right[i] = 0.0;
            for k in 0..6 {
                point.right[i] += basis[i][k] * residual[k];
                for l in 0..6 {
                    rows[l] += basis[i][k] * stiffness[k.max(l)][k.min(l)];
                }
            }
            for j in 0..=i {
                point.matrix[i][j] = (0..6).map(|l| rows[l] * basis[j][l]).sum();
            }
        }
    }

    /// Factor that makes an entry a length: 1 for translations, the platform radius (m) for rotations.
    #[inline]
    fn radius(&self, entry: usize) -> f64 {
        if entry < self.problem.model.axes().len() { 1.0 } else { self.problem.platform_radius }
    }

    /// [`squared`] of a wrench in the robot's degrees of freedom.
    fn size_of(&self, wrench: &[f64; N]) -> f64 {
        squared(wrench, self.problem.model.axes().len(), self.problem.platform_radius)
    }

    /// True if the energy falls, or if the residual wrench is halved: near the end rounding hides differences of
    /// energy.
    #[inline]
    fn is_better(&self) -> bool {
        let (point, next) = (&self.points[self.here], &self.points[1 - self.here]);
        let residual = self.size_of(&next.right);
        let mut work = point.energy - next.energy;
        let twist = twist_of(self.problem.model, &self.amounts);
        for k in 3..6 {
            work += self.problem.load.constant[k] * twist[k];
        }
        residual.is_finite() && (work > 0.0 || residual <= 0.25 * self.size_of(&point.right))
    }
}
