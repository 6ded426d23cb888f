//! The number types that one formula serves: plain numbers, lanes of poses or cables, dual numbers.
//!
//! Per-cable geometry is written once over [`Real`]. `f64` gives the answer for one pose, [`Lanes`]
//! types the answer for eight at once, and the dual numbers of the tests check every analytic derivative.

mod angle;
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
mod avx2;
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
mod avx512;
mod dispatch;
#[cfg(any(feature = "dual", test))]
mod dual;
pub mod eigenvalue;
pub mod ldl;
mod portable;
mod select;
mod smooth;

use core::ops::{Add, Div, Mul, Neg, Sub};

#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
pub use avx2::Avx2;
#[cfg(all(feature = "vectors", target_arch = "x86_64"))]
pub use avx512::Avx512;
pub use dispatch::{Kernel, Unit, dispatch, dispatch_narrow, dispatch_on};
pub use portable::Portable;
pub use select::Select;
pub use smooth::Smooth;

/// A number that cable geometry can be computed with.
///
/// There is no fused multiply-add on purpose: every width then gives the same bits.
pub trait Real:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// The constant `x` in the number type (and vector unit) of `self`, whose value does not matter.
    fn constant(self, x: f64) -> Self;

    /// Square root; NaN below zero.
    fn sqrt(self) -> Self;

    /// Angle of the vector (`x`, `self`), counted from the first axis, in [0, 2π) (rad).
    fn full_angle(self, x: Self) -> Self;
}

/// Eight numbers that are computed at once, on the widest vector unit of the machine.
///
/// The types differ in the unit only: each operation gives the same bits on all of them and on `f64`.
pub trait Lanes: Select {
    /// The first eight entries of `source`; panics when it has fewer.
    fn load(self, source: &[f64]) -> Self;

    /// The eight numbers.
    fn to_array(self) -> [f64; LANES];

    /// Writes the eight numbers to the front of `target`; panics when it is shorter.
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

    /// The sums of four at once, each with the bits of [`Lanes::sum`] and all for little more than the price of one.
    #[inline(always)]
    fn sums(four: [Self; 4]) -> [f64; 4] {
        [four[0].sum(), four[1].sum(), four[2].sum(), four[3].sum()]
    }

    /// Runs a part of a kernel as a function of its own on the same vector unit. What several kernels share is compiled
    /// once for each unit instead of once for each place; a call costs a few nanoseconds.
    fn apart<K: Kernel>(self, part: K) -> K::Output;
}

/// How many numbers a [`Lanes`] type holds, on every machine.
pub const LANES: usize = 8;

impl Real for f64 {
    #[inline(always)]
    fn constant(self, x: f64) -> Self {
        x
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        num_traits::Float::sqrt(self)
    }

    #[inline(always)]
    fn full_angle(self, x: Self) -> Self {
        angle::full_angle(self, x)
    }
}

/// `a − b`.
#[inline(always)]
pub fn sub<T: Real>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `a + b`.
#[inline(always)]
pub fn add<T: Real>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// `a · b`.
#[inline(always)]
pub fn dot<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// `a × b`.
#[inline(always)]
pub fn cross<T: Real>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `s a`.
#[inline(always)]
pub fn scale<T: Real>(s: T, a: [T; 3]) -> [T; 3] {
    [s * a[0], s * a[1], s * a[2]]
}

/// `M a` for a matrix given by its rows.
#[inline(always)]
pub fn rotate<T: Real>(rows: &[[T; 3]; 3], a: [T; 3]) -> [T; 3] {
    [dot(rows[0], a), dot(rows[1], a), dot(rows[2], a)]
}

/// `Mᵀ a` for a matrix given by its rows.
#[inline(always)]
pub fn rotate_back<T: Real>(rows: &[[T; 3]; 3], a: [T; 3]) -> [T; 3] {
    let [x, y, z] = *rows;
    [
        a[0] * x[0] + a[1] * y[0] + a[2] * z[0],
        a[0] * x[1] + a[1] * y[1] + a[2] * z[1],
        a[0] * x[2] + a[1] * y[2] + a[2] * z[2],
    ]
}

/// A vector of plain numbers in the number type of `of`.
#[inline(always)]
pub fn constants<T: Real>(of: T, v: [f64; 3]) -> [T; 3] {
    [of.constant(v[0]), of.constant(v[1]), of.constant(v[2])]
}
