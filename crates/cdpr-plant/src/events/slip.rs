//! A cable slips.

use std::sync::Arc;

use super::entry::{CABLE, EventEntry};
use super::happening::Happening;
use crate::keys::{Key, Kind, Shape, Word};
use crate::plant::Plant;
use crate::state::PlantState;

const WORD: Word = Word::new("slip", "A cable slips through what holds it.");

pub(super) const SLIP: EventEntry = EventEntry {
    kind: Kind {
        word: WORD,
        keys: &[CABLE, Key::needed("length_m", Shape::Number, "length that the cable gains (m).")],
    },
    make: |setting| Ok(Arc::new(Slip { cable: setting.cable()?, length: setting.stated.number_or_zero("length_m") })),
};

/// A cable slips through its holder, so that its unstrained length changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip {
    /// Cable (0-based).
    pub cable: usize,
    /// Length (m), positive if the cable becomes longer.
    pub length: f64,
}

impl Happening for Slip {
    fn kind(&self) -> &'static str {
        WORD.name
    }

    fn apply(&self, _plant: &Plant, state: &mut PlantState) {
        state.cables[self.cable].slip += self.length;
    }

    fn words(&self, cable: &str, number: &dyn Fn(f64, i32) -> String) -> String {
        format!("{cable} slips by {} mm", number(1e3 * self.length, 3))
    }

    fn cable(&self) -> Option<usize> {
        Some(self.cable)
    }
}
