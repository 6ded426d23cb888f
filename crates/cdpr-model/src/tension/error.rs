//! Input that no method of tension distribution can accept.

use nalgebra::DMatrix;
use thiserror::Error;

use super::Limits;

/// Sizes that do not fit together, or numbers that cannot be calculated with.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InputError {
    /// The structure matrix has another shape than the solver.
    #[error("expected a structure matrix of {expected_rows} × {expected_columns}, found {rows} × {columns}")]
    MatrixShape {
        /// Degrees of freedom n.
        expected_rows: usize,
        /// Number of cables m.
        expected_columns: usize,
        /// Rows given.
        rows: usize,
        /// Columns given.
        columns: usize,
    },
    /// A structure matrix without rows or columns.
    #[error("a structure matrix of {rows} × {columns} has nothing to balance, or nothing to balance with")]
    Empty {
        /// Degrees of freedom.
        rows: usize,
        /// Number of cables.
        columns: usize,
    },
    /// Not one wrench component per degree of freedom.
    #[error("expected {expected} wrench components, one per row of the structure matrix, found {found}")]
    WrenchLength {
        /// Rows of the structure matrix.
        expected: usize,
        /// Components given.
        found: usize,
    },
    /// Not one pair of limits per cable.
    #[error("expected tension limits of {expected} cables, one per column of the structure matrix, found {found}")]
    LimitCount {
        /// Columns of the structure matrix.
        expected: usize,
        /// Limits given.
        found: usize,
    },
    /// Not one reference tension per cable.
    #[error("expected {expected} reference tensions, one per cable, found {found}")]
    ReferenceLength {
        /// Number of cables.
        expected: usize,
        /// Tensions given.
        found: usize,
    },
    /// Not one answer per pose.
    #[error("expected room for {expected} answers, one per pose, found {found}")]
    AnswerCount {
        /// Number of poses.
        expected: usize,
        /// Room given.
        found: usize,
    },
    /// An option that is a list has a wrong length.
    #[error("expected {expected} {what}, found {found}")]
    OptionCount {
        /// Entries of the list, in words.
        what: &'static str,
        /// Entries expected.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// An option has a value outside its range.
    #[error("the {what} is {value}; it has to be {expected}")]
    OptionValue {
        /// Name of the option, with its unit.
        what: &'static str,
        /// The value given.
        value: f64,
        /// The values allowed, in words.
        expected: &'static str,
    },
    /// Rate limits, or a reference at the previous tensions, without previous tensions.
    #[error("rate limits, and a reference at the previous tensions, need the previous tensions")]
    NoPrevious,
    /// An input that is NaN, infinite, or so large that its square is.
    #[error("the {what} is not finite, or too large to calculate with")]
    NotFinite {
        /// Name of the input.
        what: &'static str,
    },
}

/// Checks that the matrix has the shape for which a solver's memory was claimed.
pub(super) fn check_shape(structure_matrix: &DMatrix<f64>, dof: usize, cable_count: usize) -> Result<(), InputError> {
    let (rows, columns) = structure_matrix.shape();
    if (rows, columns) == (dof, cable_count) {
        return Ok(());
    }
    Err(InputError::MatrixShape { expected_rows: dof, expected_columns: cable_count, rows, columns })
}

/// Checks sizes only; numbers are checked where they are read.
pub(super) fn check_sizes(
    structure_matrix: &DMatrix<f64>,
    wrench: &[f64],
    limits: &Limits,
    reference: Option<&[f64]>,
) -> Result<(), InputError> {
    let (rows, columns) = structure_matrix.shape();
    if rows == 0 || columns == 0 {
        return Err(InputError::Empty { rows, columns });
    }
    if wrench.len() != rows {
        return Err(InputError::WrenchLength { expected: rows, found: wrench.len() });
    }
    if limits.cable_count() != columns {
        return Err(InputError::LimitCount { expected: columns, found: limits.cable_count() });
    }
    match reference {
        Some(reference) if reference.len() != columns => {
            Err(InputError::ReferenceLength { expected: columns, found: reference.len() })
        }
        _ => Ok(()),
    }
}
