//! Stiffness of the platform at the tensions that hold the load.

use nalgebra::DMatrix;

use super::cables::{length_scale, mainly, not_negative};
use super::wrench_feasible::cable_of;
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use cdpr_model::equilibrium::distribution;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::scalar::decomposition::symmetric_eigen;
use cdpr_model::statics::{self, Load};
use cdpr_model::tension::{InputError, Limits};

/// The smallest eigenvalue of the symmetric part of the stiffness K_wx (eq. 2.74, see [`statics::Stiffness`]) is at
/// least the required one (N/m), so that the platform resists any displacement with that stiffness. A turn is measured
/// by the path of a point at the length scale.
///
/// Tensions are those nearest to the middle of their limits that balance the load. The margin (N/m) is the eigenvalue's
/// excess; −∞ if no tensions within limits hold the load, and the reason then says so.
#[derive(Clone, Debug)]
pub(crate) struct MinimumStiffness<'a> {
    held: HeldPlatform<'a>,
    least: f64,
    length_scale: f64,
}

const NAME: &str = "stiffness";

impl<'a> MinimumStiffness<'a> {
    /// The criterion for the least stiffness (N/m); the length scale (m) is the platform radius if none is given.
    pub(crate) fn new(
        model: &'a Model,
        load: &Load,
        limits: &Limits,
        least: f64,
        scale: Option<f64>,
    ) -> Result<Self, WorkspaceError> {
        let least = not_negative(NAME, "least stiffness", least, "it is a finite number of 0 or more (N/m)")?;
        let length_scale = length_scale(model, NAME, scale)?;
        Ok(Self { held: HeldPlatform::new(model, load, limits, NAME)?, least, length_scale })
    }
}

impl Criterion for MinimumStiffness<'_> {
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
        let Softest { eigenvalue, direction } = match self.held.softest(&stiffness, self.length_scale) {
            Some(softest) => softest,
            None => return Verdict::impossible("the stiffness is not finite", None),
        };
        let margin = eigenvalue - self.least;
        if margin >= 0.0 {
            return Verdict::held(margin, None);
        }
        let (least, length) = (self.least, self.length_scale);
        let words = format!(
            "the platform is too soft, mainly {direction}: {eigenvalue:.4e} N/m, at least {least} N/m are asked for (turns \
             counted at {length:.4} m)"
        );
        Verdict::failed(margin, words, None)
    }
}

/// A platform on elastic cables whose tensions hold a load.
#[derive(Clone, Debug)]
pub(super) struct HeldPlatform<'a> {
    pub(super) model: &'a Model,
    load: Load,
    limits: Limits,
}

/// The direction in which a platform is softest.
pub(super) struct Softest {
    /// Smallest eigenvalue of the symmetric part (N/m).
    pub(super) eigenvalue: f64,
    /// The degree of freedom with the largest component.
    pub(super) direction: String,
}

impl<'a> HeldPlatform<'a> {
    pub(super) fn new(
        model: &'a Model,
        load: &Load,
        limits: &Limits,
        criterion: &'static str,
    ) -> Result<Self, WorkspaceError> {
        let (expected, found) = (model.cable_count(), limits.cable_count());
        if expected != found {
            return Err(InputError::LimitCount { expected, found }.into());
        }
        let composition = model.composition();
        if !composition.is_elastic() {
            let cure = "rigid cables have no finite stiffness; `axial_stiffness_EA_N` at every cable is enough for it"
                .to_owned();
            return Err(WorkspaceError::MissingEffect { criterion, effect: "elastic", cure });
        }
        let is_rigid = |cable: &usize| model.law(*cable).is_inextensible_line();
        if let Some(cable) = (0..expected).find(is_rigid) {
            return Err(WorkspaceError::MissingKey {
                criterion,
                robot: model.robot().name.clone(),
                key: format!("`axial_stiffness_EA_N` of {}", super::cables::named(model.robot(), cable)),
                cure: "a cable of compliance 0 has no finite stiffness".to_owned(),
            });
        }
        Ok(Self { model, load: *load, limits: limits.clone() })
    }

    /// Effort of a pose, see [`Criterion::effort`].
    pub(super) fn effort(&self) -> f64 {
        distribution::effort(self.model, 100.0)
    }

    /// The stiffness at the tensions that hold the load, or the verdict that there are none.
    pub(super) fn stiffness(&self, pose: &Pose) -> Result<statics::Stiffness, Verdict> {
        let found = distribution::solve(self.model, pose, &self.load, &self.limits)
            .map_err(|error| Verdict::impossible(error.to_string(), cable_of(&error)))?;
        if let Some(reason) = &found.reason {
            return Err(Verdict::impossible(format!("no tensions hold the load: {reason}"), None));
        }
        statics::Stiffness::at(self.model, pose, &found.tensions, &self.load)
            .map_err(|error| Verdict::impossible(error.to_string(), None))
    }

    /// The least eigenvalue of the symmetric part of K_wx for \[δr; ρ δφ\]; `None` if numbers overflow.
    pub(super) fn softest(&self, stiffness: &statics::Stiffness, length_scale: f64) -> Option<Softest> {
        let translations = self.model.robot().motion_pattern.translations();
        let scale = |row: usize| if row < translations { 1.0 } else { 1.0 / length_scale };
        let system = &stiffness.system;
        let symmetric = DMatrix::from_fn(system.nrows(), system.ncols(), |i, j| {
            0.5 * (system[(i, j)] + system[(j, i)]) * scale(i) * scale(j)
        });
        let eigen = symmetric_eigen(symmetric)?;
        let direction = mainly(self.model, eigen.eigenvectors.column(eigen.eigenvalues.imin()).iter().copied());
        Some(Softest { eigenvalue: eigen.eigenvalues.min(), direction })
    }
}
