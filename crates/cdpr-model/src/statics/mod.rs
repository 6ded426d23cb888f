//! Forces at one pose: the load on the platform, what balances it, and how stiffly.
//!
//! Everything is asked at a given pose with given tensions, in the motion pattern's degrees of freedom. Tensions are pull
//! positive and never negative; the law that made them is that of the model (see [`crate::cable::elasticity`]).

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
