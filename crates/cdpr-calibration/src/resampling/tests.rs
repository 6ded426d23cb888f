use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::{Resampled, resampled};
use crate::fit::{Fit, Settings, fit};
use crate::loss::Loss;
use crate::objective::Minimize;
use crate::recorded_curves::{SIGMA, points};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};

/// Exact poses along a small curve, one in fifteen far from it, lengths with this noise, which is asked for the sample and a standard normal number.
fn samples(count: usize, noise: impl Fn(usize, f64) -> f64) -> Samples {
    let (model, mut rng) = (points(), ChaCha8Rng::seed_from_u64(6));
    let home = model.robot().home_or_middle();
    let pose = |index: usize| {
        let t = 0.37 * index as f64;
        let size = if index.is_multiple_of(15) { 1.5 } else { 0.3 };
        let way = Vector3::new(t.sin(), (1.7 * t).cos(), 0.5 * (2.3 * t).sin());
        Pose::from_xyz_angles(home.position + size * way, [0.0; 3])
    };
    let poses: Vec<Pose> = (0..count).map(pose).collect();
    let mut lengths = Vec::new();
    for (sample, pose) in poses.iter().enumerate() {
        for length in model.cable_lengths(pose).unwrap() {
            lengths.push(length + SIGMA * noise(sample, StandardNormal.sample(&mut rng)));
        }
    }
    Samples { poses, lengths, cable_count: 8, sigmas: SensorSigmas::default(), ..Samples::default() }
}

fn both(samples: &Samples, free: &str) -> (Fit, Resampled) {
    let settings = Settings { loss: Loss::Squared, ..Settings::default() };
    let fit = fit(&points(), samples, &free.parse().unwrap(), &settings).unwrap();
    let found = resampled(&points(), samples, &fit, &settings, 400, 1).unwrap();
    (fit, found)
}

/// Independent normal noise: 400 replicates tell a deviation to 3.5 %, 450 samples to another 3.3 %; four times that for the worst of eight.
#[test]
fn independent_noise_has_the_linear_deviation() {
    let (_, found) = both(&samples(450, |_, draw| draw), "length-offset");
    assert_eq!((found.replicates, found.failed, found.block_length), (400, 0, 1));
    assert!(found.warning.is_none(), "{:?}", found.warning);
    let ratios: Vec<f64> = found.parameters.iter().map(|one| one.ratio.unwrap()).collect();
    assert!(ratios.iter().all(|ratio| (ratio - 1.0).abs() < 0.2), "{ratios:?}");
    let mean = ratios.iter().sum::<f64>() / 8.0;
    assert!((mean - 1.0).abs() < 0.07, "{mean}");
}

/// Noise that repeats itself over ten samples: the textbook's σ/√n of an offset is too small by about √10, which the blocks see.
#[test]
fn correlated_noise_is_seen_by_blocks() {
    let mut random = ChaCha8Rng::seed_from_u64(8);
    let steps: Vec<f64> = (0..160 * 8).map(|_| StandardNormal.sample(&mut random)).collect();
    let cable = std::cell::Cell::new(0);
    let noise = |sample: usize, _: f64| {
        let own = cable.get();
        cable.set((own + 1) % 8);
        steps[(sample / 10) * 8 + own]
    };
    let (_, found) = both(&samples(1600, noise), "length-offset");
    assert!(found.block_length > 10, "{}", found.block_length);
    let textbook = SIGMA / 1600_f64.sqrt();
    let ratios: Vec<f64> = found.parameters.iter().map(|one| one.bootstrap / textbook).collect();
    // some thirty blocks tell a deviation to 13 %, the mean of eight to 5 %, and the ends of blocks cost some of it
    let mean = ratios.iter().sum::<f64>() / 8.0;
    assert!((mean / 10_f64.sqrt() - 1.0).abs() < 0.2, "{ratios:?}");
    assert!(ratios.iter().all(|ratio| *ratio > 1.5), "{ratios:?}");
}

/// One pose in fifteen is far away and noisy: it alone tells length scales, whose linear deviations, with the mean noise of all poses, are too small
/// by 5/√((14 + 25)/15) = 3.1, and the warning says so.
#[test]
fn noise_that_sits_where_parameters_are_told_is_warned_of() {
    let noisy = |sample: usize, draw: f64| if sample.is_multiple_of(15) { 5.0 * draw } else { draw };
    let (_, found) = both(&samples(450, noisy), "length-offset,length-scale");
    let warning = found.warning.as_ref().expect("deviations differ");
    assert!(warning.contains("differ from the linear ones by more than a factor 1.5"), "{warning}");
    assert!(warning.ends_with("take those of the bootstrap where they are larger"), "{warning}");
    let scales: Vec<f64> =
        found.parameters.iter().filter(|one| one.unit.is_empty()).map(|one| one.ratio.unwrap()).collect();
    let mean = scales.iter().sum::<f64>() / 8.0;
    // thirty far poses tell their noise to 13 %, in each of eight cables
    assert!((mean / 3.1 - 1.0).abs() < 0.25, "{scales:?}");
}

/// The same seed gives the same bits whatever the number of threads.
#[cfg(feature = "parallel")]
#[test]
fn replicates_are_the_same_on_any_number_of_threads() {
    let samples = samples(60, |_, draw| draw);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| both(&samples, "frame-anchor").1)
    };
    assert_eq!(on(1), on(3));
}

/// A least largest norm has no linear deviations: the bootstrap tells them, the same at every repetition.
#[test]
fn the_least_largest_norm_has_deviations_by_the_bootstrap() {
    let samples = samples(60, |_, draw| draw);
    let settings = Settings { minimize: Minimize::Max, ..Settings::default() };
    let fit = fit(&points(), &samples, &"length-offset".parse().unwrap(), &settings).unwrap();
    let [first, second] = [1, 2].map(|_| resampled(&points(), &samples, &fit, &settings, 40, 1).unwrap());
    assert_eq!(first, second);
    assert!(first.warning.is_none() && first.replicates + first.failed == 40 && first.failed < 4, "{first:?}");
    // the middle of the range of 60 normal numbers scatters by 0.3 to 0.4 of their deviation; eight cables share one bound, which leaves more room
    for one in &first.parameters {
        assert_eq!((one.linear, one.ratio), (None, None));
        assert!((0.1 * SIGMA..1.0 * SIGMA).contains(&one.bootstrap), "{one:?}");
    }
}
