//! A data set in memory.

use serde::{Deserialize, Serialize};

use thiserror::Error;

use crate::geometry::Pose;

/// Measurements of one robot, row by row; every per-cable row has m entries in the robot's cable order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Samples {
    /// Measured platform poses.
    pub poses: Vec<Pose>,
    /// Recorded cable lengths, sample by sample (m), `poses.len()` × m, row-major.
    ///
    /// If motor angles were recorded instead, these are the lengths of a model's winches (`Model::with_lengths`), and
    /// NaN until they are computed.
    pub lengths: Vec<f64>,
    /// Recorded motor angles, laid out as `lengths` (rad); `None` if lengths were recorded.
    pub motor_angles: Option<Vec<f64>>,
    /// Recorded tensions, laid out as `lengths` (N).
    pub tensions: Option<Vec<f64>>,
    /// Number of cables m.
    pub cable_count: usize,
    /// Name of each sample's subset (column `set`).
    pub set: Option<Vec<String>>,
    /// Time of each sample (s), increasing order not required.
    pub time: Option<Vec<f64>>,
    /// Line of each sample in its file, from 1; `None` for samples without a file.
    pub lines: Option<Vec<usize>>,
    /// True for samples that were appended from another record; `None` where all are of one.
    pub appended: Option<Vec<bool>>,
    /// Angles rx, ry, rz, or the angle in the plane (rad), as in the file, which poses keep only up to full turns; `None`
    /// for poses with quaternions or without rotation.
    pub angles: Option<Vec<[f64; 3]>>,
    /// Accuracies of the sensors, as far as known.
    pub sigmas: SensorSigmas,
}

/// Standard deviations of the sensors PER AXIS; `None` when unknown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SensorSigmas {
    /// Position of the platform, per axis (m).
    #[serde(rename = "position_m", skip_serializing_if = "Option::is_none")]
    pub position: Option<f64>,
    /// Orientation of the platform, per axis (rad).
    #[serde(rename = "rotation_rad", skip_serializing_if = "Option::is_none")]
    pub rotation: Option<f64>,
    /// Cable length (m).
    #[serde(rename = "length_m", skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    /// Tension (N).
    #[serde(rename = "tension_N", skip_serializing_if = "Option::is_none")]
    pub tension: Option<f64>,
    /// Swivel angle of a pulley (rad).
    #[serde(rename = "swivel_rad", skip_serializing_if = "Option::is_none")]
    pub swivel: Option<f64>,
    /// Factor that all recorded lengths may have in common (gear, spool, tape), as a share of it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub length_scale: Option<f64>,
    /// Force that cables and load may miss their equilibrium by: friction, masses (N).
    #[serde(rename = "balance_N", skip_serializing_if = "Option::is_none")]
    pub balance_force: Option<f64>,
    /// Moment that they may miss it by (N·m).
    #[serde(rename = "balance_Nm", skip_serializing_if = "Option::is_none")]
    pub balance_moment: Option<f64>,
}

/// Data sets that cannot be used, or not together.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum DataError {
    /// Every row is the same.
    #[error(
        "all {samples} samples are equal: one pose cannot tell parameters apart; record poses spread over the workspace"
    )]
    AllEqual {
        /// Number of samples.
        samples: usize,
    },
    /// No times for a log that is to be cut by them.
    #[error("poses at rest are found by time, and the samples have none (column t_s)")]
    NoTimes,
    /// Sets of different robots.
    #[error("the data sets have {first} and {second} cables; they must be of the same robot")]
    DifferentCables {
        /// Cables of the first.
        first: usize,
        /// Cables of the second.
        second: usize,
    },
    /// Lengths in one set, changes of length in the other.
    #[error("one data set has lengths, the other their changes from a common pose: they do not count from the same")]
    DifferentLengths,
}

