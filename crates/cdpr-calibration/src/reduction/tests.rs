//! Proposals of smaller models, and data that show none.

use super::{Evidence, Reduction, propose_reduction};
use crate::fit::{Settings, fit};
use crate::loss::Loss;
use crate::path::{PathSettings, Penalty, Towards, penalty_path};
use cdpr_model::geometry::{MotionPattern, Pose};
use cdpr_model::measurement::{Samples, SensorSigmas, Split};
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::robot::Robot;
use nalgebra::Vector3;

const SIGMA: f64 = 1e-3;

fn wave(index: usize) -> f64 {
    (1.3 * index as f64).sin() + 0.5 * (4.1 * index as f64).cos()
}

fn given() -> Model {
    Model::new(Robot::builtin("cablerobot-simulator-helicopter").unwrap(), Composition::STANDARD).unwrap()
}

/// Sixty poses with true rotations up to `turn` and measured ones up to `noise` (rad) beside the start's, of a robot with other anchors.
fn samples(turn: f64, noise: f64) -> Samples {
    let mut robot = given().robot().clone();
    for (index, cable) in robot.cables.iter_mut().enumerate() {
        cable.frame_anchor += 0.02 * Vector3::new(wave(index), wave(index + 9), wave(index + 20));
    }
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let home = model.robot().home_or_middle();
    let pose = |index: usize, size: f64| {
        let t = index as f64;
        let shift = Vector3::new(t.sin(), (1.7 * t).cos(), 0.5 * (2.3 * t).sin());
        let angles = [0.1 + size * wave(3 * index), size * wave(3 * index + 1), -0.05 + size * wave(3 * index + 2)];
        Pose::from_xyz_angles(home.position + shift, angles)
    };
    let lengths = (0..60).flat_map(|index| model.cable_lengths(&pose(index, turn)).unwrap());
    let lengths = lengths.enumerate().map(|(index, length)| length + SIGMA * wave(index)).collect();
    let sigmas =
        SensorSigmas { length: Some(SIGMA), rotation: (noise > 0.0).then_some(noise), ..SensorSigmas::default() };
    let poses = (0..60).map(|index| pose(index, turn + noise)).collect();
    Samples { poses, lengths, cable_count: 8, sigmas, ..Samples::default() }
}

fn proposed(samples: &Samples, free: &str, path: Option<&PathSettings>) -> Option<Reduction> {
    let (model, free) = (given(), free.parse::<FreeParameters>().unwrap());
    let settings = Settings { loss: Loss::Squared, ..Settings::default() };
    let fit = fit(&model, samples, &free, &settings).unwrap();
    let folds = Split::KFold(5).folds(samples, 1).unwrap();
    let path = path.map(|path| penalty_path(&model, samples, &fit, &settings, &free, path, &folds).unwrap());
    propose_reduction(&model, samples, &fit, &settings, &free, path.as_ref(), &folds).unwrap()
}

/// Sec. 6.3: 48 → 24 parameters, b = 0 exactly, 3R3T → 3T; data held out are predicted as by the full model, which the point is on these data.
#[test]
fn one_orientation_leads_to_a_point_by_rank() {
    let found = proposed(&samples(0.0, 0.0), "frame-anchor,platform-anchor", None).unwrap();
    assert_eq!((found.evidence, found.parameter_count), (Evidence::Rank, [48, 24]));
    assert_eq!(found.patterns, [MotionPattern::Spatial, MotionPattern::SpatialPoint]);
    assert!(found.model.robot().cables.iter().all(|cable| cable.platform_anchor == Vector3::zeros()));
    let [full, reduced] = found.position_mean_m;
    // the full model may answer with a rotation that no sample has: a percent
    assert!(reduced <= 1.01 * full, "{reduced} {full}");
    assert!(found.reason.contains("24 of 48"), "{}", found.reason);
    assert_eq!((found.left.len(), found.left[0].as_str()), (24, "platform-anchor[1].x"));
}

/// Orientations measured with 0.1° of noise leave the rank full; the noise is told in their accuracy.
#[test]
fn noise_of_orientations_hides_no_point() {
    let found = proposed(&samples(0.0, 0.1_f64.to_radians()), "frame-anchor,platform-anchor", None).unwrap();
    assert_eq!((found.evidence, found.parameter_count), (Evidence::Noise, [48, 24]));
    assert!(found.reason.contains("0.100° per axis"), "{}", found.reason);
}

#[test]
fn a_platform_that_turns_is_no_point() {
    assert!(proposed(&samples(0.1, 0.0), "frame-anchor,platform-anchor", None).is_none());
    // nothing else than frame anchors is free: there is nothing to leave out
    assert!(proposed(&samples(0.0, 0.0), "frame-anchor", None).is_none());
}

/// Lasso on b towards 0 leaves no platform anchor: the path shows the point too.
#[test]
fn a_path_shows_the_point() {
    let path = PathSettings {
        penalty: Penalty::Lasso,
        towards: Towards::Zero,
        shrink: "platform-anchor".parse().unwrap(),
        points: 6,
        ..PathSettings::default()
    };
    let found = proposed(&samples(0.0, 0.0), "frame-anchor,platform-anchor", Some(&path)).unwrap();
    assert_eq!((found.evidence, found.parameter_count), (Evidence::Path, [48, 24]));
    assert_eq!(found.patterns[1], MotionPattern::SpatialPoint);
}

/// Offsets that are 0 leave a path towards the file; the smaller model keeps the pattern.
#[test]
fn parameters_that_leave_a_path_are_held() {
    let path = PathSettings {
        penalty: Penalty::GroupLasso,
        shrink: "length-offset".parse().unwrap(),
        points: 12,
        ..PathSettings::default()
    };
    let found = proposed(&samples(0.2, 0.0), "frame-anchor,length-offset", Some(&path)).unwrap();
    assert_eq!((found.evidence, found.patterns[1]), (Evidence::Path, MotionPattern::Spatial));
    let [full, reduced] = found.parameter_count;
    assert!(full == 32 && (24..32).contains(&reduced), "{reduced}");
    assert!(found.left.iter().all(|name| name.starts_with("length-offset[")), "{:?}", found.left);
    for (cable, found) in found.model.robot().cables.iter().enumerate() {
        assert!(found.frame_anchor != given().robot().cables[cable].frame_anchor);
    }
}
