//! Effect of a map that corrects a control model's lengths.

use serde::Serialize;

use crate::compensation::Beyond;

/// Effect of a map over commanded poses, beside which stands what was found with it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MapEffect<T> {
    /// Poses beyond the map, to which the control model drives without correction, and those in its margin, where the correction fades.
    #[serde(flatten)]
    pub beyond: Beyond,
    /// Findings of the control model alone at the same poses.
    pub without: T,
}
