//! Autocorrelation of consecutive samples: the number of independent ones among them.

/// Lag-one autocorrelation of a series, 0 for fewer than three values or a constant series.
pub(super) fn lag_one(series: &[f64]) -> f64 {
    lag(series, 1)
}

fn lag(series: &[f64], distance: usize) -> f64 {
    let count = series.len();
    if count < distance + 2 {
        return 0.0;
    }
    let mean = series.iter().sum::<f64>() / count as f64;
    let variance: f64 = series.iter().map(|x| (x - mean).powi(2)).sum();
    let products = series.iter().zip(&series[distance..]).map(|(a, b)| (a - mean) * (b - mean));
    if variance > 0.0 { products.sum::<f64>() / variance } else { 0.0 }
}

/// Integrated autocorrelation time τ = 1 + 2 Σ ρ_k, summed until the correlation disappears: N samples of the series tell
/// as much about a mean as N/τ independent ones. 1 unless the first lag differs from 0 by more than three standard errors.
pub(super) fn correlation_time(series: &[f64]) -> f64 {
    let count = series.len() as f64;
    if lag_one(series) < 3.0 / count.sqrt() {
        return 1.0;
    }
    let mut time = 1.0;
    for distance in 1..series.len() / 4 {
        let rho = lag(series, distance);
        // beyond the first zero the estimates are noise
        if rho <= 0.0 {
            break;
        }
        time += 2.0 * rho;
    }
    time
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};

    use super::*;

    fn autoregressive(rho: f64, count: usize) -> Vec<f64> {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(5);
        let mut value = 0.0;
        (0..count)
            .map(|_| {
                value = rho * value + rng.random_range(-1.0..1.0);
                value
            })
            .collect()
    }

    #[test]
    fn independent_samples_have_time_one() {
        assert_eq!(correlation_time(&autoregressive(0.0, 1000)), 1.0);
        assert_eq!(correlation_time(&[1.0; 50]), 1.0);
    }

    /// AR(1) has τ = (1 + ρ)/(1 − ρ) = 9 at ρ = 0.8; 20 000 samples estimate it within about 15 %.
    #[test]
    fn correlated_samples_have_the_time_of_their_process() {
        let time = correlation_time(&autoregressive(0.8, 20_000));
        assert!((time - 9.0).abs() < 1.5, "{time}");
    }
}
