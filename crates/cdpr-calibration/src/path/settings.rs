//! Questions to a path.

use std::fmt;

use crate::selection::SelectionCriterion;
use cdpr_model::model::FreeParameters;
use cdpr_model::reading::{Keyword, keywords};

/// Penalty on changes u of parameters in metres of cable, beside ½χ².
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Penalty {
    /// ½ λ Σ u²: a prior with σ = 1/√λ.
    Ridge,
    /// λ Σ |u|.
    #[default]
    Lasso,
    /// λ Σ √n ‖u‖ over the n numbers of a kind at a cable.
    GroupLasso,
}

/// Centre of a penalty.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub enum Towards {
    /// Values of the robot as given.
    #[default]
    File,
    /// 0.
    Zero,
}

keywords!(Penalty: Ridge = "ridge", Lasso = "lasso", GroupLasso = "group-lasso");

keywords!(Towards: File = "file", Zero = "zero");

impl fmt::Display for Penalty {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.name())
    }
}

/// Questions to a path.
#[derive(Clone, Debug, PartialEq)]
pub struct PathSettings {
    /// Penalty.
    pub penalty: Penalty,
    /// Its centre.
    pub towards: Towards,
    /// Free parameters that it acts on; all of them where none is named.
    pub shrink: FreeParameters,
    /// Number of penalties above 0.
    pub points: usize,
    /// Error that cross-validation compares.
    pub criterion: SelectionCriterion,
}

impl Default for PathSettings {
    fn default() -> Self {
        Self {
            penalty: Penalty::default(),
            towards: Towards::default(),
            shrink: FreeParameters::default(),
            points: 50,
            criterion: SelectionCriterion::default(),
        }
    }
}
