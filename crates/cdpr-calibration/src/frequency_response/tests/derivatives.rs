//! Derivatives against differences, and roots against the products that they make.

use nalgebra::Complex;
use std::f64::consts::TAU;

use crate::frequency_response::Transfer;

/// Four poles and three zeros with a delay, none of them near another.
fn functions() -> [Transfer; 3] {
    let of = |denominator: &[f64], numerator: &[f64], has_delay: bool| Transfer {
        gain: 3.0,
        delay: if has_delay { 0.01 } else { 0.0 },
        denominator: denominator.to_vec(),
        numerator: numerator.to_vec(),
        unit: 40.0,
        has_delay,
    };
    [
        of(&[0.9, 1.7, 0.6, 0.3], &[-0.4, 0.25, 0.05], true),
        of(&[0.4, 1.0], &[], false),
        of(&[2.0, 0.75, 0.05], &[0.3], true),
    ]
}

/// Central differences: truncation ~ h², rounding ~ ε/h; 1e-5 leaves 1e-10 of either.
const H: f64 = 1e-5;

#[test]
fn slopes_by_parameters_and_by_frequency_are_those_of_differences() {
    for transfer in functions() {
        let values = transfer.parameters();
        for frequency in [0.3, 4.0, 9.0, 40.0] {
            let slopes = transfer.slopes(frequency);
            for (k, slope) in slopes.iter().enumerate() {
                let at = |by: f64| {
                    let mut moved = values.clone();
                    moved[k] += by;
                    transfer.with(&moved).response(frequency)
                };
                let difference = (at(H) - at(-H)) / (2.0 * H) / transfer.response(frequency);
                let error = (slope - difference).norm();
                assert!(error < 1e-8 * (1.0 + slope.norm()), "parameter {k} at {frequency} Hz: {error:.1e}");
            }
            let h = H * frequency;
            let ratio = transfer.response(frequency + h) / transfer.response(frequency - h);
            let error = (transfer.logarithmic_slope(frequency) - ratio.ln() / (2.0 * h)).norm();
            assert!(error < 1e-8 * (1.0 + transfer.logarithmic_slope(frequency).norm()), "{frequency} Hz: {error:.1e}");
        }
    }
}

#[test]
fn slopes_of_roots_are_those_of_differences() {
    for transfer in functions() {
        let values = transfer.parameters();
        for k in 0..values.len() {
            let moved = |by: f64| {
                let mut moved = values.clone();
                moved[k] += by;
                transfer.with(&moved)
            };
            let (ahead, behind) = (moved(H), moved(-H));
            let all = [
                (ahead.poles(), behind.poles(), transfer.pole_slopes()),
                (ahead.zeros(), behind.zeros(), transfer.zero_slopes()),
            ];
            for (ahead, behind, slopes) in all {
                for ((ahead, behind), row) in ahead.iter().zip(&behind).zip(&slopes) {
                    let difference = (ahead - behind) / (2.0 * H);
                    let error = (row[k] - difference).norm();
                    assert!(error < 1e-6 * (1.0 + row[k].norm()), "parameter {k}: {} is {difference}", row[k]);
                }
            }
        }
    }
}

/// The response is gain · e^(−s T) · ∏(1 − s/zero) / ∏(1 − s/pole), and a pair stands side by side.
#[test]
fn a_response_is_the_product_of_its_roots() {
    for transfer in functions() {
        for frequency in [0.3_f64, 4.0, 40.0] {
            let s = Complex::new(0.0, TAU * frequency);
            let product = |roots: Vec<Complex<f64>>| roots.iter().map(|root| 1.0 - s / root).product::<Complex<f64>>();
            let expected = product(transfer.zeros()) / product(transfer.poles()) * 3.0 * (-s * transfer.delay).exp();
            let found = transfer.response(frequency);
            assert!((found - expected).norm() < 1e-11 * found.norm(), "{found} instead of {expected}");
        }
        for pair in transfer.poles().windows(2).filter(|pair| pair[0].im > 0.0) {
            assert!((pair[0] - pair[1].conj()).norm() < 1e-9 * pair[0].norm());
        }
    }
}
