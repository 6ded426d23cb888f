//! Motions for another program to judge (`cargo xtask judge`): platforms let go beside their equilibrium, by several steps, as JSON; and the time of
//! a step.
//!
//! `judge_motion FILE` writes them; without a file they are computed and counted only.

use std::time::Instant;

use cdpr::control::Initial;
use cdpr::control::initial_tensions;
use cdpr::geometry::{Pose, Twist};
use cdpr::model::{Composition, Model, place_pulleys};
use cdpr::nalgebra::{Matrix3, Vector3};
use cdpr::plant::events::CableBreak;
use cdpr::plant::{Command, Event, Plant, PlantState, Winches};
use cdpr::robot::{CableStiffness, Robot, StiffnessBasis};
use serde_json::{Value, json};

type Failure = Box<dyn std::error::Error>;

/// Duration of every motion, and the times between the poses that are compared (s).
const DURATION: f64 = 3.0;
const SAMPLE: f64 = 0.05;

/// Steps of ours (s); the last one is compared, the others show how the error falls.
const STEPS: [f64; 4] = [1e-3, 5e-4, 2.5e-4, 5e-5];

/// A motion to judge.
struct Case {
    name: &'static str,
    robot: Robot,
    /// Tensions that the start is brought near to (N).
    level: f64,
    /// Cable (0-based) that is cut at 1 s.
    cut: Option<usize>,
    /// Displacement at the start (m, rad).
    displacement: [f64; 6],
}

fn main() -> Result<(), Failure> {
    // 50 mm and 3° about an axis across
    let release = [0.03, -0.03, 0.0265, 0.03, 0.03, -0.0305];
    let small = release.map(|x| 0.1 * x);
    let case = |name, robot, level, cut, displacement| Case { name, robot, level, cut, displacement };
    let cases = [
        case("simulator, all taut", simulator()?, 9000.0, None, small),
        case("simulator, cables go slack", simulator()?, 6000.0, None, release),
        case("simulator, cable 3 is cut", simulator()?, 6000.0, Some(2), release),
        case("cogiro, suspended, goes slack", off_centre("cogiro", 5e3)?, 400.0, None, release),
        case("ipanema-1, cable 1 is cut", off_centre("ipanema-1", 1e4)?, 300.0, Some(0), release),
    ];
    let motions = cases.iter().map(motion).collect::<Result<Vec<_>, _>>()?;
    let slack: Vec<bool> = motions.iter().map(|motion| motion["slack_cables"] != 0).collect();
    assert_eq!(slack, [false, true, true, true, true], "all but the small motion slacken a cable");
    let step = timed_step()?;
    if let Some(file) = std::env::args_os().nth(1) {
        std::fs::write(file, json!({ "motions": motions, "timed": step }).to_string())?;
    }
    Ok(())
}

fn builtin(name: &str) -> Result<Robot, Failure> {
    Robot::builtin(name).ok_or_else(|| format!("{name} is not built in").into())
}

/// The CableRobot Simulator, hung off-centre, on springs.
fn simulator() -> Result<Robot, Failure> {
    let mut robot = builtin("cablerobot-simulator-helicopter-elastostatic-calibrated")?;
    robot.platform.center_of_mass = Some(Vector3::new(-0.09, -0.05, 0.1));
    robot.platform.inertia = Some(Matrix3::new(117.0, 2.0, -1.0, 2.0, 121.0, 3.0, -1.0, 3.0, 62.5));
    robot.external_wrench = None;
    for cable in &mut robot.cables {
        cable.stiffness = Some(CableStiffness::Spring(1.47e5));
    }
    Ok(robot)
}

/// A built-in robot with its centre of mass moved and springs for cables (N/m).
fn off_centre(name: &str, stiffness: f64) -> Result<Robot, Failure> {
    let mut robot = builtin(name)?;
    robot.external_wrench = None;
    let center = robot.platform.center_of_mass.unwrap_or_default();
    robot.platform.center_of_mass = Some(center + Vector3::new(0.04, -0.03, 0.05));
    for cable in &mut robot.cables {
        cable.stiffness = Some(CableStiffness::Spring(stiffness));
    }
    Ok(robot)
}

/// The machine in equilibrium at its home pose with tensions near a level (N).
fn at_home(plant: &Plant, level: f64) -> Result<PlantState, Failure> {
    let pose = plant.model().robot().home_or_middle();
    let initial = Initial { tensions_N: Some(vec![level; plant.model().cable_count()]), ..Initial::default() };
    let tensions = initial_tensions(&initial, plant.model(), &pose)?;
    Ok(plant.at_rest(&pose, &tensions)?)
}

