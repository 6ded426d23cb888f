//! Cables that do not touch the platform.

use super::cables::{named, not_negative, paths};
use super::clearance::Cone;
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;

/// No cable runs into the platform that it holds, or passes it at less than a given angle.
///
/// The platform is the convex hull of the points `hull_m` in \[platform\], or of the platform anchors if the file has
/// none. Seen from its anchor it fills a cone of directions; the cable is straight and its thickness is left out. A
/// cable that leaves the cone does not return to the convex body. The margin (rad) is the angle between cable and cone
/// minus the required one: the exact angle beside a side of the cone and inside it, at most the angle off its edges (in
/// a plane, from 90° off a side). Anchors inside the hull of the anchors are not judged: there the hull says nothing
/// about the body.
#[derive(Clone, Debug)]
pub(crate) struct PlatformInterference<'a> {
    model: &'a Model,
    /// Cones in platform axes, one per cable; `None` if the anchor is not judged.
    cones: Vec<Option<Cone>>,
    angle: f64,
}

const NAME: &str = "platform-interference";

impl<'a> PlatformInterference<'a> {
    /// The criterion for the least angle between cable and platform (rad); 0 forbids only contact.
    pub(crate) fn new(model: &'a Model, angle: f64) -> Result<Self, WorkspaceError> {
        let robot = model.robot();
        let wanted = "it is a finite angle of 0 or more (rad)";
        not_negative(NAME, "least angle", angle, wanted)?;
        let missing = |key: String, cure: &str| WorkspaceError::MissingKey {
            criterion: NAME,
            robot: robot.name.clone(),
            key,
            cure: cure.to_owned(),
        };
        let anchors: Vec<_> = robot.cables.iter().map(|cable| cable.platform_anchor).collect();
        let body = robot.platform.hull.as_ref().unwrap_or(&anchors);
        if body.iter().all(|point| *point == body[0]) {
            let cure = "all platform anchors are one point, so the platform has no body without it";
            return Err(missing("`hull_m` in [platform]".to_owned(), cure));
        }
        let normal = robot.motion_pattern.is_planar().then(|| robot.plane.normal());
        let mut cones = Vec::new();
        for (cable, anchor) in anchors.iter().enumerate() {
            let cone = Cone::over(anchor, body, normal);
            if cone.is_everything() && robot.platform.hull.is_some() {
                let key =
                    format!("a `hull_m` in [platform] with the anchor of {} on or outside it", named(robot, cable));
                return Err(missing(key, "a cable that starts inside the body could not leave it"));
            }
            cones.push((!cone.is_everything()).then_some(cone));
        }
        Ok(Self { model, cones, angle })
    }
}

impl Criterion for PlatformInterference<'_> {
    fn name(&self) -> &str {
        NAME
    }

    fn unit(&self) -> &str {
        "rad"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let paths = match paths(self.model, pose) {
            Ok(paths) => paths,
            Err(verdict) => return verdict,
        };
        let mut least = (f64::MAX, None);
        for (cable, ((path, _), cone)) in paths.iter().zip(&self.cones).enumerate() {
            let Some(cone) = cone else { continue };
            let angle = cone.angle(&(pose.rotation.inverse() * nalgebra::Vector3::from(path.direction)));
            if angle < least.0 {
                least = (angle, Some(cable));
            }
        }
        let (angle, Some(cable)) = least else { return Verdict::held(f64::MAX, None) };
        let margin = angle - self.angle;
        if margin >= 0.0 {
            return Verdict::held(margin, Some(cable));
        }
        let (name, degrees) = (named(self.model.robot(), cable), angle.to_degrees());
        let words = match angle < 0.0 {
            true => format!("{name} runs into the platform, {:.2}° below its surface", -degrees),
            false => {
                let asked = self.angle.to_degrees();
                format!("{name} leaves the platform at {degrees:.2}° only, at least {asked:.2}° are asked for")
            }
        };
        Verdict::failed(margin, words, Some(cable))
    }
}
