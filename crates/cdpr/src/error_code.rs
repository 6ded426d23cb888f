//! Stable short names of everything that the library refuses, for scripts and for looking up.
//!
//! A code is `area::mistake` in words. One mistake has one code, whichever function met it: an error that only carries
//! another one has the other's code. Errors of files ([`ReadError`]) bring their own.

mod identification;
mod operation;
mod plant;
#[cfg(feature = "files")]
mod sweep;

use crate::cable::outlet::pulley::PlacementError;
use crate::cable::winch::{DrumError, GrooveError};
use crate::cable::{CableStateError, GeometryError};
use crate::equilibrium::{ForwardError, distribution, elastostatics, forward_kinematics, forward_statics};
use crate::geometry::PatternError;
use crate::identification::PredictionError;
use crate::metamodel;
use crate::model::{CompositionError, ModelError, ParameterError, PlacePulleysError, WinchError};
use crate::reading::{FileError, ReadError};
use crate::robot::StretchError;
use crate::statics::{LoadError, StaticsError};
use crate::tension::{self, LimitsError};
use crate::workspace::WorkspaceError;
use crate::workspace::criterion::registry::WantedError;
use crate::workspace::wrench_set::{PayloadError, WrenchSetError};

/// An error with a stable short name.
pub trait ErrorCode: std::error::Error {
    /// The name, e.g. `data::all-equal`.
    fn code(&self) -> &'static str;
}

impl ErrorCode for ReadError {
    fn code(&self) -> &'static str {
        self.code
    }
}

impl ErrorCode for FileError {
    fn code(&self) -> &'static str {
        match self {
            Self::Unreadable { .. } => "io::read",
            Self::Refused(error) => error.code(),
        }
    }
}

impl ErrorCode for CableStateError {
    fn code(&self) -> &'static str {
        match self {
            Self::NoCourse => "cable::no-course",
            Self::TooShort { .. } | Self::TensionTooLow { .. } | Self::NotConverged { .. } => "cable::no-shape",
            Self::Overstretched { .. } => "tensions::overstretched",
        }
    }
}

impl ErrorCode for distribution::DistributionError {
    fn code(&self) -> &'static str {
        match self {
            Self::Statics(error) => error.code(),
            Self::Tension(error) => error.code(),
            Self::Limits(error) => error.code(),
        }
    }
}

impl ErrorCode for GeometryError {
    fn code(&self) -> &'static str {
        match self {
            Self::ZeroLength { .. } | Self::InsidePulley { .. } | Self::OnSwivelAxis { .. } | Self::OpenSide { .. } => {
                "cable::no-course"
            }
            Self::NotFinite { .. } => "numerical::overflow",
        }
    }
}

impl ErrorCode for DrumError {
    fn code(&self) -> &'static str {
        match self {
            Self::PulleyInside { .. } | Self::Number { .. } => "winch::drum",
        }
    }
}

impl ErrorCode for GrooveError {
    fn code(&self) -> &'static str {
        "winch::groove"
    }
}

impl ErrorCode for WinchError {
    fn code(&self) -> &'static str {
        match self {
            Self::NoRadius { .. } => "winch::no-radius",
            Self::Groove { reason, .. } => reason.code(),
            Self::Count { .. } => "winch::angle-count",
        }
    }
}

impl ErrorCode for PlacementError {
    fn code(&self) -> &'static str {
        match self {
            Self::AlongAxis | Self::ZeroLength => "pulley::no-place",
        }
    }
}

impl ErrorCode for PlacePulleysError {
    fn code(&self) -> &'static str {
        match self {
            Self::Cable { reason, .. } => reason.code(),
            Self::Input { .. } => "pulley::radius-or-axis",
        }
    }
}

impl ErrorCode for StretchError {
    fn code(&self) -> &'static str {
        // the reader of robot files, which stands left of this list, shows it too
        self.code()
    }
}

impl ErrorCode for PatternError {
    fn code(&self) -> &'static str {
        match self {
            Self::ComponentCount { .. } => "pose::component-count",
            Self::NotFinite { .. } => "pose::not-finite",
        }
    }
}

impl ErrorCode for CompositionError {
    fn code(&self) -> &'static str {
        match self {
            Self::Unknown { .. } => "model::unknown-effect",
            Self::Misplaced { .. } => "model::composition",
        }
    }
}

impl ErrorCode for ModelError {
    fn code(&self) -> &'static str {
        match self {
            Self::Stretch { reason, .. } => reason.code(),
            Self::MissingKey { .. } | Self::NoGravity { .. } => "model::missing-key",
            Self::Drum { reason, .. } => reason.code(),
            Self::SpatialWrapSide { .. } => "robot::wrap-side",
            Self::NoCables { .. } => "robot::no-cables",
        }
    }
}

