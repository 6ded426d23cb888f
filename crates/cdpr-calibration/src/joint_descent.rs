//! Damped Gauss–Newton descent of all parameters together, within bounds.

use super::starts::Ending;
use super::stopping::StoppedBy;
use super::trail::Trail;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::cholesky::LowerTriangle;
use cdpr_model::solve::{
    self, Control, Minimizer, NormalSystem, OF_SINGULAR, REGULAR, Room, Rules, Step, StepRule, Stop, Surroundings,
    Trial, minimizer,
};

/// Cost of parameters that tie all cables together, with its normal equations.
pub(super) trait System {
    /// Normal equations with their cost.
    type Equations: Equations;

    /// Writes the equations at parameter values; false where a row is not finite.
    fn write(&mut self, values: &[f64], equations: &mut Self::Equations) -> bool;
}

/// Normal equations that know the cost they belong to.
pub(super) trait Equations: NormalSystem + Clone {
    /// The cost; twice that of the quadratic model.
    fn cost(&self) -> f64;
}

/// Unknowns of a descent.
pub(super) struct Around<'a> {
    pub(super) parameters: &'a [Parameter],
    /// Metres that one unit of each parameter is worth.
    pub(super) scale: &'a [f64],
    pub(super) minimizer: Minimizer,
    /// Whether the places on the way are kept.
    pub(super) keeps_course: bool,
    /// Whether the search ends before a step behind which only rounding is left: it is taken untried.
    pub(super) ends_ahead: bool,
}

/// End of a descent.
#[derive(Clone, Debug)]
pub(super) struct End {
    pub(super) values: Vec<f64>,
    pub(super) cost: f64,
    pub(super) iterations: u32,
    pub(super) trail: Trail,
    pub(super) stopped: StoppedBy,
}

impl End {
    pub(super) fn converged(&self) -> bool {
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
pub(super) fn descend<S: System>(
    system: &mut S,
    around: &Around<'_>,
    from: &[f64],
    equations: S::Equations,
    rules: &Rules<f64>,
) -> End {
    let trial = Place { values: from.to_vec(), equations };
    let trail = Trail::new(around.keeps_course, 0);
    let here = trial.clone();
    let mut descent = Descent { system, around, here, here_cost: f64::INFINITY, trial, untried: None, trail };
    let rules = Rules { max_iterations: if from.is_empty() { 0 } else { rules.max_iterations }, ..*rules };
    let end = solve::descend(&mut descent, &rules);
    let mut iterations = end.iterations as u32;
    let is_fixed = from.is_empty() && end.stop() != Stop::Degenerate;
    let stopped = if is_fixed { StoppedBy::at_start(rules.tolerance) } else { StoppedBy::of(&end, &rules) };
    let Descent { here: Place { mut values, equations }, trial, untried, mut trail, .. } = descent;
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
        } else if let Some((step, _)) = around.step(&values, &equations, &Control::none()) {
            values.iter_mut().zip(step).for_each(|(value, step)| *value += step);
        }
    }
    End { values, cost, iterations, trail, stopped }
}

impl Around<'_> {
    /// A step that respects the bounds, and whether something cut it.
    fn step(&self, values: &[f64], equations: &impl NormalSystem, control: &Control<f64>) -> Option<(Vec<f64>, bool)> {
        let room = |(parameter, value): (&Parameter, &f64)| -> Room {
            let (low, high) = parameter.bounds();
            (low - value, high - value)
        };
        let room: Vec<Room> = self.parameters.iter().zip(values).map(room).collect();
        let around = Surroundings { room: &room, scale: self.scale };
        let (mut held, mut step) = (vec![false; values.len()], vec![0.0; values.len()]);
        let is_cut = self.minimizer.step(equations, around, control, &mut held, &mut step)?;
        Some((step, is_cut))
    }
}

/// Parameter values with their normal equations.
#[derive(Clone)]
struct Place<E> {
    values: Vec<f64>,
    equations: E,
}

/// Parameters that tie all cables together, as the loop of all searches sees them.
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
}

impl<S: System> solve::Problem for Descent<'_, '_, S> {
    type Number = f64;

    fn step(&mut self, control: &Control<f64>) -> Step<f64> {
        self.untried = None;
        let Place { values, equations } = &self.here;
        let Some((step, is_cut)) = self.around.step(values, equations, control) else {
            return Step::whole(0.0, false);
        };
        for (trial, (value, step)) in self.trial.values.iter_mut().zip(values.iter().zip(&step)) {
            *trial = value + step;
        }
        let size = minimizer::size(&step, self.around.scale);
        let gain = self.around.minimizer.gain(equations, &step, equations.cost());
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
pub(super) fn damped_step(system: &impl NormalSystem, held: &[bool], damping: f64, step: &mut [f64]) -> Option<()> {
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
