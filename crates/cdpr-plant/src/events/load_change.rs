//! The platform takes up a mass, or loses one.

use std::sync::Arc;

use nalgebra::Vector3;

use super::entry::{EventEntry, EventSetting};
use super::happening::{Happening, LoadChange};
use crate::error::PlantError;
use crate::keys::{Key, Kind, Shape, Word};
use crate::momentum::Inertia;
use crate::plant::Plant;
use crate::state::PlantState;
use cdpr_model::robot::Body;

const WORD: Word = Word::new("load", "The platform takes up a mass, or loses one.");

pub(super) const LOAD: EventEntry = EventEntry {
    kind: Kind {
        word: WORD,
        keys: &[
            Key::needed(
                "mass_kg",
                Shape::Number,
                "mass that is fixed to the platform (kg), negative where it is taken off.",
            ),
            Key::optional(
                "position_m",
                Shape::Numbers,
                "its place (platform frame, m); the platform origin when missing.",
            ),
        ],
    },
    make,
};

fn make(setting: &EventSetting<'_>) -> Result<Arc<dyn Happening>, PlantError> {
    let axes = setting.plant.model().axes();
    let place = setting.stated.numbers("position_m").map_or_else(|| vec![0.0; axes.len()], <[f64]>::to_vec);
    if place.len() != axes.len() || place.iter().any(|x| !x.is_finite()) {
        return Err(setting.refused("position_m", format!("position_m has {} finite numbers", axes.len())));
    }
    let place = axes.iter().zip(&place).map(|(axis, along)| axis * *along).sum();
    Ok(Arc::new(LoadChange { mass: setting.stated.number_or_zero("mass_kg"), place }))
}

impl Happening for LoadChange {
    fn kind(&self) -> &'static str {
        WORD.name
    }

    fn apply(&self, plant: &Plant, state: &mut PlantState) {
        let Some(body) = state.inertia.body.with_point_mass(self.mass, &self.place) else { return };
        let twist = state.twist();
        state.inertia = Inertia::new(plant.model(), held(plant, body));
        state.added.mass += self.mass;
        state.added.moment += self.place * self.mass;
        state.set_twist(&twist);
    }

    fn words(&self, _cable: &str, number: &dyn Fn(f64, i32) -> String) -> String {
        match self.mass < 0.0 {
            true => format!("{} kg are taken off", number(-self.mass, 4)),
            false => format!("{} kg are taken up", number(self.mass, 4)),
        }
    }

    fn load_change(&self) -> Option<&LoadChange> {
        Some(self)
    }
}

/// The body in the motion pattern: a point if the pattern has no rotation.
fn held(plant: &Plant, body: Body) -> Body {
    match plant.model().robot().motion_pattern.has_rotation() {
        true => body,
        false => Body { center_of_mass: Vector3::zeros(), inertia: nalgebra::Matrix3::zeros(), ..body },
    }
}
