//! Memories of the cables of a model along a path, and their derivatives by each deviation.

use nalgebra::DVector;

use super::cause::Side;
use super::kink::Kink;
use cdpr_model::cable::stretch::hysteresis::{MemoryChange, Motion};
use cdpr_model::control::OperationError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::cable_state_at_outlet;

/// Strain within which the end of a branch counts as met: a hundred times the error of forward problems (1e-11 of the
/// mean length).
const ROUNDING: f64 = 1e-9;

/// Fraction of a motion by which it may appear to cross the end of a branch without leaving it.
const STAYS: f64 = 1e-6;

/// Strain per unit of a deviation that is left to rounding if its effects cancel, as for winches set anew at the pose.
const CANCELLED: f64 = 1e-13;

/// Changes of the memories of all cables per unit of one cause; empty for a model whose cables have no memory.
pub(super) type MemoryChanges = Vec<MemoryChange>;

/// Linearized motions of cables from their memories to their tensions; empty for a model whose cables have no memory.
#[derive(Default)]
pub(super) struct Motions {
    cables: Vec<Moving>,
}

struct Moving {
    motion: Motion,
    /// Change of the recorded length with the strain, at fixed tension (m).
    length_by_strain: f64,
}

impl Motions {
    /// The motions of a model, whose laws have their memories, to these tensions at a pose (N).
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

    /// The model with memories moved off the ends of branches, so that everything derived from it lies on the same
    /// side; `None` if no cable is near one.
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

    /// The first cable (0-based) at the end of a branch that leaves it under these changes of the memories.
    fn crosses(&self, before: &[MemoryChange], after: &[MemoryChange]) -> Option<usize> {
        let moved = before.iter().chain(after).map(|change| change.strain.abs()).fold(0.0, f64::max);
        let mut changes = self.cables.iter().zip(before.iter().zip(after));
        changes.position(|(cable, (before, after))| {
            cable.motion.crossing(3.0 * ROUNDING, after.strain, before) > STAYS * moved + CANCELLED
        })
    }

    /// True if the earlier memories have no effect any more.
    pub(super) fn forget(&self) -> bool {
        self.cables.iter().all(|cable| cable.motion.forgets() && cable.motion.margin() > 3.0 * ROUNDING)
    }

    /// Change of the recorded lengths with the memories before, at fixed tensions (m); `None` for cables without
    /// memory.
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
    /// Changes for the control model, by each of its causes, which come first.
    pub(super) control: Vec<MemoryChanges>,
    /// Changes for the machine, by each cause.
    pub(super) machine: Vec<MemoryChanges>,
}

impl Remembered {
    /// Cables that were never loaded, so that their memories depend on no cause.
    pub(super) fn nothing(control: &Model, control_causes: usize, machine: &Model, causes: usize) -> Self {
        Self { control: vec![unchanged(control); control_causes], machine: vec![unchanged(machine); causes] }
    }

    /// Checks that motions from these memories to others do not cross the end of a branch.
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

/// True for a model whose cables have a memory.
pub(super) fn remembers(model: &Model) -> bool {
    model.composition().stretch.remembers()
}

fn unchanged(model: &Model) -> MemoryChanges {
    vec![MemoryChange::default(); if remembers(model) { model.cable_count() } else { 0 }]
}
