//! Checks of sensors that need the robot or say what a number means.

use super::cables;
use super::table::SensorTable;
use crate::model::Model;
use crate::plant::error::{PlantError, ScenarioKey};

/// Refuses sensors that cannot be.
pub(super) fn check(table: &SensorTable, model: &Model) -> Result<(), PlantError> {
    let wrong = |name: &'static str, key: &'static str, message: String| {
        Err(PlantError::Value { key: ScenarioKey { table: name, index: None, key }, message })
    };
    let rates = [
        ("sensors", table.rate_Hz),
        ("sensors.tracker", table.tracker.map_or(1.0, |tracker| tracker.rate_Hz)),
        ("sensors.imu", table.imu.as_ref().map_or(1.0, |imu| imu.rate_Hz)),
    ];
    if let Some((name, rate)) = rates.into_iter().find(|(_, rate)| !(*rate > 0.0 && rate.is_finite())) {
        return wrong(name, "rate_Hz", format!("rate_Hz is {rate}; it is above 0"));
    }
    for (name, key, value) in not_negative(table) {
        if !(value >= 0.0 && value.is_finite()) {
            return wrong(name, key, format!("{key} is {value}; it is 0 or more"));
        }
    }
    let cables = model.cable_count();
    if let Some(bias) =
        table.load_pins.as_ref().and_then(|pins| pins.bias_N.as_ref()).filter(|bias| bias.len() != cables)
    {
        let message = format!("bias_N has {} numbers; the robot has {cables} cables", bias.len());
        return wrong("sensors.load_pins", "bias_N", message);
    }
    let losses = table.encoders.iter().flat_map(|encoders| &encoders.loss);
    if let Some(loss) = losses.into_iter().find(|loss| !(1..=cables).contains(&loss.cable)) {
        let message = format!("cable {} does not exist: cables count from 1 to {cables}", loss.cable);
        return wrong("sensors.encoders", "loss", message);
    }
    if table.swivels.is_some()
        && (0..cables).all(|cable| cables::swivel_angle(model, cable, &crate::geometry::Pose::identity()).is_none())
    {
        let message = "the model has no pulleys that swivel across gravity: take one with the effect `pulley`, and state `gravity_m_s2`".to_owned();
        return wrong("sensors", "swivels", message);
    }
    if table.inclinometer.is_some() && !model.robot().motion_pattern.has_rotation() {
        return wrong("sensors", "inclinometer", "the platform is a point and does not turn".to_owned());
    }
    Ok(())
}

/// Numbers of the tables that are 0 or more, with their keys.
fn not_negative(table: &SensorTable) -> Vec<(&'static str, &'static str, f64)> {
    let mut all = Vec::new();
    if let Some(encoders) = &table.encoders {
        all.push(("sensors.encoders", "resolution_m", encoders.resolution_m));
    }
    if let Some(pins) = &table.load_pins {
        all.push(("sensors.load_pins", "noise_N", pins.noise_N));
        all.push(("sensors.load_pins", "bandwidth_Hz", pins.bandwidth_Hz.unwrap_or(0.0)));
        all.push(("sensors.load_pins", "range_N", pins.range_N.unwrap_or(0.0)));
    }
    if let Some(swivels) = table.swivels {
        all.push(("sensors.swivels", "noise_rad", swivels.noise_rad));
        all.push(("sensors.swivels", "resolution_rad", swivels.resolution_rad));
    }
    if let Some(inclinometer) = table.inclinometer {
        all.push(("sensors.inclinometer", "noise_rad", inclinometer.noise_rad));
    }
    if let Some(tracker) = table.tracker {
        all.push(("sensors.tracker", "latency_s", tracker.latency_s));
        all.push(("sensors.tracker", "position_noise_m", tracker.position_noise_m));
        all.push(("sensors.tracker", "rotation_noise_rad", tracker.rotation_noise_rad));
        all.push(("sensors.tracker", "dropouts_per_s", tracker.dropouts_per_s));
        all.push(("sensors.tracker", "dropout_s", tracker.dropout_s));
    }
    if let Some(imu) = &table.imu {
        all.push(("sensors.imu", "acceleration_noise_m_s2", imu.acceleration_noise_m_s2));
        all.push(("sensors.imu", "gyro_noise_rad_s", imu.gyro_noise_rad_s));
    }
    all
}
