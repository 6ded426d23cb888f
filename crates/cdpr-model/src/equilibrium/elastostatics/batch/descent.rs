//! Eight plain descents of the energy side by side, with the bits of the single descent.

use super::{ITERATIONS, RMS, STATUS, TENSIONS};
use crate::equilibrium::elastostatics::balance::{Pull, TERMS, force_terms, stiffness_terms, unpack};
use crate::equilibrium::elastostatics::problem::squared;
use crate::equilibrium::elastostatics::search::ROUNDING;
use crate::equilibrium::elastostatics::{LoadParts, Settings, Status, unsymmetric};
use crate::equilibrium::pose_step::{Measure, accept_lines, displaced_lines, mean_length, sum};
use crate::geometry::{POSE_ROWS, in_lanes};
use crate::model::Model;
use crate::scalar::{Kernel, LANES, Lanes, Line, Unit, dispatch_on, ldl};
use crate::solve::{self, Control, Rules, Step, StepRule, Stop, Trial, descend};

/// Eight problems of a robot with six degrees of freedom and six to eight linearly elastic cables.
pub(super) struct Descents<'a> {
    pub(super) model: &'a Model,
    pub(super) settings: &'a Settings,
    pub(super) load: LoadParts,
    pub(super) platform_radius: f64,
    pub(super) lengths: &'a [Line],
    pub(super) guesses: &'a [Line],
    pub(super) solutions: &'a mut [Line],
}

/// Largest ratio of the squared residual wrench after and before a step; the single descent allows a quarter.
const CUT: f64 = 0.2499;
/// Stiffness that is certainly above the single solver's limit of indifference, as a fraction of the sum over cables.
const STABLE: f64 = 2e-9;

/// The balance at eight poses.
#[derive(Clone, Copy)]
struct Point<L> {
    /// Aᵀ f + w.
    residual: [L; 6],
    /// Lower triangle.
    stiffness: [[L; 6]; 6],
    /// Above 0 if a cable may have no path.
    needs_scalar: L,
}

impl Descents<'_> {
    /// Runs on an available unit; compiled only here, for library and tests.
    #[inline(never)]
    pub(super) fn run_on(self, unit: Unit) -> [Ending; LANES] {
        dispatch_on(unit, self).unwrap_or_default()
    }
}

/// Ending of a plain descent for one of eight platforms.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Ending {
    /// It needs more than a plain descent.
    #[default]
    Open,
    /// A stable equilibrium without slack cables.
    Solved,
    /// An equilibrium of bars, one of which pushes: as cables they would not all be taut.
    Pushes,
}

/// Energy of eight platforms, as a problem of the common descent loop.
struct Eight<'a, L> {
    lanes: L,
    descents: &'a Descents<'a>,
    measure: Measure<L>,
    /// Stiffness of the cables at rest (N/m).
    springs: [L; LANES],
    pose: [Line; POSE_ROWS],
    trial: [Line; POSE_ROWS],
    tensions: [Line; LANES],
    trial_tensions: [Line; LANES],
    /// Terms of the cables; zeros in lanes without a cable.
    terms: [[L; TERMS]; LANES],
    /// Equations of the trial: a plain step is always accepted or ends the descent. The stiffness at the end is the one
    /// before the last step.
    point: Point<L>,
    trial_squared: L,
    /// Residual wrench at the pose, squared (N²).
    residual_squared: L,
}

impl Kernel for Descents<'_> {
    type Output = [Ending; LANES];

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> [Ending; LANES] {
        let (zero, one, infinite) = (lanes.constant(0.0), lanes.constant(1.0), lanes.constant(f64::INFINITY));
        let mean_length = mean_length(lanes, self.lengths);
        let (springs, stiffness_scale) = self.springs(lanes);
        let mut start = [Line::default(); POSE_ROWS];
        start.copy_from_slice(self.guesses);
        let mut eight = Eight {
            lanes,
            descents: &self,
            measure: Measure { translations: 3, mean_length, platform_radius: lanes.constant(self.platform_radius) },
            springs,
            pose: start,
            trial: start,
            tensions: [Line::default(); LANES],
            trial_tensions: [Line::default(); LANES],
            terms: [[zero; TERMS]; LANES],
            point: Point { residual: [zero; 6], stiffness: [[zero; 6]; 6], needs_scalar: zero },
            trial_squared: infinite,
            residual_squared: infinite,
        };
        let rules = Rules {
            tolerance: lanes.constant(self.settings.pose_tolerance) * mean_length.max(one),
            // a plain descent needs far fewer steps
            max_iterations: self.settings.max_iterations.min(30),
            least_gain: 0.0,
            rule: StepRule::Plain { slowest: f64::INFINITY },
        };
        let end = descend(&mut eight, &rules);
        let is_done = end.is(Stop::Stationary);
        let Eight { pose, tensions, point, residual_squared, .. } = eight;
        let ended = Ended { pose, tensions, residual_squared, is_done, iterations: end.iterations };
        self.conclude(lanes, &ended, point.stiffness, [stiffness_scale, mean_length])
    }
}

