//! Fit of both branches and of the transitions between them.
//!
//! With t = 0…1 over the elongations, f = mid(t) + half(t)·Σ wⱼ Sⱼ is linear in the values and slopes of mid and half at
//! the knots for given shares wⱼ, and linear in the shares for given branches: each is a problem of least squares, solved
//! in turn. That both branches rise and do not cross are linear conditions on the coefficients of their pieces in
//! Bernstein's form, which suffice. The states Sⱼ depend on the record only.

use nalgebra::{DMatrix, DVector};

use cdpr_model::cable::stretch::hysteresis::Memory;
use cdpr_model::robot::{HysteresisTable, TRANSITION_LIMIT};

/// Transitions offered, as shares of all elongations; the fit decides how much of the way is done within each.
const TRANSITIONS: [f64; TRANSITION_LIMIT] = [0.01, 0.0175, 0.031, 0.054, 0.094, 0.164, 0.287, 0.5];

/// Shares below this are left out of the table.
const LEAST_SHARE: f64 = 1e-3;

/// Alternations between branches and shares.
const ALTERNATIONS: usize = 30;

/// Rows that take part in the fit; a longer record is thinned out.
const ROWS: usize = 4000;

/// Least slope of a branch, as a share of the mean one.
const LEAST_SLOPE: f64 = 1e-3;

/// Least half width of the loop, as a share of the range of tensions: rounding shall not let the branches cross.
const LEAST_HALF: f64 = 1e-5;

/// Largest half width at the first knot, as a share of the tension there, that leaves room to close at zero tension.
const WIDEST_START: f64 = 0.6;

/// Branches over t = 0…1 by value and slope at the knots, with the transitions between them.
#[derive(Clone, Debug)]
pub(super) struct BranchFit {
    pieces: usize,
    /// For mid and then for half: value and slope at each knot (N).
    unknowns: DVector<f64>,
    fractions: Vec<f64>,
    initial: f64,
}

/// The samples of the fit, scaled.
struct Samples {
    pieces: usize,
    /// Basis of one branch at each row: first knot and its four coefficients.
    basis: Vec<(usize, [f64; 4])>,
    /// Tensions in units of `scale`.
    tensions: Vec<f64>,
    /// States of the stops at each row.
    states: Vec<[f64; TRANSITION_LIMIT]>,
    scale: f64,
}

/// The best fit over the states that the cable may have had before the record.
pub(super) fn fit(elongations: &[f64], tensions: &[f64], pieces: usize) -> BranchFit {
    let fits = [-1.0, 0.0, 1.0].map(|initial| {
        let samples = Samples::new(elongations, tensions, pieces, initial);
        samples.descend(initial)
    });
    let [first, second, third] = fits;
    let better = |one: (BranchFit, f64), other: (BranchFit, f64)| if other.1 < one.1 { other } else { one };
    better(better(first, second), third).0
}

impl Samples {
    fn new(elongations: &[f64], tensions: &[f64], pieces: usize, initial: f64) -> Self {
        let (lower, upper) = bounds(elongations);
        let (least, largest) = bounds(tensions);
        let scale = largest - least;
        let stride = elongations.len().div_ceil(ROWS);
        let mut state = [initial; TRANSITION_LIMIT];
        let mut before = (elongations[0] - lower) / (upper - lower);
        let mut samples = Self { pieces, basis: Vec::new(), tensions: Vec::new(), states: Vec::new(), scale };
        for (row, (elongation, tension)) in elongations.iter().zip(tensions).enumerate() {
            let t = (elongation - lower) / (upper - lower);
            for (stop, transition) in state.iter_mut().zip(TRANSITIONS) {
                *stop = (*stop + 2.0 * (t - before) / transition).clamp(-1.0, 1.0);
            }
            before = t;
            if row % stride == 0 {
                samples.basis.push(basis(t, pieces));
                samples.tensions.push(tension / scale);
                samples.states.push(state);
            }
        }
        samples
    }

