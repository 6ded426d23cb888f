//! One descent from one start, cables in lanes.

use nalgebra::{Quaternion, UnitQuaternion};

use super::Settings;
use crate::geometry::{Pose, Twist};
use crate::model::Model;
use crate::scalar::{Kernel, LANES, Lanes, constants, cross, dispatch_narrow, dot, ldl};

/// A model with lengths to meet.
pub(super) struct Problem<'a> {
    pub(super) model: &'a Model,
    pub(super) settings: &'a Settings,
    /// Given lengths, packed like the model's groups.
    pub(super) targets: &'a [[f64; LANES]],
    pub(super) mean_length: f64,
    pub(super) platform_radius: f64,
}

/// Residuals of the cables at one pose (m), packed like the model's groups: where the descent stands, and at its trial.
#[derive(Clone, Debug)]
pub(super) struct Residuals {
    pub(super) accepted: Vec<[f64; LANES]>,
    pub(super) trial: Vec<[f64; LANES]>,
}

impl Residuals {
    /// One number per cable, where the descent stands.
    pub(super) fn unpack(&self, residuals: &mut [f64]) {
        for (chunk, lanes) in residuals.chunks_mut(LANES).zip(&self.accepted) {
            chunk.copy_from_slice(&lanes[..chunk.len()]);
        }
    }
}

/// Steps that shrink less than this fraction make the descent use second derivatives.
pub(super) const SLOW_CONTRACTION: f64 = 0.1;

/// Where one descent ended.
pub(super) struct End {
    pub(super) pose: Pose,
    pub(super) rms: f64,
    pub(super) iterations: u32,
    pub(super) stop: Stop,
    /// Smallest pivot of the scaled normal equations: near 0 where lengths do not determine the pose.
    pub(super) pivot_ratio: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Stop {
    Stationary,
    /// No shorter step helped, though the steps had not become small.
    Stalled,
    IterationLimit,
    /// The start itself has no valid lengths.
    Degenerate,
}

impl Problem<'_> {
    /// Descends from one start.
    pub(super) fn descend(&self, start: &Pose, residuals: &mut Residuals) -> End {
        match self.model.dof() {
            2 => dispatch_narrow(Search::<2> { problem: self, start, residuals }),
            3 => dispatch_narrow(Search::<3> { problem: self, start, residuals }),
            _ => dispatch_narrow(Search::<6> { problem: self, start, residuals }),
        }
    }
}

/// The descent as a kernel over lanes of cables, for N degrees of freedom.
pub(super) struct Search<'a, const N: usize> {
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

/// A damped Gauss–Newton step.
struct Step<const N: usize> {
    /// In the robot's degrees of freedom.
    amounts: [f64; N],
    /// Length (m); angles times the platform radius.
    size: f64,
    pivot_ratio: f64,
}

impl<const N: usize> Kernel for Search<'_, N> {
    type Output = End;

    #[inline(always)]
    fn run<L: Lanes>(mut self, lanes: L) -> End {
        let settings = self.problem.settings;
        let mean_length = self.problem.mean_length;
        let tolerance = settings.pose_tolerance * mean_length.max(1.0);
        let mut pose = *self.start;
        let mut normal = Normal { cost: 0.0, right: [0.0; N], matrix: [[0.0; N]; N] };
        normal.cost = self.evaluate(lanes, &pose, Some(&mut normal));
        self.accept();
        let mut end = End { pose, rms: f64::NAN, iterations: 0, stop: Stop::IterationLimit, pivot_ratio: f64::NAN };
        if !normal.cost.is_finite() {
            return End { stop: Stop::Degenerate, ..end };
        }
        let mut damping = 0.0;
        let mut slow = false;
        let mut last_size = 0.0; // none yet: no rate of contraction to judge by
        while end.iterations < settings.max_iterations {
            end.iterations += 1;
            let matrix = if slow { normal.with(&self.problem.curvature(&pose)) } else { normal.matrix };
            let Some(step) = self.step(&normal, matrix, damping) else {
                if damping > 1e6 {
                    // some direction moves no cable at all
                    end.stop = Stop::Stationary;
                    break;
                }
                damping = f64::max(10.0 * damping, 1e-6);
                continue;
            };
            let plain = !slow && damping == 0.0;
            end.pivot_ratio = if plain { step.pivot_ratio } else { f64::NAN };
            let size = step.size;
            let contraction = size / last_size;
            // what the remaining steps add up to if they go on shrinking at this rate
            let settles =
                contraction < 0.5 && size * contraction <= tolerance * (1.0 - contraction) || size <= 1e-3 * tolerance;
            let trial = self.displaced(&pose, &step);
            let mut next = normal;
            next.cost = self.evaluate(lanes, &trial, if settles && plain { None } else { Some(&mut next) });
            // rounding of the cost: equal costs near the optimum must not look like a failure
            if next.cost <= normal.cost * (1.0 + 1e-12) + 1e-29 * mean_length * mean_length {
                self.accept();
                (pose, normal, last_size) = (trial, next, size);
                slow = contraction.is_finite() && contraction > SLOW_CONTRACTION;
                damping = if damping < 1e-9 { 0.0 } else { damping * 0.1 };
                if settles {
                    end.stop = Stop::Stationary;
                    break;
                }
            } else if size <= tolerance {
                end.stop = Stop::Stationary;
                break;
            } else if damping > 1e12 {
                end.stop = Stop::Stalled;
                break;
            } else {
                damping = f64::max(10.0 * damping, 1e-3);
                slow = true;
            }
        }
        if end.pivot_ratio.is_nan() {
            // neither damping nor curvature may hide that lengths do not determine the pose
            end.pivot_ratio = self.step(&normal, normal.matrix, 0.0).map_or(0.0, |step| step.pivot_ratio);
        }
        let count = self.problem.model.cable_count() as f64;
        End { pose, rms: (normal.cost / count).sqrt(), ..end }
    }
}

