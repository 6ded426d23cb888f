//! Length residuals cable by cable, without what the geometry of a robot can take up of them.

use nalgebra::{DMatrix, DVector};

use super::examined::Examined;
use crate::evaluation::evaluate_fitted;
use cdpr_model::measurement::Samples;

/// Most rows that are searched; of more, so many are taken evenly.
const MOST: usize = 400;
/// Residuals beyond so many robust deviations of their cable count as those there: one wild row is no step.
const CLIPPED: f64 = 8.0;
/// A column that keeps less than this of its length beside the others says nothing of its own.
const DEPENDENT: f64 = 1e-6;

/// Residuals of the recorded lengths at the measured poses.
pub(super) struct ResidualTable {
    /// Index of every row in the samples.
    pub(super) rows: Vec<usize>,
    pub(super) cables: Vec<CableResiduals>,
    /// Number of residuals less those that the geometry takes up.
    pub(super) freedom: f64,
    /// Sum of the squares of all residuals (m²).
    pub(super) squares: f64,
}

/// Residuals of one cable.
pub(super) struct CableResiduals {
    /// Recorded minus modelled lengths without what the columns take up (m).
    pub(super) residuals: DVector<f64>,
    /// The same with those far beyond the others as they are (m).
    pub(super) unclipped: DVector<f64>,
    /// Orthonormal columns of what anchors, offset, scale and compliance of the cable can take up.
    basis: DMatrix<f64>,
    /// Directions of the cable (world, unit) and the places where it pulls, relative to the platform's origin (world, m).
    pub(super) directions: Vec<nalgebra::Vector3<f64>>,
    pub(super) arms: Vec<nalgebra::Vector3<f64>>,
    /// Modelled lengths (m).
    pub(super) lengths: Vec<f64>,
    pub(super) squares: f64,
    pub(super) freedom: f64,
}

impl ResidualTable {
    /// `None` where too few rows have residuals, or these are rounding.
    pub(super) fn of(examined: &Examined<'_>) -> Option<Self> {
        let fit = examined.richest;
        let samples = fit.as_fitted(examined.samples);
        let errors = evaluate_fitted(&fit.model, &samples).ok()?;
        let m = samples.cable_count;
        let is_known = |row: &usize| errors.length[row * m..][..m].iter().all(|error| error.is_finite());
        let all: Vec<usize> = (0..samples.len()).filter(is_known).collect();
        let taken = all.len().min(MOST);
        let rows: Vec<usize> = (0..taken).map(|place| all[place * all.len() / taken]).collect();
        let cables: Vec<CableResiduals> = (0..m)
            .map(|cable| {
                CableResiduals::of(&Cable { examined, samples: &samples, rows: &rows, cable, errors: &errors.length })
            })
            .collect();
        let freedom: f64 = cables.iter().map(|cable| cable.freedom).sum();
        let squares = cables.iter().map(|cable| cable.squares).sum();
        let is_enough = rows.len() >= 20 && freedom >= 20.0 && cables.iter().all(|cable| cable.freedom >= 8.0);
        is_enough.then_some(Self { rows, cables, freedom, squares })
    }
}

/// One cable of samples.
struct Cable<'a> {
    examined: &'a Examined<'a>,
    samples: &'a Samples,
    rows: &'a [usize],
    cable: usize,
    errors: &'a [f64],
}

impl CableResiduals {
    fn of(asked: &Cable<'_>) -> Self {
        let Cable { examined, samples, rows, cable, errors } = *asked;
        let own = &examined.richest.model.robot().cables[cable];
        let m = samples.cable_count;
        let mut residuals = DVector::from_iterator(rows.len(), rows.iter().map(|row| -errors[row * m + cable]));
        let mut unclipped = residuals.clone();
        clip(&mut residuals);
        let (mut directions, mut arms, mut lengths) = (Vec::new(), Vec::new(), Vec::new());
        let mut columns: Vec<DVector<f64>> = vec![DVector::zeros(rows.len()); 9];
        for (place, &row) in rows.iter().enumerate() {
            let pose = &samples.poses[row];
            let arm = pose.rotation * own.platform_anchor;
            let line = own.frame_anchor - pose.position - arm;
            let direction = line.normalize();
            let in_platform = pose.rotation.inverse() * direction;
            let tension = samples.tensions.as_ref().map_or(0.0, |tensions| tensions[row * m + cable]);
            for axis in 0..3 {
                columns[axis][place] = direction[axis];
                columns[3 + axis][place] = in_platform[axis];
            }
            columns[6][place] = 1.0;
            columns[7][place] = line.norm();
            columns[8][place] = tension * line.norm();
            directions.push(direction);
            arms.push(arm);
            lengths.push(line.norm());
        }
        let basis = orthonormal(columns, rows.len());
        residuals -= &basis * basis.tr_mul(&residuals);
        unclipped -= &basis * basis.tr_mul(&unclipped);
        let squares = residuals.norm_squared();
        let freedom = (rows.len() - basis.ncols()) as f64;
        Self { residuals, unclipped, basis, directions, arms, lengths, squares, freedom }
    }

    /// A column without what the geometry takes up of it; `None` where nothing of its own is left.
    pub(super) fn own_part(&self, column: DVector<f64>) -> Option<DVector<f64>> {
        let before = column.norm();
        let left = &column - &self.basis * self.basis.tr_mul(&column);
        (left.norm() > 1e-3 * before && before > 0.0).then_some(left)
    }

    /// Direction in which the length last changed, 1 or −1; 0 before it does.
    pub(super) fn travel(&self) -> DVector<f64> {
        let mut last = 0.0;
        DVector::from_fn(self.lengths.len(), |row, _| {
            let step = if row == 0 { 0.0 } else { self.lengths[row] - self.lengths[row - 1] };
            if step != 0.0 {
                last = step.signum();
            }
            last
        })
    }

    /// Place of a length inside a dead band of a half width (m): 1 at the end of paying out, −1 at that of winding.
    pub(super) fn behind(&self, half: f64) -> DVector<f64> {
        let mut recorded = self.lengths.first().copied().unwrap_or(0.0);
        DVector::from_fn(self.lengths.len(), |row, _| {
            let length = self.lengths[row];
            recorded = recorded.clamp(length - half, length + half);
            (length - recorded) / half
        })
    }

    /// Root mean square of the residuals (m).
    pub(super) fn rms(&self) -> f64 {
        (self.squares / self.freedom).sqrt()
    }
}

/// Orthonormal columns of the same space, without dependent ones.
fn orthonormal(columns: Vec<DVector<f64>>, rows: usize) -> DMatrix<f64> {
    let mut kept: Vec<DVector<f64>> = Vec::new();
    for column in columns {
        let before = column.norm();
        let mut left = column;
        for _ in 0..2 {
            for other in &kept {
                let part = other.dot(&left);
                left.axpy(-part, other, 1.0);
            }
        }
        let after = left.norm();
        if after > DEPENDENT * before && after > 0.0 && kept.len() + 1 < rows {
            kept.push(left / after);
        }
    }
    if kept.is_empty() { DMatrix::zeros(rows, 0) } else { DMatrix::from_columns(&kept) }
}

/// Brings residuals far beyond the others of a cable to the rim of these.
fn clip(residuals: &mut DVector<f64>) {
    let middle = median(residuals.iter().copied());
    let deviation = 1.4826 * median(residuals.iter().map(|value| (value - middle).abs()));
    if deviation > 0.0 {
        let limit = CLIPPED * deviation;
        residuals.iter_mut().for_each(|value| *value = value.clamp(middle - limit, middle + limit));
    }
}

/// The median; 0 of nothing.
pub(super) fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}
