//! Tension of a cable as a function of its strain, and back, where the two are not in proportion.
//!
//! Each law rises strictly, so every tension has one strain. Below strain 0 and beyond its end each goes on straight,
//! so that iterations may pass through any number. Strain is the lengthening divided by the length it is counted from,
//! dimensionless.

pub mod hysteresis;
mod inverse;
pub mod polynomial;
