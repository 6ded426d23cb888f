//! Codes of the errors of robots, models, statics and controllers.

use crate::cable::outlet::pulley::PlacementError;
use crate::cable::winch::{DrumError, GrooveError};
use crate::cable::{CableStateError, GeometryError};
use crate::compensation::MapError;
use crate::control::OperationError;
use crate::equilibrium::hanging::HangingError;
use crate::equilibrium::{
    ForwardError, NoSolution, RowsError, distribution, elastostatics, forward_kinematics, forward_statics,
};
use crate::geometry::{PatternError, PoseRowError};
use crate::measurement::{DataError, KnownError, SplitError};
use crate::model::{CompositionError, ModelError, ParameterError, PlacePulleysError, WinchError};
use crate::reading::{ErrorCode, ReadError};
use crate::robot::{BodyError, StretchError};
use crate::statics::{LoadError, StaticsError};
use crate::tension::LimitsError;
use crate::{control, tension};

/// Code of outcomes without an answer: only another pose, load or robot has one.
const NO_ANSWER: &str = "numerical::no-answer";

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
        // the reader of robot files, which comes before this list in the order of modules, shows it too
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

impl ErrorCode for PoseRowError {
    fn code(&self) -> &'static str {
        match self {
            Self::Norm { .. } => "rows::not-a-rotation",
            Self::NotFinite { .. } => "rows::not-finite",
            Self::Angle { .. } => "rows::angle",
        }
    }
}

impl ErrorCode for RowsError {
    fn code(&self) -> &'static str {
        match self {
            Self::Pose(error) => error.code(),
            Self::Count { .. } => "rows::count",
            Self::Forward(error) => error.code(),
            Self::Tension(error) => error.code(),
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
            Self::Syntax { .. } | Self::LoadOfCable { .. } => "parameter::syntax",
            Self::NoSuchCable { .. } => "parameter::no-such-cable",
            Self::NotInModel { .. } | Self::GuidedDrum { .. } => "parameter::not-in-model",
            Self::ConstantSpring { .. } => "parameter::constant-spring",
            Self::StartLengthTwice { .. } => "parameter::collinear",
            Self::NoEffect { .. } => "parameter::no-effect",
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

impl ErrorCode for HangingError {
    fn code(&self) -> &'static str {
        match self {
            Self::Fixed { .. } | Self::TooFew { .. } => "equilibrium::position",
            Self::NoForce => "equilibrium::no-force",
            Self::Sagging => "equilibrium::position-sag",
            Self::Statics(error) => error.code(),
            Self::Geometry(error) => error.code(),
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

impl ErrorCode for control::InputError {
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

impl ErrorCode for DataError {
    fn code(&self) -> &'static str {
        match self {
            Self::AllEqual { .. } => "data::all-equal",
            Self::NoTimes => "data::no-times",
            Self::DifferentCables { .. } => "data::cable-count",
            Self::DifferentLengths => "data::no-start-lengths",
        }
    }
}

impl ErrorCode for SplitError {
    fn code(&self) -> &'static str {
        match self {
            Self::Syntax { .. } => "split::syntax",
            Self::NoColumn | Self::SetName { .. } | Self::EmptySide { .. } => "split::column",
            Self::TooManyFolds { .. } => "split::too-many-folds",
        }
    }
}

impl ErrorCode for KnownError {
    fn code(&self) -> &'static str {
        match self {
            Self::Syntax { .. } => "known::syntax",
            Self::Cables { .. } | Self::NoCommonPose { .. } => "known::not-of-robot",
        }
    }
}

impl ErrorCode for MapError {
    fn code(&self) -> &'static str {
        match self {
            Self::Read(error) => error.code,
            Self::OnePose => "data::all-equal",
            Self::OtherModel { .. } => "compensation::other-model",
            Self::Outside { .. } => "compensation::outside",
            Self::Statics(error) => error.code(),
        }
    }

    fn read_error(&self) -> Option<&ReadError> {
        match self {
            Self::Read(error) => Some(error),
            _ => None,
        }
    }
}

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

impl ErrorCode for BodyError {
    fn code(&self) -> &'static str {
        "plant::missing-body"
    }
}
