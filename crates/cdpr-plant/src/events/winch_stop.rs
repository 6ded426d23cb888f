//! A winch stands still.

use std::sync::Arc;

use super::entry::{CABLE, EventEntry};
use super::happening::Happening;
use crate::keys::{Kind, Word};
use crate::plant::Plant;
use crate::state::PlantState;

const WORD: Word = Word::new("winch-stop", "A winch stands still from then on, under any command.");

pub(super) const WINCH_STOP: EventEntry = EventEntry {
    kind: Kind { word: WORD, keys: &[CABLE] },
    make: |setting| Ok(Arc::new(WinchStop { cable: setting.cable()? })),
};

/// A winch stands still from then on, under any command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct WinchStop {
    /// Cable (0-based).
    pub cable: usize,
}

impl Happening for WinchStop {
    fn kind(&self) -> &'static str {
        WORD.name
    }

    fn apply(&self, _plant: &Plant, state: &mut PlantState) {
        let cable = &mut state.cables[self.cable];
        (cable.is_stopped, cable.controlled_length_rate, cable.drum_speed) = (true, 0.0, 0.0);
    }

    fn words(&self, cable: &str, _number: &dyn Fn(f64, i32) -> String) -> String {
        format!("the winch of {cable} stands still")
    }

    fn cable(&self) -> Option<usize> {
        Some(self.cable)
    }
}
