//! The linear law of a cable as a law of stretch by its unstrained length.

use cdpr_core::cable::stretch::Stretch;

use super::StretchError;
use crate::robot::{Cable, CableStiffness};

/// The law of the cable; a constant spring is a compliance in series with a rigid cable. `None` if the file states no
/// stiffness.
pub(super) fn law(cable: &Cable) -> Result<Option<Stretch>, StretchError> {
    if cable.stiffness.is_none() && cable.series_compliance.is_none() {
        return Ok(None);
    }
    Ok(Some(cable.specific_compliance().map_or(Stretch::Rigid, Stretch::Linear)))
}

/// Number of values that identification determines.
pub(super) fn count(_: &Cable) -> usize {
    1
}

/// Gives a cable this axial stiffness (N).
pub(super) fn sample(cable: &mut Cable, stiffness: f64) {
    cable.stiffness = Some(CableStiffness::Axial(stiffness));
}
