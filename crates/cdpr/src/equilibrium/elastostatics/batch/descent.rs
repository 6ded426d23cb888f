//! Eight plain descents of the energy side by side, with the bits of the single one.

use super::unsymmetric::unsymmetric;
use super::{ITERATIONS, RMS, STATUS, TENSIONS};
use crate::equilibrium::descents::{displaced, flag, settles, sum};
use crate::equilibrium::elastostatics::balance::{Pull, TERMS, stiffness_terms};
use crate::equilibrium::elastostatics::search::ROUNDING;
use crate::equilibrium::elastostatics::{LoadParts, Settings, Status};
use crate::geometry::{POSE_ROWS, in_lanes};
use crate::model::Model;
use crate::scalar::{Kernel, LANES, Lanes, Line, Unit, constants, cross, dispatch_on, dot, ldl};

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

/// A residual wrench must shrink to less than this share of its square; the single descent asks for a quarter.
const CUT: f64 = 0.2499;
/// Stiffness that is certainly above what the single pose calls indifferent, as a share of the sum over cables.
const STABLE: f64 = 2e-9;

/// The balance at eight poses.
#[derive(Clone, Copy)]
struct Point<L> {
    /// Aᵀ f + w.
    residual: [L; 6],
    /// Lower triangle.
    stiffness: [[L; 6]; 6],
    /// Above 0 where a cable may have no course.
    doubt: L,
}

/// Where the eight descents stand; flags are 1 or 0.
struct State<L> {
    pose: [Line; POSE_ROWS],
    tensions: [Line; LANES],
    last_size: L,
    residual_squared: L,
    is_running: L,
    is_done: L,
    iterations: L,
}

impl Descents<'_> {
    /// On an available unit; compiled here, once for library and tests.
    #[inline(never)]
    pub(super) fn run_on(self, unit: Unit) -> [Ending; LANES] {
        dispatch_on(unit, self).unwrap_or_default()
    }
}

/// What became of one of the eight.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Ending {
    /// It takes more than a plain descent.
    #[default]
    Open,
    /// A stable equilibrium without slack cables.
    Solved,
    /// An equilibrium of bars, one of which pushes: as cables they would not all be taut.
    Pushes,
}

impl Kernel for Descents<'_> {
    type Output = [Ending; LANES];

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> [Ending; LANES] {
        let (zero, one) = (lanes.constant(0.0), lanes.constant(1.0));
        let mean_length = self.mean_length(lanes);
        let tolerance = lanes.constant(self.settings.pose_tolerance) * mean_length.max(one);
        let radius = lanes.constant(self.platform_radius);
        let (springs, stiffness_scale) = self.springs(lanes);
        let mut trial = [Line::default(); POSE_ROWS];
        trial.copy_from_slice(self.guesses);
        let mut tensions = [Line::default(); LANES];
        let mut state = State {
            pose: trial,
            tensions,
            last_size: zero,
            residual_squared: lanes.constant(f64::INFINITY),
            is_running: one,
            is_done: zero,
            iterations: zero,
        };
        // the guess is a trial like all others, so that the evaluation is compiled once
        let (mut size, mut last) = (zero, zero);
        let mut before = [[zero; 6]; 6];
        let mut stiffness = before;
        let mut terms = [[zero; TERMS]; LANES];
        // a plain descent needs far fewer steps
        for _ in 0..=self.settings.max_iterations.min(30) {
            let all_end = !lanes.any(last.is_less(state.is_running));
            let point = self.evaluate(lanes, &trial, &springs, (&mut tensions, &mut terms), !all_end);
            let residual_squared = self.squared(&point.residual);
            let is_cut = flag(one, residual_squared.is_less(lanes.constant(CUT) * state.residual_squared));
            let has_courses = one - flag(one, zero.is_less(point.doubt));
            state.is_running = state.is_running * is_cut * has_courses;
            state.accept(lanes, &trial, &tensions, [size, residual_squared]);
            let ends = zero.is_less(state.is_running * last);
            if lanes.any(ends) {
                for row in 0..self.model.dof() {
                    for column in 0..=row {
                        // the stiffness of an end is that before its last step
                        stiffness[row][column] = before[row][column].select(ends, stiffness[row][column]);
                    }
                }
            }
            before = point.stiffness;
            state.is_done = one.select(ends, state.is_done);
            state.is_running = state.is_running * (one - last);
            if !lanes.any(zero.is_less(state.is_running)) {
                break;
            }
            state.iterations = state.iterations + state.is_running;
            let (step, is_regular) = self.step(&point);
            let shift_squared = step[0] * step[0] + step[1] * step[1] + step[2] * step[2];
            let turn_squared = step[3] * step[3] + step[4] * step[4] + step[5] * step[5];
            let largest_squared = turn_squared.max(shift_squared / (mean_length * mean_length));
            let is_short = flag(one, largest_squared.is_less(lanes.constant(0.2499)));
            state.is_running = state.is_running * is_regular * is_short;
            size = (shift_squared + radius * radius * turn_squared).sqrt();
            last = settles(size, size / state.last_size, tolerance);
            trial = displaced(lanes, &state.pose, &step);
        }
        self.conclude(lanes, &state, stiffness, [stiffness_scale, mean_length])
    }
}

