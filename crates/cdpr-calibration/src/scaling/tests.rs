//! Conditions against numbers of sec. 4.5, scales and maps.

use nalgebra::DVector;

use super::{KindScale, condition_map, conditioning, of_matrix, scaled_kind};
use crate::fit::{RowWeights, Settings};
use crate::plain_rows::PlainRows;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::robot::{CableStiffness, ParameterKind, Robot};
use cdpr_model::statics::controlled_lengths;

const ROWS: RowWeights = RowWeights { wrench: 1.0, length: 1e4 };

/// The planar example with cables of 200 000 N.
fn planar() -> Model {
    let mut robot = Robot::builtin("planar-example").unwrap();
    robot.cables.iter_mut().for_each(|cable| cable.stiffness = Some(CableStiffness::Axial(2e5)));
    Model::new(robot, Composition::ELASTIC).unwrap()
}

fn free() -> FreeParameters {
    "frame-anchor,compliance,wrench".parse().unwrap()
}

fn settings() -> Settings {
    Settings { row_weights: Some(ROWS), ..Settings::default() }
}

/// The 25 poses of W_T1 with closed-form tensions of the nominal model (eq. 3.41).
fn ideal() -> (Model, Samples) {
    let model = Model::new(planar().robot().clone(), Composition::ELASTIC).unwrap();
    let pose = |index: usize| {
        let (x, z) = (-4.0 + 2.0 * (index / 5) as f64, 0.5 + 1.375 * (index % 5) as f64);
        model.robot().motion_pattern.pose(model.robot().plane, &[x, z]).unwrap()
    };
    let poses: Vec<Pose> = (0..25).map(pose).collect();
    let (mut lengths, mut tensions) = (Vec::new(), Vec::new());
    for pose in &poses {
        let matrix = model.structure_matrix(pose).unwrap();
        let wrench = DVector::from_column_slice(&[0.0, -1962.0]);
        let middle = DVector::from_element(4, 4500.0);
        let inverse = matrix.clone().pseudo_inverse(1e-12).unwrap();
        let of_pose: Vec<f64> = (&middle - inverse * (wrench + matrix * &middle)).iter().copied().collect();
        lengths.extend(controlled_lengths(&model, pose, &of_pose).unwrap());
        tensions.extend(of_pose);
    }
    (model, Samples { poses, lengths, tensions: Some(tensions), cable_count: 4, ..Samples::default() })
}

/// Ours for the blocks of Table 4.3 (C25.2), two and three digits: anchors, stiffness, wrench alone; all in SI units with k_F in N; under 10⁶ N and 10³ N.
#[test]
fn conditions_are_those_of_the_table() {
    let (model, samples) = ideal();
    let scales = ["axial-stiffness=1", "wrench=1"].map(|text| text.parse::<KindScale>().unwrap());
    let plain = conditioning(&model, &samples, &free(), &settings(), &scales).unwrap();
    let near = |value: f64, expected: f64, digit: f64| assert!((value - expected).abs() < digit, "{value} {expected}");
    for (kind, expected) in plain.kinds.iter().zip([3.1, 1.45, 1.0]) {
        near(kind.condition, expected, 0.05);
    }
    near(plain.condition_scaled, 5.5e6, 0.05e6);
    let scales = ["axial-stiffness=1e6", "wrench=1e3"].map(|text| text.parse::<KindScale>().unwrap());
    let scaled = conditioning(&model, &samples, &free(), &settings(), &scales).unwrap();
    near(scaled.condition_scaled, 12.6, 0.05);
    // a script's own: 8.18 with columns of one length
    near(scaled.condition_unit_columns, 8.18, 0.005);
    let product: f64 = plain.influences.iter().map(|influence| influence.factor).product();
    assert!((product / plain.condition - 1.0).abs() < 1e-9, "{product} {}", plain.condition);
    let names: Vec<&str> = plain.influences.iter().map(|influence| influence.name).collect();
    assert_eq!(names, ["structure", "parameters", "samples", "scaling"]);
}

/// The scales that are found are no worse than the printed ones, nor than any of a map around them.
#[test]
fn found_scales_have_the_least_condition_of_a_map() {
    let (model, samples) = ideal();
    let found = conditioning(&model, &samples, &free(), &settings(), &[]).unwrap();
    assert!(found.condition_scaled < 12.6, "{}", found.condition_scaled);
    assert_eq!(found.scales[0], KindScale { kind: ParameterKind::FrameAnchor, factor: 1.0 });
    let kinds = [scaled_kind("compliance").unwrap(), scaled_kind("wrench").unwrap()];
    let map = condition_map(&model, &samples, &free(), &settings(), &[], kinds).unwrap();
    assert_eq!(map.points.len(), 625);
    let least = map.points.iter().map(|point| point.1).fold(f64::INFINITY, f64::min);
    let most = map.points.iter().map(|point| point.1).fold(0.0, f64::max);
    assert!(found.condition_scaled <= least && least < 1.3 * found.condition_scaled, "{least}");
    assert!(most > 100.0 * least);
}

/// A Gauss–Newton step in scaled parameters, scaled back, is the step in SI units: the condition of the scaled problem is 10⁵ times smaller, and the step
/// the same to what the unscaled condition leaves of sixteen digits.
#[test]
fn steps_do_not_depend_on_scales() {
    let (model, samples) = ideal();
    let parameters = free().parameters(&model, &FreeParameters::default()).unwrap();
    let matrix = PlainRows::of(&model, &samples, &parameters, ROWS).unwrap().jacobian;
    let right = DVector::from_fn(matrix.nrows(), |row, _| (1.3 * row as f64).sin());
    let step = |scale: &dyn Fn(ParameterKind) -> f64| {
        let factors: Vec<f64> = parameters.iter().map(|parameter| scale(parameter.kind)).collect();
        let mut scaled = matrix.clone();
        scaled.column_iter_mut().zip(&factors).for_each(|(mut column, factor)| column *= *factor);
        let condition = of_matrix(&scaled).1;
        let solved = scaled.svd(true, true).solve(&right, 0.0).unwrap();
        (DVector::from_fn(solved.len(), |k, _| solved[k] * factors[k]), condition)
    };
    let (plain, unscaled) = step(&|_| 1.0);
    let (scaled, condition) = step(&|kind| match kind {
        ParameterKind::Compliance => 2.5e-5,
        ParameterKind::Wrench => 1e3,
        _ => 1.0,
    });
    assert!(unscaled > 1e4 * condition, "{unscaled} {condition}");
    for k in 0..plain.len() {
        assert!((plain[k] / scaled[k] - 1.0).abs() < 1e-16 * unscaled * 100.0, "{k}: {} {}", plain[k], scaled[k]);
    }
}

#[test]
fn scales_that_mean_nothing_are_refused() {
    for text in ["compliance", "compliance=0", "wrench=-1", "wrench=many", "width=3"] {
        assert!(text.parse::<KindScale>().is_err(), "{text}");
    }
    assert!("length=1,".parse::<RowWeights>().is_err());
}
