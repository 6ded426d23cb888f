//! Cubic pieces between knots: values, slopes, and their minima.

use std::ops::Sub;

/// Largest slope at a knot, relative to the chord: at 3 a piece may have a point of slope zero inside (Fritsch and
/// Carlson 1980).
const STEEPEST: f64 = 2.9;

/// Least slope at an end of the table, relative to the chord.
const FLATTEST: f64 = 0.05;

/// c₀ + c₁ x + c₂ x² + c₃ x³.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cubic(pub(crate) [f64; 4]);

impl Sub for Cubic {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] - other.0[k]))
    }
}

impl Cubic {
    /// The cubic over 0..width with these values and slopes at both ends.
    pub(crate) fn hermite(width: f64, [y0, y1]: [f64; 2], [m0, m1]: [f64; 2]) -> Self {
        let chord = (y1 - y0) / width;
        Self([y0, m0, (3.0 * chord - 2.0 * m0 - m1) / width, (m0 + m1 - 2.0 * chord) / (width * width)])
    }

    fn value(&self, x: f64) -> f64 {
        let [c0, c1, c2, c3] = self.0;
        c0 + x * (c1 + x * (c2 + x * c3))
    }

    fn slope(&self, x: f64) -> f64 {
        let [_, c1, c2, c3] = self.0;
        c1 + x * (2.0 * c2 + x * 3.0 * c3)
    }

    /// Position in 0..width of the least slope, and that slope; NaN counts as least.
    pub(crate) fn least_slope(&self, width: f64) -> (f64, f64) {
        let [_, _, c2, c3] = self.0;
        least(&[0.0, width, -c2 / (3.0 * c3)], width, |x| self.slope(x))
    }

    /// Position in 0..width of the least value, and that value.
    pub(crate) fn least_value(&self, width: f64) -> (f64, f64) {
        let [_, c1, c2, c3] = self.0;
        // roots of the slope c₁ + 2 c₂ x + 3 c₃ x²
        let root = (c2 * c2 - 3.0 * c1 * c3).max(0.0).sqrt();
        // the form without cancellation, and its partner by Vieta
        let sum = -(c2 + root.copysign(c2));
        least(&[0.0, width, sum / (3.0 * c3), c1 / sum], width, |x| self.value(x))
    }
}

/// The candidate in 0..width with the least value, and that value.
fn least(candidates: &[f64], width: f64, of: impl Fn(f64) -> f64) -> (f64, f64) {
    let inside = candidates.iter().copied().filter(|x| (0.0..=width).contains(x)).map(|x| (x, of(x)));
    inside.reduce(|a, b| if a.1 <= b.1 || a.1.is_nan() { a } else { b }).unwrap_or((0.0, f64::NAN))
}

/// Slopes at the knots with which the cubic pieces rise wherever the values do (Fritsch and Butland 1984).
pub(crate) fn rising_slopes(knots: &[f64], values: &[f64]) -> Vec<f64> {
    let widths: Vec<f64> = knots.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let chords: Vec<f64> = values.windows(2).zip(&widths).map(|(pair, width)| (pair[1] - pair[0]) / width).collect();
    let last = chords.len() - 1;
    if last == 0 {
        return vec![chords[0]; 2];
    }
    let end = |(h0, d0): (f64, f64), (h1, d1): (f64, f64)| {
        (((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)).max(FLATTEST * d0).min(STEEPEST * d0)
    };
    let inner = |k: usize| {
        let ((h0, d0), (h1, d1)) = ((widths[k - 1], chords[k - 1]), (widths[k], chords[k]));
        let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
        ((w0 + w1) / (w0 / d0 + w1 / d1)).min(STEEPEST * d0.min(d1))
    };
    let mut slopes = vec![end((widths[0], chords[0]), (widths[1], chords[1]))];
    slopes.extend((1..=last).map(inner));
    slopes.push(end((widths[last], chords[last]), (widths[last - 1], chords[last - 1])));
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_hermite_piece_has_its_values_and_slopes() {
        let piece = Cubic::hermite(0.5, [1.0, 4.0], [2.0, 3.0]);
        for (x, value, slope) in [(0.0, 1.0, 2.0), (0.5, 4.0, 3.0)] {
            assert!((piece.value(x) - value).abs() < 1e-14 && (piece.slope(x) - slope).abs() < 1e-13);
        }
    }

    #[test]
    fn least_slope_and_value_are_below_all_samples() {
        for piece in [Cubic([0.0, 1.0, -3.0, 2.5]), Cubic([1.0, -2.0, 0.0, 3.0]), Cubic([0.0, 1.0, 0.0, 0.0])] {
            let (slope, value) = (piece.least_slope(1.0).1, piece.least_value(1.0).1);
            for k in 0..=1000 {
                let x = f64::from(k) / 1000.0;
                assert!(slope <= piece.slope(x) + 1e-14 && value <= piece.value(x) + 1e-14, "{piece:?} at {x}");
            }
        }
    }

    #[test]
    fn interpolated_slopes_keep_every_piece_rising() {
        let knots = [0.0, 0.1, 0.9, 1.0, 1.05];
        let values = [0.0, 5.0, 5.1, 9.0, 30.0];
        let slopes = rising_slopes(&knots, &values);
        for k in 0..4 {
            let width = knots[k + 1] - knots[k];
            let piece = Cubic::hermite(width, [values[k], values[k + 1]], [slopes[k], slopes[k + 1]]);
            assert!(piece.least_slope(width).1 > 0.0, "piece {k}");
        }
    }
}
