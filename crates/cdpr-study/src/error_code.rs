//! Codes of the errors of studies.

use cdpr_model::reading::{ErrorCode, ReadError};

use crate::campaign::CampaignError;
use crate::chain::ChainError;
use crate::effects::EffectError;
#[cfg(feature = "files")]
use crate::sweep::{KeyError, KeyReason, PointError, ValuesError, ValuesReason};
use crate::{ExperimentError, PredictionError, advice};

/// Code of outcomes that only another pose, load or robot can change.
const NO_ANSWER: &str = "numerical::no-answer";

impl ErrorCode for ExperimentError {
    fn code(&self) -> &'static str {
        self.error.code()
    }
}

impl ErrorCode for PredictionError {
    fn code(&self) -> &'static str {
        match self {
            Self::Input(error) => error.code(),
            Self::Evaluation(error) => error.code(),
        }
    }
}

impl ErrorCode for advice::AdviceError {
    fn code(&self) -> &'static str {
        match self {
            Self::Model(error) => error.code(),
            Self::Input(error) => error.code(),
            Self::NoPoses => "study::no-poses",
            Self::NoHome => "advice::no-home",
            Self::NothingToChoose { .. } => "advice::nothing-to-choose",
        }
    }
}

impl ErrorCode for CampaignError {
    fn code(&self) -> &'static str {
        match self {
            Self::NoTable => "campaign::no-table",
            Self::Criterion { .. } => "campaign::criterion",
            Self::Parameters(error) => error.code(),
            Self::Fit(error) => error.code(),
            Self::Plan(error) => error.code(),
            Self::Machine(error) => error.code(),
            Self::Evaluation(error) => error.code(),
        }
    }
}

impl ErrorCode for ChainError {
    fn code(&self) -> &'static str {
        match self {
            Self::Experiment(error) => error.code(),
            Self::Fit(error) => error.code(),
            Self::Evaluation(error) => error.code(),
            Self::Model(error) => error.code(),
            Self::Parameters(error) => error.code(),
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

#[cfg(feature = "files")]
impl ErrorCode for KeyError {
    fn code(&self) -> &'static str {
        match self {
            Self::Place { .. } | Self::NoParameter { .. } | Self::Entry { .. } | Self::Nowhere { .. } => "sweep::value",
        }
    }
}

#[cfg(feature = "files")]
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

    fn read_error(&self) -> Option<&ReadError> {
        match self {
            Self::Read(error) => Some(error),
            _ => None,
        }
    }
}

#[cfg(feature = "files")]
impl ErrorCode for ValuesError {
    fn code(&self) -> &'static str {
        self.reason.code()
    }
}

#[cfg(feature = "files")]
impl ErrorCode for ValuesReason {
    fn code(&self) -> &'static str {
        "sweep::value"
    }
}

#[cfg(feature = "files")]
impl ErrorCode for KeyReason {
    fn code(&self) -> &'static str {
        "sweep::value"
    }
}
