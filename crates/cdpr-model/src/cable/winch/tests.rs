//! The drum in the world: layers, ends of the groove, derivatives, the geometry of the free part.

use nalgebra::{Const, SVector, Vector3};
use num_dual::DualVec;

use super::turns::{FirstPulley, Turns};
use super::*;
use crate::robot::{Cable, CableWinch, DrumSide, Groove};

/// A drum with its axis askew, four metres from its pulley.
fn drum(groove_length: Option<f64>, layer_height: Option<f64>) -> Parameters {
    Parameters {
        radius: 0.1,
        pitch: 0.008,
        start_angle: 0.7,
        start_length: 3.0,
        mounting: Some(Mounting {
            position: Vector3::new(-4.0, -3.0, 0.5),
            axis: Vector3::new(0.3, 0.9, 0.1).normalize(),
            side: DrumSide::Left,
            pulley: Vector3::new(-4.2, -2.9, 4.5),
        }),
        groove_length,
        layer_height,
        build_up: 0.0,
        advantage: 1.0,
    }
}

/// Drums without ends, with one layer, with many, guided and not, with angles that each allows.
fn drums() -> Vec<(Drum, Vec<f64>)> {
    let guided = |parameters: Parameters| Parameters { mounting: None, ..parameters };
    let (one, many) = (drum(Some(0.16), None), drum(Some(0.04), Some(0.007)));
    // the grooves have 20 and 5 turns
    let (one_layer, many_layers) = (vec![0.7, 33.0, 126.0], vec![31.0, 0.7, -4.0, -30.0, -33.0, -60.0, -64.0, -96.0]);
    [
        (drum(None, None), vec![-50.0, 0.7, 300.0]),
        (guided(drum(None, None)), vec![-50.0, 300.0]),
        (one, one_layer.clone()),
        (guided(one), one_layer),
        (many, many_layers.clone()),
        (guided(many), many_layers),
    ]
    .map(|(parameters, angles)| (Drum::new(parameters).unwrap(), angles))
    .into()
}

#[test]
fn angle_and_length_are_inverse_to_each_other_in_every_layer() {
    for (drum, angles) in drums() {
        for angle in angles {
            let length = drum.length(angle).unwrap();
            let back = drum.angle(length).unwrap();
            // rounding of lengths of 30 m over a radius of 0.1 m
            assert!((back - angle).abs() < 1e-12, "{angle} {back}");
            assert!((drum.length(back).unwrap() - length).abs() < 1e-12);
        }
        let start = *drum.parameters();
        assert!((drum.length(start.start_angle).unwrap() - start.start_length).abs() < 1e-12);
    }
}

#[test]
fn derivatives_by_angle_radius_pitch_and_pulley_agree_with_differences() {
    for (drum, angles) in drums() {
        // at a change of layer the derivatives jump
        for angle in angles.into_iter().filter(|angle| *angle != 0.7) {
            let found = drum.gradient(angle).unwrap();
            // central differences over 1e-5: truncation ~ 1e-10 times third derivatives, rounding ~ 1e-15/1e-5
            let slope = |change: &dyn Fn(&mut Parameters, f64) -> f64| {
                let at = |step: f64| {
                    let mut parameters = *drum.parameters();
                    let turn = change(&mut parameters, step);
                    Drum::new(parameters).unwrap().length(angle + turn).unwrap()
                };
                (at(1e-5) - at(-1e-5)) / 2e-5
            };
            let mut pairs = vec![
                (found.by_angle, slope(&|_, step| step)),
                (
                    found.by_radius,
                    slope(&|drum, step| {
                        drum.radius += step;
                        0.0
                    }),
                ),
                (
                    found.by_pitch,
                    slope(&|drum, step| {
                        drum.pitch += step;
                        0.0
                    }),
                ),
                (
                    found.by_start_length,
                    slope(&|drum, step| {
                        drum.start_length += step;
                        0.0
                    }),
                ),
                (
                    -found.by_angle,
                    slope(&|drum, step| {
                        drum.start_angle += step;
                        0.0
                    }),
                ),
            ];
            for axis in 0..3 {
                pairs.push((
                    found.by_pulley[axis],
                    slope(&|drum, step| {
                        if let Some(mounting) = &mut drum.mounting {
                            mounting.pulley[axis] += step;
                        }
                        0.0
                    }),
                ));
            }
            for (index, (analytic, difference)) in pairs.into_iter().enumerate() {
                let scale = analytic.abs().max(1.0);
                assert!((analytic - difference).abs() < 2e-6 * scale, "{index} at {angle}: {analytic} {difference}");
            }
        }
    }
}

