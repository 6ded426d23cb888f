//! Robots with deviations: their numbers, models and winch offsets.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution as _, StandardNormal};

use crate::sensitivity::{Kind, Offsets, ParameterDeviation, Setting, Side};
use crate::study::Distribution;
use cdpr_model::control::Initial;
use cdpr_model::control::InputError;
use cdpr_model::control::{tensions_set, winch_offsets};
use cdpr_model::model::Model;

/// Index of the first stream of random numbers for robots; streams below are those of poses and sensors.
const FIRST_STREAM: u64 = 1 << 32;

/// Draws the deviations of one robot (from 0), in the units of their causes, from its own stream of random numbers, so
/// that they do not depend on earlier draws.
pub(super) fn draw(seed: u64, robot: usize, sigmas: &[f64], distribution: Distribution, deviations: &mut Vec<f64>) {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    rng.set_stream(FIRST_STREAM + robot as u64);
    deviations.clear();
    deviations.extend(sigmas.iter().map(|&sigma| {
        let unit: f64 = match distribution {
            Distribution::Normal => StandardNormal.sample(&mut rng),
            Distribution::Uniform => rng.random_range(-1.0..=1.0) * 3.0_f64.sqrt(),
        };
        sigma * unit
    }));
}

/// A control model on a machine, with the deviations that apply to each.
pub(super) struct Makers<'a> {
    pub(super) control: &'a Model,
    pub(super) machine: &'a Model,
    pub(super) setting: &'a Setting<'a>,
    /// The offsets in use (m).
    pub(super) offsets: &'a [f64],
    /// The numbers that deviate.
    pub(super) causes: &'a [ParameterDeviation],
    /// Initial tensions (N); empty if they are not needed.
    tensions: Vec<f64>,
}

/// A robot with deviations; models that do not deviate are `None`.
pub(super) struct Made {
    pub(super) control: Option<Model>,
    pub(super) machine: Option<Model>,
    /// Winch offsets (m).
    pub(super) offsets: Vec<f64>,
}

impl<'a> Makers<'a> {
    pub(super) fn new(
        control: &'a Model,
        machine: &'a Model,
        setting: &'a Setting<'a>,
        offsets: &'a [f64],
        causes: &'a [ParameterDeviation],
    ) -> Result<Self, InputError> {
        let is_asked = causes.iter().any(|cause| cause.kind == Kind::InitialTension);
        let mut makers = Self { control, machine, setting, offsets, causes, tensions: Vec::new() };
        if is_asked {
            makers.tensions = makers.initial_tensions(setting.set_with(control), machine)?;
        }
        Ok(makers)
    }

    /// The robot with these deviations; an error if its winches cannot be set.
    pub(super) fn make(&self, deviations: &[f64]) -> Result<Made, InputError> {
        let (control, machine) =
            (self.deviating(Side::Control, deviations)?, self.deviating(Side::Machine, deviations)?);
        let set = match self.setting.offsets {
            Offsets::Kept => (self.control, self.machine),
            Offsets::SetAnew => (control.as_ref().unwrap_or(self.control), machine.as_ref().unwrap_or(self.machine)),
        };
        let mut offsets = self.set_offsets(set, deviations)?;
        for (cause, by) in self.causes.iter().zip(deviations).filter(|(cause, _)| cause.kind == Kind::WinchOffset) {
            offsets[cause.cable] += by;
        }
        Ok(Made { control, machine, offsets })
    }

    fn deviating(&self, side: Side, deviations: &[f64]) -> Result<Option<Model>, InputError> {
        let model = if side == Side::Control { self.control } else { self.machine };
        let mut own = self.causes.iter().zip(deviations).filter(|(cause, _)| cause.side == side).peekable();
        if own.peek().is_none() {
            return Ok(None);
        }
        let mut robot = model.robot().clone();
        own.for_each(|(cause, &by)| cause.deviate(model, &mut robot, by));
        Ok(Some(Model::new(robot, model.composition())?))
    }

    fn set_offsets(&self, (control, machine): (&Model, &Model), deviations: &[f64]) -> Result<Vec<f64>, InputError> {
        let is_anew = self.setting.offsets == Offsets::SetAnew && self.setting.has_computed_offsets();
        let (initial, pose, set_with) = (self.setting.initial, &self.setting.pose, self.setting.set_with(control));
        if self.tensions.is_empty() {
            return if is_anew { winch_offsets(initial, set_with, machine, pose) } else { Ok(self.offsets.to_vec()) };
        }
        let mut tensions = if is_anew { self.initial_tensions(set_with, machine)? } else { self.tensions.clone() };
        let own = self.causes.iter().zip(deviations).filter(|(cause, _)| cause.kind == Kind::InitialTension);
        // a negative tension cannot be set
        own.for_each(|(cause, by)| tensions[cause.cable] = (tensions[cause.cable] + by).max(0.0));
        let changed = Initial { tensions_N: Some(tensions), tension_method: None, ..initial.clone() };
        winch_offsets(&changed, set_with, machine, pose)
    }

    fn initial_tensions(&self, set_with: &Model, machine: &Model) -> Result<Vec<f64>, InputError> {
        Ok(tensions_set(self.setting.initial, set_with, machine, &self.setting.pose)?.unwrap_or_default())
    }
}
