//! Codes of what a control model, a machine and their comparison refuse.

use super::ErrorCode;
use crate::equilibrium::NoSolution;
use crate::metamodel::OperationError;
use crate::metamodel::effects::EffectError;

/// Code of outcomes that no other input than another pose, load or robot mends.
const NO_ANSWER: &str = "numerical::no-answer";

impl ErrorCode for NoSolution {
    fn code(&self) -> &'static str {
        NO_ANSWER
    }
}

impl ErrorCode for OperationError {
    fn code(&self) -> &'static str {
        match self {
            Self::Statics(error) => error.code(),
            Self::Distribution(error) => error.code(),
            Self::Winch(error) => error.code(),
            Self::Groove(error) => error.code(),
            Self::NotSmooth(error) => error.code(),
            Self::Input(error) => error.code(),
            Self::Map(error) => error.code(),
            Self::AtPose { reason, .. } | Self::Deviating { reason, .. } => reason.code(),
            Self::NoTensions(_) | Self::NoRest { .. } | Self::Singular => NO_ANSWER,
        }
    }
}

impl ErrorCode for EffectError {
    fn code(&self) -> &'static str {
        match self {
            Self::Load(error) => error.code(),
            Self::Statics(error) => error.code(),
            Self::Distribution(error) => error.code(),
            Self::Winch(error) => error.code(),
            Self::Forward(error) => error.code(),
            Self::NoSolution(error) => error.code(),
            Self::AtHome(error) => error.code(),
            Self::NoHome => "advice::no-home",
            Self::Unbalanced(_) | Self::UnknownTensions | Self::NotNear | Self::Singular => NO_ANSWER,
        }
    }
}
