//! Least squares of the law, by steps of Gauss and Newton, with what the data leave open.

use std::collections::BTreeMap;

use nalgebra::{DMatrix, DVector};

use super::law::Law;
use super::plateaus::Plateau;

/// Speeds and loads that differ by less than this share are the same: they do not tell parameters apart.
pub(super) const SAME: f64 = 0.05;

/// Singular values of the scaled design of the same speeds and loads below this share of the largest are none.
const RANK: f64 = 1e-7;

/// Share of a parameter in a direction that the data leave open, from which on it is open itself.
const OPEN: f64 = 1e-5;

/// Steps at most; a law without the Stribeck part and with given loads needs one.
const STEPS: usize = 60;

/// A law fitted to plateaus.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    pub(super) law: Law,
    pub(super) parameters: Vec<f64>,
    /// Covariance for errors of variance 1, of what the data determine.
    pub(super) covariance: DMatrix<f64>,
    /// Recorded minus fitted torques (N·m).
    pub(super) residuals: Vec<f64>,
    /// Directions in the parameters that the data leave open, as columns in scaled parameters.
    open: DMatrix<f64>,
    /// Scale of each parameter's column.
    scales: Vec<f64>,
    /// Number of combinations of parameters that are determined.
    pub(super) rank: usize,
}

impl Fit {
    /// Fits a law from a start.
    pub(super) fn of(law: Law, plateaus: &[&Plateau], start: Vec<f64>) -> Self {
        let mut parameters = start;
        let cells = cells(plateaus);
        let (mut residuals, mut design) = linear(law, plateaus, &parameters);
        for _ in 0..STEPS {
            let scales = scales(&design);
            let rank = open_directions(law, &cells, &parameters, &scales).1;
            let inverse = pseudo_inverse(&scaled(&design, &scales), rank);
            let step = inverse * &residuals;
            let mut share = 1.0;
            let before = residuals.norm_squared();
            let tried = loop {
                let moved: Vec<f64> = (0..law.count()).map(|k| parameters[k] + share * step[k] / scales[k]).collect();
                let (new_residuals, new_design) = linear(law, plateaus, &moved);
                if new_residuals.norm_squared() <= before || share < 1e-6 {
                    break (moved, new_residuals, new_design);
                }
                share *= 0.5;
            };
            let gain = before - tried.1.norm_squared();
            if gain < 0.0 {
                break;
            }
            (parameters, residuals, design) = tried;
            if gain <= 1e-14 * before {
                break;
            }
        }
        let scales = scales(&design);
        let (open, rank) = open_directions(law, &cells, &parameters, &scales);
        let inverse = pseudo_inverse(&scaled(&design, &scales), rank);
        let unscaled =
            DMatrix::from_fn(inverse.nrows(), inverse.ncols(), |row, column| inverse[(row, column)] / scales[row]);
        let covariance = &unscaled * unscaled.transpose();
        Self { law, parameters, covariance, residuals: residuals.as_slice().to_vec(), open, scales, rank }
    }

    /// Sum of squares (N²·m²).
    pub(super) fn squares(&self) -> f64 {
        self.residuals.iter().map(|residual| residual * residual).sum()
    }

    /// A column without what the law's own derivatives explain of it.
    pub(super) fn without(&self, plateaus: &[&Plateau], column: &[f64]) -> Vec<f64> {
        let (_, design) = linear(self.law, plateaus, &self.parameters);
        let column = DVector::from_column_slice(column);
        let explained = &design * (&self.covariance * (design.transpose() * &column));
        (column - explained).as_slice().to_vec()
    }

    /// Share of each plateau in its own fitted torque, 0 to 1.
    pub(super) fn leverages(&self, plateaus: &[&Plateau]) -> Vec<f64> {
        let (_, design) = linear(self.law, plateaus, &self.parameters);
        design.row_iter().map(|row| (row * &self.covariance * row.transpose())[0].clamp(0.0, 1.0)).collect()
    }

    /// Variance, for errors of variance 1, of a quantity with these derivatives; `None` if the data leave it open.
    pub(super) fn variance(&self, gradient: &[f64]) -> Option<f64> {
        let scaled = DVector::from_fn(gradient.len(), |row, _| gradient[row] / self.scales[row]);
        let along = self.open.transpose() * &scaled;
        if along.amax() > OPEN * scaled.amax().max(f64::MIN_POSITIVE) {
            return None;
        }
        let gradient = DVector::from_column_slice(gradient);
        Some((gradient.transpose() * &self.covariance * &gradient)[0].max(0.0))
    }
}

