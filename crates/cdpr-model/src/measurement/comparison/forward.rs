//! Platform poses to which recorded lengths lead, and the frames that lay measured poses on them.

use nalgebra::{DMatrix, DVector, Matrix3, Matrix6, Rotation3, UnitQuaternion, Vector3, Vector6};

use super::Data;
use crate::geometry::{Pose, Twist, product};

/// Steps of one search, and the length of a step that ends it (m, rad).
const STEPS: usize = 25;
const STEP_END: f64 = 1e-6;
/// Largest residual of a pose that lengths lead to, as a fraction of the anchors' diagonal.
const MOST_LEFT: f64 = 0.05;
/// Fewest poses for a start.
const FEWEST: usize = 5;

/// Frames between measured poses and the platform's: platform in world = tracker · measured · marker.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frames {
    /// The tracker's world in the robot's.
    pub(crate) tracker: Pose,
    /// The platform in the marker's frame.
    pub(crate) marker: Pose,
}

impl Frames {
    /// Frames that change nothing.
    pub(super) fn none() -> Self {
        Self { tracker: Pose::identity(), marker: Pose::identity() }
    }

    /// The platform's poses from the measured ones.
    pub(crate) fn platform_poses(&self, poses: &[Pose]) -> Vec<Pose> {
        poses.iter().map(|pose| product(&product(&self.tracker, pose), &self.marker)).collect()
    }
}

/// Platform poses by the sample's index, found from recorded lengths alone; empty for robots with too few cables.
pub(super) fn platform_poses(data: &Data<'_>) -> Vec<(usize, Pose)> {
    let robot = data.robot;
    let basis = robot.motion_pattern.twist_basis(robot.plane);
    if data.recorded.len() < basis.len() {
        return Vec::new();
    }
    let home = below_anchors(data);
    let mut last = home;
    let mut found = Vec::new();
    for sample in 0..data.poses.len() {
        let starts = [last, home];
        if let Some(pose) = starts.iter().find_map(|start| solved(data, sample, *start, &basis)) {
            last = pose;
            found.push((sample, pose));
        }
    }
    found
}

/// The pose from which searches start: home, or the middle of the anchors, lowered if they are all at one height.
fn below_anchors(data: &Data<'_>) -> Pose {
    let robot = data.robot;
    let (mut home, [low, high]) = (robot.home_or_middle(), robot.anchor_box());
    let diagonal = robot.anchor_diagonal();
    if robot.home.is_none() && !robot.motion_pattern.is_planar() && high.z - low.z < 0.05 * diagonal {
        home.position.z -= 0.3 * diagonal;
    }
    home
}

/// Damped Gauss–Newton steps of one pose.
fn solved(data: &Data<'_>, sample: usize, start: Pose, basis: &[Twist]) -> Option<Pose> {
    let (robot, mut pose) = (data.robot, start);
    let mut squares = f64::INFINITY;
    for _ in 0..STEPS {
        let mut normal = DMatrix::zeros(basis.len(), basis.len());
        let mut gradient = DVector::zeros(basis.len());
        squares = 0.0;
        for (cable, recorded) in robot.cables.iter().zip(&data.recorded) {
            let b = pose.rotation * cable.platform_anchor;
            let span = pose.position + b - cable.frame_anchor;
            let told = (recorded[sample] - cable.length_offset.unwrap_or(0.0)) / cable.length_scale.unwrap_or(1.0);
            let residual = told - span.norm();
            squares += residual * residual;
            let (force, moment) = (span.normalize(), b.cross(&span.normalize()));
            let row = Vector6::new(force.x, force.y, force.z, moment.x, moment.y, moment.z);
            let row = DVector::from_iterator(basis.len(), basis.iter().map(|unit| unit.dot(&row)));
            normal += &row * row.transpose();
            gradient += row * residual;
        }
        let damping = 1e-6 * normal.trace();
        (0..basis.len()).for_each(|k| normal[(k, k)] += damping);
        let solved = normal.cholesky()?.solve(&gradient);
        let mut step: Twist = basis.iter().zip(solved.iter()).map(|(unit, size)| unit * *size).sum();
        // a step is at most a tenth of the robot and a third of a radian
        let longest = (step.fixed_rows::<3>(0).norm() / (0.1 * robot.anchor_diagonal()))
            .max(step.fixed_rows::<3>(3).norm() / 0.3);
        step /= longest.max(1.0);
        pose = Pose {
            position: pose.position + step.fixed_rows::<3>(0),
            rotation: UnitQuaternion::new(step.fixed_rows::<3>(3).into_owned()) * pose.rotation,
        };
        if !pose.is_finite() {
            return None;
        }
        if step.amax() < STEP_END {
            break;
        }
    }
    let left = (squares / data.recorded.len().max(1) as f64).sqrt();
    (left < MOST_LEFT * robot.anchor_diagonal()).then_some(pose)
}