impl Samples {
    /// Refuses data whose rows are all equal.
    pub fn check(&self) -> Result<(), DataError> {
        let samples = self.len();
        let same =
            |sample: usize| self.poses[sample] == self.poses[0] && self.recorded_of(sample) == self.recorded_of(0);
        if samples > 1 && (1..samples).all(same) {
            return Err(DataError::AllEqual { samples });
        }
        Ok(())
    }

    /// These samples followed by others; quantities that only one of the two has are dropped.
    pub fn followed_by(&self, other: &Self) -> Result<Self, DataError> {
        let (first, second) = (self.cable_count, other.cable_count);
        if first != second {
            return Err(DataError::DifferentCables { first, second });
        }
        let joined = |a: &Option<Vec<f64>>, b: &Option<Vec<f64>>| Some([a.as_deref()?, b.as_deref()?].concat());
        Ok(Self {
            poses: [self.poses.as_slice(), &other.poses].concat(),
            lengths: [self.lengths.as_slice(), &other.lengths].concat(),
            motor_angles: joined(&self.motor_angles, &other.motor_angles),
            tensions: joined(&self.tensions, &other.tensions),
            cable_count: first,
            set: None,
            time: joined(&self.time, &other.time),
            lines: self.lines.as_ref().zip(other.lines.as_ref()).map(|(a, b)| [a.as_slice(), b].concat()),
            appended: Some(
                (0..self.len()).map(|own| self.is_appended(own)).chain(other.poses.iter().map(|_| true)).collect(),
            ),
            angles: self.angles.as_ref().zip(other.angles.as_ref()).map(|(a, b)| [a.as_slice(), b].concat()),
            sigmas: self.sigmas,
        })
    }

    /// Motor angles of one sample (rad) if they were recorded, otherwise its lengths (m).
    fn recorded_of(&self, sample: usize) -> &[f64] {
        &self.motor_angles.as_ref().unwrap_or(&self.lengths)[sample * self.cable_count..][..self.cable_count]
    }

    /// True if a sample was appended from another record.
    pub fn is_appended(&self, sample: usize) -> bool {
        self.appended.as_ref().is_some_and(|appended| appended[sample])
    }

    /// The samples as those of another record than that of a fit: later ones, whose lines are of another file.
    #[must_use]
    pub fn of_another_record(self) -> Self {
        Self { appended: Some(vec![true; self.len()]), ..self }
    }

    /// Number of samples.
    pub fn len(&self) -> usize {
        self.poses.len()
    }

    /// True if there are no samples.
    pub fn is_empty(&self) -> bool {
        self.poses.is_empty()
    }

    /// Recorded lengths of one sample (m), m entries.
    pub fn lengths_of(&self, sample: usize) -> &[f64] {
        &self.lengths[sample * self.cable_count..][..self.cable_count]
    }

    /// The samples with these indices, in this order.
    #[must_use]
    pub fn subset(&self, indices: &[usize]) -> Self {
        let rows = |data: &[f64]| -> Vec<f64> {
            indices.iter().flat_map(|&i| data[i * self.cable_count..][..self.cable_count].to_vec()).collect()
        };
        Self {
            poses: indices.iter().map(|&i| self.poses[i]).collect(),
            lengths: rows(&self.lengths),
            motor_angles: self.motor_angles.as_deref().map(rows),
            tensions: self.tensions.as_deref().map(rows),
            cable_count: self.cable_count,
            set: self.set.as_ref().map(|set| indices.iter().map(|&i| set[i].clone()).collect()),
            time: self.time.as_ref().map(|time| indices.iter().map(|&i| time[i]).collect()),
            lines: self.lines.as_ref().map(|lines| indices.iter().map(|&i| lines[i]).collect()),
            appended: self.appended.as_ref().map(|appended| indices.iter().map(|&i| appended[i]).collect()),
            angles: self.angles.as_ref().map(|angles| indices.iter().map(|&i| angles[i]).collect()),
            sigmas: self.sigmas,
        }
    }
}
