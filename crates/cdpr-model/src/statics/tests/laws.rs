//! Laws that every stiffness obeys, and cases calculated by hand.

use nalgebra::{Matrix3, Vector3};

use super::*;
use crate::geometry::{MotionPattern, Plane, Wrench};
use crate::model::FreeParameters;
use crate::robot::{Cable, CableStiffness, Parameter};

/// At an equilibrium of springs and weight the potential energy has a Hessian, which is symmetric.
#[test]
fn conservative_stiffness_is_symmetric_at_equilibrium_only() {
    for composition in [Composition::ELASTIC, Composition::PULLEY_ELASTIC] {
        let mut robot = elastic_robot();
        robot.cables.iter_mut().for_each(|cable| cable.platform_anchor.x *= 1.2);
        let pose = robot.home.unwrap().displaced(&Twist::new(0.1, 0.2, 0.3, 0.05, 0.02, -0.04));
        let load = Load::of(&robot).unwrap();
        let model = Model::new(robot, composition).unwrap();
        let suspended = balanced(&model, &pose, &load);
        assert!(suspended.iter().all(|&f| f > 0.0), "the test wants taut cables: {suspended:?}");
        let skew = |tensions: &[f64], load: &Load| {
            let k = Stiffness::at(&model, &pose, tensions, load).unwrap().system;
            (&k - k.transpose()).amax()
        };
        assert!(wrench_residual(&model, &pose, &suspended, &load).unwrap().amax() < 1e-9);
        assert!(skew(&suspended, &load) < 1e-8, "rounding of entries of 1e5: {}", skew(&suspended, &load));
        // an unbalanced moment, and a moment of constant direction, are not conservative
        assert!(skew(&tensions(&model), &load) > 1.0);
        let mut moment = load.wrench(&pose);
        moment.fixed_rows_mut::<3>(3).add_scalar_mut(50.0);
        let constant = Load::constant(moment);
        assert!(skew(&balanced(&model, &pose, &constant), &constant) > 1.0);
    }
}

#[test]
fn cable_stiffness_is_positive_semidefinite_and_has_the_structure_matrix_rank() {
    let (model, pose, tensions, load) = of(Composition::PULLEY_ELASTIC);
    let all = Stiffness::at(&model, &pose, &tensions, &load).unwrap().cable;
    assert!(all.symmetric_eigenvalues().min() > 0.0);
    // five taut cables leave one direction without stiffness
    let mut slack = tensions;
    slack[5..].fill(0.0);
    let five = Stiffness::at(&model, &pose, &slack, &load).unwrap();
    let values = five.cable.symmetric_eigenvalues();
    assert!(values.min().abs() < 1e-12 * values.max(), "{values}");
    assert_eq!(five.cable_stiffness[5..], [0.0; 3]);
}

/// ∂t/∂p_B of one pull t = f u at fixed q_θ: −K u uᵀ + f ∂u/∂p_B, the Hessian of a spring's energy.
#[test]
fn the_tangent_of_a_pull_is_symmetric() {
    let (model, pose, tensions, _) = of(Composition::PULLEY_ELASTIC);
    let controlled = controlled_lengths(&model, &pose, &tensions).unwrap();
    for cable in 0..8 {
        let (path, moment_arm) = model.path(cable, &pose).unwrap();
        let pull = |step: Vector3<f64>| {
            let twist = Twist::new(step.x, step.y, step.z, 0.0, 0.0, 0.0);
            let (path, _) = model.path(cable, &pose.displaced(&twist)).unwrap();
            let tension = model.elasticity(cable).tension(path.length, controlled[cable]).value;
            Vector3::from(path.direction) * tension
        };
        let h = 1e-5; // truncation ~ h² · 1e4 N/m³, rounding ~ 1e3 N · ε/h
        let columns = [0, 1, 2].map(|k| (pull(Vector3::ith(k, h)) - pull(Vector3::ith(k, -h))) / (2.0 * h));
        let tangent = Matrix3::from_columns(&columns);
        assert!((tangent - tangent.transpose()).amax() < 1e-4, "cable {}: {tangent}", cable + 1);
        let u = Vector3::from(path.direction);
        let law = model.elasticity(cable).tension(path.length, controlled[cable]);
        let gradient = Matrix3::from_fn(|i, j| path.direction_gradient[i][j]);
        assert!((tangent - (gradient * law.value - u * u.transpose() * law.by_length)).amax() < 1e-4);
        // and it is the stiffness for translations of a one-cable robot
        assert!(moment_arm.norm() > 0.0);
    }
}

