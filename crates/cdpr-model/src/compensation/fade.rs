//! Fading from 1 to 0 with a continuous slope.

/// Fraction that remains at this part of a margin: 1 before it, 0 behind it, (1 − t)² (1 + 2t) = 1 − 3t² + 2t³ between.
pub(super) fn left(part: f64) -> f64 {
    let t = part.clamp(0.0, 1.0);
    (1.0 - t) * (1.0 - t) * (1.0 + 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Value and slope −6t (1 − t) are continuous at both ends; outside of them the value is constant.
    #[test]
    fn what_is_left_falls_from_one_to_zero_without_a_corner() {
        assert_eq!([-1.0, 0.0, 0.5, 1.0, 7.0, f64::INFINITY].map(left), [1.0, 1.0, 0.5, 0.0, 0.0, 0.0]);
        let h = 1e-5;
        for step in -20..=120 {
            let t = 0.01 * f64::from(step);
            let slope = (left(t + h) - left(t - h)) / (2.0 * h);
            let expected = if (0.0..=1.0).contains(&t) { -6.0 * t * (1.0 - t) } else { 0.0 };
            // at the two ends the second derivative jumps by 6, of which a difference sees a quarter of h
            assert!((slope - expected).abs() < 6.0 * h, "{t}: {slope} {expected}");
        }
    }
}
