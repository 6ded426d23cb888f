//! Damped Gauss–Newton descent of one cable's block, within bounds.

use super::{Settings, prior_sigma};
use crate::blocks::{Block, SLOTS};
use crate::further::FURTHER;
use crate::normal_equations::{NormalEquations, exact};
use crate::pose_lanes::{CableValues, PoseLanes};
use crate::quadratic::Quadratic;
use crate::stopping::StoppedBy;
use crate::trail::Trail;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::ldl;
use cdpr_model::solve::{
    self, Control, NormalSystem, OF_SINGULAR, REGULAR, ROUNDING_GAIN, Room, Rules, Step, StepRule, Stop, Surroundings,
    Trial, descend, minimizer,
};

/// Steps that are recorded without allocating again; few descents take more.
const HISTORY_CAPACITY: usize = 16;

/// End of the descent of one block.
#[derive(Clone)]
pub(super) struct End {
    pub(super) values: CableValues,
    /// Change of the parameters from the block's start values.
    pub(super) change: Vec<f64>,
    pub(super) cost: f64,
    pub(super) iterations: u32,
    pub(super) trail: Trail,
    pub(super) stopped: StoppedBy,
}

/// Calls a method of the search with room for the parameters of the block: exact for what is chosen most often.
macro_rules! search {
    ($block:ident, $poses:ident, $settings:ident, $method:ident($($argument:expr),+)) => {
        match $block.parameters.len() {
            3 => Search::<3>::new($block, $poses, $settings).$method($($argument),+),
            4 => Search::<4>::new($block, $poses, $settings).$method($($argument),+),
            6 => Search::<6>::new($block, $poses, $settings).$method($($argument),+),
            8 => Search::<8>::new($block, $poses, $settings).$method($($argument),+),
            _ => Search::<{ SLOTS + FURTHER }>::new($block, $poses, $settings).$method($($argument),+),
        }
    };
}

/// Descends from the block's start values, or from a change of them that an earlier descent found.
pub(super) fn run(block: &Block, poses: &PoseLanes, settings: &Settings, from: Option<&[f64]>) -> End {
    search!(block, poses, settings, run(from))
}

/// Takes one undamped step from where a descent ended, without asking what it helped: the reduction of the weighted squares that it
/// promises; `None`, and no step, where the normal equations do not determine it.
pub(super) fn advance(block: &Block, poses: &PoseLanes, settings: &Settings, end: &mut End) -> Option<f64> {
    search!(block, poses, settings, advance(end))
}

/// Weighted squares at a change of the block's start values.
pub(super) fn cost(block: &Block, poses: &PoseLanes, settings: &Settings, change: &[f64]) -> f64 {
    search!(block, poses, settings, cost(change))
}

/// Writes half the weighted squares after a change of the block's start values.
pub(super) fn write(block: &Block, poses: &PoseLanes, settings: &Settings, change: &[f64], to: &mut Quadratic) {
    search!(block, poses, settings, write(change, to))
}

struct Search<'a, const P: usize> {
    /// Number of parameters, P at most.
    count: usize,
    block: &'a Block,
    poses: &'a PoseLanes,
    settings: &'a Settings,
    /// 1/σ² of the priors, 0 without one.
    prior_weights: [f64; P],
    /// Metres that one unit of each parameter is worth.
    scale: [f64; P],
    bounds: [(f64, f64); P],
    start: [f64; P],
}

impl<'a, const P: usize> Search<'a, P> {
    fn new(block: &'a Block, poses: &'a PoseLanes, settings: &'a Settings) -> Self {
        let count = exact::<P>(block.parameters.len());
        let parameter = |k: usize| block.parameters.get(k).copied();
        let mut start = [0.0; P];
        start.iter_mut().zip(block.values(&block.start)).for_each(|(start, value)| *start = value);
        let prior = |parameter: Parameter| prior_sigma(settings, parameter.kind).map_or(0.0, |s| 1.0 / (s * s));
        Self {
            count,
            block,
            poses,
            settings,
            prior_weights: std::array::from_fn(|k| parameter(k).map_or(0.0, prior)),
            scale: std::array::from_fn(|k| parameter(k).map_or(1.0, |parameter| block.scale(parameter.kind))),
            bounds: std::array::from_fn(|k| parameter(k).map_or((0.0, 0.0), |parameter| parameter.bounds())),
            start,
        }
    }

