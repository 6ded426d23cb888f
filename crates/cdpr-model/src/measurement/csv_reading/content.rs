//! Quantities that are read from a file, and their columns.

use std::collections::BTreeMap;

use crate::measurement::columns::Quantity;

/// Columns of a file by quantity: their index and factor to SI.
pub(super) type Columns = BTreeMap<Quantity, (usize, f64)>;

/// Quantities that are read from a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Content {
    /// Poses with lengths or motor angles, and all other quantities of samples.
    Samples,
    /// As `Samples`, but the poses come from another file, by time.
    Log,
    /// Poses with their times; all other columns are ignored.
    Track,
    /// Poses alone.
    Poses,
    /// Lengths or their changes, with the components of poses that a row has.
    Internal,
}

impl Content {
    /// True if a column of this quantity is read.
    pub(super) fn takes(self, quantity: Quantity) -> bool {
        match self {
            Self::Internal => true,
            Self::Samples => !quantity.is_internal(),
            Self::Log => !quantity.is_of_pose() && !quantity.is_internal(),
            Self::Track => quantity.is_of_pose() || quantity == Quantity::Time,
            Self::Poses => quantity.is_of_pose(),
        }
    }

    /// True if poses are read.
    pub(super) fn has_poses(self) -> bool {
        !matches!(self, Self::Log | Self::Internal)
    }

    /// True if lengths or motor angles are read.
    pub(super) fn has_cables(self) -> bool {
        matches!(self, Self::Samples | Self::Log | Self::Internal)
    }

    /// True if a name map is for two files, of which this is one.
    pub(super) fn is_one_of_two(self) -> bool {
        matches!(self, Self::Log | Self::Track)
    }
}

/// True for a file with motor angles instead of lengths.
pub(super) fn by_angle(columns: &Columns) -> bool {
    let has = |wanted: fn(&Quantity) -> bool| columns.keys().any(wanted);
    has(|quantity| matches!(quantity, Quantity::MotorAngle(_)))
        && !has(|quantity| matches!(quantity, Quantity::Length(_)))
}
