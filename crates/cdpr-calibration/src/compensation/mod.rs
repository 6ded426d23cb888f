//! Compensation maps made of what a model leaves of samples, and judged on samples held out.

mod compensation_error;
mod judged;
mod judgement;

pub use compensation_error::CompensationError;
pub use judged::Judged;
pub use judgement::{Compensated, compensate, evaluate_compensated};
