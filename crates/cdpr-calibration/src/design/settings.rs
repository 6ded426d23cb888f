//! Wishes for a plan.

use super::criterion::DesignCriterion;
use crate::fit::Settings;

/// Wishes for a plan.
#[derive(Clone, Debug)]
pub struct PlanSettings {
    /// Number of poses to choose, 1 at least.
    pub count: usize,
    /// Measure of what poses tell.
    pub criterion: DesignCriterion,
    /// A candidate may be chosen more than once.
    pub repeats: bool,
    /// Random sets that exchanges start from, beside one that grows pose by pose.
    pub starts: u32,
    /// Seed of these sets.
    pub seed: u64,
    /// Parameters that are held, and priors.
    pub fit: Settings,
}
