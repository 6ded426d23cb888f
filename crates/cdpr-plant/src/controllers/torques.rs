//! Motors that keep the torques of the start.

use super::entry::{ControlSetting, ControllerEntry};
use crate::command::Command;
use crate::controller::{Controller, Measured, Setpoint};
use crate::error::{ControlError, PlantError};
use crate::keys::{Kind, Word};
use crate::plant::Winches;

pub(super) const TORQUES: ControllerEntry = ControllerEntry {
    kind: Kind { word: Word::new("torques", "Motors of drums hold the torques of the start."), keys: &[] },
    winches: &[Winches::Drums],
    make,
};

fn make(setting: &ControlSetting<'_>) -> Result<Box<dyn Controller>, PlantError> {
    Ok(Box::new(Torques(Command::torques(&setting.plant.holding_torques(setting.state)?))))
}

/// Controller of constant torques.
#[derive(Clone, Debug)]
struct Torques(Vec<Command>);

impl Controller for Torques {
    fn command(
        &mut self,
        _time: f64,
        _wanted: &Setpoint,
        _measured: &Measured<'_>,
        out: &mut [Command],
    ) -> Result<(), ControlError> {
        out.copy_from_slice(&self.0);
        Ok(())
    }

    fn period(&self) -> Option<f64> {
        None
    }

    fn reset(&mut self) {}

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }

    fn bends(&self) -> Option<&[f64]> {
        Some(&[])
    }
}
