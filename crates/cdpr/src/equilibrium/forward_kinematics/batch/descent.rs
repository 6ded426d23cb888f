//! Eight plain descents side by side, with the bits of the single one.

use super::{ITERATIONS, RMS, STATUS};
use crate::equilibrium::descents::{displaced, flag, product, settles};
use crate::equilibrium::forward_kinematics::descent::SLOW_CONTRACTION;
use crate::equilibrium::forward_kinematics::{Settings, Status};
use crate::geometry::{POSE_ROWS, in_lanes};
use crate::model::Model;
use crate::scalar::{Kernel, LANES, Lanes, Line, Unit, cross, dispatch_on, ldl};

/// Eight problems of a robot with six degrees of freedom and six to eight cables.
pub(super) struct Descents<'a> {
    pub(super) model: &'a Model,
    pub(super) settings: &'a Settings,
    pub(super) platform_radius: f64,
    pub(super) lengths: &'a [Line],
    pub(super) guesses: &'a [Line],
    pub(super) solutions: &'a mut [Line],
}

/// Sum of squares, gradient side and normal matrix.
struct Normal<L> {
    cost: L,
    right: [L; 6],
    /// Lower triangle.
    matrix: [[L; 6]; 6],
    /// 1 where a cable may have no course.
    doubt: L,
}

/// Where the eight descents stand; flags are 1 or 0.
struct State<L> {
    pose: [Line; POSE_ROWS],
    last_size: L,
    is_running: L,
    is_done: L,
    iterations: L,
    /// Sum of squared residuals at the pose.
    cost: L,
}

impl Descents<'_> {
    /// On an available unit; compiled here, once for library and tests.
    #[inline(never)]
    pub(super) fn run_on(self, unit: Unit) -> [bool; LANES] {
        dispatch_on(unit, self).unwrap_or_default()
    }
}

impl Kernel for Descents<'_> {
    /// Which of the eight are solved.
    type Output = [bool; LANES];

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> [bool; LANES] {
        let (zero, one) = (lanes.constant(0.0), lanes.constant(1.0));
        let mean_length = self.mean_length(lanes);
        let tolerance = lanes.constant(self.settings.pose_tolerance) * mean_length.max(one);
        let rounding = lanes.constant(1e-29) * mean_length * mean_length;
        let radius = lanes.constant(self.platform_radius);
        let mut trial = [Line::default(); POSE_ROWS];
        trial.copy_from_slice(self.guesses);
        let mut state = State {
            pose: trial,
            last_size: zero,
            is_running: one,
            is_done: zero,
            iterations: zero,
            cost: lanes.constant(f64::INFINITY),
        };
        // the guess is a trial like all others, so that the evaluation is compiled once
        let (mut size, mut contraction, mut last) = (zero, zero, zero);
        let mut most = state.cost;
        // a plain descent needs far fewer steps
        for _ in 0..=self.settings.max_iterations.min(30) {
            let all_end = !lanes.any(last.is_less(state.is_running));
            let mut normal = self.evaluate(lanes, &trial, !all_end);
            let falls = one - flag(most, most.is_less(normal.cost));
            let is_finite = flag(most, normal.cost.is_less(lanes.constant(f64::INFINITY)));
            state.is_running = state.is_running * falls * is_finite * (one - normal.doubt);
            state.accept(lanes, &trial, size, normal.cost);
            state.is_done = state.is_done.max(last * state.is_running);
            // steps that shrink slowly ask for second derivatives
            let is_slow = flag(size, lanes.constant(SLOW_CONTRACTION).is_less(contraction))
                * flag(size, contraction.is_less(lanes.constant(f64::INFINITY)));
            state.is_running = state.is_running * (one - last) * (one - is_slow);
            if !lanes.any(zero.is_less(state.is_running)) {
                break;
            }
            state.iterations = state.iterations + state.is_running;
            let mut step = normal.right;
            let is_regular = ldl::solve_in_lanes(self.model.dof(), &mut normal.matrix, &mut step);
            let shift_squared = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
            let turn_squared = step[3] * step[3] + step[4] * step[4] + step[5] * step[5];
            let largest_squared = turn_squared.max(shift_squared / (mean_length * mean_length));
            let is_short = flag(largest_squared, largest_squared.is_less(lanes.constant(0.2499)));
            state.is_running = state.is_running * is_regular * is_short;
            size = (shift_squared + radius * radius * turn_squared).sqrt();
            contraction = size / state.last_size;
            last = settles(size, contraction, tolerance);
            most = state.cost * lanes.constant(1.0 + 1e-12) + rounding;
            trial = displaced(lanes, &state.pose, &step);
        }
        self.conclude(lanes, &state, mean_length)
    }
}

