//! The fit of an optimum in full: uncertainty, weak directions, warnings.

use super::answer::{Estimate, Fit, Status};
use super::checks::is_at_bound;
use super::input_error::InputError;
use super::settings::{Settings, prior_sigma};
use super::{cautions, warnings};
use crate::identifiability::{Analysis, analyse};
use crate::likelihood::FittedRows;
use crate::loss::Loss;
use crate::minimize::cost::deviations_of_norms;
use crate::minimize::unknowns::Unknowns;
use crate::minimize::{Optimum, misfit};
use crate::misfit::Misfit;
use crate::noise::Noise;
use crate::objective::Minimize;
use crate::outliers;
use crate::problem::model_at;
use crate::residual::Residual;
use crate::residual::length_errors::length_errors;
use crate::residual::rows::GroupRows;
use crate::residual::rows::Rows;
use crate::stopping::{StoppedBy, StoppingRule};
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// The fit of an optimum, with warnings of the data that are `suspicious`; samples whose poses are not measured have those that were found.
pub(crate) fn report(
    residual: &mut dyn Residual,
    unknowns: &Unknowns<'_>,
    optimum: Optimum,
    samples: &Samples,
    suspicious: Vec<String>,
) -> Result<Fit, InputError> {
    let Optimum { end, starts, norms, certificate } = optimum;
    let calibrated = model_at(residual, unknowns, &end.values)?;
    let weights_noise = residual.weighing().map_or(1.0, |weighing| weighing.noise());
    let (groups, rows) = match residual.groups(&calibrated, &end.values) {
        Some(groups) => (groups?, None),
        None => {
            let mut rows = Rows::new(residual.layout(), unknowns.len());
            residual.write(&end.values, &mut rows).then_some(()).ok_or(InputError::NotFinite)?;
            (vec![GroupRows::of(&rows, calibrated.cable_count(), residual.unit())], Some(rows))
        }
    };
    let mut misfit = misfit(residual, unknowns, &end);
    if let Some(rows) = &rows {
        // another cost than the squares may have been made small
        misfit = Misfit { cost: rows.residuals.norm_squared() + misfit.prior_cost, ..misfit };
    }
    let noise = Noise::of(&misfit, &norms, residual.is_absolute());
    let noise_factor = weights_noise * noise.factor;
    let mut analysis = analyse(&calibrated, samples, unknowns, &groups, &norms, &noise);
    match (unknowns.settings.minimize, &rows) {
        (Minimize::Mean, Some(rows)) => analysis.sigmas = deviations_of_norms(rows).unwrap_or(analysis.sigmas),
        (Minimize::Max, _) => {
            analysis.sigmas.fill(None);
            analysis.correlations.clear();
        }
        _ => {}
    }
    let estimate = |((parameter, &start), &sigma): ((&Parameter, &f64), &Option<f64>)| {
        estimate(*parameter, start, &calibrated, sigma, unknowns.settings)
    };
    let named = unknowns.parameters.iter().zip(unknowns.start.iter()).zip(&analysis.sigmas);
    let estimates: Vec<Estimate> = named.map(estimate).collect();
    let remarks = residual.remarks(&calibrated, &estimates, noise_factor, &mut analysis);
    let (status, reason) = match remarks.objection {
        Some(why) => (Status::NotPredictive, why),
        None => verdict(&analysis, &estimates, &end.stopped),
    };
    let recorded = calibrated.with_lengths(samples)?;
    let outliers = outliers::named(&norms, samples, |sample| length_errors(&calibrated, &recorded, sample));
    let loss = norms.loss.map_or(Loss::Squared, |loss| loss.tail.loss());
    let mut all_warnings: Vec<String> = analysis.repeated_rows.iter().cloned().collect();
    all_warnings.extend(suspicious);
    all_warnings.extend(remarks.of_noise);
    all_warnings.extend(warnings::of_bounds(&estimates));
    all_warnings.extend(remarks.of_priors);
    all_warnings.extend(caution(unknowns.settings));
    let series = groups.into_iter().flat_map(|group| group.series).collect();
    let fitted = residual.row_weights().map(|weights| FittedRows {
        series,
        weights,
        noise: weights_noise,
        norms: norms.clone(),
        absolute: residual.is_absolute(),
        with_wrenches: residual.has_wrenches(),
    });
    Ok(Fit {
        model: calibrated,
        status,
        reason,
        stopped_by: end.stopped,
        iterations: end.iterations,
        history: end.trail.costs.clone(),
        trail: end.trail,
        parameters: estimates,
        analysis,
        noise_factor,
        loss,
        loss_threshold: weights_noise * norms.loss.map_or(f64::INFINITY, |loss| loss.threshold),
        starts,
        clock_offset: None,
        frames: None,
        shifts: Vec::new(),
        certificate: certificate.map(|certificate| certificate.in_metres(residual.unit())),
        samples: samples.len(),
        outlier_warning: outliers::warning(&outliers, samples.len(), loss),
        outliers,
        warnings: all_warnings,
        rows: fitted,
    })
}

fn estimate(parameter: Parameter, start: f64, calibrated: &Model, sigma: Option<f64>, settings: &Settings) -> Estimate {
    let value = parameter.value(calibrated.robot());
    Estimate {
        name: parameter.name(calibrated.robot()),
        unit: parameter.unit(calibrated.robot()),
        nominal: None,
        start,
        value,
        sigma,
        change: value - start,
        prior_sigma: prior_sigma(settings, parameter.kind),
        at_bound: is_at_bound(value, start, parameter.bounds()),
        parameter,
    }
}

/// Warning of a cost that no statistics belong to.
fn caution(settings: &Settings) -> Option<String> {
    let is_max = settings.minimize == Minimize::Max;
    is_max.then(|| {
        "the least largest error hangs on a few samples: one outlier moves every parameter, and it has no standard deviations".to_owned()
    })
}

/// Status of an optimum, and the reason in words.
fn verdict(analysis: &Analysis, estimates: &[Estimate], stopped: &StoppedBy) -> (Status, String) {
    let count = estimates.len();
    if !stopped.converged() {
        let reason = match stopped.rule {
            StoppingRule::IterationLimit => {
                format!("{stopped} was reached before the parameters settled")
            }
            _ => format!("the parameters did not settle: {stopped}"),
        };
        let weak = match analysis.weak_directions.len() {
            0 => String::new(),
            _ => format!("; the data hold them weakly along: {}", analysis.weak_directions.join("; ")),
        };
        return (Status::NotConverged, reason + &weak);
    }
    if count == 0 {
        return (Status::Converged, "nothing was free".to_owned());
    }
    let at_bounds = cautions::at_bounds(estimates).map_or_else(String::new, |words| format!("; {words}"));
    let directions = analysis.weak_directions.join("; ");
    if analysis.rank < count && analysis.undetermined > 0 {
        let rank = analysis.rank;
        let reason =
            format!("the data determine {rank} of {count} parameters{at_bounds}; not determined: {directions}");
        return (Status::NotIdentifiable, reason);
    }
    let reason = match analysis.weak_directions.len() {
        0 => format!("all {count} parameters are determined{at_bounds}"),
        _ => format!("all {count} parameters are determined{at_bounds}, but weakly along: {directions}"),
    };
    (Status::Converged, reason)
}
