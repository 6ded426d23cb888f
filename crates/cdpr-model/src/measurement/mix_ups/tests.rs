//! Every mix-up on robots without symmetry is found, and none in clean data.

use std::f64::consts::PI;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};

use super::*;
use crate::geometry::{Pose, inverse, product};

/// The mix-up in words.
fn found_words(robot: &Robot, samples: &Samples, angles: &[[f64; 3]]) -> Option<String> {
    super::found(robot, &with_angles(samples, angles)).map(|finding| finding.text)
}

/// Samples with the angles of a file, or with quaternions.
fn with_angles(samples: &Samples, angles: &[[f64; 3]]) -> Samples {
    Samples { angles: (!angles.is_empty()).then(|| angles.to_vec()), ..samples.clone() }
}

/// Samples with rotations of the platform of up to 30° about each axis, with lengths of points, offsets and noise of
/// 0.3 mm; angles as in a file.
fn recorded(robot: &Robot) -> (Samples, Vec<[f64; 3]>) {
    let mut chance = rand_chacha::ChaCha8Rng::seed_from_u64(11);
    let (home, reach) = (robot.home_or_middle(), 0.12 * robot.anchor_diagonal());
    let (mut samples, mut all) = (Samples { cable_count: robot.cable_count(), ..Samples::default() }, Vec::new());
    for _ in 0..60 {
        let mut uniform = |size: f64| size * (2.0 * chance.random::<f64>() - 1.0);
        let angles = [uniform(0.5), uniform(0.5), uniform(0.5)];
        // the middle of the workspace is far from the origin, as with a tracker's coordinates
        let shift = Vector3::new(uniform(reach), uniform(reach), uniform(reach));
        let pose = Pose::from_xyz_angles(home.position + shift, angles);
        let lengths = lengths(robot, &pose);
        samples.lengths.extend(lengths.iter().enumerate().map(|(k, l)| l + 0.05 * k as f64 + uniform(3e-4)));
        samples.poses.push(pose);
        all.push(angles);
    }
    (samples, all)
}

fn lengths(robot: &Robot, pose: &Pose) -> Vec<f64> {
    robot.cables.iter().map(|cable| (cable.frame_anchor - pose.transform(&cable.platform_anchor)).norm()).collect()
}

/// A robot with anchors without symmetry: those of a built-in one, each moved by up to a tenth of the size.
fn unsymmetrical(name: &str, seed: u64) -> Robot {
    let mut robot = Robot::builtin(name).unwrap();
    let mut chance = rand_chacha::ChaCha8Rng::seed_from_u64(seed);
    let size = robot.anchor_diagonal();
    for cable in &mut robot.cables {
        let mut moved = |size: f64| Vector3::from_fn(|_, _| size * (2.0 * chance.random::<f64>() - 1.0));
        cable.frame_anchor += moved(0.1 * size) + Vector3::new(0.2, 0.3, 0.1) * size;
        cable.platform_anchor += moved(0.03 * size);
    }
    let home = robot.home_or_middle();
    robot.home = Some(Pose { position: home.position + Vector3::new(0.2, 0.3, 0.1) * size, ..home });
    robot
}

fn robots() -> [Robot; 2] {
    [unsymmetrical("ipanema-1", 1), unsymmetrical("cogiro", 2)]
}

/// Samples with poses written in another way.
fn with_poses(samples: &Samples, written: impl Fn(&Pose) -> Pose) -> Samples {
    Samples { poses: samples.poses.iter().map(written).collect(), ..samples.clone() }
}

fn with_rotations(samples: &Samples, written: impl Fn(UnitQuaternion<f64>) -> UnitQuaternion<f64>) -> Samples {
    with_poses(samples, |pose| Pose { rotation: written(pose.rotation), ..*pose })
}

#[test]
fn clean_data_name_no_mix_up() {
    for robot in robots() {
        let (samples, angles) = recorded(&robot);
        for angles in [&angles[..], &[]] {
            assert_eq!(found_words(&robot, &samples, angles), None, "{}", robot.name);
        }
        // anchors that are wrong by centimetres are no mix-up
        let mut wrong = robot.clone();
        wrong.cables.iter_mut().enumerate().for_each(|(k, cable)| cable.frame_anchor.x += 0.03 * (k as f64).sin());
        assert_eq!(found_words(&wrong, &samples, &angles), None, "{}", robot.name);
    }
}