#[test]
fn pulleys_of_radius_zero_have_the_stiffness_of_point_outlets() {
    let mut robot = elastic_robot();
    robot.cables.iter_mut().for_each(|cable| cable.set_pulley_radius(0.0));
    let (pose, load) = (turned(&robot), Load::of(&robot).unwrap());
    let at = |composition| {
        let model = Model::new(robot.clone(), composition).unwrap();
        Stiffness::at(&model, &pose, &tensions(&model), &load).unwrap()
    };
    let (base, pulley) = (at(Composition::ELASTIC), at(Composition::PULLEY_ELASTIC));
    assert!((&base.system - &pulley.system).amax() < 1e-9 * base.system.amax());
    assert!((&base.by_controlled_length - &pulley.by_controlled_length).amax() < 1e-9 * base.system.amax());
}

/// K/K_θ = q_θ/q by actual length, also by unstrained length, and 1 for a constant spring: confusing them gives errors
/// of percents.
#[test]
fn stiffness_by_length_and_by_controlled_length_differ_by_the_strain() {
    let mut robot = elastic_robot();
    for cable in &mut robot.cables {
        (cable.hidden_length, cable.series_compliance) = (None, None);
    }
    let (pose, load) = (turned(&robot), Load::of(&robot).unwrap());
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let k = Stiffness::at(&model, &pose, &tensions(&model), &load).unwrap();
    let lengths = model.cable_lengths(&pose).unwrap();
    for cable in 0..8 {
        let ratio = k.controlled_length_stiffness[cable] / k.cable_stiffness[cable];
        let strain = lengths[cable] / k.controlled_lengths[cable] - 1.0;
        let expected = if cable % 3 == 2 { 1.0 } else { 1.0 + strain };
        assert!(strain > 0.005 && (ratio - expected).abs() < 1e-12, "cable {}: {ratio} {strain}", cable + 1);
    }
}

/// With f = 0 and equal springs the length Jacobian is that of forward kinematics, −(AᵀA)⁻¹ Aᵀ (eq. 2.59, 2.81).
#[test]
fn at_vanishing_tension_equal_springs_are_forward_kinematics() {
    let mut robot = elastic_robot();
    for cable in &mut robot.cables {
        (cable.stiffness, cable.stiffness_by) = (Some(CableStiffness::Spring(1.0)), None);
        (cable.hidden_length, cable.series_compliance) = (None, None);
    }
    let pose = turned(&robot);
    let model = Model::new(robot, Composition::PULLEY_ELASTIC).unwrap();
    let k = Stiffness::at(&model, &pose, &[1e-9; 8], &Load::constant(Wrench::zeros())).unwrap();
    let matrix = model.structure_matrix(&pose).unwrap();
    let expected = -(&matrix * matrix.transpose()).try_inverse().unwrap() * &matrix;
    // 1e-9 N of tension against springs of 1 N/m
    assert!((k.pose_by_controlled_lengths().unwrap() - expected).amax() < 1e-7);
}

/// A pendulum on one cable: the horizontal stiffness is f/q, the vertical one the cable's.
#[test]
fn a_hanging_point_has_the_stiffness_of_a_pendulum() {
    let mut robot = elastic_robot();
    robot.motion_pattern = MotionPattern::SpatialPoint;
    robot.cables = vec![Cable {
        name: "1".to_owned(),
        frame_anchor: Vector3::new(0.0, 0.0, 5.0),
        stiffness: Some(CableStiffness::Axial(1e5)),
        ..Cable::default()
    }];
    robot.external_wrench = None;
    (robot.platform.mass, robot.gravity) = (Some(100.0), Some(Vector3::new(0.0, 0.0, -9.81)));
    let load = Load::of(&robot).unwrap();
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let k = Stiffness::at(&model, &Pose::identity(), &[981.0], &load).unwrap();
    assert!((k.system[(0, 0)] - 981.0 / 5.0).abs() < 1e-10 && (k.system[(1, 1)] - 981.0 / 5.0).abs() < 1e-10);
    // k_F q_θ/q²
    assert!((k.system[(2, 2)] - 1e5 * (1.0 - 0.00981) / 5.0).abs() < 1e-8);
    assert_eq!(k.stability(), Stability::Stable);
    assert!((k.compliance().unwrap()[(0, 0)] - 5.0 / 981.0).abs() < 1e-12);
    // without tension the stiffness is zero
    let slack = Stiffness::at(&model, &Pose::identity(), &[0.0], &load).unwrap();
    assert_eq!((slack.stability(), slack.compliance()), (Stability::Indifferent, None));
}

