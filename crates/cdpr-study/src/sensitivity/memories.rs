//! Memories of the cables of a model along a path, and how they follow each deviation.

use nalgebra::DVector;

use super::cause::Side;
use super::kink::Kink;
use cdpr_model::cable::stretch::hysteresis::{MemoryChange, Motion};
use cdpr_model::control::OperationError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::cable_state_at_outlet;

/// Strain within which the end of a branch may be met: a hundred times what forward problems leave (1e-11 of the mean length).
const ROUNDING: f64 = 1e-9;

/// Share of a motion by which it may seem to cross the end of a branch that it stays on.
const STAYS: f64 = 1e-6;

/// Strain per unit of a deviation that rounding leaves where its effects cancel, as of winches that are set anew at the pose.
const CANCELLED: f64 = 1e-13;

/// Changes of the memories of all cables per unit of one cause; empty for a model whose cables do not remember.
pub(super) type MemoryChanges = Vec<MemoryChange>;

/// Cables on the motion from their memories to their tensions, linearized; empty for a model whose cables do not remember.
#[derive(Default)]
pub(super) struct Motions {
    cables: Vec<Moving>,
}

struct Moving {
    motion: Motion,
    /// Change of the recorded length per strain, at fixed tension (m).
    length_by_strain: f64,
}

impl Motions {
    /// The motions of a model, whose laws are at the memories, to these tensions at a pose (N).
    pub(super) fn to(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<Self, Kink> {
        if !remembers(model) {
            return Ok(Self::default());
        }
        let moving = |(cable, &tension)| {
            let state = cable_state_at_outlet(model, pose, cable, tension).map_err(OperationError::from)?;
            let (motion, length_by_strain) = model.law(cable).motion(&state).ok_or(Kink::Sagging)?;
            Ok(Moving { motion, length_by_strain: state.recording.length_scale * length_by_strain })
        };
        tensions.iter().enumerate().map(moving).collect::<Result<_, _>>().map(|cables| Self { cables })
    }

    /// The model from whose memories no stop is in doubt, so that all that is derived from it takes the same side; `None` if none is.
    pub(super) fn pushed_on(&self, model: &Model) -> Option<Model> {
        let is_in_doubt = self.cables.iter().any(|cable| cable.motion.margin() < ROUNDING);
        let memories = self.cables.iter().enumerate().filter_map(|(cable, Moving { motion, .. })| {
            Some(motion.pushed_on(ROUNDING, model.law(cable).stretch.memory()?))
        });
        is_in_doubt.then(|| model.with_memories(&memories.collect::<Vec<_>>()))
    }

    /// The first cable (0-based) on the border of being slack; `loose` is the strain by which a slack one is too long.
    pub(super) fn between_taut_and_slack(&self, loose: impl Fn(usize) -> f64) -> Option<usize> {
        let is_between = |cable: usize| self.cables[cable].motion.strain.abs() < ROUNDING && loose(cable) < ROUNDING;
        (0..self.cables.len()).find(|&cable| is_between(cable))
    }

    /// The first cable (0-based) that meets the end of a branch, and leaves it by these changes of the memories.
    fn crosses(&self, before: &[MemoryChange], after: &[MemoryChange]) -> Option<usize> {
        let moved = before.iter().chain(after).map(|change| change.strain.abs()).fold(0.0, f64::max);
        let mut changes = self.cables.iter().zip(before.iter().zip(after));
        changes.position(|(cable, (before, after))| {
            cable.motion.crossing(3.0 * ROUNDING, after.strain, before) > STAYS * moved + CANCELLED
        })
    }

    /// True where nothing is left of what the cables remembered before.
    pub(super) fn forget(&self) -> bool {
        self.cables.iter().all(|cable| cable.motion.forgets() && cable.motion.margin() > 3.0 * ROUNDING)
    }

    /// Change of the recorded lengths with the memories before, at fixed tensions (m).
    pub(super) fn lengths(&self, before: &[MemoryChange]) -> Option<DVector<f64>> {
        let changes = self.cables.iter().zip(before);
        let lengths: Vec<f64> =
            changes.map(|(cable, before)| cable.length_by_strain * cable.motion.strain_change(0.0, before)).collect();
        (!lengths.is_empty()).then(|| DVector::from_vec(lengths))
    }

    /// Changes of the memories after the motions, for a change of the tensions (N).
    pub(super) fn settled(&self, tensions: &DVector<f64>, before: &[MemoryChange]) -> MemoryChanges {
        let after = |((cable, &tension), before): ((&Moving, &f64), &MemoryChange)| {
            cable.motion.memory_change(cable.motion.strain_change(tension, before), before)
        };
        self.cables.iter().zip(tensions.iter()).zip(before).map(after).collect()
    }
}

/// Changes of the memories of control model and machine.
#[derive(Clone, Default)]
pub(super) struct Remembered {
    /// Of the control model, by each of its causes, which come first.
    pub(super) control: Vec<MemoryChanges>,
    /// Of the machine, by each cause.
    pub(super) machine: Vec<MemoryChanges>,
}

impl Remembered {
    /// Cables that were never loaded, whatever deviates.
    pub(super) fn nothing(control: &Model, control_causes: usize, machine: &Model, causes: usize) -> Self {
        Self { control: vec![unchanged(control); control_causes], machine: vec![unchanged(machine); causes] }
    }

    /// Refuses motions from these memories to others that cross the end of a branch.
    pub(super) fn check(&self, [control, machine]: [&Motions; 2], after: &Self) -> Result<(), Kink> {
        let sides = [
            (Side::Control, control, &self.control, &after.control),
            (Side::Machine, machine, &self.machine, &after.machine),
        ];
        for (side, motions, before, after) in sides {
            let crosses = before.iter().zip(after).find_map(|(before, after)| motions.crosses(before, after));
            if let Some(cable) = crosses {
                return Err(Kink::Branch { side, cable });
            }
        }
        Ok(())
    }
}

/// True for a model whose cables remember.
pub(super) fn remembers(model: &Model) -> bool {
    model.composition().stretch.remembers()
}

fn unchanged(model: &Model) -> MemoryChanges {
    vec![MemoryChange::default(); if remembers(model) { model.cable_count() } else { 0 }]
}
