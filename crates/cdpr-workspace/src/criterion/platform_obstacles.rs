//! A platform that does not touch the frame or other obstacles.

use nalgebra::Vector3;

use super::cables::not_negative;
use super::clearance::{Other, Solid};
use super::obstacles::{Body, missing_obstacles};
use super::{Criterion, Spans, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;

/// The platform keeps away from every obstacle of the file (`[[obstacle]]`) by a clearance.
///
/// The platform is the convex hull of the points `hull_m` in \[platform\], or of the platform anchors if the file has
/// none. The margin (m) is the exact distance of the nearest obstacle minus the clearance; if they overlap, minus the
/// shortest translation that would part them. Without a clearance and among boxes only, the parts of a straight line on
/// which it holds have a closed form.
#[derive(Clone, Debug)]
pub struct PlatformObstacles<'a> {
    model: &'a Model,
    /// The platform in platform axes.
    solid: Solid,
    /// Obstacles of the file, each with the distance that its axis needs (m): the radius of a strut.
    bodies: Vec<(Other, f64)>,
    clearance: f64,
}

const NAME: &str = "platform-obstacles";

impl<'a> PlatformObstacles<'a> {
    /// The criterion for a clearance (m).
    pub fn new(model: &'a Model, clearance: f64) -> Result<Self, WorkspaceError> {
        let robot = model.robot();
        not_negative(NAME, "clearance", clearance, "it is a finite length of 0 or more (m)")?;
        if robot.obstacles.is_empty() {
            return Err(missing_obstacles(
                NAME,
                robot,
                "add a table for each box or strut that the platform may not touch",
            ));
        }
        let points = robot.platform.hull.clone();
        let points = points.unwrap_or_else(|| robot.cables.iter().map(|cable| cable.platform_anchor).collect());
        let solid = Solid::over(points, robot.motion_pattern.is_planar().then(|| robot.plane.normal()));
        let bodies = robot.obstacles.iter().map(|obstacle| match Body::of(robot, obstacle) {
            Body::Box(solid) => (Other::Box(solid), 0.0),
            Body::Strut { axis, radius } => (Other::Strut(axis), radius),
        });
        Ok(Self { model, solid, bodies: bodies.collect(), clearance })
    }
}

impl Criterion for PlatformObstacles<'_> {
    fn name(&self) -> &str {
        NAME
    }

    fn unit(&self) -> &str {
        "m"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        if !pose.position.iter().chain(pose.rotation.coords.iter()).all(|number| number.is_finite()) {
            return Verdict::impossible("the pose is not finite", None);
        }
        let solid = self.solid.moved(|point| pose.transform(point));
        let distances = self.bodies.iter().map(|(body, radius)| solid.distance(body) - radius);
        let Some((obstacle, distance)) = distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)) else {
            return Verdict::held(f64::MAX, None);
        };
        let margin = distance - self.clearance;
        if margin >= 0.0 {
            return Verdict::held(margin, None);
        }
        let name = &self.model.robot().obstacles[obstacle].name;
        let words = match distance < 0.0 {
            true => format!("the platform reaches {:.1} mm into \"{name}\"", -1e3 * distance),
            false => {
                let (away, needed) = (1e3 * distance, 1e3 * self.clearance);
                format!("the platform comes within {away:.1} mm of \"{name}\"; {needed:.1} mm are asked for")
            }
        };
        Verdict::failed(margin, words, None)
    }

    fn holds_along(&self, start: &Pose, direction: &Vector3<f64>, length: f64) -> Option<Spans> {
        if self.clearance > 0.0 || self.bodies.iter().any(|(_, radius)| *radius > 0.0) {
            return None;
        }
        let solid = self.solid.moved(|point| start.transform(point));
        let overlaps = self.bodies.iter().map(|(body, _)| solid.overlap_along(body, direction));
        Some(overlaps.fold(Spans::whole(length), |spans, overlap| spans.without(overlap)))
    }
}
