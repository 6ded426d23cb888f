//! Entry of a controller in the table of all: its word, its keys, and its constructor from a scenario.

use crate::controller::Controller;
use crate::error::{PlantError, ScenarioKey};
use crate::keys::{Kind, Stated};
use crate::state::PlantState;
use crate::{Plant, Winches};

/// Controller that a scenario can select.
pub(super) struct ControllerEntry {
    /// Word of `kind`, meaning and keys in the table `[control]`.
    pub(super) kind: Kind,
    /// Winches that the controller can drive.
    pub(super) winches: &'static [Winches],
    pub(super) make: fn(&ControlSetting<'_>) -> Result<Box<dyn Controller>, PlantError>,
}

/// Table `[control]` of a scenario.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    /// Word of the controller.
    pub kind: &'static str,
    /// Values of the controller's keys.
    pub(crate) stated: Stated,
}

/// Inputs for the construction of a controller.
pub(crate) struct ControlSetting<'a> {
    /// Machine that the controller drives.
    pub(crate) plant: &'a Plant,
    /// Machine at rest, before it is displaced.
    pub(crate) state: &'a PlantState,
    /// Values of the controller's keys.
    pub(crate) stated: &'a Stated,
}

impl ControlSetting<'_> {
    /// An error at a key of the table.
    pub(super) fn refused(&self, key: &'static str, message: String) -> PlantError {
        PlantError::Value { key: ScenarioKey::of("control", key), message }
    }
}
