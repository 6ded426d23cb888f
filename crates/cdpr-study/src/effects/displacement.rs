//! Displacement of the platform under changed controlled lengths.

use super::error::EffectError;
use cdpr_model::equilibrium::{self, ForwardProblem, ForwardSettings, Status};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;
use cdpr_model::reading::keywords;
use cdpr_model::statics::{Load, LoadError, StaticsError, Stiffness, cable_state};
use nalgebra::{DVector, Vector3};

/// Largest distance at which the machine's own lengths must lead back to its pose (m; angles times the platform
/// radius); otherwise the forward problem does not suit this machine.
const WAY_BACK: f64 = 1e-6;

/// The state at which effects are compared.
#[derive(Clone, Debug, PartialEq)]
pub struct EffectState {
    /// The platform pose.
    pub pose: Pose,
    /// The load on the platform, or the reason for which it is unknown; only rigid straight cables need no load.
    pub load: Result<Load, LoadError>,
    /// Tensions that balance the load, at the end where the robot measures them (N); `None` if there are none, which
    /// only rigid straight cables allow.
    pub tensions: Option<Vec<f64>>,
}

/// Method by which a displacement was found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DisplacementMethod {
    /// By the forward problem.
    Exact,
    /// By δx = −K_wx⁻¹ K_wq δq_θ (eq. 2.80), for small changes.
    FirstOrder,
}

keywords!(DisplacementMethod: Exact = "exact", FirstOrder = "first-order");

/// Displacement of the platform and change of the tensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacement {
    /// Distance of the platform origin (m).
    pub translation: f64,
    /// Angle of rotation (rad).
    pub rotation: f64,
    /// Largest change of a tension at the outlets (N); `None` for rigid straight cables, whose tensions do not follow
    /// from lengths.
    pub tension: Option<f64>,
    /// Number of cables that lose their tension.
    pub slack: usize,
    /// Method by which it was found.
    pub method: DisplacementMethod,
}

/// Displacement of the platform at rest in a state if the controlled lengths change by `change` (m), one per cable.
pub fn displacement(machine: &Model, state: &EffectState, change: &[f64]) -> Result<Displacement, EffectError> {
    let tensions = match (&state.tensions, ForwardProblem::of(machine, state.load.is_ok())) {
        (Some(tensions), ForwardProblem::Equilibrium) => tensions,
        _ => return by_geometry(machine, &state.pose, change),
    };
    match by_equilibrium(machine, state, tensions, change) {
        Some(found) => Ok(found),
        None if ForwardProblem::of(machine, false) == ForwardProblem::Equilibrium => {
            to_first_order(machine, state, tensions, change)
        }
        None => Err(EffectError::NotNear),
    }
}

/// For rigid straight cables: the pose whose lengths fit best.
fn by_geometry(machine: &Model, pose: &Pose, change: &[f64]) -> Result<Displacement, EffectError> {
    let own = machine.cable_lengths(pose).map_err(StaticsError::from)?;
    let lengths: Vec<f64> = own.iter().zip(change).map(|(own, change)| own + change).collect();
    let mut machine_state = equilibrium::State::at(machine, pose);
    let found = machine.forward(&lengths, None, Some(pose), &mut machine_state)?.converged()?;
    let (translation, rotation) = apart(pose, &found.pose);
    Ok(Displacement { translation, rotation, tension: None, slack: 0, method: DisplacementMethod::Exact })
}

