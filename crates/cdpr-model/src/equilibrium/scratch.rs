//! Memory in which forward problems are solved.

use super::{Solution, elastostatics, forward_kinematics};

/// Memory of a solver, with its last solution.
#[derive(Clone, Debug)]
pub(super) enum Scratch {
    LeastSquares(forward_kinematics::Scratch),
    Equilibrium(elastostatics::Scratch),
}

impl Scratch {
    pub(super) fn solution(&self) -> &Solution {
        match self {
            Self::LeastSquares(scratch) => &scratch.solution,
            Self::Equilibrium(scratch) => &scratch.solution,
        }
    }
}