    /// Alternates between branches and shares; the fit and its mean square.
    fn descend(&self, initial: f64) -> (BranchFit, f64) {
        let conditions = self.conditions();
        let mut fractions = vec![1.0 / TRANSITION_LIMIT as f64; TRANSITION_LIMIT];
        for _ in 0..ALTERNATIONS {
            let unknowns = self.branches(&fractions, &conditions);
            fractions = self.fractions(&unknowns, &fractions);
        }
        fractions.iter_mut().filter(|fraction| **fraction < LEAST_SHARE).for_each(|fraction| *fraction = 0.0);
        normalize(&mut fractions);
        let unknowns = self.branches(&fractions, &conditions);
        let square = |row: usize| {
            let (mid, half) = self.at(&unknowns, row);
            (mid + half * self.state(&fractions, row) - self.tensions[row]).powi(2)
        };
        let cost = (0..self.tensions.len()).map(square).sum::<f64>() / self.tensions.len() as f64;
        let unknowns = unknowns * self.scale;
        (BranchFit { pieces: self.pieces, unknowns, fractions, initial }, cost)
    }

    fn state(&self, fractions: &[f64], row: usize) -> f64 {
        self.states[row].iter().zip(fractions).map(|(state, fraction)| state * fraction).sum()
    }

    /// mid and half at a row.
    fn at(&self, unknowns: &DVector<f64>, row: usize) -> (f64, f64) {
        let (first, coefficients) = self.basis[row];
        let half = 2 * (self.pieces + 1);
        let sum = |offset: usize| (0..4).map(|k| coefficients[k] * unknowns[offset + first + k]).sum::<f64>();
        (sum(0), sum(half))
    }

    /// Values and slopes at the knots for given shares.
    fn branches(&self, fractions: &[f64], (conditions, bounds): &(DMatrix<f64>, DVector<f64>)) -> DVector<f64> {
        let half = 2 * (self.pieces + 1);
        let count = self.tensions.len() as f64;
        // a weight that only decides where no sample says anything
        let mut normal = DMatrix::identity(2 * half, 2 * half) * 1e-9;
        let mut right = DVector::zeros(2 * half);
        for (row, &(first, coefficients)) in self.basis.iter().enumerate() {
            let state = self.state(fractions, row);
            let entry = |k: usize| match k {
                0..4 => (first + k, coefficients[k]),
                _ => (half + first + k - 4, coefficients[k - 4] * state),
            };
            for (i, a) in (0..8).map(entry) {
                right[i] += a * self.tensions[row] / count;
                for (j, b) in (0..8).map(entry) {
                    normal[(i, j)] += a * b / count;
                }
            }
        }
        least_squares_under(normal, &right, conditions, bounds)
    }

    /// Shares for given branches: not negative, and 1 in sum, since half takes the rest.
    fn fractions(&self, unknowns: &DVector<f64>, before: &[f64]) -> Vec<f64> {
        let mut normal = DMatrix::identity(TRANSITION_LIMIT, TRANSITION_LIMIT) * 1e-15;
        let mut right = DVector::zeros(TRANSITION_LIMIT);
        for row in 0..self.tensions.len() {
            let (mid, half) = self.at(unknowns, row);
            let column = DVector::from_fn(TRANSITION_LIMIT, |j, _| half * self.states[row][j]);
            normal.ger(1.0, &column, &column, 1.0);
            right.axpy(self.tensions[row] - mid, &column, 1.0);
        }
        let mut fractions = before.to_vec();
        for _ in 0..500 {
            for j in 0..TRANSITION_LIMIT {
                let rest: f64 = (0..TRANSITION_LIMIT).map(|k| normal[(j, k)] * fractions[k]).sum();
                fractions[j] = (fractions[j] + (right[j] - rest) / normal[(j, j)]).max(0.0);
            }
        }
        if !normalize(&mut fractions) {
            return before.to_vec();
        }
        fractions
    }

