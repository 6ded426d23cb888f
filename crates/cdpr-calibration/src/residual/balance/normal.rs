//! Normal equations of weighted rows, and whitened rows, parameters in lanes.

use super::rows::SampleRows;
use cdpr_model::scalar::{Kernel, LANES, Lanes, dispatch};

/// Σ JᵀWJ (lower triangle), Σ JᵀWr and Σ rᵀWr over samples, with W = Σ⁻¹ of each sample.
///
/// A length row knows the parameters of its own cable only, so of the rows of J just a few reach any block of columns:
/// products with the others are left out.
#[derive(Clone, Debug)]
pub(super) struct NormalEquations {
    hessian: Vec<f64>,
    gradient: Vec<f64>,
    cost: f64,
    /// Columns, rounded up to whole lanes.
    stride: usize,
    /// For each block of columns the rows of J that are not zero there.
    reaching: Vec<Vec<usize>>,
    /// W J of one sample, row-major, rows rounded up to whole lanes.
    products: Vec<f64>,
}

impl NormalEquations {
    /// For rows whose columns belong to cables as `first` says: the first column of each cable, then of the wrench.
    pub(super) fn new(rows: &SampleRows, first: &[usize]) -> Self {
        let cables = first.len() - 1;
        let wrench_rows = rows.count - cables;
        let blocks = rows.parameter_count.div_ceil(LANES);
        let of_block = |block: usize| {
            let columns = block * LANES..(block + 1) * LANES;
            let has_columns = |cable: &usize| first[*cable].max(columns.start) < first[cable + 1].min(columns.end);
            (0..wrench_rows).chain((0..cables).filter(has_columns).map(|cable| wrench_rows + cable)).collect()
        };
        let stride = blocks * LANES;
        Self {
            hessian: vec![0.0; stride * stride],
            gradient: vec![0.0; stride],
            cost: 0.0,
            stride,
            reaching: (0..blocks).map(of_block).collect(),
            products: vec![0.0; rows.count.next_multiple_of(LANES) * stride.max(1)],
        }
    }

    pub(super) fn clear(&mut self) {
        self.hessian.fill(0.0);
        self.gradient.fill(0.0);
        self.cost = 0.0;
    }

    /// Weighted sum of squares.
    pub(super) fn cost(&self) -> f64 {
        self.cost
    }

    pub(super) fn add_to_cost(&mut self, amount: f64) {
        self.cost += amount;
    }

    /// JᵀWr of one parameter.
    pub(super) fn gradient(&self, k: usize) -> f64 {
        self.gradient[k]
    }

    pub(super) fn add_to_gradient(&mut self, k: usize, amount: f64) {
        self.gradient[k] += amount;
    }

    /// JᵀWJ of two parameters.
    pub(super) fn entry(&self, i: usize, j: usize) -> f64 {
        self.hessian[i.max(j) * self.stride + i.min(j)]
    }

    pub(super) fn add_to_diagonal(&mut self, k: usize, amount: f64) {
        self.hessian[k * self.stride + k] += amount;
    }

    /// Adds the rows of one sample with their weight W, whose rows are rounded up to whole lanes.
    pub(super) fn add(&mut self, weight: &[f64], rows: &SampleRows) {
        dispatch(AddSample { weight, rows, equations: self });
    }
}

/// Whitens the rows of a sample in place: solves L X = \[J r\].
pub(super) fn whiten(factor: &[f64], rows: &mut SampleRows) {
    rows.is_full = true;
    dispatch(Whiten { factor, rows });
}

struct Whiten<'a> {
    factor: &'a [f64],
    rows: &'a mut SampleRows,
}

impl Kernel for Whiten<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        substitute(l, self.factor, self.rows);
    }
}

struct AddSample<'a> {
    weight: &'a [f64],
    rows: &'a SampleRows,
    equations: &'a mut NormalEquations,
}

impl Kernel for AddSample<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        let Self { weight, rows, equations } = self;
        let (entries, _) = rows.entries.as_chunks::<LANES>();
        let sample = Sample {
            entries,
            row_blocks: rows.stride / LANES,
            weight: weight.as_chunks::<LANES>().0,
            weight_groups: rows.count.div_ceil(LANES),
        };
        equations.add_residuals(l, rows, &sample);
        equations.multiply(l, &sample);
        equations.add_products(l, &sample);
    }
}

/// One sample in lanes.
struct Sample<'a> {
    /// J, some blocks of columns a row.
    entries: &'a [[f64; LANES]],
    row_blocks: usize,
    /// W, some groups of columns a row.
    weight: &'a [[f64; LANES]],
    weight_groups: usize,
}

impl Sample<'_> {
    #[inline]
    fn block(&self, row: usize, block: usize) -> &[f64; LANES] {
        &self.entries[row * self.row_blocks + block]
    }
}

