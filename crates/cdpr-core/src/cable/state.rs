//! State of one cable at rest: lengths, tensions and pull, with all their derivatives.

use core::fmt;

use nalgebra::Matrix6;
use thiserror::Error;

use super::span;
use super::wrench::{CableEnd, wrench, wrench_by_pose};
use crate::geometry::{Twist, Wrench};
use crate::scalar::{add, cross, dot, rotate, scale};

/// Quantity that determines a cable together with the position of its end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum CableInput {
    /// q_θ (m).
    ControlledLength(f64),
    /// Tension at the outlet, where robots measure it (N).
    OutletTension(f64),
    /// Tension at the platform anchor (N).
    PlatformTension(f64),
}

/// Calibration of the length and tension that a robot records of a cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recording {
    /// Scale of recorded lengths.
    pub length_scale: f64,
    /// Offset of recorded lengths (m).
    pub length_offset: f64,
    /// Scale of recorded tensions.
    pub tension_scale: f64,
    /// Offset of recorded tensions (N).
    pub tension_offset: f64,
}

impl Recording {
    /// The robot records lengths and tensions as they are.
    pub const EXACT: Self = Self { length_scale: 1.0, length_offset: 0.0, tension_scale: 1.0, tension_offset: 0.0 };

    /// Length that the robot records for a controlled length: length_scale · q_θ + length_offset (m).
    #[inline]
    pub fn length(&self, controlled_length: f64) -> f64 {
        self.length_scale * controlled_length + self.length_offset
    }

    /// Controlled length of a recorded length (m).
    #[inline]
    pub fn controlled_length(&self, recorded: f64) -> f64 {
        (recorded - self.length_offset) / self.length_scale
    }

    /// Tension that the robot records for a real one: tension_scale · f + tension_offset (N).
    #[inline]
    pub fn tension(&self, tension: f64) -> f64 {
        self.tension_scale * tension + self.tension_offset
    }

    /// Real tension of a recorded tension (N).
    #[inline]
    pub fn real_tension(&self, recorded: f64) -> f64 {
        (recorded - self.tension_offset) / self.tension_scale
    }
}

/// A cable of any law at rest between its outlet and its end on the platform.
///
/// Derivatives at fixed tension keep the tension at the outlet. Derivatives at fixed controlled length are not finite
/// for straight, rigid cables and zero for straight, slack ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CableState {
    /// Platform anchor and moment arm b (world, m).
    pub end: CableEnd<f64>,
    /// Calibration of the recorded length and tension.
    pub recording: Recording,
    /// True if the tension that determines the cable is given at the platform anchor.
    pub is_given_at_platform: bool,
    /// F and L; for a straight cable F is f times the direction away from the outlet and L its unstrained free length.
    pub span: span::SpanState<f64>,
    /// q_θ (m).
    pub controlled_length: f64,
    /// Pull t on the platform (world, N).
    pub pull: [f64; 3],
    /// Unit vector of the pull at the platform anchor, along the cable's end tangent; defined for slack straight cables
    /// too.
    pub direction: [f64; 3],
    /// Tension at the outlet (N).
    pub outlet_tension: f64,
    /// Tension at the platform anchor (N).
    pub platform_tension: f64,
    /// Wrap angle (rad).
    pub wrap_angle: f64,
    /// Strained length from the frame anchor, wrapped part included (m).
    pub strained_length: f64,
    /// ∂t/∂p_B at fixed q_θ, by rows (N/m).
    pub tangent: [[f64; 3]; 3],
    /// ∂t/∂p_B at fixed tension, by rows (N/m).
    pub tangent_at_tension: [[f64; 3]; 3],
    /// ∂t/∂q_θ at fixed p_B (N/m).
    pub by_controlled_length: [f64; 3],
    /// ∂t/∂T by the tension at the outlet, at fixed p_B.
    pub by_tension: [f64; 3],
    /// ∂q_θ/∂T by the tension at the outlet, at fixed p_B (m/N).
    pub controlled_length_by_tension: f64,
    /// ∂q_θ/∂p_B at fixed tension.
    pub controlled_length_by_anchor: [f64; 3],
}

