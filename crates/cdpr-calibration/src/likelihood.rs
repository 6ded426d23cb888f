//! Likelihood of the rows that a fit was made to, and the information criteria that follow from it.
//!
//! Rows are normally distributed with the covariance of the fit's weights: recorded lengths at the measured poses for rigid models, wrenches and
//! lengths at the measured poses and tensions for elastic ones. Candidates are compared by these criteria on the same rows alone.

mod residuals;
#[cfg(test)]
mod tests;

pub(super) use residuals::FittedRows;
use residuals::{Residuals, Rows};

use super::fit::Fit;
use super::loss::Loss;
use super::norms::{Extent, Norms};
use cdpr_model::reading::keywords;
use cdpr_model::robot::Robot;

/// Least variance of noise that residuals tell, in units of the assumed one: exact data leave rounding.
const LEAST_VARIANCE: f64 = 1e-12;

/// Size of the noise that a likelihood is taken at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum NoiseSource {
    /// The stated accuracies of the sensors.
    Stated,
    /// The stated accuracies, enlarged to what the candidate with the least noise leaves (quasi-likelihood).
    Enlarged,
    /// Each candidate's own residuals; the size of the noise counts as a parameter.
    Estimated,
}

keywords!(NoiseSource: Stated = "stated", Enlarged = "enlarged", Estimated = "estimated");

/// Likelihood and information criteria of a candidate (Akaike 1974, Schwarz 1978, Hurvich and Tsai 1989).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Information {
    /// ln L of the rows at the optimum.
    pub log_likelihood: f64,
    /// Rows that say something, without those of samples that no candidate explains.
    pub rows: usize,
    /// As many independent rows as these tell: rows divided by the correlation time of consecutive samples.
    pub effective_rows: f64,
    /// Directions that the data determine: one with a prior counts by the share that the data tell, 1 − σ²/σ_prior².
    pub effective_parameters: f64,
    /// Noise in units of the stated or assumed accuracies.
    pub noise: f64,
    /// Source of that noise.
    pub noise_source: NoiseSource,
    /// Whether wrenches are rows besides lengths: only candidates with the same rows are compared.
    pub with_wrenches: bool,
    /// −2 ln L · (effective rows/rows) + 2 k.
    pub aic: f64,
    /// The same corrected for few rows, + 2 k (k + 1)/(n − k − 1); not a number where there are as many parameters as rows.
    pub aicc: f64,
    /// −2 ln L · (effective rows/rows) + k ln n.
    pub bic: f64,
}

/// Information of fits in the order given; those with the same rows share samples, noise and correlation. None of a fit that made something
/// else small than what its rows leave.
pub(super) fn information(robot: &Robot, fits: &[&Fit], loss: Loss) -> Vec<Option<Information>> {
    let rated = |(place, fit): (usize, &&Fit)| {
        let residuals = Residuals::of(fit.rows.as_ref()?);
        Some(Rated { place, residuals, free: fit.parameters.len(), parameters: effective_parameters(robot, fit) })
    };
    let mut found = vec![None; fits.len()];
    let mut open: Vec<Rated> = fits.iter().enumerate().filter_map(rated).collect();
    while let Some(first) = open.first() {
        let kind = first.residuals.kind();
        let (group, rest): (Vec<Rated>, Vec<Rated>) =
            open.into_iter().partition(|other| other.residuals.kind() == kind);
        of_group(&group, loss, &mut found);
        open = rest;
    }
    found
}

/// A fit with its rows.
struct Rated {
    place: usize,
    residuals: Residuals,
    /// Free parameters.
    free: usize,
    /// Directions of parameters, frames, clock and changes of lengths that the data determine.
    parameters: f64,
}