impl NormalEquations {
    /// JᵀWr and rᵀWr.
    #[inline(always)]
    fn add_residuals<L: Lanes>(&mut self, l: L, rows: &SampleRows, sample: &Sample<'_>) {
        let groups = sample.weight_groups;
        for group in 0..groups {
            let mut weighted = l.constant(0.0);
            for k in 0..rows.count {
                weighted = weighted + l.constant(rows.residual(k)) * l.load(&sample.weight[k * groups + group]);
            }
            weighted.store(&mut self.products[group * LANES..]);
        }
        for k in 0..rows.count {
            self.cost += rows.residual(k) * self.products[k];
        }
        let (gradient, _) = self.gradient.as_chunks_mut::<LANES>();
        for (block, reaching) in self.reaching.iter().enumerate() {
            let mut sum = l.load(&gradient[block]);
            for &k in reaching {
                sum = sum + l.constant(self.products[k]) * l.load(sample.block(k, block));
            }
            sum.store(&mut gradient[block]);
        }
    }

    /// W J.
    #[inline(always)]
    fn multiply<L: Lanes>(&mut self, l: L, sample: &Sample<'_>) {
        let blocks = self.reaching.len();
        let (products, _) = self.products.as_chunks_mut::<LANES>();
        let groups = sample.weight_groups;
        for (block, reaching) in self.reaching.iter().enumerate() {
            for group in 0..groups {
                let mut tile = [l.constant(0.0); LANES];
                for &k in reaching {
                    let values = l.load(sample.block(k, block));
                    let weights = &sample.weight[k * groups + group];
                    for row in 0..LANES {
                        tile[row] = tile[row] + l.constant(weights[row]) * values;
                    }
                }
                for row in 0..LANES {
                    tile[row].store(&mut products[(group * LANES + row) * blocks + block]);
                }
            }
        }
    }

    /// Jᵀ (W J), eight rows at a time, so that each load of a row of W J serves eight products.
    #[inline(always)]
    fn add_products<L: Lanes>(&mut self, l: L, sample: &Sample<'_>) {
        let blocks = self.reaching.len();
        let (products, _) = self.products.as_chunks::<LANES>();
        let (hessian, _) = self.hessian.as_chunks_mut::<LANES>();
        for (first, reaching) in self.reaching.iter().enumerate() {
            for block in 0..=first {
                let mut tile = [l.constant(0.0); LANES];
                for &k in reaching {
                    let values = l.load(&products[k * blocks + block]);
                    let factors = sample.block(k, first);
                    for row in 0..LANES {
                        tile[row] = tile[row] + l.constant(factors[row]) * values;
                    }
                }
                for row in 0..LANES {
                    let sum = &mut hessian[(first * LANES + row) * blocks + block];
                    (l.load(sum) + tile[row]).store(sum);
                }
            }
        }
    }
}

/// Columns whose substitution runs side by side: each waits for its own earlier rows.
const SIDE_BY_SIDE: usize = 4;

/// Forward substitution with the lower factor, some blocks of columns side by side.
#[inline(always)]
fn substitute<L: Lanes>(l: L, factor: &[f64], rows: &mut SampleRows) {
    let (count, blocks) = (rows.count, rows.stride / LANES);
    let (entries, _) = rows.entries.as_chunks_mut::<LANES>();
    let entries = &mut entries[..count * blocks];
    let mut block = 0;
    while block < blocks {
        match blocks - block {
            SIDE_BY_SIDE.. => substitute_blocks::<L, SIDE_BY_SIDE>(l, factor, entries, count, blocks, block),
            2.. => substitute_blocks::<L, 2>(l, factor, entries, count, blocks, block),
            _ => substitute_blocks::<L, 1>(l, factor, entries, count, blocks, block),
        }
        block += match blocks - block {
            SIDE_BY_SIDE.. => SIDE_BY_SIDE,
            2.. => 2,
            _ => 1,
        };
    }
}

#[inline(always)]
fn substitute_blocks<L: Lanes, const B: usize>(
    l: L,
    factor: &[f64],
    entries: &mut [[f64; LANES]],
    count: usize,
    blocks: usize,
    first: usize,
) {
    for row in 0..count {
        let own = &factor[row * count..][..count];
        let mut values = [l.constant(0.0); B];
        for b in 0..B {
            values[b] = l.load(&entries[row * blocks + first + b]);
        }
        for k in 0..row {
            let weight = l.constant(own[k]);
            for b in 0..B {
                values[b] = values[b] - weight * l.load(&entries[k * blocks + first + b]);
            }
        }
        let inverse = l.constant(own[row]);
        for b in 0..B {
            (values[b] * inverse).store(&mut entries[row * blocks + first + b]);
        }
    }
}