fn motion(case: &Case) -> Result<Value, Failure> {
    let model = Model::new(case.robot.clone(), Composition::ELASTIC)?;
    let plant = Plant::new(model, Winches::Ideal)?;
    let mut start = at_home(&plant, case.level)?;
    start.set_pose(start.pose.displaced(&Twist::from(case.displacement)));
    let lengths: Vec<f64> = start.cables.iter().map(|cable| cable.controlled_length).collect();
    let mut poses = Vec::new();
    let mut slack = vec![0; lengths.len()];
    for step in STEPS {
        let (path, was_slack) = path(&plant, &start, &lengths, case.cut, step)?;
        poses.push(json!({ "step": step, "poses": path }));
        slack = was_slack;
    }
    let body = start.inertia.body;
    let inertia: Vec<f64> = body.inertia.iter().copied().collect();
    let cables = case.robot.cables.iter().map(|cable| {
        json!({
            "frame_anchor": array(cable.frame_anchor), "platform_anchor": array(cable.platform_anchor),
            "stiffness": cable.spring_constant(),
        })
    });
    Ok(json!({
        "name": case.name, "cables": cables.collect::<Vec<_>>(), "lengths": lengths, "mass": body.mass,
        "center_of_mass": array(body.center_of_mass), "inertia": inertia,
        "gravity": case.robot.gravity.map(array), "start": written(&start.pose), "cut": case.cut, "cut_time": 1.0,
        "sample": SAMPLE, "duration": DURATION, "motions": poses,
        "slack_cables": slack.iter().filter(|&&count| count > 0).count(),
    }))
}

/// Poses at the samples, and how often each cable was slack.
fn path(
    plant: &Plant,
    start: &PlantState,
    lengths: &[f64],
    cut: Option<usize>,
    step: f64,
) -> Result<(Vec<Value>, Vec<usize>), Failure> {
    let (mut state, commands) = (start.clone(), Command::lengths(lengths));
    let (mut poses, mut slack) = (Vec::new(), vec![0; lengths.len()]);
    let every = (SAMPLE / step).round() as usize;
    let cut = cut.map(|cable| Event::new(1.0, CableBreak { cable }));
    for sample in 0..(DURATION / SAMPLE).round() as usize {
        if let Some(event) = cut.as_ref().filter(|event| (sample as f64 * SAMPLE - event.time).abs() < 1e-9) {
            plant.apply(&mut state, event.happening.as_ref());
        }
        for _ in 0..every {
            plant.step(&mut state, &commands, step)?;
            for (count, cable) in slack.iter_mut().zip(&state.cables) {
                *count += usize::from(cable.tension == 0.0);
            }
        }
        poses.push(written(&state.pose));
    }
    Ok((poses, slack))
}

/// Time of a step of the simulator over eight pulleys, the best of many runs (ns), and the scene for the other program.
fn timed_step() -> Result<Value, Failure> {
    let mut robot = simulator()?;
    for cable in &mut robot.cables {
        cable.stiffness = Some(CableStiffness::Axial(2.5e6));
        cable.stiffness_by = Some(StiffnessBasis::Unstrained);
    }
    let robot = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle())?;
    let plant = Plant::new(Model::new(robot.clone(), Composition::PULLEY_ELASTIC)?, Winches::Ideal)?;
    let rest = at_home(&plant, 4000.0)?;
    let mut start = rest.clone();
    start.set_pose(rest.pose.displaced(&Twist::new(0.01, 0.01, -0.01, 0.005, 0.005, 0.005)));
    let lengths: Vec<f64> = rest.cables.iter().map(|cable| cable.controlled_length).collect();
    let commands = Command::lengths(&lengths);
    let (mut best, count) = (f64::INFINITY, 1000);
    for _ in 0..60 {
        let mut state = start.clone();
        let before = Instant::now();
        for _ in 0..count {
            plant.step(&mut state, &commands, 1e-3)?;
        }
        best = best.min(before.elapsed().as_nanos() as f64 / f64::from(count));
    }
    let reference = Vector3::x();
    let cables = robot.cables.iter().map(|cable| {
        json!({
            "frame_anchor": array(cable.frame_anchor), "platform_anchor": array(cable.platform_anchor),
            "radius": cable.pulley_radius(), "reference": array(reference),
            "swivel_axis": cable.pulley_swivel_axis().map(array), "stiffness": cable.axial_stiffness(),
        })
    });
    let model = plant.model();
    let swivels: Vec<_> = (0..8).map(|cable| model.swivel_angle(cable, &start.pose, &reference)).collect();
    Ok(json!({
        "step_ns": best, "cables": cables.collect::<Vec<_>>(), "lengths": lengths, "start": written(&start.pose),
        "swivel_angles": swivels, "mass": start.inertia.body.mass,
        "center_of_mass": array(start.inertia.body.center_of_mass), "gravity": robot.gravity.map(array),
    }))
}

/// Position and unit quaternion, the real part first.
fn written(pose: &Pose) -> Value {
    let q = pose.rotation.quaternion();
    json!({ "position": array(pose.position), "quaternion": [q.w, q.i, q.j, q.k] })
}

fn array(v: Vector3<f64>) -> [f64; 3] {
    v.into()
}
