//! The dissertation's machine rebuilt from its printed optimum, and its planar example: what its controllers reach on them.
//!
//! The studies are those of the folder `studies`; the numbers were recomputed from the dissertation's printed parameters with
//! an independent implementation and stand in its corrected form (a factor 10 in sec. 4.4, k_F = 200 kN in sec. 3.6).

use super::studies::experiment;
use cdpr_model::control::CommandedPose;
use cdpr_model::control::Status;
use cdpr_model::geometry::Pose;
use cdpr_study::Experiment;
use cdpr_study::accuracy::Accuracy;
use nalgebra::{Matrix2, Vector2, Vector3};

fn accuracy(experiment: &Experiment) -> Accuracy {
    let poses = experiment.poses(Vec::new(), 0).unwrap();
    let accuracy = experiment.assess(&poses).unwrap().accuracy;
    assert_eq!(accuracy.statuses.get("converged"), Some(&poses.len()), "{:?}", accuracy.statuses);
    accuracy
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found - expected).abs() < tolerance, "{found}, expected {expected} ± {tolerance}");
}

#[test]
fn the_nominal_controller_misses_on_the_twin_by_what_the_dissertation_measured_on_its_machine() {
    let accuracy = accuracy(&experiment("twin-nominal"));
    assert_eq!(accuracy.samples, 75);
    assert_near(1e3 * accuracy.position_error_m.mean, 38.8, 0.3);
    assert_near(accuracy.rotation_error_rad.mean.to_degrees(), 1.19, 0.02);
    assert_near(1e3 * accuracy.length_error_m.mean_abs, 23.7, 0.3);
}

#[test]
fn the_kinematic_calibration_leaves_four_millimetres_on_the_twin() {
    assert_near(1e3 * accuracy(&experiment("twin-kinematic-calibrated")).position_error_m.mean, 4.07, 0.05);
}

#[test]
fn the_planar_controller_misses_by_the_corrected_means_of_the_dissertation() {
    for (name, mean) in [("planar-wide-grid", 57.14), ("planar-low-grid", 117.83)] {
        assert_near(1e3 * accuracy(&experiment(name)).position_error_m.mean, mean, 0.02);
    }
}

/// A constant tension would give one zero of the error; tensions that fall with the length give three.
#[test]
fn the_planar_controller_is_exact_at_three_poses() {
    let experiment = experiment("planar-wide-grid");
    let mut operation = experiment.operation().unwrap();
    let mut error = |x: Vector2<f64>| -> Vector2<f64> {
        let commanded = Pose { position: Vector3::new(x[0], x[1], 0.0), ..Pose::identity() };
        let outcome = operation.answer(&CommandedPose::at(commanded));
        assert_eq!(outcome.status, Status::Converged);
        (outcome.pose.position - commanded.position).xy()
    };
    for zero in [Vector2::new(0.0, 5.2), Vector2::new(-3.974, 2.694), Vector2::new(3.557, 2.803)] {
        let mut x = zero + Vector2::new(0.05, -0.05);
        for _ in 0..20 {
            let h = 1e-5;
            let columns =
                [Vector2::x() * h, Vector2::y() * h].map(|step| (error(x + step) - error(x - step)) / (2.0 * h));
            x -= Matrix2::from_columns(&columns).try_inverse().unwrap() * error(x);
        }
        assert!(error(x).norm() < 1e-9, "a zero of the error");
        assert!((x - zero).norm() < 2e-3, "{x} is not {zero}");
    }
}