/// Frames that lay measured poses on those that lengths lead to, by positions and by relative turns; empty without
/// enough of the latter.
pub(super) fn starts(data: &Data<'_>, poses: &[Pose], platform: &[(usize, Pose)]) -> Vec<Frames> {
    if platform.len() < FEWEST {
        return Vec::new();
    }
    let mean =
        |positions: &mut dyn Iterator<Item = Vector3<f64>>| positions.sum::<Vector3<f64>>() / platform.len() as f64;
    let centre = mean(&mut platform.iter().map(|(_, pose)| pose.position));
    let measured = mean(&mut platform.iter().map(|(sample, _)| poses[*sample].position));
    let mut by_positions = Matrix3::zeros();
    for (sample, pose) in platform {
        by_positions += (pose.position - centre) * (poses[*sample].position - measured).transpose();
    }
    let mut rotations = vec![nearest_rotation(&by_positions), UnitQuaternion::identity()];
    if data.robot.motion_pattern.has_rotation() {
        let mut by_turns = Matrix3::zeros();
        let half = platform.len() / 2;
        for ((first, a), (second, b)) in platform.iter().zip(platform.iter().cycle().skip(half)) {
            let turn = (b.rotation * a.rotation.inverse()).scaled_axis();
            let told = (poses[*second].rotation * poses[*first].rotation.inverse()).scaled_axis();
            by_turns += turn * told.transpose();
        }
        rotations.push(nearest_rotation(&by_turns));
    }
    rotations.into_iter().map(|rotation| frames(data, poses, platform, rotation)).collect()
}

/// The frames with this rotation of the tracker: the marker's mean rotation, then both places by least squares.
fn frames(data: &Data<'_>, poses: &[Pose], platform: &[(usize, Pose)], rotation: UnitQuaternion<f64>) -> Frames {
    let turns = data.robot.motion_pattern.has_rotation();
    let mut sum = Matrix3::zeros();
    let (mut normal, mut right) = (Matrix6::zeros(), Vector6::zeros());
    for (sample, pose) in platform {
        let told = rotation * poses[*sample].rotation;
        sum += (told.inverse() * pose.rotation).to_rotation_matrix().into_inner();
        let mut rows = nalgebra::Matrix3x6::zeros();
        rows.fixed_columns_mut::<3>(0).copy_from(&Matrix3::identity());
        if turns {
            rows.fixed_columns_mut::<3>(3).copy_from(told.to_rotation_matrix().matrix());
        }
        normal += rows.transpose() * rows;
        right += rows.transpose() * (pose.position - rotation * poses[*sample].position);
    }
    let places =
        normal.pseudo_inverse(1e-6 * platform.len() as f64).map_or(Vector6::zeros(), |inverse| inverse * right);
    let marker = if turns { nearest_rotation(&sum) } else { UnitQuaternion::identity() };
    Frames {
        tracker: Pose { position: places.fixed_rows::<3>(0).into(), rotation },
        marker: Pose { position: places.fixed_rows::<3>(3).into(), rotation: marker },
    }
}

/// The rotation nearest to a matrix.
fn nearest_rotation(matrix: &Matrix3<f64>) -> UnitQuaternion<f64> {
    let svd = matrix.svd(true, true);
    let (Some(u), Some(v)) = (svd.u, svd.v_t) else { return UnitQuaternion::identity() };
    let mut signs = Matrix3::identity();
    // singular values need no order here: the least one takes the sign
    signs[(svd.singular_values.imin(), svd.singular_values.imin())] = (u * v).determinant().signum();
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(u * signs * v))
}
