//! Winches between a control model's lengths and a machine's: lengths sent, motor angles, lengths paid out.

use super::input_error::InputError;
use crate::cable::winch::{DrumLength, GrooveError, Winch};
use crate::measurement::Samples;
use crate::model::{Model, WinchError};

/// Conversion of a control model's recorded lengths by motor angles to those of a machine, and back.
///
/// A model without the effect `drum` has ideal winches, with a length linear in the angle and the radius of its own
/// file, or else that of the other. If neither has the effect, lengths are not converted.
#[derive(Clone, Debug)]
pub struct Winding {
    control: Model,
    /// Winches of control model and machine, cable by cable; empty if lengths are not converted.
    winches: Vec<[Winch; 2]>,
}

/// Derivative of the length that a machine pays out by the one that its control model sends.
pub struct WindingGradient {
    /// Change of the length paid out per metre sent.
    pub by_sent: f64,
    /// The control model's drum at the angle sent.
    pub control: DrumLength,
    /// The machine's drum at that angle.
    pub machine: DrumLength,
}

impl Winding {
    /// The winches of control model and machine; an error if numbers of a drum are missing.
    pub fn new(control: &Model, machine: &Model) -> Result<Self, InputError> {
        if !control.composition().drum && !machine.composition().drum {
            return Ok(Self { control: control.clone(), winches: Vec::new() });
        }
        let winch = |model: &Model, other: &Model, cable: usize| {
            let ideal_of_other = || Winch::ideal(&other.robot().cables[cable]).and_then(Result::ok);
            model.winch(cable).cloned().or_else(ideal_of_other).ok_or_else(|| WinchError::NoRadius {
                cable: cable + 1,
                name: model.robot().cables[cable].name.clone(),
            })
        };
        let pair = |cable| Ok([winch(control, machine, cable)?, winch(machine, control, cable)?]);
        let winches = (0..control.cable_count()).map(pair).collect::<Result<_, WinchError>>()?;
        Ok(Self { control: control.clone(), winches })
    }

    /// True without the effect `drum` on either side: lengths paid out are those sent.
    pub(super) fn is_none(&self) -> bool {
        self.winches.is_empty()
    }

    /// Lengths that the machine pays out for these sent lengths (m).
    pub(super) fn to_machine(&self, sent: &[f64]) -> Result<Vec<f64>, WinchError> {
        self.convert(sent, |[control, machine], length| machine.controlled_length(control.motor_angle(length)?))
    }

    /// Derivatives of the lengths that the machine pays out, cable by cable; `None` if they are those sent.
    pub fn gradients(&self, sent: &[f64]) -> Result<Option<Vec<WindingGradient>>, GrooveError> {
        if self.winches.is_empty() {
            return Ok(None);
        }
        let one = |([control, machine], &length): (&[Winch; 2], &f64)| {
            let angle = control.motor_angle(length)?;
            let control_drum = control.drum.gradient(angle / control.gear_ratio)?;
            let machine_drum = machine.drum.gradient(angle / machine.gear_ratio)?;
            // δq = ∂q_M/∂θ δθ/g_M with δθ = g_C δ(sent)/(∂q_C/∂θ)
            let per_angle = machine_drum.by_angle / machine.gear_ratio;
            let by_sent = per_angle * control.gear_ratio / control_drum.by_angle;
            Ok(WindingGradient { by_sent, control: control_drum, machine: machine_drum })
        };
        self.winches.iter().zip(sent).map(one).collect::<Result<_, _>>().map(Some)
    }

    /// Lengths by the control model's winches when the machine has paid out these (m).
    pub(super) fn to_control(&self, paid_out: &[f64]) -> Result<Vec<f64>, WinchError> {
        self.convert(paid_out, |[control, machine], length| control.controlled_length(machine.motor_angle(length)?))
    }

    /// Motor angles at which the control model sends these lengths (rad).
    fn motor_angles(&self, sent: &[f64]) -> Result<Vec<f64>, WinchError> {
        self.convert(sent, |[control, _], length| control.motor_angle(length))
    }

    fn convert(
        &self,
        lengths: &[f64],
        through: impl Fn(&[Winch; 2], f64) -> Result<f64, GrooveError>,
    ) -> Result<Vec<f64>, WinchError> {
        if self.winches.is_empty() {
            return Ok(lengths.to_vec());
        }
        let name = |cable: usize| self.control.robot().cables[cable].name.clone();
        let one = |(cable, &length): (usize, &f64)| {
            let converted = through(&self.winches[cable], length);
            converted.map_err(|reason| WinchError::Groove { cable: cable + 1, name: name(cable), reason })
        };
        lengths.iter().enumerate().map(one).collect()
    }
}

/// Simulated samples with the motor angles for the sent lengths instead of the lengths.
///
/// One of the two models must have the effect `drum`: without it winches are commanded by lengths.
pub fn with_motor_angles(control: &Model, machine: &Model, samples: &Samples) -> Result<Samples, InputError> {
    let winding = Winding::new(control, machine)?;
    if winding.winches.is_empty() {
        return Err(InputError::NoDrum);
    }
    let rows = samples.lengths.chunks(samples.cable_count.max(1));
    let angles: Vec<Vec<f64>> = rows.map(|lengths| winding.motor_angles(lengths)).collect::<Result<_, _>>()?;
    Ok(Samples { motor_angles: Some(angles.concat()), ..samples.clone() })
}