fn of_group(group: &[Rated], loss: Loss, found: &mut [Option<Information>]) {
    let kept = kept_samples(group, loss);
    let all: Vec<Rows> = group.iter().map(|one| one.residuals.over(&kept)).collect();
    let variance = |k: usize| all[k].cost / (all[k].count as f64 - group[k].parameters).max(1.0);
    let quietest = (0..group.len()).min_by(|&a, &b| variance(a).total_cmp(&variance(b))).unwrap_or(0);
    let independent = group[quietest].residuals.independent_share;
    let common = group[0].residuals.absolute.then(|| variance(quietest).max(1.0));
    for (one, rows) in group.iter().zip(&all) {
        found[one.place] = Some(of_rows(rows, (one.parameters, independent), common, one.residuals.with_wrenches));
    }
}

/// Criteria of rows with so many parameters and this share of independent ones, at a common variance of the noise or their own.
fn of_rows(
    rows: &Rows,
    (parameters, independent): (f64, f64),
    common: Option<f64>,
    with_wrenches: bool,
) -> Information {
    let n = rows.count as f64;
    let variance = common.unwrap_or_else(|| (rows.cost / n).max(LEAST_VARIANCE));
    let twice = -(rows.cost / variance + rows.log_variance + n * (std::f64::consts::TAU * variance).ln());
    let k = parameters + if common.is_some() { 0.0 } else { 1.0 };
    let (effective, deviance) = (n * independent, -twice * independent);
    let aic = deviance + 2.0 * k;
    let room = effective - k - 1.0;
    Information {
        log_likelihood: twice / 2.0,
        rows: rows.count,
        effective_rows: effective,
        effective_parameters: k,
        noise: variance.sqrt(),
        noise_source: match common {
            None => NoiseSource::Estimated,
            Some(variance) if variance > 1.0 => NoiseSource::Enlarged,
            Some(_) => NoiseSource::Stated,
        },
        with_wrenches,
        aic,
        aicc: if room > 0.0 { aic + 2.0 * k * (k + 1.0) / room } else { f64::NAN },
        bic: deviance + k * effective.ln(),
    }
}

/// Samples with the same rows in all fits, where these agree on which cables are slack, that at least one of them explains; outliers stay in
/// under least squares.
fn kept_samples(group: &[Rated], loss: Loss) -> Vec<usize> {
    let first = &group[0].residuals.rows;
    let outliers: Vec<Vec<usize>> = group.iter().map(outliers).collect();
    let is_explained = |sample: &usize| outliers.iter().any(|of_one| of_one.binary_search(sample).is_err());
    let is_same = |sample: &usize| group.iter().all(|one| one.residuals.rows[*sample] == first[*sample]);
    (0..first.len()).filter(is_same).filter(|sample| loss == Loss::Squared || is_explained(sample)).collect()
}

fn outliers(one: &Rated) -> Vec<usize> {
    let Residuals { squares, absolute, rows, .. } = &one.residuals;
    let extent = Extent { rows: rows.iter().sum(), parameters: one.free, absolute: *absolute };
    Norms::new(squares.clone(), None, extent).outliers().collect()
}

/// Directions of parameters, frames, clock and changes of lengths that the data determine.
fn effective_parameters(robot: &Robot, fit: &Fit) -> f64 {
    let by_prior = |(sigma, prior): (f64, f64)| (sigma / prior).powi(2).min(1.0);
    let known = fit.parameters.iter().filter_map(|estimate| Some((estimate.sigma?, estimate.prior_sigma?)));
    let determined = fit.parameters.len().saturating_sub(fit.analysis.undetermined) as f64;
    let turns = if robot.motion_pattern.is_planar() { 1 } else { 3 };
    let shifts = if robot.motion_pattern.is_planar() { 2 } else { 3 };
    let of_frames = fit.frames.as_ref().map_or(0, |frames| {
        let free = usize::from(frames.tracker.is_some()) + usize::from(frames.marker.is_some());
        (free * (turns + shifts)).saturating_sub(frames.gauge.directions)
    });
    let of_clock = usize::from(fit.clock_offset.is_some());
    (determined - known.map(by_prior).sum::<f64>()).max(0.0) + (of_frames + of_clock + fit.shifts.len()) as f64
}
