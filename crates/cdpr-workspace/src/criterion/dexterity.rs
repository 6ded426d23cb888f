//! Uniformity of the cables' action over all directions: condition and dexterity of the structure matrix.

use nalgebra::DMatrix;

use super::cables::{length_scale, mainly, not_negative};
use super::{Criterion, Verdict};
use crate::WorkspaceError;
use cdpr_model::cable::GeometryError;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::scalar::decomposition::svd;

/// Condition number above which a matrix is singular up to rounding.
const SINGULAR: f64 = 1e12;

/// The condition number κ = σ_max/σ_min of Aᵀ, moments divided by the length scale, is at most κ_max.
///
/// The margin is κ_max − κ. A matrix that has lost rank counts as κ = 10¹².
#[derive(Clone, Debug)]
pub(crate) struct JacobianConditioning<'a> {
    matrix: ScaledMatrix<'a>,
    largest: f64,
}

/// The dexterity 1/κ of Aᵀ (Gosselin, Angeles 1991: the local conditioning index), moments divided by the length scale,
/// is at least the required one.
///
/// It is 1 if the cables act alike in all directions and 0 if no cable acts in some direction. The margin is its
/// excess.
#[derive(Clone, Debug)]
pub(crate) struct Dexterity<'a> {
    matrix: ScaledMatrix<'a>,
    least: f64,
}

/// The structure matrix with moments divided by a length (m).
#[derive(Clone, Debug)]
struct ScaledMatrix<'a> {
    model: &'a Model,
    length_scale: f64,
}

/// Singular values of a structure matrix, and the direction in which the cables act least.
struct Conditioning {
    /// σ_min/σ_max.
    inverse: f64,
    /// The degree of freedom with the largest component of the weakest wrench.
    weakest: String,
}

impl ScaledMatrix<'_> {
    fn conditioning(&self, pose: &Pose) -> Result<Conditioning, Verdict> {
        let refused = |error: GeometryError| Verdict::impossible(error.to_string(), Some(error.cable() - 1));
        let mut matrix: DMatrix<f64> = self.model.structure_matrix(pose).map_err(refused)?;
        for row in self.model.robot().motion_pattern.translations()..matrix.nrows() {
            matrix.row_mut(row).scale_mut(1.0 / self.length_scale);
        }
        // with fewer cables than rows, the missing singular values are zero
        let gap = matrix.nrows().saturating_sub(matrix.ncols());
        let columns = matrix.ncols();
        let full = matrix.resize_horizontally(columns + gap, 0.0);
        let Some((values, left)) = svd(full, true, false).and_then(|found| Some((found.singular_values, found.u?)))
        else {
            return Err(Verdict::impossible("the structure matrix is not finite", None));
        };
        let weakest = mainly(self.model, left.column(values.imin()).iter().copied());
        let (least, largest) = (values.min(), values.max());
        Ok(Conditioning { inverse: if largest > 0.0 { least / largest } else { 0.0 }, weakest })
    }
}

impl<'a> JacobianConditioning<'a> {
    /// The criterion for the largest condition number allowed, 1 or more; the length scale (m) is the platform radius
    /// if `scale` is not given.
    pub(crate) fn new(model: &'a Model, largest: f64, scale: Option<f64>) -> Result<Self, WorkspaceError> {
        if !(largest >= 1.0 && largest.is_finite()) {
            let (setting, wanted) = ("largest condition number", "it is a finite number of 1 or more");
            return Err(WorkspaceError::Setting { criterion: "condition", setting, value: largest, wanted });
        }
        let length_scale = length_scale(model, "condition", scale)?;
        Ok(Self { matrix: ScaledMatrix { model, length_scale }, largest })
    }
}

impl<'a> Dexterity<'a> {
    /// The criterion for the least dexterity allowed, 0 to 1; the length scale (m) is the platform radius if none is
    /// given.
    pub(crate) fn new(model: &'a Model, least: f64, scale: Option<f64>) -> Result<Self, WorkspaceError> {
        let wanted = "it is a number from 0 to 1";
        not_negative("dexterity", "least dexterity", least, wanted)?;
        not_negative("dexterity", "least dexterity", 1.0 - least, wanted)?;
        let length_scale = length_scale(model, "dexterity", scale)?;
        Ok(Self { matrix: ScaledMatrix { model, length_scale }, least })
    }
}

impl Criterion for JacobianConditioning<'_> {
    fn name(&self) -> &str {
        "condition"
    }

    fn unit(&self) -> &str {
        "1"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let Conditioning { inverse, weakest } = match self.matrix.conditioning(pose) {
            Ok(conditioning) => conditioning,
            Err(verdict) => return verdict,
        };
        let condition = (1.0 / inverse).min(SINGULAR);
        let margin = self.largest - condition;
        if margin >= 0.0 {
            return Verdict::held(margin, None);
        }
        let (largest, length) = (self.largest, self.matrix.length_scale);
        let words = format!(
            "the structure matrix has the condition number {condition:.4}, at most {largest} is allowed (moments divided by \
             {length:.4} m); the cables act least {weakest}"
        );
        Verdict::failed(margin, words, None)
    }
}

impl Criterion for Dexterity<'_> {
    fn name(&self) -> &str {
        "dexterity"
    }

    fn unit(&self) -> &str {
        "1"
    }

    fn judge(&self, pose: &Pose) -> Verdict {
        let Conditioning { inverse, weakest } = match self.matrix.conditioning(pose) {
            Ok(conditioning) => conditioning,
            Err(verdict) => return verdict,
        };
        let margin = inverse - self.least;
        if margin >= 0.0 {
            return Verdict::held(margin, None);
        }
        let (least, length) = (self.least, self.matrix.length_scale);
        let words = format!(
            "the dexterity is {inverse:.4}, at least {least} is asked for (moments divided by {length:.4} m); the cables act least \
             {weakest}"
        );
        Verdict::failed(margin, words, None)
    }
}
