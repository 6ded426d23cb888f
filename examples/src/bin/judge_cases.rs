//! Numbers for other programs to judge (`cargo xtask judge`): pulley lengths and elastic equilibria of random poses as JSON.
//!
//! `judge_cases FILE` writes them; without a file they are computed and counted only.

use cdpr::control;
use cdpr::control::CommandedPose;
use cdpr::control::Operation;
use cdpr::equilibrium::elastostatics::{self, Settings, Status};
use cdpr::geometry::{Pose, Twist};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::Vector3;
use cdpr::robot::{CableStiffness, Robot, StiffnessBasis};
use cdpr::statics::{Load, controlled_lengths};
use cdpr::tension::{Limits, closed_form};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

type Failure = Box<dyn std::error::Error>;

const POSES_PER_ROBOT: usize = 50;
const EQUILIBRIA_PER_ROBOT: usize = 6;
const COMMANDED_STATES: usize = 50;

fn main() -> Result<(), Failure> {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    let mut lengths = Vec::new();
    for (name, robot) in pulley_robots(&mut rng)? {
        lengths.push(lengths_of(name, &robot, &mut rng)?);
    }
    let mut equilibria = Vec::new();
    for (name, robot, effects) in elastic_robots()? {
        let model = Model::new(robot, effects.parse()?)?;
        for _ in 0..EQUILIBRIA_PER_ROBOT {
            equilibria.push(equilibrium_of(name, &model, &mut rng)?);
        }
    }
    equilibria.extend(emerging_states(&mut rng)?);
    assert_eq!((lengths.len(), equilibria.len()), (4, 3 * EQUILIBRIA_PER_ROBOT + COMMANDED_STATES));
    if let Some(file) = std::env::args_os().nth(1) {
        std::fs::write(file, json!({ "pulley_lengths": lengths, "equilibria": equilibria }).to_string())?;
    }
    Ok(())
}

/// Pulleys of two files, those of the simulator placed with upright axes, and the same with an axis of its own per cable.
fn pulley_robots(rng: &mut ChaCha8Rng) -> Result<Vec<(&'static str, Robot)>, Failure> {
    let mut tilted = builtin("cablerobot-simulator-helicopter")?;
    for cable in &mut tilted.cables {
        cable.set_pulley_swivel_axis(direction(rng));
        cable.set_pulley_radius(rng.random_range(0.02..0.5));
    }
    Ok(vec![
        ("caroca-pulleys", builtin("caroca-pulleys")?),
        ("cucablerobot", builtin("cucablerobot")?),
        ("simulator, upright axes", with_upright_pulleys(&builtin("cablerobot-simulator-helicopter")?)?),
        ("simulator, random axes and radii", tilted),
    ])
}

/// The simulator over points and over pulleys, and a suspended robot: cables whose stiffness is by their unstrained length.
fn elastic_robots() -> Result<Vec<(&'static str, Robot, &'static str)>, Failure> {
    let mut simulator = builtin("cablerobot-simulator-helicopter-elastostatic-calibrated")?;
    let mut suspended = builtin("cogiro")?;
    for robot in [&mut simulator, &mut suspended] {
        robot.platform.mass = Some(500.0);
        robot.platform.center_of_mass = Some(Vector3::new(0.05, -0.03, 0.12));
        if let Some(external) = &mut robot.external_wrench {
            external.includes_gravity = false;
            external.wrench = Twist::new(-20.0, 150.0, -300.0, 90.0, -60.0, 40.0);
        }
        for cable in &mut robot.cables {
            cable.stiffness.get_or_insert(CableStiffness::Axial(3e5));
            cable.stiffness_by = Some(StiffnessBasis::Unstrained);
        }
    }
    let over_pulleys = with_upright_pulleys(&simulator)?;
    Ok(vec![
        ("simulator, points", simulator, "elastic"),
        ("simulator, pulleys", over_pulleys, "pulley+elastic"),
        ("cogiro, suspended", suspended, "elastic"),
    ])
}

fn lengths_of(name: &str, robot: &Robot, rng: &mut ChaCha8Rng) -> Result<Value, Failure> {
    let model = Model::new(robot.clone(), "pulley".parse()?)?;
    let references: Vec<Vector3<f64>> = robot.cables.iter().map(|_| direction(rng)).collect();
    let mut poses = Vec::new();
    while poses.len() < POSES_PER_ROBOT {
        let pose = random_pose(robot, 1.5, 0.6, rng);
        // random axes meet poses inside a pulley or so near the axis that the swivel angle is noise
        let swivels: Option<Vec<f64>> =
            (0..model.cable_count()).map(|cable| model.swivel_angle(cable, &pose, &references[cable])).collect();
        let paths: Result<Vec<_>, _> = (0..model.cable_count()).map(|cable| model.path(cable, &pose)).collect();
        if let (Some(swivels), Ok(paths)) = (swivels, paths) {
            let lengths: Vec<f64> = paths.iter().map(|(path, _)| path.length).collect();
            let wrap_angles: Vec<f64> = paths.iter().map(|(path, _)| path.wrap_angle).collect();
            poses.push(json!({
                "pose": written(&pose), "lengths": lengths, "wrap_angles": wrap_angles, "swivel_angles": swivels,
            }));
        }
    }
    Ok(json!({ "name": name, "cables": cables(robot, &references, true), "poses": poses }))
}

