//! Check values of C23 (an independent computation), optimality of exchanges, and predicted against simulated deviations.

use super::*;
use crate::fit::Settings;
use crate::fit::fit;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Composition;
use cdpr_model::reading::Keyword;
use cdpr_model::robot::Robot;
use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// The 75 poses of sec. 6.1: z runs fastest, then y.
fn grid() -> Vec<Pose> {
    let at = |x: f64, y: f64, z: f64| Pose { position: Vector3::new(x, y, z), ..Pose::identity() };
    let ends = [-1.5, -0.75, 0.0, 0.75, 1.5];
    let of_columns = |x: f64| ends.map(|y| [1.25, 1.625, 2.0].map(|z| at(x, y, z)));
    ends.iter().flat_map(|&x| of_columns(x).into_iter().flatten()).collect()
}

fn helicopter() -> Model {
    Model::new(Robot::builtin("cablerobot-simulator-helicopter").expect("is built in"), Composition::STANDARD).unwrap()
}

fn settings(count: usize, criterion: DesignCriterion) -> PlanSettings {
    PlanSettings { count, criterion, repeats: false, starts: 10, seed: 0, fit: Settings::default() }
}

fn of_grid(count: usize, criterion: DesignCriterion) -> (Plan, Vec<usize>) {
    of_grid_by(&settings(count, criterion))
}

fn of_grid_by(settings: &PlanSettings) -> (Plan, Vec<usize>) {
    let model = helicopter();
    let candidates = Candidates::new(&model, &grid(), 1, SensorSigmas::default()).unwrap();
    let found = plan(&model, &candidates, None, &"frame-anchor".parse().unwrap(), settings).unwrap();
    let mut numbers: Vec<usize> = found.chosen.iter().map(|place| place + 1).collect();
    numbers.sort_unstable();
    (found, numbers)
}

const CORNERS: [usize; 8] = [1, 3, 13, 15, 61, 63, 73, 75];

#[test]
fn all_poses_of_the_grid_tell_what_an_independent_computation_says() {
    let (found, _) = of_grid(75, DesignCriterion::D);
    assert!((found.log_det.unwrap() - 19.4992).abs() < 5e-5, "{found:?}");
    assert!((found.condition.unwrap() - 26.535).abs() < 5e-4 && (found.sigma_min - 0.32421).abs() < 5e-6);
    // 24 parameters over 600 lengths
    assert!((found.i_value.unwrap() - 0.04).abs() < 1e-12 && (found.trace_inverse.unwrap() - 60.493).abs() < 5e-4);
}

#[test]
fn eight_best_poses_are_the_corners() {
    for criterion in [DesignCriterion::D, DesignCriterion::I] {
        let (found, numbers) = of_grid(8, criterion);
        assert_eq!(numbers, CORNERS, "{criterion:?}");
        assert!((found.log_det.unwrap() + 24.3330).abs() < 5e-5);
        assert!((found.condition.unwrap() - 20.2515).abs() < 5e-5 && (found.sigma_min - 0.13788).abs() < 5e-6);
        assert!((found.i_value.unwrap() - 0.26125).abs() < 5e-6);
    }
    assert!(of_grid(8, DesignCriterion::Condition).0.condition.unwrap() < 19.705);
}

#[test]
fn sixteen_best_poses_are_as_good_as_known() {
    let (found, numbers) = of_grid(16, DesignCriterion::D);
    assert!(found.log_det.unwrap() >= -9.883_155, "{:?} {numbers:?}", found.log_det);
    let mut once = numbers.clone();
    once.dedup();
    assert_eq!(once.len(), 16);
    let (found, _) = of_grid(16, DesignCriterion::I);
    assert!(found.i_value.unwrap() <= 0.140_745, "{:?}", found.i_value);
}

/// Every criterion is best by its own measure.
#[test]
fn each_criterion_is_best_by_its_own_measure() {
    // one start by way of each smooth measure
    let by = |criterion| PlanSettings { starts: 4, ..settings(12, criterion) };
    let all: Vec<Plan> = DesignCriterion::ALL.iter().map(|&criterion| of_grid_by(&by(criterion)).0).collect();
    // rounding of the held directions
    let tolerance = 1e-7;
    for other in &all {
        assert!(all[0].log_det >= other.log_det.map(|value| value - tolerance));
        assert!(all[1].trace_inverse.unwrap() <= other.trace_inverse.unwrap() * (1.0 + tolerance));
        assert!(all[2].sigma_min >= other.sigma_min * (1.0 - tolerance));
        assert!(all[3].i_value.unwrap() <= other.i_value.unwrap() * (1.0 + tolerance));
        assert!(all[4].condition.unwrap() <= other.condition.unwrap() * (1.0 + tolerance));
    }
}

