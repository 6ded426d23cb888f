//! Tables of robot files that state parameters, and the ranges of their values.

#[cfg(feature = "files")]
use crate::reading::MAGNITUDE_LIMIT;

/// Owner of a parameter: its table in the robot file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Owner {
    /// Each `[[cable]]`.
    Cable,
    /// `[platform]`.
    Platform,
    /// `[external_wrench]`.
    ExternalWrench,
    /// The keys above the first table.
    Robot,
    /// No table: numbers of a recording.
    Recording,
}

/// Range of the values that a robot file may state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Range {
    /// Any number.
    Real,
    /// Zero or more.
    NotNegative,
    /// Above zero.
    Positive,
    /// Any number but zero.
    NotZero,
}

impl Range {
    /// True for a value that a robot file may state.
    #[cfg(feature = "files")]
    pub(crate) fn contains(self, value: f64) -> bool {
        // NaN and infinities fail the first comparison
        value.abs() <= MAGNITUDE_LIMIT
            && match self {
                Self::Real => true,
                Self::NotNegative => value >= 0.0,
                Self::Positive => value >= 1.0 / MAGNITUDE_LIMIT,
                Self::NotZero => value != 0.0,
            }
    }
}
