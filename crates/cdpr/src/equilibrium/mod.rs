//! Forward problems: which pose follows from the cables.

pub mod closed_form;

pub mod distribution;
pub mod elastostatics;
pub mod feasibility;
pub mod forward_kinematics;
pub mod forward_problem;
pub mod forward_statics;
pub mod inverse;
mod pose_step;
mod restarts;
mod solution;
mod state;

pub use forward_problem::{ForwardError, ForwardProblem, ForwardSettings, Start};
pub use inverse::{CableCommand, InverseSolution};
use solution::{ITERATIONS, RMS, STATUS, TENSIONS};
pub use solution::{NoSolution, Solution, Solutions, Status};
pub use state::State;
