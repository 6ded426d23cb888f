//! Derivatives against dual numbers, and the laws that every model obeys.

mod wrap_side;

use nalgebra::{Const, SVector, Vector3};
use num_dual::DualVec;

use super::*;
use crate::cable::{CableInput, CablePath, outlet};
use crate::geometry::{MotionPattern, Plane, Pose, Twist};
use crate::robot::{Assumption, Cable, Parameter, ParameterKind, Platform, Pulley, Robot, WrapSide};
use crate::scalar::{add, rotate};
use wrap_side::{planar_poses, planar_robot};

/// Derivatives by [δr; δφ], frame anchor, platform anchor, radius.
type Dual = DualVec<f64, Const<13>>;

fn variable(value: f64, index: usize) -> Dual {
    Dual::new(value, num_dual::Derivative::some(SVector::<f64, 13>::ith(index, 1.0)))
}

fn gradient(value: &Dual) -> SVector<f64, 13> {
    value.eps.unwrap_generic(Const, Const::<1>)
}

/// A cable that comes down from a pulley at an odd angle.
fn tilted_pulley_cable() -> Cable {
    Cable {
        name: "1".to_owned(),
        frame_anchor: Vector3::new(-2.0, 1.5, 3.0),
        platform_anchor: Vector3::new(0.3, -0.2, 0.1),
        pulley: Some(Pulley::Whole { radius: 0.12, swivel_axis: Vector3::new(0.2, -0.3, 0.9).normalize().into() }),
        length_scale: Some(1.03),
        length_offset: Some(-0.2),
        ..Cable::default()
    }
}

fn robot_of(cables: Vec<Cable>) -> Robot {
    Robot {
        name: "test".to_owned(),
        title: None,
        motion_pattern: MotionPattern::Spatial,
        kind: None,
        plane: Plane::default(),
        gravity: None,
        notes: vec![],
        assumptions: vec![],
        source: None,
        platform: Platform::default(),
        home: None,
        external_wrench: None,
        travel: None,
        cables,
        reference_checks: vec![],
        calibration: None,
        tracked: None,
        obstacles: vec![],
    }
}

fn tilted_pose() -> Pose {
    Pose::from_xyz_angles(Vector3::new(0.1, -0.2, 0.4), [0.2, -0.3, 0.4])
}

/// Path of the cable in dual numbers: pose displaced by [δr; δφ] to first order, which is exact for dual numbers.
fn dual_path(robot: &Robot, pose: &Pose, with_pulley: bool) -> CablePath<Dual> {
    let cable = &robot.cables[0];
    let numbers = |v: Vector3<f64>, first: usize| [0, 1, 2].map(|k| variable(v[k], first + k));
    let moment_arm = rotate(&pose.rotation_rows().map(|row| row.map(Dual::from)), numbers(cable.platform_anchor, 9));
    let turn = numbers(Vector3::zeros(), 3);
    let anchor = add(numbers(pose.position, 0), add(moment_arm, crate::scalar::cross(turn, moment_arm)));
    let frame_anchor = numbers(cable.frame_anchor, 6);
    match (with_pulley, cable.pulley_swivel_axis()) {
        (true, Some(axis)) => {
            let radius = variable(cable.pulley_radius().unwrap(), 12);
            let constants = |v: Vector3<f64>| [0, 1, 2].map(|k| Dual::from(v[k]));
            match robot.pulley_side(cable) {
                None => outlet::pulley::path(frame_anchor, constants(axis), radius, anchor),
                Some(side) => {
                    outlet::pulley::path_on_side(frame_anchor, constants(axis), constants(side), radius, anchor)
                }
            }
        }
        _ => outlet::point::path(frame_anchor, anchor),
    }
}

