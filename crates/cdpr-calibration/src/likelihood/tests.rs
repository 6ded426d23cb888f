use std::f64::consts::TAU;

use super::{Information, NoiseSource, information};
use crate::fit::{Fit, Prior, Settings, fit};
use crate::loss::Loss;
use crate::recorded_curves::{SIGMA, curve, noisy, points};
use cdpr_model::measurement::Samples;
use cdpr_model::model::FreeParameters;
use cdpr_model::robot::ParameterKind;

/// Lengths with an offset of the cables' numbers (mm).
fn samples(count: usize, seed: u64, stated: Option<f64>) -> Samples {
    noisy(&points(), curve(&points(), count, 0.0), seed, stated, 1e-3)
}

fn fitted(samples: &Samples, free: &str, settings: &Settings) -> Fit {
    let free: FreeParameters = free.parse().unwrap();
    fit(&points(), samples, &free, settings).unwrap()
}

fn of(fits: &[&Fit], loss: Loss) -> Vec<Information> {
    information(points().robot(), fits, loss).into_iter().flatten().collect()
}

/// Residual sum of squares of a regression on a constant, from the raw lengths; without offsets that of the lengths themselves.
fn sum_of_squares(samples: &Samples, with_offsets: bool) -> f64 {
    let model = points();
    let modelled: Vec<Vec<f64>> = samples.poses.iter().map(|pose| model.cable_lengths(pose).unwrap()).collect();
    let rest = |sample: usize, cable: usize| samples.lengths[8 * sample + cable] - modelled[sample][cable];
    let count = samples.len();
    let of_cable = |cable: usize| {
        let mean = (0..count).map(|sample| rest(sample, cable)).sum::<f64>() / count as f64;
        let middle = if with_offsets { mean } else { 0.0 };
        (0..count).map(|sample| (rest(sample, cable) - middle).powi(2)).sum::<f64>()
    };
    (0..8).map(of_cable).sum()
}

/// Offsets alone are a linear regression: the textbook's criteria follow from its sum of squares, noise known.
#[test]
fn a_linear_problem_has_the_textbooks_criteria() {
    let samples = samples(30, 1, Some(SIGMA));
    let squared = Settings { loss: Loss::Squared, ..Settings::default() };
    let (plain, offsets) = (fitted(&samples, "", &squared), fitted(&samples, "length-offset", &squared));
    let found = of(&[&plain, &offsets], Loss::Squared);
    // noise drawn at the stated size leaves about what it should, whose excess over 1 enlarges it for both
    let n = 240.0;
    let variance = (sum_of_squares(&samples, true) / (SIGMA * SIGMA * (n - 8.0))).max(1.0);
    for (one, with_offsets, k) in [(found[0], false, 0.0), (found[1], true, 8.0)] {
        let deviance = sum_of_squares(&samples, with_offsets) / (SIGMA * SIGMA * variance)
            + n * (TAU * SIGMA * SIGMA * variance).ln();
        // sums of 240 numbers, and an optimum to 1e-10 m
        let close = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-6, "{found} {expected} {one:?}");
        assert_eq!((one.rows, one.with_wrenches), (240, false));
        close(one.effective_rows, n);
        close(one.effective_parameters, k);
        close(-2.0 * one.log_likelihood, deviance);
        close(one.aic, deviance + 2.0 * k);
        close(one.aicc, deviance + 2.0 * k + 2.0 * k * (k + 1.0) / (n - k - 1.0));
        close(one.bic, deviance + k * n.ln());
    }
    assert!(found[1].aicc < found[0].aicc && found[1].bic < found[0].bic);
}

/// Without stated accuracies the noise is the residuals' own (its maximum likelihood), and counts as a parameter.
#[test]
fn unknown_noise_is_one_parameter_more() {
    let samples = samples(30, 2, None);
    let squared = Settings { loss: Loss::Squared, ..Settings::default() };
    let found = of(&[&fitted(&samples, "length-offset", &squared)], Loss::Squared)[0];
    let (n, sum) = (240.0, sum_of_squares(&samples, true));
    let deviance = n * (1.0 + (TAU * sum / n).ln());
    assert_eq!((found.noise_source, found.effective_parameters), (NoiseSource::Estimated, 9.0));
    assert!((found.aic - deviance - 18.0).abs() < 1e-6, "{found:?}");
    assert!((1e-3 * found.noise / (sum / n).sqrt() - 1.0).abs() < 1e-9, "{found:?}");
}

