//! Range of each tension while all of them balance a load within limits: two linear programmes for each cable.
//!
//! Aᵀ f + w = 0 is brought to f_B + T f_N = d by elimination with complete pivoting, rows divided by their length; a
//! row whose remaining entries are below a millionth of its length counts as dependent, since poses are known no
//! better. Then the simplex method for variables within limits (Dantzig 1963, with Bland's rule, so that it ends) finds
//! tensions that keep the limits, and from there the least and the largest of each cable. Limits may be infinite, and
//! so may the ranges.

use nalgebra::DMatrix;

use super::InputError;

/// Entry, as a fraction of the row's length, below which a row depends on the rows before it.
const DEPENDENT: f64 = 1e-6;

/// Rounding of tensions, as a fraction of the largest number among load and limits.
const ROUNDING: f64 = 1e-10;

/// Rounding of reduced costs and pivots, whose rows have the length 1.
const FLAT: f64 = 1e-11;

/// Steps allowed for each programme, times the number of cables.
const STEPS: usize = 200;

/// Intervals of the tensions that balance a load.
#[derive(Clone, Debug, PartialEq)]
pub struct Intervals {
    /// Least and largest tension of each cable (N); infinite if it has no bound.
    pub ranges: Vec<[f64; 2]>,
    /// Dimension of the set of balanced tensions: number of cables less the rank of the structure matrix.
    pub freedom: usize,
}

/// The range of each tension within limits, one pair per cable (N); `None` if no tensions balance the wrench within
/// them.
///
/// The wrench has one component per row of the structure matrix (N, N·m). The least tensions must be finite, the
/// largest may be infinite.
pub fn intervals(
    structure_matrix: &DMatrix<f64>,
    wrench: &[f64],
    limits: &[[f64; 2]],
) -> Result<Option<Intervals>, InputError> {
    let (rows, columns) = structure_matrix.shape();
    if wrench.len() != rows {
        return Err(InputError::WrenchLength { expected: rows, found: wrench.len() });
    }
    if limits.len() != columns {
        return Err(InputError::LimitCount { expected: columns, found: limits.len() });
    }
    if !structure_matrix.iter().chain(wrench).all(|number| number.is_finite()) {
        return Err(InputError::NotFinite { what: "structure matrix or wrench" });
    }
    if !limits.iter().all(|[least, largest]| least.is_finite() && largest >= least) {
        return Err(InputError::NotFinite { what: "least tension" });
    }
    let Some(mut programme) = Programme::new(structure_matrix, wrench, limits) else { return Ok(None) };
    let freedom = columns - programme.basis.len();
    if !programme.enter_limits() {
        return Ok(None);
    }
    let ranges = (0..columns).map(|cable| [false, true].map(|largest| programme.extreme(cable, largest)));
    Ok(Some(Intervals { ranges: ranges.collect(), freedom }))
}

/// A linear programme at one of its corners.
struct Programme<'a> {
    limits: &'a [[f64; 2]],
    /// T, with the identity in the columns of the basis.
    table: DMatrix<f64>,
    /// Cable of each row.
    basis: Vec<usize>,
    tensions: Vec<f64>,
    /// Rounding of tensions (N).
    tolerance: f64,
}

