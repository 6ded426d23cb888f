//! Quantiles of Student's t distribution: half widths of 95 % intervals, in standard deviations that residuals tell.

/// Half width of a 95 % interval of a normal distribution, in standard deviations.
pub(super) const NORMAL_95: f64 = 1.959_964;

/// 97.5 % quantiles for one and two degrees of freedom.
const FEW: [f64; 2] = [12.706_205, 4.302_653];

/// Half width of a 95 % interval in standard deviations that so many degrees of freedom tell, t at 97.5 %, within 0.12 %.
///
/// The expansion of Cornish and Fisher about the normal quantile (Abramowitz and Stegun 1964, 26.7.5); [`NORMAL_95`] without end.
pub(super) fn t_95(freedom: usize) -> f64 {
    match freedom {
        // nothing tells
        0 => f64::INFINITY,
        1 | 2 => FEW[freedom - 1],
        _ => {
            let (z, n) = (NORMAL_95, freedom as f64);
            let [z3, z5, z7, z9] = [3, 5, 7, 9].map(|power| z.powi(power));
            let terms = [
                (z3 + z) / 4.0,
                (5.0 * z5 + 16.0 * z3 + 3.0 * z) / 96.0,
                (3.0 * z7 + 19.0 * z5 + 17.0 * z3 - 15.0 * z) / 384.0,
                (79.0 * z9 + 776.0 * z7 + 1482.0 * z5 - 1920.0 * z3 - 945.0 * z) / 92160.0,
            ];
            terms.iter().rev().fold(0.0, |sum, term| (sum + term) / n) + z
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Printed tables of the distribution.
    #[test]
    fn quantiles_are_those_of_the_tables() {
        let printed = [
            (1, 12.7062),
            (2, 4.3027),
            (3, 3.1824),
            (4, 2.7764),
            (5, 2.5706),
            (7, 2.3646),
            (10, 2.2281),
            (30, 2.0423),
            (120, 1.9799),
            (1_000_000, 1.959_966),
        ];
        for (freedom, expected) in printed {
            let found = t_95(freedom);
            assert!((found / expected - 1.0).abs() < 1.2e-3, "{freedom}: {found} instead of {expected}");
        }
    }
}
