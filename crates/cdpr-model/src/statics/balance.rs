//! Balance of cable tensions and load, Aᵀ f + w = 0, solved for the load or for controlled lengths.

use nalgebra::{DMatrix, DVector};

use super::error::{StaticsError, check_tensions};
use super::{Load, cable_lengths, section_wrench};
use crate::geometry::{Pose, Wrench};
use crate::model::Model;

/// Tensions split into two parts with their sum (eq. 2.38–2.40).
#[derive(Clone, Debug, PartialEq)]
pub struct TensionSplit {
    /// f_int = H λ: the part that tightens the cables against each other without a wrench, Aᵀ f_int = 0 (N).
    pub internal: Vec<f64>,
    /// f_ext = A⁺ᵀ Aᵀ f: the part that carries the load, the tensions of minimum norm with the wrench of f (N). Entries
    /// may be negative: only the sum of both parts is a tension.
    pub external: Vec<f64>,
    /// Rank of the structure matrix; the internal part has m − rank dimensions.
    pub rank: usize,
}

/// The constant external wrench that these tensions balance, w = −Aᵀ f (world axes, moment about the platform origin;
/// N, N·m).
///
/// For measured tensions this is the load estimation of Miermeister 2021, eq. 6.22 and 6.23. Components outside the
/// motion pattern are zero: out of the plane, and the moment on a point platform.
pub fn balanced_wrench(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<Wrench, StaticsError> {
    let all: Vec<usize> = (0..model.cable_count()).collect();
    Ok(-section_wrench(model, pose, tensions, &all)?)
}

/// Residual wrench Aᵀ f + w in the n degrees of freedom of the model (N, N·m): zero if the tensions balance the load.
/// The platform starts to move in its direction.
pub fn wrench_residual(
    model: &Model,
    pose: &Pose,
    tensions: &[f64],
    load: &Load,
) -> Result<DVector<f64>, StaticsError> {
    let missing = load.wrench(pose) - balanced_wrench(model, pose, tensions)?;
    Ok(DVector::from_iterator(model.dof(), model.twist_basis().iter().map(|twist| twist.dot(&missing))))
}

/// The internal and the external part of tensions at a pose (eq. 2.40).
///
/// With full rank n the external part is A (AᵀA)⁻¹ Aᵀ f (eq. 2.39). If Aᵀ has lower rank, AᵀA has no inverse, but the
/// projector onto the row space of Aᵀ exists and is used: the external part then has the minimum norm among the
/// tensions with the same wrench. A row counts as dependent if less than 10·max(n, m)·ε of the longest row remains
/// after subtracting the others (moment rows divided by the platform radius, so that all are without unit): that is
/// rounding of the matrix. Scaling rows does not change the row space, so that the radius matters only for the rank.
pub fn split(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<TensionSplit, StaticsError> {
    check_tensions(model, tensions)?;
    let mut matrix = model.structure_matrix(pose)?;
    for row in model.robot().motion_pattern.translations()..model.dof() {
        matrix.row_mut(row).scale_mut(1.0 / model.platform_radius());
    }
    let basis = column_space(matrix.transpose());
    let f = DVector::from_column_slice(tensions);
    let external = &basis * basis.tr_mul(&f);
    let internal = &f - &external;
    Ok(TensionSplit {
        internal: internal.as_slice().to_vec(),
        external: external.as_slice().to_vec(),
        rank: basis.ncols(),
    })
}

/// Orthonormal columns that span the columns of a matrix: modified Gram–Schmidt with pivoting. Ends after n steps for
/// any numbers.
fn column_space(mut matrix: DMatrix<f64>) -> DMatrix<f64> {
    let (rows, columns) = matrix.shape();
    let longest = |matrix: &DMatrix<f64>, from: usize| {
        (from..columns).map(|column| (column, matrix.column(column).norm())).max_by(|a, b| a.1.total_cmp(&b.1))
    };
    let reference = longest(&matrix, 0).map_or(0.0, |(_, norm)| norm);
    let tolerance = 10.0 * rows.max(columns) as f64 * f64::EPSILON * reference;
    let mut rank = 0;
    while let Some((pivot, norm)) = longest(&matrix, rank)
        && norm > tolerance
    {
        matrix.swap_columns(rank, pivot);
        // a second time, since the first removal leaves rounding that is large beside a short column
        (0..rank).for_each(|unit| remove_share(&mut matrix, rank, unit));
        let norm = matrix.column(rank).norm();
        matrix.column_mut(rank).scale_mut(1.0 / norm);
        (rank + 1..columns).for_each(|column| remove_share(&mut matrix, column, rank));
        rank += 1;
    }
    matrix.columns(0, rank).into_owned()
}

/// Subtracts from a column its projection on a unit column.
fn remove_share(matrix: &mut DMatrix<f64>, column: usize, unit: usize) {
    let unit = matrix.column(unit).into_owned();
    let fraction = matrix.column(column).dot(&unit);
    matrix.column_mut(column).axpy(-fraction, &unit, 1.0);
}

/// Controlled lengths q_θ with which the cables have these tensions at this pose (m): the exact inverse of the elastic
/// law (eq. 2.37, 2.41); the geometric lengths for a model that does not stretch.
///
/// The tensions need not balance a load (see [`wrench_residual`]).
pub fn controlled_lengths(model: &Model, pose: &Pose, tensions: &[f64]) -> Result<Vec<f64>, StaticsError> {
    check_tensions(model, tensions)?;
    let rotation = pose.rotation_rows();
    let length = |(index, &tension): (usize, &f64)| {
        let (path, _) = model.checked_path(index, pose.position.into(), &rotation)?;
        match model.law(index).closed_length(path.length, tension) {
            Some(length) if length > 0.0 => Ok(length),
            _ => cable_lengths(model, pose, &rotation, index, tension, None).map(|lengths| lengths.controlled_length),
        }
    };
    tensions.iter().enumerate().map(length).collect()
}
