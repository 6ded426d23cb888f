//! Derivatives at a pose, and how they were taken.

use nalgebra::{DMatrix, DVector};

use super::kink::Kink;

/// Derivatives by every cause, a column each.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivatives {
    /// Displacement of the emerging pose in the pattern's degrees of freedom, translations first (m, rad; world axes), per unit
    /// of the cause.
    pub pose: DMatrix<f64>,
    /// Change of the tensions (N); `None` for a rigid machine.
    pub tensions: Option<DMatrix<f64>>,
    /// Way in which they were taken.
    pub differentiation: Differentiation,
}

/// Way in which derivatives are taken.
#[derive(Clone, Debug, PartialEq)]
pub enum Differentiation {
    /// By the implicit function theorem, along the whole path of cables that remember.
    Exact,
    /// By central differences of the exact forward problem, along the path with every number deviating.
    Differences {
        /// Largest error that a component of each column of [`Derivatives::pose`] may have (its units).
        errors: DVector<f64>,
        /// Reason why no derivative leads to the pose.
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

    /// Angle that the platform turns per unit of a cause (rad); 0 for patterns without turns.
    pub(crate) fn rotation(&self, translations: usize, cause: usize) -> f64 {
        self.pose.column(cause).rows(translations, self.pose.nrows() - translations).norm()
    }
}