/// Residuals and derivatives of the law.
fn linear(law: Law, plateaus: &[&Plateau], parameters: &[f64]) -> (DVector<f64>, DMatrix<f64>) {
    let mut design = DMatrix::zeros(plateaus.len(), law.count());
    let mut residuals = DVector::zeros(plateaus.len());
    let mut gradient = vec![0.0; law.count()];
    for (row, plateau) in plateaus.iter().enumerate() {
        residuals[row] = plateau.torque - law.torque(plateau, parameters, &mut gradient);
        design.row_mut(row).iter_mut().zip(&gradient).for_each(|(out, own)| *out = *own);
    }
    (residuals, design)
}

/// Norms of columns; 1 for a column of zeros.
fn scales(design: &DMatrix<f64>) -> Vec<f64> {
    design.column_iter().map(|column| column.norm()).map(|norm| if norm > 0.0 { norm } else { 1.0 }).collect()
}

fn scaled(design: &DMatrix<f64>, scales: &[f64]) -> DMatrix<f64> {
    DMatrix::from_fn(design.nrows(), design.ncols(), |row, column| design[(row, column)] / scales[column])
}

/// Pseudo-inverse of the rank.
fn pseudo_inverse(design: &DMatrix<f64>, rank: usize) -> DMatrix<f64> {
    if design.nrows() == 0 {
        return DMatrix::zeros(design.ncols(), 0);
    }
    let svd = design.clone().svd(true, true);
    let (Some(left), Some(right)) = (svd.u, svd.v_t) else {
        return DMatrix::zeros(design.ncols(), design.nrows());
    };
    let largest = svd.singular_values.iter().fold(0.0, |most: f64, value| most.max(*value));
    let mut order: Vec<usize> = (0..svd.singular_values.len()).collect();
    order.sort_by(|one, other| svd.singular_values[*other].total_cmp(&svd.singular_values[*one]));
    let mut inverse = DMatrix::zeros(design.ncols(), design.nrows());
    for &k in order.iter().take(rank).filter(|&&k| svd.singular_values[k] > 1e-13 * largest) {
        inverse += right.row(k).transpose() * left.column(k).transpose() / svd.singular_values[k];
    }
    inverse
}

/// Plateaus at the means of those of nearly the same speed, and of the same load: what differs by noise alone tells nothing apart.
fn cells(plateaus: &[&Plateau]) -> Vec<Plateau> {
    let mut cells: Vec<Plateau> = plateaus.iter().map(|plateau| (*plateau).clone()).collect();
    cells.sort_by(|one, other| one.speed.abs().total_cmp(&other.speed.abs()));
    let is_same = |slowest: f64, cell: &Plateau| cell.speed.abs() - slowest <= SAME * cell.speed.abs();
    let mut start = 0;
    while start < cells.len() {
        let slowest = cells[start].speed.abs();
        let end = cells[start..].iter().position(|cell| !is_same(slowest, cell)).map_or(cells.len(), |k| start + k);
        let mean = cells[start..end].iter().map(|cell| cell.speed.abs()).sum::<f64>() / (end - start) as f64;
        cells[start..end].iter_mut().for_each(|cell| cell.speed = mean.copysign(cell.speed));
        start = end;
    }
    let mut loads: BTreeMap<usize, f64> = BTreeMap::new();
    for cell in &mut cells {
        cell.load = cell.load.map(|load| *loads.entry(cell.group).or_insert(load));
    }
    cells.sort_by(|one, other| one.group.cmp(&other.group).then(one.speed.total_cmp(&other.speed)));
    cells.dedup_by(|one, other| one.group == other.group && one.speed == other.speed);
    cells
}

/// Directions of scaled parameters that the cells leave open, and the rank.
fn open_directions(law: Law, cells: &[Plateau], parameters: &[f64], scales: &[f64]) -> (DMatrix<f64>, usize) {
    let (_, design) = linear(law, &cells.iter().collect::<Vec<_>>(), parameters);
    let design = scaled(&design, scales);
    // squares of singular values lose digits: a square matrix of the same singular values has all directions
    let (rows, count) = (design.nrows().max(law.count()), law.count());
    let padded = design.resize(rows, count, 0.0);
    let svd = padded.svd(false, true);
    let Some(right) = svd.v_t else { return (DMatrix::zeros(count, 0), count) };
    let largest = svd.singular_values.iter().fold(0.0, |most: f64, value| most.max(*value));
    let open: Vec<usize> = (0..count).filter(|&k| svd.singular_values[k] <= RANK * largest).collect();
    let directions = DMatrix::from_fn(count, open.len(), |row, column| right[(open[column], row)]);
    (directions, count - open.len())
}
