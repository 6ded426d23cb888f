//! Warnings about a fit, in words: doubts about noise, bounds and rank.

use super::{ASSUMED_NOISE, ASSUMED_TENSION_SHARE, Estimate};
use cdpr_model::measurement::{Samples, SensorSigmas, three_digits};
use cdpr_model::model::Model;

/// Cables whose recorded lengths are far from the modelled ones before the fit: a wrong unit, order or robot, which a fit
/// would turn into absurd parameters.
pub(crate) fn suspicious_units(model: &Model, samples: &Samples) -> Vec<String> {
    let mut warnings = Vec::new();
    for cable in 0..model.cable_count() {
        let (mut recorded, mut modelled) = (0.0, 0.0);
        for (sample, pose) in samples.poses.iter().enumerate() {
            recorded += samples.lengths_of(sample)[cable];
            modelled += model.path(cable, pose).map_or(0.0, |(path, _)| model.recorded_length(cable, path.length));
        }
        let ratio = recorded / modelled;
        if !(0.5..=2.0).contains(&ratio) {
            let (number, count) = (cable + 1, samples.len() as f64);
            warnings.push(format!(
                "cable {number}: the recorded lengths ({} m in the mean) are {} of the modelled ones ({} m): is the unit in the \
                 column's name right, and the order of the cables?",
                three_digits(recorded / count),
                three_digits(ratio),
                three_digits(modelled / count)
            ));
        }
    }
    warnings
}

/// Warning about the noise of lengths, stated or told by the residuals.
pub(crate) fn of_length_noise(is_stated: bool, noise_factor: f64, parameter_count: usize) -> Option<String> {
    if is_stated || parameter_count == 0 {
        return of_noise(noise_factor, parameter_count).filter(|_| is_stated);
    }
    let noise = match noise_factor.is_finite() {
        true => format!("the residuals of {:.2} mm", 1e3 * noise_factor * ASSUMED_NOISE),
        false => "an assumed noise of 1 mm, since there are as many parameters as rows".to_owned(),
    };
    Some(format!(
        "no sensor accuracy is known (a sidecar file DATA.meta.toml or --sigma tells it): all lengths weigh the same, and \
         standard deviations come from {noise}"
    ))
}

/// Residuals larger than the stated accuracies explain.
pub(crate) fn of_noise(noise_factor: f64, parameter_count: usize) -> Option<String> {
    if noise_factor.is_nan() && parameter_count > 0 {
        let text = "there are as many parameters as rows and priors: nothing is left over that would tell whether the model fits";
        return Some(text.to_owned());
    }
    (noise_factor > 2.0).then(|| {
        format!(
            "the residuals are {noise_factor:.1} times larger than the sensor accuracies explain: the model lacks something, \
             or the accuracies are too optimistic; standard deviations are enlarged to agree with the residuals"
        )
    })
}

/// Assumptions where only some accuracies are stated; all of them count as known then.
pub(crate) fn of_assumptions(sigmas: &SensorSigmas, mean_tension: f64) -> Vec<String> {
    let mut assumed = Vec::new();
    let lengths_known = sigmas.length.is_some() || sigmas.position.is_some();
    if !lengths_known {
        assumed.push(format!("lengths are assumed to be known to {} mm, poses exactly", 1e3 * ASSUMED_NOISE));
    }
    if sigmas.tension.is_none() {
        let assumed_tension = ASSUMED_TENSION_SHARE * mean_tension;
        assumed.push(format!("tensions are assumed to be known to 1 % of their mean ({assumed_tension:.3} N)"));
    }
    let mut warnings: Vec<String> = assumed
        .into_iter()
        .map(|assumed| {
            format!("only some sensor accuracies are stated: {assumed}; the weights of the rows depend on it")
        })
        .collect();
    warnings.extend(exact_poses(sigmas).filter(|_| lengths_known));
    warnings
}

/// Poses count as exact where no accuracy of theirs is stated beside that of the lengths.
fn exact_poses(sigmas: &SensorSigmas) -> Option<String> {
    let text = "only some sensor accuracies are stated: measured poses count as exact";
    (sigmas.position.is_none() && sigmas.rotation.is_none()).then(|| text.to_owned())
}

/// Parameters on a bound.
pub(crate) fn of_bounds(estimates: &[Estimate]) -> Vec<String> {
    let at_bound = estimates.iter().filter(|estimate| estimate.at_bound);
    at_bound.map(|estimate| format!("{} lies at its bound: {}", estimate.name, estimate.value)).collect()
}
