//! Rules that end a search for parameters.

use std::fmt;

use cdpr_model::reading::keywords;
use cdpr_model::solve::{DescentEnd, HIDDEN_GAIN, Rules, Stop};

/// Rule that ended a search for parameters; from [`StoppingRule::IterationLimit`] on, no optimum was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[non_exhaustive]
pub enum StoppingRule {
    /// The steps left, if they go on shrinking as the last ones did, are within the tolerance (m).
    Step,
    /// The next step promises to remove less than this share of the cost.
    Cost,
    /// The cost is within this share of a bound of the least one.
    Gap,
    /// No step lowers the cost, however short; the last promised to remove this share.
    Rounding,
    /// No free parameter changes a residual.
    Undetermined,
    /// As many steps as allowed.
    IterationLimit,
    /// No shorter step helped, though steps (m) had not become small.
    Stalled,
    /// The start has no residuals.
    NoResiduals,
}

keywords!(
    StoppingRule: Step = "step",
    Cost = "cost",
    Gap = "gap",
    Rounding = "rounding",
    Undetermined = "undetermined",
    IterationLimit = "iteration-limit",
    Stalled = "stalled",
    NoResiduals = "no-residuals",
);

/// End of a search by a rule with its number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StoppedBy {
    /// The rule.
    pub rule: StoppingRule,
    /// Its number: metres, a share of the cost, or steps.
    pub value: f64,
    /// Limit of this number.
    pub limit: f64,
}

impl StoppedBy {
    /// The end of a search of the one loop.
    pub(super) fn of(end: &DescentEnd<f64>, rules: &Rules<f64>) -> Self {
        let (rule, value, limit) = match end.stop() {
            Stop::IterationLimit => (StoppingRule::IterationLimit, end.iterations, f64::from(rules.max_iterations)),
            Stop::Stationary if end.left <= rules.tolerance => (StoppingRule::Step, end.left, rules.tolerance),
            Stop::Stationary if end.gain < rules.least_gain => (StoppingRule::Cost, end.gain, rules.least_gain),
            Stop::Stationary => (StoppingRule::Rounding, end.gain, HIDDEN_GAIN),
            Stop::Stalled => (StoppingRule::Stalled, end.left, rules.tolerance),
            Stop::Singular => (StoppingRule::Undetermined, 0.0, 0.0),
            Stop::Degenerate => (StoppingRule::NoResiduals, 0.0, 0.0),
        };
        Self { rule, value, limit }
    }

    /// The end of a search without free parameters.
    pub(super) fn at_start(tolerance: f64) -> Self {
        Self { rule: StoppingRule::Step, value: 0.0, limit: tolerance }
    }

    /// True at an optimum.
    pub(super) fn converged(&self) -> bool {
        self.rule < StoppingRule::IterationLimit
    }

    /// The end that says least of an optimum, of searches that were apart.
    pub(super) fn worst(all: impl IntoIterator<Item = Self>) -> Option<Self> {
        let fraction = |stopped: &Self| stopped.value / stopped.limit;
        all.into_iter().max_by(|a, b| a.rule.cmp(&b.rule).then(fraction(a).total_cmp(&fraction(b))))
    }
}

impl fmt::Display for StoppedBy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rule, value, limit } = self;
        match rule {
            StoppingRule::Step => write!(f, "the step rule: {value:.1e} m or less are left, {limit:.0e} m are allowed"),
            StoppingRule::Cost => {
                write!(f, "the cost rule: the next step promises {value:.1e} of the cost, {limit:.0e} is the limit")
            }
            StoppingRule::Gap => {
                write!(f, "the gap rule: within {value:.1e} of the least cost, {limit:.0e} is allowed")
            }
            StoppingRule::Rounding => {
                write!(f, "the rounding rule: no step lowers the cost, and the last one promised {value:.1e} of it")
            }
            StoppingRule::Undetermined => f.write_str("singular equations: no free parameter changes a residual"),
            StoppingRule::IterationLimit => write!(f, "the limit of {limit} iterations"),
            StoppingRule::Stalled => write!(f, "no shorter step helped, with {value:.1e} m still to go"),
            StoppingRule::NoResiduals => f.write_str("the start has no residuals"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_searches_apart_the_one_that_says_least_of_an_optimum_is_told() {
        let of = |rule, value| StoppedBy { rule, value, limit: 1e-10 };
        let (near, far) = (of(StoppingRule::Step, 1e-14), of(StoppingRule::Step, 1e-11));
        let (cost, limit) = (of(StoppingRule::Cost, 1e-20), of(StoppingRule::IterationLimit, 200.0));
        assert_eq!(StoppedBy::worst([far, near]), Some(far));
        assert_eq!(StoppedBy::worst([far, cost, near]), Some(cost));
        let worst = StoppedBy::worst([limit, cost]).unwrap();
        assert!(worst == limit && !worst.converged() && cost.converged());
        assert_eq!(StoppedBy::worst([]), None);
    }
}
