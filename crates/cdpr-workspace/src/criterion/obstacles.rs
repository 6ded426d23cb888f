//! Cables that do not touch the frame or other obstacles.

use nalgebra::Vector3;

use super::cables::{named, not_negative, per_cable, straight};
use super::clearance::{AxisBox, Segment};
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::{Obstacle, ObstacleShape, Robot};

/// The free part of every cable keeps away from every obstacle of the file (`[[obstacle]]`: boxes along the world's
/// axes and round struts of the frame) by half its diameter and the clearance.
///
/// Cables are straight lines from outlet to platform anchor, without sag. An obstacle that supports a cable's frame
/// anchor (which lies inside it, or nearer than clearance, half a cable and, with pulleys, a pulley's diameter) carries
/// that cable's outlet and is not judged against it. The margin (m) is the least distance left; if a cable passes
/// through, minus the depth. For a strut in a plane, that is its radius plus the length by which the crossing axes have
/// to be moved apart.
#[derive(Clone, Debug)]
pub(crate) struct CableObstacles<'a> {
    model: &'a Model,
    pairs: Vec<Pair>,
    clearance: f64,
}

/// A cable, an obstacle (both from 0), and the least distance of the cable's axis (m).
#[derive(Clone, Copy, Debug)]
struct Pair {
    cable: usize,
    obstacle: usize,
    radius: f64,
    body: Body,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum Body {
    Box(AxisBox),
    Strut { axis: Segment, radius: f64 },
}

const NAME: &str = "obstacles";

impl<'a> CableObstacles<'a> {
    /// The criterion for a clearance (m), with one diameter for all cables (m) or else those of the file.
    pub(crate) fn new(model: &'a Model, clearance: f64, diameter: Option<f64>) -> Result<Self, WorkspaceError> {
        let robot = model.robot();
        not_negative(NAME, "clearance", clearance, "it is a finite length of 0 or more (m)")?;
        if robot.obstacles.is_empty() {
            return Err(missing_obstacles(NAME, robot, "add a table for each box or strut that cables may not touch"));
        }
        let diameters = per_cable(robot, NAME, "diameter_m", diameter, |cable| cable.diameter)?;
        let mut pairs = Vec::new();
        for (cable, diameter) in diameters.into_iter().enumerate() {
            let radius = 0.5 * not_negative(NAME, "diameter", diameter, "it is a finite length of 0 or more (m)")?;
            let anchor = robot.cables[cable].frame_anchor;
            let pulley = if model.composition().pulley { robot.cables[cable].pulley_radius() } else { None };
            let seat = clearance + radius + 2.0 * pulley.unwrap_or_default();
            for (obstacle, data) in robot.obstacles.iter().enumerate() {
                let body = Body::of(robot, data);
                if body.distance(robot, &Segment { from: anchor, to: anchor }) > seat {
                    pairs.push(Pair { cable, obstacle, radius, body });
                }
            }
        }
        Ok(Self { model, pairs, clearance })
    }
}

/// Error of a file without obstacles.
pub(super) fn missing_obstacles(criterion: &'static str, robot: &Robot, cure: &str) -> WorkspaceError {
    WorkspaceError::MissingKey {
        criterion,
        robot: robot.name.clone(),
        key: "`[[obstacle]]`".to_owned(),
        cure: cure.to_owned(),
    }
}

impl Body {
    pub(super) fn of(robot: &Robot, obstacle: &Obstacle) -> Self {
        match obstacle.shape {
            ObstacleShape::Box { min, max } => {
                let mut half_extent: Vector3<f64> = (max - min) * 0.5;
                if robot.motion_pattern.is_planar() {
                    let normal = robot.plane.normal();
                    half_extent = half_extent.zip_map(&normal, |half, n| if n != 0.0 { f64::INFINITY } else { half });
                }
                Self::Box(AxisBox { center: (min + max) * 0.5, half_extent })
            }
            ObstacleShape::Strut { from, to, radius } => Self::Strut { axis: Segment { from, to }, radius },
        }
    }

    /// Distance of a cable's axis from the surface (m), negative inside.
    fn distance(&self, robot: &Robot, cable: &Segment) -> f64 {
        match self {
            Self::Box(solid) => solid.distance(cable),
            Self::Strut { axis, radius } => {
                let between = match robot.motion_pattern.is_planar() {
                    true => axis.distance_in_plane(cable),
                    false => axis.distance(cable),
                };
                between - radius
            }
        }
    }
}

impl Criterion for CableObstacles<'_> {
    fn name(&self) -> &str {
        NAME
    }

    fn unit(&self) -> &str {
        "m"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let (robot, cables) = match straight(self.model, pose) {
            Ok(cables) => (self.model.robot(), cables),
            Err(verdict) => return verdict,
        };
        let distance = |pair: &Pair| pair.body.distance(robot, &cables[pair.cable]);
        let margins = self.pairs.iter().map(|pair| (distance(pair) - pair.radius - self.clearance, pair));
        let Some((margin, pair)) = margins.min_by(|a, b| a.0.total_cmp(&b.0)) else {
            // every obstacle carries every cable
            return Verdict::held(f64::MAX, None);
        };
        if margin >= 0.0 {
            return Verdict::held(margin, Some(pair.cable));
        }
        let (cable, obstacle) = (named(robot, pair.cable), &robot.obstacles[pair.obstacle].name);
        let (distance, needed) = (1e3 * distance(pair), 1e3 * (pair.radius + self.clearance));
        let words = match distance < 0.0 {
            true => format!("{cable} goes through \"{obstacle}\", {:.1} mm deep", -distance),
            false => format!(
                "{cable} comes within {distance:.1} mm of \"{obstacle}\"; half its diameter and the clearance are {needed:.1} mm"
            ),
        };
        Verdict::failed(margin, words, Some(pair.cable))
    }
}
