//! A control model on a richer machine: accuracy, sensitivity, tolerances, sweeps, reachable workspace, advice, campaigns.

#[doc(inline)]
pub use cdpr_study::study::{ControlModel, Distribution, RobotModel, Tolerances};
#[doc(inline)]
pub use cdpr_study::{Experiment, ExperimentError, Robots, Study};

pub mod accuracy {
    //! Errors over commanded poses.

    #[doc(inline)]
    pub use cdpr_study::accuracy::{Accuracy, Assessment, assess};
}

pub mod advice {
    //! The simplest control model that is good enough.

    #[doc(inline)]
    pub use cdpr_study::advice::{Advice, AdviceError, advise};
}

pub mod campaign {
    //! Rounds of planned measurements.

    #[doc(inline)]
    pub use cdpr_study::campaign::{Campaign, CampaignError};
}

pub mod difference {
    //! Two controllers on one machine.

    #[doc(inline)]
    pub use cdpr_study::difference::{Difference, ErrorChange};
}

pub mod effects {
    //! Contributions of single effects.

    #[doc(inline)]
    pub use cdpr_study::effects::{Contribution, EffectError, EffectState, contributions, largest};
}

pub mod field {
    //! Errors pose by pose.

    #[doc(inline)]
    pub use cdpr_study::field::{Field, Sample, Summary, field};
}

pub mod force_tracking {
    //! Verdict on force control after an identification.

    #[doc(inline)]
    pub use cdpr_study::force_tracking::{ForceTracking, TrackingVerdict};
}

pub mod reachable {
    //! The reachable workspace (eq. 3.33).

    #[doc(inline)]
    pub use cdpr_study::reachable::{Reachable, Requirements, Varied, differential_hull};
}

pub mod sensitivity {
    //! How pose and tensions follow what deviates.

    #[doc(inline)]
    pub use cdpr_study::sensitivity::{
        Influence, Kind, Offsets, ParameterDeviation, PoseSensitivity, Sensitivity, Setting, Side, causes, rank,
    };
}

#[cfg(feature = "files")]
pub mod sweep {
    //! Studies over ranges of numbers.

    #[doc(inline)]
    pub use cdpr_study::sweep::{PreparedSweep, Row, Subjects, Sweep};
}

pub mod tolerance {
    //! Robots as they are made.

    #[doc(inline)]
    pub use cdpr_study::tolerance::{Engine, MonteCarlo, Quantiles, Settings, Spread, monte_carlo};
}
