//! Frames as a fit tells them.

use super::poses::Frames;

/// A frame with its standard deviations.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameEstimate {
    /// Origin (m).
    pub position_m: [f64; 3],
    /// Angles of R = Rx Ry Rz (rad).
    pub rotation_rad: [f64; 3],
    /// The same rotation.
    pub quaternion_xyzw: [f64; 4],
    /// Standard deviations of the origin (m).
    pub sigma_position_m: [f64; 3],
    /// Standard deviations of small rotations about the axes of the frame that it is given in (rad).
    pub sigma_rotation_rad: [f64; 3],
}

/// Freedom that the data leave of the frame of a calibrated robot, and what fixes it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Gauge {
    /// `least-change`: of the file's anchors.
    pub kind: &'static str,
    /// `translation`, `rotation`; empty where the data leave nothing free.
    pub free: Vec<&'static str>,
    /// Number of free directions.
    pub directions: usize,
}

/// Frames that were identified together with a model.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordingFrames {
    pub(super) frames: Frames,
    /// Pose of the tracker's world in the frame of the robot, where it was free.
    pub tracker: Option<FrameEstimate>,
    /// Pose of the marker on the platform, where it was free.
    pub marker: Option<FrameEstimate>,
    /// Freedom that the data leave of them.
    pub gauge: Gauge,
}
