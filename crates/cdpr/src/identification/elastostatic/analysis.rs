//! What the data determine of an elastic model, and the report of its fit.

use nalgebra::{DMatrix, DVector};

use super::descent::Problem;
use super::optimum::Optimum;
use super::rows::{RowModel, SampleRows};
use crate::identification::autocorrelation::correlation_time;
use crate::identification::fit::{Estimate, Fit, Settings, estimate, verdict, warnings};
use crate::identification::identifiability::{
    Analysis, Named, Uncertainty, mean_rotation, rank_and_condition, spectrum, with_priors, with_unit_columns,
};
use crate::identification::words::describe;
use crate::measurement::Samples;
use crate::model::{Parameter, ParameterKind};
use crate::statics::Load;

/// Prior and data contradict each other when the parameters moved this many times farther than the prior lets expect.
const CONFLICT: f64 = 2.0;

/// The fit in full: uncertainty, weak directions, warnings.
pub(crate) fn report(samples: &Samples, parameters: &[Parameter], optimum: Optimum, settings: &Settings) -> Fit {
    let model = &optimum.start_model;
    let factor = Problem::new(model, samples, &optimum.tensions, parameters, settings).noise_factor(optimum.end.cost);
    let inflation = if optimum.absolute { factor.max(1.0) } else { factor };
    let analysis = analyse(&optimum, samples, parameters, inflation, settings);
    let estimates: Vec<Estimate> = parameters
        .iter()
        .zip(&analysis.sigmas)
        .map(|(parameter, &sigma)| estimate(model, &optimum.calibrated, *parameter, sigma, settings))
        .collect();
    let (status, reason) = verdict(&analysis, parameters.len(), optimum.converged(), settings);
    let mut all_warnings = analysis.warnings.clone();
    all_warnings.extend(warnings::suspicious_units(model, samples));
    all_warnings.extend(warnings::of_noise(optimum.absolute, factor, parameters.len()));
    all_warnings.extend(warnings::of_bounds(&estimates));
    all_warnings.extend(prior_conflicts(&estimates));
    Fit {
        status,
        reason,
        iterations: optimum.iterations(),
        history: optimum.history().to_vec(),
        parameters: estimates,
        analysis,
        noise_factor: factor,
        basins: optimum.basins,
        warnings: all_warnings,
        model: optimum.calibrated,
    }
}

fn analyse(
    optimum: &Optimum,
    samples: &Samples,
    parameters: &[Parameter],
    inflation: f64,
    settings: &Settings,
) -> Analysis {
    let mut analysis = Analysis::default();
    let Ok(load) = Load::of(optimum.calibrated.robot()) else { return analysis };
    if parameters.is_empty() {
        analysis.condition = 1.0;
        analysis.condition_scaled = 1.0;
        return analysis;
    }
    let (plain, weighted, residuals) = stacked(optimum, samples, parameters, load);
    let plain_values = spectrum(&plain).values;
    (analysis.rank, analysis.condition) = rank_and_condition(&plain_values, plain.nrows());
    let scaled_values = spectrum(&with_unit_columns(plain)).values;
    (_, analysis.condition_scaled) = rank_and_condition(&scaled_values, samples.len());
    analysis.singular_values = plain_values;

    let mut times: Vec<f64> = residuals.iter().map(|series| correlation_time(series)).collect();
    times.sort_by(f64::total_cmp);
    let time = times[times.len() / 2];
    if time > 1.0 {
        analysis.warnings.push(format!(
            "residuals of consecutive samples repeat each other (correlation time {time:.0} samples): standard deviations are \
             enlarged by {:.1} to account for it",
            time.sqrt()
        ));
    }
    let posterior = spectrum(&with_priors(weighted, parameters, settings));
    let uncertainty = Uncertainty::new(&posterior, inflation * time.sqrt());
    analysis.undetermined = uncertainty.undetermined;
    analysis.correlations = uncertainty.correlations(&optimum.start_model, parameters);
    analysis.correlation_rows = uncertainty.correlation_rows(0);
    let model = &optimum.calibrated;
    let problem = Problem::new(&optimum.start_model, samples, &optimum.tensions, parameters, settings);
    let named = Named {
        parameters,
        axes: model.axes(),
        cables: 0..model.cable_count(),
        worth: DVector::from_column_slice(problem.worth()),
    };
    let directions = uncertainty.weak_directions(&named, &mean_rotation(samples), settings.weak_direction_limit);
    analysis.weak_directions = describe(model, directions);
    analysis.sigmas = uncertainty.sigmas;
    analysis.weak_directions.extend(unknown_stiffness(optimum, parameters, &analysis.sigmas));
    analysis
}

