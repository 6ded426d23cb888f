//! Searches for known optima, one and eight at a time.

use super::convergence::settles;
use super::*;
use crate::scalar::{Kernel, LANES, Lanes, Unit, dispatch_on};

/// Rosenbrock's valley 10 (y − x²), 1 − x: the sum of squares is 0 at (1, 1).
struct Valley<N> {
    here: Place<N>,
    trial: Place<N>,
    step: [N; 2],
    /// Weight of the second residual: at 0 the optima are a curve.
    weight: N,
}

#[derive(Clone, Copy)]
struct Place<N> {
    x: [N; 2],
    cost: N,
}

impl<N: Select> Valley<N> {
    fn new(x: [N; 2], weight: f64) -> Self {
        let [zero, infinite, weight] = [0.0, f64::INFINITY, weight].map(|number| x[0].constant(number));
        let place = Place { x, cost: infinite };
        Self { here: place, trial: place, step: [zero; 2], weight }
    }

    #[inline(always)]
    fn residual(&self, [x, y]: [N; 2]) -> [N; 2] {
        [x.constant(10.0) * (y - x * x), self.weight * (x.constant(1.0) - x)]
    }
}

impl<N: Select> Problem for Valley<N> {
    type Number = N;

    #[inline(always)]
    fn step(&mut self, control: &Control<N>) -> Step<N> {
        let [x, y] = self.here.x;
        let [p, q] = self.residual([x, y]);
        let (ten, one) = (x.constant(10.0), x.constant(1.0));
        // rows of J: (−20 x, 10), (−weight, 0)
        let (a, b, c) = (x.constant(-20.0) * x, ten, -self.weight);
        let diagonal = one + control.damping;
        let (h, k, l) = ((a * a + c * c) * diagonal, a * b, b * b * diagonal);
        let (g, f) = (a * p + c * q, b * p);
        let determinant = h * l - k * k;
        let mut step = [-(l * g - k * f) / determinant, -(h * f - k * g) / determinant];
        let length = |step: &[N; 2]| (step[0] * step[0] + step[1] * step[1]).sqrt();
        let fraction = (control.radius / length(&step)).min(one);
        step = [fraction * step[0], fraction * step[1]];
        self.step = step;
        let predicted_reduction = -(step[0] * g + step[1] * f);
        let is_regular = (x.constant(1e-11) * h * l).is_less(determinant);
        let bend = step[0] * step[0] * h + x.constant(2.0) * step[0] * step[1] * k + step[1] * step[1] * l;
        let gain = (x.constant(2.0) * predicted_reduction - bend) / self.here.cost;
        Step { size: length(&step), gain, is_cut: fraction.is_less(one), is_regular }
    }

    #[inline(always)]
    fn evaluate(&mut self, fraction: N, _: bool) -> Trial<N> {
        let [x, y] = self.here.x;
        self.trial.x = [x + fraction * self.step[0], y + fraction * self.step[1]];
        let [p, q] = self.residual(self.trial.x);
        self.trial.cost = p * p + q * q;
        let gain = x.constant(1.0) - self.trial.cost / self.here.cost;
        Trial { helps: self.trial.cost.is_less(self.here.cost), gain }
    }

    #[inline(always)]
    fn accept(&mut self, helps: N::Mask, _: N) {
        for k in 0..2 {
            self.here.x[k] = self.trial.x[k].select(helps, self.here.x[k]);
        }
        self.here.cost = self.trial.cost.select(helps, self.here.cost);
    }
}

const RULES: [StepRule; 4] =
    [StepRule::Plain { slowest: f64::INFINITY }, StepRule::Damping, StepRule::Shortening, StepRule::TrustRegion];

fn rules(rule: StepRule) -> Rules<f64> {
    Rules { tolerance: 1e-10, max_iterations: 200, least_gain: 0.0, rule }
}

/// Starts in and beside the valley, eight of them.
fn starts() -> [[f64; 2]; LANES] {
    [[-1.2, 1.0], [0.0, 0.0], [2.0, 2.0], [1.0, 1.0], [-0.5, 3.0], [0.9, 0.5], [3.0, -1.0], [1.5, 2.2]]
}

/// The optimum is known; the cost after the last step is rounding.
#[test]
fn every_rule_that_can_shorten_steps_finds_the_optimum_from_every_start() {
    for rule in &RULES[1..] {
        for start in starts() {
            let mut valley = Valley::new(start, 1.0);
            let end = descend(&mut valley, &rules(*rule));
            assert_eq!(end.stop(), Stop::Stationary, "{rule:?} from {start:?}");
            let [x, y] = valley.here.x;
            assert!((x - 1.0).abs() < 1e-9 && (y - 1.0).abs() < 1e-9, "{rule:?} from {start:?}: {x} {y}");
        }
    }
}

