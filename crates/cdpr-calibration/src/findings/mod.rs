//! Findings: the data, the file's own numbers and statics as witnesses against a fitted model.

mod cause;
mod center_of_mass;
mod examined;
mod load;
mod noise;
mod numbers;
mod reach;
mod residual_table;
mod scan;
mod sentence;

pub use examined::Examined;
pub use numbers::UNIT_FACTORS;

use cdpr_model::finding::Finding;
use cdpr_model::measurement::mix_ups;

/// Everything that speaks against a fitted model: what is wrong with the data, then numbers that cannot be, then statics, then what the samples
/// do not show.
pub fn findings(examined: &Examined<'_>) -> Vec<Finding> {
    let mut found = load::findings(examined);
    // the place of a load that is another one is not asked
    if found.is_empty() {
        found.extend(center_of_mass::finding(examined));
    }
    found.extend(scan::finding(examined));
    found.extend(numbers::findings(examined));
    found.extend(load::gravity(examined));
    // asked again with anchors that fit, a mix-up shows that wrong ones hid
    if found.is_empty() && examined.fit.frames.is_none() {
        found.extend(mix_ups::with_robot(examined.richest.model.robot(), examined.samples));
    }
    // a cause that is named explains that residuals are too large
    if found.is_empty() {
        found.extend(noise::lack_of_fit(examined));
    }
    found.extend(reach::finding(examined));
    // the same cause explains that residuals repeat each other
    if found.iter().all(|finding| finding.explains.is_none()) {
        found.extend(noise::repeated_rows(examined));
    }
    found
}
