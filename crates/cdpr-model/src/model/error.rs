//! Reasons that a robot has no model with the requested effects.

use thiserror::Error;

use crate::cable::winch::DrumError;
use crate::robot::{Cable, StretchError};

/// A robot that has no model with the requested effects.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ModelError {
    /// An effect needs a key that the file lacks.
    #[error(
        "the effect `{effect}` needs `{key}`, which cable {cable} (\"{name}\") does not have; add the key to its [[cable]] table{hint}"
    )]
    MissingKey {
        /// The effect.
        effect: &'static str,
        /// The key of the robot file.
        key: &'static str,
        /// Number of the cable, from 1.
        cable: usize,
        /// Name of the cable.
        name: String,
        /// Advice on how to add the key.
        hint: &'static str,
    },
    /// Invalid numbers of a law of stretch.
    #[error("cable {cable} (\"{name}\"): {reason}")]
    Stretch {
        /// Number of the cable, from 1.
        cable: usize,
        /// Name of the cable.
        name: String,
        /// Reason that the numbers make no law.
        reason: StretchError,
    },
    /// Cables with weight, but an unknown gravity.
    #[error(
        "cables of \"{robot}\" sag by their weight, but its file lacks `gravity_m_s2`; add it, e.g. gravity_m_s2 = [0.0, 0.0, -9.81]"
    )]
    NoGravity {
        /// Name of the robot.
        robot: String,
    },
    /// Numbers of a drum that contradict each other or are out of range.
    #[error("cable {cable} (\"{name}\"): {reason}")]
    Drum {
        /// Number of the cable, from 1.
        cable: usize,
        /// Name of the cable.
        name: String,
        /// Reason that the numbers make no drum.
        reason: DrumError,
    },
    /// A pulley that does not swivel, on a robot with spatial motion.
    #[error(
        "cable {cable} (\"{name}\") has `pulley_wrap_side`, but the robot is spatial: its platform would leave the plane of a pulley \
         that does not swivel; leave the key out"
    )]
    SpatialWrapSide {
        /// Number of the cable, from 1.
        cable: usize,
        /// Name of the cable.
        name: String,
    },
    /// A robot without cables.
    #[error("robot \"{robot}\" has no cables")]
    NoCables {
        /// Name of the robot.
        robot: String,
    },
}

/// A key that an effect needs in every cable of a file.
#[derive(Clone, Copy)]
pub(super) struct Need {
    pub(super) effect: &'static str,
    pub(super) key: &'static str,
    /// Further words about the key in the error.
    pub(super) hint: &'static str,
}

pub(super) fn require(
    present: bool,
    Need { effect, key, hint }: Need,
    index: usize,
    cable: &Cable,
) -> Result<(), ModelError> {
    let name = cable.name.clone();
    if present { Ok(()) } else { Err(ModelError::MissingKey { effect, key, cable: index + 1, name, hint }) }
}
