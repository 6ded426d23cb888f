//! Settings of the elastostatic forward problem, and what it refuses.

use thiserror::Error;

use crate::equilibrium::forward_kinematics;
use crate::solve::not_positive;

/// When the elastostatic forward problem stops, and what it accepts.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Stop once the pose is this near to the equilibrium, judged by the last steps (m, relative to the mean length above
    /// 1 m; angles times the platform radius).
    pub pose_tolerance: f64,
    /// For rigid cables: how much longer than its controlled length a cable may remain (m).
    pub length_tolerance: f64,
    /// Size of Aᵀ f + w that counts as balance, beside the forces at work; moments divided by the platform radius. A tension
    /// this small beside the others cannot be told from none.
    pub wrench_tolerance: f64,
    /// Steps allowed for each descent.
    pub max_iterations: u32,
    /// Other starts that may be tried when the first one does not lead to a stable equilibrium.
    pub max_restarts: u32,
    /// A cable that stretches by more than this share of its controlled length deserves a remark.
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
    /// Lengths, guess or settings, as for forward kinematics.
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
