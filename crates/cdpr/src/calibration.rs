//! From measurements to calibrated models, their uncertainty, and the choice between them.

#[doc(inline)]
pub use cdpr_calibration::{
    Analysis, Candidates, Conditioning, Coverage, CrossValidation, CrossValidationError, DesignCriterion, Doubt,
    DoubtKind, ErrorBlocks, Evaluation, EvaluationError, FrameEstimate, GaugeFixing, Information, Loss, Minimize,
    Objective, Outlier, PathSettings, Penalty, PenaltyPath, Plan, PlanError, PlanSettings, PoseBand, Progress,
    Reduction, Resampled, SelfCalibration, Towards, Verdict, conditioning, coverage, cross_validate,
    cross_validate_without_poses, evaluate, evaluate_fitted, evaluate_lengths, penalty_path, plan, propose_reduction,
    resampled, self_calibrate, unobserved,
};

pub mod candidate {
    //! Candidates of a choice.

    #[doc(inline)]
    pub use cdpr_calibration::candidate::{
        Candidate, CandidateError, KnownTensions, Ladder, PlatformAnchors, assumed_prior, defaults,
    };
}

pub mod compensation {
    //! Maps made of samples, and judged on others.

    #[doc(inline)]
    pub use cdpr_calibration::compensation::{Compensated, CompensationError, compensate, evaluate_compensated};
}

pub mod fit {
    //! One model fitted to samples.

    #[doc(inline)]
    pub use cdpr_calibration::fit::{
        Estimate, Fit, InputError, Minimizer, OptimalParameters, Prior, Profile, Settings, Status, TaskBox, fit,
        optimal_parameters, profiles,
    };
}

pub mod friction {
    //! Friction of a winch from records at constant speeds.

    #[doc(inline)]
    pub use cdpr_calibration::friction::{Record, Solution, identify};
}

pub mod selection {
    //! The choice between candidates.

    #[doc(inline)]
    pub use cdpr_calibration::selection::{
        InputError, JudgedCandidate, Judgement, Requirement, Selection, SelectionCriterion, Settings, select,
        select_without_poses,
    };
}

pub mod frequency_response {
    //! Frequency responses and transfer functions from records of input and output.

    #[doc(inline)]
    pub use cdpr_calibration::frequency_response::{Record, Settings, Solution, identify};
}

pub mod test_bench {
    //! Laws of cables from a test bench.

    #[doc(inline)]
    pub use cdpr_calibration::test_bench::{Record, Settings, Solution, identify};
}
