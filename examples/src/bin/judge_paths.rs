//! Paths of a lasso for another program to judge (`cargo xtask judge`): data and our values at several penalties, as JSON.
//!
//! `judge_paths FILE` writes them; without a file they are computed and counted only.

use cdpr::calibration::fit::{Settings, fit};
use cdpr::calibration::{Loss, PathSettings, Penalty, Towards, penalty_path};
use cdpr::geometry::Pose;
use cdpr::measurement::{Samples, SensorSigmas};
use cdpr::model::{Composition, FreeParameters, Model};
use cdpr::nalgebra::Vector3;
use cdpr::reading::Keyword;
use cdpr::robot::Robot;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

type Failure = Box<dyn std::error::Error>;

const POSES: usize = 91;
const SIGMA: f64 = 1e-3;

fn main() -> Result<(), Failure> {
    let nominal = Model::new(
        Robot::builtin("cablerobot-simulator-helicopter").ok_or("the robot is not built in")?,
        Composition::STANDARD,
    )?;
    let cases = [
        case(&nominal, Towards::File, "")?,
        case(&nominal, Towards::File, "platform-anchor")?,
        case(&nominal, Towards::Zero, "platform-anchor")?,
    ];
    if let Some(file) = std::env::args_os().nth(1) {
        std::fs::write(file, json!({ "cases": cases }).to_string())?;
    }
    Ok(())
}

/// Anchors of eight cables along a lasso.
fn case(nominal: &Model, towards: Towards, shrink: &str) -> Result<Value, Failure> {
    let samples = samples(nominal)?;
    let free: FreeParameters = "frame-anchor,platform-anchor".parse()?;
    let settings = Settings { loss: Loss::Squared, ..Settings::default() };
    let found = fit(nominal, &samples, &free, &settings)?;
    let question = PathSettings {
        penalty: Penalty::Lasso,
        towards,
        shrink: shrink.parse()?,
        points: 9,
        ..PathSettings::default()
    };
    let path = penalty_path(nominal, &samples, &found, &settings, &free, &question, &[])?;
    if path.points.iter().any(|point| !point.converged) {
        return Err("a point of the path has not converged".into());
    }
    let all = || path.parameters.iter();
    Ok(json!({
        "name": format!("lasso towards {}{}", towards.name(), if shrink.is_empty() { "" } else { " on platform anchors" }),
        "sigma_m": SIGMA,
        "positions": samples.poses.iter().map(|pose| <[f64; 3]>::from(pose.position)).collect::<Vec<_>>(),
        "rotations": samples.poses.iter().map(Pose::rotation_rows).collect::<Vec<_>>(),
        "lengths": samples.lengths.chunks(8).collect::<Vec<_>>(),
        "centre": all().map(|parameter| parameter.centre).collect::<Vec<_>>(),
        "is_penalised": all().map(|parameter| parameter.is_penalised).collect::<Vec<_>>(),
        "points": path.points.iter().map(|point| json!({ "lambda": point.lambda, "values": point.values })).collect::<Vec<_>>(),
    }))
}

/// Poses with lengths of a machine whose anchors are elsewhere by up to 2 cm at every second cable.
fn samples(nominal: &Model) -> Result<Samples, Failure> {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut vector = |size: f64| Vector3::from_fn(|_, _| rng.random_range(-size..size));
    let mut machine = nominal.robot().clone();
    for cable in machine.cables.iter_mut().step_by(2) {
        cable.frame_anchor += vector(0.02);
        cable.platform_anchor += vector(0.02);
    }
    let machine = Model::new(machine, Composition::STANDARD)?;
    let sigmas = SensorSigmas { length: Some(SIGMA), ..SensorSigmas::default() };
    let mut samples = Samples { cable_count: 8, sigmas, ..Samples::default() };
    for _ in 0..POSES {
        let position = Vector3::new(0.0, 0.0, 1.6) + vector(1.5).component_mul(&Vector3::new(1.0, 1.0, 0.25));
        let pose = Pose::from_xyz_angles(position, vector(10.0_f64.to_radians()).into());
        samples.lengths.extend(machine.cable_lengths(&pose)?.iter().map(|length| length + vector(SIGMA).x));
        samples.poses.push(pose);
    }
    Ok(samples)
}
