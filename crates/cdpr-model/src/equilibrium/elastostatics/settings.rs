//! Settings of the elastostatic forward problem, and the input that it refuses.

use thiserror::Error;

use crate::equilibrium::forward_kinematics;
use crate::solve::not_positive;

/// Settings of the elastostatic forward problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// The search stops once the pose is this near to the equilibrium, judged by the last steps (m, relative to the
    /// mean length above 1 m; angles times the platform radius).
    pub pose_tolerance: f64,
    /// For rigid cables: largest excess of a cable over its controlled length (m).
    pub length_tolerance: f64,
    /// Size of Aᵀ f + w that counts as balance, relative to the acting forces; moments divided by the platform radius.
    /// A tension below this fraction of the others counts as none.
    pub wrench_tolerance: f64,
    /// Steps allowed for each descent.
    pub max_iterations: u32,
    /// Further starts allowed if the first one does not lead to a stable equilibrium.
    pub max_restarts: u32,
    /// Fraction of its controlled length by which a cable stretches before the answer has a remark.
    pub remarkable_strain: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            pose_tolerance: 1e-11,
            length_tolerance: 1e-10,
            wrench_tolerance: 1e-7,
            max_iterations: 200,
            max_restarts: 16,
            remarkable_strain: 0.1,
        }
    }
}

/// Input that no elastostatic forward problem can accept.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InputError {
    /// Invalid lengths, guess or settings, as for forward kinematics.
    #[error(transparent)]
    Kinematic(#[from] forward_kinematics::InputError),
    /// More rigid cables than degrees of freedom: their tensions do not follow from their lengths.
    #[error(
        "{rigid} cables have no compliance at {dof} degrees of freedom: their tensions do not follow from their lengths; give \
         them a stiffness and use the effect `elastic`, or use forward kinematics for the pose that fits the lengths best"
    )]
    RigidRedundant {
        /// Number of cables without compliance.
        rigid: usize,
        /// Degrees of freedom.
        dof: usize,
    },
}

impl Settings {
    /// Refuses tolerances that are not positive numbers.
    pub(crate) fn validate(&self) -> Result<(), InputError> {
        let refused = not_positive([
            ("pose_tolerance", self.pose_tolerance),
            ("length_tolerance", self.length_tolerance),
            ("wrench_tolerance", self.wrench_tolerance),
            ("remarkable_strain", self.remarkable_strain),
        ]);
        refused.map_or(Ok(()), |(name, value)| Err(forward_kinematics::InputError::Setting { name, value }.into()))
    }
}
