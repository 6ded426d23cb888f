//! Free parameters with their priors, bounds and scales, as every descent sees them.

use std::borrow::Cow;
use std::ops::Range;

use super::dense::DenseEquations;
use super::descent::Around;
use crate::fit::{Settings, prior_sigma};
use crate::loss::RobustLoss;
use cdpr_model::robot::Parameter;
use cdpr_model::solve::Rules;

/// Free parameters of a problem, or of one of its blocks.
#[derive(Clone, Debug)]
pub(crate) struct Unknowns<'a> {
    pub(crate) parameters: &'a [Parameter],
    /// Values before the fit, where priors are centred.
    pub(crate) start: Cow<'a, [f64]>,
    /// Metres that one unit of each parameter is worth.
    pub(crate) scale: Cow<'a, [f64]>,
    pub(crate) settings: &'a Settings,
    /// Mean recorded tension, 0 without (N).
    pub(crate) mean_tension: f64,
}

/// Cost of the norm of a sample's rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shape {
    /// ‖r‖².
    Square,
    /// ‖r‖, rounded at zero by so much.
    Norm(f64),
    /// C² ρ(‖r‖²/C²).
    Robust(RobustLoss),
}

/// Cost and end of one descent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pace {
    pub(crate) shape: Shape,
    /// Share of the cost that the next step may still promise.
    pub(crate) least_gain: f64,
    /// Steps at most beside those of the settings; `None` without a limit of its own.
    pub(crate) patience: Option<u32>,
}

/// Ridge on one parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ridge {
    pub(crate) parameter: usize,
    pub(crate) centre: f64,
    /// 1/σ².
    pub(crate) weight: f64,
}

impl Ridge {
    /// ((p − p_start)/σ)².
    pub(crate) fn cost(&self, values: &[f64]) -> f64 {
        self.weight * (values[self.parameter] - self.centre).powi(2)
    }
}

impl Unknowns<'_> {
    /// Those of a block.
    pub(crate) fn within(&self, block: Range<usize>) -> Unknowns<'_> {
        Unknowns {
            parameters: &self.parameters[block.clone()],
            start: Cow::Borrowed(&self.start[block.clone()]),
            scale: Cow::Borrowed(&self.scale[block]),
            settings: self.settings,
            mean_tension: self.mean_tension,
        }
    }

    /// Number of parameters.
    pub(crate) fn len(&self) -> usize {
        self.parameters.len()
    }

    /// Priors of the parameters.
    pub(crate) fn ridges(&self) -> impl Iterator<Item = Ridge> {
        let ridge = |(parameter, of): (usize, &Parameter)| {
            let sigma = prior_sigma(self.settings, of.kind)?;
            Some(Ridge { parameter, centre: self.start[parameter], weight: 1.0 / (sigma * sigma) })
        };
        self.parameters.iter().enumerate().filter_map(ridge)
    }

    /// True where a parameter has a prior.
    pub(crate) fn has_priors(&self) -> bool {
        self.ridges().next().is_some()
    }

    /// Σ ((p − p_start)/σ_prior)².
    pub(crate) fn prior_cost(&self, values: &[f64]) -> f64 {
        self.ridges().map(|ridge| ridge.cost(values)).sum()
    }

    /// Adds the priors to normal equations.
    pub(crate) fn add_priors(&self, values: &[f64], equations: &mut DenseEquations) {
        for Ridge { parameter, centre, weight } in self.ridges() {
            let change = values[parameter] - centre;
            equations.cost += weight * change * change;
            equations.gradient[parameter] += weight * change;
            equations.hessian[(parameter, parameter)] += weight;
        }
    }

    /// Takes values that lie within rounding of a bound to it: trust regions come as near as numbers go, and never there.
    pub(crate) fn take_to_bounds(&self, values: &mut [f64]) {
        for ((value, start), parameter) in values.iter_mut().zip(self.start.iter()).zip(self.parameters) {
            let (low, high) = parameter.bounds();
            let is_at = |bound: f64| (*value - bound).abs() <= f64::EPSILON * bound.abs().max(start.abs());
            if let Some(bound) = [low, high].into_iter().find(|bound| bound.is_finite() && is_at(*bound)) {
                *value = bound;
            }
        }
    }

    /// Surroundings of a descent; `ends_ahead` where it may end before a step that only rounding is left behind.
    pub(crate) fn around(&self, ends_ahead: bool) -> Around<'_> {
        let Settings { minimizer, keeps_course, .. } = *self.settings;
        Around { parameters: self.parameters, scale: &self.scale, minimizer, keeps_course, ends_ahead }
    }

    /// Rules by which a descent ends.
    pub(crate) fn rules(&self, pace: &Pace) -> Rules<f64> {
        Rules {
            tolerance: self.settings.tolerance,
            max_iterations: pace.patience.unwrap_or(u32::MAX).min(self.settings.max_iterations),
            least_gain: pace.least_gain,
            rule: self.settings.minimizer.rule(),
        }
    }
}
