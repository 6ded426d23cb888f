//! Calibrations compared by a sweep: sensors, numbers of poses, models, and their prices.

use serde::{Deserialize, Serialize};
use thiserror::Error;

use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Composition;

/// Calibrations of a study's machine (sec. 7.2): every sensor with every model and every number of poses.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CalibrationTable {
    /// Numbers of poses to measure, taken at random among those of the study.
    pub poses: Vec<usize>,
    /// Records of each, by seeds of their own; errors are means over them; 3 when missing.
    #[serde(default = "records")]
    #[schemars(range(min = 1, max = 100))]
    pub records: u32,
    /// Required mean position errors of driven poses (m): the answer names the cheapest calibration that reaches
    /// each.
    #[serde(default)]
    pub accuracy_m: Vec<f64>,
    /// Price of measuring one pose, in the unit of the sensors' prices; 1 when missing.
    #[serde(default = "one")]
    pub price_per_pose: f64,
    /// Sensors of the platform's pose.
    pub sensor: Vec<PoseSensor>,
    /// Control models.
    pub model: Vec<CalibratedModel>,
}

/// Sensor of the platform's pose; lengths and tensions are recorded as the study's `[noise]` says.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PoseSensor {
    /// Name.
    pub name: String,
    /// Standard deviation of the position per axis (m); without it poses are not measured and the robot calibrates itself by lengths.
    pub position_m: Option<f64>,
    /// Standard deviation of the orientation per axis (rad); as exact as the position at the platform's anchors when missing.
    pub rotation_rad: Option<f64>,
    /// Price of having it; 0 when missing.
    #[serde(default)]
    pub price: f64,
}

/// Control model to calibrate.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CalibratedModel {
    /// Composition, with the numbers of the study's `[control]` robot.
    pub model: String,
    /// Free parameters, by the names of `cdpr identify --free`.
    pub free: String,
    /// Ridges towards the file's values, e.g. `["platform-anchor=0.02"]`.
    #[serde(default)]
    pub prior: Vec<String>,
    /// Price of using the model, for example of load cells; 0 when missing.
    #[serde(default)]
    pub price: f64,
}

/// Outcome of one calibration: means over its records.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[expect(non_snake_case, reason = "the fields are the keys of the answer, units included")]
pub struct CalibrationOutcome {
    /// Free parameters.
    pub parameter_count: usize,
    /// Mean position error on another record by the same sensors (m); `None` if no poses are measured.
    pub validation_position_m: Option<f64>,
    /// Root mean square length error on that record (m).
    pub validation_length_m: f64,
    /// Mean position error with which the calibrated controller drives the machine, without noise (m); if poses are not
    /// measured, in the best-fitting frame, since no other is known.
    pub driven_position_m: f64,
    /// Largest position error (m).
    pub driven_position_max_m: f64,
    /// Mean rotation error (rad).
    pub driven_rotation_rad: f64,
    /// Mean over poses of the 2-norm of the tension errors (N); `None` for control models that command no tensions.
    pub driven_tension_N: Option<f64>,
}

/// Calibration of one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CalibrationPoint<'t> {
    /// Sensor of the pose.
    pub sensor: &'t PoseSensor,
    /// Control model.
    pub model: &'t CalibratedModel,
    /// Poses measured.
    pub poses: usize,
    /// Total price of sensor, model and poses.
    pub price: f64,
}

/// Error of a table of calibrations.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub(crate) enum TableError {
    /// A list without entries.
    #[error("`{list}` is empty: one at least is to be compared")]
    Empty {
        /// Key of the list.
        list: &'static str,
    },
    /// A number of poses that is 0.
    #[error("0 poses calibrate nothing")]
    NoPoses,
    /// A price, accuracy or deviation below zero, or NaN.
    #[error("`{key}` is a number of 0 or more")]
    Number {
        /// Key of the number.
        key: &'static str,
    },
    /// Words that name no composition.
    #[error("`{model}` is no composition: write `standard`, or effects joined by `+`")]
    Model {
        /// The words.
        model: String,
    },
}

fn records() -> u32 {
    3
}

fn one() -> f64 {
    1.0
}

impl CalibrationTable {
    pub(super) fn check(&self) -> Result<(), TableError> {
        let lists = [
            ("poses", self.poses.is_empty()),
            ("sensor", self.sensor.is_empty()),
            ("model", self.model.is_empty()),
            ("records", self.records == 0),
        ];
        if let Some((list, _)) = lists.into_iter().find(|(_, is_empty)| *is_empty) {
            return Err(TableError::Empty { list });
        }
        if self.poses.contains(&0) {
            return Err(TableError::NoPoses);
        }
        let sensors = self.sensor.iter().flat_map(|sensor| {
            let sigmas = [("position_m", sensor.position_m), ("rotation_rad", sensor.rotation_rad)];
            sigmas.into_iter().filter_map(|(key, value)| Some((key, value?))).chain([("price", sensor.price)])
        });
        let prices = self.model.iter().map(|model| ("price", model.price));
        let accuracies = self.accuracy_m.iter().map(|&accuracy| ("accuracy_m", accuracy));
        let all = sensors.chain(prices).chain(accuracies).chain([("price_per_pose", self.price_per_pose)]);
        if let Some((key, _)) = all.into_iter().find(|(_, value)| !(*value >= 0.0 && value.is_finite())) {
            return Err(TableError::Number { key });
        }
        match self.model.iter().find(|model| model.model.parse::<Composition>().is_err()) {
            Some(wrong) => Err(TableError::Model { model: wrong.model.clone() }),
            None => Ok(()),
        }
    }

    /// Points with these values of parameters, followed by the numbers of sensor, model and poses.
    pub(super) fn points(&self, values: &[f64]) -> Vec<Vec<f64>> {
        let mut points = Vec::new();
        for sensor in 1..=self.sensor.len() {
            for model in 1..=self.model.len() {
                let own = |&poses: &usize| [values, &[sensor as f64, model as f64, poses as f64]].concat();
                points.extend(self.poses.iter().map(own));
            }
        }
        points
    }

    /// Calibration of a point's values; `None` if they belong to no point.
    pub fn at(&self, values: &[f64]) -> Option<CalibrationPoint<'_>> {
        let [.., sensor, model, poses] = values else { return None };
        let number = |value: &f64| (*value as usize).checked_sub(1);
        let (sensor, model) = (self.sensor.get(number(sensor)?)?, self.model.get(number(model)?)?);
        let price = sensor.price + model.price + self.price_per_pose * poses;
        Some(CalibrationPoint { sensor, model, poses: *poses as usize, price })
    }
}

impl PoseSensor {
    /// Accuracies of all sensors, with those of lengths and tensions from the study; `None` if poses are not measured.
    /// `lever` is the distance of the platform's anchors (m).
    pub(crate) fn sigmas(&self, of_study: SensorSigmas, lever: f64) -> Option<SensorSigmas> {
        let position = self.position_m?;
        let rotation = Some(self.rotation_rad.unwrap_or(position / lever));
        Some(SensorSigmas { position: Some(position), rotation, ..of_study })
    }
}