impl ErrorCode for ParameterError {
    fn code(&self) -> &'static str {
        match self {
            Self::UnknownName { .. } => "parameter::unknown-name",
            Self::Syntax { .. } | Self::WrenchOfCable => "parameter::syntax",
            Self::NoSuchCable { .. } => "parameter::no-such-cable",
            Self::NotInModel { .. } | Self::GuidedDrum { .. } => "parameter::not-in-model",
            Self::ConstantSpring { .. } => "parameter::constant-spring",
            Self::StartLengthTwice { .. } => "parameter::collinear",
        }
    }
}

impl ErrorCode for StaticsError {
    fn code(&self) -> &'static str {
        match self {
            Self::TensionCount { .. } => "tensions::count",
            Self::NotFinite { .. } => "tensions::not-finite",
            Self::Negative { .. } => "tensions::negative",
            Self::CableState { reason, .. } => reason.code(),
            Self::Overstretched { .. } => "tensions::overstretched",
            Self::Rigid { .. } => "stiffness::rigid-cable",
            Self::UnknownCable { .. } | Self::RepeatedCable { .. } => "group::cables",
            Self::CablePath(reason) => reason.code(),
        }
    }
}

impl ErrorCode for LoadError {
    fn code(&self) -> &'static str {
        "load::missing-key"
    }
}

impl ErrorCode for LimitsError {
    fn code(&self) -> &'static str {
        match self {
            Self::Count { .. } => "limits::count",
            Self::NotFinite { .. } => "limits::not-finite",
            Self::EmptyRange { .. } => "limits::empty-range",
            Self::MissingKey { .. } => "limits::missing-key",
        }
    }
}

impl ErrorCode for tension::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::MatrixShape { .. } | Self::WrenchLength { .. } | Self::Empty { .. } => "wrench::component-count",
            Self::LimitCount { .. } => "limits::count",
            Self::ReferenceLength { .. } | Self::AnswerCount { .. } | Self::OptionCount { .. } => "tensions::count",
            Self::OptionValue { .. } | Self::NoPrevious => "tensions::option",
            Self::NotFinite { .. } => "numerical::overflow",
        }
    }
}

impl ErrorCode for tension::NotSmooth {
    fn code(&self) -> &'static str {
        match self {
            Self::Pinned | Self::Thin { .. } => "tensions::not-smooth",
            Self::Input(error) => error.code(),
        }
    }
}

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

impl ErrorCode for forward_kinematics::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::LengthCount { .. } | Self::GuessCount { .. } => "lengths::count",
            Self::Length { .. } => "lengths::value",
            Self::Guess => "pose::not-finite",
            Self::Setting { .. } => "setting::value",
        }
    }
}

impl ErrorCode for elastostatics::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::Kinematic(error) => error.code(),
            Self::RigidRedundant { .. } => "equilibrium::rigid-cables",
        }
    }
}

impl ErrorCode for ForwardError {
    fn code(&self) -> &'static str {
        match self {
            Self::Load(error) => error.code(),
            Self::Input(error) => error.code(),
        }
    }
}

impl ErrorCode for forward_statics::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::Statics(error) => error.code(),
            Self::Kinematic(error) => error.code(),
        }
    }
}

impl ErrorCode for metamodel::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::DifferentRobots { .. } => "study::different-robots",
            Self::Count { .. } => "study::count",
            Self::Initial(error) => error.code(),
            Self::InitialTensions(error) => error.code(),
            Self::NoTensions | Self::NotBalanced { .. } => "study::initial-tensions",
            Self::Load(error) => error.code(),
            Self::Machine(error) => error.code(),
            Self::Limits(error) => error.code(),
            Self::Distribution(error) => error.code(),
            Self::Winch(error) => error.code(),
            Self::NoDrum => "study::no-drum",
            Self::RigidMachine => "study::rigid-machine",
            Self::TensionsVaryTogether => "study::initial-tensions",
            Self::Model(error) => error.code(),
            Self::Composition(error) => error.code(),
            Self::InitialPose(error) => error.code(),
            Self::TooManyRobots { .. } => "study::too-many-robots",
            Self::NoMap { .. } | Self::Map { .. } => "study::compensation",
            Self::NoPoses | Self::NoneFeasible { .. } => "study::no-poses",
            Self::NoRequirement { .. } => "study::no-requirement",
            Self::NoCommandedTensions { .. } => "study::no-commanded-tensions",
        }
    }
}

impl ErrorCode for metamodel::ExperimentError {
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

impl ErrorCode for metamodel::advice::AdviceError {
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

impl ErrorCode for WorkspaceError {
    fn code(&self) -> &'static str {
        match self {
            Self::NoCriterion => "workspace::no-criterion",
            Self::SaggingCables { .. } => "workspace::sagging-cables",
            Self::MissingKey { .. } => "workspace::missing-key",
            Self::MissingEffect { .. } => "workspace::missing-effect",
            Self::WrenchSet(error) => error.code(),
            Self::Payload(error) => error.code(),
            Self::Setting { .. } => "workspace::setting",
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
