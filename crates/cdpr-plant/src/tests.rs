//! Laws of machines in time: conservation, order of the method, the static limit, small motions.
#![expect(clippy::print_stdout, reason = "tests show their figures")]

mod compositions;
mod conservation;
mod controllers;
mod drums;
mod dual_laws;
mod dual_numbers;
mod error_control;
mod friction;
mod kinks;
mod limits;
mod oracle;
mod scenarios;
mod small_motions;

use nalgebra::{Matrix3, Vector3};

use super::{Command, Damping, Plant, PlantState, Winches};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{CableStiffness, Robot, StiffnessBasis};

/// The CableRobot Simulator with its centre of mass off-centre, and cables as springs whose energy is a function of
/// lengths.
pub(super) fn simulator() -> Robot {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    robot.platform.center_of_mass = Some(Vector3::new(-0.09, -0.05, 0.1));
    robot.platform.inertia = Some(Matrix3::new(117.0, 2.0, -1.0, 2.0, 121.0, 3.0, -1.0, 3.0, 62.5));
    if let Some(external) = &mut robot.external_wrench {
        external.includes_gravity = false;
        // moments of constant direction have no potential
        external.wrench = Twist::new(-20.0, 30.0, -40.0, 0.0, 0.0, 0.0);
    }
    for cable in &mut robot.cables {
        cable.stiffness_by = Some(StiffnessBasis::Unstrained);
    }
    robot
}

/// A plate in a plane on four springs.
pub(super) fn plate() -> Robot {
    let mut robot = Robot::builtin("cucablerobot-planar").unwrap();
    for cable in &mut robot.cables {
        cable.stiffness = Some(CableStiffness::Spring(3e3));
    }
    robot
}

pub(super) fn plant(robot: Robot, composition: Composition, damping: f64) -> Plant {
    let model = Model::new(robot, composition).unwrap();
    let damping = vec![Damping { constant: damping, time: 0.0 }; model.cable_count()];
    Plant::with_damping(model, Winches::Ideal, damping).unwrap()
}

/// The machine in equilibrium at its home pose, with tensions near a level (N).
pub(super) fn at_home(plant: &Plant, level: f64) -> PlantState {
    let pose = plant.model().robot().home_or_middle();
    let initial = cdpr_model::control::Initial {
        tensions_N: Some(vec![level; plant.model().cable_count()]),
        ..Default::default()
    };
    let tensions = cdpr_model::control::initial_tensions(&initial, plant.model(), &pose).unwrap();
    plant.at_rest(&pose, &tensions).unwrap()
}

/// The state displaced in the degrees of freedom.
pub(super) fn displaced(plant: &Plant, state: &PlantState, displacement: &[f64]) -> PlantState {
    let twist: Twist = plant.model().twist_basis().iter().zip(displacement).map(|(basis, by)| basis * *by).sum();
    let mut moved = state.clone();
    moved.set_pose(state.pose.displaced(&twist));
    plant.observe(&mut moved).unwrap();
    moved
}

/// Takes `count` steps with constant winches.
pub(super) fn hold(plant: &Plant, state: &mut PlantState, step: f64, count: usize) {
    let lengths: Vec<f64> = state.cables.iter().map(|cable| cable.controlled_length).collect();
    for _ in 0..count {
        plant.step(state, &Command::lengths(&lengths), step).unwrap();
    }
}

/// Distance and angle between poses as one length (m, with the angle at 1 m).
pub(super) fn apart(a: &Pose, b: &Pose) -> f64 {
    a.displacement_to(b).amax()
}