    /// G x ≥ g: both branches rise, the loop has a width and room to close below the first knot.
    fn conditions(&self) -> (DMatrix<f64>, DVector<f64>) {
        let half = 2 * (self.pieces + 1);
        let width = 1.0 / self.pieces as f64;
        let mut rows: Vec<(Vec<(usize, f64)>, f64)> = Vec::new();
        for sign in [1.0, -1.0] {
            let branch = |terms: &[(usize, f64)]| {
                terms.iter().flat_map(|&(k, c)| [(k, c), (half + k, sign * c)]).collect::<Vec<_>>()
            };
            for knot in 0..=self.pieces {
                rows.push((branch(&[(2 * knot + 1, 1.0)]), LEAST_SLOPE));
            }
            for k in (0..self.pieces).map(|piece| 2 * piece) {
                let chord = 3.0 / width;
                rows.push((branch(&[(k, -chord), (k + 2, chord), (k + 1, -1.0), (k + 3, -1.0)]), LEAST_SLOPE));
            }
        }
        for k in (0..=self.pieces).map(|knot| half + 2 * knot) {
            rows.push((vec![(k, 1.0)], LEAST_HALF));
            rows.push((vec![(k, 1.0), (k + 1, width / 3.0)], LEAST_HALF));
            rows.push((vec![(k, 1.0), (k + 1, -width / 3.0)], LEAST_HALF));
        }
        rows.push((vec![(0, 1.0)], 1e-3));
        rows.push((vec![(0, WIDEST_START), (half, -1.0)], 0.0));
        rows.push((vec![(half + 1, 1.0)], 0.0));
        rows.push((vec![(half, 3.0), (half + 1, -1.2 * self.zero_distance())], 0.0));
        let mut conditions = DMatrix::zeros(rows.len(), 2 * half);
        for (row, (terms, _)) in rows.iter().enumerate() {
            terms.iter().for_each(|&(column, c)| conditions[(row, column)] += c);
        }
        (conditions, DVector::from_iterator(rows.len(), rows.iter().map(|row| row.1)))
    }

    /// How far below t = 0 the tension is zero, by the rows of the first tenth.
    fn zero_distance(&self) -> f64 {
        let place = |row: usize| {
            let (first, [_, slope0, value1, slope1]) = self.basis[row];
            // Σ of the basis times the identity function is t
            let width = 1.0 / self.pieces as f64;
            let start = 0.5 * first as f64 * width;
            start + width * value1 + slope0 + slope1
        };
        let low: Vec<(f64, f64)> = (0..self.tensions.len())
            .map(|row| (place(row), self.tensions[row]))
            .filter(|sample| sample.0 < 0.1)
            .collect();
        let count = low.len() as f64;
        let (t0, f0) = (low.iter().map(|s| s.0).sum::<f64>() / count, low.iter().map(|s| s.1).sum::<f64>() / count);
        let slope = low.iter().map(|s| (s.0 - t0) * (s.1 - f0)).sum::<f64>()
            / low.iter().map(|s| (s.0 - t0) * (s.0 - t0)).sum::<f64>();
        let distance = (f0 - slope * t0) / slope;
        if distance.is_finite() { distance.clamp(0.0, 10.0) } else { 0.0 }
    }
}

impl BranchFit {
    /// The memory that the cable had at the strain of the first row.
    pub(super) fn start(&self, strain: f64) -> Memory {
        Memory { strain, stops: [self.initial; TRANSITION_LIMIT] }
    }

