//! Static stability of the equilibrium.

use super::cables::length_scale;
use super::stiffness::{HeldPlatform, Softest};
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::{Load, Stability};
use cdpr_model::tension::Limits;

/// Every small displacement at fixed controlled lengths is driven back: all eigenvalues of the symmetric part of
/// K_wx = K_C − K_G − ∂w/∂x exceed the stiffness that counts as zero.
///
/// A weight above its suspension, or tensions that tip over a moment arm, can make it fail at any stiffness of the
/// cables. The margin (N/m) is the smallest eigenvalue, with a turn measured by the path of a point at the length
/// scale; its sign does not depend on that length. −∞ if no tensions within limits hold the load.
#[derive(Clone, Debug)]
pub(crate) struct StaticStability<'a> {
    held: HeldPlatform<'a>,
    length_scale: f64,
}

const NAME: &str = "stability";

impl<'a> StaticStability<'a> {
    /// The criterion for elastic cables; the length scale (m) is the platform radius if none is given.
    pub(crate) fn new(
        model: &'a Model,
        load: &Load,
        limits: &Limits,
        scale: Option<f64>,
    ) -> Result<Self, WorkspaceError> {
        let length_scale = length_scale(model, NAME, scale)?;
        Ok(Self { held: HeldPlatform::new(model, load, limits, NAME)?, length_scale })
    }
}

impl Criterion for StaticStability<'_> {
    fn name(&self) -> &str {
        NAME
    }

    fn unit(&self) -> &str {
        "N/m"
    }

    fn effort(&self) -> f64 {
        self.held.effort()
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let stiffness = match self.held.stiffness(pose) {
            Ok(stiffness) => stiffness,
            Err(verdict) => return verdict,
        };
        let Some(Softest { eigenvalue, direction }) = self.held.softest(&stiffness, self.length_scale) else {
            return Verdict::impossible("the stiffness is not finite", None);
        };
        match Stability::of(eigenvalue, stiffness.indifferent_stiffness) {
            Stability::Stable => Verdict::held(eigenvalue, None),
            Stability::Indifferent | Stability::Unstable => {
                let words = format!(
                    "the platform is not driven back from a displacement mainly {direction}: its stiffness there is \
                     {eigenvalue:.4e} N/m"
                );
                Verdict::failed(eigenvalue, words, None)
            }
        }
    }
}
