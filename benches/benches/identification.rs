//! Identification from 91 poses: `cargo bench -p benches --bench identification`.
//!
//! Kinematic: 48 parameters, both anchors of eight cables; `dense` is the same problem, 728 × 48, by the crate
//! levenberg-marquardt. Elastostatic: 62 parameters, anchors, compliances and the wrench, from wrench and length rows with
//! their full covariances, poses and tensions corrected along with the parameters. Cartesian: 24 parameters, the frame anchors, from the errors of
//! 75 predicted poses, beside the fit of the same lengths.

#[path = "../../crates/cdpr-calibration/tests/dense/mod.rs"]
mod dense;

use std::hint::black_box;

use cdpr::calibration::fit::{Prior, Settings, fit, optimal_parameters};
use cdpr::calibration::{Loss, Objective, PathSettings, Penalty, penalty_path};
use cdpr::control::simulate::simulate;
use cdpr::control::winch_offsets;
use cdpr::measurement::{Samples, SensorSigmas};
use cdpr::model::{Composition, FreeParameters, Model};
use cdpr::reading::Keyword;
use cdpr::robot::{ParameterKind, Robot};
use cdpr::study::Study;
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion};
use levenberg_marquardt::LevenbergMarquardt;

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let (model, samples) = dense::problem();
    let free = "frame-anchor,platform-anchor".parse().expect("parameters");
    let settings = Settings { loss: Loss::Squared, ..Settings::default() };
    let sigmas =
        SensorSigmas { length: Some(2e-4), position: Some(1.155e-3), rotation: Some(1e-3), ..SensorSigmas::default() };
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
    robust(&mut group, (&model, &free), &weighted);
    group.bench_function("with uncertainty analysis", |bencher| {
        bencher.iter(|| fit(&model, black_box(&samples), &free, &settings).map(|found| found.iterations));
    });
    path(&mut group, (&model, &free), &weighted);
    group.sample_size(20);
    group.bench_function("dense", |bencher| {
        bencher.iter(|| dense::solve(&model, black_box(&samples), LevenbergMarquardt::new()))
    });
    group.finish();
    elastostatic(&mut criterion);
    cartesian(&mut criterion);
    criterion.final_summary();
}

/// Robust losses with sensor accuracies, of clean samples and of such with 3 of 91 rows displaced by 0.2 m: at most three times as long as least
/// squares in the same run.
fn robust(group: &mut BenchmarkGroup<'_, WallTime>, (model, free): (&Model, &FreeParameters), clean: &Samples) {
    let mut dirty = clean.clone();
    [17, 44, 80].into_iter().for_each(|row| dirty.poses[row].position.x += 0.2);
    for (data, samples) in [("clean", clean), ("displaced rows", &dirty)] {
        for &loss in Loss::ALL {
            let settings = Settings { loss, ..Settings::default() };
            group.bench_function(format!("optimum, accuracies, {data}, {}", loss.name()), |bencher| {
                bencher.iter(|| {
                    optimal_parameters(model, black_box(samples), free, &settings).map(|found| found.iterations)
                });
            });
        }
    }
}

/// A path of 50 penalties and its end beside one fit in the same run, as `identify` makes it: at most 20 times as long.
fn path(group: &mut BenchmarkGroup<'_, WallTime>, (model, free): (&Model, &FreeParameters), samples: &Samples) {
    let settings = Settings { loss: Loss::Squared, ..Settings::default() };
    let found = fit(model, samples, free, &settings).expect("a fit");
    group.bench_function("with uncertainty analysis, accuracies", |bencher| {
        bencher.iter(|| fit(model, black_box(samples), free, &settings).map(|found| found.iterations));
    });
    for &penalty in Penalty::ALL {
        let question = PathSettings { penalty, ..PathSettings::default() };
        group.bench_function(format!("path of 50 penalties, {penalty}"), |bencher| {
            bencher.iter(|| {
                let path = penalty_path(model, black_box(samples), &found, &settings, free, &question, &[]);
                path.map(|path| path.points.len())
            });
        });
    }
}

/// Control model of a study in `studies` and what its machine measures, at its random poses too where they are asked for.
fn measured(study: &str, with_random: bool) -> (Model, Samples) {
    let path = format!("{}/../studies/{study}.toml", env!("CARGO_MANIFEST_DIR"));
    let mut study = Study::from_toml_bytes(&std::fs::read(&path).expect("the study"), &path).expect("a study");
    let poses = study.poses.as_mut().expect("poses");
    poses.tension_tests = None;
    poses.random = poses.random.take().filter(|_| with_random);
    let robot = |name: &str| Robot::builtin(name).expect("built in");
    let control = Model::new(robot(&study.control.robot), Composition::STANDARD).expect("a model");
    let machine = Model::new(robot(&study.machine.robot), Composition::ELASTIC).expect("a model");
    let pose = study.initial_pose(machine.robot()).expect("a pose");
    let offsets = winch_offsets(&study.initial, &control, &machine, &pose).expect("offsets");
    let poses = study.commanded_poses(machine.robot(), Vec::new(), 1).expect("poses");
    let noise = study.noise.expect("noise");
    let samples = simulate(&control, &machine, &offsets, &poses, &noise, 1).expect("measurements").samples;
    (control, samples)
}

/// Errors of predicted poses beside the lengths of the same samples, whose cables are fitted one by one.
fn cartesian(criterion: &mut Criterion) {
    let (model, samples) = measured("twin-kinematic-measurements", false);
    let free = "frame-anchor".parse().expect("parameters");
    let mut group = criterion.benchmark_group("identification 24 × 75");
    for (name, objective) in [("lengths", Objective::Length), ("poses", Objective::Pose)] {
        let settings = Settings { loss: Loss::Squared, objective, ..Settings::default() };
        group.bench_function(format!("optimum, {name}"), |bencher| {
            bencher.iter(|| {
                optimal_parameters(&model, black_box(&samples), &free, &settings).map(|found| found.iterations)
            });
        });
    }
    group.finish();
}

fn elastostatic(criterion: &mut Criterion) {
    let (control, samples) = measured("twin-measurements", true);
    let model = Model::new(control.robot().clone(), Composition::ELASTIC).expect("a model");
    let free = "frame-anchor,platform-anchor,compliance,wrench".parse().expect("parameters");
    let prior = Prior { kind: ParameterKind::PlatformAnchor, sigma: 0.02 };
    let settings = Settings { priors: vec![prior], loss: Loss::Squared, ..Settings::default() };
    let mut group = criterion.benchmark_group("identification, elastostatic 62 × 91");
    group.bench_function("optimum", |bencher| {
        bencher
            .iter(|| optimal_parameters(&model, black_box(&samples), &free, &settings).map(|found| found.iterations));
    });
    group.sample_size(20);
    group.bench_function("with uncertainty analysis", |bencher| {
        bencher.iter(|| fit(&model, black_box(&samples), &free, &settings).map(|found| found.iterations));
    });
    group.finish();
}
