//! Robots for the tests, and calculations that several tests share.

mod balance;
mod derivatives;
mod every;
mod laws;

use nalgebra::{DVector, Vector3};

use super::*;
use crate::geometry::{Pose, Twist};
use crate::model::{Composition, Model, place_pulleys};
use crate::robot::{CableStiffness, Robot, StiffnessBasis};

/// Eight cables with pulleys at odd angles, the three laws of elasticity among them, and a weight off the origin.
fn elastic_robot() -> Robot {
    let mut robot = Robot::builtin("cogiro").expect("built in");
    let home = robot.home.expect("has a home pose");
    let pulleys = (0..8).map(|i| (0.1 + 0.01 * i as f64, Vector3::new(0.1 * i as f64, -0.2, 0.9).normalize()));
    robot = place_pulleys(&robot, &pulleys.collect::<Vec<_>>(), &home).expect("pulleys fit");
    robot.platform.mass = Some(90.0);
    robot.platform.center_of_mass = Some(Vector3::new(0.1, -0.05, 0.2));
    for (index, cable) in robot.cables.iter_mut().enumerate() {
        match index % 3 {
            0 => {
                (cable.stiffness, cable.stiffness_by) = (Some(CableStiffness::Axial(4e4)), Some(StiffnessBasis::Actual))
            }
            1 => {
                (cable.stiffness, cable.stiffness_by) =
                    (Some(CableStiffness::Axial(6e4)), Some(StiffnessBasis::Unstrained));
            }
            _ => cable.stiffness = Some(CableStiffness::Spring(1e4)),
        }
        cable.hidden_length = (index % 3 != 2).then_some(1.5);
        cable.series_compliance = Some(1e-6);
    }
    robot
}

fn turned(robot: &Robot) -> Pose {
    robot.home.expect("has a home pose").displaced(&Twist::new(0.2, -0.1, 0.15, 0.1, -0.15, 0.2))
}

fn tensions(model: &Model) -> Vec<f64> {
    (0..model.cable_count()).map(|cable| 400.0 + 150.0 * cable as f64).collect()
}

fn of(composition: Composition) -> (Model, Pose, Vec<f64>, Load) {
    let robot = elastic_robot();
    let (pose, load) = (turned(&robot), Load::of(&robot).expect("knows its load"));
    let model = Model::new(robot, composition).expect("is elastic");
    let tensions = tensions(&model);
    (model, pose, tensions, load)
}

/// Aᵀ f + w at fixed controlled lengths.
fn residual(model: &Model, pose: &Pose, controlled: &[f64], load: &Load) -> DVector<f64> {
    let lengths = model.cable_lengths(pose).unwrap();
    let tension = |cable: usize| model.elasticity(cable).tension(lengths[cable], controlled[cable]).value;
    let tensions: Vec<f64> = (0..lengths.len()).map(tension).collect();
    wrench_residual(model, pose, &tensions, load).unwrap()
}

/// Tensions of a level robot that balance its load: a large common part, and a correction for the load.
fn balanced(model: &Model, pose: &Pose, load: &Load) -> Vec<f64> {
    let matrix = model.structure_matrix(pose).unwrap();
    let middle = DVector::from_element(model.cable_count(), 1500.0);
    let missing = load.in_pattern(model, pose) + &matrix * &middle;
    let inverse = (&matrix * matrix.transpose()).try_inverse().unwrap();
    (middle - matrix.transpose() * inverse * missing).as_slice().to_vec()
}

fn planar_robot() -> (Model, Pose) {
    let robot = Robot::builtin("kntu-planar").unwrap();
    let pose = robot.home_or_middle().displaced(&Twist::new(0.1, 0.2, 0.0, 0.0, 0.0, 0.2));
    (Model::new(robot, Composition::STANDARD).unwrap(), pose)
}
