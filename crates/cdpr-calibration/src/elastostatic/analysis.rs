//! Identifiability of an elastic model's parameters, and the report of its fit.

use super::descent::Problem;
use super::noise::SLACK_SIGMA;
use super::optimum::Optimum;
use super::rows::{RowModel, SampleRows, first_columns};
use crate::fit::{Estimate, Fit, Settings, Status, estimate, threshold, used, verdict, warnings};
use crate::identifiability::Analysis;
use crate::joint_analysis::{JointRows, analyse_together};
use crate::likelihood::FittedRows;
use crate::noise::Noise;
use crate::outliers;
use crate::recorded::Recorded;
use cdpr_model::equilibrium::elastostatics;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::{Parameter, ParameterKind};
use cdpr_model::scalar::TriangularFactor;
use cdpr_model::statics::Load;

/// Prior and data contradict each other when the parameters moved this many times farther than the prior lets expect.
const CONFLICT: f64 = 2.0;

/// The fit in full: uncertainty, weak directions, warnings.
pub(crate) fn report(samples: &Samples, parameters: &[Parameter], optimum: Optimum, settings: &Settings) -> Fit {
    let model = &optimum.start_model;
    let noise = Noise::of(&optimum.misfit, &optimum.norms, optimum.absolute);
    let noise_factor = optimum.noise * noise.factor;
    let (analysis, series) = analyse(&optimum, samples, parameters, noise, settings);
    let estimates: Vec<Estimate> = parameters
        .iter()
        .zip(&analysis.sigmas)
        .map(|(parameter, &sigma)| {
            estimate(*parameter, parameter.value(model.robot()), &optimum.calibrated, sigma, settings)
        })
        .collect();
    let (mut status, mut reason) = verdict(&analysis, &estimates, &optimum.stopped());
    if let Some(why) = without_forward_problem(&optimum.calibrated, &estimates) {
        (status, reason) = (Status::NotPredictive, why);
    }
    let loss = used(optimum.norms.loss);
    let rows = FittedRows {
        weights: row_weights(&optimum, samples, series.len()),
        series,
        noise: optimum.noise,
        norms: optimum.norms.clone(),
        absolute: optimum.absolute,
        with_wrenches: true,
    };
    let outliers =
        outliers::named(&optimum.norms, samples, |sample| length_residuals(&optimum.calibrated, samples, sample));
    let mut all_warnings = analysis.warnings.clone();
    all_warnings.extend(warnings::suspicious_units(model, samples));
    if settings.row_weights.is_none() {
        all_warnings.extend(noise_warnings(samples, &optimum, noise_factor, parameters.len()));
    }
    all_warnings.extend(warnings::of_bounds(&estimates));
    all_warnings.extend(prior_conflicts(&estimates));
    Fit {
        status,
        reason,
        stopped_by: optimum.stopped(),
        iterations: optimum.iterations(),
        history: optimum.trail().costs.clone(),
        trail: optimum.trail().clone(),
        parameters: estimates,
        analysis,
        noise_factor,
        loss,
        loss_threshold: optimum.noise * threshold(optimum.norms.loss),
        starts: optimum.starts,
        clock_offset: None,
        frames: None,
        certificate: None,
        samples: samples.len(),
        outlier_warning: outliers::warning(&outliers, samples.len(), loss),
        outliers,
        warnings: all_warnings,
        rows: Some(rows),
        model: optimum.calibrated,
    }
}

/// 1/σ of every row over the samples, 0 for the length rows of slack cables.
fn row_weights(optimum: &Optimum, samples: &Samples, rows: usize) -> Vec<Vec<f64>> {
    let mut weights = vec![Vec::with_capacity(samples.len()); rows];
    let least = 1.0 / (SLACK_SIGMA * optimum.noise);
    for sample in 0..samples.len() {
        for (row, deviation) in optimum.linearization.deviations(sample).enumerate() {
            let weight = 1.0 / deviation;
            weights[row].push(if weight > least { weight } else { 0.0 });
        }
    }
    weights
}

/// Modelled minus recorded lengths of a sample (from 0) at its measured pose and tensions (m).
pub(crate) fn length_residuals(model: &Model, samples: &Samples, sample: usize) -> Vec<f64> {
    let (Ok(load), Some(tensions)) = (Load::of(model.robot()), &samples.tensions) else { return Vec::new() };
    let m = samples.cable_count;
    let mut rows = SampleRows::new(model, 0);
    let tensions = &tensions[sample * m..][..m];
    RowModel::new(model, load, &[]).write(&samples.poses[sample], tensions, Recorded::of(samples, sample), &mut rows);
    (0..m).map(|cable| rows.residual(rows.count - m + cable)).collect()
}

/// Warnings about accuracies, stated or assumed.
fn noise_warnings(samples: &Samples, optimum: &Optimum, noise_factor: f64, parameter_count: usize) -> Vec<String> {
    let mean_tension = optimum.tensions.iter().sum::<f64>() / optimum.tensions.len() as f64;
    if optimum.absolute {
        let assumed = warnings::of_assumptions(&samples.sigmas, mean_tension);
        return warnings::of_noise(noise_factor, parameter_count).into_iter().chain(assumed).collect();
    }
    let told = match noise_factor.is_finite() {
        true => format!("multiplied by {noise_factor:.2} to agree with the residuals"),
        false => "taken as they are, since there are as many parameters as rows".to_owned(),
    };
    let words = format!(
        "no sensor accuracy is known (a sidecar file DATA.meta.toml or --sigma tells it): 1 mm for lengths and 1 % of the mean for \
         tensions are assumed and {told}"
    );
    (parameter_count > 0).then_some(words).into_iter().collect()
}

