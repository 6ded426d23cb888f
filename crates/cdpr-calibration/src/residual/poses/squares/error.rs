//! Errors of eight predicted poses.

use super::cable::PoseLines;
use cdpr_model::scalar::{Lanes, Real, cross};

/// Largest sine of half an angle for which the series below are exact to rounding.
const SMALL: f64 = 0.1;

/// asin(s)/s by powers of s².
const ARC_SINE: [f64; 9] = [
    1.0,
    1.0 / 6.0,
    3.0 / 40.0,
    15.0 / 336.0,
    105.0 / 3456.0,
    945.0 / 42240.0,
    10395.0 / 599_040.0,
    135_135.0 / 9_676_800.0,
    2_027_025.0 / 175_472_640.0,
];

/// (1 − θ/2 cot(θ/2))/θ² by powers of θ².
const TURN: [f64; 5] = [1.0 / 12.0, 1.0 / 720.0, 1.0 / 30_240.0, 1.0 / 1_209_600.0, 1.0 / 47_900_160.0];

/// Displacements \[δr; δφ\] from measured to predicted poses (m, rad).
pub(super) struct Error<L> {
    pub(super) vector: [L; 6],
}

impl<L: Lanes> Error<L> {
    /// `None` if a rotation is too large.
    #[inline(always)]
    pub(super) fn of(l: L, measured: &PoseLines, predicted: &[L; 7]) -> Option<Self> {
        let mut from = [l; 7];
        for row in 0..7 {
            from[row] = l.load(&measured[row].0);
        }
        let [x, y, z, a, b, c, d] = from;
        let [p_x, p_y, p_z, i, j, k, w] = *predicted;
        // predicted after the inverse of the measured rotation
        let turned = cross([a, b, c], [i, j, k]);
        let vector = [i * d - w * a + turned[0], j * d - w * b + turned[1], k * d - w * c + turned[2]];
        let cosine = w * d + (i * a + j * b + k * c);
        let one = l.constant(1.0);
        let sign = l.constant(-1.0).select(cosine.is_less(l.constant(0.0)), one);
        let square = vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2];
        let is_small = square.is_less(l.constant(SMALL * SMALL));
        if l.any(l.without(l.everywhere(true), is_small)) {
            return None;
        }
        let factor = l.constant(2.0) * sign * series(square, &ARC_SINE);
        Some(Self { vector: [p_x - x, p_y - y, p_z - z, factor * vector[0], factor * vector[1], factor * vector[2]] })
    }

    /// Change of the rotation vectors with a turn of the predicted poses (world): the inverse of the left Jacobian of SO(3), by rows.
    #[inline(always)]
    pub(super) fn by_turn(&self) -> [[L; 3]; 3] {
        let [.., x, y, z] = self.vector;
        let (xx, yy, zz) = (x * x, y * y, z * z);
        let second = series(xx + yy + zz, &TURN);
        let (half, one) = (x.constant(0.5), x.constant(1.0));
        let (xy, yz, zx) = (second * x * y, second * y * z, second * z * x);
        [
            [one - second * (yy + zz), xy + half * z, zx - half * y],
            [xy - half * z, one - second * (zz + xx), yz + half * x],
            [zx + half * y, yz - half * x, one - second * (xx + yy)],
        ]
    }
}

/// Σ cᵢ xⁱ.
#[inline(always)]
fn series<T: Real, const N: usize>(x: T, coefficients: &[f64; N]) -> T {
    let mut sum = x.constant(coefficients[N - 1]);
    for k in (0..N - 1).rev() {
        sum = sum * x + x.constant(coefficients[k]);
    }
    sum
}
