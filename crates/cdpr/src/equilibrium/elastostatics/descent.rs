//! One descent of the energy from one start, by damped Newton steps.

use nalgebra::{Quaternion, UnitQuaternion};

use super::Problem;
use super::balance::{AtPose, Balance};
use super::unsymmetric;
use crate::geometry::{Pose, Twist};
use crate::scalar::{Kernel, LANES, Lanes, dispatch_narrow, ldl};

/// Tensions (N) and geometric lengths (m) packed like the model's groups: where the descent stands, and at its trial.
#[derive(Clone, Debug)]
pub(super) struct Tensions {
    pub(super) accepted: Vec<[f64; LANES]>,
    pub(super) trial: Vec<[f64; LANES]>,
    pub(super) accepted_lengths: Vec<[f64; LANES]>,
    pub(super) trial_lengths: Vec<[f64; LANES]>,
}

/// Where one descent ended.
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    pub(super) pose: Pose,
    /// Aᵀ f + w (N, N·m).
    pub(super) residual: [f64; 6],
    /// Symmetric part of K_wx in the robot's degrees of freedom, lower triangle.
    pub(super) stiffness: [[f64; 6]; 6],
    pub(super) iterations: u32,
    pub(super) stop: Stop,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stop {
    Stationary,
    /// No shorter step helped, though the steps had not become small.
    Stalled,
    IterationLimit,
    /// The start itself has no valid lengths.
    Degenerate,
    /// Bars are in balance, one of them pushes, and nobody asks for what cables would do there.
    Pushes,
}

impl Tensions {
    pub(super) fn new(groups: usize) -> Self {
        let room = vec![[0.0; LANES]; groups];
        Self { accepted: room.clone(), trial: room.clone(), accepted_lengths: room.clone(), trial_lengths: room }
    }
}

impl Problem<'_> {
    /// Descends from one start.
    pub(super) fn descend(&self, start: &Pose, tensions: &mut Tensions) -> End {
        match self.model.dof() {
            2 => dispatch_narrow(Search::<2> { problem: self, start, tensions }),
            3 => dispatch_narrow(Search::<3> { problem: self, start, tensions }),
            _ => dispatch_narrow(Search::<6> { problem: self, start, tensions }),
        }
    }
}

/// The descent as a kernel over lanes of cables, for N degrees of freedom.
pub(super) struct Search<'a, const N: usize> {
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

/// A damped Newton step.
struct Step<const N: usize> {
    /// In the robot's degrees of freedom.
    amounts: [f64; N],
    /// Length (m); angles times the platform radius.
    size: f64,
}

impl<const N: usize> Kernel for Search<'_, N> {
    type Output = End;

    #[inline(always)]
    fn run<L: Lanes>(mut self, lanes: L) -> End {
        let tolerance = self.problem.settings.pose_tolerance * self.problem.mean_length.max(1.0);
        let max_iterations = self.problem.settings.max_iterations;
        let mut pose = *self.start;
        let mut point = self.evaluate(lanes, &pose, true);
        self.accept();
        let mut iterations = 0;
        if !self.size_of(&point.right).is_finite() {
            return end(pose, &point, iterations, Stop::Degenerate);
        }
        let mut damping = 0.0;
        let mut last_size = 0.0; // none yet: no rate of contraction to judge by
        let stop = loop {
            if iterations == max_iterations {
                break Stop::IterationLimit;
            }
            iterations += 1;
            let Some(step) = self.damped_step(&point, &mut damping) else { break Stop::Stalled };
            let size = step.size;
            if damping > 0.0 && size * f64::max(damping, 1.0) <= 1e-3 * tolerance {
                // in balance where the energy has a saddle, or where some direction is free
                break Stop::Stationary;
            }
            let contraction = size / last_size;
            // what the remaining steps add up to if they go on shrinking at this rate
            let settles = damping == 0.0
                && (contraction < 0.5 && size * contraction <= tolerance * (1.0 - contraction)
                    || size <= 1e-3 * tolerance);
            let trial = self.displaced(&pose, &step);
            let next = self.evaluate(lanes, &trial, !settles);
            if self.is_better(&point, &next, &step) {
                self.accept();
                pose = trial;
                last_size = size;
                damping = if damping < 1e-9 { 0.0 } else { damping * 0.1 };
                if settles {
                    // the stiffness hardly changes over this last step
                    point = Point { matrix: point.matrix, ..next };
                    break Stop::Stationary;
                }
                point = next;
            } else if size <= tolerance && self.is_balanced(&point) {
                // rounding hides what is left to gain; a step that damping made short says nothing of the kind
                break Stop::Stationary;
            } else if damping > 1e9 {
                break Stop::Stalled;
            } else {
                damping = f64::max(10.0 * damping, 1e-3);
            }
        };
        end(pose, &point, iterations, stop)
    }
}

#[inline(always)]
fn end<const N: usize>(pose: Pose, point: &Point<N>, iterations: u32, stop: Stop) -> End {
    let mut stiffness = [[0.0; 6]; 6];
    for row in 0..N {
        stiffness[row][..N].copy_from_slice(&point.matrix[row]);
    }
    End { pose, residual: point.residual, stiffness, iterations, stop }
}

