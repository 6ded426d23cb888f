//! Methods for the least squares of parameters, on the damped loop of [`cdpr_core::solve`].

pub mod minimizer;
mod settings;

pub use cdpr_core::solve::bounded::Room;
pub use cdpr_core::solve::{
    Control, DescentEnd, HIDDEN_GAIN, OF_SINGULAR, Problem, REGULAR, ROUNDING_GAIN, Rules, Step, StepRule, Stop, Trial,
    descend,
};
pub use minimizer::Minimizer;
pub use minimizer::{NormalSystem, Surroundings};
pub use settings::not_positive;
