//! What a careful reader of a fit should know, in words.

use super::Estimate;
use crate::identification::weights::Weights;
use crate::measurement::Samples;
use crate::model::Model;

/// Cables whose recorded lengths are far from the modelled ones before the fit: a wrong unit, order or robot, which a fit
/// would turn into absurd parameters.
pub(in crate::identification) fn suspicious_units(model: &Model, samples: &Samples) -> Vec<String> {
    let mut warnings = Vec::new();
    for cable in 0..model.cable_count() {
        let (mut recorded, mut modelled) = (0.0, 0.0);
        for (sample, pose) in samples.poses.iter().enumerate() {
            recorded += samples.lengths_of(sample)[cable];
            modelled +=
                model.course(cable, pose).map_or(0.0, |(course, _)| model.recorded_length(cable, course.length));
        }
        let ratio = recorded / modelled;
        if !(0.5..=2.0).contains(&ratio) {
            let (number, count) = (cable + 1, samples.len() as f64);
            warnings.push(format!(
                "cable {number}: the recorded lengths ({:.4} m in the mean) are {ratio:.3e} of the modelled ones ({:.4} m): is \
                 the unit in the column's name right, and the order of the cables?",
                recorded / count,
                modelled / count
            ));
        }
    }
    warnings
}

/// What the noise and the bounds of a kinematic fit give reason to say.
pub(super) fn of_fit(weights: &Weights, noise_factor: f64, estimates: &[Estimate]) -> Vec<String> {
    let mut warnings = Vec::new();
    if weights.absolute {
        warnings.extend(of_noise(true, noise_factor, estimates.len()));
    } else if !estimates.is_empty() {
        // equal weights: the first one is that of all
        let noise = weights.of_cable(0).first().map_or(f64::NAN, |weight| 1e3 * noise_factor / weight);
        warnings.push(format!(
            "no sensor accuracy is known (a sidecar file DATA.meta.toml or --sigma tells it): all lengths weigh the same, and \
             standard deviations come from the residuals of {noise:.2} mm"
        ));
    }
    warnings.extend(of_bounds(estimates));
    warnings
}

/// Residuals larger than the sensors explain, or accuracies that nobody stated.
pub(in crate::identification) fn of_noise(absolute: bool, noise_factor: f64, parameter_count: usize) -> Option<String> {
    match absolute {
        true if noise_factor > 2.0 => Some(format!(
            "the residuals are {noise_factor:.1} times larger than the sensor accuracies explain: the model lacks something, \
             or the accuracies are too optimistic; standard deviations are enlarged by this factor"
        )),
        false if parameter_count > 0 => Some(format!(
            "no sensor accuracy is known (a sidecar file DATA.meta.toml or --sigma tells it): 1 mm for lengths and 1 % of the \
             mean for tensions are assumed, and standard deviations multiplied by {noise_factor:.2} to agree with the residuals"
        )),
        _ => None,
    }
}

/// Parameters on a bound.
pub(in crate::identification) fn of_bounds(estimates: &[Estimate]) -> Vec<String> {
    let at_bound = estimates.iter().filter(|estimate| estimate.at_bound);
    at_bound.map(|estimate| format!("{} lies on its bound {}", estimate.name, estimate.value)).collect()
}
