//! Encoders of the winches: recorded lengths in whole counts, some of which may be lost.

use super::entry::{Seen, Sensor, SensorEntry, SensorSetting, refused};
use super::record::cable_columns;
use super::signal::counted;
use crate::error::PlantError;
use crate::keys::{Key, Shape};
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Model;

const TABLE: &str = "sensors.encoders";

pub(super) const ENCODERS: SensorEntry = SensorEntry {
    table: TABLE,
    summary: "Encoders of the winches: recorded lengths.",
    file: "measurements.csv",
    keys: &[
        Key::with_default(
            "resolution_m",
            0.0,
            Shape::NotNegative,
            "Length of cable that a count stands for (m); 0 for encoders that resolve everything.",
        ),
        Key::optional("loss", Shape::Tables(LOSS), "Counts that get lost at a time."),
    ],
    make,
};

const LOSS: &[Key] = &[
    Key::needed("time_s", Shape::Number, "Time since the start (s)."),
    Key::needed("cable", Shape::Cable, "Number of the cable, from 1."),
    Key::needed("length_m", Shape::Number, "Length by which the record is too short from then on (m)."),
];

/// Counts that an encoder loses at a time.
#[derive(Clone, Copy, Debug)]
struct Loss {
    time: f64,
    /// Cable (0-based).
    cable: usize,
    length: f64,
}

#[derive(Clone, Debug)]
struct Encoders {
    resolution: f64,
    losses: Vec<Loss>,
}

fn make(setting: &SensorSetting<'_>) -> Result<Box<dyn Sensor>, PlantError> {
    let cables = setting.model.cable_count();
    let mut losses = Vec::new();
    for loss in setting.stated.tables("loss") {
        let number = loss.whole("cable").unwrap_or(0);
        let cable = usize::try_from(number).ok().filter(|cable| (1..=cables).contains(cable));
        let Some(cable) = cable else {
            let message = format!("cable {number} does not exist: cables count from 1 to {cables}");
            return Err(refused(TABLE, "loss", message));
        };
        let [time, length] = ["time_s", "length_m"].map(|key| loss.number_or_zero(key));
        losses.push(Loss { time, cable: cable - 1, length });
    }
    Ok(Box::new(Encoders { resolution: setting.stated.number_or_zero("resolution_m"), losses }))
}

impl Sensor for Encoders {
    fn columns(&self, model: &Model) -> Vec<String> {
        cable_columns("cable_length_m", model)
    }

    fn read(&mut self, seen: &Seen<'_>) -> Option<Vec<f64>> {
        let lost = |cable: usize| -> f64 {
            let lost = self.losses.iter().filter(|loss| loss.cable == cable && loss.time < seen.state.time);
            lost.map(|loss| loss.length).sum()
        };
        let length = |(index, cable): (usize, &crate::CableMotion)| {
            let recorded = seen.plant.model().recorded_length(index, cable.controlled_length);
            counted(recorded, self.resolution) - lost(index)
        };
        Some(seen.state.cables.iter().enumerate().map(length).collect())
    }

    fn add_accuracies(&self, sigmas: &mut SensorSigmas) {
        // within one count all lengths are equally probable
        sigmas.length = Some(self.resolution / 12f64.sqrt());
    }

    fn boxed_clone(&self) -> Box<dyn Sensor> {
        Box::new(self.clone())
    }
}
