//! Winches of a robot.

use super::ModelError;
use crate::cable::winch::{DrumError, Winch, missing_key};
use crate::robot::Robot;

/// The winches of a robot: drums, or ideal winches for cables with a known radius.
pub(super) fn winches_of(robot: &Robot, with_drums: bool) -> Result<Vec<Option<Winch>>, ModelError> {
    let refused = |index: usize, reason: DrumError| ModelError::Drum {
        cable: index + 1,
        name: robot.cables[index].name.clone(),
        reason,
    };
    let winch = |(index, cable)| {
        if !with_drums {
            return Ok(Winch::ideal(cable).and_then(Result::ok));
        }
        if let Some(key) = missing_key(cable) {
            let hint = if cable.winch.guided == Some(true) {
                ""
            } else {
                ", or set drum_guided = true for a drum whose guide travels with the contact point"
            };
            let hint = if matches!(key, "drum_axis" | "drum_position_m") { hint } else { "" };
            let name = cable.name.clone();
            return Err(ModelError::MissingKey { effect: "drum", key, cable: index + 1, name, hint });
        }
        Winch::of(cable).transpose().map_err(|reason| refused(index, reason))
    };
    robot.cables.iter().enumerate().map(winch).collect()
}
