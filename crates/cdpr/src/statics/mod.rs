//! Forces at one pose: the load on the platform, what balances it, and how stiffly.
//!
//! Everything is asked at a given pose with given tensions, in the motion pattern's degrees of freedom. Tensions are pull
//! positive and never negative; the law that made them is that of the model (see [`crate::cable::elasticity`]).

mod balance;
mod error;
mod general_cable;
mod holding;
mod lengths;
mod load;
mod sections;
mod stiffness;
mod straight_cable;
#[cfg(test)]
mod tests;

pub use balance::{Split, balanced_wrench, controlled_lengths, split, wrench_residual};
pub use error::{StaticsError, check_tensions};
pub(crate) use general_cable::GeneralCable;
pub use holding::{Held, held, holds};
pub(crate) use lengths::{CableLengths, cable_lengths};
pub use load::{Load, LoadError};
pub use sections::section_wrench;
pub use stiffness::{Stability, Stiffness, geometric_stiffness};
pub(crate) use straight_cable::StraightCable;
