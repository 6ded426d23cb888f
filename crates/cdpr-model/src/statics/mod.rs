//! Forces at one pose: the load on the platform, the tensions that balance it, and the stiffness.
//!
//! All functions take a pose and tensions, and work in the motion pattern's degrees of freedom. Tensions are pull
//! positive and never negative; the law of the cables is the model's (see [`crate::cable::elasticity`]).

mod balance;
mod cable_states;
mod error;
mod load;
mod sections;
mod stability;
mod stiffness;
#[cfg(test)]
mod tests;

pub use balance::{TensionSplit, balanced_wrench, controlled_lengths, split, wrench_residual};
pub use cable_states::cable_state;
pub use cable_states::{cable_lengths, cable_state_at_outlet, unit_spring_state};
pub use error::{StaticsError, check_tensions};
pub use load::{Load, LoadError};
pub use sections::section_wrench;
pub use stability::Stability;
pub use stability::indifferent_stiffness;
pub use stiffness::Stiffness;
pub use stiffness::{axial_stiffness, geometric_stiffness};
