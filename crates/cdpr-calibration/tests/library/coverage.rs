//! Intervals mean what they say: 95 % intervals contain the truth in 95 % of repeated experiments.

use super::support::{builtin, measured, random_direction, simulator};
use cdpr_calibration::Loss;
use cdpr_calibration::fit::{Prior, Settings, Status, fit};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::robot::ParameterKind;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

const RUNS: u64 = 200;

/// Share of runs in which the interval contains the true value, parameter by parameter; `spoil` changes the samples of each run.
fn coverage(free: &str, loss: Loss, spoil: impl Fn(&mut Samples)) -> Vec<f64> {
    let truth = builtin("cablerobot-simulator-helicopter-kinematic-calibrated");
    let true_model = Model::new(truth.clone(), Composition::STANDARD).unwrap();
    let mut start = simulator();
    // what is not free must be true
    if !free.contains("platform-anchor") {
        for (cable, other) in start.cables.iter_mut().zip(&truth.cables) {
            cable.platform_anchor = other.platform_anchor;
        }
    }
    let start = Model::new(start, Composition::STANDARD).unwrap();
    let free: FreeParameters = free.parse().unwrap();
    let mut hits: Vec<u32> = Vec::new();
    for seed in 0..RUNS {
        let mut samples = measured(&truth, Composition::STANDARD, 91, 0.15, seed);
        spoil(&mut samples);
        let fit = fit(&start, &samples, &free, &Settings { loss, ..Settings::default() }).unwrap();
        assert_eq!((fit.status, fit.loss), (Status::Converged, loss), "{}", fit.reason);
        hits.resize(fit.parameters.len(), 0);
        for (hit, estimate) in hits.iter_mut().zip(&fit.parameters) {
            let sigma = estimate.sigma.expect("everything is determined");
            let error = estimate.value - estimate.parameter.value(true_model.robot());
            *hit += u32::from(error.abs() <= 1.96 * sigma);
        }
    }
    hits.iter().map(|&hit| f64::from(hit) / RUNS as f64).collect()
}

fn check(free: &str, loss: Loss, spoil: impl Fn(&mut Samples)) {
    let fractions = coverage(free, loss, spoil);
    let pooled = fractions.iter().sum::<f64>() / fractions.len() as f64;
    let (least, most) =
        fractions.iter().fold((1.0_f64, 0.0_f64), |(a, b), &fraction| (a.min(fraction), b.max(fraction)));
    println!("{free}, {loss:?}: pooled {pooled:.4}, single parameters {least:.3} to {most:.3}");
    assert!((0.93..=0.97).contains(&pooled), "{free}: pooled {pooled}");
    // 200 runs of a 95 % event: standard deviation 1.5 %, so ± 4 of them
    assert!(least >= 0.89 && most <= 0.99 + 1e-9, "{free}: {least} to {most}");
}

#[test]
fn intervals_of_frame_anchors_cover_the_truth() {
    check("frame-anchor", Loss::Squared, |_| {});
}

#[test]
fn intervals_of_anchors_and_offsets_cover_the_truth() {
    check("frame-anchor,platform-anchor", Loss::Squared, |_| {});
    check("frame-anchor,length-offset", Loss::Squared, |_| {});
}

/// Huber's intervals, of clean samples and of such with 3 of 91 rows displaced by 0.1 to 0.3 m: the rows pull with what the loss leaves
/// them, and the covariance knows.
#[test]
fn intervals_under_huber_cover_the_truth_with_and_without_outliers() {
    check("frame-anchor,length-offset", Loss::Huber, |_| {});
    check("frame-anchor,platform-anchor", Loss::Huber, displace);
}

/// Displaces 3 of 91 rows by 0.1 to 0.3 m in random directions.
fn displace(samples: &mut Samples) {
    let mut rng = ChaCha8Rng::seed_from_u64(samples.lengths[0].to_bits());
    for row in [17, 44, 80] {
        let size = rng.random_range(0.1..0.3);
        samples.poses[row].position += size * random_direction(&mut rng);
    }
}

/// Standard deviation of the priors (m).
const PRIOR: f64 = 0.02;

/// Machines for each number of poses; `CDPR_COVERAGE_RUNS` asks for more.
fn machines() -> u64 {
    std::env::var("CDPR_COVERAGE_RUNS").ok().and_then(|count| count.parse().ok()).unwrap_or(60)
}

/// Share of intervals that hold the truth, all 48 anchors of machines drawn from the priors together; the mean noise factor.
fn coverage_with_priors(kinds: &[ParameterKind], poses: usize) -> (f64, f64) {
    let file = simulator();
    let start = Model::new(file.clone(), Composition::STANDARD).unwrap();
    let free: FreeParameters = "frame-anchor,platform-anchor".parse().unwrap();
    let priors = kinds.iter().map(|&kind| Prior { kind, sigma: PRIOR }).collect();
    let settings = Settings { priors, ..Settings::default() };
    let normal = Normal::new(0.0, PRIOR).unwrap();
    let (mut inside, mut all, mut noise_factor) = (0, 0, 0.0);
    for seed in 0..machines() {
        let mut rng = ChaCha8Rng::seed_from_u64(7000 + seed);
        let mut machine = file.clone();
        for cable in &mut machine.cables {
            for k in 0..3 {
                cable.frame_anchor[k] += normal.sample(&mut rng);
                cable.platform_anchor[k] += normal.sample(&mut rng);
            }
        }
        let samples = measured(&machine, Composition::STANDARD, poses, 0.15, seed);
        let found = fit(&start, &samples, &free, &settings).unwrap();
        let truth = Model::new(machine, Composition::STANDARD).unwrap();
        for estimate in &found.parameters {
            let error = estimate.value - estimate.parameter.value(truth.robot());
            inside += u32::from(error.abs() <= 1.96 * estimate.sigma.expect("a prior determines it"));
            all += 1;
        }
        noise_factor += found.noise_factor / machines() as f64;
    }
    (f64::from(inside) / f64::from(all), noise_factor)
}

/// Few poses and many parameters: priors count as rows, else the noise seems several times as large as it is.
#[test]
fn intervals_cover_the_truth_with_priors_and_few_poses() {
    let both = [ParameterKind::FrameAnchor, ParameterKind::PlatformAnchor];
    for kinds in [&both[..], &both[1..]] {
        for poses in [25, 10, 7, 4] {
            let (fraction, noise_factor) = coverage_with_priors(kinds, poses);
            println!("{kinds:?}, {poses} poses: {:.2} % covered, noise factor {noise_factor:.3}", 100.0 * fraction);
            assert!((0.93..=0.97).contains(&fraction), "{kinds:?}, {poses} poses: {fraction}");
            // the root of a mean of squares is a little below that of their expectation
            assert!((0.9..1.05).contains(&noise_factor), "{kinds:?}, {poses} poses: {noise_factor}");
        }
    }
}
