//! Damped Gauss–Newton descent of parameters that rows tie together, within bounds.

use super::starts::Ending;
use super::trail::{Trail, side_by_side};
use crate::stopping::StoppedBy;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::cholesky::LowerTriangle;
use cdpr_model::solve::{
    self, Control, Minimizer, NormalSystem, OF_SINGULAR, REGULAR, Room, Rules, Step, StepRule, Stop, Surroundings,
    Trial, minimizer,
};

/// Steps that are recorded without allocating again; few descents take more.
const HISTORY_CAPACITY: usize = 16;

/// Cost of parameters with its normal equations.
pub(crate) trait System {
    /// Normal equations with their cost.
    type Equations: Equations;

    /// Writes the equations at parameter values; false where a row is not finite.
    fn write(&mut self, values: &[f64], equations: &mut Self::Equations) -> bool;
}

/// Normal equations that know the cost they belong to.
pub(crate) trait Equations: NormalSystem + Clone {
    /// The cost; twice that of the quadratic model.
    fn cost(&self) -> f64;
}

/// Unknowns of a descent.
pub(crate) struct Around<'a> {
    pub(crate) parameters: &'a [Parameter],
    /// Metres that one unit of each parameter is worth.
    pub(crate) scale: &'a [f64],
    pub(crate) minimizer: Minimizer,
    /// Whether the places on the way are kept.
    pub(crate) keeps_course: bool,
    /// Whether the search ends before a step behind which only rounding is left: it is taken untried.
    pub(crate) ends_ahead: bool,
}

/// End of a descent.
#[derive(Clone, Debug)]
pub(crate) struct End {
    pub(crate) values: Vec<f64>,
    pub(crate) cost: f64,
    pub(crate) iterations: u32,
    pub(crate) trail: Trail,
    pub(crate) stopped: StoppedBy,
}

impl End {
    /// Ends of searches side by side, as one end of all their parameters in succession.
    pub(crate) fn joined(mut ends: Vec<Self>) -> Self {
        if ends.len() == 1 {
            return ends.swap_remove(0);
        }
        Self {
            cost: ends.iter().map(|end| end.cost).sum(),
            iterations: ends.iter().map(|end| end.iterations).max().unwrap_or(0),
            trail: side_by_side(&ends.iter().map(|end| &end.trail).collect::<Vec<_>>()),
            stopped: StoppedBy::worst(ends.iter().map(|end| end.stopped)).unwrap_or(StoppedBy::at_start(0.0)),
            values: ends.into_iter().flat_map(|end| end.values).collect(),
        }
    }

    pub(crate) fn converged(&self) -> bool {
        self.stopped.converged()
    }
}

impl Ending for End {
    fn cost(&self) -> f64 {
        self.cost
    }

    fn converged(&self) -> bool {
        self.converged()
    }

    fn place(&self) -> &[f64] {
        &self.values
    }
}

/// Descends from these values; `equations` is memory for them.
pub(crate) fn descend<S: System>(
    system: &mut S,
    around: &Around<'_>,
    from: &[f64],
    equations: S::Equations,
    rules: &Rules<f64>,
) -> End {
    let trial = Place { values: from.to_vec(), equations };
    let trail = Trail::new(around.keeps_course, HISTORY_CAPACITY);
    let (here, memory) = (trial.clone(), Memory::new(from.len()));
    let mut descent = Descent { system, around, here, here_cost: f64::INFINITY, trial, untried: None, trail, memory };
    let rules = Rules { max_iterations: if from.is_empty() { 0 } else { rules.max_iterations }, ..*rules };
    let end = solve::descend(&mut descent, &rules);
    let mut iterations = end.iterations as u32;
    let is_fixed = from.is_empty() && end.stop() != Stop::Degenerate;
    let stopped = if is_fixed { StoppedBy::at_start(rules.tolerance) } else { StoppedBy::of(&end, &rules) };
    let Descent { here: Place { mut values, equations }, trial, untried, mut trail, mut memory, .. } = descent;
    let mut cost = equations.cost();
    if end.stop() == Stop::Degenerate {
        return End { values, cost: f64::NAN, iterations, trail: Trail::default(), stopped };
    }
    if end.stop() == Stop::Stationary && end.damping == 0.0 {
        iterations += 1;
        // the gradient still knows the way to more digits, and the step costs no evaluation
        if let Some(gain) = untried.filter(|_| rules.rule == StepRule::Damping) {
            values = trial.values;
            if around.ends_ahead {
                cost *= 1.0 - gain;
                trail.push(cost, || values.clone());
            }
        } else if around.step(&values, &equations, &Control::none(), &mut memory).is_some() {
            values.iter_mut().zip(&memory.step).for_each(|(value, step)| *value += step);
        }
    }
    End { values, cost, iterations, trail, stopped }
}

/// Memory of a step.
struct Memory {
    room: Vec<Room>,
    held: Vec<bool>,
    step: Vec<f64>,
}

