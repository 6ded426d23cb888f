//! Sets of positions that tests know in closed form.

use cdpr_model::geometry::Pose;
use cdpr_workspace::{Criterion, Verdict};
use nalgebra::Vector3;

/// A set of positions by its signed distance; cable 4 limits within.
pub(crate) struct Shape<F>(pub(crate) F);

impl<F: Fn(&Vector3<f64>) -> f64 + Sync> Criterion for Shape<F> {
    fn name(&self) -> &str {
        "shape"
    }

    fn unit(&self) -> &str {
        "m"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        match (self.0)(&pose.position) {
            margin if margin >= 0.0 => Verdict::held(margin, Some(3)),
            margin => Verdict::failed(margin, "outside", None),
        }
    }
}