    fn equations(&self, change: &[f64; P]) -> (CableValues, NormalEquations<P>) {
        let values = self.block.moved(&self.block.start, &change[..self.count]);
        let mut equations = self.block.normal::<P>(self.poses, &values);
        for k in 0..self.count {
            equations.cost += self.prior_weights[k] * change[k] * change[k];
            equations.gradient[k] += self.prior_weights[k] * change[k];
            equations.matrix[k][k] += self.prior_weights[k];
        }
        (values, equations)
    }

    fn cost(&self, from: &[f64]) -> f64 {
        let mut change = [0.0; P];
        change[..from.len()].copy_from_slice(from);
        self.equations(&change).1.cost
    }

    fn write(&self, change: &[f64], to: &mut Quadratic) {
        let mut own = [0.0; P];
        own[..change.len()].copy_from_slice(change);
        let (_, equations) = self.equations(&own);
        to.value = 0.5 * equations.cost;
        for i in 0..change.len() {
            to.gradient[i] = equations.gradient[i];
            (0..=i).for_each(|j| {
                (to.hessian[(i, j)], to.hessian[(j, i)]) = (equations.matrix[i][j], equations.matrix[i][j]);
            });
        }
    }

    fn run(&self, from: Option<&[f64]>) -> End {
        let mut change = [0.0; P];
        change.iter_mut().zip(from.into_iter().flatten()).for_each(|(value, &earlier)| *value = earlier);
        let values = self.block.start;
        let none =
            NormalEquations { count: self.count, cost: f64::INFINITY, gradient: [0.0; P], matrix: [[0.0; P]; P] };
        let trail = Trail::new(self.settings.keeps_course, HISTORY_CAPACITY);
        let here = Place { change, values, equations: none };
        let mut descent = Descent { search: self, here, trial: here, trail };
        let rules = Rules {
            tolerance: self.settings.tolerance,
            max_iterations: if self.count == 0 { 0 } else { self.settings.max_iterations },
            least_gain: ROUNDING_GAIN,
            rule: self.settings.minimizer.rule(),
        };
        let end = descend(&mut descent, &rules);
        let mut iterations = end.iterations as u32;
        let stopped = if self.count == 0 { StoppedBy::at_start(rules.tolerance) } else { StoppedBy::of(&end, &rules) };
        if end.stop() == Stop::Stationary && end.damping == 0.0 {
            iterations += 1;
            descent.part();
        }
        if end.stop() == Stop::Degenerate {
            // a start without a cost is told as it is
            descent.here = descent.trial;
            descent.remember();
        }
        let Descent { here: Place { change, values, equations }, trail, .. } = descent;
        End { values, change: change[..self.count].to_vec(), cost: equations.cost, iterations, trail, stopped }
    }

    fn advance(&self, end: &mut End) -> Option<f64> {
        let mut change = [0.0; P];
        change[..self.count].copy_from_slice(&end.change);
        let (_, equations) = self.equations(&change);
        let (step, _) = self.step(&change, &equations, &Control::none())?;
        change = add(&change, &step);
        end.change.copy_from_slice(&change[..self.count]);
        end.values = self.block.moved(&self.block.start, &end.change);
        Some(-(0..self.count).map(|k| step[k] * equations.gradient[k]).sum::<f64>())
    }

    /// A step that respects the bounds, and whether something cut it; `None` if the normal equations do not determine it.
    fn step(
        &self,
        change: &[f64; P],
        equations: &NormalEquations<P>,
        control: &Control<f64>,
    ) -> Option<([f64; P], bool)> {
        let room: [Room; P] = std::array::from_fn(|k| {
            let value = self.start[k] + change[k];
            (self.bounds[k].0 - value, self.bounds[k].1 - value)
        });
        let mut step = [0.0; P];
        let count = self.count;
        let around = Surroundings { room: &room[..count], scale: &self.scale[..count] };
        let (held, taken) = (&mut [false; P][..count], &mut step[..count]);
        let is_cut = self.settings.minimizer.step(equations, around, control, held, taken)?;
        Some((step, is_cut))
    }
}