/// Analytic and dual derivatives of length and direction agree; both are exact, so only rounding separates them.
fn check_derivatives(robot: &Robot, pose: &Pose, with_pulley: bool) {
    let composition = if with_pulley { Composition::PULLEY } else { Composition::STANDARD };
    let model = Model::new(robot.clone(), composition).unwrap();
    let (path, moment_arm) = model.path(0, pose).unwrap();
    // indices 9.. are the platform anchor, 12 the radius; the layout needs 13 variables
    let dual = dual_path(robot, pose, with_pulley);
    let (by_pose, directions_by_pose) = path.by_pose(moment_arm.into());
    let (by_anchor, directions_by_anchor) = path.by_platform_anchor(&pose.rotation_rows());
    // near the axis and the rim directions change fast, and rounding grows with their gradient (1/m)
    let tolerance = 1e-12 * path.direction_gradient.iter().flatten().fold(1.0, |max: f64, x| max.max(x.abs()));
    let analytic = |pose: [f64; 6], frame: [f64; 3], platform: [f64; 3], radius: f64| {
        let mut all = pose.to_vec();
        all.extend(frame);
        all.extend(platform);
        all.push(radius);
        SVector::<f64, 13>::from_vec(all)
    };
    let expected = analytic(by_pose, path.direction, by_anchor, path.length_by_radius);
    assert!((gradient(&dual.length) - expected).amax() < tolerance, "{} {expected}", gradient(&dual.length));
    for k in 0..3 {
        let frame = path.direction_gradient[k].map(|x| -x);
        let expected = analytic(directions_by_pose[k], frame, directions_by_anchor[k], path.direction_by_radius[k]);
        assert!((gradient(&dual.direction[k]) - expected).amax() < tolerance, "row {k}");
    }
}

#[test]
fn derivatives_of_both_outlets_agree_with_dual_numbers() {
    let mut cable = tilted_pulley_cable();
    for pose in [tilted_pose(), Pose::identity(), Pose::from_xyz_angles(Vector3::new(-1.7, 1.4, 5.0), [1.0, 0.5, -2.0])]
    {
        check_derivatives(&robot_of(vec![cable.clone()]), &pose, false);
        check_derivatives(&robot_of(vec![cable.clone()]), &pose, true);
    }
    // nearer to the axis than the radius, below and above: there eq. 2.19 and principal values fail
    cable.set_pulley_swivel_axis(Vector3::z());
    for z in [-1.0, 1.0] {
        let near_axis = Pose { position: Vector3::new(-2.0 + 0.05 - 0.3, 1.5 + 0.2, 3.0 + z), ..Pose::identity() };
        check_derivatives(&robot_of(vec![cable.clone()]), &near_axis, true);
    }
}

/// The second derivatives of the length by anchor and radius: ∂²q/∂r_p∂p_B = −∂u/∂r_p and ∂²q/∂r_p² = (1 − cos β)²/q_f,
/// so that the Hessian is symmetric.
#[test]
fn second_derivatives_by_anchor_and_radius_are_one_symmetric_matrix() {
    let swivelling = (robot_of(vec![tilted_pulley_cable()]), vec![tilted_pose(), Pose::identity()]);
    for (robot, poses) in [swivelling, (planar_robot(WrapSide::Right), planar_poses())] {
        for pose in poses {
            let model = Model::new(robot.clone(), Composition::PULLEY).unwrap();
            let (path, _) = model.path(0, &pose).unwrap();
            let by_radius = gradient(&dual_path(&robot, &pose, true).length_by_radius);
            for k in 0..3 {
                assert!((by_radius[k] + path.direction_by_radius[k]).abs() < 1e-12);
                for column in 0..3 {
                    let (upper, lower) = (path.direction_gradient[k][column], path.direction_gradient[column][k]);
                    assert!((upper - lower).abs() < 1e-13);
                }
            }
            let turned = 1.0 - path.wrap_angle.cos();
            assert!((by_radius[12] - turned * turned / path.free_length).abs() < 1e-12);
        }
    }
}