/// Reason for which a cable has no state at this input.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum CableStateError {
    /// A cable that does not stretch is shorter than the distance it has to span.
    #[error(
        "the controlled length {controlled_length:.6} m is shorter than the chord allows: without stretch at least {least:.6} m \
         are needed to reach the platform anchor; give the cable a stiffness, or pay out more"
    )]
    TooShort {
        /// q_θ (m).
        controlled_length: f64,
        /// Least length (m).
        least: f64,
    },
    /// The tension is below the least tension of a cable of this weight at this pose.
    #[error(
        "a tension of {tension:.3} N is less than the cable's own weight leaves: at this pose its outlet carries {least:.3} N at \
         least"
    )]
    TensionTooLow {
        /// Required tension (N).
        tension: f64,
        /// Least tension (N).
        least: f64,
    },
    /// The tension is so large that the law of stretch leaves no positive controlled length.
    #[error("a tension of {tension:.3} N stretches the cable from a controlled length below zero")]
    Overstretched {
        /// Tension (N).
        tension: f64,
    },
    /// The cable runs along the swivel axis of its pulley, or its anchor lies inside.
    #[error("the cable has no unique course over its pulley")]
    NoCourse,
    /// The iteration ended without an answer.
    #[error("no shape of the cable was found after {iterations} steps: {}", Missing(*.gap))]
    NotConverged {
        /// Steps tried, those of all searches.
        iterations: u32,
        /// Length still missing (m); NaN where numbers overflowed.
        gap: f64,
    },
}

/// Gap left by an iteration, for display (m).
struct Missing(f64);

impl fmt::Display for Missing {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0.is_finite() {
            true => write!(formatter, "{:.3e} m are missing", self.0),
            false => formatter.write_str(
                "its forces and lengths are too large to calculate with; check the units of tensions (N) and lengths (m)",
            ),
        }
    }
}

impl CableStateError {
    /// True if numbers overflowed: the input, not the cable, is at fault.
    #[inline]
    pub fn is_overflow(&self) -> bool {
        matches!(self, Self::NotConverged { gap, .. } if !gap.is_finite())
    }
}

impl CableState {
    /// Returns the state, or `Overstretched` if its controlled length is not positive.
    #[inline]
    pub fn unless_overstretched(self) -> Result<Self, CableStateError> {
        // written so that NaN is refused too
        match self.controlled_length > 0.0 {
            true => Ok(self),
            false => Err(CableStateError::Overstretched { tension: self.given_tension() }),
        }
    }

    /// Wrench on the platform, \[t; b × t\] (N, N·m).
    #[inline]
    pub fn wrench(&self) -> Wrench {
        self.wrench_of(self.pull)
    }

    /// Change of the wrench with the tension at the end where it is given, at a fixed pose: for a straight cable the
    /// column \[u; b × u\] of the structure matrix.
    #[inline]
    pub fn wrench_by_tension(&self) -> Wrench {
        self.wrench_of(match self.is_given_at_platform {
            true => scale(self.outlet_by_given_tension(), self.by_tension),
            false => self.by_tension,
        })
    }

    /// Change of the wrench with the controlled length, at a fixed pose (N/m, N).
    #[inline]
    pub fn wrench_by_controlled_length(&self) -> Wrench {
        self.wrench_of(self.by_controlled_length)
    }

    /// Wrench \[v; b × v\] of a change v of the pull.
    #[inline]
    pub fn wrench_of(&self, pull: [f64; 3]) -> Wrench {
        wrench(self.end.moment_arm, pull).into()
    }

    /// −∂\[t; b × t\]/∂\[δr; δφ\] at fixed controlled length.
    #[inline]
    pub fn stiffness(&self) -> Matrix6<f64> {
        -matrix(&wrench_by_pose(&self.tangent, self.end.moment_arm, self.pull))
    }

    /// ∂\[t; b × t\]/∂\[δr; δφ\] at fixed tension at the outlet: the cable's contribution to K_G.
    #[inline]
    pub fn wrench_by_pose(&self) -> Matrix6<f64> {
        matrix(&wrench_by_pose(&self.tangent_at_tension, self.end.moment_arm, self.pull))
    }