impl Memory {
    fn new(count: usize) -> Self {
        Self { room: vec![(0.0, 0.0); count], held: vec![false; count], step: vec![0.0; count] }
    }
}

impl Around<'_> {
    /// An undamped step that respects the bounds; `None` if the equations do not determine it.
    pub(crate) fn plain_step(&self, values: &[f64], equations: &impl NormalSystem) -> Option<Vec<f64>> {
        let mut memory = Memory::new(values.len());
        self.step(values, equations, &Control::none(), &mut memory)?;
        Some(memory.step)
    }

    /// Writes a step that respects the bounds, and tells whether something cut it; `None` if the equations do not determine it.
    fn step(
        &self,
        values: &[f64],
        equations: &impl NormalSystem,
        control: &Control<f64>,
        memory: &mut Memory,
    ) -> Option<bool> {
        let Memory { room, held, step } = memory;
        for (room, (parameter, value)) in room.iter_mut().zip(self.parameters.iter().zip(values)) {
            let (low, high) = parameter.bounds();
            *room = (low - value, high - value);
        }
        held.fill(false);
        let around = Surroundings { room, scale: self.scale };
        self.minimizer.step(equations, around, control, held, step)
    }
}

/// Parameter values with their normal equations.
#[derive(Clone)]
struct Place<E> {
    values: Vec<f64>,
    equations: E,
}

/// Parameters as the loop of all searches sees them.
struct Descent<'a, 'p, S: System> {
    system: &'a mut S,
    around: &'a Around<'p>,
    here: Place<S::Equations>,
    /// Infinite before the start.
    here_cost: f64,
    trial: Place<S::Equations>,
    /// Share of the cost that the last step promises, where nobody has evaluated its end, the trial.
    untried: Option<f64>,
    trail: Trail,
    memory: Memory,
}

impl<S: System> solve::Problem for Descent<'_, '_, S> {
    type Number = f64;

    fn step(&mut self, control: &Control<f64>) -> Step<f64> {
        self.untried = None;
        let Place { values, equations } = &self.here;
        let Some(is_cut) = self.around.step(values, equations, control, &mut self.memory) else {
            return Step::whole(0.0, false);
        };
        let step = &self.memory.step;
        for (trial, (value, step)) in self.trial.values.iter_mut().zip(values.iter().zip(step)) {
            *trial = value + step;
        }
        let size = minimizer::size(step, self.around.scale);
        let gain = self.around.minimizer.gain(equations, step, equations.cost());
        self.untried = Some(gain);
        Step { size, gain, is_cut, is_regular: true }
    }

    fn evaluate(&mut self, _: f64, _: bool) -> Trial<f64> {
        self.untried = None;
        let is_finite = self.system.write(&self.trial.values, &mut self.trial.equations);
        let cost = self.trial.equations.cost();
        Trial { helps: is_finite && cost <= self.here_cost * (1.0 + 1e-12), gain: 1.0 - cost / self.here_cost }
    }

    fn takes_last_step(&self) -> bool {
        self.around.ends_ahead && self.around.minimizer.rule() == StepRule::Damping
    }

    /// Steps along a descent that do not help however short leave rounding, as damped steps do once they are within the tolerance.
    fn rests(&mut self, size: f64, tolerance: f64) -> bool {
        size <= tolerance || self.around.minimizer.rule() == StepRule::Shortening
    }

    fn accept(&mut self, helps: bool, _: f64) {
        if helps {
            std::mem::swap(&mut self.here, &mut self.trial);
            self.here_cost = self.here.equations.cost();
            self.trail.push(self.here_cost, || self.here.values.clone());
        }
    }
}

/// Solves (H + damping · diag H) step = −gradient for the parameters that are not held, columns scaled to unit diagonal;
/// `None` when that matrix is not positive definite to rounding.
pub(crate) fn damped_step(system: &impl NormalSystem, held: &[bool], damping: f64, step: &mut [f64]) -> Option<()> {
    let count = held.len();
    let scale: Vec<f64> = (0..count)
        .map(|k| match held[k] || !(system.entry(k, k) > 0.0) {
            true => 0.0,
            false => 1.0 / system.entry(k, k).sqrt(),
        })
        .collect();
    let mut factor = LowerTriangle::new(count);
    let scale = &scale;
    factor.fill(|column| {
        let (entry, own) = (system.column(column), scale[column]);
        move |row| if row == column { 1.0 + damping } else { entry(row) * scale[row] * own }
    });
    factor.factorize()?;
    let smallest = factor.smallest();
    // undamped, directions that nothing determines would wander on rounding errors
    if smallest * smallest < REGULAR && damping < OF_SINGULAR {
        return None;
    }
    (0..count).for_each(|k| step[k] = -system.gradient(k) * scale[k]);
    factor.solve(step);
    (0..count).for_each(|k| step[k] *= scale[k]);
    Some(())
}
