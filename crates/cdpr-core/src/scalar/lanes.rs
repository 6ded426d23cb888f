//! Eight numbers side by side, and computations over them.

use super::select::Select;

/// Count of numbers that a [`Lanes`] type holds, on every machine.
pub const LANES: usize = 8;

/// Eight numbers computed at once, on the widest vector unit of the machine.
///
/// The types differ only in the vector unit: each operation gives the same bits on all of them and on `f64`.
pub trait Lanes: Select {
    /// The first eight entries of `source`; panics if it has fewer.
    fn load(self, source: &[f64]) -> Self;

    /// The eight numbers.
    fn to_array(self) -> [f64; LANES];

    /// Writes the eight numbers to the front of `target`; panics if it is shorter.
    #[inline(always)]
    fn store(self, target: &mut [f64]) {
        target[..LANES].copy_from_slice(&self.to_array());
    }

    /// Sum of the eight numbers, in an order that is the same on every vector unit.
    #[inline(always)]
    fn sum(self) -> f64 {
        let a = self.to_array();
        ((a[0] + a[4]) + (a[1] + a[5])) + ((a[2] + a[6]) + (a[3] + a[7]))
    }

    /// The sums of four values at once, each with the bits of [`Lanes::sum`], for little more than the cost of one.
    #[inline(always)]
    fn sums(four: [Self; 4]) -> [f64; 4] {
        [four[0].sum(), four[1].sum(), four[2].sum(), four[3].sum()]
    }

    /// Rows to columns: number k of row i becomes number i of row k.
    #[inline(always)]
    fn transposed(eight: &[Self; LANES]) -> [Self; LANES] {
        let mut columns = [[0.0; LANES]; LANES];
        for row in 0..LANES {
            let numbers = eight[row].to_array();
            for column in 0..LANES {
                columns[column][row] = numbers[column];
            }
        }
        let mut transposed = *eight;
        for column in 0..LANES {
            transposed[column] = eight[0].load(&columns[column]);
        }
        transposed
    }

    /// Runs a part of a kernel as a function of its own on the same vector unit. Code shared by several kernels is then
    /// compiled once for each unit instead of once for each call site; a call costs a few nanoseconds.
    fn apart<K: Kernel>(self, part: K) -> K::Output;
}

/// A computation over [`Lanes`]: its inputs are its fields, so that it can be handed to any vector unit.
///
/// `run` and every function below it that takes, returns or holds lanes must be `#[inline(always)]`, otherwise every
/// operation becomes a call (thirty times slower); functions of single numbers need not. Closures cannot be marked so:
/// write loops, and keep operations on lanes out of `map`, `array::from_fn` and the like. Read arrays of lanes by index
/// or by reference: taken by value, each entry becomes an `Option` in memory, written and read back in pieces (five
/// times slower).
///
/// ```
/// use cdpr_core::scalar::{Kernel, LANES, Lanes, Real, dispatch};
///
/// /// Distances from the origin to points in the plane (m); whole eights of points.
/// struct Distances<'a> {
///     x: &'a [f64],
///     y: &'a [f64],
///     distances: &'a mut [f64],
/// }
///
/// impl Kernel for Distances<'_> {
///     type Output = ();
///
///     #[inline(always)]
///     fn run<L: Lanes>(self, lanes: L) {
///         for start in (0..self.distances.len()).step_by(LANES) {
///             let (x, y) = (lanes.load(&self.x[start..]), lanes.load(&self.y[start..]));
///             (x * x + y * y).sqrt().store(&mut self.distances[start..]);
///         }
///     }
/// }
///
/// let mut distances = [0.0; 16];
/// dispatch(Distances { x: &[3.0; 16], y: &[4.0; 16], distances: &mut distances });
/// assert_eq!(distances, [5.0; 16]);
/// ```
pub trait Kernel {
    /// Type of the result.
    type Output;

    /// The computation; `lanes` is the source of further numbers (`constant`, `load`), and its value does not matter.
    fn run<L: Lanes>(self, lanes: L) -> Self::Output;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Unit, dispatch_on};

    /// Whether rows of eight different numbers become columns.
    struct Transposed;

    impl Kernel for Transposed {
        type Output = bool;

        #[inline(always)]
        fn run<L: Lanes>(self, lanes: L) -> bool {
            let number = |row: usize, column: usize| (LANES * row + column) as f64;
            let mut rows = [lanes; LANES];
            for row in 0..LANES {
                rows[row] = lanes.load(&core::array::from_fn::<f64, LANES, _>(|column| number(row, column)));
            }
            let columns = L::transposed(&rows);
            (0..LANES).all(|column| {
                columns[column].to_array() == core::array::from_fn::<f64, LANES, _>(|row| number(row, column))
            })
        }
    }

    #[test]
    fn rows_become_columns_on_every_vector_unit() {
        for unit in Unit::available() {
            assert!(dispatch_on(unit, Transposed).unwrap(), "{unit:?}");
        }
    }
}