impl<'a> Programme<'a> {
    /// The corner at which the cables outside the basis have their least tensions; `None` if dependent rows contradict
    /// each other.
    fn new(structure_matrix: &DMatrix<f64>, wrench: &[f64], limits: &'a [[f64; 2]]) -> Option<Self> {
        let (rows, columns) = structure_matrix.shape();
        let mut table = structure_matrix.clone().insert_column(columns, 0.0);
        for (row, load) in wrench.iter().enumerate() {
            table[(row, columns)] = -load;
            let length = structure_matrix.row(row).norm();
            if length > 0.0 {
                table.row_mut(row).iter_mut().for_each(|entry| *entry /= length);
            }
        }
        let of_limits = limits.iter().flatten().filter(|limit| limit.is_finite());
        let scale = of_limits.chain(table.column(columns).iter()).fold(0.0_f64, |most, number| most.max(number.abs()));
        let mut basis = Vec::new();
        while let Some((row, column)) = largest_below(&table, basis.len()) {
            table.swap_rows(row, basis.len());
            pivot(&mut table, basis.len(), column);
            basis.push(column);
        }
        let unbalanced = (basis.len()..rows).map(|row| table[(row, columns)].abs()).fold(0.0, f64::max);
        if unbalanced > DEPENDENT * scale {
            return None;
        }
        let mut tensions: Vec<f64> = limits.iter().map(|limit| limit[0]).collect();
        for (row, &cable) in basis.iter().enumerate() {
            let beside = (0..columns).filter(|other| !basis.contains(other));
            tensions[cable] = table[(row, columns)] - beside.map(|k| table[(row, k)] * tensions[k]).sum::<f64>();
        }
        let table = table.remove_column(columns).remove_rows(basis.len(), rows - basis.len());
        Some(Self { limits, table, basis, tensions, tolerance: ROUNDING * scale })
    }

    /// Moves to tensions within the limits; false if there are none.
    fn enter_limits(&mut self) -> bool {
        for _ in 0..STEPS * self.tensions.len() {
            let miss: Vec<f64> = self.basis.iter().map(|&cable| self.miss(cable)).collect();
            if miss.iter().all(|&miss| miss == 0.0) {
                return true;
            }
            // slope of the sum of all misses
            let slope = |k: usize| -(0..miss.len()).map(|row| miss[row] * self.table[(row, k)]).sum::<f64>();
            match self.entering(slope) {
                Some((cable, direction)) if self.go(cable, direction) => {}
                _ => return false,
            }
        }
        false
    }

    /// The least or largest tension of a cable, from tensions within the limits.
    fn extreme(&mut self, cable: usize, largest: bool) -> f64 {
        let sign = if largest { -1.0 } else { 1.0 };
        for _ in 0..STEPS * self.tensions.len() {
            let row = self.basis.iter().position(|&other| other == cable);
            let slope = |k: usize| match row {
                Some(row) => -sign * self.table[(row, k)],
                None => sign * f64::from(u8::from(k == cable)),
            };
            match self.entering(slope) {
                None => break,
                Some((other, direction)) if !self.go(other, direction) => return -sign * f64::INFINITY,
                Some(_) => {}
            }
        }
        let [least, most] = self.limits[cable];
        self.tensions[cable].clamp(least, most)
    }

    /// Side on which a tension misses its limits: −1 below, 1 above, 0 within.
    fn miss(&self, cable: usize) -> f64 {
        let [least, largest] = self.limits[cable];
        match self.tensions[cable] {
            f if f < least - self.tolerance => -1.0,
            f if f > largest + self.tolerance => 1.0,
            _ => 0.0,
        }
    }

    /// The first cable outside the basis whose tension improves the aim with this slope, and the sign of its change.
    fn entering(&self, slope: impl Fn(usize) -> f64) -> Option<(usize, f64)> {
        (0..self.tensions.len()).filter(|k| !self.basis.contains(k)).find_map(|k| {
            let [least, largest] = self.limits[k];
            let (slope, f) = (slope(k), self.tensions[k]);
            let rises = slope < -FLAT && f < largest;
            let falls = slope > FLAT && f > least;
            (rises || falls).then_some((k, -slope.signum()))
        })
    }

