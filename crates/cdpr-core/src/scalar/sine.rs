//! Sine and cosine of an angle, one formula for every width.

use super::Select;

/// π/2 in three pieces of 33 bits: products with whole numbers below 2²⁰ are exact (Cody and Waite, 1980).
const QUARTER_TURN: [f64; 3] = [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21];
/// Quarter turns in a radian.
const QUARTER_TURNS: f64 = core::f64::consts::FRAC_2_PI;
/// A number that is added and subtracted again is rounded to the nearest whole one: 1.5 · 2⁵².
const ROUNDING: f64 = 6_755_399_441_055_744.0;

/// Polynomial S with sin(r) = r + r³ S(r²) for |r| ≤ π/4, lowest power first (Chebyshev interpolation; error of the sine below 1e-17).
const SINE: [f64; 6] = [
    -0.166_666_666_666_666_66,
    0.008_333_333_333_330_948,
    -0.000_198_412_698_367_567_74,
    2.755_731_610_161_787_4e-6,
    -2.505_113_165_023_518e-8,
    1.591_811_526_326_597_4e-10,
];
/// Polynomial C with cos(r) = 1 − r²/2 + r⁴ C(r²) for |r| ≤ π/4, lowest power first (error of the cosine below 1e-18).
const COSINE: [f64; 6] = [
    0.041_666_666_666_666_664,
    -0.001_388_888_888_888_739_8,
    2.480_158_729_876_456e-5,
    -2.755_731_727_114_514_4e-7,
    2.087_614_614_655_861e-9,
    -1.138_262_364_747_460_4e-11,
];

/// Angles up to this amount (rad) are served by [`sin_cos`]; beyond, whole turns are lost.
pub const SINE_LIMIT: f64 = 524_288.0;

/// Sine and cosine of an angle (rad) of amount up to [`SINE_LIMIT`], each within 2.3e-16 of the truth; NaN of a NaN.
///
/// Every vector unit and a single number give the same bits.
#[inline(always)]
pub fn sin_cos<T: Select>(angle: T) -> (T, T) {
    let (zero, one, rounding) = (angle.constant(0.0), angle.constant(1.0), angle.constant(ROUNDING));
    let turns = (angle * angle.constant(QUARTER_TURNS) + rounding) - rounding;
    let [high, middle, low] = QUARTER_TURN;
    let r = ((angle - turns * angle.constant(high)) - turns * angle.constant(middle)) - turns * angle.constant(low);

    let square = r * r;
    let sine = r + r * square * polynomial(square, SINE);
    let cosine = one - (square * angle.constant(0.5) - square * square * polynomial(square, COSINE));

    // the fraction left of quarter turns divided by four: 0, 1/4, ±1/2, −1/4 in the four quadrants
    let whole = turns * angle.constant(0.25);
    let quadrant = whole - ((whole + rounding) - rounding);
    let (little, much) = (angle.constant(0.125), angle.constant(0.375));
    let is_odd = angle.both(little.is_less(quadrant.abs()), quadrant.abs().is_less(much));
    let (swapped_sine, swapped_cosine) = (cosine.select(is_odd, sine), sine.select(is_odd, cosine));
    let sine_is_negative = angle.either(quadrant.is_less(-little), much.is_less(quadrant));
    let cosine_is_negative = angle.either(little.is_less(quadrant), quadrant.is_less(-much));
    (
        (zero - swapped_sine).select(sine_is_negative, swapped_sine),
        (zero - swapped_cosine).select(cosine_is_negative, swapped_cosine),
    )
}

#[inline(always)]
fn polynomial<T: Select>(z: T, c: [f64; 6]) -> T {
    let second = z * z;
    let low = (z.constant(c[0]) + z.constant(c[1]) * z) + (z.constant(c[2]) + z.constant(c[3]) * z) * second;
    low + (z.constant(c[4]) + z.constant(c[5]) * z) * (second * second)
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::scalar::{Kernel, LANES, Lanes, Unit, dispatch_on};

    fn worst(angles: impl Iterator<Item = f64>) -> f64 {
        let apart = |angle: f64| {
            let (sine, cosine) = sin_cos(angle);
            let (expected_sine, expected_cosine) = angle.sin_cos();
            f64::max((sine - expected_sine).abs(), (cosine - expected_cosine).abs())
        };
        angles.map(apart).fold(0.0, f64::max)
    }

    #[test]
    fn sine_and_cosine_are_those_of_the_standard_library_to_an_ulp_of_one() {
        let mut generator = ChaCha8Rng::seed_from_u64(5);
        for largest in [0.01, 1.0, 4.0, 100.0, 1e4, SINE_LIMIT] {
            let angles: Vec<f64> = (0..200_000).map(|_| generator.random_range(-largest..largest)).collect();
            assert!(worst(angles.into_iter()) <= 2.3e-16, "angles up to {largest}");
        }
    }

    #[test]
    fn sine_and_cosine_are_right_next_to_every_quarter_turn() {
        let near = (-4000..4000).flat_map(|quarter| {
            let angle = f64::from(quarter) * FRAC_PI_2;
            [-1e-3, -1e-12, 0.0, 1e-15, 1e-6].map(|more| angle + more)
        });
        assert!(worst(near) <= 2.3e-16);
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
        assert!(sin_cos(f64::NAN).0.is_nan() && sin_cos(f64::NAN).1.is_nan());
        assert_eq!(sin_cos(-PI).1, -1.0);
    }

    struct Eight<'a>(&'a [f64]);

    impl Kernel for Eight<'_> {
        type Output = Vec<[f64; 2 * LANES]>;

        #[inline(always)]
        fn run<L: Lanes>(self, lanes: L) -> Self::Output {
            let mut all = Vec::new();
            for angles in self.0.chunks_exact(LANES) {
                let (sine, cosine) = sin_cos(lanes.load(angles));
                let mut both = [0.0; 2 * LANES];
                sine.store(&mut both);
                cosine.store(&mut both[LANES..]);
                all.push(both);
            }
            all
        }
    }

    #[test]
    fn every_vector_unit_gives_the_bits_of_the_single_number() {
        let mut generator = ChaCha8Rng::seed_from_u64(6);
        let angles: Vec<f64> = (0..8000).map(|_| generator.random_range(-50.0..50.0)).collect();
        for unit in Unit::available() {
            for (eight, angles) in dispatch_on(unit, Eight(&angles)).unwrap().iter().zip(angles.chunks_exact(LANES)) {
                for (lane, &angle) in angles.iter().enumerate() {
                    let (sine, cosine) = sin_cos(angle);
                    assert_eq!(
                        [eight[lane].to_bits(), eight[LANES + lane].to_bits()],
                        [sine, cosine].map(f64::to_bits)
                    );
                }
            }
        }
    }
}
