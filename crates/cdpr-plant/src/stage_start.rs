//! Start of the stages of a step, in memory that is allocated once.

use super::momentum::Momentum;
use cdpr_model::geometry::Pose;

/// Start of the stages, to which a cut returns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Start {
    pub(super) pose: Pose,
    pub(super) momentum: Momentum,
    pub(super) cables: Vec<CableStart>,
}

/// A cable at the start of the stages.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct CableStart {
    pub(super) length: f64,
    pub(super) rate: f64,
    pub(super) angle: f64,
    pub(super) speed: f64,
    /// Sum of law and damper before clipping (N).
    pub(super) sum: f64,
    /// The same in the middle of the stages.
    pub(super) middle: f64,
    /// Margin of the drum (N·m or rad/s), see [`Plant::margin`](super::plant::Plant::margin).
    pub(super) margin: f64,
    /// The same in the middle of the stages.
    pub(super) middle_margin: f64,
}

impl Start {
    pub(super) fn new(cables: usize) -> Self {
        let cables = vec![CableStart::default(); cables];
        Self { pose: Pose::identity(), momentum: Momentum::default(), cables }
    }
}
