//! Correction of a map at one pose, and numbers of poses at which it does not act fully.

use super::map_error::MapError;

/// Fraction from which on a map counts as acting fully, to allow for rounding.
const WHOLE: f64 = 1.0 - 1e-9;

/// Correction of a map at a pose.
#[derive(Clone, Debug, PartialEq)]
pub struct Correction {
    /// Lengths to add to the model's recorded ones, cable by cable (m); zeros beyond the margin.
    pub lengths: Vec<f64>,
    /// Fraction of the map that acts at the pose: 1 among its samples, falling over the margin to 0.
    pub fraction: f64,
    /// Reason that it does not act fully; `None` among the samples.
    pub reason: Option<String>,
}

impl Correction {
    /// The correction; an error beyond the margin, where the map has none.
    pub fn known(self) -> Result<Self, MapError> {
        match self.reason {
            Some(reason) if self.fraction == 0.0 => Err(MapError::Outside { reason }),
            _ => Ok(self),
        }
    }

    /// Lengths to send: modelled ones plus the correction (m).
    pub fn added_to(&self, modelled: &[f64]) -> Vec<f64> {
        modelled.iter().zip(&self.lengths).map(|(length, own)| length + own).collect()
    }

    /// Lengths of the model for recorded ones: without the correction (m).
    pub fn taken_from(&self, recorded: &[f64]) -> Vec<f64> {
        recorded.iter().zip(&self.lengths).map(|(length, own)| length - own).collect()
    }
}

/// Numbers of poses at which a map does not act fully.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Beyond {
    /// Number of poses beyond its margin, where only the model acts.
    pub outside: usize,
    /// Number of poses in its margin, where it fades.
    pub fading: usize,
}

impl Beyond {
    /// Counts poses by the fraction of the map that acts at each.
    pub fn of(fractions: impl Iterator<Item = f64>) -> Self {
        fractions.fold(Self::default(), |counts, fraction| Self {
            outside: counts.outside + usize::from(fraction == 0.0),
            fading: counts.fading + usize::from(fraction > 0.0 && fraction < WHOLE),
        })
    }

    /// Sum of both counts.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self { outside: self.outside + other.outside, fading: self.fading + other.fading }
    }
}