/// A nanometre from the swivel axis and from the rim derivatives exist and are right; without a path there is an error.
/// Nothing is ever NaN.
#[test]
fn next_to_axis_and_rim_derivatives_are_finite_and_right() {
    let cable = Cable {
        frame_anchor: Vector3::zeros(),
        platform_anchor: Vector3::zeros(),
        pulley: Some(Pulley::Whole { radius: 0.12, swivel_axis: Vector3::z().into() }),
        ..tilted_pulley_cable()
    };
    let robot = robot_of(vec![cable]);
    let model = Model::new(robot.clone(), Composition::PULLEY).unwrap();
    let radius = 0.12;
    let mut without = 0;
    for exponent in 3..=18 {
        let distance = 10_f64.powi(-exponent);
        for turn in 0..12 {
            let angle = f64::from(turn) * std::f64::consts::TAU / 12.0 + 0.1;
            let rim = Vector3::new(radius + (radius + distance) * angle.cos(), 0.0, (radius + distance) * angle.sin());
            let axis =
                Vector3::new(distance * angle.cos(), distance * angle.sin(), if turn % 2 == 0 { 1.0 } else { -1.0 });
            for position in [rim, axis] {
                let pose = Pose { position, ..Pose::identity() };
                let Ok((path, _)) = model.path(0, &pose) else {
                    without += 1;
                    continue;
                };
                let gradient = path.direction_gradient.iter().flatten();
                let numbers = [path.length, path.wrap_angle, path.length_by_radius];
                assert!(gradient.chain(&path.direction_by_radius).chain(&numbers).all(|x| x.is_finite()), "{pose:?}");
                // nearer than this, rounding of the position itself determines the digits
                if distance >= 1e-9 {
                    check_derivatives(&robot, &pose, true);
                }
            }
        }
    }
    assert!(without > 0, "the nearest poses have no course");
}

#[test]
fn radius_zero_gives_the_base_model_in_values_and_derivatives() {
    let mut cable = tilted_pulley_cable();
    cable.set_pulley_radius(0.0);
    let path = |composition| {
        let model = Model::new(robot_of(vec![cable.clone()]), composition).unwrap();
        model.path(0, &tilted_pose()).unwrap()
    };
    let ((base, moment_arm), (pulley, _)) = (path(Composition::STANDARD), path(Composition::PULLEY));
    assert!((base.length - pulley.length).abs() < 1e-14);
    let (base_pose, base_direction) = base.by_pose(moment_arm.into());
    let (pulley_pose, pulley_direction) = pulley.by_pose(moment_arm.into());
    for k in 0..6 {
        assert!((base_pose[k] - pulley_pose[k]).abs() < 1e-14);
        for row in 0..3 {
            assert!((base_direction[row][k] - pulley_direction[row][k]).abs() < 1e-14);
        }
    }
}

/// r_p = 0 is a point outlet, even if the platform anchor lies on the swivel axis.
#[test]
fn radius_zero_has_no_axis_to_avoid() {
    let cable = Cable {
        frame_anchor: Vector3::new(0.0, 0.0, 3.0),
        pulley: Some(Pulley::Whole { radius: 0.0, swivel_axis: Vector3::z().into() }),
        name: "1".to_owned(),
        ..Cable::default()
    };
    let model = Model::new(robot_of(vec![cable]), Composition::PULLEY).unwrap();
    let (path, _) = model.path(0, &Pose::identity()).unwrap();
    assert_eq!((path.length, path.direction), (3.0, [0.0, 0.0, 1.0]));
}

/// `∂q/∂(twist) = −A`: the work of pulling a cable in equals that of its force.
#[test]
fn structure_matrix_is_minus_the_length_gradient() {
    for composition in [Composition::STANDARD, Composition::PULLEY] {
        let model = Model::new(robot_of(vec![tilted_pulley_cable()]), composition).unwrap();
        let pose = tilted_pose();
        let structure_matrix = model.structure_matrix(&pose).unwrap();
        let h = 1e-6; // central difference: truncation ~ h², rounding ~ ε/h
        for axis in 0..6 {
            let twist = Twist::ith(axis, h);
            let ahead = model.cable_lengths(&pose.displaced(&twist)).unwrap()[0];
            let behind = model.cable_lengths(&pose.displaced(&-twist)).unwrap()[0];
            let slope = (ahead - behind) / (2.0 * h);
            assert!((slope + structure_matrix[(axis, 0)]).abs() < 1e-8, "axis {axis}");
        }
    }
}