#[test]
fn permuted_cables_are_named_with_their_order() {
    for robot in robots() {
        let (mut samples, angles) = recorded(&robot);
        let m = samples.cable_count;
        samples.lengths.chunks_mut(m).for_each(|row| {
            row.swap(1, 4);
            row.swap(0, 2);
        });
        let words = found_words(&robot, &samples, &angles).unwrap();
        let rest: String = (6..=m).map(|cable| format!(", {cable}")).collect();
        assert!(words.contains(&format!("recorded lengths 3, 5, 1, 4, 2{rest}")), "{words}");
    }
}

#[test]
fn orientations_written_otherwise_are_named() {
    for robot in robots() {
        let (samples, angles) = recorded(&robot);
        let named = |samples: &Samples, angles: &[[f64; 3]], what: &str| {
            let words = found_words(&robot, samples, angles).unwrap_or_default();
            assert!(words.contains(what), "{}: {what}: {words}", robot.name);
        };
        let scalar_first = with_rotations(&samples, |rotation| {
            let q = rotation.coords;
            // columns qx, qy, qz, qw hold w, x, y, z
            UnitQuaternion::new_unchecked(Quaternion::new(q[2], q[3], q[0], q[1]))
        });
        named(&scalar_first, &[], "as if the scalar came first:");
        named(&with_rotations(&samples, |rotation| rotation.inverse()), &[], "turned the world into the platform");
        let about = |axis: usize, angle: f64| UnitQuaternion::from_axis_angle(&Vector3::ith_axis(axis), angle);
        for (order, name) in [
            ([0, 2, 1], "R = Rx Rz Ry"),
            ([1, 0, 2], "R = Ry Rx Rz"),
            ([1, 2, 0], "R = Ry Rz Rx"),
            ([2, 0, 1], "R = Rz Rx Ry"),
            ([2, 1, 0], "R = Rz Ry Rx"),
        ] {
            // the angles of that order, read as those of Rx Ry Rz
            let written: Vec<[f64; 3]> = samples.poses.iter().map(|pose| angles_in(order, pose.rotation)).collect();
            let mut read = samples.clone();
            read.poses
                .iter_mut()
                .zip(&written)
                .for_each(|(pose, angles)| *pose = Pose::from_xyz_angles(pose.position, *angles));
            let check = about(order[0], written[0][order[0]])
                * about(order[1], written[0][order[1]])
                * about(order[2], written[0][order[2]]);
            assert!(check.angle_to(&samples.poses[0].rotation) < 1e-9);
            named(&read, &written, name);
        }
        let degrees: Vec<[f64; 3]> = angles.iter().map(|angles| angles.map(|angle| angle * 180.0 / PI)).collect();
        let mut read = samples.clone();
        read.poses
            .iter_mut()
            .zip(&degrees)
            .for_each(|(pose, angles)| *pose = Pose::from_xyz_angles(pose.position, *angles));
        named(&read, &degrees, "the angles look like degrees");
    }
}

/// Angles about x, y, z whose rotations in an order make a rotation, by Newton steps from its own.
fn angles_in(order: [usize; 3], rotation: UnitQuaternion<f64>) -> [f64; 3] {
    let product = |angles: &[f64; 3]| {
        let about = |axis: usize| UnitQuaternion::from_axis_angle(&Vector3::ith_axis(axis), angles[axis]);
        about(order[0]) * about(order[1]) * about(order[2])
    };
    let mut angles = [0.0; 3];
    for _ in 0..50 {
        let error = (rotation * product(&angles).inverse()).scaled_axis();
        let column = |k: usize| {
            let mut moved = angles;
            moved[k] += 1e-7;
            (product(&moved) * product(&angles).inverse()).scaled_axis() / 1e-7
        };
        let jacobian = nalgebra::Matrix3::from_columns(&[column(0), column(1), column(2)]);
        let step = jacobian.lu().solve(&error).unwrap();
        (0..3).for_each(|k| angles[k] += step[k]);
    }
    angles
}

