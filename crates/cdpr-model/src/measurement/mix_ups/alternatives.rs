//! Other readings of poses.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};

use crate::finding::FindingKind;
use crate::geometry::{MotionPattern, Pose, inverse};
use crate::robot::Robot;

/// Function that reads a pose from its numbers and angles; `None` if this reading does not exist.
type Read = Box<dyn Fn(&Pose, &[f64; 3]) -> Option<Pose>>;

/// A reading of poses, with its description.
pub(super) struct Reading {
    pub(super) kind: FindingKind,
    pub(super) words: String,
    pub(super) read: Read,
    /// True if frames of tracker and marker cannot stand for it.
    pub(super) differs_by_frames: bool,
}

/// All wrong readings of a robot's poses, written with angles or with quaternions.
pub(super) fn readings(robot: &Robot, has_angles: bool) -> Vec<Reading> {
    let mut all = match robot.motion_pattern {
        MotionPattern::Spatial if has_angles => of_angles(),
        MotionPattern::Spatial => of_quaternions(),
        MotionPattern::Planar if has_angles => of_plane(robot),
        _ => Vec::new(),
    };
    if robot.motion_pattern.has_rotation() {
        all.push(whole(
            "the poses look as if they were those of the world in the platform (of the tracker in the marker's frame): inverted they fit the cable lengths much better",
            |pose| Some(inverse(pose)),
        ));
    }
    all.extend(axes(robot));
    all
}

fn rotated(
    words: impl Into<String>,
    rotation: impl Fn(&Pose, &[f64; 3]) -> Option<UnitQuaternion<f64>> + 'static,
) -> Reading {
    let read = move |pose: &Pose, angles: &[f64; 3]| Some(Pose { rotation: rotation(pose, angles)?, ..*pose });
    Reading {
        kind: FindingKind::RotationConvention,
        words: words.into(),
        read: Box::new(read),
        differs_by_frames: true,
    }
}

fn whole(words: impl Into<String>, read: impl Fn(&Pose) -> Option<Pose> + 'static) -> Reading {
    let read = move |pose: &Pose, _: &[f64; 3]| read(pose);
    Reading {
        kind: FindingKind::RotationConvention,
        words: words.into(),
        read: Box::new(read),
        differs_by_frames: true,
    }
}

/// Readings of quaternions.
fn of_quaternions() -> Vec<Reading> {
    let scalar_first = |pose: &Pose| {
        let q = pose.rotation.coords;
        Pose::rotation_from_xyzw([q[1], q[2], q[3], q[0]])
    };
    let fits = "so read they fit the cable lengths much better";
    vec![
        rotated(format!("the quaternions look as if the scalar came first: {fits}"), move |pose, _| scalar_first(pose)),
        rotated(
            "the quaternions look as if they turned the world into the platform: inverted they fit the cable lengths much better",
            |pose, _| Some(pose.rotation.inverse()),
        ),
        rotated(
            format!(
                "the quaternions look as if the scalar came first and they turned the world into the platform: {fits}"
            ),
            move |pose, _| Some(scalar_first(pose)?.inverse()),
        ),
        whole(
            format!(
                "the poses look as if they were those of the world in the platform (of the tracker in the marker's frame), with the scalar of the quaternions first: {fits}"
            ),
            move |pose| Some(inverse(&Pose { rotation: scalar_first(pose)?, ..*pose })),
        ),
    ]
}

