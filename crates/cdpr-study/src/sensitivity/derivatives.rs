//! Derivatives at a pose, and their method.

use nalgebra::{DMatrix, DVector};

use super::kink::Kink;

/// Derivatives by every cause, a column each.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivatives {
    /// Displacement of the emerging pose in the pattern's degrees of freedom, translations first (m, rad; world axes),
    /// per unit of the cause.
    pub pose: DMatrix<f64>,
    /// Change of the tensions (N); `None` for a rigid machine.
    pub tensions: Option<DMatrix<f64>>,
    /// Method by which they were computed.
    pub differentiation: Differentiation,
}

/// Method by which derivatives are computed.
#[derive(Clone, Debug, PartialEq)]
pub enum Differentiation {
    /// By the implicit function theorem, along the whole path for cables with memory.
    Exact,
    /// By central differences of the exact forward problem along the path, for each number in turn.
    Differences {
        /// Largest error that a component of each column of [`Derivatives::pose`] may have (its units).
        errors: DVector<f64>,
        /// Reason for which no exact derivative leads to the pose.
        kink: Kink,
    },
}

impl Derivatives {
    /// Largest error that a component of each column of `pose` may have (its units); `None` for exact ones.
    pub(crate) fn errors(&self) -> Option<&DVector<f64>> {
        match &self.differentiation {
            Differentiation::Exact => None,
            Differentiation::Differences { errors, .. } => Some(errors),
        }
    }

    /// Distance that the platform origin moves per unit of a cause (m).
    pub(crate) fn position(&self, translations: usize, cause: usize) -> f64 {
        self.pose.column(cause).rows(0, translations).norm()
    }

    /// Angle that the platform turns per unit of a cause (rad); 0 for patterns without rotation.
    pub(crate) fn rotation(&self, translations: usize, cause: usize) -> f64 {
        self.pose.column(cause).rows(translations, self.pose.nrows() - translations).norm()
    }
}
