//! Effect of a map that corrects a control model's lengths.

use serde::Serialize;

/// Effect of a map over commanded poses, beside which stands what was found with it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MapEffect<T> {
    /// Poses beyond the samples of the map, to which the control model drives without correction.
    pub outside: usize,
    /// Findings of the control model alone at the same poses.
    pub without: T,
}
