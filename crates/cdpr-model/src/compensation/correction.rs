//! Correction of a map at one pose, and counts of poses at which it is not the whole.

use serde::Serialize;

use super::map_error::MapError;

/// Share from which a map acts as a whole: rounding makes less of 1.
const WHOLE: f64 = 1.0 - 1e-9;

/// Correction of a map at a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Correction {
    /// Lengths to add to the recorded ones of the model, cable by cable (m); zeros beyond the margin.
    pub lengths: Vec<f64>,
    /// Share of the map that acts at the pose: 1 among its samples, falling over the margin to 0.
    pub fraction: f64,
    /// Reason why it is not the whole; nothing among the samples.
    pub reason: Option<String>,
}

impl Correction {
    /// The same; an error beyond the margin, where the map says nothing.
    pub fn known(self) -> Result<Self, MapError> {
        match self.reason {
            Some(reason) if self.fraction == 0.0 => Err(MapError::Outside { reason }),
            _ => Ok(self),
        }
    }

    /// Lengths to send: modelled ones and the correction (m).
    pub fn added_to(&self, modelled: &[f64]) -> Vec<f64> {
        modelled.iter().zip(&self.lengths).map(|(length, own)| length + own).collect()
    }

    /// Lengths that the model has where these are recorded (m).
    pub fn taken_from(&self, recorded: &[f64]) -> Vec<f64> {
        recorded.iter().zip(&self.lengths).map(|(length, own)| length - own).collect()
    }
}

/// Poses at which a map does not act as a whole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Beyond {
    /// Poses beyond its margin, where the model stands alone.
    pub outside: usize,
    /// Poses in its margin, where it fades.
    pub fading: usize,
}

impl Beyond {
    /// Counts of poses by the share of the map that acts at each.
    pub fn of(fractions: impl Iterator<Item = f64>) -> Self {
        fractions.fold(Self::default(), |counts, fraction| Self {
            outside: counts.outside + usize::from(fraction == 0.0),
            fading: counts.fading + usize::from(fraction > 0.0 && fraction < WHOLE),
        })
    }

    /// Counts of both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self { outside: self.outside + other.outside, fading: self.fading + other.fading }
    }
}
