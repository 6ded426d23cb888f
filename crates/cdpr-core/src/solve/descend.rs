//! The loop shared by all searches.

use super::convergence::{left, settles};
use super::damping::{is_exhausted, is_felt, lowered, raised, regularised};
use super::{Control, DescentEnd, HIDDEN_GAIN, Mask, Problem, Rules, Step, StepRule, Stop, Trial};
use crate::scalar::{Real, Select};

/// Fraction of a step below which its direction is given up.
const LEAST_FRACTION: f64 = 1e-8;

/// Factor by which the gain of an untried step may exceed the gain that the rate of earlier steps predicts.
const UNSURE: f64 = 100.0;

/// Takes steps from the start, which is the problem's first trial, until they are small or no longer help.
///
/// The start is a trial like all others, so that an evaluation is compiled once; everything here is inlined into its
/// caller, where the rule is a constant.
#[inline(always)]
pub fn descend<P: Problem>(problem: &mut P, rules: &Rules<P::Number>) -> DescentEnd<P::Number> {
    let n = rules.tolerance;
    let mut search = Search::<P>::new(rules);
    let mut steps = 0;
    #[cfg(all(feature = "std", debug_assertions))]
    let mut trace = super::trace::Trace::begin::<P>();
    loop {
        let goes_on = n.any(n.without(search.running, search.is_last));
        let outcome = problem.evaluate(search.fraction, !goes_on);
        let helps = n.both(search.running, outcome.helps);
        problem.accept(helps, search.contraction);
        #[cfg(all(feature = "std", debug_assertions))]
        let (step, fraction) = (search.step, search.fraction);
        search.judge(problem, &outcome, helps, steps == 0);
        #[cfg(all(feature = "std", debug_assertions))]
        if let Some(trace) = &mut trace {
            trace.add(&step, fraction, &search.control, n.any(helps), search.stop);
        }
        if !n.any(search.running) {
            break;
        }
        if rules.rule == StepRule::Shortening && steps > 0 && !n.any(helps) {
            // the same step, but shorter
            continue;
        }
        if steps >= rules.max_iterations {
            break;
        }
        search.take_step(problem);
        if !n.any(search.running) {
            break;
        }
        steps += 1;
        search.iterations = search.iterations + n.constant(1.0).select(search.running, n.constant(0.0));
    }
    let (left, gain) = (search.left(), search.step.gain);
    DescentEnd { stop: search.stop, iterations: search.iterations, damping: search.control.damping, left, gain }
}

/// State of the loop, lane by lane.
struct Search<'a, P: Problem> {
    rules: &'a Rules<P::Number>,
    control: Control<P::Number>,
    step: Step<P::Number>,
    /// Fraction of the step that is tried.
    fraction: P::Number,
    /// Length of the step as it would be without damping; `last_reach` is that of the step before.
    reach: P::Number,
    last_reach: P::Number,
    contraction: P::Number,
    /// Lanes in which the search ends if the trial helps.
    is_last: Mask<P>,
    running: Mask<P>,
    stop: P::Number,
    iterations: P::Number,
}

impl<'a, P: Problem> Search<'a, P> {
    #[inline(always)]
    fn new(rules: &'a Rules<P::Number>) -> Self {
        let n = rules.tolerance;
        let (zero, infinite) = (n.constant(0.0), n.constant(f64::INFINITY));
        Self {
            rules,
            control: Control { damping: zero, radius: infinite },
            step: Step::whole(zero, n.everywhere(true)),
            fraction: n.constant(1.0),
            reach: zero,
            last_reach: zero,
            // no step yet: no rate of contraction to judge by
            contraction: infinite,
            is_last: n.everywhere(false),
            running: n.everywhere(true),
            stop: n.constant(Stop::IterationLimit as u8 as f64),
            iterations: zero,
        }
    }

    /// Total length of the steps that remain: the last one, or those that follow it if they shrink.
    #[inline(always)]
    fn left(&self) -> P::Number {
        let (size, rate) = (self.step.size, self.contraction);
        let behind = left(self.reach, rate);
        let is_shorter = behind.is_less(size);
        behind.select(size.both(is_shorter, rate.is_less(size.constant(0.5))), size)
    }

    /// Ends the search in these lanes for the reason `stop`.
    #[inline(always)]
    fn end(&mut self, lanes: Mask<P>, stop: Stop) {
        let n = self.stop;
        self.stop = n.constant(stop as u8 as f64).select(lanes, n);
        self.running = n.without(self.running, lanes);
    }

