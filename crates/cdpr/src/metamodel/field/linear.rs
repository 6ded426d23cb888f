//! The pose error by one linear step from the commanded pose.

use nalgebra::{DMatrix, DVector};

use crate::cable::law::Known;
use crate::geometry::{Pose, Twist};
use crate::metamodel::operate::Operation;
use crate::model::Model;
use crate::statics::{Held, Load};

/// Displacement of the platform from the commanded pose (m, rad), δx ≈ K_wx⁻¹ (Aᵀ f + w) (eq. 3.23).
///
/// f are the tensions that the lengths would bring if the platform were held at the commanded pose, and K_wx is the
/// stiffness there at these tensions: they differ from those of the equilibrium by as much as the error, so that the result is
/// exact to first order. The platform of a rigid machine moves to where the lengths fit best.
pub(super) fn displacement(operation: &mut Operation<'_>, commanded: &Pose) -> Option<Twist> {
    let controlled = operation.controlled_lengths(commanded).ok()?;
    let machine = operation.machine();
    let amounts = match machine.composition().depends_on_tension() {
        true => elastic(machine, commanded, &controlled)?,
        false => rigid(machine, commanded, &controlled)?,
    };
    let mut twist = Twist::zeros();
    for (direction, amount) in machine.twist_basis().iter().zip(amounts.iter()) {
        twist += direction * *amount;
    }
    Some(twist)
}

/// In the robot's degrees of freedom.
fn elastic(machine: &Model, pose: &Pose, controlled: &[f64]) -> Option<DVector<f64>> {
    let load = Load::of(machine.robot()).ok()?;
    let (mut wrench, mut stiffness) = (load.wrench(pose), -load.gradient(pose));
    for (cable, &length) in controlled.iter().enumerate() {
        let (hold, lever) = machine.hold(cable, pose, Known::ControlledLength(length)).ok()?;
        let held = Held { hold, lever, is_known_at_platform: false };
        wrench += held.wrench();
        stiffness += held.stiffness();
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
