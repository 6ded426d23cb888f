//! Identifiability of parameters that are identified together, whatever their rows are.

use nalgebra::DVector;

use super::autocorrelation::correlation_time;
use super::fit::Settings;
use super::identifiability::{
    Analysis, Named, Uncertainty, mean_rotation, prior_weights, rank_and_condition, singular_values, spectrum,
    with_unit_columns,
};
use super::noise::Noise;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::scalar::TriangularFactor;

/// Rows that tie all parameters together, at their optimum.
pub(super) struct JointRows<'a> {
    /// The calibrated model.
    pub(super) model: &'a Model,
    pub(super) samples: &'a Samples,
    pub(super) parameters: &'a [Parameter],
    /// Metres that one unit of each parameter is worth.
    pub(super) scale: &'a [f64],
    /// Number of rows.
    pub(super) count: usize,
    /// Jacobian of the data in SI units.
    pub(super) plain: TriangularFactor,
    /// Directions that no data tell and a convention fixes: they are no part of condition and rank.
    pub(super) conventions: usize,
    /// Jacobian in units of the rows' noise.
    pub(super) weighted: TriangularFactor,
    /// Residuals in these units, one series over the samples for each row of a sample.
    pub(super) series: Vec<Vec<f64>>,
    /// Noise of the rows in these units.
    pub(super) noise: Noise,
}

/// Analyses parameters that are identified together. The typical correlation time of the series enlarges deviations.
pub(super) fn analyse_together(rows: JointRows<'_>, settings: &Settings) -> Analysis {
    let JointRows { model, samples, parameters, scale, count, plain, conventions, mut weighted, series, noise } = rows;
    let Noise { inflation, .. } = noise;
    let mut analysis = Analysis { inflation, quantile_95: noise.quantile(1.0), ..Analysis::default() };
    if parameters.is_empty() {
        (analysis.condition, analysis.condition_scaled) = (1.0, 1.0);
        return analysis;
    }
    let plain = plain.into_matrix();
    let told = parameters.len().saturating_sub(conventions);
    let mut plain_values = singular_values(plain.clone());
    plain_values.truncate(told);
    (_, analysis.condition) = rank_and_condition(&plain_values, count);
    let mut scaled_values = singular_values(with_unit_columns(plain));
    scaled_values.truncate(told);
    // compliances in 1/N beside anchors in m are twelve decades apart whatever the data tell: columns of length one tell the rank
    (analysis.rank, analysis.condition_scaled) = rank_and_condition(&scaled_values, count);
    analysis.singular_values = plain_values;

    let mut times: Vec<f64> = series.iter().map(|series| correlation_time(series)).collect();
    times.sort_by(f64::total_cmp);
    let time = times[times.len() / 2];
    if time > 1.0 {
        analysis.warnings.push(format!(
            "residuals of consecutive samples repeat each other (correlation time {time:.0} samples): standard deviations are \
             enlarged by {:.1} to account for it",
            time.sqrt()
        ));
    }
    let priors = prior_weights(parameters, settings);
    weighted.push_diagonal(priors.iter().map(|weight| weight.sqrt()));
    let posterior = spectrum(weighted);
    let uncertainty = Uncertainty::new(&posterior, inflation * time.sqrt(), &priors);
    analysis.inflation = inflation * time.sqrt();
    analysis.quantile_95 = noise.quantile(time);
    analysis.undetermined = uncertainty.undetermined;
    let name = |k: usize| parameters[k].name(model.robot());
    analysis.set_correlations(uncertainty.correlation_rows(0), &name);
    let named = Named {
        parameters,
        axes: model.axes(),
        cables: 0..model.cable_count(),
        scale: DVector::from_column_slice(scale),
    };
    let directions = uncertainty.weak_directions(&named, &mean_rotation(samples), settings.weak_direction_limit);
    analysis.set_weak_directions(model, directions);
    analysis.sigmas = uncertainty.sigmas;
    analysis
}
