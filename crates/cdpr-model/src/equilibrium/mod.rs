//! Forward problems: the pose that follows from the cables, and tensions that balance a load at a pose.

pub mod closed_form;

pub mod distribution;
pub mod elastostatics;
pub mod feasibility;
pub mod forward_kinematics;
pub mod forward_problem;
pub mod forward_statics;
pub mod hanging;
mod inverse;
mod inverse_solution;
mod pose_step;
mod restarts;
pub mod rows;
mod scratch;
mod solution;
mod start;
mod state;

pub use forward_problem::{ForwardBatch, ForwardError, ForwardProblem, ForwardSettings};
pub use inverse_solution::{CableCommand, InverseSolution};
pub use pose_step::turned;
pub use restarts::restart_poses;
pub use rows::{ForwardAnswers, ForwardRows, RowsError};
use solution::{ITERATIONS, RMS, STATUS, TENSIONS};
pub use solution::{NoSolution, Solution, Solutions, Status};
pub use start::Start;
pub use state::State;