impl<L: Lanes> State<L> {
    /// Moves on to the trial where the descent still runs.
    #[inline(always)]
    fn accept(&mut self, lanes: L, trial: &[Line; POSE_ROWS], size: L, cost: L) {
        let runs = lanes.constant(0.0).is_less(self.is_running);
        for (pose, trial) in self.pose.iter_mut().zip(trial) {
            lanes.load(&trial.0).select(runs, lanes.load(&pose.0)).store(&mut pose.0);
        }
        self.last_size = size.select(runs, self.last_size);
        self.cost = cost.select(runs, self.cost);
    }
}

impl Descents<'_> {
    #[inline(always)]
    fn mean_length<L: Lanes>(&self, lanes: L) -> L {
        let mut sum = lanes.constant(0.0);
        for line in self.lengths {
            sum = sum + lanes.load(&line.0);
        }
        sum / lanes.constant(self.lengths.len() as f64)
    }

    /// Sum of squared residuals, with the normal equations where they are asked for; sums over cables in the order of
    /// [`Lanes::sum`].
    #[inline(always)]
    fn evaluate<L: Lanes>(&self, lanes: L, pose: &[Line; POSE_ROWS], with_matrix: bool) -> Normal<L> {
        let zero = lanes.constant(0.0);
        let (position, rotation) = in_lanes(lanes, pose);
        let mut rows = [[zero; LANES]; 7];
        let mut doubt = zero;
        for (cable, length) in self.lengths.iter().enumerate() {
            let found = self.model.groups()[0].course_in_lanes(cable, position, &rotation);
            let u = found.course.direction;
            let moment = cross(found.lever, u);
            for axis in 0..3 {
                rows[axis][cable] = u[axis];
                rows[3 + axis][cable] = moment[axis];
            }
            rows[6][cable] = found.course.length - lanes.load(&length.0);
            doubt = doubt.max(found.doubt);
        }
        let mut normal = Normal { cost: zero, right: [zero; 6], matrix: [[zero; 6]; 6], doubt };
        normal.cost = product(&rows[6], &rows[6]);
        if with_matrix {
            for i in 0..self.model.dof() {
                normal.right[i] = product(&rows[i], &rows[6]);
                for j in 0..=i {
                    normal.matrix[i][j] = product(&rows[i], &rows[j]);
                }
            }
        }
        normal
    }

    /// Writes the solutions; which of them are those of a good plain descent.
    #[inline(always)]
    fn conclude<L: Lanes>(self, lanes: L, state: &State<L>, mean_length: L) -> [bool; LANES] {
        let one = lanes.constant(1.0);
        let settings = self.settings;
        let rms = (state.cost / lanes.constant(self.lengths.len() as f64)).sqrt();
        let plausible = lanes.constant(settings.plausible_residual) * mean_length;
        let most = match self.lengths.len() == self.model.dof() {
            true => plausible.min(lanes.constant(settings.length_tolerance) * mean_length.max(one)),
            false => plausible,
        };
        let is_good = one - flag(one, most.is_less(rms));
        let is_done = (state.is_done * is_good).to_array();
        self.solutions[..POSE_ROWS].copy_from_slice(&state.pose);
        rms.store(&mut self.solutions[RMS].0);
        state.iterations.store(&mut self.solutions[ITERATIONS].0);
        self.solutions[STATUS].0 = [Status::Converged.code(); LANES];
        let mut done = [false; LANES];
        for lane in 0..LANES {
            done[lane] = is_done[lane] > 0.0;
        }
        done
    }
}
