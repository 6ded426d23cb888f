//! A cable breaks.

use std::sync::Arc;

use super::entry::{CABLE, EventEntry};
use super::happening::Happening;
use crate::keys::{Kind, Word};
use crate::plant::Plant;
use crate::state::PlantState;

const WORD: Word = Word::new("cable-break", "A cable breaks.");

pub(super) const CABLE_BREAK: EventEntry = EventEntry {
    kind: Kind { word: WORD, keys: &[CABLE] },
    make: |setting| Ok(Arc::new(CableBreak { cable: setting.cable()? })),
};

/// A cable breaks: its tension is 0 afterwards.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CableBreak {
    /// Cable (0-based).
    pub cable: usize,
}

impl Happening for CableBreak {
    fn kind(&self) -> &'static str {
        WORD.name
    }

    fn apply(&self, _plant: &Plant, state: &mut PlantState) {
        state.cables[self.cable].is_broken = true;
        state.cables[self.cable].tension = 0.0;
    }

    fn words(&self, cable: &str, _number: &dyn Fn(f64, i32) -> String) -> String {
        format!("{cable} breaks")
    }

    fn cable(&self) -> Option<usize> {
        Some(self.cable)
    }

    fn takes_cable(&self) -> bool {
        true
    }
}