impl<L: Lanes> State<L> {
    /// Moves on to the trial where the descent still runs.
    #[inline(always)]
    fn accept(
        &mut self,
        lanes: L,
        trial: &[Line; POSE_ROWS],
        tensions: &[Line; LANES],
        [size, residual_squared]: [L; 2],
    ) {
        let runs = lanes.constant(0.0).is_less(self.is_running);
        let here = self.pose.iter_mut().chain(&mut self.tensions);
        for (here, there) in here.zip(trial.iter().chain(tensions)) {
            lanes.load(&there.0).select(runs, lanes.load(&here.0)).store(&mut here.0);
        }
        self.last_size = size.select(runs, self.last_size);
        self.residual_squared = residual_squared.select(runs, self.residual_squared);
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

    /// Size of a wrench squared, moments divided by the platform radius.
    #[inline(always)]
    fn squared<L: Lanes>(&self, wrench: &[L; 6]) -> L {
        let by_radius = wrench[0].constant(1.0 / self.platform_radius);
        let mut sum = wrench[0].constant(0.0);
        for k in 0..6 {
            let entry = if k < 3 { wrench[k] } else { wrench[k] * by_radius };
            sum = sum + entry * entry;
        }
        sum
    }

    /// The undamped Newton step, and 1 where the stiffness is clearly positive definite.
    #[inline(always)]
    fn step<L: Lanes>(&self, point: &Point<L>) -> ([L; 6], L) {
        let (mut matrix, mut amounts) = (point.stiffness, point.residual);
        let is_regular = ldl::solve_in_lanes(self.model.dof(), &mut matrix, &mut amounts);
        if self.load.constant[3..].iter().any(|&moment| moment != 0.0) {
            amounts = unsymmetric(self.model.dof(), &point.stiffness, &point.residual, &self.load.constant);
        }
        (amounts, is_regular)
    }

    /// Residual, tensions and, where it is asked for, stiffness; `terms` are the cables' shares, which stay zeros where there is
    /// no cable.
    #[inline(always)]
    fn evaluate<L: Lanes>(
        &self,
        lanes: L,
        pose: &[Line; POSE_ROWS],
        springs: &[L; LANES],
        (tensions, terms): (&mut [Line; LANES], &mut [[L; TERMS]; LANES]),
        with_stiffness: bool,
    ) -> Point<L> {
        let (zero, one) = (lanes.constant(0.0), lanes.constant(1.0));
        let (position, rotation) = in_lanes(lanes, pose);
        let mut doubt = zero;
        for (cable, length) in self.lengths.iter().enumerate() {
            let found = self.model.groups()[0].course_in_lanes(cable, position, &rotation);
            let (u, lever) = (found.course.direction, found.lever);
            let force_at_rest = springs[cable] * (found.course.length - lanes.load(&length.0));
            let softer = one / (one + lanes.constant(self.model.elasticity(cable).by_length) * force_at_rest);
            let stiffness = springs[cable] * softer * softer;
            let pull = Pull { tension: force_at_rest * softer, stiffness, energy: zero };
            pull.tension.store(&mut tensions[cable].0);
            let moment = cross(lever, u);
            for k in 0..3 {
                terms[cable][1 + k] = pull.tension * u[k];
                terms[cable][4 + k] = pull.tension * moment[k];
            }
            if with_stiffness {
                stiffness_terms(&mut terms[cable], &found.course.direction_gradient, u, lever, &pull);
            }
            doubt = doubt.max(found.doubt);
        }
        let mut totals = [zero; TERMS];
        for term in 1..if with_stiffness { TERMS } else { 7 } {
            let mut cables = [zero; LANES];
            for cable in 0..LANES {
                cables[cable] = terms[cable][term];
            }
            totals[term] = sum(cables);
        }
        let mut point = unpack(zero, &totals, doubt);
        self.add_load(&mut point, &rotation);
        point
    }

    #[inline(always)]
    fn add_load<L: Lanes>(&self, point: &mut Point<L>, rotation: &[[L; 3]; 3]) {
        let (load, l) = (&self.load, point.doubt);
        let center = constants(l, load.center_of_mass);
        let c = [dot(rotation[0], center), dot(rotation[1], center), dot(rotation[2], center)];
        let g = constants(l, load.weight);
        let moment = cross(c, g);
        for k in 0..3 {
            point.residual[k] = point.residual[k] + (l.constant(load.constant[k]) + g[k]);
            point.residual[3 + k] = point.residual[3 + k] + (l.constant(load.constant[3 + k]) + moment[k]);
        }
        let product = dot(g, c);
        for i in 0..3 {
            for j in 0..=i {
                let half = l.constant(0.5) * (c[i] * g[j] + c[j] * g[i]);
                point.stiffness[3 + i][3 + j] = point.stiffness[3 + i][3 + j] - half;
            }
            point.stiffness[3 + i][3 + i] = point.stiffness[3 + i][3 + i] + product;
        }
    }

    /// Writes the solutions and tells what they are.
    #[inline(always)]
    fn conclude<L: Lanes>(
        self,
        lanes: L,
        state: &State<L>,
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
        for tension in &state.tensions[..self.lengths.len()] {
            let tension = lanes.load(&tension.0);
            pushes = one.select(tension.is_less(zero), pushes);
            pull = pull + tension.abs();
            least_tension = least_tension.min(tension);
        }
        // clearly in balance and clearly taut; what is not clear is the single pose's to decide
        let undecided = lanes.constant(self.settings.wrench_tolerance) * pull;
        let most = lanes.constant(0.25) * undecided * undecided;
        let is_clear = flag(one, state.residual_squared.is_less(most))
            * flag(
                one,
                (lanes.constant(2.0) * (undecided + lanes.constant(ROUNDING) * scale * mean_length))
                    .is_less(least_tension),
            );
        let is_solved = state.is_done * is_stable * is_clear * (one - pushes);
        self.solutions[..POSE_ROWS].copy_from_slice(&state.pose);
        self.solutions[RMS].0 = [0.0; LANES];
        state.iterations.store(&mut self.solutions[ITERATIONS].0);
        self.solutions[STATUS].0 = [Status::Converged.code(); LANES];
        self.solutions[TENSIONS..].copy_from_slice(&state.tensions[..self.lengths.len()]);
        let (solved, pushing) = (is_solved.to_array(), (state.is_done * pushes).to_array());
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

/// The order of the terms, undone.
#[inline(always)]
fn unpack<L: Lanes>(zero: L, totals: &[L; TERMS], doubt: L) -> Point<L> {
    let mut point = Point { residual: [zero; 6], stiffness: [[zero; 6]; 6], doubt };
    point.residual.copy_from_slice(&totals[1..7]);
    let mut count = 7;
    for i in 0..3 {
        for j in 0..=i {
            point.stiffness[i][j] = totals[count];
            point.stiffness[3 + i][3 + j] = totals[count + 1];
            count += 2;
        }
    }
    for i in 0..3 {
        for j in 0..3 {
            point.stiffness[3 + i][j] = totals[count];
            count += 1;
        }
    }
    point
}
