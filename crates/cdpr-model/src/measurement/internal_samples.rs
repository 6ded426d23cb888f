//! Samples of sensors inside the machine, at poses that were not measured.

use super::{DataError, Known, Samples};

/// Samples at poses that are known in part or not at all.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InternalSamples {
    /// Recordings; unknown components of the poses are those of the identity.
    pub samples: Samples,
    /// True for the known components of each pose, in the order of the pattern's degrees of freedom: positions, then
    /// rotations.
    pub known: Vec<Vec<bool>>,
    /// Swivel angles of the pulleys about `pulley_swivel_axis`, 0 towards gravity's component perpendicular to it, laid
    /// out as the lengths (rad).
    pub swivels: Option<Vec<f64>>,
    /// Mass of the platform with its load, sample by sample (kg); `None` uses that of the robot's file.
    pub masses: Option<Vec<f64>>,
    /// Further known facts about the robot.
    pub facts: Vec<Known>,
    /// True if lengths are changes from those at one common pose, which is the world's origin.
    pub are_changes: bool,
}

impl InternalSamples {
    /// Samples without any pose of a robot with this many degrees of freedom.
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

    /// The samples with these indices, in this order.
    #[must_use]
    pub fn subset(&self, indices: &[usize]) -> Self {
        let m = self.samples.cable_count;
        let of_cables = |data: &Vec<f64>| indices.iter().flat_map(|&i| data[i * m..][..m].to_vec()).collect();
        Self {
            samples: self.samples.subset(indices),
            known: indices.iter().map(|&i| self.known[i].clone()).collect(),
            swivels: self.swivels.as_ref().map(of_cables),
            masses: self.masses.as_ref().map(|masses| indices.iter().map(|&i| masses[i]).collect()),
            facts: self.facts.clone(),
            are_changes: self.are_changes,
        }
    }

    /// These samples followed by others; quantities that only one of the two has are dropped, facts are those of the
    /// first.
    pub fn followed_by(&self, other: &Self) -> Result<Self, DataError> {
        if self.are_changes != other.are_changes {
            return Err(DataError::DifferentLengths);
        }
        let joined = |a: &Option<Vec<f64>>, b: &Option<Vec<f64>>| Some([a.as_deref()?, b.as_deref()?].concat());
        Ok(Self {
            samples: self.samples.followed_by(&other.samples)?,
            known: [self.known.as_slice(), &other.known].concat(),
            swivels: joined(&self.swivels, &other.swivels),
            masses: joined(&self.masses, &other.masses),
            facts: self.facts.clone(),
            are_changes: self.are_changes,
        })
    }

    /// Number of completely known poses.
    pub fn whole_poses(&self) -> usize {
        self.known.iter().filter(|known| known.iter().all(|known| *known)).count()
    }

    /// Number of known components.
    pub fn known_count(&self) -> usize {
        self.known.iter().flatten().filter(|known| **known).count()
    }
}
