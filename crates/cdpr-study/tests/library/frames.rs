//! Poses of a tracker with a world of its own and of a marker that is not the platform, on the elastic twin.

use super::studies::study;
use super::support::builtin;
use cdpr_calibration::selection::{self, Judgement, Selection, Warnings, select};
use cdpr_calibration::unobserved;
use cdpr_calibration::{FrameEstimate, Prior, candidate, fit};
use cdpr_model::control::simulate::simulate;
use cdpr_model::control::winch_offsets;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, Split};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{ParameterKind, Robot};
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// The record of the study from which the elastostatic model is identified, the machine, and a file whose frame anchors are wrong by centimetres.
fn record() -> (Robot, Robot, Samples) {
    let study = study("twin-elastostatic-measurements");
    let control = Model::new(builtin(&study.control.robot), Composition::STANDARD).unwrap();
    let machine = Model::new(builtin(&study.machine.robot), Composition::ELASTIC).unwrap();
    let pose = study.initial_pose(machine.robot()).unwrap();
    let offsets = winch_offsets(&study.initial, &control, &machine, &pose).unwrap();
    let poses = study.commanded_poses(machine.robot(), Vec::new(), 0).unwrap();
    let samples = simulate(&control, &machine, &offsets, &poses, &study.noise.unwrap(), 0).unwrap().samples;
    let mut file = machine.robot().clone();
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    for cable in &mut file.cables {
        (0..3).for_each(|k| cable.frame_anchor[k] += rng.random_range(-0.04..0.04));
    }
    (file, machine.robot().clone(), samples)
}

fn turned(axis: [f64; 3], degrees: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::new(Vector3::from(axis).normalize() * degrees.to_radians())
}

fn product(a: &Pose, b: &Pose) -> Pose {
    Pose { position: a.transform(&b.position), rotation: a.rotation * b.rotation }
}

fn inverse(pose: &Pose) -> Pose {
    let rotation = pose.rotation.inverse();
    Pose { position: -(rotation * pose.position), rotation }
}

/// The motion that lays points on others with the least squares.
fn laid(from: &[Vector3<f64>], to: &[Vector3<f64>]) -> Pose {
    let middle = |points: &[Vector3<f64>]| points.iter().sum::<Vector3<f64>>() / points.len() as f64;
    let (a, b) = (middle(from), middle(to));
    let moment: Matrix3<f64> = from.iter().zip(to).map(|(p, q)| (q - b) * (p - a).transpose()).sum();
    let svd = moment.svd(true, true);
    let (u, v_t) = (svd.u.unwrap(), svd.v_t.unwrap());
    let mirror = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, (u * v_t).determinant().signum()));
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(u * mirror * v_t));
    Pose { position: b - rotation * a, rotation }
}

fn chosen(file: &Robot, samples: &Samples) -> Selection {
    let list = "standard;standard:frame-anchor,length-offset;elastic:frame-anchor,compliance,wrench;\
         elastic:frame-anchor,platform-anchor,compliance,wrench";
    let folds = Split::Blocks(5).folds(samples, 0).unwrap();
    let fit = fit::Settings {
        priors: vec![Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 }],
        ..fit::Settings::default()
    };
    let settings = selection::Settings { fit, ..selection::Settings::default() };
    select(file, &candidate::parse_list(list).unwrap(), samples, &folds[..1], &settings, &unobserved).unwrap()
}

fn recommended(selection: &Selection) -> &Judgement {
    selection.candidates[selection.recommended.unwrap()].outcome.as_ref().unwrap()
}

/// A world tilted by 40° and 2 m away and a marker turned by 15° and 0.1 m off, at once: the model of the undisturbed record, its error, frames
/// within three deviations of the truth once the machine's anchors are laid on the file's, and a robot in the frame of its file.
#[test]
fn frames_are_found_beside_an_elastic_model() {
    let (file, machine, plain) = record();
    let tracker = Pose { position: Vector3::new(1.2, -1.4, 0.8), rotation: turned([0.5, 0.3, 0.8], 40.0) };
    let marker = Pose { position: Vector3::new(0.06, 0.0, 0.08), rotation: turned([1.0, -0.4, 0.2], 15.0) };
    let mut moved = plain.clone();
    for pose in &mut moved.poses {
        *pose = product(&inverse(&tracker), &product(pose, &marker));
    }
    let (before, after) = (chosen(&file, &plain), chosen(&file, &moved));
    assert_eq!(before.frames, None);
    let warnings = after.warnings(&moved, &Warnings::default());
    assert!(warnings.list()[0].starts_with("frames: "), "{warnings:?}");
    let (without, with) = (recommended(&before), recommended(&after));
    let errors = [without, with].map(|judged| 1e3 * judged.validation.position_error_m.mean);
    let frames = with.fit.frames.as_ref().unwrap();
    println!("mean errors {errors:.3?} mm; {frames:?}");
    let names = [&before, &after].map(|selection| &selection.candidates[selection.recommended.unwrap()].name);
    assert_eq!(*names[1], format!("{},tracker-frame,marker-frame", names[0]));
    assert!((errors[1] / errors[0] - 1.0).abs() < 0.1, "{errors:?}");
    assert_eq!(frames.gauge.free, ["translation", "rotation"]);

    let anchors = |robot: &Robot, platform: bool| -> Vec<Vector3<f64>> {
        robot.cables.iter().map(|cable| if platform { cable.platform_anchor } else { cable.frame_anchor }).collect()
    };
    for (platform, estimate, truth) in [(false, &frames.tracker, &tracker), (true, &frames.marker, &marker)] {
        let truth = product(&laid(&anchors(&machine, platform), &anchors(&file, platform)), truth);
        let FrameEstimate { position_m, rotation_rad, sigma_position_m, sigma_rotation_rad, .. } = estimate.unwrap();
        let error = truth.displacement_to(&Pose::from_xyz_angles(position_m.into(), rotation_rad));
        for k in 0..3 {
            let ratios = [error[k] / sigma_position_m[k], error[3 + k] / sigma_rotation_rad[k]];
            assert!(ratios.iter().all(|ratio| ratio.abs() < 3.0), "{platform} {k}: {ratios:?} {error}");
        }
        // the calibrated file is where its file was
        let own = laid(&anchors(with.fit.model.robot(), platform), &anchors(&file, platform));
        assert!(platform || (own.position.norm() < 1e-6 && own.rotation.angle() < 1e-6), "{own:?}");
    }
    assert_eq!(with.fit.model.robot().home, file.home);
    assert_eq!(with.fit.model.robot().gravity, file.gravity);
}
