//! Existence of the model's answer at a pose.

use nalgebra::Vector3;

use super::cables::named;
use super::{Criterion, Verdict};
use cdpr_model::cable::outlet::Outlet;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;

/// Every cable has a path at the pose: no platform anchor lies on its outlet, inside its pulley, on the pulley's swivel
/// axis, or on the open side of a pulley that does not swivel.
///
/// The margin (m) is the least distance of a platform anchor from the points at which its cable has no path: the
/// outlet, or the pulley's circle and swivel axis. Inside the pulley it is minus the depth; on outlet or axis it is
/// zero and fails.
#[derive(Clone, Debug)]
pub(crate) struct ModelValidity<'a> {
    model: &'a Model,
}

impl<'a> ModelValidity<'a> {
    /// The criterion for any model.
    pub(crate) fn new(model: &'a Model) -> Self {
        Self { model }
    }

    /// Distance of a cable's platform anchor from the points at which it has no path (m).
    fn distance(&self, cable: usize, pose: &Pose) -> f64 {
        let outlet = &self.model.law(cable).outlet;
        let entry = Vector3::from(*outlet.frame_anchor());
        let d = pose.transform(&self.model.robot().cables[cable].platform_anchor) - entry;
        match *outlet {
            Outlet::Point { .. } => d.norm(),
            Outlet::Sided { swivel_axis, side, radius, .. } => {
                let (along, across) = (Vector3::from(swivel_axis).dot(&d), Vector3::from(side).dot(&d));
                let from_circle = (across - radius).hypot(along) - radius;
                // the open side is the quarter of the plane with across < 0 and along > 0
                let from_open_side = match across < 0.0 && along > 0.0 {
                    true => across.max(-along),
                    false => across.max(0.0).hypot(along.min(0.0)),
                };
                from_circle.min(from_open_side)
            }
            Outlet::Swivel { swivel_axis, radius, .. } => {
                let axis = Vector3::from(swivel_axis);
                let along = axis.dot(&d);
                let across = (d - axis * along).norm();
                let from_circle = (across - radius).hypot(along) - radius;
                if radius > 0.0 { from_circle.min(across) } else { d.norm() }
            }
        }
    }
}

impl Criterion for ModelValidity<'_> {
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
            if let (None, Err(error)) = (&reason, self.model.path(cable, pose)) {
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
        pose.is_finite() && (0..self.model.cable_count()).all(|cable| self.model.path(cable, pose).is_ok())
    }
}
