//! Model selection finds the machine that made the data.

use super::support::{measured, simulator, with_pulleys};
use cdpr_calibration::candidate;
use cdpr_calibration::selection::{Judgement, Selection, Settings, select};
use cdpr_calibration::unobserved;
use cdpr_model::measurement::{Fold, Samples};
use cdpr_model::model::Composition;
use cdpr_model::robot::Robot;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const SEEDS: u64 = 20;
const TRAIN: usize = 91;
const VALIDATION: usize = 60;

fn selection(start: &Robot, samples: &Samples) -> Selection {
    let fold = Fold {
        name: "held out".to_owned(),
        train: (0..TRAIN).collect(),
        validation: (TRAIN..TRAIN + VALIDATION).collect(),
    };
    select(start, &candidate::defaults(start, Default::default()), samples, &[fold], &Settings::default(), &unobserved)
        .unwrap()
}

fn judgement(selection: &Selection, index: usize) -> &Judgement {
    selection.candidates[index].outcome.as_ref().unwrap()
}

/// Seeds for which the machine's own model, or a simpler one within one standard error of the best, is recommended.
fn successes(
    truth: &str,
    start: &Robot,
    composition: Composition,
    machine: impl Fn(&mut ChaCha8Rng) -> Robot,
) -> usize {
    let mut good = 0;
    let mut recommended = std::collections::BTreeMap::<String, usize>::new();
    for seed in 0..SEEDS {
        let machine = machine(&mut ChaCha8Rng::seed_from_u64(1000 + seed));
        let samples = measured(&machine, composition, TRAIN + VALIDATION, 0.1, seed);
        let selection = selection(start, &samples);
        let own = selection.candidates.iter().position(|c| c.name == truth).expect("the ladder has the truth");
        let (best, chosen) = (selection.best.unwrap(), selection.recommended.unwrap());
        let limit = judgement(&selection, best).criterion + judgement(&selection, best).standard_error;
        let within = judgement(&selection, chosen).criterion <= limit;
        good += usize::from(chosen == own || (chosen < own && within));
        *recommended.entry(selection.candidates[chosen].name.clone()).or_default() += 1;
    }
    println!("truth {truth}: {good} of {SEEDS}; recommended {recommended:?}");
    good
}

#[test]
fn a_machine_with_offsets_is_recognised() {
    let good = successes("standard:length-offset", &simulator(), Composition::STANDARD, |rng| {
        let mut robot = simulator();
        for cable in &mut robot.cables {
            cable.length_offset = Some(rng.random_range(-0.02..0.02));
        }
        robot
    });
    assert!(good >= 18, "{good}");
}

#[test]
fn a_machine_with_moved_anchors_is_recognised() {
    let good = successes("standard:frame-anchor", &simulator(), Composition::STANDARD, |rng| {
        let mut robot = simulator();
        for cable in &mut robot.cables {
            cable.frame_anchor.iter_mut().for_each(|x| *x += rng.random_range(-0.03..0.03));
        }
        robot
    });
    assert!(good >= 18, "{good}");
}

#[test]
fn a_machine_with_an_unknown_pulley_radius_is_recognised() {
    let start = with_pulleys(&simulator(), 0.161);
    let good = successes("pulley:pulley-radius", &start, Composition::PULLEY, |rng| {
        let mut robot = start.clone();
        for cable in &mut robot.cables {
            cable.set_pulley_radius(rng.random_range(0.1..0.14));
        }
        robot
    });
    assert!(good >= 18, "{good}");
}

#[test]
fn a_nominal_machine_is_left_as_it_is() {
    let good = successes("standard", &simulator(), Composition::STANDARD, |_| simulator());
    assert!(good >= 18, "{good}");
}
