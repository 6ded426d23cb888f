//! Codes of the errors of workspaces.

use cdpr_model::reading::ErrorCode;

use crate::WorkspaceError;
use crate::criterion::registry::WantedError;
use crate::wrench_set::{PayloadError, WrenchSetError};

impl ErrorCode for WrenchSetError {
    fn code(&self) -> &'static str {
        match self {
            Self::TooManyCables { .. } => "robot::too-many-cables",
            Self::Rows { .. } => "wrench::component-count",
            Self::Count { .. } => "limits::count",
            Self::Number { .. } => "setting::value",
        }
    }
}

impl ErrorCode for PayloadError {
    fn code(&self) -> &'static str {
        match self {
            Self::MissingKey { .. } => "load::missing-key",
            Self::Mass { .. } | Self::Acceleration { .. } => "setting::value",
        }
    }
}

impl ErrorCode for WorkspaceError {
    fn code(&self) -> &'static str {
        match self {
            Self::NoCriterion => "workspace::no-criterion",
            Self::SaggingCables { .. } => "workspace::sagging-cables",
            Self::MissingKey { .. } => "workspace::missing-key",
            Self::MissingEffect { .. } => "workspace::missing-effect",
            Self::WrenchSet(error) => error.code(),
            Self::Payload(error) => error.code(),
            Self::Setting { .. } | Self::Capability { .. } => "workspace::setting",
            Self::Drum { error, .. } => error.code(),
            Self::BoundsCount { .. } | Self::Bounds { .. } => "workspace::bounds",
            Self::Step { .. } | Self::StepTooFine { .. } => "workspace::step",
            Self::NoRotation { .. } | Self::NoOrientation { .. } => "workspace::orientations",
            Self::Rays { .. } => "workspace::rays",
            Self::Tolerance { .. } => "workspace::tolerance",
            Self::CenterOutsideBounds { .. } | Self::CenterOutside { .. } => "workspace::center-outside",
            Self::Limits(error) => error.code(),
            Self::Load(error) => error.code(),
            Self::Tension(error) => error.code(),
        }
    }
}

impl ErrorCode for WantedError {
    fn code(&self) -> &'static str {
        match self {
            Self::Unknown { .. } => "workspace::criterion",
            Self::Number { .. } | Self::Missing { .. } => "workspace::setting",
        }
    }
}
