//! Rows at an optimum of parameters that they tie together, as an analysis takes them.

use std::ops::Range;

use super::rows::Rows;
use cdpr_model::scalar::TriangularFactor;

/// Rows of one block of parameters.
#[derive(Clone, Debug)]
pub(crate) struct GroupRows {
    /// Places of the parameters.
    pub(crate) parameters: Range<usize>,
    /// Cables that they belong to.
    pub(crate) cables: Range<usize>,
    /// Number of rows.
    pub(crate) count: usize,
    /// Jacobian of the data in SI units.
    pub(crate) plain: TriangularFactor,
    /// Directions that no data tell and a convention fixes: they are no part of condition and rank.
    pub(crate) conventions: usize,
    /// Jacobian in units of the rows' noise.
    pub(crate) weighted: TriangularFactor,
    /// Residuals in these units, one series over the samples for each row of a sample.
    pub(crate) series: Vec<Vec<f64>>,
}

impl GroupRows {
    /// All rows in one group, in units of so many metres.
    pub(crate) fn of(rows: &Rows, cables: usize, unit: Option<f64>) -> Self {
        Self {
            parameters: 0..rows.jacobian.ncols(),
            cables: 0..cables,
            count: rows.jacobian.nrows(),
            plain: TriangularFactor::of(&(rows.jacobian.rows(0, rows.layout.data) * unit.unwrap_or(1.0))),
            conventions: rows.layout.conventions,
            weighted: TriangularFactor::of(&rows.jacobian),
            series: rows.series(),
        }
    }
}