/// By the forward problem; `None` if it has no answer.
fn by_equilibrium(machine: &Model, state: &EffectState, tensions: &[f64], change: &[f64]) -> Option<Displacement> {
    let mut settings = ForwardSettings::default();
    settings.equilibrium.max_restarts = 0;
    let load = state.load.as_ref().ok()?;
    let mut machine_state = equilibrium::State::at(machine, &state.pose);
    let own = machine.inverse(&state.pose, tensions, &mut machine_state).ok()?.controlled_lengths().ok()?;
    let mut at_rest = |lengths: &[f64]| {
        let found = machine.forward_with(&settings, lengths, Some(load), Some(&state.pose), &mut machine_state).ok()?;
        (found.status == Status::Converged).then(|| (found.pose, found.tensions.clone(), found.slack))
    };
    let (start, start_tensions, _) = at_rest(&own)?;
    let (distance, angle) = apart(&state.pose, &start);
    if distance + machine.platform_radius() * angle > WAY_BACK {
        return None;
    }
    let lengths: Vec<f64> = own.iter().zip(change).map(|(own, change)| own + change).collect();
    let (end, end_tensions, slack) = at_rest(&lengths)?;
    let (translation, rotation) = apart(&start, &end);
    let tension = Some(largest(end_tensions.iter().zip(&start_tensions).map(|(end, start)| end - start)));
    Some(Displacement { translation, rotation, tension, slack, method: DisplacementMethod::Exact })
}

fn to_first_order(
    machine: &Model,
    state: &EffectState,
    tensions: &[f64],
    change: &[f64],
) -> Result<Displacement, EffectError> {
    let load = state.load.as_ref().map_err(Clone::clone)?;
    let stiffness = Stiffness::at(machine, &state.pose, tensions, load)?;
    let by_lengths = stiffness.pose_by_controlled_lengths().ok_or(EffectError::Singular)?;
    let moved = by_lengths * DVector::from_column_slice(change);
    let twist: Twist = machine.twist_basis().iter().zip(moved.iter()).map(|(unit, fraction)| unit * *fraction).sum();
    let (step, turn) = (Vector3::new(twist[0], twist[1], twist[2]), Vector3::new(twist[3], twist[4], twist[5]));
    let (mut most, mut slack) = (0.0_f64, 0);
    for (index, (&tension, change)) in tensions.iter().zip(change).enumerate() {
        let cable = cable_state(machine, &state.pose, index, tension)?;
        let tension_change =
            (change - cable.controlled_length_by_pose().dot(&twist)) / cable.controlled_length_by_tension;
        most = most.max(tension_change.abs());
        slack += usize::from(cable.outlet_tension + tension_change < 0.0);
    }
    let (translation, rotation) = (step.norm(), turn.norm());
    Ok(Displacement { translation, rotation, tension: Some(most), slack, method: DisplacementMethod::FirstOrder })
}

/// Distance (m) and angle (rad) between poses.
fn apart(from: &Pose, to: &Pose) -> (f64, f64) {
    ((to.position - from.position).norm(), from.angle_to(to))
}

/// The largest magnitude; 0 for no values.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |largest, value| largest.max(value.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use cdpr_model::model::Composition;
    use cdpr_model::robot::Robot;
    use cdpr_model::statics::balanced_wrench;

    /// The forward problem and the stiffness describe the same machine: for small changes they agree.
    #[test]
    fn small_changes_lead_to_the_same_place_by_both_methods() {
        let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
        let pose = robot.home.unwrap();
        let model = Model::new(robot, Composition::ELASTIC).unwrap();
        let tensions = vec![3678.0, 2169.0, 4250.0, 1708.0, 3985.0, 2394.0, 4715.0, 1684.0];
        let load = Load::constant(balanced_wrench(&model, &pose, &tensions).unwrap());
        let state = EffectState { pose, load: Ok(load), tensions: Some(tensions.clone()) };
        let change: Vec<f64> = (0..8).map(|cable| 1e-5 * f64::from(cable - 3)).collect();
        let exact = displacement(&model, &state, &change).unwrap();
        let linear = to_first_order(&model, &state, &tensions, &change).unwrap();
        assert_eq!((exact.method, linear.method), (DisplacementMethod::Exact, DisplacementMethod::FirstOrder));
        // the difference is of second order: the change over the length, 1e-5 of the result
        for (exact, linear) in [
            (exact.translation, linear.translation),
            (exact.rotation, linear.rotation),
            (exact.tension.unwrap(), linear.tension.unwrap()),
        ] {
            assert!((exact - linear).abs() < 1e-3 * exact, "{exact} {linear}");
        }
    }
}
