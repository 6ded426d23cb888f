//! What the data, the file's own numbers and statics deny of a fitted model.

mod load;
mod numbers;
mod reach;
mod residual_table;
mod scan;
mod stated_noise;

pub use numbers::UNIT_FACTORS;
pub(crate) use scan::Scanned;

use super::fit::Fit;
use cdpr_model::finding::Finding;
use cdpr_model::measurement::{Samples, mix_ups};
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

/// Everything that speaks against a fitted model: what is wrong with the data, then numbers that cannot be, then statics, then what the samples
/// do not show.
pub fn findings(examined: &Examined<'_>) -> Vec<Finding> {
    let scanned = Scanned::of(examined);
    let load = load::findings(examined);
    let mut found: Vec<Finding> = load;
    found.extend(scanned.finding);
    found.extend(numbers::findings(examined));
    found.extend(load::gravity(examined));
    // asked again with anchors that fit, a mix-up shows that wrong ones hid
    if found.is_empty() {
        found.extend(mix_ups::with_robot(examined.richest.model.robot(), examined.samples));
    }
    // a cause that is named explains that residuals are too large
    if found.is_empty() {
        found.extend(stated_noise::finding(examined));
    }
    found.extend(reach::finding(examined));
    found
}