/// Jacobian without weights, with weights, and the whitened residuals row by row of a sample.
fn stacked(
    optimum: &Optimum,
    samples: &Samples,
    parameters: &[Parameter],
    load: Load,
) -> (DMatrix<f64>, DMatrix<f64>, Vec<Vec<f64>>) {
    let row_model = RowModel::new(&optimum.calibrated, load, parameters);
    let mut rows = SampleRows::new(&optimum.calibrated, parameters.len());
    let count = rows.count;
    let mut plain = DMatrix::zeros(samples.len() * count, parameters.len());
    let mut weighted = plain.clone();
    let mut residuals = vec![Vec::with_capacity(samples.len()); count];
    for sample in 0..samples.len() {
        optimum.linearization.write(&row_model, samples, sample, &mut rows);
        copy(&rows, sample, &mut plain);
        optimum.linearization.write_whitened(&row_model, samples, sample, &mut rows);
        copy(&rows, sample, &mut weighted);
        (0..count).for_each(|row| residuals[row].push(rows.residual(row)));
    }
    (plain, weighted, residuals)
}

fn copy(rows: &SampleRows, sample: usize, matrix: &mut DMatrix<f64>) {
    for row in 0..rows.count {
        for column in 0..rows.parameter_count {
            matrix[(sample * rows.count + row, column)] = rows.entries[row * rows.stride + column];
        }
    }
}

/// Cables whose compliance has a 95 % interval wider than ± a quarter of it: too little for a controller that relies on it.
fn unknown_stiffness(optimum: &Optimum, parameters: &[Parameter], sigmas: &[Option<f64>]) -> Option<String> {
    let mut cables = Vec::new();
    for (parameter, sigma) in parameters.iter().zip(sigmas) {
        let value = parameter.value(&optimum.calibrated);
        if parameter.kind == ParameterKind::Compliance && sigma.is_none_or(|sigma| 1.96 * sigma > 0.25 * value) {
            let deviation = sigma.map_or("not determined at all".to_owned(), |sigma| format!("± {:.0}", 1e9 * sigma));
            cables.push(format!("{} (compliance {:.0} {deviation} 1/GN)", parameter.cable + 1, 1e9 * value));
        }
    }
    (!cables.is_empty()).then(|| {
        format!(
            "the stiffness of cables {} is unknown, not even to ± 25 %: record tension tests (shorten single cables)",
            cables.join(", ")
        )
    })
}

/// Kinds whose parameters moved farther than their prior lets expect: prior and data contradict each other.
///
/// Under the prior, Σ (change/σ_prior)² is in the mean the number of directions that the data determine, Σ (1 − σ²/σ_prior²).
fn prior_conflicts(estimates: &[Estimate]) -> Vec<String> {
    let mut found = Vec::new();
    for kind in ParameterKind::ALL {
        let with_prior = || {
            let of_kind = estimates.iter().filter(move |e| e.parameter.kind == kind);
            of_kind.filter_map(|e| Some((e.change, e.sigma.unwrap_or(f64::INFINITY), e.prior_sigma?)))
        };
        let squares: f64 = with_prior().map(|(change, _, prior)| (change / prior).powi(2)).sum();
        let expected: f64 = with_prior().map(|(_, sigma, prior)| (1.0 - (sigma / prior).powi(2)).max(0.0)).sum();
        let ratio = (squares / expected).sqrt();
        if expected > 0.5 && ratio > CONFLICT {
            let count = with_prior().count();
            let rms = (with_prior().map(|(change, _, _)| change * change).sum::<f64>() / count as f64).sqrt();
            let prior = with_prior().next().map_or(f64::NAN, |(_, _, prior)| prior);
            let unit = kind.unit();
            found.push(format!(
                "prior conflict: the {kind} parameters moved by {rms:.3} {unit} rms against a prior of {prior:.3} {unit}, {ratio:.1} \
                 times farther than it lets expect; the data contradict the prior, so intervals of all parameters are too narrow: \
                 widen the prior or mend the start values"
            ));
        }
    }
    found
}
