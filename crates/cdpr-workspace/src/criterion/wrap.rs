//! Wrap angles within limits.

use super::cables::{limits, named, paths};
use super::lengths::nearest_limit;
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::Cable;

/// Every wrap angle β on a pulley keeps β_min ≤ β ≤ β_max (`pulley_wrap_min_rad`, `pulley_wrap_max_rad`).
///
/// The margin (rad) is the least distance of an angle from its limits.
#[derive(Clone, Debug)]
pub(crate) struct WrapLimits<'a> {
    model: &'a Model,
    limits: Vec<[f64; 2]>,
}

const NAME: &str = "pulley-wrap";

impl<'a> WrapLimits<'a> {
    /// The criterion with these limits for all cables (rad), or else those of the robot's file; for a model with
    /// pulleys.
    ///
    /// A limit that is neither given nor in the file for any cable is absent; one of both is required.
    pub(crate) fn new(model: &'a Model, minimum: Option<f64>, maximum: Option<f64>) -> Result<Self, WorkspaceError> {
        if !model.composition().pulley {
            return Err(WorkspaceError::MissingEffect {
                criterion: NAME,
                effect: "pulley",
                cure: "in the model without it cables leave at points".to_owned(),
            });
        }
        let keys = ["pulley_wrap_min_rad", "pulley_wrap_max_rad"];
        let of = [|cable: &Cable| cable.pulley_wrap_min, |cable: &Cable| cable.pulley_wrap_max];
        Ok(Self { model, limits: limits(model.robot(), NAME, keys, [minimum, maximum], of)? })
    }
}

impl Criterion for WrapLimits<'_> {
    fn name(&self) -> &str {
        NAME
    }

    fn unit(&self) -> &str {
        "rad"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let angles = match paths(self.model, pose) {
            Ok(paths) => paths.into_iter().map(|(path, _)| path.wrap_angle),
            Err(verdict) => return verdict,
        };
        nearest_limit(angles, &self.limits, |cable, angle, limit| {
            let (name, side) = (named(self.model.robot(), cable), if angle > limit { "at most" } else { "at least" });
            let (angle, limit) = (angle.to_degrees(), limit.to_degrees());
            format!("{name} would lie on its pulley over {angle:.2}°, it may do so over {side} {limit:.2}°")
        })
    }
}