/// Derivatives by angle, radius, pitch, the pulley and a turn of the axis.
type Dual = DualVec<f64, Const<9>>;

/// The first layer's law again in dual numbers, from the drum's position in the world.
#[test]
fn derivatives_by_the_drum_and_its_axis_agree_with_dual_numbers() {
    let variable =
        |value: f64, index: usize| Dual::new(value, num_dual::Derivative::some(SVector::<f64, 9>::ith(index, 1.0)));
    for angle in [-50.0, 0.7, 33.0, 300.0] {
        let parameters = drum(None, None);
        let found = Drum::new(parameters).unwrap().gradient(angle).unwrap();
        let mounting = parameters.mounting.unwrap();
        let vector = |v: Vector3<f64>, first: usize| [0, 1, 2].map(|k| variable(v[k], first + k));
        let turn = vector(Vector3::zeros(), 6);
        let axis = mounting.axis.map(Dual::from).into();
        let axis = crate::scalar::add(axis, crate::scalar::cross(turn, axis));
        let place = mounting.position.map(Dual::from).into();
        let from = crate::scalar::sub(vector(mounting.pulley, 3), place);
        let along = crate::scalar::dot(axis, from);
        let pulley = FirstPulley { distance_squared: crate::scalar::dot(from, from) - along * along, contact: -along };
        let turns = Turns {
            radius: variable(parameters.radius, 1),
            travel: variable(parameters.pitch, 2) / TAU,
            pulley: Some(pulley),
            build_up: Dual::from(0.0),
        };
        let length = turns.paid_out(variable(angle, 0) - parameters.start_angle);
        let expected = length.eps.unwrap_generic(Const, Const::<1>);
        let mut all = vec![found.by_angle, found.by_radius, found.by_pitch];
        all.extend(found.by_pulley.iter());
        // a turn ω moves the axis by ω × n
        all.extend((0..3).map(|k| found.by_axis.dot(&Vector3::ith(k, 1.0).cross(&mounting.axis))));
        for (index, (found, expected)) in all.iter().zip(expected.iter()).enumerate() {
            // rounding of lengths of 30 m
            assert!(
                (found - expected).abs() < 1e-12 * expected.abs().max(1.0),
                "{index} at {angle}: {found} {expected}"
            );
        }
    }
}

/// Turns of the axis in every layer, guided drums too, whose length does not depend on it.
#[test]
fn derivatives_by_the_axis_agree_with_differences_in_every_layer() {
    for (drum, angles) in drums() {
        for angle in angles.into_iter().filter(|angle| *angle != 0.7) {
            let by_axis = drum.gradient(angle).unwrap().by_axis;
            for k in 0..3 {
                let Some(mounting) = drum.parameters().mounting else {
                    assert_eq!(by_axis, Vector3::zeros());
                    continue;
                };
                let across = Vector3::ith(k, 1.0).cross(&mounting.axis);
                let at = |step: f64| {
                    let turned = Mounting { axis: (mounting.axis + across * step).normalize(), ..mounting };
                    let parameters = Parameters { mounting: Some(turned), ..*drum.parameters() };
                    Drum::new(parameters).unwrap().length(angle).unwrap()
                };
                // central differences over 1e-5, as above
                let slope = (at(1e-5) - at(-1e-5)) / 2e-5;
                assert!((by_axis.dot(&across) - slope).abs() < 2e-6, "{k} at {angle}: {by_axis:?} {slope}");
            }
        }
    }
}