    /// Changes the tension of a cable outside the basis until a limit stops it; false if no limit does.
    fn go(&mut self, entering: usize, direction: f64) -> bool {
        let [least, largest] = self.limits[entering];
        let (mut way, mut stop) = (largest - least, None);
        for (row, &cable) in self.basis.iter().enumerate() {
            let rate = -direction * self.table[(row, entering)];
            let [least, largest] = self.limits[cable];
            // a tension beyond a limit stops there on its way back
            let limit = match (rate > FLAT, rate < -FLAT, self.miss(cable)) {
                (true, _, miss) if miss < 0.0 => least,
                (true, _, 0.0) => largest,
                (_, true, miss) if miss > 0.0 => largest,
                (_, true, 0.0) => least,
                _ => continue,
            };
            let until = ((limit - self.tensions[cable]) / rate).max(0.0);
            let is_first = stop.is_none_or(|(other, _): (usize, f64)| cable < self.basis[other]);
            if until < way || (until == way && is_first) {
                (way, stop) = (until, Some((row, limit)));
            }
        }
        if !way.is_finite() {
            return false;
        }
        for (row, &cable) in self.basis.iter().enumerate() {
            self.tensions[cable] -= way * direction * self.table[(row, entering)];
        }
        self.tensions[entering] += way * direction;
        match stop {
            None => self.tensions[entering] = if direction > 0.0 { largest } else { least },
            Some((row, limit)) => {
                self.tensions[self.basis[row]] = limit;
                pivot(&mut self.table, row, entering);
                self.basis[row] = entering;
            }
        }
        true
    }
}

/// Row and column of the largest entry from row `first` on, without the last column; `None` if it is at most
/// `DEPENDENT`.
fn largest_below(table: &DMatrix<f64>, first: usize) -> Option<(usize, usize)> {
    let places = (first..table.nrows()).flat_map(|row| (0..table.ncols() - 1).map(move |column| (row, column)));
    let best = places.max_by(|a, b| table[*a].abs().total_cmp(&table[*b].abs()))?;
    (table[best].abs() > DEPENDENT).then_some(best)
}