/// Away from the axis the formulas of the dissertation hold (eq. 2.19).
#[test]
fn pulley_length_agrees_with_the_dissertation_away_from_the_axis() {
    let radius = 0.161;
    for (b_xy, b_z) in [(2.0, -3.0), (0.5, 1.0), (4.0, 0.0), (0.2, -0.5)] {
        let path = outlet::pulley::path([0.0; 3], [0.0, 0.0, 1.0], radius, [b_xy, 0.0, b_z]);
        let center_distance = f64::hypot(b_xy - radius, b_z);
        let free = (center_distance * center_distance - radius * radius).sqrt();
        let wrap = (free / center_distance).acos() + (b_z / center_distance).acos();
        assert!((path.length - (free + radius * wrap)).abs() < 1e-14);
    }
}

/// Nearer to the axis than the radius eq. 2.19 takes an angle with the wrong sign (see the book, “Models”).
#[test]
fn near_the_axis_the_wrap_angle_is_counted_the_right_way() {
    let (radius, b_xy, b_z) = (0.161, 0.1, 1.0);
    let path = outlet::pulley::path([0.0; 3], [0.0, 0.0, 1.0], radius, [b_xy, 0.0, b_z]);
    let center_distance = f64::hypot(b_xy - radius, b_z);
    let free = (center_distance * center_distance - radius * radius).sqrt();
    let printed = free + radius * ((free / center_distance).acos() + (b_z / center_distance).acos());
    let surplus = 2.0 * radius * (b_z / center_distance).acos();
    assert!((printed - path.length - surplus).abs() < 1e-13);
    // tangent point on the circle, with the free part tangent to it
    let u = path.direction;
    let contact = [b_xy + path.free_length * u[0], b_z + path.free_length * u[2]];
    assert!((f64::hypot(contact[0] - radius, contact[1]) - radius).abs() < 1e-14);
    assert!(((contact[0] - radius) * u[0] + contact[1] * u[2]).abs() < 1e-14);
}

#[test]
fn degenerate_courses_are_named_and_never_nan() {
    let cable = Cable {
        pulley: Some(Pulley::Whole { radius: 0.12, swivel_axis: Vector3::z().into() }),
        frame_anchor: Vector3::zeros(),
        ..tilted_pulley_cable()
    };
    let cable = Cable { platform_anchor: Vector3::zeros(), ..cable };
    let at = |x: f64, z: f64, composition| {
        let model = Model::new(robot_of(vec![cable.clone()]), composition).unwrap();
        model.path(0, &Pose { position: Vector3::new(x, 0.0, z), ..Pose::identity() }).unwrap_err()
    };
    use crate::cable::GeometryError as Reason;
    assert_eq!(at(0.0, 0.0, Composition::STANDARD), Reason::ZeroLength { cable: 1 });
    assert_eq!(at(0.12, 0.05, Composition::PULLEY), Reason::InsidePulley { cable: 1, radius: 0.12 });
    assert_eq!(at(0.0, 1.0, Composition::PULLEY), Reason::OnSwivelAxis { cable: 1 });
    assert_eq!(at(1e300, 1e300, Composition::STANDARD), Reason::NotFinite { cable: 1 });
}

