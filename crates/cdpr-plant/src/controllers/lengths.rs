//! Winches that follow the setpoint lengths: those of the start in a scenario without a trajectory.

use super::entry::ControllerEntry;
use crate::command::Command;
use crate::controller::{Controller, Measured, Setpoint};
use crate::error::ControlError;
use crate::keys::{Kind, Word};
use crate::plant::Winches;

pub(super) const LENGTHS: ControllerEntry = ControllerEntry {
    kind: Kind { word: Word::new("lengths", "Winches hold the lengths of the start; drums are braked."), keys: &[] },
    winches: &[Winches::Ideal, Winches::Drums],
    make: |_| Ok(Box::new(Lengths)),
};

/// Controller that commands the setpoint lengths.
#[derive(Clone, Copy, Debug)]
struct Lengths;

impl Controller for Lengths {
    fn command(
        &mut self,
        _time: f64,
        wanted: &Setpoint,
        _measured: &Measured<'_>,
        out: &mut [Command],
    ) -> Result<(), ControlError> {
        out.iter_mut().zip(&wanted.lengths).for_each(|(command, length)| *command = Command::Length(*length));
        Ok(())
    }

    fn period(&self) -> Option<f64> {
        None
    }

    fn reset(&mut self) {}

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(*self)
    }

    fn bends(&self) -> Option<&[f64]> {
        Some(&[])
    }
}
