//! All tensions that balance a load: f = p + H λ, with p the one of minimum norm and H an orthonormal basis of ker Aᵀ.

use nalgebra::DMatrix;

use super::InputError;
use super::quadratic::balance::Balance;
use super::quadratic::block::Block;
use crate::scalar::LANES;

/// The balanced tensions of one problem, in memory that is used again for the next.
#[derive(Clone, Debug)]
pub(super) struct Affine {
    balance: Balance,
    cable_count: usize,
    /// Entries per column: one per cable, padded with zeros to whole blocks.
    stride: usize,
    /// H, and after it p.
    columns: Vec<Block>,
    /// Number of columns of H that no fixed cable has used up.
    dimension: usize,
    /// Row of one cable in H; `fix` turns it until only its last entry differs from zero.
    row: Vec<f64>,
}

/// Norm of a cable's row in the free columns of H below which its tension cannot be changed.
const FIXED: f64 = 1e-9;

/// Orthonormal columns H of the null space of a structure matrix: Aᵀ H = 0.
pub(crate) fn null_space(structure_matrix: &DMatrix<f64>) -> Result<DMatrix<f64>, InputError> {
    let (dof, cable_count) = structure_matrix.shape();
    let mut affine = Affine::new(cable_count, dof);
    affine.load(structure_matrix, &vec![0.0; dof])?;
    Ok(DMatrix::from_fn(cable_count, affine.dimension(), |cable, column| affine.column(column)[cable]))
}

impl Affine {
    pub(super) fn new(cable_count: usize, dof: usize) -> Self {
        let blocks = cable_count.div_ceil(LANES);
        Self {
            balance: Balance::new(cable_count, dof),
            cable_count,
            stride: blocks * LANES,
            columns: vec![[0.0; LANES]; (cable_count + 1) * blocks],
            dimension: 0,
            row: vec![0.0; cable_count],
        }
    }

    /// Computes p and H; false if no tensions balance the load.
    pub(super) fn load(&mut self, structure_matrix: &DMatrix<f64>, wrench: &[f64]) -> Result<bool, InputError> {
        let unreachable = self.balance.solve(structure_matrix, wrench, &mut self.columns)?;
        self.dimension = self.cable_count - self.balance.rank();
        Ok(unreachable.is_none())
    }

    /// True if the rows of the structure matrix are independent by a clear margin.
    pub(super) fn rank_is_certain(&self) -> bool {
        self.balance.rank_is_certain()
    }

    /// Free columns of H.
    pub(super) fn dimension(&self) -> usize {
        self.dimension
    }

    /// One free column of H.
    pub(super) fn column(&self, index: usize) -> &[f64] {
        &self.columns.as_flattened()[index * self.stride..][..self.cable_count]
    }

    /// p, the balanced tensions of minimum norm (N). Valid only while no cable is fixed.
    pub(super) fn minimum_norm(&self) -> &[f64] {
        self.column(self.dimension)
    }

    /// Writes the balanced tensions nearest to a reference, p + H Hᵀ f_ref (N). Valid only while no cable is fixed.
    pub(super) fn nearest(&self, reference: &[f64], point: &mut [f64]) {
        point.copy_from_slice(self.minimum_norm());
        for index in 0..self.dimension {
            let column = self.column(index);
            let along = dot(column, reference);
            add_scaled(point, along, column);
        }
    }

    /// Moves a point along H as little as possible until a cable has this tension (N), and removes that degree of
    /// freedom from H.
    ///
    /// Returns false, and changes nothing, if the fixed cables leave this one no freedom.
    pub(super) fn fix(&mut self, cable: usize, tension: f64, point: &mut [f64]) -> bool {
        let (stride, dimension) = (self.stride, self.dimension);
        let numbers = self.columns.as_flattened_mut();
        for index in 0..dimension {
            self.row[index] = numbers[index * stride + cable];
        }
        let row = &mut self.row[..dimension];
        if !(dot(row, row).sqrt() > FIXED) {
            return false;
        }
        // rotates neighbouring columns until the last one alone moves the cable
        for index in 1..dimension {
            let length = (row[index - 1].powi(2) + row[index].powi(2)).sqrt();
            if length > 0.0 {
                let [sin, cos] = [row[index - 1] / length, row[index] / length];
                let (first, second) = numbers.split_at_mut(index * stride);
                for (a, b) in first[(index - 1) * stride..].iter_mut().zip(second) {
                    (*a, *b) = (cos * *a - sin * *b, cos * *b + sin * *a);
                }
                row[index] = length;
            }
        }
        self.dimension -= 1;
        let way = (tension - point[cable]) / row[dimension - 1];
        add_scaled(point, way, &self.columns.as_flattened()[self.dimension * stride..][..self.cable_count]);
        point[cable] = tension;
        true
    }
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// target += factor · source
pub(super) fn add_scaled(target: &mut [f64], factor: f64, source: &[f64]) {
    target.iter_mut().zip(source).for_each(|(target, source)| *target += factor * source);
}
