//! Hanging platforms against statics by another program, and against the forward problem.

use nalgebra::{UnitQuaternion, Vector3};

use super::{HangingError, hanging_poses, unbalanced_share};
use crate::equilibrium::elastostatics::{Settings, Status, solve};
use crate::geometry::Pose;
use crate::model::{Composition, Model};
use crate::robot::Robot;
use crate::statics::{Load, Stability, wrench_residual};

/// Carriage of a mural robot on two belts (its measures are of the case `mural-carriage`).
const CARRIAGE: &str = r#"
layout_version = 1
name = "carriage"
motion_pattern = "1R2T"
axes = "xz"
cable_count = 2
gravity_m_s2 = [0.0, -9.81]
[platform]
mass_kg = 0.55
center_of_mass_m = [0.0, -0.010]
[home_pose]
position_m = [0.65, -0.61]
angle_rad = 0.0
[[cable]]
name = "left"
frame_anchor_m = [0.0, 0.0]
platform_anchor_m = [-0.0380135, 0.0044866]
[[cable]]
name = "right"
frame_anchor_m = [1.3, 0.0]
platform_anchor_m = [0.0380135, 0.0044866]
"#;

fn spatial(cables: usize) -> Model {
    let mut text = format!(
        "layout_version = 1\nname = \"crane\"\nmotion_pattern = \"3R3T\"\ncable_count = {cables}\ngravity_m_s2 = [0.0, 0.0, -9.81]\n[platform]\nmass_kg = 10.0\n\
         center_of_mass_m = [0.02, -0.01, -0.1]\n[home_pose]\nposition_m = [0.0, 0.0, 1.5]\nrotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\n"
    );
    let frame = [[-2.0, -1.5, 3.0], [2.0, -1.4, 3.1], [0.1, 1.6, 2.9], [-2.1, 1.5, 3.0]];
    let platform = [[-0.3, -0.2, 0.05], [0.3, -0.2, 0.05], [0.0, 0.25, 0.06], [-0.3, 0.2, 0.04]];
    for cable in 0..cables {
        text.push_str(&format!(
            "[[cable]]\nname = \"{cable}\"\nframe_anchor_m = {:?}\nplatform_anchor_m = {:?}\n",
            frame[cable], platform[cable]
        ));
    }
    Model::new(Robot::from_toml(&text, "crane.toml").unwrap(), Composition::STANDARD).unwrap()
}

/// Angles, belts and tensions of SciPy's statics with a free angle.
#[test]
fn a_carriage_hangs_as_statics_of_another_program_says() {
    let model = Model::new(Robot::from_toml(CARRIAGE, "carriage.toml").unwrap(), Composition::STANDARD).unwrap();
    let load = Load::of(model.robot()).unwrap();
    let pattern = model.robot().motion_pattern;
    for ([x, z], angle, lengths, tensions) in [
        ([0.3, -0.5], -0.414_089, [0.549_787, 1.090_615], [4.767, 2.621]),
        ([0.26, -0.26], -0.313_969, [0.332_056, 1.037_529], [5.892, 4.136]),
        ([0.65, -0.61], 0.0, [0.860_915, 0.860_915], [3.836, 3.836]),
        ([1.0, -0.9], 0.567_044, [1.331_337, 0.916_574], [1.776, 4.367]),
    ] {
        let near = pattern.pose(model.robot().plane, &[x, z, 0.0]).unwrap();
        let found = hanging_poses(&model, &load, &near).unwrap();
        let first = &found.found[0];
        assert_eq!((first.stability, found.freedom), (Stability::Stable, 0));
        let wanted = pattern.pose(model.robot().plane, &[x, z, angle]).unwrap();
        assert!(first.pose.rotation.angle_to(&wanted.rotation) < 1e-6, "{x} {z}: {first:?}");
        let own = model.cable_lengths(&first.pose).unwrap();
        // printed to six and three decimals
        assert!(own.iter().zip(lengths).all(|(own, wanted)| (own - wanted).abs() < 6e-7), "{own:?}");
        assert!(first.tensions.iter().zip(tensions).all(|(own, wanted)| (own - wanted).abs() < 6e-4));
        // the other poses, turned over on crossed belts, are no rest
        assert!(found.found.len() > 1 && found.found[1..].iter().all(|other| other.stability == Stability::Unstable));
    }
    assert!(
        unbalanced_share(&model, &load, &pattern.pose(model.robot().plane, &[0.3, -0.5, 0.0]).unwrap())
            .unwrap()
            .unwrap()
            > 0.01
    );
}

