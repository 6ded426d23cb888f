//! One step of the CableRobot Simulator in time (m = 8, n = 6): `cargo bench -p benches --bench motion`.
//!
//! `newcomer` is the same step as one writes it first: the classical Runge–Kutta rule on velocities and a quaternion, forces cable by cable from the
//! structure matrix, of the same order. It looks four times at the cables, the symplectic step six times.

use std::hint::black_box;

use cdpr::geometry::{Pose, Twist};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::{Matrix3, Quaternion, UnitQuaternion, Vector3};
use cdpr::plant::{Command, Inertia, Plant, PlantState, Winches};
use cdpr::robot::{Body, Cable, Robot};
use cdpr::statics::Load;
use criterion::Criterion;

fn robot() -> Robot {
    let mut robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").expect("built in");
    robot.platform.center_of_mass = Some(Vector3::new(-0.09, -0.05, 0.1));
    robot.platform.inertia = Some(Matrix3::from_diagonal(&Vector3::new(117.0, 121.0, 62.5)));
    robot
}

struct Newcomer {
    model: Model,
    load: Load,
    inertia: Inertia,
    lengths: Vec<f64>,
}

impl Newcomer {
    fn acceleration(&self, pose: &Pose, twist: &Twist) -> Twist {
        let mut wrench = self.load.wrench(pose);
        for cable in 0..self.model.cable_count() {
            let (path, arm) = self.model.path(cable, pose).expect("a course");
            let u = Vector3::from(path.direction);
            let moment = arm.cross(&u);
            let tension = self.model.elasticity(cable).tension(path.length, self.lengths[cable]).value.max(0.0);
            wrench += Twist::new(u.x, u.y, u.z, moment.x, moment.y, moment.z) * tension;
        }
        self.inertia.acceleration(&self.model, pose, twist, &wrench)
    }

    fn moved(pose: &Pose, twist: &Twist, time: f64) -> Pose {
        let omega: Vector3<f64> = twist.fixed_rows::<3>(3).into();
        let turn = Quaternion::from_imag(omega) * pose.rotation.quaternion() * (0.5 * time);
        let rotation = UnitQuaternion::new_normalize(pose.rotation.quaternion() + turn);
        Pose { position: pose.position + twist.fixed_rows::<3>(0) * time, rotation }
    }

    fn step(&self, pose: &Pose, twist: &Twist, h: f64) -> (Pose, Twist) {
        let first = self.acceleration(pose, twist);
        let twist_2 = twist + first * (0.5 * h);
        let second = self.acceleration(&Self::moved(pose, twist, 0.5 * h), &twist_2);
        let twist_3 = twist + second * (0.5 * h);
        let third = self.acceleration(&Self::moved(pose, &twist_2, 0.5 * h), &twist_3);
        let twist_4 = twist + third * h;
        let fourth = self.acceleration(&Self::moved(pose, &twist_3, h), &twist_4);
        let mean = (twist + (twist_2 + twist_3) * 2.0 + twist_4) / 6.0;
        (Self::moved(pose, &mean, h), twist + (first + (second + third) * 2.0 + fourth) * (h / 6.0))
    }
}

const ROBOT: &str = include_str!("../../studies/robots/simulator-in-motion.toml");

/// Change of a cable of the robot file.
type Change = fn(&mut Cable);

/// Machines by their damping: nothing, cables, cables and drums with friction by speed, the same and Coulomb's friction, at which drums switch some sixty times.
const LET_GO: &[(&str, Winches, Change)] = &[
    ("undamped", Winches::Ideal, |cable| cable.damping_time = None),
    ("damped", Winches::Ideal, |_| {}),
    ("drums", Winches::Drums, |cable| cable.winch.coulomb_friction = None),
    ("drums, Coulomb", Winches::Drums, |_| {}),
];

/// A machine 20 mm and 20 mrad beside its equilibrium, and commands that hold it there.
fn let_go(plant: &Plant) -> (PlantState, Vec<Command>) {
    let home = plant.model().robot().home_or_middle();
    let mut state = plant.at_rest(&home, &BALANCED).expect("a start");
    let commands = match plant.winches() {
        Winches::Ideal => {
            Command::lengths(&state.cables.iter().map(|cable| cable.controlled_length).collect::<Vec<_>>())
        }
        Winches::Drums => Command::torques(&plant.holding_torques(&state).expect("torques")),
    };
    state.set_pose(home.displaced(&Twist::new(0.02, 0.0, 0.0, 0.0, 0.02, 0.0)));
    plant.observe(&mut state).expect("a pose");
    (state, commands)
}

/// Tensions of that robot that balance its weight (N).
const BALANCED: [f64; 8] =
    [4437.939379, 2185.102672, 4635.974809, 1364.885073, 5056.065288, 2250.129390, 5449.229867, 1162.104629];

const TENSIONS: [f64; 8] = [3678.0, 2169.0, 4250.0, 1708.0, 3985.0, 2394.0, 4715.0, 1684.0];

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let mut group = criterion.benchmark_group("a step in time");
    let points = robot();
    let pulleys = place_pulleys(&points, &[(0.161, Vector3::z()); 8], &points.home_or_middle()).expect("placed");
    for (name, robot, composition) in
        [("elastic", points, Composition::ELASTIC), ("pulley+elastic", pulleys, Composition::PULLEY_ELASTIC)]
    {
        let (load, body) = (Load::of(&robot).expect("a load"), Body::of(&robot).expect("a body"));
        let model = Model::new(robot, composition).expect("a model");
        let plant = Plant::new(model.clone(), Winches::Ideal).expect("a machine");
        let pose = model.robot().home_or_middle();
        let mut state = plant.at_rest(&pose, &TENSIONS).expect("a start");
        let lengths: Vec<f64> = state.cables.iter().map(|cable| cable.controlled_length).collect();
        group.bench_function(format!("{name}: ours"), |bencher| {
            let commands = Command::lengths(&lengths);
            bencher.iter(|| plant.step(&mut state, &commands, black_box(1e-3)).expect("a step"));
        });
        let inertia = Inertia::new(&model, body);
        let newcomer = Newcomer { model, load, inertia, lengths: lengths.clone() };
        let mut now = (pose, Twist::zeros());
        group.bench_function(format!("{name}: newcomer"), |bencher| {
            bencher.iter(|| now = newcomer.step(&now.0, &now.1, black_box(1e-3)));
        });
    }
    group.finish();
    let mut group = criterion.benchmark_group("two seconds at 1 ms, let go");
    for (name, winches, change) in LET_GO {
        let mut robot = Robot::from_toml(ROBOT, "simulator-in-motion.toml").expect("a robot");
        robot.cables.iter_mut().for_each(change);
        let plant = Plant::new(Model::new(robot, Composition::ELASTIC).expect("a model"), *winches).expect("a machine");
        let (start, commands) = let_go(&plant);
        group.bench_function(*name, |bencher| {
            bencher.iter(|| {
                let mut state = start.clone();
                (0..2000).for_each(|_| plant.step(&mut state, &commands, black_box(1e-3)).expect("a step"));
                state
            });
        });
    }
    group.finish();
    criterion.final_summary();
}
