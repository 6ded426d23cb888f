//! A fitted model with all that it is held against.

use crate::fit::Fit;
use cdpr_model::measurement::Samples;
use cdpr_model::robot::Robot;

/// A fitted model, and what it is held against.
#[derive(Clone, Copy, Debug)]
pub struct Examined<'a> {
    /// The robot as its file describes it.
    pub given: &'a Robot,
    /// All samples, those of the fit and those held out, in the order of their rows.
    pub samples: &'a Samples,
    /// Indices of samples of another file or of a column that holds them out; empty where parts take turns.
    pub held_out: &'a [usize],
    /// The fit that the answer is about.
    pub fit: &'a Fit,
    /// The fit with the most parameters, whose residuals are searched: what it leaves, no simpler model explains.
    pub richest: &'a Fit,
    /// Mean position error on validation data (m); NaN without one.
    pub position_error: f64,
}
