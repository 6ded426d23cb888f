//! Steps of a machine in time.

use std::hint::black_box;

use cdpr::model::{Composition, Model};
use cdpr::nalgebra::{Matrix3, Vector3};
use cdpr::plant::{Command, Plant, Winches};
use cdpr::robot::Robot;

use crate::counting;
use crate::robots::{ELASTIC, builtin};

/// Steps of a millisecond.
const STEPS: usize = 64;

/// Tensions at the home pose (N).
const TENSIONS: [f64; 8] = [3678.0, 2169.0, 4250.0, 1708.0, 3985.0, 2394.0, 4715.0, 1684.0];

pub(crate) fn count() {
    let mut robot = builtin(ELASTIC);
    robot.platform.center_of_mass = Some(Vector3::new(-0.09, -0.05, 0.1));
    robot.platform.inertia = Some(Matrix3::from_diagonal(&Vector3::new(117.0, 121.0, 62.5)));
    steps("steps in time", &robot);
    robot.platform.damping = Some(200.0);
    robot.platform.rotational_damping = Some(50.0);
    robot.cables.iter_mut().for_each(|cable| cable.damping = Some(500.0));
    steps("steps in time, damped", &robot);
}

/// A platform that is let go with cables 2 mm shorter and longer than they were.
fn steps(name: &str, robot: &Robot) {
    let model = Model::new(robot.clone(), Composition::ELASTIC).expect("a model");
    let plant = Plant::new(model, Winches::Ideal).expect("a machine");
    let start = plant.at_rest(&robot.home_or_middle(), &TENSIONS).expect("a start");
    let shift = [2e-3, -2e-3].into_iter().cycle();
    let lengths = start.cables.iter().zip(shift).map(|(cable, by)| Command::Length(cable.controlled_length + by));
    let commands: Vec<Command> = lengths.collect();
    counting::count(name, &mut || {
        let mut state = start.clone();
        (0..STEPS).filter(|_| plant.step(&mut state, black_box(&commands), 1e-3).is_ok()).count()
    });
}
