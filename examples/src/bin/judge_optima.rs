//! Least largest errors and fits within bounds for another program to judge (`cargo xtask judge`): data, start values and our optima, as JSON.
//!
//! `judge_optima FILE` writes them; without a file they are computed and counted only.

use cdpr::calibration::fit::{Fit, Minimizer, Settings, Status, fit};
use cdpr::calibration::{Loss, Minimize, Objective};
use cdpr::geometry::Pose;
use cdpr::measurement::Samples;
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::Vector3;
use cdpr::robot::Robot;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

type Failure = Box<dyn std::error::Error>;

/// Radius of the pulleys that the file states, none of which the machine has (m).
const RADIUS: f64 = 0.05;

fn main() -> Result<(), Failure> {
    let planar = Robot::builtin("planar-example").ok_or("the robot is not built in")?;
    let spatial = Robot::builtin("cablerobot-simulator-helicopter").ok_or("the robot is not built in")?;
    let largest =
        |objective| Settings { objective, minimize: Minimize::Max, loss: Loss::Squared, ..Settings::default() };
    let mut with_pulleys = spatial.clone();
    for cable in &mut with_pulleys.cables {
        cable.set_pulley_radius(RADIUS);
        cable.set_pulley_swivel_axis(Vector3::z());
    }
    let bounded = Settings { minimizer: Minimizer::TrustRegion, loss: Loss::Squared, ..Settings::default() };
    let of = |name: &str, robot: &Robot, composition, free: &str, settings: &Settings| {
        let model = Model::new(robot.clone(), composition)?;
        let samples = samples(robot)?;
        let found = fit(&model, &samples, &free.parse()?, settings)?;
        match found.status {
            Status::Converged => Ok(case(name, &model, &samples, &found)),
            _ => Err(Failure::from(format!("{name}: {}", found.reason))),
        }
    };
    let standard = Composition::STANDARD;
    let cases = [
        of("largest length", &spatial, standard, "frame-anchor", &largest(Objective::Length))?,
        of("largest pose", &planar, standard, "frame-anchor", &largest(Objective::Pose))?,
        of("radii within bounds", &with_pulleys, Composition::PULLEY, "frame-anchor,pulley-radius", &bounded)?,
    ];
    if let Some(file) = std::env::args_os().nth(1) {
        std::fs::write(file, json!({ "cases": cases }).to_string())?;
    }
    Ok(())
}

fn case(name: &str, model: &Model, samples: &Samples, found: &Fit) -> Value {
    let anchors = |model: &Model| -> Vec<[[f64; 3]; 2]> {
        model.robot().cables.iter().map(|cable| [cable.frame_anchor.into(), cable.platform_anchor.into()]).collect()
    };
    let radii = |model: &Model| -> Vec<Option<f64>> {
        model.robot().cables.iter().map(|cable| cable.pulley_radius()).collect()
    };
    json!({
        "name": name,
        "positions": samples.poses.iter().map(|pose| <[f64; 3]>::from(pose.position)).collect::<Vec<_>>(),
        "rotations": samples.poses.iter().map(Pose::rotation_rows).collect::<Vec<_>>(),
        "lengths": samples.lengths.chunks(samples.cable_count).collect::<Vec<_>>(),
        "start": { "anchors": anchors(model), "radii": radii(model) },
        "found": { "anchors": anchors(&found.model), "radii": radii(&found.model) },
        "largest": found.certificate.as_ref().map(|certificate| certificate.largest),
    })
}

/// Lengths of a machine without pulleys whose anchors are some millimetres off, with a uniform error of 1 mm.
fn samples(robot: &Robot) -> Result<Samples, Failure> {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut vector = |size: f64| Vector3::from_fn(|_, _| rng.random_range(-size..size));
    let mut machine = robot.clone();
    let is_planar = machine.motion_pattern.is_planar();
    let seen = if is_planar { Vector3::new(1.0, 1.0, 0.0) } else { Vector3::repeat(1.0) };
    for cable in &mut machine.cables {
        cable.frame_anchor += vector(0.01).component_mul(&seen);
    }
    let machine = Model::new(machine, Composition::STANDARD)?;
    let home = if is_planar { Vector3::new(0.0, 2.0, 0.0) } else { Vector3::new(0.0, 0.0, 1.6) };
    let mut samples = Samples { cable_count: robot.cables.len(), ..Samples::default() };
    for _ in 0..40 {
        let position = home + vector(1.5).component_mul(&Vector3::new(1.0, 1.0, 0.25)).component_mul(&seen);
        let turn = if is_planar { Vector3::zeros() } else { vector(10.0_f64.to_radians()) };
        let pose = Pose::from_xyz_angles(position, turn.into());
        samples.lengths.extend(machine.cable_lengths(&pose)?.iter().map(|length| length + vector(1e-3).x));
        samples.poses.push(pose);
    }
    Ok(samples)
}
