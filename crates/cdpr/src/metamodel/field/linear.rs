//! The pose error by one linear step from the commanded pose.

use nalgebra::{DMatrix, DVector};

use crate::cable::CableInput;
use crate::geometry::{Pose, Twist};
use crate::metamodel::operation::Operation;
use crate::model::{Cables, Model};
use crate::statics::{Load, Stiffness};
use crate::tension::Limits;

/// Displacement of the platform from the commanded pose (m, rad), δx ≈ −K_wx⁻¹ K_wq (q_θ − φ̂(x, f₀)) (eq. 3.23).
///
/// f₀ are the tensions in balance at the commanded pose that are nearest to those that the lengths would bring if the platform
/// were held there, and stiffnesses are those at f₀. They differ from the tensions of the equilibrium by as much as the error,
/// so that the result is exact to first order while no cable gets slack. Cables that are neither straight nor linear are taken
/// as they would be held, which a slack cable spoils. The platform of a rigid machine moves to where the lengths fit best.
pub(super) fn displacement(operation: &mut Operation<'_>, commanded: &Pose) -> Option<Twist> {
    let controlled = operation.controlled_lengths(commanded).ok()?;
    let machine = operation.machine();
    let held = || as_held(machine, commanded, &controlled);
    let amounts = match machine.cables() {
        Cables::Rigid => rigid(machine, commanded, &controlled),
        Cables::Linear => at_balance(machine, commanded, &controlled).or_else(held),
        Cables::Stretching | Cables::Sagging => held(),
    }?;
    let mut twist = Twist::zeros();
    for (direction, amount) in machine.twist_basis().iter().zip(amounts.iter()) {
        twist += direction * *amount;
    }
    Some(twist)
}

/// Tensions below this are taken for it (N): a slack cable has no stiffness to go by.
const TAUT: f64 = 1.0;

/// In the robot's degrees of freedom.
fn at_balance(machine: &Model, pose: &Pose, controlled: &[f64]) -> Option<DVector<f64>> {
    let load = Load::of(machine.robot()).ok()?;
    let limits = Limits::of(machine.robot(), None, None).ok()?;
    let middle: Vec<f64> = (0..controlled.len()).map(|cable| limits.middle(cable).max(TAUT)).collect();
    let start = Stiffness::at(machine, pose, &middle, &load).ok()?;
    let held = |cable: usize| {
        let short = start.controlled_lengths[cable] - controlled[cable];
        middle[cable] + start.controlled_length_stiffness[cable] * short
    };
    let held = DVector::from_fn(controlled.len(), |cable, _| held(cable));
    let matrix = machine.structure_matrix(pose).ok()?;
    let missing = &matrix * &held + load.in_pattern(machine, pose);
    let normal = (&matrix * matrix.transpose()).cholesky()?;
    let balanced = held - matrix.transpose() * normal.solve(&missing);
    let taut: Vec<f64> = balanced.iter().map(|tension| tension.max(TAUT)).collect();
    let stiffness = Stiffness::at(machine, pose, &taut, &load).ok()?;
    let change = DVector::from_fn(controlled.len(), |cable, _| controlled[cable] - stiffness.controlled_lengths[cable]);
    Some(stiffness.pose_by_controlled_lengths()? * change).filter(|step| step.iter().all(|entry| entry.is_finite()))
}

/// δx = K_wx⁻¹ (Aᵀ f + w) with the tensions f of the cables where they are held.
fn as_held(machine: &Model, pose: &Pose, controlled: &[f64]) -> Option<DVector<f64>> {
    let load = Load::of(machine.robot()).ok()?;
    let (mut wrench, mut stiffness) = (load.wrench(pose), -load.gradient(pose));
    for (cable, &length) in controlled.iter().enumerate() {
        let state = machine.cable_state(cable, pose, CableInput::ControlledLength(length)).ok()?;
        wrench += state.wrench();
        stiffness += state.stiffness();
    }
    let basis = machine.twist_basis();
    let n = machine.dof();
    let matrix = DMatrix::from_fn(n, n, |row, column| basis[row].dot(&(stiffness * basis[column])));
    let right = DVector::from_fn(n, |row, _| basis[row].dot(&wrench));
    matrix.lu().solve(&right).filter(|step| step.iter().all(|entry| entry.is_finite()))
}

/// Least squares of −Aᵀ δx = q_θ − q(x).
fn rigid(machine: &Model, pose: &Pose, controlled: &[f64]) -> Option<DVector<f64>> {
    let matrix = machine.structure_matrix(pose).ok()?;
    let lengths = machine.cable_lengths(pose).ok()?;
    let missing = DVector::from_fn(lengths.len(), |cable, _| lengths[cable] - controlled[cable]);
    (&matrix * matrix.transpose()).cholesky().map(|normal| normal.solve(&(&matrix * missing)))
}