impl<const P: usize> NormalSystem for NormalEquations<P> {
    fn gradient(&self, k: usize) -> f64 {
        self.gradient[k]
    }

    fn entry(&self, i: usize, j: usize) -> f64 {
        self.matrix[i.max(j)][i.min(j)]
    }

    #[inline]
    fn damped(&self, held: &[bool], damping: f64, step: &mut [f64]) -> Option<()> {
        let mut matrix = self.matrix;
        let mut right = self.gradient.map(|x| -x);
        let count = exact::<P>(self.count);
        for k in 0..count {
            if held[k] {
                right[k] = 0.0;
                (0..count).for_each(|j| (matrix[k][j], matrix[j][k]) = (0.0, 0.0));
                matrix[k][k] = 1.0;
            } else {
                matrix[k][k] *= 1.0 + damping;
            }
        }
        let ratio = ldl::solve_leading(count, &mut matrix, &mut right)?;
        step.copy_from_slice(&right[..count]);
        (ratio >= REGULAR || damping >= OF_SINGULAR).then_some(())
    }
}

/// Parameters of one cable with their normal equations.
#[derive(Clone, Copy)]
struct Place<const P: usize> {
    change: [f64; P],
    values: CableValues,
    equations: NormalEquations<P>,
}

/// Least squares of one cable's lengths, as the loop of all searches sees it.
struct Descent<'a, 'b, const P: usize> {
    search: &'a Search<'b, P>,
    here: Place<P>,
    trial: Place<P>,
    trail: Trail,
}

impl<const P: usize> solve::Problem for Descent<'_, '_, P> {
    type Number = f64;

    fn step(&mut self, control: &Control<f64>) -> Step<f64> {
        let Place { change, equations, .. } = &self.here;
        let found = self.search.step(change, equations, control);
        let (step, is_cut) = found.unwrap_or(([0.0; P], false));
        self.trial.change = add(change, &step);
        let size = minimizer::size(&step[..self.search.count], &self.search.scale[..self.search.count]);
        let gain = self.search.settings.minimizer.gain(equations, &step[..self.search.count], equations.cost);
        Step { size, gain, is_cut, is_regular: found.is_some() }
    }

    fn evaluate(&mut self, _: f64, _: bool) -> Trial<f64> {
        (self.trial.values, self.trial.equations) = self.search.equations(&self.trial.change);
        let (cost, here) = (self.trial.equations.cost, self.here.equations.cost);
        Trial { helps: cost.is_finite() && cost <= here * (1.0 + 1e-12), gain: 1.0 - cost / here }
    }

    /// Steps along a descent that do not help however short leave rounding, as damped steps do once they are within the tolerance.
    fn rests(&mut self, size: f64, tolerance: f64) -> bool {
        size <= tolerance || self.search.settings.minimizer.rule() == StepRule::Shortening
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            self.here = self.trial;
            self.remember();
        }
    }
}

impl<const P: usize> Descent<'_, '_, P> {
    fn remember(&mut self) {
        let Place { values, equations, .. } = &self.here;
        self.trail.push(equations.cost, || self.search.block.values(values).collect());
    }

    /// Takes a last step that costs no evaluation: the gradient still knows the way to more digits.
    fn part(&mut self) {
        let Place { change, values, equations } = &mut self.here;
        if let Some((step, _)) = self.search.step(change, equations, &Control::none()) {
            *change = add(change, &step);
            *values = self.search.block.moved(&self.search.block.start, &change[..self.search.count]);
        }
    }
}

fn add<const P: usize>(a: &[f64; P], b: &[f64; P]) -> [f64; P] {
    std::array::from_fn(|k| a[k] + b[k])
}