    /// Decides how the search goes on after a trial.
    #[inline(always)]
    fn judge(&mut self, problem: &mut P, outcome: &Trial<P::Number>, helps: Mask<P>, is_start: bool) {
        let n = self.stop;
        let fails = n.without(self.running, helps);
        if is_start {
            return self.end(fails, Stop::Degenerate);
        }
        self.last_reach = self.reach.select(helps, self.last_reach);
        self.end(n.both(helps, self.is_last), Stop::Stationary);
        match self.rules.rule {
            StepRule::Plain { slowest } => {
                let is_slow = n.constant(slowest).is_less(self.contraction);
                let is_slow = n.both(is_slow, self.contraction.is_less(n.constant(f64::INFINITY)));
                if n.any(fails) {
                    self.end_at_rest(problem, fails);
                }
                self.end(n.both(self.running, n.either(fails, is_slow)), Stop::Stalled);
            }
            StepRule::Damping => {
                if n.any(fails) {
                    self.end_at_rest(problem, fails);
                    self.end(n.both(n.both(self.running, fails), is_exhausted(self.control.damping)), Stop::Stalled);
                }
                let damping = self.control.damping;
                self.control.damping = lowered(damping).select(helps, raised(damping));
            }
            StepRule::Shortening => {
                self.fraction = n.constant(1.0).select(helps, n.constant(0.5) * self.fraction);
                let is_small = (self.fraction * self.step.size).is_less(self.rules.tolerance);
                let is_least = self.fraction.is_less(n.constant(LEAST_FRACTION));
                let is_short = n.both(fails, n.either(is_small, is_least));
                self.is_last = n.without(self.is_last, fails);
                if n.any(is_short) {
                    self.end_at_rest(problem, is_short);
                    self.end(n.both(self.running, is_short), Stop::Stalled);
                }
            }
            StepRule::TrustRegion => self.resize_region(problem, outcome, helps, fails),
        }
    }

    /// Ends the lanes in which only rounding errors remain.
    #[inline(always)]
    fn end_at_rest(&mut self, problem: &mut P, fails: Mask<P>) {
        let rests = problem.rests(self.step.size, self.rules.tolerance);
        self.end(self.stop.both(fails, rests), Stop::Stationary);
    }

    /// Sets the radius to twice the step if the equations predicted it well, to half or a quarter of it if they did not
    /// (Nocedal and Wright 2006, algorithm 4.1).
    #[inline(always)]
    fn resize_region(&mut self, problem: &mut P, outcome: &Trial<P::Number>, helps: Mask<P>, fails: Mask<P>) {
        let n = self.stop;
        let (size, radius) = (self.step.size, self.control.radius);
        // a gain hidden by rounding is no measure of the prediction
        let is_hidden = self.step.gain.is_less(n.constant(HIDDEN_GAIN));
        let ratio = n.constant(1.0).select(is_hidden, outcome.gain / self.step.gain);
        let wider = (n.constant(2.0) * size).max(radius).select(n.constant(0.75).is_less(ratio), radius);
        let accepted = (n.constant(0.5) * size).select(ratio.is_less(n.constant(0.25)), wider);
        self.control.radius = accepted.select(helps, n.constant(0.25) * size);
        if n.any(fails) {
            let whole = n.without(fails, self.step.is_cut);
            self.end(n.both(whole, is_hidden), Stop::Stationary);
            self.end_at_rest(problem, n.both(whole, self.running));
            let is_tiny = self.control.radius.is_less(n.constant(1e-3) * self.rules.tolerance);
            self.end(n.both(n.both(self.running, fails), is_tiny), Stop::Stalled);
        }
    }

    /// Ends the lanes whose step is taken untried: the next step, shorter at this rate, has a predicted gain a hundred
    /// times below the gain that rounding hides.
    #[inline(always)]
    fn end_ahead(&mut self, rate: P::Number) {
        let n = self.stop;
        let next = self.step.gain * rate * rate;
        let is_hidden = (n.constant(UNSURE) * next).is_less(n.constant(self.rules.least_gain));
        let is_damped = n.constant(0.0).is_less(self.control.damping);
        let lanes = n.both(self.running, n.without(n.without(is_hidden, is_damped), self.step.is_cut));
        self.step.gain = next.select(lanes, self.step.gain);
        self.end(lanes, Stop::Stationary);
    }

    /// Computes the next step from the current iterate, with as much damping as its equations need for a solution.
    #[inline(always)]
    fn take_step(&mut self, problem: &mut P) {
        let n = self.stop;
        loop {
            self.step = problem.step(&self.control);
            let singular = n.without(self.running, self.step.is_regular);
            if self.rules.rule != StepRule::Damping {
                self.end(singular, Stop::Singular);
                break;
            }
            self.end(n.both(singular, is_exhausted(self.control.damping)), Stop::Singular);
            let singular = n.both(singular, self.running);
            if !n.any(singular) {
                break;
            }
            self.control.damping = regularised(self.control.damping).select(singular, self.control.damping);
        }
        let is_cut = self.step.is_cut;
        let gains_nothing = n.without(self.step.gain.is_less(n.constant(self.rules.least_gain)), is_cut);
        self.end(n.both(self.running, gains_nothing), Stop::Stationary);
        // a step shortened by damping is no sign that the solution is near, nor is the rate of damped steps
        self.reach = self.step.size * (n.constant(1.0) + self.control.damping);
        self.contraction = self.reach / self.last_reach;
        let rate = n.constant(f64::INFINITY).select(is_felt(self.control.damping), self.contraction);
        if problem.takes_last_step() {
            self.end_ahead(rate);
        }
        self.is_last = n.without(settles(self.reach, rate, self.rules.tolerance), is_cut);
        self.fraction = n.constant(1.0);
    }
}