impl<const N: usize> Search<'_, N> {
    #[inline(always)]
    fn evaluate<L: Lanes>(&mut self, lanes: L, pose: &Pose, with_stiffness: bool) -> Point<N> {
        let Tensions { trial, trial_lengths, .. } = &mut *self.tensions;
        let problem = self.problem;
        let Balance { residual, stiffness, energy } =
            lanes.apart(AtPose { problem, pose, tensions: trial, lengths: trial_lengths, with_stiffness });
        let mut point = Point { right: [0.0; N], matrix: [[0.0; N]; N], energy, residual };
        if N == 6 {
            point.right.copy_from_slice(&residual[..N]);
            for row in 0..N {
                point.matrix[row].copy_from_slice(&stiffness[row][..N]);
            }
            return point;
        }
        let basis = self.problem.model.twist_basis();
        for i in 0..N {
            let mut rows = [0.0; 6];
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
        point
    }

    /// Moves on to the trial.
    #[inline(always)]
    fn accept(&mut self) {
        let Tensions { accepted, trial, accepted_lengths, trial_lengths } = &mut *self.tensions;
        accepted.copy_from_slice(trial);
        accepted_lengths.copy_from_slice(trial_lengths);
    }

    /// What makes an entry a translation, or a rotation times the platform radius.
    #[inline(always)]
    fn radius(&self, entry: usize) -> f64 {
        if entry < self.problem.model.axes().len() { 1.0 } else { self.problem.platform_radius }
    }

    /// Square of a wrench, moments divided by the platform radius (N²).
    #[inline(always)]
    fn size_of(&self, wrench: &[f64; N]) -> f64 {
        let mut sum = 0.0;
        for k in 0..N {
            let entry = wrench[k] / self.radius(k);
            sum += entry * entry;
        }
        sum
    }

    /// True where what is out of balance is nothing beside the forces at work.
    #[inline(never)] // seldom needed: the kernel stays small without it
    fn is_balanced(&self, point: &Point<N>) -> bool {
        let undecided = self.problem.undecided(self.tensions);
        self.size_of(&point.right) <= undecided * undecided
    }

    /// A step counts when energy falls, or when the residual wrench is halved: near the end, where rounding hides energies.
    #[inline(always)]
    fn is_better(&self, point: &Point<N>, next: &Point<N>, step: &Step<N>) -> bool {
        let residual = self.size_of(&next.right);
        let mut work = point.energy - next.energy;
        if N == 6 {
            for k in 3..N {
                work += self.problem.load.constant[k] * step.amounts[k];
            }
        } else {
            let basis = self.problem.model.twist_basis();
            for (direction, amount) in basis.iter().zip(step.amounts) {
                for k in 3..6 {
                    work += self.problem.load.constant[k] * direction[k] * amount;
                }
            }
        }
        residual.is_finite() && (work > 0.0 || residual <= 0.25 * self.size_of(&point.right))
    }

    /// A step with the least damping, from the given one on, that makes the matrix positive definite; nothing where
    /// no damping does (no cable and no load).
    #[inline(always)]
    fn damped_step(&self, point: &Point<N>, damping: &mut f64) -> Option<Step<N>> {
        loop {
            let mut matrix = point.matrix;
            let mut amounts = point.right;
            for k in 0..N {
                let radius = self.radius(k);
                matrix[k][k] += *damping * self.problem.stiffness_scale * radius * radius;
            }
            if let Some(pivot) = ldl::solve(&mut matrix, &mut amounts)
                && (pivot > 1e-13 || *damping > 0.0)
            {
                if N == 6 && *damping == 0.0 && self.problem.has_moment {
                    amounts = unsymmetric::solve(&point.matrix, &point.right, &self.problem.load.constant);
                }
                return Some(self.shortened(amounts));
            }
            if !(*damping < 1e9) {
                return None;
            }
            *damping = f64::max(10.0 * *damping, 1e-6);
        }
    }

    /// A step that turns the platform by more than half a radian says little about where it leads.
    #[inline(always)]
    fn shortened(&self, mut amounts: [f64; N]) -> Step<N> {
        let translations = self.problem.model.axes().len();
        let (mut shift_squared, mut turn_squared) = (0.0, 0.0);
        for k in 0..N {
            let square = amounts[k] * amounts[k];
            *(if k < translations { &mut shift_squared } else { &mut turn_squared }) += square;
        }
        let mean_length = self.problem.mean_length;
        let largest = f64::max(turn_squared, shift_squared / (mean_length * mean_length)).sqrt();
        let shorten = if largest > 0.5 { 0.5 / largest } else { 1.0 };
        for amount in &mut amounts {
            *amount *= shorten;
        }
        let radius = self.problem.platform_radius;
        Step { amounts, size: shorten * (shift_squared + radius * radius * turn_squared).sqrt() }
    }

    /// The pose after a step; the turn (1, ω/2) normalised equals exp(ω) to third order and needs no sine.
    #[inline(always)]
    fn displaced(&self, pose: &Pose, step: &Step<N>) -> Pose {
        let mut twist = Twist::zeros();
        if N == 6 {
            twist.as_mut_slice().copy_from_slice(&step.amounts);
        } else {
            for (direction, amount) in self.problem.model.twist_basis().iter().zip(step.amounts) {
                twist += direction * amount;
            }
        }
        let turn = Quaternion::new(1.0, 0.5 * twist[3], 0.5 * twist[4], 0.5 * twist[5]);
        let rotation = UnitQuaternion::new_normalize(turn * pose.rotation.quaternion());
        Pose { position: pose.position + twist.fixed_rows::<3>(0), rotation }
    }
}
