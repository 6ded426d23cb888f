//! Cables as springs.

use crate::scalar::LANES;

/// Eight cables as springs, with the law f = k₀ e/(1 + κ_q k₀ e) of the stretch e = q − q_θ.
///
/// This is (q − q_θ)/c of [`crate::cable::elasticity`] with the compliance split at rest: c = 1/k₀ + κ_q e.
#[derive(Clone, Copy, Debug)]
pub(super) struct Springs {
    /// Length without tension (m).
    pub(super) rest_length: [f64; LANES],
    /// k₀, stiffness without stretch (N/m); 0 for the copies that pad a group.
    pub(super) stiffness: [f64; LANES],
}
