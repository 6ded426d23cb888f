//! Eight plain descents side by side, with the bits of the single descent.

use super::{ITERATIONS, RMS, STATUS};
use crate::equilibrium::forward_kinematics::descent::{SLOW_CONTRACTION, is_no_higher, rounding_of};
use crate::equilibrium::forward_kinematics::{Settings, Status};
use crate::equilibrium::pose_step::{Measure, accept_lines, displaced_lines, mean_length, product};
use crate::geometry::{POSE_ROWS, in_lanes};
use crate::model::Model;
use crate::scalar::{Kernel, LANES, Lanes, Line, Unit, cross, dispatch_on, ldl};
use crate::solve::{self, Control, DescentEnd, Rules, Step, StepRule, Stop, Trial, descend};

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
#[derive(Clone, Copy)]
struct Normal<L> {
    cost: L,
    right: [L; 6],
    /// Lower triangle.
    matrix: [[L; 6]; 6],
    /// 1 if a cable may have no path.
    needs_scalar: L,
}

impl Descents<'_> {
    /// Runs on an available unit; compiled only here, for library and tests.
    #[inline(never)]
    pub(super) fn run_on(self, unit: Unit) -> [bool; LANES] {
        dispatch_on(unit, self).unwrap_or_default()
    }
}

/// Least squares of eight sets of lengths, as a problem of the common descent loop.
struct Eight<'a, L> {
    lanes: L,
    model: &'a Model,
    lengths: &'a [Line],
    measure: Measure<L>,
    /// Cost that counts as rounding (m²).
    rounding: L,
    pose: [Line; POSE_ROWS],
    trial: [Line; POSE_ROWS],
    /// Sum of squared residuals at the pose.
    cost: L,
    /// Equations of the trial: a plain step is always accepted or ends the descent.
    normal: Normal<L>,
}

impl Kernel for Descents<'_> {
    /// True for each of the eight that is solved.
    type Output = [bool; LANES];

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> [bool; LANES] {
        let (zero, one) = (lanes.constant(0.0), lanes.constant(1.0));
        let mean_length = mean_length(lanes, self.lengths);
        let mut start = [Line::default(); POSE_ROWS];
        start.copy_from_slice(self.guesses);
        let mut eight = Eight {
            lanes,
            model: self.model,
            lengths: self.lengths,
            measure: Measure { translations: 3, mean_length, platform_radius: lanes.constant(self.platform_radius) },
            rounding: rounding_of(mean_length),
            pose: start,
            trial: start,
            cost: lanes.constant(f64::INFINITY),
            normal: Normal { cost: zero, right: [zero; 6], matrix: [[zero; 6]; 6], needs_scalar: zero },
        };
        let rules = Rules {
            tolerance: lanes.constant(self.settings.pose_tolerance) * mean_length.max(one),
            // a plain descent needs far fewer steps
            max_iterations: self.settings.max_iterations.min(30),
            least_gain: 0.0,
            rule: StepRule::Plain { slowest: SLOW_CONTRACTION },
        };
        let end = descend(&mut eight, &rules);
        self.conclude(&eight, &end)
    }
}

impl<L: Lanes> solve::Problem for Eight<'_, L> {
    type Number = L;

    #[inline(always)]
    fn step(&mut self, _: &Control<L>) -> Step<L> {
        let l = self.lanes;
        let mut amounts = self.normal.right;
        let is_regular = ldl::solve_in_lanes(self.model.dof(), &mut self.normal.matrix, &mut amounts);
        let size = self.measure.shorten(&mut amounts);
        self.trial = displaced_lines(l, &self.pose, &amounts);
        Step::whole(size, l.constant(0.0).is_less(is_regular))
    }

    #[inline(always)]
    fn evaluate(&mut self, _: L, is_last: bool) -> Trial<L> {
        let l = self.lanes;
        self.normal = self.equations(!is_last);
        let has_paths = self.normal.needs_scalar.is_less(l.constant(0.5));
        Trial::new(l, l.both(is_no_higher(self.normal.cost, self.cost, self.rounding), has_paths))
    }

    #[inline(always)]
    fn accept(&mut self, helps: L::Mask, _: L) {
        accept_lines(self.lanes, helps, &mut self.pose, &self.trial);
        self.cost = self.normal.cost.select(helps, self.cost);
    }
}

impl<L: Lanes> Eight<'_, L> {
    /// Sum of squared residuals, on request with the normal equations; sums over cables in the order of [`Lanes::sum`].
    #[inline(always)]
    fn equations(&self, with_matrix: bool) -> Normal<L> {
        let (lanes, pose) = (self.lanes, &self.trial);
        let zero = lanes.constant(0.0);
        let (position, rotation) = in_lanes(lanes, pose);
        let mut rows = [[zero; LANES]; 7];
        let mut needs_scalar = zero;
        for (cable, length) in self.lengths.iter().enumerate() {
            let found = self.model.groups()[0].path_in_lanes(cable, position, &rotation);
            let u = found.path.direction;
            let moment = cross(found.moment_arm, u);
            for axis in 0..3 {
                rows[axis][cable] = u[axis];
                rows[3 + axis][cable] = moment[axis];
            }
            rows[6][cable] = found.path.length - lanes.load(&length.0);
            needs_scalar = needs_scalar.max(found.needs_scalar);
        }
        let mut normal = Normal { cost: zero, right: [zero; 6], matrix: [[zero; 6]; 6], needs_scalar };
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
}

impl Descents<'_> {
    /// Writes the solutions; true for each that a good plain descent has found.
    #[inline(always)]
    fn conclude<L: Lanes>(self, eight: &Eight<'_, L>, end: &DescentEnd<L>) -> [bool; LANES] {
        let (lanes, mean_length) = (eight.lanes, eight.measure.mean_length);
        let (settings, one) = (self.settings, lanes.constant(1.0));
        let rms = (eight.cost / lanes.constant(self.lengths.len() as f64)).sqrt();
        let plausible = lanes.constant(settings.plausible_residual) * mean_length;
        let most = match self.lengths.len() == self.model.dof() {
            true => plausible.min(lanes.constant(settings.length_tolerance) * mean_length.max(one)),
            false => plausible,
        };
        let is_done = lanes.without(end.is(Stop::Stationary), most.is_less(rms));
        let is_done = one.select(is_done, lanes.constant(0.0)).to_array();
        self.solutions[..POSE_ROWS].copy_from_slice(&eight.pose);
        rms.store(&mut self.solutions[RMS].0);
        end.iterations.store(&mut self.solutions[ITERATIONS].0);
        self.solutions[STATUS].0 = [Status::Converged.code(); LANES];
        let mut done = [false; LANES];
        for lane in 0..LANES {
            done[lane] = is_done[lane] > 0.0;
        }
        done
    }
}