/// Lengths that hold the platform near a random pose, and where it then rests by our solver.
fn equilibrium_of(name: &str, model: &Model, rng: &mut ChaCha8Rng) -> Result<Value, Failure> {
    let robot = model.robot();
    let load = Load::of(robot)?;
    let pose = random_pose(robot, 0.8, 0.1, rng);
    let wanted: Vec<f64> = robot.cables.iter().map(|_| rng.random_range(2000.0..5000.0)).collect();
    let near = Limits::new(wanted.clone(), wanted)?;
    let tensions =
        closed_form::solve(&model.structure_matrix(&pose)?, load.in_pattern(model, &pose).as_slice(), &near)?;
    let taut: Vec<f64> = tensions.tensions.iter().map(|tension| tension.max(0.0)).collect();
    let controlled: Vec<f64> =
        controlled_lengths(model, &pose, &taut)?.iter().map(|length| length + rng.random_range(-3e-3..3e-3)).collect();
    let found = elastostatics::solve(model, &controlled, &load, &pose, &Settings::default())?;
    assert_eq!(found.status, Status::Converged, "{name}: {:?}", found.reason);
    let references: Vec<Vector3<f64>> = robot.cables.iter().map(|_| direction(rng)).collect();
    let swivels: Vec<Option<f64>> =
        (0..model.cable_count()).map(|cable| model.swivel_angle(cable, &found.pose, &references[cable])).collect();
    let wrench = robot.external_wrench.as_ref().map_or_else(Twist::zeros, |external| external.wrench);
    Ok(json!({
        "name": name, "cables": cables(robot, &references, model.composition().pulley), "pose": written(&found.pose),
        "controlled_lengths": controlled, "tensions": found.tensions, "swivel_angles": swivels, "slack": found.slack,
        "mass": robot.platform.mass, "center_of_mass": robot.platform.center_of_mass.map(array),
        "gravity": robot.gravity.map(array), "wrench": wrench.as_slice(),
    }))
}

/// What emerges when the nominal kinematic controller commands random poses on the elastic simulator.
fn emerging_states(rng: &mut ChaCha8Rng) -> Result<Vec<Value>, Failure> {
    let (name, robot, effects) = elastic_robots()?.swap_remove(0);
    let machine = Model::new(robot, effects.parse()?)?;
    let control = Model::new(builtin("cablerobot-simulator-helicopter")?, Composition::STANDARD)?;
    let mut operation = Operation::new(&control, &machine, &vec![0.0; machine.cable_count()])?;
    let robot = machine.robot();
    let wrench = robot.external_wrench.as_ref().map_or_else(Twist::zeros, |external| external.wrench);
    let mut states = Vec::new();
    while states.len() < COMMANDED_STATES {
        let pose = random_pose(robot, 1.5, 0.2, rng);
        let outcome = operation.answer(&CommandedPose::at(pose));
        assert_eq!(outcome.status, control::Status::Converged, "{:?}", outcome.reason);
        let tensions = outcome.tensions.ok_or("an elastic machine has tensions")?;
        states.push(json!({
            "name": format!("{name}, commanded"), "cables": cables(robot, &vec![Vector3::x(); tensions.len()], false),
            "commanded": written(&pose), "pose": written(&outcome.pose), "tensions": tensions,
            "controlled_lengths": operation.controlled_lengths(&pose)?, "swivel_angles": vec![None::<f64>; tensions.len()],
            "mass": robot.platform.mass, "center_of_mass": robot.platform.center_of_mass.map(array),
            "gravity": robot.gravity.map(array), "wrench": wrench.as_slice(),
        }));
    }
    Ok(states)
}

fn cables(robot: &Robot, references: &[Vector3<f64>], over_pulleys: bool) -> Vec<Value> {
    let cable = |(cable, reference): (&cdpr::robot::Cable, &Vector3<f64>)| {
        json!({
            "frame_anchor": array(cable.frame_anchor), "platform_anchor": array(cable.platform_anchor),
            "radius": cable.pulley_radius().filter(|_| over_pulleys), "reference": array(*reference),
            "swivel_axis": cable.pulley_swivel_axis().filter(|_| over_pulleys).map(array),
            "stiffness": cable.axial_stiffness(),
        })
    };
    robot.cables.iter().zip(references).map(cable).collect()
}

/// Position and unit quaternion, the real part first.
fn written(pose: &Pose) -> Value {
    let q = pose.rotation.quaternion();
    json!({ "position": array(pose.position), "quaternion": [q.w, q.i, q.j, q.k] })
}

fn array(v: Vector3<f64>) -> [f64; 3] {
    v.into()
}

fn builtin(name: &str) -> Result<Robot, Failure> {
    Robot::builtin(name).ok_or_else(|| format!("{name} is not built in").into())
}

fn with_upright_pulleys(robot: &Robot) -> Result<Robot, Failure> {
    let home = robot.home_or_middle();
    let pulleys: Vec<_> =
        robot.cables.iter().map(|cable| (cable.pulley_radius().unwrap_or(0.1), Vector3::z())).collect();
    Ok(place_pulleys(robot, &pulleys, &home)?)
}

fn direction(rng: &mut ChaCha8Rng) -> Vector3<f64> {
    loop {
        let v = Vector3::from_fn(|_, _| rng.random_range(-1.0..1.0));
        if (0.1..1.0).contains(&v.norm()) {
            return v.normalize();
        }
    }
}

/// Within `reach` of the home pose along each axis (m, less for robots smaller than it), each angle within `turn` (rad).
fn random_pose(robot: &Robot, reach: f64, turn: f64, rng: &mut ChaCha8Rng) -> Pose {
    let home = robot.home_or_middle();
    let size =
        robot.cables.iter().map(|cable| (cable.frame_anchor - home.position).norm()).fold(f64::INFINITY, f64::min);
    let reach = reach.min(0.4 * size);
    let shift = Vector3::from_fn(|_, _| reach * rng.random_range(-1.0..1.0));
    let angles = [0, 1, 2].map(|_| turn * rng.random_range(-1.0..1.0));
    Pose { position: home.position + shift, rotation: Pose::from_xyz_angles(shift, angles).rotation * home.rotation }
}
