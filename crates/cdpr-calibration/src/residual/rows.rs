//! Residuals of samples with their derivatives: what every loss of an objective is made of, and how analyses and frames take them.

use std::ops::Range;

use nalgebra::{DMatrix, DVector};

use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::scalar::TriangularFactor;

/// Number of the rows of all samples, and of what is eliminated from them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Layout {
    /// Number of samples.
    pub(crate) samples: usize,
    /// Rows of one sample.
    pub(crate) size: usize,
    /// Unknowns of all samples that are eliminated from their rows.
    pub(crate) unknowns: usize,
    /// Rows of data.
    pub(crate) data: usize,
    /// Rows behind them that fix by convention what no data tell: as many directions of the parameters.
    pub(crate) conventions: usize,
}

impl Layout {
    /// Of samples from which nothing is eliminated.
    pub(crate) fn of(samples: usize, size: usize) -> Self {
        Self { samples, size, unknowns: 0, data: samples * size, conventions: 0 }
    }

    /// The same with so many unknowns.
    pub(crate) fn eliminating(self, unknowns: usize) -> Self {
        Self { unknowns, ..self }
    }

    /// Rows of all samples.
    pub(crate) fn rows(&self) -> usize {
        self.samples * self.size
    }

    /// Rows that no unknown of a sample explains.
    pub(crate) fn free_rows(&self) -> usize {
        self.rows().saturating_sub(self.unknowns)
    }
}

/// Residuals of all samples, one sample after the other, and their derivatives by the free parameters.
#[derive(Debug)]
pub(crate) struct Rows {
    pub(crate) layout: Layout,
    pub(crate) residuals: DVector<f64>,
    /// A row for each residual, a column for each parameter.
    pub(crate) jacobian: DMatrix<f64>,
}

/// A sample without residuals.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Missing {
    /// From 0.
    pub(crate) sample: usize,
    pub(crate) reason: String,
}

impl Clone for Rows {
    fn clone(&self) -> Self {
        Self { residuals: self.residuals.clone(), jacobian: self.jacobian.clone(), ..*self }
    }

    fn clone_from(&mut self, other: &Self) {
        self.layout = other.layout;
        self.residuals.copy_from(&other.residuals);
        self.jacobian.copy_from(&other.jacobian);
    }
}

impl Rows {
    /// Room for the rows of so many parameters.
    pub(crate) fn new(layout: Layout, parameters: usize) -> Self {
        let rows = layout.rows();
        Self { layout, residuals: DVector::zeros(rows), jacobian: DMatrix::zeros(rows, parameters) }
    }

    /// Number of samples.
    pub(crate) fn samples(&self) -> usize {
        self.layout.samples
    }

    /// Rows of one sample.
    pub(crate) fn size(&self) -> usize {
        self.layout.size
    }

    /// ‖r‖² of a sample.
    pub(crate) fn square(&self, sample: usize) -> f64 {
        self.residuals.rows(sample * self.size(), self.size()).norm_squared()
    }

    /// ‖r‖² of every sample.
    pub(crate) fn squares(&self) -> Vec<f64> {
        (0..self.samples()).map(|sample| self.square(sample)).collect()
    }

    /// Jᵀ r of a sample: half the derivative of its square.
    pub(crate) fn gradient(&self, sample: usize) -> DVector<f64> {
        let rows = self.jacobian.rows(sample * self.size(), self.size());
        rows.tr_mul(&self.residuals.rows(sample * self.size(), self.size()))
    }

    /// Residuals of every row of a sample over the samples.
    pub(crate) fn series(&self) -> Vec<Vec<f64>> {
        let of_row =
            |row: usize| (0..self.samples()).map(|sample| self.residuals[sample * self.size() + row]).collect();
        (0..self.size()).map(of_row).collect()
    }

    /// Multiplies residuals and derivatives of a sample.
    pub(crate) fn scale(&mut self, sample: usize, factor: f64) {
        let size = self.size();
        self.residuals.rows_mut(sample * size, size).scale_mut(factor);
        self.jacobian.rows_mut(sample * size, size).scale_mut(factor);
    }

    /// Writes the rows of a sample that is left out: it says nothing.
    pub(crate) fn leave_out(&mut self, sample: usize) {
        let size = self.size();
        self.residuals.rows_mut(sample * size, size).fill(0.0);
        self.jacobian.rows_mut(sample * size, size).fill(0.0);
    }

    /// True where every number is one.
    pub(crate) fn is_finite(&self) -> bool {
        // without an early end, several numbers at once
        let are_finite = |numbers: &[f64]| numbers.iter().fold(true, |all, number| all & number.is_finite());
        are_finite(self.residuals.as_slice()) && are_finite(self.jacobian.as_slice())
    }
}

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
    /// The same row by row, sample by sample.
    pub(crate) weighted_rows: DMatrix<f64>,
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
            weighted_rows: rows.jacobian.clone(),
            series: rows.series(),
        }
    }
}

/// Whitened rows that share parameters.
pub(crate) struct RowBlock {
    /// Places of the parameters in the list of all.
    pub(crate) parameters: Vec<usize>,
    /// Rows by these parameters.
    pub(crate) by_parameters: DMatrix<f64>,
    /// Rows by the motion of the platform along the degrees of freedom of the pattern.
    pub(crate) by_pose: DMatrix<f64>,
    pub(crate) residuals: DVector<f64>,
    /// Rows of one sample, which follow each other.
    pub(crate) rows_of_sample: usize,
    /// Poses at which the rows hold: the measured ones, or where the model and they agree best.
    pub(crate) poses: Vec<Pose>,
    /// Wrenches among the rows.
    pub(crate) wrenches: Option<Wrenches>,
}

/// Wrenches that the rows of a sample balance, for the part of a row's change that only its axes make: a motion of everything together turns them,
/// or moves the point that they are about, and changes no balance.
pub(crate) struct Wrenches {
    /// Imbalance of each sample (world, about the platform's origin).
    pub(crate) residuals: Vec<Wrench>,
    /// Whitened rows by wrenches along the degrees of freedom of the pattern.
    pub(crate) whitened: DMatrix<f64>,
}
