//! Robust calibrations for another program to judge (`cargo xtask judge`): data with rows displaced, and our optima, as JSON.
//!
//! `judge_losses FILE` writes them; without a file they are computed and counted only.

use cdpr::calibration::Loss;
use cdpr::calibration::fit::{Settings, Status, fit};
use cdpr::geometry::Pose;
use cdpr::measurement::{Samples, SensorSigmas};
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::Vector3;
use cdpr::reading::Keyword;
use cdpr::robot::Robot;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::{Value, json};

type Failure = Box<dyn std::error::Error>;

const POSES: usize = 91;
/// Rows that are displaced by 0.1 to 0.3 m.
const DISPLACED: [usize; 4] = [5, 37, 38, 70];
/// Stated accuracies of the lengths (m), and none, for which the fits assume a millimetre.
const ACCURACIES: [(Option<f64>, f64); 2] = [(None, 1e-3), (Some(2e-4), 2e-4)];

fn main() -> Result<(), Failure> {
    let nominal = Model::new(
        Robot::builtin("cablerobot-simulator-helicopter").ok_or("the robot is not built in")?,
        Composition::STANDARD,
    )?;
    let mut cases = Vec::new();
    for loss in [Loss::Huber, Loss::Cauchy] {
        for accuracy in ACCURACIES {
            cases.push(case(&nominal, loss, accuracy)?);
        }
    }
    if let Some(file) = std::env::args_os().nth(1) {
        std::fs::write(file, json!({ "cases": cases }).to_string())?;
    }
    Ok(())
}

/// All anchors of eight cables, from lengths with a uniform error of 1 mm.
fn case(nominal: &Model, loss: Loss, (stated, sigma): (Option<f64>, f64)) -> Result<Value, Failure> {
    let samples = Samples { sigmas: SensorSigmas { length: stated, ..SensorSigmas::default() }, ..samples(nominal)? };
    let settings = Settings { loss, ..Settings::default() };
    let found = fit(nominal, &samples, &"frame-anchor,platform-anchor".parse()?, &settings)?;
    if found.status != Status::Converged {
        return Err(found.reason.into());
    }
    let anchors = |model: &Model| -> Vec<[[f64; 3]; 2]> {
        model.robot().cables.iter().map(|cable| [cable.frame_anchor.into(), cable.platform_anchor.into()]).collect()
    };
    Ok(json!({
        "loss": loss.name(),
        "stated": stated.is_some(),
        "sigma_m": sigma,
        "threshold": found.loss_threshold,
        "positions": samples.poses.iter().map(|pose| <[f64; 3]>::from(pose.position)).collect::<Vec<_>>(),
        "rotations": samples.poses.iter().map(Pose::rotation_rows).collect::<Vec<_>>(),
        "lengths": samples.lengths.chunks(8).collect::<Vec<_>>(),
        "start": anchors(nominal),
        "found": anchors(&found.model),
        "cost": found.history.last(),
    }))
}

fn samples(nominal: &Model) -> Result<Samples, Failure> {
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut vector = |size: f64| Vector3::from_fn(|_, _| rng.random_range(-size..size));
    let mut machine = nominal.robot().clone();
    for cable in &mut machine.cables {
        cable.frame_anchor += vector(0.01);
        cable.platform_anchor += vector(0.01);
    }
    let machine = Model::new(machine, Composition::STANDARD)?;
    let mut samples = Samples { cable_count: 8, ..Samples::default() };
    for index in 0..POSES {
        let position = Vector3::new(0.0, 0.0, 1.6) + vector(1.5).component_mul(&Vector3::new(1.0, 1.0, 0.25));
        let mut pose = Pose::from_xyz_angles(position, vector(10.0_f64.to_radians()).into());
        samples.lengths.extend(machine.cable_lengths(&pose)?.iter().map(|length| length + vector(1e-3).x));
        if DISPLACED.contains(&index) {
            let direction = vector(1.0).normalize();
            pose.position += (0.2 + vector(0.1).x) * direction;
        }
        samples.poses.push(pose);
    }
    Ok(samples)
}
