//! The drum of a winch in the world: conversion between drum angle and controlled length, layer by layer, within its
//! groove.

use nalgebra::Vector3;
use thiserror::Error;

use super::layers::{Layer, layers};
use super::parameters::{DrumLength, Mounting, Parameters};

/// The path of a cable between drum and first pulley.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Departure {
    /// Point at which the cable leaves the drum (world, m).
    pub contact: Vector3<f64>,
    /// Length of the free part s (m).
    pub free_length: f64,
    /// Angle of the free part to the plane across the drum's axis (rad), positive if the pulley lies ahead along
    /// `axis`; grooves hold a cable up to about 0.03 to 0.06 rad.
    pub fleet_angle: f64,
}

/// Numbers that make no drum.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum DrumError {
    /// The pulley lies inside the drum.
    #[error(
        "the first pulley is {distance} m from the drum's axis, inside the drum of radius {radius} m; mend drum_position_m, drum_axis or drum_radius_m"
    )]
    PulleyInside {
        /// Distance of the pulley from the axis (m).
        distance: f64,
        /// Radius (m).
        radius: f64,
    },
    /// A number outside its range.
    #[error("{key} is {value}; {needed}")]
    Number {
        /// The robot-file key.
        key: &'static str,
        /// The value.
        value: f64,
        /// Allowed range, in words.
        needed: &'static str,
    },
}

/// A controlled length outside the range of the drum's groove.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error(
    "{}, but {needed:.4} m is needed; {}", held(*.available, *.shortest, *.longest), mend(*.shortest)
)]
pub struct GrooveError {
    /// Length of cable that the groove holds in its first layer, or the spool from the start on (m).
    pub available: f64,
    /// Least controlled length that it allows (m).
    pub shortest: f64,
    /// Largest controlled length that it allows (m).
    pub longest: f64,
    /// The requested controlled length (m).
    pub needed: f64,
}

/// Length of cable that a drum holds, in words.
fn held(available: f64, shortest: f64, longest: f64) -> String {
    match shortest.is_finite() {
        true => format!(
            "the drum's groove holds {available:.4} m of cable, enough for controlled lengths from {shortest:.4} to {longest:.4} m"
        ),
        false => format!(
            "the spool holds {available:.4} m of cable from its start on, enough for controlled lengths up to {longest:.4} m"
        ),
    }
}

/// Advice for a drum that holds too little cable.
fn mend(shortest: f64) -> &'static str {
    match shortest.is_finite() {
        true => {
            "use a longer groove (drum_groove_length_m), further layers (drum_layer_height_m) or another drum_start_length_m"
        }
        false => "mend drum_radius_m, spool_build_up_m, mechanical_advantage or drum_start_length_m",
    }
}

/// A drum with valid numbers: both directions of its law.
#[derive(Clone, Debug, PartialEq)]
pub struct Drum {
    parameters: Parameters,
    /// The first layer, and those above it.
    layers: Vec<Layer>,
}

impl Drum {
    /// The drum with these numbers; an error if they make no drum.
    pub fn new(parameters: Parameters) -> Result<Self, DrumError> {
        parameters.check()?;
        Ok(Self { layers: layers(&parameters), parameters })
    }

    /// The numbers of the drum.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    /// Length of cable that the first layer holds (m); `None` for a groove without ends.
    pub(crate) fn capacity(&self) -> Option<f64> {
        let (_, longest) = self.lengths()?;
        Some(longest - self.parameters.start_length)
    }

    /// Least and largest controlled length that the groove allows (m); `None` for a groove without ends.
    pub(crate) fn lengths(&self) -> Option<(f64, f64)> {
        let (first, last) = (self.layers.first()?, self.layers.last()?);
        let longest = first.empty().length;
        longest.is_finite().then(|| (self.geared_down(last.full().length), self.geared_down(longest)))
    }

    /// Controlled length at a drum angle (rad → m).
    #[inline]
    pub fn length(&self, angle: f64) -> Result<f64, GrooveError> {
        Ok(self.geared_down(self.layer_of_angle(angle)?.length(angle)))
    }

    /// [`Drum::length`] with its derivatives.
    pub fn gradient(&self, angle: f64) -> Result<DrumLength, GrooveError> {
        let Parameters { start_length, advantage, .. } = self.parameters;
        Ok(self.layer_of_angle(angle)?.gradient(angle).geared_down(start_length, advantage))
    }

    /// Drum angle at a controlled length (m → rad): the exact inverse of [`Drum::length`].
    #[inline]
    pub fn angle(&self, length: f64) -> Result<f64, GrooveError> {
        let Parameters { start_length, advantage, .. } = self.parameters;
        let wound = start_length + advantage * (length - start_length);
        // lengths and angles decrease together from layer to layer
        let within = |layer: &&Layer| wound >= layer.full().length;
        match self.layers.iter().find(within) {
            Some(layer) if wound <= layer.empty().length => Ok(layer.angle(wound)),
            _ => Err(self.refuse(length)),
        }
    }

