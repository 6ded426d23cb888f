//! Report of an optimum: uncertainty, weak directions, warnings.

use super::Minimize;
use super::cost::deviations_of_norms;
use super::fit::{Optimum, find};
use super::vectors::Stacked;
use crate::fit::{
    Estimate, Fit, InputError, Settings, estimate, length_residuals, prior_sigma, threshold, used, verdict, warnings,
};
use crate::identifiability::Analysis;
use crate::joint_analysis::{JointRows, analyse_together};
use crate::misfit::Misfit;
use crate::noise::Noise;
use crate::outliers;
use crate::progress::Progress;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::TriangularFactor;

/// The fit in full: uncertainty, weak directions, warnings.
pub(crate) fn fit(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
    progress: &Progress<'_>,
) -> Result<Fit, InputError> {
    let (optimum, stacked) =
        find(model, samples, parameters, settings, progress, |optimum, vectors| optimum.stacked(vectors))?;
    let mut fit = report(optimum, &stacked, samples, parameters, settings);
    fit.warnings.extend(warnings::suspicious_units(model, samples));
    Ok(fit)
}

/// The fit of an optimum in full.
pub(crate) fn report(
    optimum: Optimum,
    stacked: &Stacked,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
) -> Fit {
    let noise = Noise::of(&misfit((&optimum, stacked), parameters, settings), &optimum.norms, optimum.absolute);
    let analysis = analyse((&optimum, stacked), (samples, noise), parameters, settings);
    let Optimum { start, calibrated, end, starts, certificate, unit, norms, .. } = optimum;
    let estimates: Vec<Estimate> = parameters
        .iter()
        .zip(&start)
        .zip(&analysis.sigmas)
        .map(|((parameter, &start), &sigma)| estimate(*parameter, start, &calibrated, sigma, settings))
        .collect();
    let (status, reason) = verdict(&analysis, &estimates, &end.stopped);
    let outliers = outliers::named(&norms, samples, |sample| length_residuals(&calibrated, samples, sample));
    let loss = used(norms.loss);
    let mut all_warnings = analysis.warnings.clone();
    all_warnings.extend(warnings::of_bounds(&estimates));
    all_warnings.extend(caution(settings));
    Fit {
        model: calibrated,
        status,
        reason,
        stopped_by: end.stopped,
        iterations: end.iterations,
        history: end.trail.costs.clone(),
        trail: end.trail,
        parameters: estimates,
        analysis,
        noise_factor: noise.factor,
        loss,
        loss_threshold: threshold(norms.loss),
        starts,
        clock_offset: None,
        frames: None,
        certificate: certificate.map(|certificate| certificate.in_metres(unit)),
        samples: samples.len(),
        outlier_warning: outliers::warning(&outliers, samples.len(), loss),
        outliers,
        warnings: all_warnings,
        rows: None,
    }
}

/// Residuals of every row of a sample over the samples.
fn series(stacked: &Stacked) -> Vec<Vec<f64>> {
    let row =
        |row: usize| (0..stacked.samples()).map(|sample| stacked.residuals[sample * stacked.size + row]).collect();
    (0..stacked.size).map(row).collect()
}

/// Warning of a cost that no statistics belong to.
fn caution(settings: &Settings) -> Option<String> {
    let is_max = settings.minimize == Minimize::Max;
    is_max.then(|| {
        "the least largest error hangs on a few samples: one outlier moves every parameter, and it has no standard deviations".to_owned()
    })
}

/// Squares at the optimum, in units of the vectors.
fn misfit((optimum, stacked): (&Optimum, &Stacked), parameters: &[Parameter], settings: &Settings) -> Misfit {
    let change = |k: usize| optimum.end.values[k] - optimum.start[k];
    let square = |(k, of): (usize, &Parameter)| Some((change(k) / prior_sigma(settings, of.kind)?).powi(2));
    let priors = parameters.iter().enumerate().filter_map(square);
    let prior_cost: f64 = priors.clone().sum();
    let rows = stacked.free_rows() + priors.count();
    let cost = stacked.residuals.norm_squared() + prior_cost;
    Misfit { cost, prior_cost, freedom: rows.saturating_sub(parameters.len()) }
}

fn analyse(
    (optimum, stacked): (&Optimum, &Stacked),
    (samples, noise): (&Samples, Noise),
    parameters: &[Parameter],
    settings: &Settings,
) -> Analysis {
    let Optimum { scale, calibrated, unit, .. } = optimum;
    let rows = JointRows {
        model: calibrated,
        samples,
        parameters,
        scale,
        count: stacked.jacobian.nrows(),
        plain: TriangularFactor::of(&(stacked.jacobian.rows(0, stacked.rows.0) * unit.unwrap_or(1.0))),
        conventions: stacked.rows.1,
        weighted: TriangularFactor::of(&stacked.jacobian),
        series: series(stacked),
        noise,
    };
    let mut analysis = analyse_together(rows, settings);
    match settings.minimize {
        Minimize::Squares => {}
        Minimize::Mean => analysis.sigmas = deviations_of_norms(stacked).unwrap_or(analysis.sigmas),
        Minimize::Max => {
            analysis.sigmas.fill(None);
            analysis.correlations.clear();
        }
    }
    analysis
}