    /// The table of the robot file, and the elongation without tension (m).
    ///
    /// Below the record the middle of both branches goes on straight to no tension, where the branches meet.
    pub(super) fn table(&self, [lower, upper]: [f64; 2], length: f64) -> (HysteresisTable, f64) {
        let half = 2 * (self.pieces + 1);
        let (mid0, slope0) = (self.unknowns[0], self.unknowns[1]);
        let distance = mid0 / slope0;
        let half0 = self.unknowns[half];
        let closing = self.unknowns[half + 1].min(3.0 * half0 / distance);
        let opening = (3.0 * half0 / distance - closing - 0.9 * slope0).max(0.0);
        let per_strain = length / (upper - lower);
        let mut table = HysteresisTable { strain: vec![0.0], ..HysteresisTable::default() };
        let (mut loading, mut unloading) = (vec![(0.0, slope0 + opening)], vec![(0.0, slope0 - opening)]);
        for knot in 0..=self.pieces {
            let (k, h) = (2 * knot, half + 2 * knot);
            let half_slope = if knot == 0 { closing } else { self.unknowns[h + 1] };
            let (mid, mid_slope) = (self.unknowns[k], self.unknowns[k + 1]);
            table.strain.push((distance + knot as f64 / self.pieces as f64) / per_strain);
            loading.push((mid + self.unknowns[h], mid_slope + half_slope));
            unloading.push((mid - self.unknowns[h], mid_slope - half_slope));
        }
        let values = |branch: &[(f64, f64)]| branch.iter().map(|knot| rounded(knot.0)).collect();
        let slopes = |branch: &[(f64, f64)]| Some(branch.iter().map(|knot| rounded(knot.1 * per_strain)).collect());
        let used = TRANSITIONS.iter().zip(&self.fractions).filter(|(_, fraction)| **fraction > 0.0);
        let (transitions, fractions): (Vec<f64>, Vec<f64>) =
            used.map(|(transition, fraction)| (rounded(transition / per_strain), rounded(*fraction))).unzip();
        table.strain = table.strain.into_iter().map(rounded).collect();
        (table.loading_N, table.unloading_N) = (values(&loading), values(&unloading));
        (table.loading_slope_N, table.unloading_slope_N) = (slopes(&loading), slopes(&unloading));
        (table.transition_strain, table.transition_share) = (transitions, Some(fractions));
        (table, lower - distance * (upper - lower))
    }
}

/// Eight significant digits: more than any bench has, few enough to read.
fn rounded(x: f64) -> f64 {
    format!("{x:.7e}").parse().unwrap_or(x)
}

fn bounds(numbers: &[f64]) -> (f64, f64) {
    let extreme = |start: f64, choose: fn(f64, f64) -> f64| numbers.iter().copied().fold(start, choose);
    (extreme(f64::INFINITY, f64::min), extreme(f64::NEG_INFINITY, f64::max))
}

/// Makes shares add up to 1; false when there is nothing to share.
fn normalize(fractions: &mut [f64]) -> bool {
    let sum: f64 = fractions.iter().sum();
    if !(sum > 1e-6 && sum.is_finite()) {
        return false;
    }
    fractions.iter_mut().for_each(|fraction| *fraction /= sum);
    true
}

/// Index of the first of four unknowns (value and slope at two knots) and what each adds to the value at t.
fn basis(t: f64, pieces: usize) -> (usize, [f64; 4]) {
    let width = 1.0 / pieces as f64;
    let piece = ((t * pieces as f64) as usize).min(pieces - 1);
    let x = t * pieces as f64 - piece as f64;
    let rest = 1.0 - x;
    let value = x * x * (3.0 - 2.0 * x);
    (2 * piece, [1.0 - value, width * x * rest * rest, value, -width * x * x * rest])
}

/// Minimum of ½ xᵀ H x − gᵀ x under G x ≥ b, by Hildreth's iteration on the multipliers (1957).
fn least_squares_under(
    normal: DMatrix<f64>,
    right: &DVector<f64>,
    conditions: &DMatrix<f64>,
    bounds: &DVector<f64>,
) -> DVector<f64> {
    let Some(factor) = normal.cholesky() else { return DVector::zeros(right.len()) };
    let free = factor.solve(right);
    let missing = bounds - conditions * &free;
    if missing.iter().all(|&x| x <= 0.0) {
        return free;
    }
    let push = factor.solve(&conditions.transpose());
    let coupling = conditions * &push;
    let mut multipliers = DVector::<f64>::zeros(bounds.len());
    for _ in 0..5000 {
        let mut change = 0.0_f64;
        for row in 0..bounds.len() {
            let pulled = coupling.row(row).transpose().dot(&multipliers);
            let next = (multipliers[row] + (missing[row] - pulled) / coupling[(row, row)]).max(0.0);
            change = change.max((next - multipliers[row]).abs() * coupling[(row, row)]);
            multipliers[row] = next;
        }
        if change < 1e-12 {
            break;
        }
    }
    free + push * multipliers
}