    /// Contact point, free length and fleet angle between drum and first pulley at a drum angle (rad); `None` with a
    /// guide.
    pub fn departure(&self, angle: f64) -> Result<Option<Departure>, GrooveError> {
        let layer = self.layer_of_angle(angle)?;
        let departure = |mounting: Mounting| {
            let (radius, along) = (layer.turns.radius, layer.along(angle));
            let (distance, place) = mounting.pulley_from_axis();
            let tangent_squared = distance * distance - radius * radius;
            let ahead = place - along;
            let towards = (mounting.pulley - mounting.position - mounting.axis * place) / distance;
            let left = towards.cross(&mounting.axis) * mounting.side.sign();
            // tangent point of the circle: its radius makes the angle arccos(r/d) with the direction to the pulley
            let cosine = radius / distance;
            let spoke = towards * cosine + left * (1.0 - cosine * cosine).sqrt();
            Departure {
                contact: mounting.position + mounting.axis * along + spoke * radius,
                free_length: (tangent_squared + ahead * ahead).sqrt(),
                fleet_angle: ahead.atan2(tangent_squared.sqrt()),
            }
        };
        Ok(self.parameters.mounting.map(departure))
    }

    /// Controlled length for a length of cable on the drum, both counted from the start (m).
    #[inline]
    fn geared_down(&self, wound: f64) -> f64 {
        let Parameters { start_length, advantage, .. } = self.parameters;
        // tackle is rare: without it the number keeps its bits
        if advantage == 1.0 { wound } else { start_length + (wound - start_length) / advantage }
    }

    #[inline]
    fn layer_of_angle(&self, angle: f64) -> Result<&Layer, GrooveError> {
        let within = |layer: &&Layer| angle >= layer.full().angle;
        let nearest = || if self.layers[0].empty().angle < angle { self.layers.first() } else { self.layers.last() };
        match self.layers.iter().find(within) {
            Some(layer) if angle <= layer.empty().angle => Ok(layer),
            _ => Err(self.refuse(nearest().map_or(f64::NAN, |layer| self.geared_down(layer.length(angle))))),
        }
    }

    fn refuse(&self, needed: f64) -> GrooveError {
        let (shortest, longest) = self.lengths().unwrap_or((f64::NEG_INFINITY, f64::INFINITY));
        GrooveError { available: self.capacity().unwrap_or(f64::INFINITY), shortest, longest, needed }
    }
}

impl Mounting {
    /// Distance of the first pulley from the drum's axis, and its position along the axis from `position` (m).
    pub(super) fn pulley_from_axis(&self) -> (f64, f64) {
        let from = self.pulley - self.position;
        let place = self.axis.dot(&from);
        ((from - self.axis * place).norm(), place)
    }
}

impl Parameters {
    fn check(&self) -> Result<(), DrumError> {
        let number = |key, value: f64, fine: bool, needed| match fine && value.is_finite() {
            true => Ok(()),
            false => Err(DrumError::Number { key, value, needed }),
        };
        // for a smaller one not even the turns can be counted
        number("drum_radius_m", self.radius, self.radius >= 1e-30, "the radius of a drum is above zero")?;
        number("drum_pitch_m", self.pitch, self.pitch >= 0.0, "the pitch of a groove is zero or above")?;
        number("drum_start_angle_rad", self.start_angle, true, "it must be a finite number")?;
        number("drum_start_length_m", self.start_length, true, "it must be a finite number")?;
        if let Some(length) = self.groove_length {
            number("drum_groove_length_m", length, length > 0.0, "the length of a groove is above zero")?;
            number("drum_pitch_m", self.pitch, self.pitch > 0.0, "a groove with a length needs a pitch above zero")?;
        }
        if let Some(height) = self.layer_height {
            number("drum_layer_height_m", height, height > 0.0, "the height of a layer is above zero")?;
        }
        number("spool_build_up_m", self.build_up, self.build_up >= 0.0, "a spool that gains cable grows")?;
        number("mechanical_advantage", self.advantage, self.advantage > 0.0, "it is a ratio above zero")?;
        let Some(mounting) = self.mounting else { return Ok(()) };
        let norm = mounting.axis.norm();
        number("drum_axis", norm, (norm - 1.0).abs() < 1e-6, "the axis is a direction, of length 1")?;
        let (distance, _) = mounting.pulley_from_axis();
        // written so that NaN is refused too
        if !(distance.is_finite() && distance > self.radius) {
            return Err(DrumError::PulleyInside { distance, radius: self.radius });
        }
        Ok(())
    }
}