/// Sum of squared residuals at a pose, one pass over the cables, eight at a time; with the normal equations unless the
/// descent ends here anyway.
struct AtPose<'a, const N: usize> {
    problem: &'a Problem<'a>,
    pose: &'a Pose,
    /// Filled.
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
            let (course, lever) = group.courses(lanes, position, &rotation);
            let residual = course.length - lanes.load(targets);
            residual.store(residuals);
            let weight = lanes.load(&group.weight);
            let residual = residual * weight;
            cost += (residual * residual).sum();
            if let Some(normal) = &mut normal {
                let u = [course.direction[0] * weight, course.direction[1] * weight, course.direction[2] * weight];
                normal.add(in_basis(problem.model, lanes, u, cross(lever, u)), residual);
            }
        }
        cost
    }
}

impl<const N: usize> Search<'_, N> {
    #[inline(always)]
    fn evaluate<L: Lanes>(&mut self, lanes: L, pose: &Pose, normal: Option<&mut Normal<N>>) -> f64 {
        lanes.apart(AtPose { problem: self.problem, pose, residuals: &mut self.residuals.trial, normal })
    }

    /// Moves on to the trial.
    #[inline(always)]
    fn accept(&mut self) {
        let Residuals { accepted, trial } = &mut *self.residuals;
        for (accepted, trial) in accepted.iter_mut().zip(trial) {
            *accepted = *trial;
        }
    }

    /// The step by `matrix`, the normal matrix or that with curvature; nothing where it is not positive definite.
    #[inline(always)]
    fn step(&self, normal: &Normal<N>, mut matrix: [[f64; N]; N], damping: f64) -> Option<Step<N>> {
        let mut amounts = normal.right;
        for k in 0..N {
            matrix[k][k] += damping * normal.matrix[k][k];
        }
        let pivot_ratio = ldl::solve(&mut matrix, &mut amounts)?;
        let translations = self.problem.model.axes().len();
        let (mut shift_squared, mut turn_squared) = (0.0, 0.0);
        for k in 0..N {
            let square = amounts[k] * amounts[k];
            *(if k < translations { &mut shift_squared } else { &mut turn_squared }) += square;
        }
        // a step that turns the platform by more than half a radian says little about where it leads
        let mean_length = self.problem.mean_length;
        let largest = f64::max(turn_squared, shift_squared / (mean_length * mean_length)).sqrt();
        let shorten = if largest > 0.5 { 0.5 / largest } else { 1.0 };
        for amount in &mut amounts {
            *amount *= shorten;
        }
        let radius = self.problem.platform_radius;
        let size = shorten * (shift_squared + radius * radius * turn_squared).sqrt();
        Some(Step { amounts, size, pivot_ratio })
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

/// Room for the products of N rows and a residual with each other, the spatial case being the largest.
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