/// Every sample ten times over is no new evidence: a tenth of the rows, as far as 600 samples tell their correlation.
#[test]
fn repeated_samples_are_few_independent_rows() {
    let once = samples(60, 3, Some(SIGMA));
    let mut repeated = Samples { poses: Vec::new(), lengths: Vec::new(), ..once.clone() };
    for sample in 0..60 {
        for _ in 0..10 {
            repeated.poses.push(once.poses[sample]);
            repeated.lengths.extend(once.lengths_of(sample));
        }
    }
    let squared = Settings { loss: Loss::Squared, ..Settings::default() };
    let found = of(&[&fitted(&repeated, "length-offset", &squared)], Loss::Squared)[0];
    assert_eq!(found.rows, 4800);
    assert!((found.effective_rows / 480.0 - 1.0).abs() < 0.5, "{found:?}");
}

/// A sample that no candidate explains counts for none: the criteria are near those of the data without it. It still pulls by C of Huber's loss,
/// as a sample does that lies 3.6 standard deviations off: the deviance of the others rises by about C² times its share of the parameters,
/// 13 k/320, twice that where its leverage is large.
#[test]
fn outliers_of_all_candidates_are_left_out() {
    let clean = samples(40, 4, Some(SIGMA));
    let mut dirty = clean.clone();
    dirty.lengths[8 * 17..8 * 18].iter_mut().for_each(|length| *length += 0.5);
    let rest: Vec<usize> = (0..40).filter(|&sample| sample != 17).collect();
    let automatic = Settings::default();
    let frees = ["length-offset", "frame-anchor"];
    let fits = |samples: &Samples| frees.map(|free| fitted(samples, free, &automatic));
    let told = |samples: &Samples| {
        let fits = fits(samples);
        of(&[&fits[0], &fits[1]], Loss::Auto)
    };
    for (dirty, clean) in told(&dirty).iter().zip(told(&clean.subset(&rest))) {
        assert_eq!(dirty.rows, clean.rows);
        let allowed = 26.0 / 320.0 * clean.effective_parameters;
        assert!((dirty.aicc - clean.aicc).abs() < allowed, "{dirty:?} {clean:?}");
    }
    // under least squares every sample counts
    let squared = Settings { loss: Loss::Squared, ..Settings::default() };
    assert_eq!(of(&[&fitted(&dirty, "length-offset", &squared)], Loss::Squared)[0].rows, 320);
}

/// A prior as wide as the data's own deviation leaves half of the parameter to the data: n s²/σ² = 1 for each offset.
#[test]
fn a_parameter_with_a_prior_counts_by_what_the_data_tell() {
    let mut samples = samples(25, 5, Some(SIGMA));
    samples.lengths.iter_mut().enumerate().for_each(|(index, length)| *length -= 1e-3 * (index % 8) as f64);
    let priors = vec![Prior { kind: ParameterKind::LengthOffset, sigma: SIGMA / 5.0 }];
    let settings = Settings { loss: Loss::Squared, priors, ..Settings::default() };
    let found = of(&[&fitted(&samples, "length-offset", &settings)], Loss::Squared)[0].effective_parameters;
    // 200 rows tell the size of their noise within 5 %
    assert!((found - 4.0).abs() < 0.4, "{found}");
    let wide = vec![Prior { kind: ParameterKind::LengthOffset, sigma: 1.0 }];
    let settings = Settings { loss: Loss::Squared, priors: wide, ..Settings::default() };
    let found = of(&[&fitted(&samples, "length-offset", &settings)], Loss::Squared)[0].effective_parameters;
    assert!((found - 8.0).abs() < 1e-5, "{found}");
}