/// Readings of angles in space.
fn of_angles() -> Vec<Reading> {
    let fits = "so read they fit the cable lengths much better";
    let mut all = vec![
        rotated(
            "the angles look as if they turned the world into the platform: inverted they fit the cable lengths much better",
            |pose, _| Some(pose.rotation.inverse()),
        ),
        rotated(format!("the angles look like a rotation vector: {fits}"), |_, angles| {
            Some(UnitQuaternion::from_scaled_axis(Vector3::from(*angles)))
        }),
    ];
    for order in [[0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let names: Vec<&str> = order.iter().map(|axis| ["Rx", "Ry", "Rz"][*axis]).collect();
        let name = if order == [2, 1, 0] { " (roll–pitch–yaw)" } else { "" };
        let words = format!("the angles look like those of R = {}{name}, not of R = Rx Ry Rz: {fits}", names.join(" "));
        all.push(rotated(words, move |_, angles| Some(product(order, angles))));
    }
    all.push(rotated(
        format!("the angles look like degrees: {fits}; name the columns rx_deg, ry_deg, rz_deg"),
        |_, angles| Some(product([0, 1, 2], &angles.map(|angle| angle * PI / 180.0))),
    ));
    all.push(rotated(
        format!("the angles look like those of R = Rz Ry Rx (roll–pitch–yaw) in degrees: {fits}"),
        |_, angles| Some(product([2, 1, 0], &angles.map(|angle| angle * PI / 180.0))),
    ));
    all
}

/// Rotations about the axes in an order, each about its own angle.
fn product(order: [usize; 3], angles: &[f64; 3]) -> UnitQuaternion<f64> {
    let about = |axis: usize| UnitQuaternion::from_axis_angle(&Vector3::ith_axis(axis), angles[axis]);
    about(order[0]) * about(order[1]) * about(order[2])
}

/// Readings of the angle in a plane.
fn of_plane(robot: &Robot) -> Vec<Reading> {
    let (pattern, plane) = (robot.motion_pattern, robot.plane);
    let turned = move |words: &str, factor: f64| {
        let read = move |pose: &Pose, angles: &[f64; 3]| {
            let mut components = pattern.pose_to_components(plane, pose);
            components[2] = factor * angles[0];
            pattern.pose(plane, &components).ok()
        };
        Reading {
            kind: FindingKind::RotationConvention,
            words: words.to_owned(),
            read: Box::new(read),
            differs_by_frames: true,
        }
    };
    vec![
        turned(
            "the angles look like degrees: so read they fit the cable lengths much better; name the column angle_deg",
            PI / 180.0,
        ),
        turned(
            "the angles look as if they turned the other way: with the other sign they fit the cable lengths much better",
            -1.0,
        ),
    ]
}

/// Readings of coordinates with axes swapped or mirrored: of positions alone, of both frames, of the world alone.
fn axes(robot: &Robot) -> Vec<Reading> {
    let own: Vec<usize> = if robot.motion_pattern.is_planar() { robot.plane.indices().to_vec() } else { vec![0, 1, 2] };
    let [low, high] = robot.anchor_box();
    let middle = (low + high) / 2.0;
    let mut first_mirror = Matrix3::identity();
    first_mirror[(own[0], own[0])] = -1.0;
    let mut all = Vec::new();
    let swaps = signed_permutations(&own).into_iter().filter(|matrix| *matrix != Matrix3::identity());
    for (matrix, shift) in swaps.flat_map(|matrix| shifts(&matrix, &middle).map(move |shift| (matrix, shift))) {
        let words = words_of(&matrix, &shift, &own);
        let kind = if matrix.determinant() < 0.0 { FindingKind::Mirror } else { FindingKind::Permutation };
        let turns = robot.motion_pattern.has_rotation();
        let moved = move |pose: &Pose, rotation| Some(Pose { position: matrix * pose.position + shift, rotation });
        // turns of the world are a matter of frames, and so are all mirrors but one
        let is_one_mirror = matrix == first_mirror && shift == Vector3::zeros();
        all.push(Reading {
            kind,
            words: words.clone(),
            read: Box::new(move |pose, _| moved(pose, pose.rotation)),
            differs_by_frames: is_one_mirror,
        });
        if turns {
            let both = move |pose: &Pose| rotation(matrix * pose.rotation_matrix() * matrix.transpose());
            all.push(Reading {
                kind,
                words: format!("{words}, in the orientations too"),
                read: Box::new(move |pose, _| moved(pose, both(pose))),
                differs_by_frames: is_one_mirror,
            });
        }
        // a rotation of the world about the normal of the plane, or in space
        if turns && matrix.determinant() > 0.0 {
            all.push(Reading {
                kind,
                words: format!("{words}: the world's axes, also under the orientations"),
                read: Box::new(move |pose, _| moved(pose, rotation(matrix * pose.rotation_matrix()))),
                differs_by_frames: false,
            });
        }
    }
    all
}

/// Shifts for a matrix: none, and for mirrored axes also that of a mirror in the middle of the frame anchors' box.
fn shifts(matrix: &Matrix3<f64>, middle: &Vector3<f64>) -> impl Iterator<Item = Vector3<f64>> + use<> {
    let about_middle = (Matrix3::identity() - matrix) * middle;
    let is_mirror = matrix.diagonal().iter().all(|entry| *entry != 0.0);
    std::iter::once(Vector3::zeros()).chain((is_mirror && about_middle.norm() > 0.0).then_some(about_middle))
}

fn rotation(matrix: Matrix3<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(matrix))
}

/// Matrices that swap and mirror the axes of a robot: 8 of a plane, 48 of space.
fn signed_permutations(own: &[usize]) -> Vec<Matrix3<f64>> {
    let orders: Vec<Vec<usize>> = match own {
        &[a, b] => vec![vec![a, b], vec![b, a]],
        _ => [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]].map(Vec::from).into(),
    };
    let mut all = Vec::new();
    for order in orders {
        for signs in 0..1_u32 << own.len() {
            let mut matrix = Matrix3::identity();
            for (place, (&row, &column)) in own.iter().zip(&order).enumerate() {
                (0..3).for_each(|k| matrix[(row, k)] = 0.0);
                matrix[(row, column)] = if signs >> place & 1 == 1 { -1.0 } else { 1.0 };
            }
            all.push(matrix);
        }
    }
    all
}

/// The robot's axes in terms of the file's, e.g. "x, y, z of the robot look like −y, x, z of the data".
fn words_of(matrix: &Matrix3<f64>, shift: &Vector3<f64>, own: &[usize]) -> String {
    let name = |axis: usize| ["x", "y", "z"][axis];
    let of_data = own.iter().map(|&row| {
        let column = (0..3).find(|&column| matrix[(row, column)] != 0.0).unwrap_or(row);
        match matrix[(row, column)] < 0.0 {
            true if shift[row] != 0.0 => format!("{:.3} m − {}", shift[row], name(column)),
            true => format!("−{}", name(column)),
            false => name(column).to_owned(),
        }
    });
    let of_robot: Vec<&str> = own.iter().map(|&axis| name(axis)).collect();
    let of_data = of_data.collect::<Vec<_>>().join(", ");
    format!("axes look swapped or mirrored: {} of the robot fit {of_data} of the data", of_robot.join(", "))
}
