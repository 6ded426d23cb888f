//! Gravity upside down, and anchors below a platform that hangs.

use nalgebra::Vector3;

use crate::finding::{Finding, FindingKind, Severity};
use crate::robot::Robot;

/// Part of the diagonal of the anchors by which an anchor has to be lower than the platform to count as below.
const BELOW: f64 = 0.01;

/// Heights of the frame anchors above their platform anchors at the home pose, against gravity (m); `None` without gravity.
fn heights(robot: &Robot) -> Option<Vec<f64>> {
    let gravity = robot.gravity.filter(|gravity| gravity.norm() > 0.0)?;
    let (up, home) = (-gravity.normalize(), robot.home_or_middle());
    let height = |a: Vector3<f64>, b: Vector3<f64>| (a - home.position - home.rotation * b).dot(&up);
    Some(robot.cables.iter().map(|cable| height(cable.frame_anchor, cable.platform_anchor)).collect())
}

/// Axis along whose positive side gravity points, where it points along one.
fn axis_downwards(robot: &Robot) -> Option<&'static str> {
    let gravity = robot.gravity?;
    let axis = gravity.iamax();
    (gravity[axis] > 0.0).then(|| ["x", "y", "z"][axis])
}

/// True of robots whose axis points downwards throughout: every frame anchor is above the platform as gravity has it.
fn hangs(robot: &Robot, heights: &[f64]) -> bool {
    let least = BELOW * robot.anchor_diagonal();
    heights.iter().all(|height| *height > least)
}

/// Gravity along a positive axis, unless all anchors are above the platform in that direction.
pub(super) fn upside_down(robot: &Robot) -> Vec<Finding> {
    let (Some(heights), Some(axis)) = (heights(robot), axis_downwards(robot)) else { return Vec::new() };
    if hangs(robot, &heights) {
        return Vec::new();
    }
    let text = format!(
        "gravity_m_s2 points along +{axis}, and frame anchors lie there, too: is it upside down? It is the direction in which things fall, \
         as [0, 0, -9.81]"
    );
    vec![Finding::new(FindingKind::Gravity, Severity::Caution, text)]
}

/// Frame anchors below a platform that cables can only hold from above: all of them, or one of no more cables than degrees of freedom.
pub(super) fn anchors_below(robot: &Robot) -> Vec<Finding> {
    let Some(heights) = heights(robot).filter(|_| axis_downwards(robot).is_none()) else { return Vec::new() };
    let least = BELOW * robot.anchor_diagonal();
    let is_below = |height: &f64| *height < -least;
    let caution = |text: String| Finding::new(FindingKind::Anchor, Severity::Caution, text);
    if heights.iter().all(is_below) {
        let text = "all frame anchors lie below the platform at the home pose: the cables pull where its weight does, so that nothing holds it";
        return vec![caution(text.to_owned())];
    }
    // more cables than degrees of freedom can be tensioned against each other
    if robot.cable_count() > robot.dof() {
        return Vec::new();
    }
    let found = heights.iter().enumerate().filter(|(_, height)| is_below(height));
    found
        .map(|(cable, height)| {
            let (number, name, below) = (cable + 1, &robot.cables[cable].name, -height);
            let text = format!(
                "the frame anchor of cable {number} (\"{name}\") lies {below:.3} m below the platform at the home pose: {} cables hold {} degrees of \
                 freedom by the weight alone, which this one pulls along; is the sign of its height right?",
                robot.cable_count(),
                robot.dof()
            );
            caution(text).of_cable(cable).of_size(below, "m")
        })
        .collect()
}
