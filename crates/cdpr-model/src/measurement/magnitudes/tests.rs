//! Every unit in every part of the data is found, and none in clean data, also in the world of a tracker.

use nalgebra::{UnitQuaternion, Vector3};
use rand::{RngExt, SeedableRng};

use super::*;
use crate::geometry::product;

/// Samples over a tenth of the robot about its home, with offsets of 20 mm and noise of 1 mm.
fn recorded(robot: &Robot) -> Samples {
    let mut chance = rand_chacha::ChaCha8Rng::seed_from_u64(5);
    let (home, diagonal, pattern) = (robot.home_or_middle(), robot.anchor_diagonal(), robot.motion_pattern);
    let middle = pattern.pose_to_components(robot.plane, &home);
    let mut samples = Samples { cable_count: robot.cable_count(), ..Samples::default() };
    for _ in 0..60 {
        let mut uniform = |size: f64| size * (2.0 * chance.random::<f64>() - 1.0);
        let size = |k: usize| if k < pattern.translations() { 0.12 * diagonal } else { 0.3 };
        let components: Vec<f64> = middle.iter().enumerate().map(|(k, value)| value + uniform(size(k))).collect();
        let pose = pattern.pose(robot.plane, &components).unwrap();
        for (k, cable) in robot.cables.iter().enumerate() {
            let length = (cable.frame_anchor - pose.transform(&cable.platform_anchor)).norm();
            samples.lengths.push(length + 0.02 * (k as f64).sin() + uniform(1e-3));
        }
        samples.poses.push(pose);
    }
    samples
}

fn robots() -> [Robot; 4] {
    ["cablerobot-simulator-helicopter", "cogiro", "ipanema-1", "planar-example"]
        .map(|name| Robot::builtin(name).unwrap())
}

fn scaled(samples: &Samples, positions: Vector3<f64>, length: impl Fn(usize) -> f64) -> Samples {
    let m = samples.cable_count;
    let poses = samples.poses.iter().map(|pose| Pose { position: pose.position.component_mul(&positions), ..*pose });
    let lengths = samples.lengths.iter().enumerate().map(|(place, q)| q * length(place % m));
    Samples { poses: poses.collect(), lengths: lengths.collect(), ..samples.clone() }
}

fn verdict(robot: &Robot, samples: &Samples, factor: f64) -> UnitVerdict {
    judge(robot, samples, &|_| factor)
}

/// The message of a certain verdict, with the quantity of its column.
fn refused(robot: &Robot, samples: &Samples, factor: f64) -> (String, Quantity) {
    match verdict(robot, samples, factor) {
        UnitVerdict::Wrong { message, quantity, .. } => (message, quantity),
        other => panic!("{}: {other:?}", robot.name),
    }
}

/// The world of a tracker 50 m off the robot, turned, and a marker beside the platform's origin.
fn by_tracker(robot: &Robot, samples: &Samples) -> Samples {
    let is_planar = robot.motion_pattern.is_planar();
    let axis = if is_planar { robot.plane.normal() } else { Vector3::new(0.3, -0.2, 1.0) };
    let off = robot.plane.first_axis() * 40.0 + robot.plane.second_axis() * -30.0;
    let tracker = Pose { position: off, rotation: UnitQuaternion::new(axis.normalize() * 2.1) };
    let marker = Pose { position: robot.plane.first_axis() * 0.15, ..Pose::identity() };
    let moved = |pose: &Pose| product(&product(&tracker, pose), &marker);
    Samples { poses: samples.poses.iter().map(moved).collect(), ..samples.clone() }
}

#[test]
fn units_of_positions_and_lengths_are_named_both_ways() {
    for robot in robots() {
        let samples = recorded(&robot);
        assert_eq!(verdict(&robot, &samples, 1.0), UnitVerdict::Plausible, "{}", robot.name);
        // lengths of no unit at all
        let small = scaled(&samples, Vector3::repeat(1.0), |_| 2e-4);
        assert_eq!(verdict(&robot, &small, 1.0), UnitVerdict::Plausible, "{}", robot.name);
        for (name, metres) in [("millimetres", 1e-3), ("centimetres", 1e-2), ("inches", 0.0254), ("feet", 0.3048)] {
            let factor = 1.0 / metres;
            let all = Vector3::repeat(factor);
            for (positions, length, words) in [
                (all, 1.0, format!("the positions look like {name}:")),
                (Vector3::repeat(1.0), factor, format!("the cable lengths look like {name}:")),
                (all, factor, format!("positions and cable lengths look like {name}:")),
            ] {
                let (message, _) = refused(&robot, &scaled(&samples, positions, |_| length), 1.0);
                assert!(message.starts_with(&words), "{}: {words} {message}", robot.name);
            }
        }
        // metres in columns of millimetres, which reading has divided by 1000
        let small = Vector3::repeat(1e-3);
        for (positions, length, words) in [
            (small, 1.0, "the positions look like metres:"),
            (Vector3::repeat(1.0), 1e-3, "the cable lengths look like metres:"),
            (small, 1e-3, "positions and cable lengths look like metres:"),
        ] {
            let (message, _) = refused(&robot, &scaled(&samples, positions, |_| length), 1e-3);
            assert!(message.starts_with(words), "{}: {words} {message}", robot.name);
        }
    }
}

#[test]
fn one_column_of_several_is_named_with_its_place() {
    for robot in robots() {
        let samples = recorded(&robot);
        for axis in 0..3 {
            let Some(component) = (match robot.motion_pattern.is_planar() {
                true => robot.plane.indices().iter().position(|own| *own == axis),
                false => Some(axis),
            }) else {
                continue;
            };
            let mut factors = Vector3::repeat(1.0);
            factors[axis] = 1.0 / 0.0254;
            let (message, quantity) = refused(&robot, &scaled(&samples, factors, |_| 1.0), 1.0);
            assert_eq!(quantity, Quantity::Position(component), "{}: {message}", robot.name);
            assert!(message.contains("alone looks like inches") && message.contains("times 0.0254"), "{message}");
        }
        let one = scaled(&samples, Vector3::repeat(1.0), |cable| if cable == 2 { 1000.0 } else { 1.0 });
        let (message, quantity) = refused(&robot, &one, 1.0);
        assert_eq!(quantity, Quantity::Length(2), "{}: {message}", robot.name);
        assert!(message.contains("cable_length_m_3 alone looks like millimetres"), "{message}");
    }
}

/// Units are found for any frame of the tracker, which changes no distance.
#[test]
fn the_world_of_a_tracker_is_no_unit_and_hides_none() {
    for robot in robots() {
        let samples = by_tracker(&robot, &recorded(&robot));
        assert_eq!(verdict(&robot, &samples, 1.0), UnitVerdict::Plausible, "{}", robot.name);
        let feet = scaled(&samples, Vector3::repeat(1.0 / 0.3048), |_| 1.0);
        let (message, _) = refused(&robot, &feet, 1.0);
        assert!(message.starts_with("the positions look like feet:"), "{}: {message}", robot.name);
    }
}
