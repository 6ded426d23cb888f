//! Edges of maps: full correction among the samples, none beyond the margin, and neither jump nor corner between.

use nalgebra::{DMatrix, UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::field::Field;
use super::*;
use crate::geometry::Pose;
use crate::model::{Composition, Model};
use crate::robot::Robot;

/// Largest correction of the maps below (m).
const SIZE: f64 = 0.012;

/// Corrections that vary over metres at poses of the twin's robot, turned by up to 0.09 rad; no sample with x in `gap`.
fn samples(gap: std::ops::Range<f64>) -> (Model, Vec<Pose>, DMatrix<f64>) {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-kinematic-calibrated").unwrap();
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let mut within = |half: f64| rng.random_range(-half..half);
    let poses: Vec<Pose> = (0..90)
        .map(|_| pose([within(1.5), within(1.5), 1.6 + within(0.4)], [within(0.09), within(0.09), within(0.09)]))
        .filter(|pose| !gap.contains(&pose.position.x))
        .collect();
    let correction = |row: usize, cable: usize| {
        let Pose { position, rotation } = poses[row];
        SIZE * (0.4 * position.x + 0.3 * position.y + 2.0 * rotation.scaled_axis().z + cable as f64).sin()
    };
    let corrections = DMatrix::from_fn(poses.len(), 8, correction);
    (model, poses, corrections)
}

/// The map through samples without a gap.
fn map() -> (Model, Compensation) {
    let (model, poses, corrections) = samples(0.0..0.0);
    let map = Compensation::through(&model, &poses, &corrections).unwrap();
    (model, map)
}

fn pose(position: [f64; 3], turn: [f64; 3]) -> Pose {
    Pose { position: Vector3::from(position), rotation: UnitQuaternion::from_scaled_axis(Vector3::from(turn)) }
}

/// Pose at a fraction of a line from the middle of the samples.
fn on(way: &[[f64; 3]; 2], fraction: f64) -> Pose {
    pose([fraction * way[0][0], fraction * way[0][1], 1.6 + fraction * way[0][2]], way[1].map(|turn| fraction * turn))
}

/// Lines out of the box: along an axis, across an edge, across a corner of positions and rotations.
const LINES: [[[f64; 3]; 2]; 5] = [
    [[3.0, 0.0, 0.0], [0.0; 3]],
    [[0.0, -3.0, 0.0], [0.0; 3]],
    [[0.0, 0.0, 1.0], [0.0; 3]],
    [[2.4, 2.4, 0.6], [0.0; 3]],
    [[1.8, -1.8, 0.4], [0.14, 0.0, -0.14]],
];

/// Along lines out of the box corrections change by less than 0.3 mm within a step of a millimetre, where they once
/// jumped by 5 to 12 mm; their slope changes in a step by less than a tenth of its largest value, which a corner would
/// change completely; beyond the margin they are zero to the bit.
#[test]
fn corrections_end_without_a_jump_or_a_corner() {
    const STEPS: usize = 2500;
    let (_, map) = map();
    for (number, way) in LINES.iter().enumerate() {
        let at = |k: usize| map.at(&on(way, k as f64 / STEPS as f64));
        let along: Vec<Correction> = (0..=STEPS).map(at).collect();
        let (first, last) = (&along[0], &along[STEPS]);
        assert_eq!((first.fraction, &first.reason, last.fraction), (1.0, &None, 0.0), "line {number}");
        for cable in 0..8 {
            let steps: Vec<f64> =
                along.windows(2).map(|pair| pair[1].lengths[cable] - pair[0].lengths[cable]).collect();
            let steepest = steps.iter().fold(0.0_f64, |most, step| most.max(step.abs()));
            let corner = steps.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
            assert!(steepest < 3e-4, "line {number}, cable {cable}: a step of {steepest} m");
            // a micrometre where the correction is small
            assert!(corner < 0.1 * steepest + 1e-6, "line {number}, cable {cable}: {corner} m of {steepest} m");
        }
        // rounding of the product
        assert!(along.windows(2).all(|pair| pair[1].fraction <= pair[0].fraction + 1e-12), "line {number}");
        assert!(last.lengths.iter().all(|length| length.to_bits() == 0) && last.clone().known().is_err());
    }
}

/// A map ends at its stated extents: full at the ends, half in the middle of the margin, zero beyond it.
#[test]
fn margins_are_those_that_are_told() {
    let (_, map) = map();
    let MapFacts { centre, extents, .. } = map.facts();
    let turn = |axis: usize, by: f64| UnitQuaternion::from_scaled_axis(Vector3::ith(axis, by));
    for (place, extent) in extents.iter().enumerate() {
        let Extent { unit, ends: [low, high], margin, .. } = *extent;
        assert!(low < 0.0 && high > 0.0 && margin > 0.04 * (high - low), "{extent:?}");
        for (by, fraction) in [(high, 1.0), (high + 0.5 * margin, 0.5), (high + margin, 0.0), (low - 0.5 * margin, 0.5)]
        {
            let pose = match unit {
                "m" => Pose { position: centre.position + Vector3::ith(place, by), ..centre },
                _ => Pose { rotation: turn(place - 3, by) * centre.rotation, ..centre },
            };
            // rounding of coordinates, over a margin of centimetres
            assert!((map.at(&pose).fraction - fraction).abs() < 1e-9, "{extent:?} at {by}: {}", map.at(&pose).fraction);
        }
    }
}

/// Inside its box a map equals the Gaussian process, to the bit.
#[test]
fn among_the_samples_nothing_fades() {
    let (_, map) = map();
    for k in 0..20 {
        let pose = on(&[[1.2, -0.9, 0.3], [0.05, -0.04, 0.06]], 0.1 * f64::from(k) - 1.0);
        assert_eq!((map.at(&pose).lengths, map.at(&pose).fraction), (map.field.at(&map.space.point(&pose)).0, 1.0));
    }
}

/// In a gap of 1.9 m between samples with corrections correlated over 0.6 m a map fades to zero and returns, without
/// jump or corner.
#[test]
fn corrections_fade_in_gaps() {
    let (model, poses, corrections) = samples(-0.9..1.0);
    let mut map = Compensation::through(&model, &poses, &corrections).unwrap();
    let Field { points, length_scale, noise_ratio, mean, weights, factor } = std::sync::Arc::make_mut(&mut map.field);
    (*length_scale, *noise_ratio) = (0.6, 1e-4);
    *factor = field::factor(points, *length_scale, *noise_ratio).unwrap();
    let centred = DMatrix::from_fn(corrections.nrows(), 8, |row, cable| corrections[(row, cable)] - mean[cable]);
    *weights = factor.solve(&centred);
    let at = |k: u32| map.at(&pose([1.4 - 2.8e-3 * f64::from(k), 0.1, 1.6], [0.0; 3]));
    let along: Vec<Correction> = (0..=1000).map(at).collect();
    let least = along.iter().map(|own| own.fraction).fold(1.0, f64::min);
    assert!(least < 0.1 && along.iter().any(|own| own.fraction == 1.0), "{least}");
    let reason = along.iter().find_map(|own| own.reason.clone()).unwrap();
    assert!(reason.contains("of the variance stay unknown"), "{reason}");
    for cable in 0..8 {
        let steps: Vec<f64> = along.windows(2).map(|pair| pair[1].lengths[cable] - pair[0].lengths[cable]).collect();
        let corner = steps.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max);
        assert!(steps.iter().all(|step| step.abs() < 3e-4) && corner < 2e-5, "cable {cable}: {corner} m");
    }
}

/// A map read from its file is the same: the same corrections in the box, in its margin and beyond, to the bit.
#[cfg(feature = "files")]
#[test]
fn a_file_makes_the_same_map() {
    let (model, map) = map();
    let again = Compensation::from_toml_bytes(map.to_toml().as_bytes(), "map.toml", &model).unwrap();
    assert_eq!(again.facts(), map.facts());
    for k in 0..=100 {
        let pose = on(&LINES[4], 1e-2 * f64::from(k));
        assert_eq!(again.at(&pose), map.at(&pose));
    }
}