/// The contact point of a placed pulley is the anchor of the point model, so that the pull is the same.
#[test]
fn a_placed_pulley_touches_where_the_point_model_has_its_anchor() {
    let robot = robot_of(vec![Cable { pulley: None, ..tilted_pulley_cable() }]);
    let pose = tilted_pose();
    for axis in [Vector3::z(), -Vector3::z(), Vector3::new(0.6, 0.0, 0.8)] {
        let placed = place_pulleys(&robot, &[(0.161, axis)], &pose).unwrap();
        let (path, _) = Model::new(placed, Composition::PULLEY).unwrap().path(0, &pose).unwrap();
        let contact =
            pose.transform(&robot.cables[0].platform_anchor) + Vector3::from(path.direction) * path.free_length;
        assert!((contact - robot.cables[0].frame_anchor).norm() < 1e-14);
        let base = Model::new(robot.clone(), Composition::STANDARD).unwrap();
        let difference = base.structure_matrix(&pose).unwrap()
            - Model::new(place_pulleys(&robot, &[(0.161, axis)], &pose).unwrap(), Composition::PULLEY)
                .unwrap()
                .structure_matrix(&pose)
                .unwrap();
        assert!(difference.amax() < 1e-14);
    }
}

#[test]
fn the_gradient_by_parameters_is_the_gradient_of_the_recorded_length() {
    let robot = robot_of(vec![tilted_pulley_cable()]);
    let model = Model::new(robot.clone(), Composition::PULLEY).unwrap();
    let path = model.path(0, &tilted_pose()).unwrap().0;
    let row = path.recorded_length_row(&tilted_pose().rotation_rows(), 1.0, model.law(0).recording.length_scale);
    let kinds: Vec<_> = ParameterKind::IDENTIFIED
        .into_iter()
        .filter(|kind| !kind.needs_elasticity() && !kind.needs_motor_angles() && !kind.needs_swivels())
        .collect();
    let free = FreeParameters::of(&kinds);
    for parameter in free.parameters(&model, &FreeParameters::default()).unwrap() {
        let recorded = |value: f64| {
            let mut changed = robot.clone();
            parameter.set(&mut changed, value);
            let changed = Model::new(changed, Composition::PULLEY).unwrap();
            changed.recorded_length(0, changed.path(0, &tilted_pose()).unwrap().0.length)
        };
        let (value, h) = (parameter.value(model.robot()), 1e-6);
        let slope = (recorded(value + h) - recorded(value - h)) / (2.0 * h);
        let analytic = match parameter.kind {
            ParameterKind::FrameAnchor => row[parameter.axis],
            ParameterKind::PlatformAnchor => row[3 + parameter.axis],
            ParameterKind::LengthOffset => row[6],
            ParameterKind::LengthScale => row[7],
            ParameterKind::PulleyRadius => row[8],
            ParameterKind::SwivelAxis => {
                let pose = tilted_pose();
                let end = model.cable_end(0, pose.position.into(), &pose.rotation_rows());
                let state = model.law(0).state(end, CableInput::OutletTension(0.0)).unwrap();
                model.by_parameter(0, &state, &parameter, &pose.rotation_matrix()).1
            }
            other => unreachable!("{other} is not free here"),
        };
        assert!((slope - analytic).abs() < 1e-8, "{}: {slope} {analytic}", parameter.name(&robot));
    }
}

/// A compliance replaces a stiffness, which the file then no longer states: no key may be listed as assumed.
#[cfg(feature = "files")]
#[test]
fn a_robot_with_identified_compliances_can_be_read_again() {
    let mut robot = Robot::builtin("planar-example").unwrap();
    let key = "cable.axial_stiffness_EA_N".to_owned();
    robot.assumptions = vec![Assumption { key, reason: "a guess".to_owned() }];
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let parameters = Parameter::named("compliance", model.robot()).unwrap();
    let calibrated = model.with_parameters(&parameters[..3], &[1e-5; 3]).unwrap();
    let read = Robot::from_toml(&calibrated.robot().to_toml(), "calibrated").unwrap();
    assert_eq!(read.assumptions[0].key, "cable[4].axial_stiffness_EA_N");
}
