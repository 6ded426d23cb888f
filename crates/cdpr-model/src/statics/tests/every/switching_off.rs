//! As an effect's parameter goes to zero, values and derivatives go smoothly to those of the model without the effect.

use super::*;
use crate::model::{SpanEffect, StretchEffect};
use crate::robot::CableStiffness;

/// Results of a model for its cables at these tensions (N): lengths, wrenches in the pattern's degrees of freedom, and
/// their derivatives.
fn answers(model: &Model, pose: &Pose, tensions: &[f64]) -> Vec<f64> {
    let basis = model.twist_basis();
    let mut answers = Vec::new();
    for (index, &tension) in tensions.iter().enumerate() {
        let state = cable_state(model, pose, index, tension).unwrap();
        answers.extend([state.controlled_length, state.controlled_length_by_tension]);
        answers.extend(state.controlled_length_by_anchor);
        let by_pose = state.wrench_by_pose();
        for row in basis {
            answers.extend([row.dot(&state.wrench()), row.dot(&state.wrench_by_tension())]);
            answers.extend(basis.iter().map(|column| row.dot(&(by_pose * column))));
        }
    }
    answers
}

/// An effect, with the function that scales its parameter in a robot.
struct Effect {
    word: &'static str,
    scale: fn(&mut Robot, f64),
}

const EFFECTS: [Effect; 4] = [
    Effect {
        word: "pulley",
        scale: |robot, fraction| {
            each(robot, |cable| {
                cable.pulley_radius().into_iter().for_each(|radius| cable.set_pulley_radius(radius * fraction))
            })
        },
    },
    Effect {
        word: "elastic",
        scale: |robot, fraction| {
            each(robot, |cable| {
                let compliance = cable.specific_compliance().unwrap_or(1e-6);
                cable.stiffness = Some(CableStiffness::Compliance(compliance * fraction));
                cable.series_compliance = cable.series_compliance.map(|series| series * fraction);
            });
        },
    },
    Effect { word: "catenary", scale: lighter },
    Effect { word: "finite-element", scale: lighter },
];

fn lighter(robot: &mut Robot, fraction: f64) {
    each(robot, |cable| cable.linear_density = cable.linear_density.map(|density| density * fraction));
}

fn each(robot: &mut Robot, change: impl Fn(&mut crate::robot::Cable)) {
    robot.cables.iter_mut().for_each(change);
}

/// The largest difference of two lists, each entry relative to 1 plus its size.
fn gap(found: &[f64], expected: &[f64]) -> f64 {
    let relative = |(a, b): (&f64, &f64)| (a - b).abs() / (1.0 + b.abs());
    found.iter().zip(expected).map(relative).fold(0.0, f64::max)
}

/// A robot that is comparable with and without weight: sag refers strain to the unstrained length.
fn by_unstrained_length(seed: u64) -> Robot {
    let mut robot = random_robot(seed);
    each(&mut robot, |cable| {
        if cable.spring_constant().is_some() {
            cable.stiffness = Some(CableStiffness::Axial(2e6));
        }
        cable.stiffness_by = Some(StiffnessBasis::Unstrained);
        cable.tension_at = None;
    });
    robot
}

/// Every composition with each of its effects reduced: the difference goes to zero with the parameter.
#[test]
fn effects_that_vanish_leave_the_model_without_them() {
    for seed in [1, 2, 4] {
        let robot = by_unstrained_length(seed);
        for effect in &EFFECTS {
            for composition in Composition::all().filter(|all| all.effects().any(|word| word == effect.word)) {
                vanishes(&robot, effect, composition, seed);
            }
        }
    }
}

