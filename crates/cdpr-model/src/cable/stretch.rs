//! Laws of stretch of a robot's cable: the formulas of [`cdpr_core::cable::stretch`] with the numbers of a robot file.

pub use cdpr_core::cable::stretch::{Stretch, hysteresis, polynomial};

#[cfg(test)]
mod hysteresis_tests;
#[cfg(test)]
mod motion_tests;
#[cfg(test)]
mod polynomial_tests;

pub use crate::robot::stretch::{hysteresis_law, polynomial_law};
