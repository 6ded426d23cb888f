//! How candidates are compared.

use super::{Requirement, SelectionCriterion};
use crate::fit;

/// How candidates are compared.
#[derive(Clone, Debug, Default)]
pub struct Settings {
    /// The error that decides.
    pub criterion: SelectionCriterion,
    /// Limits that a recommended candidate must keep on validation data.
    pub requirements: Vec<Requirement>,
    /// Priors, held parameters and tolerances of every fit.
    pub fit: fit::Settings,
    /// Seed of the bootstrap.
    pub seed: u64,
    /// Regions of the workspace that are left out in turn besides, for the rating; 0 for none.
    pub regions: usize,
}