/// A weight above the plane of the cables' anchors on the platform tips over; below it hangs.
#[test]
fn the_gravity_term_decides_whether_a_weight_tips() {
    let cable = |x: f64| Cable {
        name: format!("{x}"),
        frame_anchor: Vector3::new(x, 0.0, 5.0),
        platform_anchor: Vector3::new(x, 0.0, 0.0),
        stiffness: Some(CableStiffness::Axial(1e6)),
        ..Cable::default()
    };
    let judged = |height: f64| {
        let mut robot = elastic_robot();
        robot.plane = Plane::from_axes("xz").unwrap();
        robot.motion_pattern = MotionPattern::Planar;
        robot.external_wrench = None;
        robot.gravity = Some(Vector3::new(0.0, 0.0, -9.81));
        robot.platform.mass = Some(100.0);
        robot.platform.center_of_mass = Some(Vector3::new(0.0, 0.0, height));
        robot.cables = vec![cable(0.0)];
        let load = Load::of(&robot).unwrap();
        let model = Model::new(robot, Composition::ELASTIC).unwrap();
        let k = Stiffness::at(&model, &Pose::identity(), &[981.0], &load).unwrap();
        // the rotation about the platform origin, against which m g h acts
        assert!((k.system[(2, 2)] + 981.0 * height).abs() < 1e-9, "{}", k.system);
        k.stability()
    };
    assert_eq!([judged(-0.5), judged(0.5)], [Stability::Stable, Stability::Unstable]);
}

/// The planar example on cables of two pieces, whose knee lies at 200 N.
fn two_piece() -> Robot {
    let mut robot = Robot::builtin("planar-example").unwrap();
    for cable in &mut robot.cables {
        let keys = ["stiffness_below_knee_EA_N", "stiffness_above_knee_EA_N", "knee_strain"];
        cable.law_numbers.extend(keys.into_iter().zip([1e5, 8e5, 0.002]));
    }
    robot
}

/// The law's numbers are parameters of models that have it; their derivatives are those of lengths at given tensions.
#[test]
fn its_numbers_are_free_where_the_model_has_it() {
    let free: FreeParameters = "stiffness-below-knee,stiffness-above-knee[2],knee-strain".parse().unwrap();
    let model = Model::new(two_piece(), "two-piece".parse().unwrap()).unwrap();
    let parameters = free.parameters(&model, &FreeParameters::default()).unwrap();
    assert_eq!(parameters.len(), 4 + 1 + 4);
    let elastic = Model::new(two_piece(), Composition::ELASTIC).unwrap();
    let refused = free.parameters(&elastic, &FreeParameters::default()).unwrap_err().to_string();
    assert!(refused.contains("`two-piece`"), "{refused}");
    let key = Parameter::named("cable[2].knee_strain", model.robot()).unwrap();
    assert_eq!(key[0].name(model.robot()), "knee-strain[2]");

    let pose = model.robot().home_or_middle();
    let lengths = |model: &Model| controlled_lengths(model, &pose, &[3000.0; 4]).unwrap();
    for parameter in &parameters {
        let (value, cable) = (parameter.value(model.robot()), parameter.cable);
        let with = |value: f64| lengths(&model.with_parameters(&[*parameter], &[value]).unwrap())[cable];
        let h = 1e-5 * value;
        let slope = (with(value + h) - with(value - h)) / (2.0 * h);
        let state = cable_state(&model, &pose, cable, 3000.0).unwrap();
        let (_, found) = model.by_parameter(cable, &state, parameter, &pose.rotation_matrix());
        // lengths of 10 m have a rounding of 1e-15 of them, over 2e-5 of the number
        assert!((found - slope).abs() * value < 1e-9, "{}: {found} {slope}", parameter.name(model.robot()));
    }
}

/// A file that states no such law does not support it, and the error names the first key; the law is richer than
/// `elastic` and poorer than a polynomial.
#[test]
fn a_robot_without_its_keys_lacks_them_by_name() {
    let plain = Robot::builtin("planar-example").unwrap();
    let missing = Composition::supported(&plain).unwrap().missing;
    let (_, reason) = missing.iter().find(|(word, _)| *word == "two-piece").unwrap();
    assert!(reason.to_string().contains("stiffness_below_knee_EA_N"), "{reason}");
    assert_eq!(Composition::supported(&two_piece()).unwrap().richest.to_string(), "two-piece");
}