/// The reason where a fit has made more cables rigid than there are degrees of freedom, with its likely cause.
fn without_forward_problem(calibrated: &Model, estimates: &[Estimate]) -> Option<String> {
    let load = Load::of(calibrated.robot()).ok()?;
    let refusal = elastostatics::Solver::new(calibrated, &load, &elastostatics::Settings::default()).err()?;
    let of = |kind: ParameterKind| estimates.iter().filter(move |estimate| estimate.parameter.kind == kind);
    let rigid: Vec<String> =
        of(ParameterKind::Compliance).filter(|e| e.at_bound).map(|e| (e.parameter.cable + 1).to_string()).collect();
    if rigid.is_empty() {
        return None;
    }
    let cause = match of(ParameterKind::LengthOffset).next() {
        None => {
            "the recorded lengths leave no room for stretch, which offsets of the winches in the record would explain: free              `length-offset` too"
        }
        Some(_) => {
            "the recorded lengths do not follow the recorded tensions: check their units, signs and order of the cables"
        }
    };
    Some(format!(
        "the fit drives the compliance of cables {} to 0, so that the calibrated model predicts no poses ({refusal}). Likely cause: \
         {cause}",
        rigid.join(", ")
    ))
}

fn analyse(
    optimum: &Optimum,
    samples: &Samples,
    parameters: &[Parameter],
    noise: Noise,
    settings: &Settings,
) -> (Analysis, Vec<Vec<f64>>) {
    let Ok(load) = Load::of(optimum.calibrated.robot()) else {
        let (inflation, quantile_95) = (noise.inflation, noise.quantile(1.0));
        return (Analysis { inflation, quantile_95, ..Analysis::default() }, Vec::new());
    };
    let ([plain, weighted], series) = stacked(optimum, samples, parameters, load);
    let model = &optimum.calibrated;
    let problem = Problem::new(&optimum.start_model, samples, &optimum.tensions, parameters, settings);
    let mut weighed = series.clone();
    weighed.iter_mut().for_each(|row| optimum.norms.weigh(row));
    let scale = problem.scale();
    let count = samples.len() * series.len();
    let rows =
        JointRows { model, samples, parameters, scale, count, plain, conventions: 0, weighted, series: weighed, noise };
    let mut analysis = analyse_together(rows, settings);
    analysis.unknown_stiffness = unknown_stiffness(optimum, parameters, &analysis);
    analysis.weak_directions.extend(analysis.unknown_stiffness.clone());
    (analysis, series)
}

/// Jacobians without and with weights, and the whitened residuals row by row of a sample.
fn stacked(
    optimum: &Optimum,
    samples: &Samples,
    parameters: &[Parameter],
    load: Load,
) -> ([TriangularFactor; 2], Vec<Vec<f64>>) {
    let row_model = RowModel::new(&optimum.calibrated, load, parameters);
    let mut rows = SampleRows::new(&optimum.calibrated, parameters.len());
    let [mut plain, mut weighted] = [(); 2].map(|()| TriangularFactor::new(parameters.len()));
    // a length knows the parameters of its own cable only: few columns, whose factor joins at the end
    let first = first_columns(&optimum.calibrated, parameters);
    let own = |cable: usize| first[cable]..first[cable + 1];
    let mut of_lengths: Vec<_> =
        (0..samples.cable_count).map(|cable| TriangularFactor::new(own(cable).len())).collect();
    let wrench_rows = rows.count - samples.cable_count;
    let mut residuals = vec![Vec::with_capacity(samples.len()); rows.count];
    for sample in 0..samples.len() {
        optimum.linearization.write(&row_model, samples, sample, &mut rows);
        rows.derivatives().take(wrench_rows).for_each(|row| plain.push(row.iter().copied()));
        for (cable, (row, factor)) in rows.derivatives().skip(wrench_rows).zip(&mut of_lengths).enumerate() {
            factor.push(row[own(cable)].iter().copied());
        }
        optimum.linearization.whiten(sample, &mut rows);
        rows.derivatives().for_each(|row| weighted.push(row.iter().copied()));
        residuals.iter_mut().enumerate().for_each(|(row, residuals)| residuals.push(rows.residual(row)));
    }
    for (cable, factor) in of_lengths.into_iter().enumerate() {
        let columns = own(cable);
        for row in factor.into_matrix().row_iter() {
            let entry = |k: usize| if columns.contains(&k) { row[k - columns.start] } else { 0.0 };
            plain.push((0..parameters.len()).map(entry));
        }
    }
    ([plain, weighted], residuals)
}

/// Cables whose compliance has a 95 % interval wider than ± a quarter of it: too little for a controller that relies on it.
fn unknown_stiffness(optimum: &Optimum, parameters: &[Parameter], analysis: &Analysis) -> Option<String> {
    let mut cables = Vec::new();
    for (parameter, sigma) in parameters.iter().zip(&analysis.sigmas) {
        let value = parameter.value(optimum.calibrated.robot());
        if parameter.kind == ParameterKind::Compliance
            && sigma.is_none_or(|sigma| analysis.quantile_95 * sigma > 0.25 * value)
        {
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
    for kind in ParameterKind::IDENTIFIED {
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
