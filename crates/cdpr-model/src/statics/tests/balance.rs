//! Load, split, groups, and invalid input.

use nalgebra::{DVector, Vector3};

use super::*;
use crate::geometry::{Plane, Wrench};
use crate::robot::{Cable, CableStiffness, ExternalWrench};

#[test]
fn a_wrench_that_includes_gravity_is_the_whole_load() {
    let mut robot = elastic_robot();
    let wrench = Wrench::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0);
    robot.external_wrench = Some(ExternalWrench { wrench, includes_gravity: true, note: None });
    assert_eq!(Load::of(&robot), Ok(Load::constant(wrench)));
    robot.external_wrench = Some(ExternalWrench { wrench, includes_gravity: false, note: None });
    let load = Load::of(&robot).unwrap();
    let pose = turned(&robot);
    let without = Load::of(&Robot { external_wrench: None, ..robot.clone() }).unwrap();
    assert_eq!(load.wrench(&pose) - without.wrench(&pose), wrench);
    // neither mass nor gravity is needed if the wrench includes gravity
    robot.external_wrench = Some(ExternalWrench { wrench, includes_gravity: true, note: None });
    (robot.platform.mass, robot.gravity) = (None, None);
    assert_eq!(Load::of(&robot), Ok(Load::constant(wrench)));
}

/// In the xz plane, where positive rotations are about −y, a weight right of the origin turns the platform to the
/// right.
#[test]
fn a_planar_load_has_its_moment_about_the_normal() {
    let mut robot = Robot::builtin("kntu-planar").unwrap();
    robot.plane = Plane::from_axes("xz").unwrap();
    robot.gravity = Some(Vector3::new(0.0, 0.0, -10.0));
    (robot.platform.mass, robot.platform.center_of_mass) = (Some(5.0), Some(Vector3::new(0.2, 0.0, 0.0)));
    let load = Load::of(&robot).unwrap();
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    assert_eq!(load.in_pattern(&model, &Pose::identity()), DVector::from_vec(vec![0.0, -50.0, -10.0]));
}

/// The parts add up, one has no wrench and the other is a combination of the rows of Aᵀ, so they are perpendicular.
#[test]
fn tensions_split_into_an_internal_and_an_external_part() {
    let (planar, planar_pose) = planar_robot();
    let (spatial, spatial_pose, ..) = of(Composition::PULLEY_ELASTIC);
    for (model, pose) in [(planar, planar_pose), (spatial, spatial_pose)] {
        let f = tensions(&model);
        let parts = split(&model, &pose, &f).unwrap();
        assert_eq!(parts.rank, model.dof());
        let matrix = model.structure_matrix(&pose).unwrap();
        let (internal, external) = (DVector::from_vec(parts.internal), DVector::from_vec(parts.external));
        assert!((&internal + &external - DVector::from_column_slice(&f)).amax() < 1e-10);
        assert!((&matrix * &internal).amax() < 1e-9);
        // eq. 2.38 and 2.39 literally: −A⁺ᵀ w of the load that f balances
        let inverse = (&matrix * matrix.transpose()).try_inverse().unwrap();
        let expected = matrix.transpose() * inverse * &matrix * DVector::from_column_slice(&f);
        assert!((external - expected).amax() < 1e-9);
    }
}

/// All cables in one plane: Aᵀ of the spatial robot has rank 3, AᵀA has no inverse, and the projector still exists.
#[test]
fn a_structure_matrix_of_less_rank_still_splits() {
    let mut robot = elastic_robot();
    for cable in &mut robot.cables {
        (cable.frame_anchor.z, cable.platform_anchor.z) = (1.0, 0.0);
    }
    let pose = Pose { position: Vector3::new(0.1, 0.2, 1.0), ..Pose::identity() };
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let f = tensions(&model);
    let parts = split(&model, &pose, &f).unwrap();
    assert_eq!(parts.rank, 3);
    let matrix = model.structure_matrix(&pose).unwrap();
    assert!((matrix * DVector::from_vec(parts.internal)).amax() < 1e-9);
}

#[test]
fn the_estimated_load_leaves_no_residual_and_groups_add_up_to_it() {
    let (planar, planar_pose) = planar_robot();
    let (spatial, spatial_pose, ..) = of(Composition::PULLEY_ELASTIC);
    for (model, pose) in [(planar, planar_pose), (spatial, spatial_pose)] {
        let f = tensions(&model);
        let w = balanced_wrench(&model, &pose, &f).unwrap();
        assert!(wrench_residual(&model, &pose, &f, &Load::constant(w)).unwrap().amax() < 1e-10);
        let odd: Vec<usize> = (0..model.cable_count()).step_by(2).collect();
        let even: Vec<usize> = (1..model.cable_count()).step_by(2).collect();
        let sum = section_wrench(&model, &pose, &f, &odd).unwrap() + section_wrench(&model, &pose, &f, &even).unwrap();
        assert!((sum + w).amax() < 1e-10);
    }
    // a planar robot has no force out of its plane and no moment in it
    let (model, pose) = planar_robot();
    let w = balanced_wrench(&model, &pose, &tensions(&model)).unwrap();
    assert_eq!([w[2], w[3], w[4]], [0.0; 3]);
    assert!(w[5] != 0.0);
}

#[test]
fn what_no_cable_can_do_is_refused_by_its_number() {
    let (model, pose, f, load) = of(Composition::ELASTIC);
    let with = |cable: usize, value: f64| {
        let mut changed = f.clone();
        changed[cable] = value;
        changed
    };
    assert_eq!(balanced_wrench(&model, &pose, &f[1..]), Err(StaticsError::TensionCount { expected: 8, found: 7 }));
    assert_eq!(split(&model, &pose, &with(2, -1.0)), Err(StaticsError::Negative { cable: 3, value: -1.0 }));
    assert!(matches!(
        Stiffness::at(&model, &pose, &with(4, f64::NAN), &load),
        Err(StaticsError::NotFinite { cable: 5, .. })
    ));
    assert!(matches!(
        controlled_lengths(&model, &pose, &with(0, 1e6)),
        Err(StaticsError::Overstretched { cable: 1, .. })
    ));
    assert_eq!(section_wrench(&model, &pose, &f, &[8]), Err(StaticsError::UnknownCable { cable: 9, count: 8 }));
    assert_eq!(section_wrench(&model, &pose, &f, &[1, 1]), Err(StaticsError::RepeatedCable { cable: 2 }));
    let nowhere = Pose { position: Vector3::repeat(f64::NAN), ..Pose::identity() };
    assert!(matches!(balanced_wrench(&model, &nowhere, &f), Err(StaticsError::CablePath(_))));
}

#[test]
fn a_rigid_cable_has_no_stiffness_but_a_controlled_length() {
    let (elastic, pose, f, load) = of(Composition::ELASTIC);
    let rigid = Model::new(elastic.robot().clone(), Composition::PULLEY).unwrap();
    assert_eq!(controlled_lengths(&rigid, &pose, &f), Ok(rigid.cable_lengths(&pose).unwrap()));
    let refused = Stiffness::at(&rigid, &pose, &f, &load).unwrap_err().to_string();
    assert!(refused.contains("the model `pulley+elastic`"), "{refused}");
    let mut robot = elastic.robot().clone();
    robot.cables[1] = Cable { stiffness: Some(CableStiffness::Compliance(0.0)), ..Cable::default() };
    robot.cables[1].name = "stiff one".to_owned();
    let refused = Stiffness::at(&Model::new(robot, Composition::ELASTIC).unwrap(), &pose, &f, &load).unwrap_err();
    assert!(refused.to_string().contains("\"stiff one\""), "{refused}");
}
