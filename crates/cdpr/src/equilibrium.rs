//! Equilibria: the inverse problem and the forward problems.

#[doc(inline)]
pub use cdpr_model::equilibrium::{
    CableCommand, ForwardAnswers, ForwardBatch, ForwardError, ForwardProblem, ForwardRows, ForwardSettings,
    InverseSolution, RowsError, Solution, Solutions, State, Status,
};

pub mod closed_form {
    //! Closed-form tensions of many poses.

    #[doc(inline)]
    pub use cdpr_model::equilibrium::closed_form::solve_batch;
}

pub mod distribution {
    //! Tensions of a model at a pose.

    #[doc(inline)]
    pub use cdpr_model::equilibrium::distribution::{
        Distribution, DistributionError, Distributions, Reason, Solver, solve, solve_batch,
    };
}

pub mod elastostatics {
    //! Poses and tensions of elastic robots from their lengths.

    #[doc(inline)]
    pub use cdpr_model::equilibrium::elastostatics::{InputError, Settings, Solution, Solver, Status, solve};
}

pub mod feasibility {
    //! Wrench feasibility of many poses.

    #[doc(inline)]
    pub use cdpr_model::equilibrium::feasibility::{Solver, feasible};
}

pub mod forward_kinematics {
    //! Poses of rigid robots from their lengths.

    #[doc(inline)]
    pub use cdpr_model::equilibrium::forward_kinematics::{InputError, Settings, Solution, Solver, Status, solve};
}

pub mod forward_statics {
    //! Poses of hanging robots with too few cables.

    #[doc(inline)]
    pub use cdpr_model::equilibrium::forward_statics::{Settings, Solution, solve};
}
