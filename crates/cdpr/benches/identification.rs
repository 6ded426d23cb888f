//! Kinematic identification of 48 parameters (both anchors of eight cables) from 91 poses:
//! `cargo bench -p cdpr --bench identification`.
//!
//! `dense` is the same problem, 728 × 48, by the crate levenberg-marquardt.

#[path = "../tests/dense/mod.rs"]
mod dense;

use std::hint::black_box;

use cdpr::identification::fit::{Settings, fit, optimal_parameters};
use cdpr::measurement::{Samples, SensorSigmas};
use criterion::Criterion;
use levenberg_marquardt::LevenbergMarquardt;

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let (model, samples) = dense::problem();
    let free = "frame-anchor,platform-anchor".parse().expect("parameters");
    let settings = Settings::default();
    let sigmas = SensorSigmas { length: Some(2e-4), position: Some(1.155e-3), rotation: Some(1e-3), tension: None };
    let weighted = Samples { sigmas, ..samples.clone() };
    let mut group = criterion.benchmark_group("identification 48 × 91");
    group.bench_function("optimum", |bencher| {
        bencher
            .iter(|| optimal_parameters(&model, black_box(&samples), &free, &settings).map(|found| found.iterations));
    });
    group.bench_function("optimum, weights by sensor accuracies", |bencher| {
        bencher
            .iter(|| optimal_parameters(&model, black_box(&weighted), &free, &settings).map(|found| found.iterations));
    });
    group.bench_function("with uncertainty analysis", |bencher| {
        bencher.iter(|| fit(&model, black_box(&samples), &free, &settings).map(|found| found.iterations));
    });
    group.sample_size(20);
    group.bench_function("dense", |bencher| {
        bencher.iter(|| dense::solve(&model, black_box(&samples), LevenbergMarquardt::new()))
    });
    group.finish();
    criterion.final_summary();
}