#[test]
fn swapped_and_mirrored_axes_are_named() {
    for robot in robots() {
        let (samples, _) = recorded(&robot);
        for (written, axes) in
            [(Vector3::new(1, 0, 2), "y, x, z"), (Vector3::new(0, 2, 1), "x, z, y"), (Vector3::new(2, 0, 1), "y, z, x")]
        {
            let order = written.map(|axis: i32| axis as usize);
            let swapped = with_poses(&samples, |pose| {
                let p = pose.position;
                Pose { position: Vector3::new(p[order.x], p[order.y], p[order.z]), ..*pose }
            });
            let words = found_words(&robot, &swapped, &[]).unwrap_or_default();
            assert!(words.contains(&format!("x, y, z of the robot fit {axes} of the data")), "{axes}: {words}");
        }
        let mirrored = with_poses(&samples, |pose| {
            let p = pose.position;
            Pose { position: Vector3::new(p.x, -p.y, p.z), ..*pose }
        });
        let words = found_words(&robot, &mirrored, &[]).unwrap_or_default();
        assert!(words.contains("x, y, z of the robot fit x, −y, z of the data (misfit"), "{words}");
        // counted from the other wall
        let [low, high] = robot.anchor_box();
        let walls = low.y + high.y;
        let other_wall = with_poses(&samples, |pose| {
            let p = pose.position;
            Pose { position: Vector3::new(p.x, walls - p.y, p.z), ..*pose }
        });
        let words = found_words(&robot, &other_wall, &[]).unwrap_or_default();
        assert!(
            words.contains(&format!("x, y, z of the robot fit x, {walls:.3} m − y, z of the data (misfit")),
            "{words}"
        );
        // a left-handed world with orientations of its own
        let left_handed = with_poses(&samples, |pose| {
            let q = pose.rotation.coords;
            let rotation = UnitQuaternion::new_unchecked(Quaternion::new(q[3], -q[0], q[1], -q[2]));
            let p = pose.position;
            Pose { position: Vector3::new(p.x, -p.y, p.z), rotation }
        });
        let words = found_words(&robot, &left_handed, &[]).unwrap_or_default();
        assert!(words.contains("x, −y, z of the data, in the orientations too"), "{words}");
        // a world with y up
        let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -PI / 2.0);
        let y_up = with_poses(&samples, |pose| Pose { position: turn * pose.position, rotation: turn * pose.rotation });
        let words = found_words(&robot, &y_up, &[]).unwrap_or_default();
        assert!(words.contains("x, −z, y of the data: the world's axes, also under the orientations"), "{words}");
    }
}

#[test]
fn poses_of_a_marker_are_named_with_its_place() {
    for robot in robots() {
        let (samples, _) = recorded(&robot);
        let plate = Pose::from_xyz_angles(Vector3::new(0.05, -0.2, 0.15), [0.1, 0.05, -0.2]);
        let marker = with_poses(&samples, |pose| Pose {
            position: pose.transform(&plate.position),
            rotation: pose.rotation * plate.rotation,
        });
        let words = found_words(&robot, &marker, &[]).unwrap_or_default();
        assert!(words.contains("those of a marker") && words.contains("turned by 13."), "{words}");
        let origin = -(plate.rotation.inverse() * plate.position);
        let place = words.split(['(', ')']).nth(1).unwrap();
        let place: Vec<f64> = place.split(", ").map(|number| number.parse().unwrap()).collect();
        // 480 lengths with 0.17 mm of noise, whose offsets are free
        assert!((Vector3::from_column_slice(&place) - origin).norm() < 3e-3, "{origin}: {words}");
    }
}

/// The planar robot of the examples cannot turn; one that can, with the angle in degrees or with the opposite sign.
#[test]
fn an_angle_in_the_plane_is_tried_in_degrees_and_the_other_way_round() {
    let mut robot = Robot::builtin("cucablerobot-planar").unwrap();
    robot.cables.iter_mut().enumerate().for_each(|(k, cable)| {
        cable.frame_anchor += robot.plane.first_axis() * 0.2 * (k as f64).sin();
        cable.platform_anchor += robot.plane.second_axis() * 0.1 * (2.0 * k as f64).cos();
    });
    let middle = robot.motion_pattern.pose_to_components(robot.plane, &robot.home_or_middle());
    let written = |factor: f64| {
        let (mut samples, mut angles) =
            (Samples { cable_count: robot.cable_count(), ..Samples::default() }, Vec::new());
        for k in 0..50 {
            let (t, angle) = (0.3 * f64::from(k), 0.4 * (0.7 * f64::from(k)).sin());
            let at = [middle[0] + 0.2 * t.sin(), middle[1] + 0.15 * (1.3 * t).cos()];
            let pose = |angle: f64| robot.motion_pattern.pose(robot.plane, &[at[0], at[1], angle]).unwrap();
            samples.lengths.extend(lengths(&robot, &pose(angle)));
            samples.poses.push(pose(factor * angle));
            angles.push([factor * angle, 0.0, 0.0]);
        }
        found_words(&robot, &samples, &angles)
    };
    assert_eq!(written(1.0), None);
    assert!(written(180.0 / PI).unwrap().contains("look like degrees"));
    assert!(written(-1.0).unwrap().contains("turned the other way"));
}

