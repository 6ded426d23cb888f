//! The angle of a plane vector in [0, 2π), one formula for every width.

use super::Select;

/// π/4 with its last 13 bits cut off, so that its product with a whole number up to 8 is exact.
const EIGHTH_TURN_HIGH: f64 = 0.785_398_163_397_076_1;
/// Remainder of π/4 beyond [`EIGHTH_TURN_HIGH`].
const EIGHTH_TURN_LOW: f64 = 3.721_773_740_243_311_6e-13;

/// Polynomial P with atan(t) = t + t³ P(t²) for |t| ≤ 1/2, lowest power first; relative error of atan below 1e-17
/// (Remez iteration on t² in [0, 0.25], coefficients rounded).
const ATAN: [f64; 12] = [
    -0.333_333_333_333_333,
    0.199_999_999_999_738_78,
    -0.142_857_142_818_636_15,
    0.111_111_108_717_529_51,
    -0.090_909_010_355_158_7,
    0.076_921_421_962_086_5,
    -0.066_644_502_124_156_28,
    0.058_622_937_041_434_925,
    -0.051_384_884_143_925_34,
    0.042_296_510_092_245_03,
    -0.028_084_134_625_442_597,
    0.010_544_436_150_917_267,
];

/// Angle of the vector (`x`, `y`), counted from the first axis, in [0, 2π) (rad).
///
/// The vector (0, 0) has the angle 0; NaN in either component gives NaN, and so do two infinities. Magnitudes beyond
/// 8e307 are not supported: their sum overflows.
#[inline(always)]
pub(super) fn full_angle<T: Select>(y: T, x: T) -> T {
    let (zero, one, two) = (y.constant(0.0), y.constant(1.0), y.constant(2.0));
    // Fold into the first eighth of the turn: 0 ≤ low ≤ high. A NaN ends up in one of the two.
    let (width, height) = (x.abs(), y.abs());
    let steep = width.is_less(height);
    let low = width.min(height);
    let high = height.max(width);
    let high = one.select(high.is_less(y.constant(f64::from_bits(1))), high);

    // From tan = 1/2 on, turn back by π/4: |t| ≤ 1/2, with one division for both cases.
    let far = high.is_less(low + low);
    let above = (low - high).select(far, low);
    let under = (low + high).select(far, high);

    // Unfold: the angle is `eighths` π/4 + atan(t), and each mirroring reverses both. The signs are known before the
    // quotient.
    let eighths = one.select(far, zero);
    let (eighths, above) = ((two - eighths).select(steep, eighths), (-above).select(steep, above));
    let left = x.is_less(zero);
    let (eighths, above) = ((y.constant(4.0) - eighths).select(left, eighths), (-above).select(left, above));
    let below = y.is_less(zero);
    let (eighths, above) = ((y.constant(8.0) - eighths).select(below, eighths), (-above).select(below, above));

    let t = above / under;
    let square = t * t;
    let rest = eighths * y.constant(EIGHTH_TURN_LOW) + t * square * atan_polynomial(square);
    eighths * y.constant(EIGHTH_TURN_HIGH) + (t + rest)
}

/// P of [`ATAN`] as a quadratic in z⁴ of cubics in z: a short chain of dependent operations.
#[inline(always)]
fn atan_polynomial<T: Select>(z: T) -> T {
    let c = ATAN;
    let second = z * z;
    let fourth = second * second;
    let low = (z.constant(c[0]) + z.constant(c[1]) * z) + (z.constant(c[2]) + z.constant(c[3]) * z) * second;
    let middle = (z.constant(c[4]) + z.constant(c[5]) * z) + (z.constant(c[6]) + z.constant(c[7]) * z) * second;
    let high = (z.constant(c[8]) + z.constant(c[9]) * z) + (z.constant(c[10]) + z.constant(c[11]) * z) * second;
    low + (middle + high * fourth) * fourth
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI, TAU};

    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use crate::scalar::Real;

    /// Count of representable numbers between `full_angle` and the standard library's angle brought to [0, 2π).
    fn distance(y: f64, x: f64) -> u64 {
        let angle = y.full_angle(x);
        let standard = y.atan2(x);
        let expected = if y < 0.0 { standard + TAU } else { standard };
        assert!((0.0..=TAU).contains(&angle), "angle of ({x:e}, {y:e}) is {angle:e}");
        angle.to_bits().abs_diff(expected.to_bits())
    }

    /// Largest distance over the pairs (x, y).
    fn worst(pairs: impl Iterator<Item = (f64, f64)>) -> u64 {
        pairs.map(|(x, y)| distance(y, x)).max().expect("pairs")
    }

    #[test]
    fn full_angle_is_within_two_ulp_of_the_standard_library_all_around() {
        let steps = 400_000;
        let circle = (0..steps).map(|step| TAU * f64::from(step) / f64::from(steps)).map(|angle| angle.sin_cos());
        assert!(worst(circle.map(|(y, x)| (x, y))) <= 2);
        let ratios = (0..steps).map(|step| (1.0, f64::from(step) / f64::from(steps)));
        assert!(worst(ratios) <= 2);
    }

    #[test]
    fn full_angle_is_within_two_ulp_for_any_mixture_of_magnitudes_and_signs() {
        let mut generator = ChaCha8Rng::seed_from_u64(1);
        let mut signed = |largest: f64| {
            let magnitude = generator.random_range(-largest..largest);
            let mantissa: f64 = generator.random_range(-10.0..10.0);
            mantissa * 10f64.powf(magnitude)
        };
        for largest in [0.1, 3.0, 20.0, 306.0] {
            let pairs: Vec<_> = (0..100_000).map(|_| (signed(largest), signed(largest))).collect();
            assert!(worst(pairs.into_iter()) <= 2, "magnitudes up to 1e±{largest}");
        }
    }

    #[test]
    fn full_angle_is_the_rounded_truth_on_axes_and_diagonals() {
        for scale in [f64::from_bits(1), 1e-310, 1e-200, 0.3, 1.0, 7.0, 1e200, 8e307] {
            let expected = [
                (1.0, 0.0, 0.0),
                (1.0, -0.0, 0.0),
                (1.0, 1.0, FRAC_PI_4),
                (0.0, 1.0, FRAC_PI_2),
                (-0.0, 1.0, FRAC_PI_2),
                (-1.0, 1.0, 3.0 * FRAC_PI_4),
                (-1.0, 0.0, PI),
                (-1.0, -0.0, PI),
                (-1.0, -1.0, 5.0 * FRAC_PI_4),
                (0.0, -1.0, 3.0 * FRAC_PI_2),
                (1.0, -1.0, 7.0 * FRAC_PI_4),
            ];
            for (x, y, angle) in expected {
                assert_eq!((y * scale).full_angle(x * scale), angle, "direction ({x}, {y}) times {scale:e}");
            }
        }
    }

    #[test]
    fn full_angle_of_the_zero_vector_is_zero() {
        for (x, y) in [(0.0, 0.0), (-0.0, 0.0), (0.0, -0.0), (-0.0, -0.0)] {
            assert_eq!(f64::full_angle(y, x), 0.0);
        }
    }

    #[test]
    fn full_angle_of_a_vector_with_nan_is_nan() {
        for other in [0.0, -1.0, 1e300, f64::INFINITY, f64::NAN] {
            assert!(f64::NAN.full_angle(other).is_nan());
            assert!(other.full_angle(f64::NAN).is_nan());
        }
    }

    #[test]
    fn full_angle_just_below_the_first_axis_rounds_to_the_full_turn() {
        assert_eq!((-1e-300).full_angle(1.0), TAU);
    }
}
