//! Motor angles of a model: conversion to and from controlled and recorded lengths.

use std::borrow::Cow;

use thiserror::Error;

use super::Model;
use crate::cable::winch::{DrumLength, GrooveError, Winch};
use crate::measurement::Samples;
use crate::robot::{Parameter, ParameterKind};

/// Motor angles that a model cannot convert to lengths.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum WinchError {
    /// No radius is known, so that there is not even an ideal winch.
    #[error(
        "motor angles need `drum_radius_m`, which cable {cable} (\"{name}\") does not have; add the key to its [[cable]] table, or give lengths"
    )]
    NoRadius {
        /// Number of the cable, from 1.
        cable: usize,
        /// Name of the cable.
        name: String,
    },
    /// The length or angle is outside the range of the groove.
    #[error("cable {cable} (\"{name}\"): {reason}")]
    Groove {
        /// Number of the cable, from 1.
        cable: usize,
        /// Name of the cable.
        name: String,
        /// Length or angle beyond the groove, with the range that it holds.
        reason: GrooveError,
    },
    /// Not one angle per cable.
    #[error("{found} motor angles are given, the robot has {expected} cables: give one per cable")]
    Count {
        /// Cables of the robot.
        expected: usize,
        /// Angles given.
        found: usize,
    },
}

impl Model {
    /// The winch of one cable (0-based): its drum in a model with the effect `drum`, otherwise an ideal winch of the
    /// drum's radius; `None` if the robot states no radius.
    pub fn winch(&self, cable: usize) -> Option<&Winch> {
        self.winches()[cable].as_ref()
    }

    /// Motor angle at which one cable (0-based) has this controlled length (m → rad).
    ///
    /// Drum angles correspond to recorded lengths, length_scale · q_θ + length_offset: calibrated scale and offset
    /// apply to robots that record angles as to those that record lengths. Without the effect `drum` the winch is an
    /// ideal one.
    pub fn motor_angle(&self, cable: usize, controlled_length: f64) -> Result<f64, WinchError> {
        self.recorded_motor_angle(cable, self.recorded_length(cable, controlled_length))
    }

    /// Controlled length at a motor angle: the inverse of [`Model::motor_angle`] (rad → m).
    pub fn controlled_length_of_motor_angle(&self, cable: usize, motor_angle: f64) -> Result<f64, WinchError> {
        Ok(self.controlled_length(cable, self.recorded_length_of_motor_angle(cable, motor_angle)?))
    }

    /// Controlled lengths at motor angles, one per cable (rad → m).
    pub fn controlled_lengths_of_motor_angles(&self, motor_angles: &[f64]) -> Result<Vec<f64>, WinchError> {
        let (expected, found) = (self.cable_count(), motor_angles.len());
        if expected != found {
            return Err(WinchError::Count { expected, found });
        }
        let length = |(cable, &angle): (usize, &f64)| self.controlled_length_of_motor_angle(cable, angle);
        motor_angles.iter().enumerate().map(length).collect()
    }

    /// The samples with the lengths of this model's winches at the recorded motor angles; unchanged if lengths were
    /// recorded.
    pub fn with_lengths<'s>(&self, samples: &'s Samples) -> Result<Cow<'s, Samples>, WinchError> {
        let Some(angles) = samples.motor_angles.as_ref().filter(|_| samples.cable_count == self.cable_count()) else {
            return Ok(Cow::Borrowed(samples));
        };
        let length =
            |(index, &angle): (usize, &f64)| self.recorded_length_of_motor_angle(index % samples.cable_count, angle);
        let lengths = angles.iter().enumerate().map(length).collect::<Result<_, _>>()?;
        Ok(Cow::Owned(Samples { lengths, ..samples.clone() }))
    }

    /// Motor angle at a recorded length (m → rad).
    pub(crate) fn recorded_motor_angle(&self, cable: usize, recorded_length: f64) -> Result<f64, WinchError> {
        let winch = self.known_winch(cable)?;
        winch.motor_angle(recorded_length).map_err(|reason| self.groove(cable, reason))
    }

    /// Recorded length at a motor angle (rad → m).
    pub(crate) fn recorded_length_of_motor_angle(&self, cable: usize, motor_angle: f64) -> Result<f64, WinchError> {
        let winch = self.known_winch(cable)?;
        winch.controlled_length(motor_angle).map_err(|reason| self.groove(cable, reason))
    }

    /// `Model::recorded_length_of_motor_angle` with its derivatives by the drum.
    pub fn motor_angle_gradient(&self, cable: usize, motor_angle: f64) -> Result<DrumLength, WinchError> {
        let winch = self.known_winch(cable)?;
        winch.drum.gradient(motor_angle / winch.gear_ratio).map_err(|reason| self.groove(cable, reason))
    }

    /// Derivative of a drum's length at a fixed angle by a parameter of its cable.
    pub fn by_winch_parameter(&self, drum: &DrumLength, parameter: &Parameter) -> f64 {
        match parameter.kind {
            ParameterKind::DrumRadius => drum.by_radius,
            ParameterKind::DrumPitch => drum.by_pitch,
            ParameterKind::SpoolBuildUp => drum.by_build_up,
            ParameterKind::StartLength => drum.by_start_length,
            ParameterKind::StartAngle => -drum.by_angle,
            ParameterKind::DrumAxis => {
                let turned = parameter.turned_axis(self.robot());
                turned.map_or(0.0, |(axis, about)| drum.by_axis.dot(&axis.by_turn_about(&about)))
            }
            // the first pulley moves with the anchor
            ParameterKind::FrameAnchor if self.robot().cables[parameter.cable].winch.first_pulley.is_none() => {
                drum.by_pulley.dot(&self.axes()[parameter.axis])
            }
            _ => 0.0,
        }
    }

    fn known_winch(&self, cable: usize) -> Result<&Winch, WinchError> {
        let name = || self.robot().cables[cable].name.clone();
        self.winch(cable).ok_or_else(|| WinchError::NoRadius { cable: cable + 1, name: name() })
    }

    fn groove(&self, cable: usize, reason: GrooveError) -> WinchError {
        WinchError::Groove { cable: cable + 1, name: self.robot().cables[cable].name.clone(), reason }
    }
}
