//! Intervals mean what they say: 95 % intervals contain the truth in 95 % of repeated experiments.

use crate::support::{builtin, measured, simulator};
use cdpr::identification::fit::{Settings, Status, fit};
use cdpr::model::{Composition, FreeParameters, Model};

const RUNS: u64 = 200;

/// Share of runs in which the interval contains the true value, parameter by parameter.
fn coverage(free: &str) -> Vec<f64> {
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
        let samples = measured(&truth, Composition::STANDARD, 91, 0.15, seed);
        let fit = fit(&start, &samples, &free, &Settings::default()).unwrap();
        assert_eq!(fit.status, Status::Converged, "{}", fit.reason);
        hits.resize(fit.parameters.len(), 0);
        for (hit, estimate) in hits.iter_mut().zip(&fit.parameters) {
            let sigma = estimate.sigma.expect("everything is determined");
            let error = estimate.value - estimate.parameter.value(&true_model);
            *hit += u32::from(error.abs() <= 1.96 * sigma);
        }
    }
    hits.iter().map(|&hit| f64::from(hit) / RUNS as f64).collect()
}

fn check(free: &str) {
    let shares = coverage(free);
    let pooled = shares.iter().sum::<f64>() / shares.len() as f64;
    let (least, most) = shares.iter().fold((1.0_f64, 0.0_f64), |(a, b), &share| (a.min(share), b.max(share)));
    println!("{free}: pooled {pooled:.4}, single parameters {least:.3} to {most:.3}");
    assert!((0.93..=0.97).contains(&pooled), "{free}: pooled {pooled}");
    // 200 runs of a 95 % event: standard deviation 1.5 %, so ± 4 of them
    assert!(least >= 0.89 && most <= 0.99 + 1e-9, "{free}: {least} to {most}");
}

#[test]
fn intervals_of_frame_anchors_cover_the_truth() {
    check("frame-anchor");
}

#[test]
fn intervals_of_anchors_and_offsets_cover_the_truth() {
    check("frame-anchor,platform-anchor");
    check("frame-anchor,length-offset");
}
