//! The identified parameters and how well the data determine them.

use cdpr_calibration::fit::{Estimate, Fit, Status};
use minijinja::{Value, context};

use super::Shown;
use super::table::{Cell, Table};
use crate::answers::start_summary;
use crate::html_page::prose;
use crate::number_format::{self as number, decimals_for, fixed, signed};

/// The free parameters of the model shown.
pub(super) fn table(shown: &Shown<'_>) -> Value {
    let columns = [
        ("parameter", "def-parameter"),
        ("unit", ""),
        ("#nominal", "def-nominal"),
        ("#start", "def-start"),
        ("#value", "def-value"),
        ("#σ", "def-sigma"),
        ("#95 % interval", "def-interval"),
        ("#change", "def-change"),
        ("#change / σ", "def-change"),
        ("#prior σ", "def-prior"),
        ("remark", "def-bound"),
    ];
    let mut table = Table::new(format!("Free parameters of `{}`", shown.name), &columns);
    for estimate in &shown.judgement.fit.parameters {
        table.push("", row(estimate, shown.judgement.fit.analysis.quantile_95));
    }
    table.into_value()
}

/// A parameter with its interval, whose half width is so many deviations.
fn row(estimate: &Estimate, quantile: f64) -> Vec<Cell> {
    let (factor, unit) = match estimate.unit {
        "m" => (1e3, "mm"),
        // compliances per newton have more zeros than anybody wants to count
        "1/N" => (1e9, "1/GN"),
        other => (1.0, other),
    };
    let sigma = estimate.sigma.map(|sigma| factor * sigma);
    let plain = match unit {
        "mm" => 3,
        "1/GN" => 2,
        "N" | "N·m" => 1,
        _ => 6,
    };
    let decimals = if sigma.is_some_and(|s| s > 0.0) { decimals_for(sigma) } else { plain };
    let number = |value: f64| Cell::number(fixed(value, decimals));
    let value = factor * estimate.value;
    let change = factor * estimate.change;
    let none = || Cell::number(number::NONE);
    let interval = sigma.map(|sigma| {
        let half = quantile * sigma;
        Cell::number(format!("{} … {}", fixed(value - half, decimals), fixed(value + half, decimals)))
    });
    let remark = match (estimate.sigma, estimate.at_bound) {
        (_, true) => "at its bound",
        (None, false) => "not determined",
        _ => "",
    };
    vec![
        Cell::code(&estimate.name),
        Cell::text(unit),
        estimate.nominal.map_or_else(none, |nominal| number(factor * nominal)),
        number(factor * estimate.start),
        number(value),
        sigma.map_or_else(none, |sigma| Cell::number(number::significant(sigma, 2))),
        interval.unwrap_or_else(none),
        Cell::number(signed(change, decimals)),
        sigma.filter(|s| *s > 0.0).map_or_else(none, |sigma| Cell::number(signed(change / sigma, 1))),
        estimate.prior_sigma.map_or_else(none, |prior| Cell::number(number::short(factor * prior))),
        Cell::text(remark),
    ]
}

/// Rank, condition, weak directions, correlations, and the course of the fit.
pub(super) fn identifiability(shown: &Shown<'_>) -> Value {
    let fit = &shown.judgement.fit;
    let analysis = &fit.analysis;
    let correlations = correlations(fit);
    let count = correlations.len();
    let weak: Value = analysis.weak_directions.iter().map(|words| prose(words)).collect();
    context! {
        status => status(fit.status),
        reason => prose(&fit.reason),
        rank => format!("{} of {}", analysis.rank, fit.parameters.len()),
        condition => number::condition(analysis.condition),
        condition_scaled => number::condition(analysis.condition_scaled),
        noise_factor => number::significant(fit.noise_factor, 3),
        iterations => fit.iterations,
        stopped_by => fit.stopped_by.to_string(),
        starts => (fit.starts.count > 1).then(|| prose(&start_summary(&fit.starts))),
        optima => (fit.starts.optima.len() > 1).then(|| optima(fit).into_value()),
        weak,
        correlation_count => count,
        correlations => correlations.into_value(),
    }
}

/// Optima that the starts led to.
fn optima(fit: &Fit) -> Table {
    let columns = [
        ("#cost", "def-cost"),
        ("#starts", "def-starts"),
        ("#share %", "def-starts"),
        ("#spread mm", "def-starts"),
        ("#from the best mm", "def-starts"),
    ];
    let mut table = Table::new("Optima that the starts led to", &columns);
    for optimum in &fit.starts.optima {
        table.push(
            "",
            vec![
                Cell::number(number::significant(optimum.cost, 5)),
                Cell::number(optimum.starts.to_string()),
                Cell::number(fixed(100.0 * optimum.fraction, 0)),
                Cell::number(number::significant(1e3 * optimum.spread_m, 2)),
                Cell::number(number::significant(1e3 * optimum.distance_m, 4)),
            ],
        );
    }
    table
}

/// Outcome of the fit in words.
pub(super) fn status(status: Status) -> &'static str {
    match status {
        Status::Converged => "converged",
        Status::NotIdentifiable => "not identifiable",
        Status::NotConverged => "not converged",
        Status::NotPredictive => "no forward problem",
        _ => "ended otherwise",
    }
}

fn correlations(fit: &Fit) -> Table {
    let columns = [("parameter", ""), ("and parameter", ""), ("#correlation", "def-correlation")];
    let mut table = Table::new("Pairs of parameters that the data hardly separate", &columns);
    for pair in fit.correlations() {
        let coefficient = Cell::number(fixed(pair.coefficient, 3));
        table.push("", vec![Cell::code(&pair.first), Cell::code(&pair.second), coefficient]);
    }
    table
}
