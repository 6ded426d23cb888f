//! Load pins at the outlets: recorded tensions after an amplifier, with noise and bias.

use super::entry::{Seen, Sensor, SensorEntry, SensorSetting, refused};
use super::record::cable_columns;
use super::signal::{LowPass, Noise};
use crate::error::PlantError;
use crate::keys::{Key, Shape};
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Model;

const TABLE: &str = "sensors.load_pins";

/// Index of the random stream.
const STREAM: u64 = 1;

pub(super) const LOAD_PINS: SensorEntry = SensorEntry {
    table: TABLE,
    summary: "Load pins: recorded tensions.",
    file: "measurements.csv",
    keys: &[
        Key::with_default("noise_N", 0.0, Shape::NotNegative, "Standard deviation of the noise (N)."),
        Key::optional("bias_N", Shape::Numbers, "Bias of each pin (N); none when missing."),
        Key::optional(
            "bandwidth_Hz",
            Shape::NotNegative,
            "Cut-off of the amplifier's low-pass of first order (Hz); none when missing.",
        ),
        Key::optional(
            "range_N",
            Shape::NotNegative,
            "Largest tension that a pin shows (N), none below zero; no limits when missing.",
        ),
    ],
    make,
};

#[derive(Clone, Debug)]
struct LoadPins {
    sigma: f64,
    bias: Vec<f64>,
    range: Option<f64>,
    filters: Vec<LowPass>,
    noise: Noise,
    /// Time of the last update (s).
    last: f64,
}

fn make(setting: &SensorSetting<'_>) -> Result<Box<dyn Sensor>, PlantError> {
    let (stated, cables) = (setting.stated, setting.model.cable_count());
    let bias = stated.numbers("bias_N").map_or_else(|| vec![0.0; cables], <[f64]>::to_vec);
    if bias.len() != cables {
        let message = format!("bias_N has {} numbers; the robot has {cables} cables", bias.len());
        return Err(refused(TABLE, "bias_N", message));
    }
    Ok(Box::new(LoadPins {
        sigma: stated.number_or_zero("noise_N"),
        bias,
        range: stated.number("range_N"),
        filters: vec![LowPass::new(stated.number("bandwidth_Hz")); cables],
        noise: Noise::new(setting.seed, STREAM),
        last: 0.0,
    }))
}

impl Sensor for LoadPins {
    fn columns(&self, model: &Model) -> Vec<String> {
        cable_columns("tension_N", model)
    }

    fn follow(&mut self, seen: &Seen<'_>) {
        let time = seen.state.time - self.last;
        self.last = seen.state.time;
        self.filters.iter_mut().zip(&seen.state.cables).for_each(|(filter, cable)| filter.pass(cable.tension, time));
    }

    fn read(&mut self, seen: &Seen<'_>) -> Option<Vec<f64>> {
        let Self { sigma, bias, range, filters, noise, .. } = self;
        let shown = |(index, filter): (usize, &LowPass)| {
            let recorded = seen.plant.model().recorded_tension(index, filter.output());
            let shown = recorded + bias[index] + noise.of(*sigma);
            range.map_or(shown, |range| shown.clamp(0.0, range))
        };
        Some(filters.iter().enumerate().map(shown).collect())
    }

    fn add_accuracies(&self, sigmas: &mut SensorSigmas) {
        sigmas.tension = Some(self.sigma);
    }

    fn boxed_clone(&self) -> Box<dyn Sensor> {
        Box::new(self.clone())
    }
}
