//! Codes of what sweeps refuse.

use super::ErrorCode;
use crate::metamodel::sweep::{KeyError, KeyReason, PointError, ValuesError, ValuesReason};

impl ErrorCode for KeyError {
    fn code(&self) -> &'static str {
        match self {
            Self::Place { .. } | Self::Entry { .. } | Self::Nowhere { .. } => "sweep::value",
        }
    }
}

impl ErrorCode for PointError {
    fn code(&self) -> &'static str {
        match self {
            Self::Key(error) => error.code(),
            Self::Read(error) => error.code,
            Self::Input(error) => error.code(),
            Self::Workspace(error) => error.code(),
            Self::Pulleys(error) => error.code(),
            Self::SwivelAxis | Self::NoDirection | Self::NoSwivelAxis { .. } => "pulley::radius-or-axis",
        }
    }
}

impl ErrorCode for ValuesError {
    fn code(&self) -> &'static str {
        self.reason.code()
    }
}

impl ErrorCode for ValuesReason {
    fn code(&self) -> &'static str {
        "sweep::value"
    }
}

impl ErrorCode for KeyReason {
    fn code(&self) -> &'static str {
        "sweep::value"
    }
}
