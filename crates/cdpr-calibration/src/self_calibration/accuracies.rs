//! Accuracies of sensors whose noise nobody states, told by the residuals of all sensors together.

use super::internal::Sensing;
use super::question::Question;
use super::sensor_fit::SensorFit;
use crate::fit::{InputError, Settings};
use crate::minimize::minimize;
use crate::problem::model_at;
use crate::progress::unobserved;
use crate::residual::Poseless;
use crate::residual::sensors::{Sensor, Weights};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Rounds at most.
const ROUNDS: u32 = 10;
/// Steps to an optimum in each: near enough to tell accuracies.
const STEPS: u32 = 12;
/// Change of all accuracies below which they agree with the residuals.
const AGREED: f64 = 0.03;
/// Least and largest accuracy, beside the assumed one.
const RANGE: (f64, f64) = (0.03, 100.0);
/// Residuals beside the assumed accuracies that are those of data without noise.
const EXACT: f64 = 1e-4;

impl Question<'_> {
    /// Estimates the variance components of sensors without stated accuracy: each sensor's squares over the rows that are left of it (Helmert; Förstner 1979).
    pub(super) fn agree_on_accuracies(&mut self, parameters: &[Parameter], near: &[Pose]) -> Result<(), InputError> {
        let Sensing::All(_, assumed) = &self.sensing else { return Ok(()) };
        let assumed = *assumed;
        if self.are_stated() {
            return Ok(());
        }
        let settings = Settings { starts: 1, keeps_course: false, max_iterations: STEPS, ..self.settings.clone() };
        let (mut model, mut near) = (self.model.clone(), near.to_vec());
        for _ in 0..ROUNDS {
            let (fits, calibrated, poses) = self.fits_of_one_start((&model, parameters), &near, &settings)?;
            if settings.priors.is_empty() {
                // the next round goes on from here; a prior is about the file's values
                (model, near) = (calibrated, poses);
            }
            if fits.iter().all(|fit| !(fit.deviation() > EXACT * fit.sigma)) {
                break;
            }
            let Sensing::All(_, weights) = &mut self.sensing else { break };
            let before = *weights;
            fits.iter().filter(|fit| !fit.is_stated).for_each(|fit| adopt(fit, weights, &assumed));
            let change = |fit: &SensorFit| (sigma_of(fit, weights) / sigma_of(fit, &before)).ln().abs();
            if fits.iter().map(change).fold(0.0, f64::max) < AGREED {
                break;
            }
        }
        Ok(())
    }

    /// Residuals of all sensors, with the model and the poses of a search from a model's values.
    fn fits_of_one_start(
        &self,
        (model, parameters): (&Model, &[Parameter]),
        near: &[Pose],
        settings: &Settings,
    ) -> Result<(Vec<SensorFit>, Model, Vec<Pose>), InputError> {
        let mut residual = self.start(model, parameters, Some(near))?;
        let unknowns = self.unknowns(model, parameters, settings, &residual.poses())?;
        let optimum = minimize(&mut residual, &unknowns, None, &unobserved)?;
        let calibrated = model_at(&residual, &unknowns, &optimum.end.values)?;
        let end = self.rows(&calibrated, parameters, Some(&residual.poses()))?;
        Ok((self.sensor_fits(&end), calibrated, end.poses))
    }
}

/// Takes the deviation of a sensor's residuals for its accuracy.
fn adopt(fit: &SensorFit, weights: &mut Weights, assumed: &Weights) {
    let (deviation, sigma) = (fit.deviation(), sigma_of(fit, assumed));
    if deviation.is_finite() {
        let own = deviation.clamp(RANGE.0 * sigma, RANGE.1 * sigma);
        weights.set(sensor_of(fit), own);
    }
}

fn sensor_of(fit: &SensorFit) -> Sensor {
    match fit.sensor {
        "tension" => Sensor::Tension,
        "swivel" => Sensor::Swivel,
        "position" => Sensor::Position,
        "rotation" => Sensor::Rotation,
        _ => Sensor::Length,
    }
}

fn sigma_of(fit: &SensorFit, weights: &Weights) -> f64 {
    weights.sigma(sensor_of(fit)).unwrap_or(1.0)
}