/// Lengths of a stable pose lead the forward problem back to it, and all poses are in balance.
#[test]
fn lengths_of_hanging_poses_lead_back_to_them() {
    for cables in [3, 4] {
        let model = spatial(cables);
        let load = Load::of(model.robot()).unwrap();
        for position in [Vector3::new(0.0, 0.0, 1.5), Vector3::new(0.4, -0.3, 1.2), Vector3::new(-0.5, 0.2, 1.7)] {
            let near = Pose { position, rotation: UnitQuaternion::identity() };
            let all = hanging_poses(&model, &load, &near).unwrap();
            assert_eq!(all.freedom, cables - 3);
            let first = &all.found[0];
            assert_eq!(first.stability, Stability::Stable, "{cables} {position}");
            for own in &all.found {
                let left = wrench_residual(&model, &own.pose, &own.tensions, &load).unwrap().norm();
                assert!(
                    left < 1e-6
                        && (own.pose.position - position).norm() < 1e-12
                        && own.tensions.iter().all(|f| *f > -1e-6),
                    "{own:?}"
                );
                assert_eq!(unbalanced_share(&model, &load, &own.pose).unwrap(), None);
            }
            let lengths = model.cable_lengths(&first.pose).unwrap();
            let back = solve(
                &model,
                &lengths,
                &load,
                &first.pose.displaced(&crate::geometry::Twist::new(0.01, 0.0, 0.02, 0.03, -0.02, 0.01)),
                &Settings::default(),
            )
            .unwrap();
            assert_eq!(back.status, Status::Converged);
            assert!(
                (back.pose.position - position).norm() < 1e-6
                    && back.pose.rotation.angle_to(&first.pose.rotation) < 1e-6
            );
        }
    }
}

/// Of a family whose cables all pull the pose nearest to an orientation is taken: turned along the family, no other is nearer.
#[test]
fn the_nearest_pose_of_a_family_is_taken() {
    let model = spatial(4);
    let load = Load::of(model.robot()).unwrap();
    let near =
        Pose { position: Vector3::new(0.0, 0.0, 1.5), rotation: UnitQuaternion::from_euler_angles(0.0, 0.0, -0.01) };
    let first = hanging_poses(&model, &load, &near).unwrap().found[0].pose.rotation;
    let distance = |rotation: &UnitQuaternion<f64>| rotation.angle_to(&near.rotation);
    for yaw in [-0.02, 0.02] {
        let other = Pose { rotation: UnitQuaternion::from_euler_angles(0.0, 0.0, yaw) * first, ..near };
        let of_other = hanging_poses(&model, &load, &other).unwrap().found[0].pose.rotation;
        assert!(distance(&of_other) > distance(&first) - 1e-7, "{} {}", distance(&of_other), distance(&first));
    }
}

#[test]
fn platforms_that_do_not_hang_are_refused() {
    let fixed = Model::new(Robot::builtin("cogiro").unwrap(), Composition::STANDARD).unwrap();
    let load = Load::of(spatial(3).robot()).unwrap();
    let pose = fixed.robot().home_or_middle();
    assert!(matches!(hanging_poses(&fixed, &load, &pose), Err(HangingError::Fixed { cables: 8, dof: 6 })));
    assert_eq!(unbalanced_share(&fixed, &load, &pose).unwrap(), None);
    let two = spatial(2);
    let home = two.robot().home_or_middle();
    assert!(matches!(hanging_poses(&two, &load, &home), Err(HangingError::TooFew { cables: 2, coordinates: 3 })));
    let nothing = Load::constant(crate::geometry::Wrench::zeros());
    assert!(matches!(hanging_poses(&spatial(3), &nothing, &home), Err(HangingError::NoForce)));
}

/// Equilibria in which a belt would have to push hold no load: above the pins there are no others.
#[test]
fn poses_that_only_pushing_belts_balance_are_none() {
    let model = Model::new(Robot::from_toml(CARRIAGE, "carriage.toml").unwrap(), Composition::STANDARD).unwrap();
    let load = Load::of(model.robot()).unwrap();
    let near = model.robot().motion_pattern.pose(model.robot().plane, &[0.5, 1.0, 0.0]).unwrap();
    let all = hanging_poses(&model, &load, &near).unwrap();
    assert!(all.found.is_empty() && all.pushing > 0, "{all:?}");
    let search = super::Search::of(&model, &load).unwrap();
    let (pose, tensions) = search.starts(&near).iter().find_map(|start| search.run(start, &near)).unwrap();
    let pushed = model.structure_matrix(&pose).unwrap() * nalgebra::DVector::from_vec(tensions.clone());
    let left = (pushed + load.in_pattern(&model, &pose)).norm();
    assert!(left < 1e-6 && tensions.iter().any(|tension| *tension < -0.1), "{tensions:?}");
    assert!(unbalanced_share(&model, &load, &pose).unwrap().unwrap() > 0.1);
}