/// Ends of the eight descents.
struct Ended<L: Lanes> {
    pose: [Line; POSE_ROWS],
    tensions: [Line; LANES],
    residual_squared: L,
    is_done: L::Mask,
    iterations: L,
}

impl<L: Lanes> solve::Problem for Eight<'_, L> {
    type Number = L;

    /// The undamped Newton step, regular if the stiffness is clearly positive definite.
    #[inline(always)]
    fn step(&mut self, _: &Control<L>) -> Step<L> {
        let (l, descents) = (self.lanes, self.descents);
        let (mut matrix, mut amounts) = (self.point.stiffness, self.point.residual);
        let is_regular = ldl::solve_in_lanes(descents.model.dof(), &mut matrix, &mut amounts);
        let moment = &descents.load.constant;
        if moment[3..].iter().any(|&moment| moment != 0.0) {
            amounts = unsymmetric::solve(descents.model.dof(), &self.point.stiffness, &self.point.residual, moment);
        }
        let size = self.measure.shorten(&mut amounts);
        self.trial = displaced_lines(l, &self.pose, &amounts);
        Step::whole(size, l.constant(0.0).is_less(is_regular))
    }

    #[inline(always)]
    fn evaluate(&mut self, _: L, is_last: bool) -> Trial<L> {
        let l = self.lanes;
        let Self { descents, trial, springs, trial_tensions, terms, .. } = self;
        let next = descents.evaluate(l, trial, springs, (trial_tensions, terms), !is_last);
        let stiffness = if is_last { self.point.stiffness } else { next.stiffness };
        self.point = Point { stiffness, ..next };
        self.trial_squared = squared(&next.residual, 3, descents.platform_radius);
        let is_cut = self.trial_squared.is_less(l.constant(CUT) * self.residual_squared);
        Trial::new(l, l.without(is_cut, l.constant(0.0).is_less(next.needs_scalar)))
    }

    #[inline(always)]
    fn accept(&mut self, helps: L::Mask, _: L) {
        accept_lines(self.lanes, helps, &mut self.pose, &self.trial);
        accept_lines(self.lanes, helps, &mut self.tensions, &self.trial_tensions);
        self.residual_squared = self.trial_squared.select(helps, self.residual_squared);
    }

    /// Never at rest: the single solver decides these cases.
    #[inline(always)]
    fn rests(&mut self, size: L, _: L) -> L::Mask {
        size.everywhere(false)
    }
}