    /// [`CableState::wrench_by_pose`] at fixed tension at the end where it is given.
    #[inline]
    pub fn wrench_by_pose_at_given(&self) -> Matrix6<f64> {
        match self.is_given_at_platform {
            true => matrix(&wrench_by_pose(&self.tangent_at_given(), self.end.moment_arm, self.pull)),
            false => self.wrench_by_pose(),
        }
    }

    fn tangent_at_given(&self) -> [[f64; 3]; 3] {
        let tangent = &self.tangent_at_tension;
        let more = [0, 1, 2].map(|k| self.outlet_change([tangent[0][k], tangent[1][k], tangent[2][k]]));
        [0, 1, 2].map(|row| [0, 1, 2].map(|column| tangent[row][column] + self.by_tension[row] * more[column]))
    }

    /// ∂q_θ/∂\[δr; δφ\] at fixed tension at the outlet, as a row.
    #[inline]
    pub fn controlled_length_by_pose(&self) -> Twist {
        self.wrench_of(self.controlled_length_by_anchor)
    }

    /// Change of the recorded length (m) along a twist of the platform, at fixed tension at the end where it is given.
    #[inline]
    pub fn recorded_length_by_twist(&self, twist: &Twist) -> f64 {
        let at_outlet = self.controlled_length_by_pose().dot(twist);
        let more = match self.is_given_at_platform {
            true => {
                let turn = cross([twist[3], twist[4], twist[5]], self.end.moment_arm);
                self.outlet_change(rotate(&self.tangent_at_tension, add([twist[0], twist[1], twist[2]], turn)))
            }
            false => 0.0,
        };
        self.recording.length_scale * (at_outlet + self.controlled_length_by_tension * more)
    }

    /// Change of wrench and recorded length with a change of the tension at the end where it is given (N).
    #[inline]
    pub fn by_given_tension(&self, change: f64) -> (Wrench, f64) {
        let at_outlet = if self.is_given_at_platform { self.outlet_by_given_tension() } else { 1.0 };
        let length = self.recording.length_scale * self.controlled_length_by_tension * at_outlet * change;
        (self.wrench_by_tension() * change, length)
    }

    /// Tension at the end where it is given (N).
    #[inline]
    pub fn given_tension(&self) -> f64 {
        if self.is_given_at_platform { self.platform_tension } else { self.outlet_tension }
    }

    /// Change of the tension at the outlet per change of the tension at the platform, at a fixed pose.
    fn outlet_by_given_tension(&self) -> f64 {
        1.0 / dot(self.direction, self.by_tension)
    }

    /// Change of the outlet tension (N) that keeps the platform tension when the pull changes by `pull` at fixed outlet
    /// tension.
    fn outlet_change(&self, pull: [f64; 3]) -> f64 {
        -dot(self.direction, pull) * self.outlet_by_given_tension()
    }

    /// Changes of the pull (N) and the recorded length (m) at the end where the tension is given, from changes of the
    /// pull and the controlled length at fixed outlet tension.
    #[inline]
    pub fn at_given(&self, pull: [f64; 3], controlled_length: f64) -> ([f64; 3], f64) {
        let scale_of_length = self.recording.length_scale;
        if !self.is_given_at_platform {
            return (pull, scale_of_length * controlled_length);
        }
        let more = self.outlet_change(pull);
        let pull = [0, 1, 2].map(|k| pull[k] + self.by_tension[k] * more);
        (pull, scale_of_length * (controlled_length + self.controlled_length_by_tension * more))
    }

    /// [`CableState::at_given`] for a motion of the platform anchor along a direction (world).
    #[inline]
    pub fn by_anchor(&self, direction: [f64; 3]) -> ([f64; 3], f64) {
        let pull = rotate(&self.tangent_at_tension, direction);
        self.at_given(pull, dot(self.controlled_length_by_anchor, direction))
    }
}

/// A matrix given by its rows.
#[inline]
fn matrix(rows: &[[f64; 6]; 6]) -> Matrix6<f64> {
    Matrix6::from_fn(|row, column| rows[row][column])
}
