//! Effect of a map that corrects a control model's lengths.

use crate::compensation::Beyond;

/// Effect of a map over commanded poses, given with the results for the map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapEffect<T> {
    /// Poses beyond the map, at which the control model drives without correction, and those in its margin, where the
    /// correction fades.
    pub beyond: Beyond,
    /// Results of the control model without the map at the same poses.
    pub without: T,
}
