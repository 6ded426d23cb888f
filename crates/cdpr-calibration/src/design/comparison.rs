//! A plan beside other numbers of poses and beside the plain grid.

use super::exchange::search;
use super::information::Information;
use super::settings::PlanSettings;
use cdpr_model::measurement::Samples;

/// Most points of a curve.
const POINTS: usize = 12;

/// Starts of the other designs: a curve is to be read, not to be driven.
const STARTS: u32 = 4;

/// Information of the best poses of a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CurvePoint {
    /// Number of poses.
    pub count: usize,
    /// log det M; `None` where as many poses do not determine all parameters.
    pub log_det: Option<f64>,
}

/// The plain grid of as many poses.
#[derive(Clone, Debug, PartialEq)]
pub struct GridComparison {
    /// log det M of the grid; `None` where it does not determine all parameters.
    pub log_det: Option<f64>,
    /// exp((log det grid − log det plan)/p): share of the plan's poses that would tell as much as the grid; `None` where the plan does not determine all
    /// parameters, 0 where only the grid does not.
    pub efficiency: Option<f64>,
}

/// Information over the number of poses: up to twice as many, as far as there are candidates.
pub(super) fn curve(
    information: &Information,
    samples: &Samples,
    settings: &PlanSettings,
    of_plan: Option<f64>,
) -> Vec<CurvePoint> {
    let most = if settings.repeats { 2 * settings.count } else { (2 * settings.count).min(information.candidates()) };
    let mut counts: Vec<usize> =
        (1..=POINTS).map(|place| (place * most).div_ceil(POINTS)).chain([settings.count]).collect();
    counts.sort_unstable();
    counts.dedup();
    let point = |count: usize| {
        if count == settings.count {
            return CurvePoint { count, log_det: of_plan };
        }
        let settings = PlanSettings { count, starts: settings.starts.min(STARTS), ..settings.clone() };
        CurvePoint { count, log_det: information.summary(&search(information, samples, &settings).chosen).log_det }
    };
    counts.into_iter().map(point).collect()
}

/// Compares a plan with a grid.
pub(super) fn against_grid(information: &Information, grid: &[usize], of_plan: Option<f64>) -> GridComparison {
    let summary = information.summary(grid);
    let parameters = information.parameter_count() as f64;
    let fraction = |plan: f64| summary.log_det.map_or(0.0, |grid| ((grid - plan) / parameters).exp());
    GridComparison { log_det: summary.log_det, efficiency: of_plan.map(fraction) }
}
