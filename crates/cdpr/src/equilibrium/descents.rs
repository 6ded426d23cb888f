//! What eight descents side by side share; flags are 1 or 0.

use crate::geometry::POSE_ROWS;
use crate::scalar::{LANES, Lanes, Line};

/// 1 where the mask holds, else 0.
#[inline(always)]
pub(super) fn flag<L: Lanes>(l: L, mask: L::Mask) -> L {
    l.constant(1.0).select(mask, l.constant(0.0))
}

/// 1 where what the remaining steps add up to, if they go on shrinking at this rate, is below the tolerance.
#[inline(always)]
pub(super) fn settles<L: Lanes>(size: L, contraction: L, tolerance: L) -> L {
    let one = size.constant(1.0);
    let shrinks = flag(size, contraction.is_less(size.constant(0.5)));
    let rest = one - flag(size, (tolerance * (one - contraction)).is_less(size * contraction));
    let is_tiny = one - flag(size, (size.constant(1e-3) * tolerance).is_less(size));
    (shrinks * rest).max(is_tiny)
}

/// Pose after a step, with the bits of the single descent's.
#[inline(always)]
pub(super) fn displaced<L: Lanes>(lanes: L, pose: &[Line; POSE_ROWS], step: &[L; 6]) -> [Line; POSE_ROWS] {
    let mut trial = *pose;
    for axis in 0..3 {
        (lanes.load(&pose[axis].0) + step[axis]).store(&mut trial[axis].0);
    }
    let half = lanes.constant(0.5);
    let (x, y, z) = (half * step[3], half * step[4], half * step[5]);
    let (i, j) = (lanes.load(&pose[3].0), lanes.load(&pose[4].0));
    let (k, w) = (lanes.load(&pose[5].0), lanes.load(&pose[6].0));
    let turned =
        [i + x * w + y * k - z * j, j - x * k + y * w + z * i, k + x * j - y * i + z * w, w - x * i - y * j - z * k];
    let [i, j, k, w] = turned;
    let norm = ((i * i + k * k) + (j * j + w * w)).sqrt();
    for entry in 0..4 {
        (turned[entry] / norm).store(&mut trial[3 + entry].0);
    }
    trial
}

/// Σ over cables of a · b, in the order of [`Lanes::sum`].
#[inline(always)]
pub(super) fn product<L: Lanes>(a: &[L; LANES], b: &[L; LANES]) -> L {
    ((a[0] * b[0] + a[4] * b[4]) + (a[1] * b[1] + a[5] * b[5]))
        + ((a[2] * b[2] + a[6] * b[6]) + (a[3] * b[3] + a[7] * b[7]))
}

/// Sum over cables in the order of [`Lanes::sum`].
#[inline(always)]
pub(super) fn sum<L: Lanes>(a: [L; LANES]) -> L {
    ((a[0] + a[4]) + (a[1] + a[5])) + ((a[2] + a[6]) + (a[3] + a[7]))
}