/// The cable from drum to pulley is tangent to the drum, and the length that the drum unwinds less the change of the
/// free part passes over the pulley.
#[test]
fn the_free_part_leaves_the_drum_tangentially_on_its_side() {
    for side in [DrumSide::Left, DrumSide::Right] {
        let mut parameters = drum(None, None);
        let mounting = parameters.mounting.as_mut().unwrap();
        mounting.side = side;
        let mounting = *mounting;
        let drum = Drum::new(parameters).unwrap();
        let (start, later) = (0.7, 60.7);
        let departure = |angle: f64| drum.departure(angle).unwrap().unwrap();
        let (first, last) = (departure(start), departure(later));
        for found in [first, last] {
            let free = mounting.pulley - found.contact;
            let from_axis = found.contact - mounting.position;
            let spoke = from_axis - mounting.axis * mounting.axis.dot(&from_axis);
            assert!((free.norm() - found.free_length).abs() < 1e-13);
            assert!((spoke.norm() - 0.1).abs() < 1e-14);
            assert!(free.dot(&spoke).abs() < 1e-13);
            assert!((found.fleet_angle.sin() - mounting.axis.dot(&free) / free.norm()).abs() < 1e-13);
            // the drum's surface moves towards the pulley when it pays out
            let velocity = mounting.axis.cross(&spoke) * side.sign();
            assert!(velocity.dot(&free) > 0.0);
        }
        let wound = 60.0 * f64::hypot(0.1, 0.008 / TAU);
        let paid = drum.length(later).unwrap() - drum.length(start).unwrap();
        assert!((paid - (wound - (last.free_length - first.free_length))).abs() < 1e-12);
    }
}

/// The n-th layer has the radius r + (n − 1) · layer height, and starts where the one below is full.
#[test]
fn layers_grow_and_join_without_a_gap() {
    let many = Parameters { mounting: None, ..drum(Some(0.04), Some(0.007)) };
    let drum = Drum::new(many).unwrap();
    let turns = 0.04 / 0.008 * TAU;
    for layer in 0..3 {
        let middle = 0.7 + turns * (0.5 - f64::from(layer));
        let slope = drum.gradient(middle).unwrap().by_angle;
        assert!((slope - f64::hypot(0.1 + 0.007 * f64::from(layer), 0.008 / TAU)).abs() < 1e-14);
        let seam = 0.7 - turns * f64::from(layer);
        let gap = drum.length(seam + 1e-9).unwrap() - drum.length(seam - 1e-9).unwrap();
        assert!(gap > 0.0 && gap < 3e-10, "{gap}");
    }
}

#[test]
fn a_groove_that_cannot_hold_the_length_says_what_it_holds() {
    let drum = Drum::new(Parameters { mounting: None, ..drum(Some(0.16), None) }).unwrap();
    // 20 turns of 0.628 m
    let capacity = 20.0 * TAU * f64::hypot(0.1, 0.008 / TAU);
    assert!((drum.capacity().unwrap() - capacity).abs() < 1e-12);
    for needed in [2.9, 3.0 + capacity + 0.1] {
        let error = drum.angle(needed).unwrap_err();
        assert!((error.available - capacity).abs() < 1e-12 && error.needed == needed);
        assert!((error.shortest - 3.0).abs() < 1e-12 && (error.longest - 3.0 - capacity).abs() < 1e-12);
    }
    assert!(drum.length(0.6).unwrap_err().needed < 3.0);
    assert!(drum.length(0.8 + 20.0 * TAU).unwrap_err().needed > 3.0 + capacity);
}

