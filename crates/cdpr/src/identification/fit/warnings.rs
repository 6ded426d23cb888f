//! What a careful reader of a fit should know, in words.

use super::Estimate;
use crate::identification::weights::Weights;
use crate::measurement::Samples;
use crate::model::Model;

/// Cables whose recorded lengths are far from the modelled ones before the fit: a wrong unit, order or robot, which a fit
/// would turn into absurd parameters.
pub(super) fn suspicious_units(model: &Model, samples: &Samples) -> Vec<String> {
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

/// What the noise, the weights and the bounds give reason to say.
pub(super) fn of_fit(weights: &Weights, noise_factor: f64, estimates: &[Estimate]) -> Vec<String> {
    let mut warnings = Vec::new();
    if weights.absolute && noise_factor > 2.0 {
        warnings.push(format!(
            "the residuals are {noise_factor:.1} times larger than the sensor accuracies explain: the model lacks something, \
             or the accuracies are too optimistic; standard deviations are enlarged by this factor"
        ));
    }
    if !weights.absolute && !estimates.is_empty() {
        // equal weights: the first one is that of all
        let noise = weights.of_cable(0).first().map_or(f64::NAN, |weight| 1e3 * noise_factor / weight);
        warnings.push(format!(
            "no sensor accuracy is known (a sidecar file DATA.meta.toml or --sigma tells it): all lengths weigh the same, and \
             standard deviations come from the residuals of {noise:.2} mm"
        ));
    }
    for estimate in estimates.iter().filter(|estimate| estimate.at_bound) {
        warnings.push(format!("{} lies on its bound {}", estimate.name, estimate.value));
    }
    warnings
}