impl Descents<'_> {
    /// Stiffness of the cables at rest, and its sum (N/m).
    #[inline(always)]
    fn springs<L: Lanes>(&self, lanes: L) -> ([L; LANES], L) {
        let mut springs = [lanes.constant(0.0); LANES];
        let mut sum = lanes.constant(0.0);
        for (cable, line) in self.lengths.iter().enumerate() {
            let law = self.model.elasticity(cable);
            let length = lanes.load(&line.0);
            let compliance = lanes.constant(law.by_length) * length
                + lanes.constant(law.by_controlled_length) * length
                + lanes.constant(law.constant);
            springs[cable] = lanes.constant(1.0) / compliance;
            sum = sum + springs[cable];
        }
        (springs, sum)
    }

    /// Residual, tensions and, on request, stiffness; `terms` are those of the cables, zeros in lanes without a cable.
    #[inline(always)]
    fn evaluate<L: Lanes>(
        &self,
        lanes: L,
        pose: &[Line; POSE_ROWS],
        springs: &[L; LANES],
        (tensions, terms): (&mut [Line; LANES], &mut [[L; TERMS]; LANES]),
        with_stiffness: bool,
    ) -> Point<L> {
        let zero = lanes.constant(0.0);
        let (position, rotation) = in_lanes(lanes, pose);
        let mut needs_scalar = zero;
        for (cable, length) in self.lengths.iter().enumerate() {
            let found = self.model.groups()[0].path_in_lanes(cable, position, &rotation);
            let (u, moment_arm) = (found.path.direction, found.moment_arm);
            let by_length = lanes.constant(self.model.elasticity(cable).by_length);
            let stretch = found.path.length - lanes.load(&length.0);
            let pull = Pull::without_energy(springs[cable], by_length, stretch);
            pull.tension.store(&mut tensions[cable].0);
            force_terms(&mut terms[cable], u, moment_arm, pull.tension);
            if with_stiffness {
                stiffness_terms(&mut terms[cable], &found.path.direction_gradient, u, moment_arm, &pull);
            }
            needs_scalar = needs_scalar.max(found.needs_scalar);
        }
        let mut totals = [zero; TERMS];
        for term in 1..if with_stiffness { TERMS } else { 7 } {
            let mut cables = [zero; LANES];
            for cable in 0..LANES {
                cables[cable] = terms[cable][term];
            }
            totals[term] = sum(cables);
        }
        let (mut residual, mut stiffness) = unpack(&totals);
        self.load.add_to(&mut residual, &mut stiffness, &rotation);
        Point { residual, stiffness, needs_scalar }
    }

    /// Writes the solutions and returns the ending of each descent.
    #[inline(always)]
    fn conclude<L: Lanes>(
        self,
        lanes: L,
        ended: &Ended<L>,
        mut stiffness: [[L; 6]; 6],
        [scale, mean_length]: [L; 2],
    ) -> [Ending; LANES] {
        let (zero, one) = (lanes.constant(0.0), lanes.constant(1.0));
        let least = lanes.constant(STABLE) * scale;
        for row in 0..6 {
            let radius = if row < 3 { 1.0 } else { self.platform_radius };
            stiffness[row][row] = stiffness[row][row] - least * lanes.constant(radius * radius);
        }
        let is_stable = ldl::solve_in_lanes(self.model.dof(), &mut stiffness, &mut [zero; 6]);
        let load = |force: &[f64]| lanes.constant(force.iter().map(|entry| entry * entry).sum::<f64>().sqrt());
        let mut pull = load(&self.load.constant[..3]) + load(&self.load.weight);
        let (mut pushes, mut least_tension) = (zero, lanes.constant(f64::INFINITY));
        for tension in &ended.tensions[..self.lengths.len()] {
            let tension = lanes.load(&tension.0);
            pushes = one.select(tension.is_less(zero), pushes);
            pull = pull + tension.abs();
            least_tension = least_tension.min(tension);
        }
        // clearly in balance and clearly taut; the single solver decides the other cases
        let undecided = lanes.constant(self.settings.wrench_tolerance) * pull;
        let most = lanes.constant(0.25) * undecided * undecided;
        let clear_tension = lanes.constant(2.0) * (undecided + lanes.constant(ROUNDING) * scale * mean_length);
        let is_clear = lanes.both(ended.residual_squared.is_less(most), clear_tension.is_less(least_tension));
        let is_done = one.select(ended.is_done, zero);
        let is_solved = is_done.select(is_clear, zero) * is_stable * (one - pushes);
        self.solutions[..POSE_ROWS].copy_from_slice(&ended.pose);
        self.solutions[RMS].0 = [0.0; LANES];
        ended.iterations.store(&mut self.solutions[ITERATIONS].0);
        self.solutions[STATUS].0 = [Status::Converged.code(); LANES];
        self.solutions[TENSIONS..].copy_from_slice(&ended.tensions[..self.lengths.len()]);
        let (solved, pushing) = (is_solved.to_array(), (is_done * pushes).to_array());
        let mut endings = [Ending::Open; LANES];
        for lane in 0..LANES {
            if solved[lane] > 0.0 {
                endings[lane] = Ending::Solved;
            } else if pushing[lane] > 0.0 {
                endings[lane] = Ending::Pushes;
            }
        }
        endings
    }
}