fn vanishes(robot: &Robot, effect: &Effect, composition: Composition, seed: u64) {
    let without = Model::new(robot.clone(), composition.without(effect.word)).unwrap();
    let with = |fraction: f64| {
        let mut scaled = robot.clone();
        (effect.scale)(&mut scaled, fraction);
        Model::new(scaled, composition).unwrap()
    };
    let models = [1e-3, 1e-4, 0.0].map(with);
    for (pose, tensions) in random_states(&without, 200 + seed, 2) {
        let expected = answers(&without, &pose, &tensions);
        let gaps = models.each_ref().map(|model| gap(&answers(model, &pose, &tensions), &expected));
        // at zero only rounding of wrenches of 1e4 N in the Newton steps of the sagging equations remains
        assert!(gaps[2] < 1e-8, "{composition} without {}: {:e} at 0", effect.word, gaps[2]);
        // smooth: a tenth of the parameter gives about a tenth or less of the effect
        assert!(gaps[0] < 0.05, "{composition} without {}: {:e} at 1e-3", effect.word, gaps[0]);
        assert!(gaps[1] < 0.11 * gaps[0] + 1e-8, "{composition} without {}: {gaps:?}", effect.word);
    }
}

/// With two equal slopes a law of two pieces is the linear one, for any knee.
#[test]
fn two_pieces_of_one_slope_are_the_linear_law() {
    for seed in [1, 2, 4] {
        let mut robot = by_unstrained_length(seed);
        each(&mut robot, |cable| {
            let stiffness = cable.specific_compliance().map_or(2e6, |compliance| 1.0 / compliance);
            cable.law_numbers.insert("stiffness_below_knee_EA_N", stiffness);
            cable.law_numbers.insert("stiffness_above_knee_EA_N", stiffness);
        });
        for composition in Composition::all().filter(|all| all.stretch == StretchEffect::TwoPiece) {
            let linear = Composition { stretch: StretchEffect::Linear, ..composition };
            let [expected, found] = [linear, composition].map(|of| Model::new(robot.clone(), of).unwrap());
            for (pose, tensions) in random_states(&expected, 400 + seed, 2) {
                let gap = gap(&answers(&found, &pose, &tensions), &answers(&expected, &pose, &tensions));
                // rounding, for spans that of Newton's steps
                assert!(gap < 1e-8, "{composition}: {gap:e}");
            }
        }
    }
}

/// Loops that close on the polynomial f = c₁ε + c₂ε² (represented exactly by its cubic pieces): the effect vanishes
/// with the loop's width, in values and derivatives, for any memory.
#[test]
fn loops_without_width_are_a_polynomial() {
    for seed in [1, 2, 4] {
        let mut robot = by_unstrained_length(seed);
        let coefficients = [2e6, 4e7];
        each(&mut robot, |cable| cable.tension_of_strain = Some(coefficients.to_vec()));
        let with = |width: f64| {
            let mut narrowed = robot.clone();
            each(&mut narrowed, |cable| {
                let mut table = loop_of(coefficients[0], width);
                let slopes: Vec<f64> =
                    table.strain.iter().map(|e| coefficients[0] + 2.0 * coefficients[1] * e).collect();
                (table.loading_slope_N, table.unloading_slope_N) = (Some(slopes.clone()), Some(slopes));
                cable.hysteresis = Some(table);
            });
            narrowed
        };
        for composition in Composition::all().filter(|all| all.stretch == StretchEffect::Hysteresis) {
            let polynomial = Composition { stretch: StretchEffect::Polynomial, ..composition };
            let expected = Model::new(robot.clone(), polynomial).unwrap();
            let models = [1e-3, 1e-4, 0.0].map(|width| Model::new(with(width), composition).unwrap());
            for (pose, tensions) in random_states(&expected, 300 + seed, 2) {
                let expected = answers(&expected, &pose, &tensions);
                let gaps = models.each_ref().map(|model| gap(&answers(model, &pose, &tensions), &expected));
                // A span with hysteresis strains by its middle tension, one with a polynomial at every point: 5e-6 of
                // the results; without sag only rounding.
                let rest = if composition.span != SpanEffect::Straight { 5e-6 } else { 1e-9 };
                assert!(gaps[2] < rest, "{composition}: {gaps:?}");
                assert!(gaps[0] < 0.05 && gaps[1] < 0.11 * gaps[0] + rest, "{composition}: {gaps:?}");
            }
        }
    }
}
