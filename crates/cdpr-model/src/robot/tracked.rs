//! Frames between a tracker's numbers and a robot: the tracker's world in the robot's frame, and the marker on the platform.

use nalgebra::{Matrix3, UnitQuaternion, Vector3};

use crate::geometry::{MotionPattern, Plane, Pose, Twist, inverse, product};

/// Turn below which a series replaces closed forms (rad).
const SMALL: f64 = 1e-4;

/// A frame as numbers that a calibration may change.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Frame {
    /// Its origin (m).
    pub position: Vector3<f64>,
    /// Its rotation vector: axis times angle (rad).
    pub turn: Vector3<f64>,
}

impl Frame {
    /// The frame of a pose.
    pub fn of(pose: &Pose) -> Self {
        Self { position: pose.position, turn: pose.rotation.scaled_axis() }
    }

    /// The pose of the frame.
    pub fn pose(&self) -> Pose {
        Pose { position: self.position, rotation: UnitQuaternion::from_scaled_axis(self.turn) }
    }

    /// Columns ω of small turns about the outer axes per change of each component of the rotation vector: the left Jacobian of SO(3).
    pub fn turn_by_vector(&self) -> Matrix3<f64> {
        let (angle, cross) = (self.turn.norm(), self.turn.cross_matrix());
        let (first, second) = match angle < SMALL {
            true => (0.5 - angle * angle / 24.0, 1.0 / 6.0 - angle * angle / 120.0),
            false => ((1.0 - angle.cos()) / (angle * angle), (angle - angle.sin()) / angle.powi(3)),
        };
        Matrix3::identity() + first * cross + second * cross * cross
    }

    /// Motion of a point at an arm from the origin per change of a component, outer axes: positions first, then the rotation vector.
    fn motion_at(&self, component: &Component, arm: &Vector3<f64>) -> Twist {
        let (shift, turn) = match component {
            Component::Shift(axis) => (*axis, Vector3::zeros()),
            Component::Turn(axis) => {
                let turn = self.turn_by_vector() * axis;
                (turn.cross(arm), turn)
            }
        };
        Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
    }
}

/// Component of a frame along a direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Component {
    /// Of its origin.
    Shift(Vector3<f64>),
    /// Of its rotation vector.
    Turn(Vector3<f64>),
}

/// Frames of a recording, which no robot file states: found by a calibration, and carried with the robot that it gives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrackedFrames {
    /// The tracker's world in the robot's frame.
    pub tracker: Frame,
    /// The marker on the platform.
    pub marker: Frame,
}

impl TrackedFrames {
    /// Pose of the marker in the tracker's world, X⁻¹ T Y, for a pose of the platform; of platforms that do not turn the marker is the platform's origin.
    pub fn seen(&self, platform: &Pose) -> Pose {
        product(&inverse(&self.tracker.pose()), &product(platform, &self.marker.pose()))
    }

    /// Change of what is seen, in the axes of the tracker's world, where the marker moves by a twist about itself (robot's axes).
    pub fn seen_by(&self, moved: &Twist) -> Twist {
        let back = self.tracker.pose().rotation.inverse();
        let [shift, turn] = [0, 3].map(|first| back * moved.fixed_rows::<3>(first).into_owned());
        Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
    }

    /// Motion of the marker about itself (robot's axes) by a twist of the platform about its origin.
    pub fn by_platform(&self, twist: &Twist, rotation: &Matrix3<f64>) -> Twist {
        let turn: Vector3<f64> = twist.fixed_rows::<3>(3).into_owned();
        let shift = twist.fixed_rows::<3>(0) + turn.cross(&(rotation * self.marker.position));
        Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
    }

    /// The same per change of a component of the tracker's world, which moves what is seen the other way, at a pose of the platform.
    pub fn by_tracker(&self, component: &Component, platform: &Pose) -> Twist {
        let marker = platform.transform(&self.marker.position);
        -self.tracker.motion_at(component, &(marker - self.tracker.position))
    }

    /// The same per change of a component of the marker's frame on the platform.
    pub fn by_marker(&self, component: &Component, rotation: &Matrix3<f64>) -> Twist {
        let own = self.marker.motion_at(component, &Vector3::zeros());
        let [shift, turn] = [0, 3].map(|first| rotation * own.fixed_rows::<3>(first).into_owned());
        Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
    }
}

impl Component {
    /// Component of a frame in the space of a pattern: along its axes, then about them; in a plane about its normal. `None` beyond them.
    pub(crate) fn of(pattern: MotionPattern, plane: Plane, index: usize) -> Option<Self> {
        let basis = pattern.twist_basis(plane);
        match (index.checked_sub(pattern.translations()), pattern.is_planar()) {
            (None, _) => Some(Self::Shift(basis[index].fixed_rows::<3>(0).into_owned())),
            (Some(turn), true) => (turn == 0).then(|| Self::Turn(plane.normal())),
            (Some(turn), false) => (turn < 3).then(|| Self::Turn(Vector3::ith(turn, 1.0))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every derivative of what a tracker sees is its difference.
    #[test]
    fn derivatives_of_what_is_seen_are_its_differences() {
        let frames = TrackedFrames {
            tracker: Frame { position: Vector3::new(3.0, -1.0, 0.5), turn: Vector3::new(0.4, -1.1, 2.0) },
            marker: Frame { position: Vector3::new(0.2, 0.1, -0.3), turn: Vector3::new(-0.3, 0.8, 0.1) },
        };
        let platform = Pose::from_xyz_angles(Vector3::new(0.5, 0.4, 1.2), [0.2, -0.3, 0.9]);
        let (seen, rotation) = (frames.seen(&platform), platform.rotation_matrix());
        let h = 1e-6;
        let near = |moved: &dyn Fn(f64) -> Pose, twist: Twist, what: &str| {
            let slope = (seen.displacement_to(&moved(h)) - seen.displacement_to(&moved(-h))) / (2.0 * h);
            assert!((slope - frames.seen_by(&twist)).amax() < 1e-8, "{what}: {slope} {}", frames.seen_by(&twist));
        };
        for k in 0..6 {
            let twist = Twist::ith(k, 1.0);
            near(
                &|h| frames.seen(&platform.displaced(&(twist * h))),
                frames.by_platform(&twist, &rotation),
                &format!("platform {k}"),
            );
            let axis = Vector3::ith(k % 3, 1.0);
            let component = if k < 3 { Component::Shift(axis) } else { Component::Turn(axis) };
            let moved = |frame: Frame, h: f64| match k < 3 {
                true => Frame { position: frame.position + axis * h, ..frame },
                false => Frame { turn: frame.turn + axis * h, ..frame },
            };
            near(
                &|h| TrackedFrames { tracker: moved(frames.tracker, h), ..frames }.seen(&platform),
                frames.by_tracker(&component, &platform),
                &format!("tracker {k}"),
            );
            near(
                &|h| TrackedFrames { marker: moved(frames.marker, h), ..frames }.seen(&platform),
                frames.by_marker(&component, &rotation),
                &format!("marker {k}"),
            );
        }
    }
}
