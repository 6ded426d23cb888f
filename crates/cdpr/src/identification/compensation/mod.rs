//! Compensation maps made of what a model leaves of samples, and judged on samples held out.

mod compensation_error;
mod judgement;
#[cfg(test)]
mod tests;

pub use compensation_error::CompensationError;
pub use judgement::{Compensated, Judged, compensate, evaluate_compensated};
