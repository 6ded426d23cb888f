//! Winches that follow a table of changes of the setpoint lengths over time.

use super::entry::{ControlSetting, ControllerEntry};
use crate::command::Command;
use crate::controller::{Controller, Measured, Setpoint};
use crate::error::{ControlError, PlantError};
use crate::keys::{Key, Kind, Shape, Word};
use crate::plant::Winches;
use crate::series::Series;

const ROWS: &str = "length_change_m";

pub(super) const LENGTH_CHANGES: ControllerEntry = ControllerEntry {
    kind: Kind {
        word: Word::new("length-changes", "Ideal winches follow changes of length over time."),
        keys: &[
            Key::needed("time_s", Shape::Numbers, "Times of the rows (s), ascending."),
            Key::needed(
                ROWS,
                Shape::Rows,
                "Rows with a number per cable, added to the lengths of the start (m), straight between the rows.",
            ),
        ],
    },
    winches: &[Winches::Ideal],
    make,
};

fn make(setting: &ControlSetting<'_>) -> Result<Box<dyn Controller>, PlantError> {
    let times = setting.stated.numbers("time_s").unwrap_or_default();
    let rows = setting.stated.rows(ROWS).unwrap_or_default();
    Series::check(times, rows.len(), ROWS)
        .map_err(|mistake| setting.refused(if mistake.is_in_times { "time_s" } else { ROWS }, mistake.message))?;
    let cables = setting.state.cables.len();
    if rows.iter().any(|row| row.len() != cables || row.iter().any(|x| !x.is_finite())) {
        let message = format!("a row of {ROWS} has a finite number for each of the {cables} cables");
        return Err(setting.refused(ROWS, message));
    }
    let changes = Series { times: times.to_vec(), rows: rows.to_vec() };
    Ok(Box::new(LengthChanges { changes, now: vec![0.0; cables] }))
}

/// Controller that adds a table of changes to the setpoint lengths.
#[derive(Clone, Debug)]
struct LengthChanges {
    changes: Series,
    /// Row of the table at the current time (m).
    now: Vec<f64>,
}

impl Controller for LengthChanges {
    fn command(
        &mut self,
        time: f64,
        wanted: &Setpoint,
        _measured: &Measured<'_>,
        out: &mut [Command],
    ) -> Result<(), ControlError> {
        self.changes.at(time, &mut self.now);
        for (command, (change, start)) in out.iter_mut().zip(self.now.iter().zip(&wanted.lengths)) {
            *command = Command::Length(change + start);
        }
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
        Some(&self.changes.times)
    }
}
