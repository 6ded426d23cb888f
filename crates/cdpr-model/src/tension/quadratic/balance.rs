//! The equations Aᵀ f + w = 0: their solutions are f = p + H λ, with H an orthonormal basis of the null space of Aᵀ.

use nalgebra::DMatrix;

use super::block::{Block, add_scaled, dot};
use super::fixed::{self, CERTAIN, LOST};
use crate::scalar::{LANES, dispatch_narrow};
use crate::tension::InputError;
use crate::tension::limits::LARGEST;

/// Residual of the load, as a fraction of load and tensions, below which dependent rows do not contradict each other.
const INCONSISTENT: f64 = 1e-9;

/// Householder factors of the rows of a structure matrix, A = Q R.
#[derive(Clone, Debug)]
pub(in crate::tension) struct Balance {
    cable_count: usize,
    dof: usize,
    blocks: usize,
    /// Factors that give each row the length 1: forces and moments have different units.
    row_scales: Vec<f64>,
    /// The rows, then the reflectors.
    columns: Vec<Block>,
    /// 2/‖v‖² of the reflectors.
    factors: Vec<f64>,
    /// R by columns, n each, with the reciprocal on the diagonal.
    triangle: Vec<f64>,
    /// Row of the structure matrix at each place.
    order: Vec<usize>,
    rank: usize,
    /// True if the factors come from the fixed-size code, with rows in their own order.
    is_fixed: bool,
    /// Coordinates of the particular solution in the columns of Q.
    coordinates: Vec<f64>,
}

/// Residual of a load that no tensions balance.
#[derive(Clone, Copy, Debug)]
pub(in crate::tension) struct Unreachable {
    /// Place (in the order of the factors) of the unbalanced row.
    place: usize,
    /// Its residual, with the row scaled to length 1.
    residual: f64,
}

impl Balance {
    pub(in crate::tension) fn new(cable_count: usize, dof: usize) -> Self {
        let blocks = cable_count.div_ceil(LANES);
        Self {
            cable_count,
            dof,
            blocks,
            row_scales: vec![0.0; dof],
            columns: vec![[0.0; LANES]; dof * blocks],
            factors: vec![0.0; dof],
            triangle: vec![0.0; dof * dof],
            order: (0..dof).collect(),
            rank: 0,
            is_fixed: false,
            coordinates: vec![0.0; dof],
        }
    }

    pub(in crate::tension) fn rank(&self) -> usize {
        self.rank
    }

    /// True if the rows are independent by a margin that holds in any order of the rows.
    pub(in crate::tension) fn rank_is_certain(&self) -> bool {
        let reciprocals = (0..self.dof).map(|row| self.triangle[row * self.dof + row].abs());
        self.rank == self.dof && reciprocals.fold(0.0, f64::max) < 1.0 / CERTAIN
    }

    /// Solves the balance: writes H (m − rank columns) to `solutions` and after it the minimum-norm tensions that
    /// balance the rows with rank. Returns the residual if another row contradicts them, otherwise `None`.
    pub(in crate::tension) fn solve(
        &mut self,
        structure_matrix: &DMatrix<f64>,
        wrench: &[f64],
        solutions: &mut [Block],
    ) -> Result<Option<Unreachable>, InputError> {
        self.is_fixed = self.solve_fixed(structure_matrix, wrench, solutions);
        if self.is_fixed {
            return Ok(None);
        }
        self.factorise(structure_matrix)?;
        let unreachable = self.balance(wrench)?;
        self.write_solutions(solutions);
        Ok(unreachable)
    }

    /// Solves 2, 3 or 6 rows with up to eight cables in registers; false if the general code is needed.
    fn solve_fixed(&mut self, structure_matrix: &DMatrix<f64>, wrench: &[f64], solutions: &mut [Block]) -> bool {
        if self.blocks != 1 || self.dof > self.cable_count {
            return false;
        }
        let done = match self.dof {
            2 => dispatch_narrow(self.fixed::<2>(structure_matrix, wrench, solutions)),
            3 => dispatch_narrow(self.fixed::<3>(structure_matrix, wrench, solutions)),
            6 => dispatch_narrow(self.fixed::<6>(structure_matrix, wrench, solutions)),
            _ => false,
        };
        if done {
            self.rank = self.dof;
            self.order.iter_mut().enumerate().for_each(|(place, row)| *row = place);
        }
        done
    }

