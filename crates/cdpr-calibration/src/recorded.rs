//! Record of one sample: lengths, or motor angles from which a model's drums make them, and tensions.

use cdpr_model::cable::winch::DrumLength;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;

/// Recorded lengths and tensions of one sample's cables, with the motor angles.
#[derive(Clone, Copy)]
pub(super) struct Recorded<'a> {
    /// Lengths (m).
    lengths: &'a [f64],
    /// Motor angles that the lengths come from (rad).
    motor_angles: Option<&'a [f64]>,
    /// Tensions (N); empty where none are recorded.
    tensions: &'a [f64],
}

impl<'a> Recorded<'a> {
    pub(super) fn of(samples: &'a Samples, sample: usize) -> Self {
        let row = |values: &'a Vec<f64>| &values[sample * samples.cable_count..][..samples.cable_count];
        Self {
            lengths: samples.lengths_of(sample),
            motor_angles: samples.motor_angles.as_ref().map(row),
            tensions: samples.tensions.as_ref().map(row).unwrap_or_default(),
        }
    }

    #[cfg(test)]
    pub(super) fn lengths(lengths: &'a [f64]) -> Self {
        Self { lengths, motor_angles: None, tensions: &[] }
    }

    /// The length that a model's drum has at the recorded angle, not a number where it has none; `None` where lengths are
    /// recorded.
    #[inline]
    pub(super) fn wound(&self, model: &Model, cable: usize) -> Option<DrumLength> {
        let angle = self.motor_angles?[cable];
        Some(model.motor_angle_gradient(cable, angle).unwrap_or(DrumLength::NAN))
    }

    /// Recorded lengths; `None` where they come from motor angles.
    pub(super) fn measured_lengths(&self) -> Option<&'a [f64]> {
        self.motor_angles.is_none().then_some(self.lengths)
    }

    /// Recorded length of a cable with this length on its drum, where there is one (m).
    pub(super) fn length_of(&self, cable: usize, wound: Option<&DrumLength>) -> f64 {
        wound.map_or(self.lengths[cable], |wound| wound.value)
    }

    /// Recorded length of a cable as a model's drum has it (m).
    pub(super) fn length(&self, model: &Model, cable: usize) -> f64 {
        self.length_of(cable, self.wound(model, cable).as_ref())
    }

    /// Derivative of the recorded length of a parameter's cable by the parameter.
    pub(super) fn change(&self, model: &Model, parameter: &Parameter) -> f64 {
        self.wound(model, parameter.cable).map_or(0.0, |wound| model.by_winch_parameter(&wound, parameter))
    }

    /// Tensions, one per cable (N); empty where none are recorded.
    pub(super) fn tensions(&self) -> &'a [f64] {
        self.tensions
    }
}
