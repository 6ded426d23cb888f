//! Vectors over cables in blocks of eight, padded with zeros, so that the compiler puts them into vector registers.

use crate::scalar::LANES;

/// Eight numbers that are computed together.
pub(in crate::tension) type Block = [f64; LANES];

/// Masks of a block: mask k has zeros before lane k and ones from there on.
pub(super) const KEEP: [Block; LANES + 1] = {
    let mut rows = [[0.0; LANES]; LANES + 1];
    let mut k = 0;
    while k < LANES {
        let mut lane = k;
        while lane < LANES {
            rows[k][lane] = 1.0;
            lane += 1;
        }
        k += 1;
    }
    rows
};

/// Unit vectors.
pub(super) const UNIT: [Block; LANES] = {
    let mut rows = [[0.0; LANES]; LANES];
    let mut k = 0;
    while k < LANES {
        rows[k][k] = 1.0;
        k += 1;
    }
    rows
};

pub(super) fn dot(a: &[Block], b: &[Block]) -> f64 {
    let mut sum = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for k in 0..LANES {
            sum[k] += a[k] * b[k];
        }
    }
    ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]))
}

/// target += factor · source
pub(super) fn add_scaled(target: &mut [Block], factor: f64, source: &[Block]) {
    for (target, source) in target.iter_mut().zip(source) {
        for k in 0..LANES {
            target[k] += factor * source[k];
        }
    }
}

/// (a, b) ← (cos a + sin b, cos b − sin a)
pub(super) fn rotate(a: &mut [Block], b: &mut [Block], [cos, sin]: [f64; 2]) {
    for (a, b) in a.iter_mut().zip(b) {
        for k in 0..LANES {
            let (first, second) = (a[k], b[k]);
            a[k] = cos * first + sin * second;
            b[k] = cos * second - sin * first;
        }
    }
}

/// Copies numbers to the front and fills the remaining entries with zeros.
pub(super) fn fill(target: &mut [Block], source: impl Iterator<Item = f64>) {
    target.fill([0.0; LANES]);
    for (target, source) in target.as_flattened_mut().iter_mut().zip(source) {
        *target = source;
    }
}
