//! Quantities that a file is read for, and the columns that give them.

use std::collections::BTreeMap;

use crate::measurement::columns::Quantity;

/// Columns of a file by quantity: their index and factor to SI.
pub(super) type Columns = BTreeMap<Quantity, (usize, f64)>;

/// Quantities that a file is read for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    /// Poses with lengths or motor angles, and what else there is.
    Samples,
    /// As samples, but the poses come from another file, by time.
    Log,
    /// Poses with their times; all else is ignored.
    Track,
    /// Poses alone.
    Poses,
    /// Lengths or their changes; components of poses where a row has them.
    Internal,
}

impl Content {
    /// Whether a column of this quantity is read.
    pub(super) fn takes(self, quantity: Quantity) -> bool {
        match self {
            Self::Internal => true,
            Self::Samples => !quantity.is_internal(),
            Self::Log => !quantity.is_of_pose() && !quantity.is_internal(),
            Self::Track => quantity.is_of_pose() || quantity == Quantity::Time,
            Self::Poses => quantity.is_of_pose(),
        }
    }

    /// Whether poses are read.
    pub(super) fn has_poses(self) -> bool {
        !matches!(self, Self::Log | Self::Internal)
    }

    /// Whether lengths or motor angles are read.
    pub(super) fn has_cables(self) -> bool {
        matches!(self, Self::Samples | Self::Log | Self::Internal)
    }

    /// Whether a name map speaks of two files, of which this is one.
    pub(super) fn is_one_of_two(self) -> bool {
        matches!(self, Self::Log | Self::Track)
    }
}

/// True for a file that gives motor angles in place of lengths.
pub(super) fn by_angle(columns: &Columns) -> bool {
    let has = |wanted: fn(&Quantity) -> bool| columns.keys().any(wanted);
    has(|quantity| matches!(quantity, Quantity::MotorAngle(_)))
        && !has(|quantity| matches!(quantity, Quantity::Length(_)))
}
