//! Laws of stretch of a robot's cable: the formulas of [`cdpr_core::cable::stretch`], made of what a robot file says.

pub use cdpr_core::cable::stretch::{Stretch, hysteresis, polynomial};

#[cfg(test)]
mod hysteresis_tests;
#[cfg(test)]
mod motion_tests;
#[cfg(test)]
mod polynomial_tests;

pub use crate::robot::stretch::{hysteresis_law, polynomial_law};
