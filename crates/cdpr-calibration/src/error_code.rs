//! Codes of what identification refuses.

use cdpr_model::reading::ErrorCode;

use crate::candidate::CandidateError;
use crate::compensation::CompensationError;
use crate::cross_validation::CrossValidationError;
use crate::selection::RequirementError;
use crate::{EvaluationError, PlanError, fit, frequency_response, friction, selection, test_bench};

impl ErrorCode for EvaluationError {
    fn code(&self) -> &'static str {
        match self {
            Self::Load(error) => error.code(),
            Self::Forward(error) => error.code(),
            Self::Winch(error) => error.code(),
            Self::CableCount { .. } => "data::cable-count",
        }
    }
}

impl ErrorCode for fit::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::Stopped => "work::stopped",
            Self::Parameters(error) => error.code(),
            Self::Model(error) => error.code(),
            Self::Winch(error) => error.code(),
            Self::NoSamples => "data::no-samples",
            Self::NoClockOffset => "data::no-clock-offset",
            Self::ShiftUntold { .. } => "data::no-shift",
            Self::ShiftOfAngles { .. } => "parameter::shift-of-angles",
            Self::NoFrames { .. } => "data::no-frames",
            Self::MarkerOfPoint => "parameter::marker-of-point",
            Self::FramesOfNothing { .. } => "parameter::frames-of-nothing",
            Self::CableCount { .. } => "data::cable-count",
            Self::TooFewSamples { .. } | Self::TooFewRows { .. } | Self::TooFewEquations { .. } => {
                "data::too-few-samples"
            }
            Self::Degenerate { reason, .. } => reason.code(),
            Self::PriorSyntax { .. } => "prior::syntax",
            Self::NoMotorAngles { .. } => "data::no-motor-angles",
            Self::NoTensions | Self::PosesWithoutTensions => "data::no-tensions",
            Self::NoTask => "objective::no-task",
            Self::RobustCost { .. }
            | Self::PriorCost { .. }
            | Self::UnknownPosesOfElastic
            | Self::ProfileCost { .. }
            | Self::RecordingCost { .. }
            | Self::PenaltyCost { .. }
            | Self::RowWeightCost { .. } => "setting::cost",
            Self::RowWeightSyntax { .. } | Self::ScaleSyntax { .. } | Self::ScaledTwice { .. } => "scale::syntax",
            Self::NoEquationLeft { .. } => "data::no-equations",
            Self::Known(error) => error.code(),
            Self::GaugeOpen { .. } => "data::gauge-open",
            Self::ChangesBesideSensors => "data::no-start-lengths",
            Self::NoSwivel { .. } => "data::no-swivel-zero",
            Self::NoSwivelAngles => "data::no-swivels",
            Self::NoPoses => "data::no-poses-found",
            Self::NoAccuracies => "data::no-accuracies",
            Self::NoPrediction { .. } => "data::no-prediction",
            Self::CableState { reason, .. } => reason.code(),
            Self::NegativeTension { .. } => "data::negative-tensions",
            Self::Load(error) => error.code(),
            Self::NotFinite => "numerical::overflow",
            Self::Setting { .. } => "setting::value",
        }
    }
}

impl ErrorCode for CompensationError {
    fn code(&self) -> &'static str {
        match self {
            Self::TooFewSamples { .. } => "data::too-few-samples",
            Self::Split(error) => error.code(),
            Self::Evaluation(error) => error.code(),
            Self::Map(error) => error.code(),
            Self::Winch(error) => error.code(),
        }
    }
}

impl ErrorCode for PlanError {
    fn code(&self) -> &'static str {
        match self {
            Self::NoCount | Self::TooMany { .. } => "plan::count",
            Self::NothingFree => "parameter::none-free",
            Self::NoCandidate { .. } => "plan::no-candidate",
            Self::Levels { .. } | Self::LevelsOfRigid | Self::LevelsOfSagging | Self::TestsOfRigid => {
                "plan::tension-levels"
            }
            Self::PriorsWithoutAccuracies => "plan::priors",
            Self::Unplannable { .. } => "plan::parameter",
            Self::Parameters(error) => error.code(),
            Self::Rows(error) => error.code(),
            Self::Load(error) => error.code(),
            Self::Tensions(error) => error.code(),
            Self::Machine(error) => error.code(),
        }
    }
}

impl ErrorCode for test_bench::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::NoRange { .. } => "record::no-range",
            Self::TooFewCycles { .. } => "record::too-few-cycles",
            Self::TooFewRows { .. } => "record::too-few-rows",
            Self::NotRising { .. } => "record::not-rising",
            Self::BranchesCross { .. } => "record::branches-cross",
            Self::NoLaw(reason) => reason.code(),
        }
    }
}

impl ErrorCode for frequency_response::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::Lengths { .. } => "record::lengths",
            Self::NotFinite { .. } => "record::not-finite",
            Self::TooFewRows { .. } => "record::too-few-rows",
            Self::TimeOrder { .. } => "record::time-order",
            Self::Uneven { .. } => "record::uneven",
            Self::NoRange { .. } => "record::no-range",
            Self::TooFewWindows { .. } => "record::too-few-windows",
            Self::NoSteps { .. } => "record::no-steps",
            Self::Setting { .. } => "setting::value",
        }
    }
}

impl ErrorCode for friction::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::Empty => "record::empty",
            Self::Lengths { .. } => "record::lengths",
            Self::NotFinite { .. } => "record::not-finite",
            Self::MixedLoads { .. } => "record::mixed-loads",
            Self::ConstantTorque { .. } => "record::constant-torque",
        }
    }
}

impl ErrorCode for CandidateError {
    fn code(&self) -> &'static str {
        match self {
            Self::Composition { reason, .. } => reason.code(),
            Self::Parameters { reason, .. } => reason.code(),
            Self::Empty { .. } => "candidate::none",
        }
    }
}

impl ErrorCode for RequirementError {
    fn code(&self) -> &'static str {
        match self {
            Self::Syntax { .. } => "requirement::syntax",
            Self::UnknownMetric { .. } => "requirement::unknown-figure",
        }
    }
}

impl ErrorCode for selection::CandidateFailure {
    fn code(&self) -> &'static str {
        match self {
            Self::Model(error) => error.code(),
            Self::Fit(error) => error.code(),
            Self::Evaluation(error) => error.code(),
        }
    }
}

impl ErrorCode for CrossValidationError {
    fn code(&self) -> &'static str {
        match self {
            Self::Fit(error) => error.code(),
            Self::Evaluation(error) => error.code(),
        }
    }
}

impl ErrorCode for selection::InputError {
    fn code(&self) -> &'static str {
        match self {
            Self::Stopped => "work::stopped",
            Self::NoCandidates => "candidate::none",
            Self::NoValidation => "data::no-validation",
            Self::Regions(error) => error.code(),
            Self::AllFailed { .. } => "candidate::all-failed",
        }
    }
}
