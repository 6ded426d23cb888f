//! Samples of sensors inside the machine, at poses that nobody measured.

use super::{Known, Samples};

/// Samples at poses that are known in part or not at all.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InternalSamples {
    /// Recordings; poses hold the components that are known, and elsewhere those of the identity.
    pub samples: Samples,
    /// Known components of each pose in the order of the pattern's degrees of freedom: positions, then turns.
    pub known: Vec<Vec<bool>>,
    /// Swivel angles of the pulleys about `pulley_swivel_axis`, 0 towards gravity's part across it, laid out as the lengths (rad).
    pub swivels: Option<Vec<f64>>,
    /// Mass of the platform with its load, sample by sample (kg); that of the robot's file where there are none.
    pub masses: Option<Vec<f64>>,
    /// Facts known of the robot besides.
    pub facts: Vec<Known>,
    /// True where lengths count from that of one common pose, which is the world's origin.
    pub are_changes: bool,
}

impl InternalSamples {
    /// Samples without any pose of a robot with so many degrees of freedom.
    pub fn without_poses(samples: Samples, dof: usize, are_changes: bool) -> Self {
        Self {
            known: vec![vec![false; dof]; samples.len()],
            samples,
            swivels: None,
            masses: None,
            facts: Vec::new(),
            are_changes,
        }
    }

    /// Number of poses that are known whole.
    pub fn whole_poses(&self) -> usize {
        self.known.iter().filter(|known| known.iter().all(|known| *known)).count()
    }

    /// Number of components that are known.
    pub(crate) fn known_count(&self) -> usize {
        self.known.iter().flatten().filter(|known| **known).count()
    }
}
