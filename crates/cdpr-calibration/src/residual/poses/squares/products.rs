//! Sums of products of residuals and derivatives, samples in lanes.

use super::cable::Column;
use crate::minimize::dense::DenseEquations;
use cdpr_model::scalar::{Kernel, Lanes, Line, dispatch};

/// Columns of a tile of products.
const TILE: usize = 4;

/// Σ rᵀr, Jᵀr and JᵀJ in lanes.
pub(super) struct Products {
    parameters: usize,
    cost: Line,
    gradient: Vec<Line>,
    /// Tiles of the lower triangle, row by row.
    hessian: Vec<[[Line; TILE]; TILE]>,
}

impl Products {
    pub(super) fn new(parameters: usize) -> Self {
        let tiles = parameters.div_ceil(TILE);
        Self {
            parameters,
            cost: Line::default(),
            gradient: vec![Line::default(); tiles * TILE],
            hessian: vec![[[Line::default(); TILE]; TILE]; tiles * (tiles + 1) / 2],
        }
    }

    /// Columns, those that fill the last tile included.
    pub(super) fn columns(&self) -> usize {
        self.gradient.len()
    }

    /// Sums begin anew, those of JᵀJ where they are asked for.
    pub(super) fn clear(&mut self, with_hessian: bool) {
        self.cost = Line::default();
        self.gradient.fill(Line::default());
        if with_hessian {
            self.hessian.fill([[Line::default(); TILE]; TILE]);
        }
    }

    /// Adds eight samples to Σ rᵀr.
    #[inline(always)]
    pub(super) fn add<L: Lanes>(&mut self, l: L, residuals: &[L; 6]) {
        let mut cost = l.load(&self.cost.0);
        for row in 0..6 {
            cost = cost + residuals[row] * residuals[row];
        }
        cost.store(&mut self.cost.0);
    }

    /// Adds eight samples to an entry of Jᵀr.
    #[inline(always)]
    pub(super) fn add_to_gradient<L: Lanes>(&mut self, l: L, parameter: usize, entry: L) {
        let sum = &mut self.gradient[parameter].0;
        (l.load(sum) + entry).store(sum);
    }

    /// Adds eight samples to JᵀJ.
    #[inline(always)]
    pub(super) fn add_to_hessian<L: Lanes>(&mut self, l: L, columns: &[Column]) {
        let (tiles, _) = columns.as_chunks::<TILE>();
        let mut sums = self.hessian.iter_mut();
        for (index, first) in tiles.iter().enumerate() {
            for (second, sums) in tiles[..=index].iter().zip(&mut sums) {
                add_tile(l, first, second, sums);
            }
        }
    }

    /// Writes the sums over the lanes, that of JᵀJ where it was asked for.
    pub(super) fn write(&self, equations: &mut DenseEquations, with_hessian: bool) {
        dispatch(Total { products: self, equations, with_hessian });
    }
}

#[inline(always)]
fn add_tile<L: Lanes>(l: L, first: &[Column; TILE], second: &[Column; TILE], sums: &mut [[Line; TILE]; TILE]) {
    let mut tile = [[l; TILE]; TILE];
    for i in 0..TILE {
        for j in 0..TILE {
            tile[i][j] = l.load(&sums[i][j].0);
        }
    }
    for row in 0..6 {
        let mut others = [l; TILE];
        for j in 0..TILE {
            others[j] = l.load(&second[j][row].0);
        }
        for i in 0..TILE {
            let own = l.load(&first[i][row].0);
            for j in 0..TILE {
                tile[i][j] = tile[i][j] + own * others[j];
            }
        }
    }
    for i in 0..TILE {
        for j in 0..TILE {
            tile[i][j].store(&mut sums[i][j].0);
        }
    }
}

struct Total<'a> {
    products: &'a Products,
    equations: &'a mut DenseEquations,
    with_hessian: bool,
}

impl Kernel for Total<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let Self { products, equations, with_hessian } = self;
        equations.cost = l.load(&products.cost.0).sum();
        for k in 0..products.parameters {
            equations.gradient[k] = l.load(&products.gradient[k].0).sum();
        }
        if !with_hessian {
            return;
        }
        let (tiles, count) = (products.gradient.len() / TILE, products.parameters);
        let entries = equations.hessian.as_mut_slice();
        let mut sums = products.hessian.iter();
        for first in 0..tiles {
            for (second, tile) in (0..=first).zip(&mut sums) {
                for i in 0..TILE {
                    let mut four = [l; TILE];
                    for j in 0..TILE {
                        four[j] = l.load(&tile[i][j].0);
                    }
                    let totals = L::sums(four);
                    for j in 0..TILE {
                        let (row, column) = (first * TILE + i, second * TILE + j);
                        if row < count && column <= row {
                            entries[column * count + row] = totals[j];
                            entries[row * count + column] = totals[j];
                        }
                    }
                }
            }
        }
    }
}
