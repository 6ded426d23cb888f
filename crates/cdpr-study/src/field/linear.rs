//! The pose error by one linear step from the commanded pose.

use nalgebra::{DMatrix, DVector};

use cdpr_model::cable::{CableInput, CableState};
use cdpr_model::control::Operation;
use cdpr_model::geometry::{Pose, Twist, Wrench};
use cdpr_model::model::{Cables, Model};
use cdpr_model::statics::{Load, Stiffness};
use cdpr_model::tension::Limits;

/// Displacement of the platform from the commanded pose (m, rad), δx ≈ −K_wx⁻¹ K_wq (q_θ − φ̂(x, f₀)) (eq. 3.23).
///
/// f₀ are the balanced tensions at the commanded pose nearest to those that the lengths would cause if the platform
/// were held there; the stiffnesses are those at f₀. They differ from the tensions of the equilibrium by the order of
/// the error, so that the result is exact to first order while no cable becomes slack. Cables that are not straight and
/// linear are evaluated at the held pose, which is inaccurate if one is slack. The platform of a rigid machine moves to
/// the least-squares pose.
pub(super) fn displacement(operation: &mut Operation, commanded: &Pose) -> Option<Twist> {
    let controlled = operation.controlled_lengths(commanded).ok()?;
    let machine = operation.machine();
    let held = || Held::at(machine, commanded, &controlled).map(|held| held.step);
    let amounts = match machine.cables() {
        Cables::Rigid => rigid(machine, commanded, &controlled),
        Cables::Linear => at_balance(machine, commanded, &controlled).or_else(held),
        Cables::Stretching | Cables::Sagging => held(),
    }?;
    Some(in_world(machine, &amounts))
}

fn in_world(machine: &Model, amounts: &DVector<f64>) -> Twist {
    let mut twist = Twist::zeros();
    for (direction, amount) in machine.twist_basis().iter().zip(amounts.iter()) {
        twist += direction * *amount;
    }
    twist
}

/// A machine whose platform is held at a commanded pose; `None` for a rigid one, if no lengths are sent, or if the
/// stiffness is singular.
pub(crate) fn held(operation: &mut Operation, commanded: &Pose) -> Option<Held> {
    let controlled = operation.controlled_lengths(commanded).ok().filter(|_| operation.knows_tensions())?;
    Held::at(operation.machine(), commanded, &controlled)
}

/// Least tension for stiffnesses (N), since a slack cable has none.
const TAUT: f64 = 1.0;

/// Displacement by the step at balanced tensions, in the robot's degrees of freedom.
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

/// A machine whose platform is held at a pose, with one linear step from there.
pub(crate) struct Held {
    /// Aᵀ f + w with the tensions f(q_θ) of the cables at the held pose (world; N, N·m).
    pub(crate) residual_wrench: Wrench,
    /// δx = K_wx⁻¹ (Aᵀ f + w) with the stiffness at these tensions, in the robot's degrees of freedom (eq. 3.24).
    step: DVector<f64>,
    cables: Vec<CableState>,
}

impl Held {
    pub(super) fn at(machine: &Model, pose: &Pose, controlled: &[f64]) -> Option<Self> {
        let load = Load::of(machine.robot()).ok()?;
        let (mut wrench, mut stiffness) = (load.wrench(pose), -load.gradient(pose));
        let mut cables = Vec::with_capacity(controlled.len());
        for (cable, &length) in controlled.iter().enumerate() {
            let state = machine.cable_state(cable, pose, CableInput::ControlledLength(length)).ok()?;
            wrench += state.wrench();
            stiffness += state.stiffness();
            cables.push(state);
        }
        let basis = machine.twist_basis();
        let n = machine.dof();
        let matrix = DMatrix::from_fn(n, n, |row, column| basis[row].dot(&(stiffness * basis[column])));
        let right = DVector::from_fn(n, |row, _| basis[row].dot(&wrench));
        let step = matrix.lu().solve(&right).filter(|step| step.iter().all(|entry| entry.is_finite()))?;
        Some(Self { residual_wrench: wrench, step, cables })
    }

    /// Displacement of the platform by the step (m, rad; world axes).
    pub(crate) fn displacement(&self, machine: &Model) -> Twist {
        in_world(machine, &self.step)
    }

    /// Tensions at the outlets after the step (N), f(q_θ) − K A δx (eq. 3.35), from those at the held pose.
    pub(crate) fn tensions(&self, machine: &Model) -> Vec<f64> {
        let changes = self.changes_along(&self.displacement(machine));
        self.cables.iter().zip(changes).map(|(cable, change)| cable.outlet_tension + change).collect()
    }

    /// Changes of the tensions at the outlets along a displacement of the platform, at fixed controlled lengths (N); 0
    /// for a slack cable.
    pub(super) fn changes_along(&self, displacement: &Twist) -> Vec<f64> {
        let change = |cable: &CableState| match cable.outlet_tension > 0.0 {
            true => -cable.controlled_length_by_pose().dot(displacement) / cable.controlled_length_by_tension,
            false => 0.0,
        };
        self.cables.iter().map(change).collect()
    }
}

/// Least-squares solution of −Aᵀ δx = q_θ − q(x); `None` if it is not determined.
fn rigid(machine: &Model, pose: &Pose, controlled: &[f64]) -> Option<DVector<f64>> {
    let matrix = machine.structure_matrix(pose).ok()?;
    let lengths = machine.cable_lengths(pose).ok()?;
    let missing = DVector::from_fn(lengths.len(), |cable, _| lengths[cable] - controlled[cable]);
    (&matrix * matrix.transpose()).cholesky().map(|normal| normal.solve(&(&matrix * missing)))
}
