//! Vectors and rotations in space, as arrays of any number.

use super::real::Real;

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
