//! A wrench begins to act.

use std::sync::Arc;

use super::entry::EventEntry;
use super::happening::Happening;
use crate::keys::{Key, Kind, Shape, Word};
use crate::plant::Plant;
use crate::state::PlantState;
use cdpr_model::geometry::Wrench;

const WORD: Word = Word::new("wrench", "A wrench begins to act, in place of that of an earlier event.");

pub(super) const WRENCH: EventEntry = EventEntry {
    kind: Kind {
        word: WORD,
        keys: &[Key::needed(
            "wrench",
            Shape::Numbers,
            "components in the degrees of freedom (N, N·m), from then on besides load and weight.",
        )],
    },
    make: |setting| Ok(Arc::new(WrenchChange(setting.components("wrench")?))),
};

/// A wrench acts in addition to load and weight and replaces that of an earlier event (world axes, moment about the
/// platform origin; N, N·m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrenchChange(pub Wrench);

impl Happening for WrenchChange {
    fn kind(&self) -> &'static str {
        WORD.name
    }

    fn apply(&self, _plant: &Plant, state: &mut PlantState) {
        state.external = self.0;
    }

    fn words(&self, _cable: &str, number: &dyn Fn(f64, i32) -> String) -> String {
        let [force, moment] = [0, 3].map(|from| number(self.0.fixed_rows::<3>(from).norm(), 4));
        format!("a wrench acts: force {force} N, moment {moment} N·m")
    }
}