/// Turns a column into that of the identity, with its 1 in this row.
fn pivot(table: &mut DMatrix<f64>, row: usize, column: usize) {
    let factor = 1.0 / table[(row, column)];
    table.row_mut(row).iter_mut().for_each(|entry| *entry *= factor);
    for other in (0..table.nrows()).filter(|&other| other != row) {
        let fraction = table[(other, column)];
        for k in 0..table.ncols() {
            let taken = fraction * table[(row, k)];
            table[(other, k)] -= taken;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The wrench that tensions balance.
    fn wrench(matrix: &DMatrix<f64>, tensions: &[f64]) -> Vec<f64> {
        (-matrix * nalgebra::DVector::from_column_slice(tensions)).as_slice().to_vec()
    }

    /// The cube of oKermorgant: four cables on a platform of six degrees of freedom; three columns of its structure
    /// matrix are independent.
    fn cube() -> (DMatrix<f64>, Vec<f64>) {
        let corners = [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]];
        let column = |[x, y]: [f64; 2]| {
            let anchor = nalgebra::Vector3::new(0.2 * x, 0.2 * y, 0.0);
            let along = nalgebra::Vector3::new(1.8 * x, 1.8 * y, 2.0).normalize();
            let moment = anchor.cross(&along);
            nalgebra::DVector::from_column_slice(&[along.x, along.y, along.z, moment.x, moment.y, moment.z])
        };
        (DMatrix::from_columns(&corners.map(column)), vec![0.0, 0.0, -9.81, 0.0, 0.0, 0.0])
    }

    #[test]
    fn diagonal_cables_of_a_cube_share_the_weight_as_they_like() {
        let (matrix, wrench) = cube();
        let found = intervals(&matrix, &wrench, &[[0.0, f64::INFINITY]; 4]).unwrap().unwrap();
        assert_eq!(found.freedom, 1);
        // f₁ = f₃, f₂ = f₄, f₁ + f₂ = m g q/(2 h)
        let both = 9.81 * (2.0 * 1.8_f64.powi(2) + 4.0).sqrt() / 4.0;
        assert!((both - 7.939).abs() < 5e-4);
        for range in found.ranges {
            assert!(range[0].abs() < 1e-12 && (range[1] - both).abs() < 1e-9, "{range:?}");
        }
        let within =
            intervals(&matrix, &wrench, &[[1.0, 5.0], [0.0, 100.0], [0.0, 4.0], [0.0, 100.0]]).unwrap().unwrap();
        assert!((within.ranges[0][1] - 4.0).abs() < 1e-9 && (within.ranges[1][0] - (both - 4.0)).abs() < 1e-9);
        assert!((within.ranges[3][1] - (both - 1.0)).abs() < 1e-9, "{within:?}");
        assert_eq!(intervals(&matrix, &wrench, &[[5.0, 100.0]; 4]).unwrap(), None);
        let sideways = [1.0, 0.0, -9.81, 0.0, 0.0, 0.0];
        assert_eq!(intervals(&matrix, &sideways, &[[0.0, f64::INFINITY]; 4]).unwrap(), None);
    }

    #[test]
    fn cables_that_pull_against_each_other_have_no_largest_tension() {
        let matrix = DMatrix::from_row_slice(1, 3, &[1.0, -1.0, 0.0]);
        let found =
            intervals(&matrix, &[5.0], &[[2.0, f64::INFINITY], [0.0, f64::INFINITY], [3.0, 4.0]]).unwrap().unwrap();
        assert_eq!(found.ranges, [[2.0, f64::INFINITY], [7.0, f64::INFINITY], [3.0, 4.0]]);
        assert_eq!(found.freedom, 2);
    }

    /// Ends of random allowed sets against all their corners.
    #[test]
    fn intervals_are_those_of_all_corners() {
        let mut state = 7_u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        for _ in 0..200 {
            let matrix = DMatrix::from_fn(3, 6, |_, _| 2.0 * number() - 1.0);
            let limits: Vec<[f64; 2]> = (0..6).map(|_| [number(), 2.0 + number()]).collect();
            let inside: Vec<f64> = limits.iter().map(|[least, most]| least + number() * (most - least)).collect();
            let wrench = wrench(&matrix, &inside);
            let found = intervals(&matrix, &wrench, &limits).unwrap().unwrap();
            let mut ends = vec![[f64::INFINITY, f64::NEG_INFINITY]; 6];
            for corner in corners(&matrix, &wrench, &limits) {
                ends.iter_mut().zip(corner).for_each(|(end, f)| *end = [end[0].min(f), end[1].max(f)]);
            }
            for (found, end) in found.ranges.iter().zip(ends) {
                // rounding of a system of three equations
                assert!((found[0] - end[0]).abs() < 1e-8 && (found[1] - end[1]).abs() < 1e-8, "{found:?} {end:?}");
            }
        }
    }

    /// Corners of the allowed tensions: three of six at a limit, the others by balance.
    fn corners(matrix: &DMatrix<f64>, wrench: &[f64], limits: &[[f64; 2]]) -> Vec<Vec<f64>> {
        let mut found = Vec::new();
        for chosen in (0_u32..64).filter(|chosen| chosen.count_ones() == 3) {
            let (fixed, free): (Vec<usize>, Vec<usize>) = (0..6).partition(|k| chosen & (1 << k) != 0);
            for sides in 0..8 {
                let mut f = vec![0.0; 6];
                fixed.iter().enumerate().for_each(|(place, &k)| f[k] = limits[k][(sides >> place) & 1]);
                let right =
                    -nalgebra::DVector::from_column_slice(wrench) - matrix * nalgebra::DVector::from_column_slice(&f);
                let Some(free_tensions) = matrix.select_columns(&free).lu().solve(&right) else { continue };
                free.iter().zip(free_tensions.iter()).for_each(|(&k, &value)| f[k] = value);
                if f.iter().zip(limits).all(|(f, limit)| *f >= limit[0] - 1e-10 && *f <= limit[1] + 1e-10) {
                    found.push(f);
                }
            }
        }
        found
    }
}
