//! How well each sensor agrees with a calibrated robot, and accuracies that the residuals tell.

use super::internal::Sensing;
use super::question::Question;
use super::written::Written;
use crate::residual::sensors::Sensor;

/// Residuals of one sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct SensorFit {
    /// `length`, `tension`, `swivel`, `position` or `rotation`.
    pub sensor: &'static str,
    /// Unit of the deviations: m, N or rad.
    pub unit: &'static str,
    /// Root mean square of the residuals.
    pub rms: f64,
    /// Accuracy that weighs the rows, as a standard deviation.
    pub sigma: f64,
    /// True where the accuracy is stated; another one is found from the residuals.
    pub is_stated: bool,
    /// Its rows.
    pub rows: usize,
    /// Rows that neither poses nor parameters use up: what is left to judge it by.
    pub redundancy: f64,
}

impl SensorFit {
    /// Standard deviation that the residuals tell; not a number where nothing is left to judge by.
    pub(super) fn deviation(&self) -> f64 {
        let squares = self.rms * self.rms * self.rows as f64;
        if self.redundancy > LEAST_REDUNDANCY { (squares / self.redundancy).sqrt() } else { f64::NAN }
    }
}

/// Rows to judge a sensor by, at least.
const LEAST_REDUNDANCY: f64 = 2.0;

/// A stated accuracy that residuals exceed by this factor is doubted.
const DOUBTFUL: f64 = 3.0;

impl Question<'_> {
    /// Residuals sensor by sensor at an optimum, where there are several.
    pub(super) fn sensor_fits(&self, end: &Written) -> Vec<SensorFit> {
        let Sensing::All(layout, weights) = &self.sensing else { return Vec::new() };
        let leverages = end.all_leverages();
        let samples = end.poses.len();
        let stated = &self.internal.samples.sigmas;
        let told = |(sensor, name, unit): (Sensor, &'static str, &'static str)| {
            let sigma = weights.sigma(sensor)?;
            // parts of poses that are not measured have leverages and residuals of zero, and no derivative
            let is_row =
                |row: &usize| !matches!(sensor, Sensor::Position | Sensor::Rotation) || end.leverages[*row] > 0.0;
            let rows: Vec<usize> = layout.places(sensor, samples).filter(is_row).collect();
            let squares: f64 = rows.iter().map(|row| end.rows.residuals[*row].powi(2)).sum();
            let redundancy = rows.iter().map(|row| 1.0 - leverages[*row]).sum::<f64>().max(0.0);
            (!rows.is_empty()).then(|| SensorFit {
                sensor: name,
                unit,
                rms: sigma * (squares / rows.len() as f64).sqrt(),
                sigma,
                is_stated: sensor.is_stated(stated),
                rows: rows.len(),
                redundancy,
            })
        };
        SENSORS.into_iter().filter_map(told).collect()
    }

    /// True where every accuracy is stated that weighs a row.
    pub(super) fn are_stated(&self) -> bool {
        let stated = &self.internal.samples.sigmas;
        match &self.sensing {
            Sensing::Lengths(_) => Sensor::Length.is_stated(stated),
            Sensing::All(layout, _) => layout.are_stated(stated),
        }
    }
}

/// Name of the sensor of lengths.
pub(super) const LENGTH: &str = "length";

/// Sensors with their names and units.
pub(super) const SENSORS: [(Sensor, &str, &str); 5] = [
    (Sensor::Length, LENGTH, "m"),
    (Sensor::Tension, "tension", "N"),
    (Sensor::Swivel, "swivel", "rad"),
    (Sensor::Position, "position", "m"),
    (Sensor::Rotation, "rotation", "rad"),
];

/// Doubts about stated accuracies.
pub(super) fn warnings(sensors: &[SensorFit]) -> Vec<String> {
    let doubt = |fit: &SensorFit| {
        let factor = fit.deviation() / fit.sigma;
        (fit.is_stated && factor > DOUBTFUL).then(|| {
            format!(
                "{} residuals are {factor:.1} times what the stated accuracy lets expect ({:.3e} {}): a parameter that matters is not free, or the accuracy is not so good",
                fit.sensor, fit.sigma, fit.unit
            )
        })
    };
    sensors.iter().filter_map(doubt).collect()
}