/// The world of a tracker and a marker beside the platform's origin hide no convention, and are none.
#[test]
fn conventions_are_named_in_the_world_of_a_tracker_too() {
    let tracker = Pose::from_xyz_angles(Vector3::new(3.2, -1.1, 0.4), [0.2, -0.1, 2.8]);
    let marker = Pose::from_xyz_angles(Vector3::new(0.12, 0.05, 0.31), [0.02, 0.3, -0.1]);
    for robot in robots() {
        let (samples, _) = recorded(&robot);
        let told = with_poses(&samples, |pose| product(&product(&tracker, pose), &marker));
        assert_eq!(found_words(&robot, &told, &[]), None, "{}", robot.name);
        let wxyz = |pose: &Pose| {
            let q = pose.rotation.coords;
            Pose { rotation: UnitQuaternion::new_unchecked(Quaternion::new(q[2], q[3], q[0], q[1])), ..*pose }
        };
        for (written, words) in [
            (with_poses(&told, wxyz), "the scalar came first:"),
            (with_rotations(&told, |rotation| rotation.inverse()), "the quaternions look as if they turned the world"),
            (with_poses(&told, inverse), "the poses look as if they were those of the world in the platform"),
        ] {
            let found = found_words(&robot, &written, &[]).unwrap_or_default();
            assert!(found.contains(words) && !found.contains("one of"), "{}: {words}: {found}", robot.name);
        }
    }
}

/// A point has no marker apart from its place: anchors that are off explain as much.
#[test]
fn anchors_of_a_point_that_are_off_are_no_marker() {
    for name in ["planar-example"] {
        let robot = Robot::builtin(name).unwrap();
        let mut machine = robot.clone();
        machine.cables.iter_mut().enumerate().for_each(|(k, cable)| {
            cable.frame_anchor += robot.plane.first_axis() * 0.02 + robot.plane.second_axis() * 0.02 * (k as f64).cos();
        });
        let mut samples = Samples { cable_count: robot.cable_count(), ..Samples::default() };
        for k in 0..60 {
            let t = 0.1 * f64::from(k);
            let at = [0.5 + 1.5 * t.sin(), 3.0 + (1.7 * t).cos()];
            let pose = robot.motion_pattern.pose(robot.plane, &at).unwrap();
            samples.lengths.extend(lengths(&machine, &pose));
            samples.poses.push(pose);
        }
        assert_eq!(found_words(&robot, &samples, &[]), None);
    }
}

/// Angles up to 14° in another order are within the misfit of coarse anchors; the right anchors show them.
#[test]
fn a_calibrated_robot_shows_what_coarse_anchors_hide() {
    for robot in robots() {
        let (mut samples, angles) = recorded(&robot);
        let small: Vec<[f64; 3]> = angles.iter().map(|angles| angles.map(|angle| 0.4 * angle)).collect();
        samples.lengths.clear();
        for (pose, angles) in samples.poses.iter_mut().zip(&small) {
            let about = |axis: usize| UnitQuaternion::from_axis_angle(&Vector3::ith_axis(axis), angles[axis]);
            let true_pose = Pose { rotation: about(2) * about(1) * about(0), ..*pose };
            samples.lengths.extend(lengths(&robot, &true_pose));
            *pose = Pose::from_xyz_angles(pose.position, *angles);
        }
        let found = with_robot(&robot, &with_angles(&samples, &small)).unwrap();
        assert!(found.text.contains("R = Rz Ry Rx (roll–pitch–yaw)"), "{}", found.text);
        let (clean, angles) = recorded(&robot);
        assert_eq!(with_robot(&robot, &with_angles(&clean, &angles)), None);
    }
}

/// Two swapped cables of a plotter are its world turned over, which no plotter is.
#[test]
fn swapped_cables_of_a_plotter_are_named_though_a_frame_could_stand_for_them() {
    let mut robot = Robot::builtin("planar-example").unwrap();
    robot.cables.drain(..2);
    let mut machine = robot.clone();
    machine.cables[0].frame_anchor += robot.plane.first_axis() * 0.05;
    let mut samples = Samples { cable_count: 2, ..Samples::default() };
    for k in 0..60 {
        let t = 0.1 * f64::from(k);
        let at = [4.0 + 1.5 * t.sin(), 3.0 + (1.7 * t).cos()];
        let pose = robot.motion_pattern.pose(robot.plane, &at).unwrap();
        samples.lengths.extend(lengths(&machine, &pose).into_iter().rev());
        samples.poses.push(pose);
    }
    let words = found_words(&robot, &samples, &[]).unwrap();
    assert!(words.contains("cables 1 to 2 of the robot fit the recorded lengths 2, 1"), "{words}");
}
