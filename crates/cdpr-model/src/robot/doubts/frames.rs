//! Platform anchors that are stated in the world frame.

use nalgebra::Vector3;

use crate::finding::{Finding, FindingKind, Severity};
use crate::robot::Robot;

/// Least distance of the middle of the platform anchors from the origin, as part of the diagonal of the frame anchors.
const AWAY: f64 = 0.1;

/// Largest distance between the middle of the platform anchors and the home position, as part of how far that is from the origin.
const NEAR: f64 = 0.25;

/// Platform anchors about the home position instead of about the platform's origin.
pub(super) fn platform_anchors_in_world(robot: &Robot) -> Vec<Finding> {
    let anchors = || robot.cables.iter().map(|cable| cable.platform_anchor);
    let middle = anchors().sum::<Vector3<f64>>() / robot.cable_count().max(1) as f64;
    let spread = anchors().map(|b| (b - middle).norm()).fold(0.0, f64::max);
    let (home, away) = (robot.home_or_middle().position, middle.norm());
    if away <= 2.0 * spread || away < AWAY * robot.anchor_diagonal() || (middle - home).norm() > NEAR * away {
        return Vec::new();
    }
    let [x, y, z] = [middle.x, middle.y, middle.z];
    let text = format!(
        "the middle of the platform anchors, ({x:.3}, {y:.3}, {z:.3}) m, lies at the home position and {away:.3} m from the platform's origin: are they \
         stated in the world frame? platform_anchor_m counts from the platform's origin, in the platform's own axes"
    );
    vec![Finding::new(FindingKind::Frame, Severity::Caution, text).of_size(away, "m")]
}