#[test]
fn drums_that_cannot_be_are_refused_by_key() {
    let refused = |change: &dyn Fn(&mut Parameters)| {
        let mut parameters = drum(Some(0.16), None);
        change(&mut parameters);
        Drum::new(parameters).unwrap_err().to_string()
    };
    assert!(refused(&|drum| drum.radius = 0.0).contains("drum_radius_m"));
    assert!(refused(&|drum| drum.radius = f64::NAN).contains("drum_radius_m"));
    assert!(refused(&|drum| drum.pitch = -0.01).contains("drum_pitch_m"));
    assert!(refused(&|drum| drum.pitch = 0.0).contains("drum_pitch_m"));
    assert!(refused(&|drum| drum.groove_length = Some(0.0)).contains("drum_groove_length_m"));
    assert!(refused(&|drum| drum.layer_height = Some(-1.0)).contains("drum_layer_height_m"));
    assert!(refused(&|drum| drum.radius = 5.0).contains("inside the drum"));
}

#[test]
fn gear_and_encoder_stand_between_drum_and_control() {
    let cable = Cable {
        winch: CableWinch {
            radius: Some(0.1),
            groove: Some(Groove { pitch: 0.008, ends: None }),
            guided: Some(true),
            gear_ratio: Some(-12.0),
            encoder_counts_per_turn: Some(4096.0),
            ..CableWinch::default()
        },
        ..Cable::default()
    };
    let winch = Winch::of(&cable).unwrap().unwrap();
    let turn = f64::hypot(0.1, 0.008 / TAU) * TAU;
    let angle = winch.motor_angle(turn).unwrap();
    assert!((angle + 12.0 * TAU).abs() < 1e-12);
    assert!((winch.encoder_counts(angle).unwrap() + 12.0 * 4096.0).abs() < 1e-9);
    assert!((winch.controlled_length(angle).unwrap() - turn).abs() < 1e-14);
    let ideal = Winch::ideal(&cable).unwrap().unwrap();
    assert!((ideal.controlled_length(-12.0).unwrap() - 0.1).abs() < 1e-16);
}

#[test]
fn a_missing_key_is_named() {
    let mut cable = Cable::default();
    cable.winch.radius = Some(0.1);
    assert_eq!(missing_key(&cable), Some("drum_pitch_m"));
    cable.winch.set_pitch(0.0);
    assert_eq!(missing_key(&cable), Some("drum_axis"));
    cable.winch.guided = Some(true);
    assert_eq!(missing_key(&cable), None);
}

/// A Hangprinter's spool: r = R − Q φ/2, length change (R² − r²)/(Q M), until the spool is empty.
#[test]
fn a_spool_grows_with_what_is_wound_on_it() {
    let (radius, build_up, advantage) = (0.0755, 5e-5, 2.0);
    let parameters =
        Parameters { radius, pitch: 0.0, build_up, advantage, mounting: None, start_angle: 0.0, ..drum(None, None) };
    let spool = Drum::new(parameters).unwrap();
    for angle in [-60.0, -4.931, 0.0, 7.17, 300.0] {
        let now: f64 = radius - 0.5 * build_up * angle;
        let expected = 3.0 + (radius * radius - now * now) / (build_up * advantage);
        let found = spool.gradient(angle).unwrap();
        // rounding of the difference of two squares over Q
        assert!((found.value - expected).abs() < 1e-12 && (spool.length(angle).unwrap() - expected).abs() < 1e-12);
        assert!((spool.angle(found.value).unwrap() - angle).abs() < 1e-9);
        let moved = |change: f64| {
            Drum::new(Parameters { build_up: build_up + change, ..parameters }).unwrap().length(angle).unwrap()
        };
        // the law is linear in Q
        let slope = (moved(1e-5) - moved(-1e-5)) / 2e-5;
        assert!((found.by_build_up - slope).abs() < 1e-9 * slope.abs().max(1.0), "{} {slope}", found.by_build_up);
        assert!(
            (found.by_angle - now / advantage).abs() < 1e-15 && (found.by_radius - angle / advantage).abs() < 1e-12
        );
    }
    let longest = 3.0 + radius * radius / (build_up * advantage);
    let beyond = spool.angle(longest + 0.01).unwrap_err().to_string();
    assert!(beyond.contains(&format!("up to {longest:.4} m")) && beyond.contains("spool_build_up_m"), "{beyond}");
    assert!(spool.length(2.0 * radius / build_up + 1.0).is_err());
}