/// Full steps leave the valley from (−1.2, 1): the second is worse than the start.
#[test]
fn plain_steps_end_where_one_does_not_help() {
    let mut valley = Valley::new([-1.2, 1.0], 1.0);
    let end = descend(&mut valley, &rules(RULES[0]));
    assert_eq!(end.stop(), Stop::Stalled);
    let mut near = Valley::new([0.99, 0.98], 1.0);
    assert_eq!(descend(&mut near, &rules(RULES[0])).stop(), Stop::Stationary);
}

/// Eight searches in lanes.
struct Eight(StepRule, f64);

impl Kernel for Eight {
    type Output = [[f64; 4]; LANES];

    #[inline(always)]
    fn run<L: Lanes>(self, lanes: L) -> Self::Output {
        let Rules { tolerance, max_iterations, least_gain, rule } = rules(self.0);
        let start = [0, 1].map(|k| lanes.load(&starts().map(|start| start[k])));
        let mut valley = Valley::new(start, self.1);
        let rules = Rules { tolerance: lanes.constant(tolerance), max_iterations, least_gain, rule };
        let end = descend(&mut valley, &rules);
        let [x, y] = valley.here.x.map(L::to_array);
        let (stops, iterations) = (end.stop.to_array(), end.iterations.to_array());
        core::array::from_fn(|lane| [x[lane], y[lane], stops[lane], iterations[lane]])
    }
}

/// Each of the eight is independent of the others, by construction of the loop; this test shows it.
#[test]
fn eight_searches_side_by_side_have_the_bits_of_single_ones_on_every_unit() {
    for (rule, weight) in [0, 1, 3].into_iter().flat_map(|rule| [(RULES[rule], 1.0), (RULES[rule], 0.0)]) {
        let singles = starts().map(|start| {
            let mut valley = Valley::new(start, weight);
            let end = descend(&mut valley, &rules(rule));
            [valley.here.x[0], valley.here.x[1], end.stop, end.iterations].map(f64::to_bits)
        });
        for unit in Unit::available() {
            let eight = dispatch_on(unit, Eight(rule, weight)).unwrap();
            assert_eq!(eight.map(|lane| lane.map(f64::to_bits)), singles, "{unit:?} {rule:?} {weight}");
        }
    }
}

#[test]
fn damping_finds_a_point_of_a_curve_of_optima_which_plain_steps_call_singular() {
    let mut valley = Valley::new([2.0, 1.0], 0.0);
    assert_eq!(descend(&mut valley, &rules(StepRule::Damping)).stop(), Stop::Stationary);
    let [x, y] = valley.here.x;
    assert!((y - x * x).abs() < 1e-9, "{x} {y}");
    let mut valley = Valley::new([2.0, 1.0], 0.0);
    assert_eq!(descend(&mut valley, &rules(RULES[0])).stop(), Stop::Singular);
}

#[test]
fn a_start_without_a_residual_and_too_few_steps_are_named() {
    let mut valley = Valley::new([f64::NAN, 1.0], 1.0);
    assert_eq!(descend(&mut valley, &rules(StepRule::Damping)).stop(), Stop::Degenerate);
    let mut valley = Valley::new([-1.2, 1.0], 1.0);
    let few = Rules { max_iterations: 3, ..rules(StepRule::Damping) };
    let end = descend(&mut valley, &few);
    assert_eq!((end.stop(), end.iterations), (Stop::IterationLimit, 3.0));
}

/// The remaining length of a geometric series of steps is within the tolerance when the test ends, and no step sooner.
#[test]
fn the_convergence_test_sums_the_steps_that_remain() {
    for rate in [0.01, 0.1, 0.4, 0.49] {
        let mut size = 1.0;
        while !settles(size, rate, 1e-6) {
            size *= rate;
        }
        let remaining = size * rate / (1.0 - rate);
        assert!(remaining <= 1e-6 && remaining > 1e-6 * rate, "{rate}: {remaining:e}");
    }
    // slow steps are no sign of convergence at any length; negligible ones are the end
    assert!(!settles(1e-7, 0.9, 1e-6) && settles(1e-10, 0.9, 1e-6) && !settles(f64::NAN, f64::NAN, 1e-6));
}