/// Measured poses count: the next best pose is the one with the largest determinant together with them.
#[test]
fn the_next_best_pose_is_the_best_of_all() {
    let model = helicopter();
    let poses = grid();
    let given: Vec<Pose> = CORNERS.iter().map(|number| poses[number - 1]).collect();
    let given = Candidates::new(&model, &given, 1, SensorSigmas::default()).unwrap().samples;
    let candidates = Candidates::new(&model, &poses, 1, SensorSigmas::default()).unwrap();
    let free = "frame-anchor".parse().unwrap();
    let one = plan(&model, &candidates, Some(&given), &free, &settings(1, DesignCriterion::D)).unwrap();
    let with = |place: usize| {
        let joined = given.followed_by(&candidates.samples.subset(&[place])).unwrap();
        let all = Candidates { samples: joined, places: (0..9).collect(), tests: vec![None; 9], left_out: Vec::new() };
        plan(&model, &all, None, &free, &settings(9, DesignCriterion::D)).unwrap().log_det.unwrap()
    };
    let values: Vec<f64> = (0..75).map(with).collect();
    let best = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    assert!((one.log_det.unwrap() - best).abs() < 1e-9 && (values[one.chosen[0]] - best).abs() < 1e-9);
}

/// 200 simulated calibrations at 25 planned poses scatter as the plan predicts.
#[test]
fn deviations_are_those_of_simulated_calibrations() {
    let model = helicopter();
    let sigmas = SensorSigmas {
        position: Some(1e-3),
        rotation: Some(5e-4),
        length: Some(5e-4),
        tension: None,
        ..SensorSigmas::default()
    };
    let candidates = Candidates::new(&model, &grid(), 1, sigmas).unwrap();
    let free: FreeParameters = "frame-anchor".parse().unwrap();
    let asked = settings(25, DesignCriterion::D);
    let found = plan(&model, &candidates, None, &free, &asked).unwrap();
    let predicted = Predicted::of(&model, &candidates, &found.chosen, None, &free, &asked.fit).unwrap();
    let exact = candidates.samples.subset(&found.chosen);
    let mut rng = ChaCha8Rng::seed_from_u64(7);
    let mut squares = vec![0.0; predicted.deviations.len()];
    for _ in 0..200 {
        let mut samples = exact.clone();
        let mut normal = || -> f64 { StandardNormal.sample(&mut rng) };
        samples.lengths.iter_mut().for_each(|length| *length += 5e-4 * normal());
        for pose in &mut samples.poses {
            let error = cdpr_model::geometry::Twist::from_fn(|k, _| if k < 3 { 1e-3 } else { 5e-4 } * normal());
            *pose = pose.displaced(&error);
        }
        let fit = fit(&model, &samples, &free, &asked.fit).unwrap();
        squares.iter_mut().zip(&fit.parameters).for_each(|(sum, one)| *sum += one.change * one.change / 200.0);
    }
    let ratios: Vec<f64> =
        squares.iter().zip(&predicted.deviations).map(|(square, one)| square.sqrt() / one.sigma.unwrap()).collect();
    let rms = (ratios.iter().map(|ratio| ratio * ratio).sum::<f64>() / ratios.len() as f64).sqrt();
    // the deviation of 200 is known to 5 %, that of 24 together to 1 %
    assert!((rms - 1.0).abs() < 0.05 && ratios.iter().all(|ratio| (ratio - 1.0).abs() < 0.2), "{rms} {ratios:?}");
    assert!(predicted.pose.is_some_and(|pose| pose.position_m > 0.0));
}

#[test]
fn poses_that_do_not_determine_all_are_told() {
    let (found, _) = of_grid(2, DesignCriterion::D);
    assert_eq!((found.log_det, found.condition, found.rank), (None, None, 16));
    // with one pose every length says one thing of each anchor
    let model = helicopter();
    let candidates = Candidates::new(&model, &grid(), 1, SensorSigmas::default()).unwrap();
    let free = "frame-anchor,platform-anchor".parse().unwrap();
    let found = plan(&model, &candidates, None, &free, &settings(20, DesignCriterion::D)).unwrap();
    // without a turn only sums of anchors are seen
    assert_eq!((found.rank, found.parameter_count, found.log_det), (24, 48, None));
}

#[test]
fn wishes_that_no_plan_keeps_are_refused() {
    let model = helicopter();
    let candidates = Candidates::new(&model, &grid(), 1, SensorSigmas::default()).unwrap();
    let of = |count: usize, free: &str| {
        plan(&model, &candidates, None, &free.parse().unwrap(), &settings(count, DesignCriterion::D)).unwrap_err()
    };
    assert_eq!(of(0, "frame-anchor"), PlanError::NoCount);
    assert_eq!(of(76, "frame-anchor"), PlanError::TooMany { count: 76, candidates: 75 });
    assert!(matches!(of(8, "tracker-frame"), PlanError::Unplannable { .. }));
    assert!(matches!(Candidates::new(&model, &grid(), 2, SensorSigmas::default()), Err(PlanError::LevelsOfRigid)));
    assert!(matches!(Candidates::new(&model, &[], 1, SensorSigmas::default()), Err(PlanError::NoCandidate { .. })));
}
