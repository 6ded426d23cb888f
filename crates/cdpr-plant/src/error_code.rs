//! Codes of the errors of machines in time and their scenarios.

use cdpr_model::reading::ErrorCode;

use crate::{ControlError, PlantError, StepError};

impl ErrorCode for PlantError {
    fn code(&self) -> &'static str {
        match self {
            Self::Value { .. } => "scenario::value",
            Self::Components { reason, .. } => reason.code(),
            Self::Composition(error) => error.code(),
            Self::Model(error) => error.code(),
            Self::Body(error) => error.code(),
            Self::Load(error) => error.code(),
            Self::RigidCable { .. } => "plant::rigid-cable",
            Self::NoDrum { .. } => "plant::no-drum",
            Self::Winch(error) => error.code(),
            Self::Start(_) | Self::Cable(_) => "plant::no-equilibrium",
            Self::Period { .. } => "plant::control",
            Self::StepTooLarge { .. } => "plant::step-too-large",
        }
    }
}

impl ErrorCode for ControlError {
    fn code(&self) -> &'static str {
        "plant::control"
    }
}

impl ErrorCode for StepError {
    fn code(&self) -> &'static str {
        match self {
            Self::Cable(error) => error.code(),
            Self::Winch(error) => error.code(),
            Self::NoLength { .. } => "plant::no-length",
            Self::Spin { .. } => "plant::spin",
            Self::Overflow => "numerical::overflow",
            Self::Tolerance { .. } => "plant::tolerance",
            Self::Command { .. } | Self::NotFinite { .. } => "plant::command",
            Self::Control(error) => error.code(),
            Self::Count { .. } => "lengths::count",
        }
    }
}
