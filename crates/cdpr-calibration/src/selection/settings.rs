//! How candidates are compared.

use super::{Requirement, SelectionCriterion};
use crate::fit::{self, Prior};

/// How candidates are compared.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// The error that decides.
    pub criterion: SelectionCriterion,
    /// Whether it decides alone. Otherwise errors of positions are compared together with those of orientations, as the distance by which they move the
    /// platform anchors.
    pub decides_alone: bool,
    /// Limits that a recommended candidate must keep on validation data.
    pub requirements: Vec<Requirement>,
    /// Priors, held parameters and tolerances of every fit.
    pub fit: fit::Settings,
    /// Seed of the bootstrap.
    pub seed: u64,
    /// Priors among those of the fits that nobody stated: told where the recommended candidate relies on them.
    pub assumed: Vec<Prior>,
    /// Whether frames of tracker and marker and the offset of the clocks are tried in the richest candidate, and freed in all where the data ask
    /// for them; frames without which poses fit the robot nowhere are freed in any case.
    pub tries_recording: bool,
    /// Regions of the workspace that are left out in turn besides, for the rating; 0 for none.
    pub regions: usize,
}
