//! Sensitivities and tolerances of a study: what `cdpr sensitivity` computes, tells and writes.

mod answer;
mod map;
mod names;
pub(crate) mod tables;
mod words;

use cdpr::metamodel::tolerance::{DeviationSettings, Deviations};

pub(crate) use answer::answer;
pub(crate) use map::map;
pub(crate) use names::place_of;

/// Questions to a study.
pub(crate) struct Asked {
    /// Those that the library answers.
    pub(crate) settings: DeviationSettings,
    /// Parameters in the table.
    pub(crate) top: usize,
}
