//! Deviations that a plan lets expect: those of a fit to its exact records.

use super::candidates::Candidates;
use crate::fit::{self, Fit, Settings};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{FreeParameters, Model};

/// Length noise where no accuracy is stated (m).
const ASSUMED_LENGTH: f64 = fit::ASSUMED_NOISE;

/// Most poses at which the platform's band is asked.
const BANDS: usize = 60;

/// Deviation of a parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct ParameterPrediction {
    /// Name, e.g. `frame-anchor[1].x`.
    pub parameter: String,
    /// Its unit; empty for a ratio.
    pub unit: &'static str,
    /// Standard deviation; `None` where the poses do not determine it.
    pub sigma: Option<f64>,
}

/// Deviation of the pose that a controller with the identified parameters drives to, over the candidates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PosePrediction {
    /// Root mean square over poses of the root of the mean squared distance (m).
    pub position_m: f64,
    /// Largest (m).
    pub position_max_m: f64,
    /// Root mean square of the angle (rad).
    pub rotation_rad: f64,
    /// Poses that were asked.
    pub poses: usize,
}

/// Deviations that measurements at some poses lead to.
#[derive(Clone, Debug, PartialEq)]
pub struct Predicted {
    /// Length noise that was assumed since no accuracy is stated (m); deviations are proportional to it.
    pub assumed: Option<f64>,
    /// Every free parameter.
    pub deviations: Vec<ParameterPrediction>,
    /// The platform; `None` where a parameter is not determined, or no pose has an answer.
    pub pose: Option<PosePrediction>,
    /// Directions that these poses leave weak, in words.
    pub weak_directions: Vec<String>,
}

impl Predicted {
    /// Of exact records at poses of candidates; bands of the platform are asked at the candidates, where there are any to ask.
    pub fn of(
        model: &Model,
        candidates: &Candidates,
        chosen: &[usize],
        given: Option<&Samples>,
        free: &FreeParameters,
        settings: &Settings,
    ) -> Result<Self, fit::InputError> {
        let stated = candidates.samples.sigmas;
        let assumed = (stated == Default::default()).then_some(ASSUMED_LENGTH);
        let mut samples = candidates.samples.subset(chosen);
        samples.sigmas.length = stated.length.or(assumed);
        if let Some(given) = given {
            let exact = Candidates::exact(model, given).unwrap_or_else(|| given.clone());
            samples = samples.followed_by(&exact).unwrap_or(samples);
        }
        let settings = Settings { loss: crate::Loss::Squared, starts: 1, ..settings.clone() };
        let fit = fit::fit(model, &samples, free, &settings)?;
        let of = |estimate: &fit::Estimate| ParameterPrediction {
            parameter: estimate.name.clone(),
            unit: estimate.unit,
            sigma: estimate.sigma,
        };
        Ok(Self {
            assumed,
            deviations: fit.parameters.iter().map(of).collect(),
            pose: bands(&fit, &candidates.samples),
            weak_directions: fit.analysis.weak_directions.clone(),
        })
    }
}

/// Bands of the platform over poses; `None` where a parameter has no deviation.
fn bands(fit: &Fit, samples: &Samples) -> Option<PosePrediction> {
    if fit.without_deviation() > 0 || fit.parameters.is_empty() {
        return None;
    }
    let step = samples.len().div_ceil(BANDS);
    let poses: Vec<_> = samples.poses.iter().copied().step_by(step).collect();
    let bands: Vec<_> = fit.pose_bands(&poses).ok()?.into_iter().flatten().collect();
    let mean = |squares: f64| (squares / bands.len() as f64).sqrt();
    (!bands.is_empty()).then(|| PosePrediction {
        position_m: mean(bands.iter().map(|band| band.position * band.position).sum()),
        position_max_m: bands.iter().map(|band| band.position).fold(0.0, f64::max),
        rotation_rad: mean(bands.iter().map(|band| band.rotation * band.rotation).sum()),
        poses: bands.len(),
    })
}