    fn fixed<'a, const N: usize>(
        &'a mut self,
        structure_matrix: &'a DMatrix<f64>,
        wrench: &'a [f64],
        solutions: &'a mut [Block],
    ) -> fixed::Solutions<'a, N> {
        fixed::Solutions {
            structure_matrix: structure_matrix.as_slice(),
            wrench,
            row_scales: &mut self.row_scales,
            factors: &mut self.factors,
            reflectors: &mut self.columns,
            triangle: &mut self.triangle,
            solutions,
        }
    }

    /// Factorises the matrix; rows are reordered only if the rank is in doubt.
    fn factorise(&mut self, structure_matrix: &DMatrix<f64>) -> Result<(), InputError> {
        self.load(structure_matrix)?;
        if !self.reflect(false) {
            self.load(structure_matrix)?;
            self.reflect(true);
        }
        Ok(())
    }

    fn load(&mut self, structure_matrix: &DMatrix<f64>) -> Result<(), InputError> {
        let (dof, blocks) = (self.dof, self.blocks);
        let columns = self.columns.as_flattened_mut();
        for (cable, entries) in structure_matrix.as_slice().chunks_exact(dof).enumerate() {
            for (row, entry) in entries.iter().enumerate() {
                columns[row * blocks * LANES + cable] = *entry;
            }
        }
        let mut largest = 0.0_f64;
        for (row, place) in self.columns.chunks_exact(blocks).zip(&mut self.row_scales) {
            *place = dot(row, row);
            if !place.is_finite() {
                return Err(InputError::NotFinite { what: "structure matrix" });
            }
            largest = largest.max(*place);
        }
        for (row, scale) in self.columns.chunks_exact_mut(blocks).zip(&mut self.row_scales) {
            // a row of rounding must not be scaled to length 1
            *scale = if *scale > LOST * LOST * largest { 1.0 / scale.sqrt() } else { 1.0 };
            row.as_flattened_mut().iter_mut().for_each(|entry| *entry *= *scale);
        }
        self.order.iter_mut().enumerate().for_each(|(place, row)| *row = place);
        Ok(())
    }

    /// Writes the reflectors; false if the rank is in doubt and the rows were not reordered.
    fn reflect(&mut self, ordered: bool) -> bool {
        let (dof, blocks) = (self.dof, self.blocks);
        let most = dof.min(self.cable_count);
        for k in 0..most {
            self.rank = k;
            if ordered {
                self.bring_longest_to(k);
            }
            self.take_head(k, k);
            let (done, residual) = self.columns.split_at_mut((k + 1) * blocks);
            let v = &mut done[k * blocks..];
            let length = dot(v, v).sqrt();
            if length <= if ordered { LOST } else { CERTAIN } {
                (k + 1..dof).for_each(|row| self.take_head(row, k));
                return ordered;
            }
            let head = &mut v[k / LANES][k % LANES];
            let signed = length.copysign(*head);
            *head += signed;
            let factor = 1.0 / (signed * *head);
            self.triangle[k * dof + k] = -1.0 / signed;
            self.factors[k] = factor;
            for column in residual.chunks_exact_mut(blocks) {
                let along = factor * dot(v, column);
                add_scaled(column, -along, v);
            }
        }
        self.rank = most;
        (most..dof).for_each(|row| self.take_head(row, most));
        true
    }

    /// Moves the first entries of a column to R.
    fn take_head(&mut self, column: usize, count: usize) {
        let entries = self.columns[column * self.blocks..(column + 1) * self.blocks].as_flattened_mut();
        let target = &mut self.triangle[column * self.dof..];
        target[..count].copy_from_slice(&entries[..count]);
        entries[..count].fill(0.0);
    }

    fn bring_longest_to(&mut self, k: usize) {
        let (dof, blocks) = (self.dof, self.blocks);
        let tail = |column: &[Block]| column.as_flattened()[k..].iter().map(|entry| entry * entry).sum::<f64>();
        let lengths = (k..dof).map(|j| (j, tail(&self.columns[j * blocks..(j + 1) * blocks])));
        let longest = lengths.fold((k, -1.0), |best, next| if next.1 > best.1 { next } else { best }).0;
        for block in 0..blocks {
            self.columns.swap(k * blocks + block, longest * blocks + block);
        }
        self.order.swap(k, longest);
    }

    /// Solves Rᵀ y = −w for the rows that have rank; returns the worst residual of the other rows if it is above
    /// rounding.
    fn balance(&mut self, wrench: &[f64]) -> Result<Option<Unreachable>, InputError> {
        let (dof, rank) = (self.dof, self.rank);
        let mut worst: Option<Unreachable> = None;
        let (mut size, mut sum) = (0.0_f64, 0.0);
        for place in 0..dof {
            let row = self.order[place];
            let column = &self.triangle[place * dof..(place + 1) * dof];
            let mut residual = wrench[row] * self.row_scales[row];
            size = size.max(residual.abs());
            sum += residual.abs();
            for (entry, y) in column[..rank.min(place)].iter().zip(&self.coordinates) {
                residual += entry * y;
            }
            if place < rank {
                self.coordinates[place] = -residual * column[place];
                size = size.max(self.coordinates[place].abs());
            } else if worst.is_none_or(|worst| residual.abs() > worst.residual.abs()) {
                worst = Some(Unreachable { place, residual });
            }
        }
        // the squares of tensions must be finite too; NaN fails this as well
        if !(sum.abs() < LARGEST) {
            return Err(InputError::NotFinite { what: "wrench" });
        }
        Ok(worst.filter(|worst| worst.residual.abs() > INCONSISTENT * size))
    }

    /// Writes H (m − rank columns) and after it the minimum-norm tensions p = Q y that balance the load.
    fn write_solutions(&self, columns: &mut [Block]) {
        let (blocks, rank) = (self.blocks, self.rank);
        let dimension = self.cable_count - rank;
        let columns = &mut columns[..(dimension + 1) * blocks];
        columns.fill([0.0; LANES]);
        let (null_space, particular) = columns.split_at_mut(dimension * blocks);
        for (j, column) in null_space.chunks_exact_mut(blocks).enumerate() {
            column.as_flattened_mut()[rank + j] = 1.0;
        }
        particular.as_flattened_mut()[..rank].copy_from_slice(&self.coordinates[..rank]);
        for k in (0..rank).rev() {
            let (v, factor) = (&self.columns[k * blocks..(k + 1) * blocks], self.factors[k]);
            for column in columns.chunks_exact_mut(blocks) {
                let along = factor * dot(v, column);
                add_scaled(column, -along, v);
            }
        }
    }

    /// Writes the combination y of rows that is nearest to `cables`, A y ≈ c; `cables` is used up.
    pub(super) fn write_combination(&self, cables: &mut [Block], y: &mut [f64]) {
        match self.dof {
            2 if self.is_fixed => return dispatch_narrow(self.combination::<2>(&cables[0], y)),
            3 if self.is_fixed => return dispatch_narrow(self.combination::<3>(&cables[0], y)),
            6 if self.is_fixed => return dispatch_narrow(self.combination::<6>(&cables[0], y)),
            _ => {}
        }
        let blocks = self.blocks;
        for k in 0..self.rank {
            let v = &self.columns[k * blocks..(k + 1) * blocks];
            let along = self.factors[k] * dot(v, cables);
            add_scaled(cables, -along, v);
        }
        y.fill(0.0);
        self.write_back_substituted(&cables.as_flattened()[..self.rank], y);
    }

    fn combination<'a, const N: usize>(&'a self, cables: &'a Block, y: &'a mut [f64]) -> fixed::Combination<'a, N> {
        fixed::Combination {
            cables,
            row_scales: &self.row_scales,
            factors: &self.factors,
            reflectors: &self.columns,
            triangle: &self.triangle,
            y,
        }
    }

    /// Writes the combination y of rows for which A y = 0 but yᵀ w < 0.
    pub(super) fn write_contradiction(&self, unreachable: Unreachable, y: &mut [f64]) {
        let place = unreachable.place;
        let sign = -unreachable.residual.signum();
        y.fill(0.0);
        let column = &self.triangle[place * self.dof..];
        self.write_back_substituted(&column[..self.rank], y);
        y.iter_mut().for_each(|entry| *entry *= -sign);
        let row = self.order[place];
        y[row] = sign * self.row_scales[row];
    }

    /// Writes y = R⁻¹ right, in the caller's order and scale of the rows.
    fn write_back_substituted(&self, right: &[f64], y: &mut [f64]) {
        let (dof, rank) = (self.dof, self.rank);
        for place in (0..rank).rev() {
            let mut value = right[place];
            for later in place + 1..rank {
                value -= self.triangle[later * dof + place] * y[self.order[later]];
            }
            y[self.order[place]] = value * self.triangle[place * dof + place];
        }
        for (entry, scale) in y.iter_mut().zip(&self.row_scales) {
            *entry *= scale;
        }
    }
}
