//! Whether the model has an answer at a pose at all.

use super::cables::named;
use super::{Criterion, Verdict};
use crate::geometry::Pose;
use crate::model::Model;

/// Every cable has a course at the pose: no platform anchor lies on its outlet, inside its pulley, on the pulley's swivel axis, or
/// on the open side of a pulley that does not swivel.
///
/// The margin (m) is the least distance of a platform anchor from where its cable has no course: from the outlet, or from the
/// pulley's circle and swivel axis. Inside the pulley it is below zero by the depth; on outlet or axis it is zero and fails.
#[derive(Clone, Debug)]
pub struct ModelValid<'a> {
    model: &'a Model,
}

impl<'a> ModelValid<'a> {
    /// The criterion for any model.
    pub fn new(model: &'a Model) -> Self {
        Self { model }
    }

    /// Distance of a cable's platform anchor from where it would have no course (m).
    fn distance(&self, cable: usize, pose: &Pose) -> f64 {
        let data = &self.model.robot().cables[cable];
        let d = pose.transform(&data.platform_anchor) - data.frame_anchor;
        let (true, Some(axis), Some(radius)) =
            (self.model.composition().pulley, data.pulley_swivel_axis, data.pulley_radius)
        else {
            return d.norm();
        };
        let along = axis.dot(&d);
        if let Some(side) = self.model.robot().pulley_side(data) {
            let across = side.dot(&d);
            let from_circle = (across - radius).hypot(along) - radius;
            // the open side is the quarter of the plane with across < 0 and along > 0
            let from_open_side = match across < 0.0 && along > 0.0 {
                true => across.max(-along),
                false => across.max(0.0).hypot(along.min(0.0)),
            };
            return from_circle.min(from_open_side);
        }
        let across = (d - axis * along).norm();
        let from_circle = (across - radius).hypot(along) - radius;
        if radius > 0.0 { from_circle.min(across) } else { d.norm() }
    }
}

impl Criterion for ModelValid<'_> {
    fn name(&self) -> &str {
        "validity"
    }

    fn unit(&self) -> &str {
        "m"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        if !pose.is_finite() {
            return Verdict::impossible("the pose is not finite", None);
        }
        let mut nearest = (f64::MAX, None);
        let mut reason = None;
        for cable in 0..self.model.cable_count() {
            let distance = self.distance(cable, pose);
            if distance < nearest.0 {
                nearest = (distance, Some(cable));
            }
            if let (None, Err(error)) = (&reason, self.model.course(cable, pose)) {
                let text = error.to_string();
                let words = text.strip_prefix(&format!("cable {}", cable + 1)).unwrap_or(&text);
                reason = Some((cable, format!("{}{words}", named(self.model.robot(), cable))));
            }
        }
        let (margin, cable) = nearest;
        match reason {
            Some((first, words)) => Verdict::failed(margin, words, Some(first)),
            None => Verdict::held(margin, cable),
        }
    }

    fn holds(&self, pose: &Pose) -> bool {
        pose.is_finite() && (0..self.model.cable_count()).all(|cable| self.model.course(cable, pose).is_ok())
    }
}
