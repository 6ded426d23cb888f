//! Input that the statics of a robot cannot use.

use thiserror::Error;

use crate::cable::{CableStateError, GeometryError};
use crate::model::Model;

/// Tensions that no cable can have, or a pose at which a cable has no path.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum StaticsError {
    /// Another number of tensions than cables.
    #[error("expected {expected} cable tensions, one per cable, found {found}")]
    TensionCount {
        /// Number of cables.
        expected: usize,
        /// Number of tensions.
        found: usize,
    },
    /// A tension that is NaN or infinite.
    #[error("cable {cable}: the tension is {value}; a tension is a finite number (N)")]
    NotFinite {
        /// Number of the cable, from 1.
        cable: usize,
        /// Value given (N).
        value: f64,
    },
    /// A tension with which the cable would push.
    #[error("cable {cable}: a tension of {value} N would push, which a cable cannot; pull is positive, slack is 0")]
    Negative {
        /// Number of the cable, from 1.
        cable: usize,
        /// Value given (N).
        value: f64,
    },
    /// A tension that would stretch the cable by its whole length.
    #[error(
        "cable {cable}: a tension of {tension} N would stretch it by its whole length of {length} m; check the units of tension (N) and stiffness (axial_stiffness_EA_N in N)"
    )]
    Overstretched {
        /// Number of the cable, from 1.
        cable: usize,
        /// Tension (N).
        tension: f64,
        /// Geometric length (m).
        length: f64,
    },
    /// The stiffness of a cable that does not stretch was requested.
    #[error("cable {cable} does not stretch, so its stiffness is infinite; {cure}")]
    Rigid {
        /// Number of the cable, from 1.
        cable: usize,
        /// Change of the robot or model that gives a finite stiffness.
        cure: String,
    },
    /// A cable that has no state with its tension.
    #[error("cable {cable}: {reason}")]
    CableState {
        /// Number of the cable, from 1.
        cable: usize,
        /// Reason that the cable has no state.
        reason: CableStateError,
    },
    /// A cable group names a cable that the robot does not have.
    #[error("the group names cable {cable}, but the robot has the cables 1 to {count}")]
    UnknownCable {
        /// Number of the cable, from 1.
        cable: usize,
        /// Number of cables.
        count: usize,
    },
    /// A cable group names a cable twice.
    #[error("the group names cable {cable} twice")]
    RepeatedCable {
        /// Number of the cable, from 1.
        cable: usize,
    },
    /// A cable has no unique path at the pose.
    #[error(transparent)]
    CablePath(#[from] GeometryError),
}

impl StaticsError {
    /// The error for one cable (0-based) of a geometric length (m) that has no state.
    #[cold]
    #[inline(never)]
    pub fn of_cable(index: usize, length: f64, reason: CableStateError) -> Self {
        let cable = index + 1;
        match reason {
            CableStateError::Overstretched { tension } => Self::Overstretched { cable, tension, length },
            reason => Self::CableState { cable, reason },
        }
    }
}

/// Checks that there is one finite tension of zero or more per cable; otherwise the error names the cable.
pub fn check_tensions(model: &Model, tensions: &[f64]) -> Result<(), StaticsError> {
    let (expected, found) = (model.cable_count(), tensions.len());
    if expected != found {
        return Err(StaticsError::TensionCount { expected, found });
    }
    for (index, &value) in tensions.iter().enumerate() {
        let cable = index + 1;
        if !value.is_finite() {
            return Err(StaticsError::NotFinite { cable, value });
        }
        if value < 0.0 {
            return Err(StaticsError::Negative { cable, value });
        }
    }
    Ok(())
}
