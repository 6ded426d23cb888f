//! Directions in which frames move, and what they do to the platform.

use nalgebra::{UnitQuaternion, Vector3};

use super::poses::Frames;
use cdpr_model::geometry::{Pose, Twist, Wrench, inverse, product};
use cdpr_model::model::{Model, RecordingParameter};
use cdpr_model::robot::{Parameter, ParameterKind};

/// Least extent of poses, for those that are all at one place (m).
const LEAST_EXTENT: f64 = 1e-3;

/// A direction in which a frame may move.
#[derive(Clone, Copy, Debug)]
pub(super) struct Direction {
    /// Tracker or marker.
    pub(super) frame: RecordingParameter,
    /// Motion by one metre: rotations are those whose arm is the extent. Of the tracker about the middle of all poses (robot's axes), of
    /// the marker that of the platform against it (platform's axes).
    pub(super) motion: Twist,
}

/// Directions of the free frames, with the middle of all poses.
pub(super) struct Directions {
    pub(super) list: Vec<Direction>,
    pub(super) middle: Vector3<f64>,
    /// Distance of the poses from their middle (root of the mean square, m).
    pub(super) extent: f64,
}

impl Directions {
    pub(super) fn of(model: &Model, freed: &[RecordingParameter], poses: &[Pose]) -> Self {
        let (robot, count) = (model.robot(), poses.len() as f64);
        let middle = poses.iter().map(|pose| pose.position).sum::<Vector3<f64>>() / count;
        let spread = poses.iter().map(|pose| (pose.position - middle).norm_squared()).sum::<f64>() / count;
        let extent = spread.sqrt().max(LEAST_EXTENT);
        let turning = |normal: Vector3<f64>| Twist::new(0.0, 0.0, 0.0, normal.x, normal.y, normal.z);
        let turns = match robot.motion_pattern.is_planar() {
            true => vec![turning(robot.plane.normal())],
            false => (0..3).map(|axis| turning(Vector3::ith(axis, 1.0))).collect(),
        };
        let shifts = model.axes().iter().map(|axis| Twist::new(axis.x, axis.y, axis.z, 0.0, 0.0, 0.0));
        let motions: Vec<Twist> = shifts.chain(turns).collect();
        let of_frame = |&frame: &RecordingParameter| {
            let arm = if frame == RecordingParameter::TrackerFrame { extent } else { model.platform_radius() };
            motions.iter().map(move |motion| {
                let is_turn = motion.fixed_rows::<3>(3).norm() > 0.0;
                Direction { frame, motion: if is_turn { motion / arm } else { *motion } }
            })
        };
        let is_free = |frame: &&RecordingParameter| freed.contains(frame);
        let list = RecordingParameter::FRAMES.iter().filter(is_free).flat_map(of_frame).collect();
        Self { list, middle, extent }
    }

    /// Motion of the platform at a pose by one metre of each direction (world).
    pub(super) fn motions(&self, pose: &Pose) -> impl Iterator<Item = Twist> {
        self.list.iter().map(|direction| {
            let (shift, turn) = (direction.motion.fixed_rows::<3>(0), direction.motion.fixed_rows::<3>(3));
            let (shift, turn) = match direction.frame {
                RecordingParameter::TrackerFrame => (shift + turn.cross(&(pose.position - self.middle)), turn.into()),
                _ => (pose.rotation * shift, pose.rotation * turn),
            };
            Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
        })
    }

    /// Change of a wrench's numbers by one metre of each direction that is none of the wrench: its axes turn with the tracker's world, its point moves
    /// with the platform's origin along the marker's directions.
    pub(super) fn changes_of_axes(&self, pose: &Pose, wrench: &Wrench) -> impl Iterator<Item = Wrench> {
        let (force, moment) = (Vector3::from(wrench.fixed_rows::<3>(0)), Vector3::from(wrench.fixed_rows::<3>(3)));
        self.list.iter().map(move |direction| {
            let (shift, turn) =
                (direction.motion.fixed_rows::<3>(0), Vector3::from(direction.motion.fixed_rows::<3>(3)));
            let (force, moment) = match direction.frame {
                RecordingParameter::TrackerFrame => (turn.cross(&force), turn.cross(&moment)),
                _ => (Vector3::zeros(), -(pose.rotation * shift).cross(&force)),
            };
            Wrench::new(force.x, force.y, force.z, moment.x, moment.y, moment.z)
        })
    }

    /// Total motion of tracker and of the platform against the marker.
    fn total(&self, step: &[f64], frame: RecordingParameter) -> Twist {
        let of_frame = self.list.iter().zip(step).filter(|(direction, _)| direction.frame == frame);
        of_frame.map(|(direction, amount)| direction.motion * *amount).sum()
    }

    /// The frames after a step.
    pub(super) fn moved(&self, frames: &Frames, step: &[f64]) -> Frames {
        let parts = |twist: Twist| {
            let turn = UnitQuaternion::new(twist.fixed_rows::<3>(3).into_owned());
            (Vector3::from(twist.fixed_rows::<3>(0)), turn)
        };
        let (shift, turn) = parts(self.total(step, RecordingParameter::TrackerFrame));
        let tracker = Pose {
            position: self.middle + shift + turn * (frames.tracker.position - self.middle),
            rotation: turn * frames.tracker.rotation,
        };
        let (shift, turn) = parts(self.total(step, RecordingParameter::MarkerFrame));
        let marker = product(&inverse(&Pose { position: shift, rotation: turn }), &frames.marker);
        Frames { tracker, marker, ..*frames }
    }
}

/// Estimates that stand for an anchor.
pub(super) fn is_anchor(parameter: &Parameter) -> bool {
    matches!(parameter.kind, ParameterKind::FrameAnchor | ParameterKind::PlatformAnchor)
}
