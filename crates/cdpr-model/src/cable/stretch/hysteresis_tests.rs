//! Properties of a rope's memory: it closes its loops, loses energy, rises, and vanishes with the width of the loop.

use nalgebra::Const;
use num_dual::{Derivative, DualVec};
use proptest::prelude::*;

use super::hysteresis::{Hysteresis, Memory};
use super::hysteresis_law;
use crate::robot::HysteresisTable;
use cdpr_testing::property;

type Dual = DualVec<f64, Const<1>>;

fn variable(value: f64) -> Dual {
    Dual::new(value, Derivative::some(nalgebra::SVector::from([1.0])))
}

fn derivative(dual: Dual) -> f64 {
    dual.eps.unwrap_generic(Const, Const::<1>)[0]
}

/// A loop like that of Fig. 5.7: 12 kN at 1.5 % strain, stiffening, up to 900 N wide times `width`.
fn table(width: f64) -> HysteresisTable {
    let middle = [0.0, 300.0, 1500.0, 5000.0, 12000.0];
    let half = [0.0, 30.0, 200.0, 450.0, 350.0];
    HysteresisTable {
        strain: vec![0.0, 0.003, 0.006, 0.01, 0.015],
        loading_N: middle.iter().zip(half).map(|(m, h)| m + width * h).collect(),
        unloading_N: middle.iter().zip(half).map(|(m, h)| m - width * h).collect(),
        transition_strain: vec![0.0004, 0.0011, 0.003],
        transition_share: Some(vec![0.5, 0.3, 0.2]),
        ..HysteresisTable::default()
    }
}

pub(super) fn law() -> Hysteresis {
    hysteresis_law(&table(1.0)).unwrap()
}

/// Memory after moving through these strains, and the tensions met on the way.
fn path(law: &Hysteresis, from: Memory, strains: &[f64]) -> (Memory, Vec<f64>) {
    let mut memory = from;
    let mut tensions = Vec::new();
    for &strain in strains {
        tensions.push(law.tension(strain, &memory).0);
        memory = law.advance(strain, &memory);
    }
    (memory, tensions)
}

/// ∮ f dε along a path through these strains (J/m), each leg in fine steps.
fn work(law: &Hysteresis, from: Memory, strains: &[f64]) -> f64 {
    let mut memory = from;
    let mut sum = 0.0;
    for &strain in strains {
        let (begin, steps) = (memory.strain, 400);
        for k in 1..=steps {
            let next = begin + (strain - begin) * f64::from(k) / f64::from(steps);
            let (before, after) = (law.tension(memory.strain, &memory).0, law.tension(next, &memory).0);
            sum += 0.5 * (before + after) * (next - memory.strain);
            memory = law.advance(next, &memory);
        }
    }
    sum
}

#[test]
fn a_long_motion_ends_on_its_branch() {
    let law = law();
    let up = law.tension(0.012, &law.advance(0.001, &Memory::virgin())).0;
    assert!((up - law.loading(0.012).0).abs() < 1e-9);
    let down = law.tension(0.006, &law.advance(0.014, &Memory::virgin())).0;
    assert!((down - law.unloading(0.006).0).abs() < 1e-9);
    // the knots of the table
    assert!((law.loading(0.01).0 - 5450.0).abs() < 1e-9 && (law.unloading(0.01).0 - 4550.0).abs() < 1e-9);
}

/// A path in one step and in many leads to the same state: nothing is integrated.
#[test]
fn the_state_depends_on_turning_points_only() {
    let law = law();
    let start = law.advance(0.011, &Memory::virgin());
    let coarse = law.advance(0.0098, &start);
    let fine = (1..=100).fold(start, |memory, k| law.advance(0.011 - 1.2e-5 * f64::from(k), &memory));
    for (a, b) in coarse.stops.iter().zip(fine.stops) {
        // a hundred roundings of Δε/r, which is about 1
        assert!((a - b).abs() < 1e-11);
    }
}

#[test]
fn derivatives_agree_with_dual_numbers() {
    let law = law();
    let memories = [
        Memory::virgin(),
        Memory::on_loading_branch(0.009),
        Memory::on_unloading_branch(0.009),
        law.advance(0.0093, &Memory::on_unloading_branch(0.009)),
    ];
    for memory in memories {
        for strain in [-0.001, 0.0005, 0.004, 0.0085, 0.0091, 0.0099, 0.014, 0.017] {
            let (tension, slope) = law.tension(variable(strain), &memory);
            assert!((derivative(tension) / slope.re - 1.0).abs() < 1e-12, "{memory:?} at {strain}");
        }
        for tension in [-10.0, 40.0, 900.0, 4000.0, 11000.0, 16000.0] {
            let (strain, compliance) = law.strain(variable(tension), &memory);
            assert!((derivative(strain) / compliance.re - 1.0).abs() < 1e-11, "{memory:?} at {tension}");
        }
    }
}

/// Central differences give the same slope, so that the dual numbers took the right branch.
#[test]
fn derivatives_agree_with_differences() {
    let law = law();
    let memory = Memory::on_loading_branch(0.009);
    for strain in [0.0051, 0.0087, 0.0095, 0.0152, 0.03] {
        let step = 1e-8;
        let slope = (law.tension(strain + step, &memory).0 - law.tension(strain - step, &memory).0) / (2.0 * step);
        // rounding of 1e4 N by 1e-16 over the step: 1e-4 N, of slopes of 1e6 N
        assert!((law.tension(strain, &memory).1 / slope - 1.0).abs() < 1e-6, "{strain}");
    }
}

#[test]
fn a_loop_without_width_is_the_middle_line_whatever_the_memory() {
    let line = hysteresis_law(&table(0.0)).unwrap();
    for memory in [Memory::virgin(), Memory::on_loading_branch(0.008), Memory::on_unloading_branch(0.002)] {
        for strain in [-0.001, 0.004, 0.008, 0.02] {
            assert_eq!(line.tension(strain, &memory), line.tension(strain, &Memory::virgin()));
        }
    }
}

/// The width enters value and slope in proportion, so it switches off smoothly.
#[test]
fn hysteresis_switches_off_smoothly() {
    let line = hysteresis_law(&table(0.0)).unwrap();
    let memory = Memory::on_loading_branch(0.0085);
    for width in [1e-2, 1e-4, 1e-6] {
        let law = hysteresis_law(&table(width)).unwrap();
        let ((f, slope), (f0, slope0)) = (law.tension(0.0082, &memory), line.tension(0.0082, &memory));
        // the loop of width 1 is within 500 N, its slopes within 4e6 N
        assert!((f - f0).abs() < 500.0 * width && (slope - slope0).abs() < 4e6 * width);
    }
}

#[test]
fn the_law_is_continuous_with_its_slope_at_the_knots_and_at_the_end() {
    let law = law();
    for strain in [0.003, 0.006, 0.01, 0.015] {
        for memory in [Memory::on_loading_branch(0.0), Memory::on_unloading_branch(0.05)] {
            let (below, above) = (law.tension(strain - 1e-10, &memory), law.tension(strain + 1e-10, &memory));
            // slope 2e6 N and curvature 1e9 N over 2e-10
            assert!((below.0 - above.0).abs() < 1e-3 && (below.1 - above.1).abs() < 1.0, "{strain}");
        }
    }
}

/// Beyond the table the branches come closer without meeting.
#[test]
fn beyond_the_end_unloading_stays_below_loading() {
    let law = law();
    for strain in [0.016, 0.03, 0.3, 3.0] {
        let (up, down) = (law.loading(strain), law.unloading(strain));
        assert!(up.0 > down.0 && up.1 > 0.0 && down.1 > 0.0, "{strain}");
    }
}

#[test]
fn the_loss_of_a_cycle_is_the_area_of_its_loop() {
    let law = law();
    let bottom = path(&law, Memory::virgin(), &[0.014, 0.004]).0;
    let area = work(&law, bottom, &[0.014, 0.004]);
    // both sides by trapezoids in steps of 2.5e-5
    assert!((law.cycle_loss(0.004, 0.014, 400) / area - 1.0).abs() < 1e-9 && area > 0.0);
}

proptest! {
    #![proptest_config(property::cases(256))]

    #[test]
    fn the_strain_is_the_inverse_of_the_tension(turns in prop::collection::vec(0.0..0.016_f64, 1..6), tension in -200.0..20_000.0_f64) {
        let law = law();
        let memory = path(&law, Memory::virgin(), &turns).0;
        let (strain, compliance) = law.strain(tension, &memory);
        let (found, _) = law.tension(strain, &memory);
        // rounding of the strain, 2e-18, times slopes up to 4e6 N; near zero tension the stops' slope is small
        prop_assert!((found - tension).abs() < 1e-9 && compliance > 0.0);
    }

    /// Return-point memory: after any small loops inside, the way back to a turning point closes there.
    #[test]
    fn minor_loops_close(turns in prop::collection::vec(0.0..0.016_f64, 1..5), a in 0.002..0.014_f64, b in 0.002..0.014_f64) {
        let law = law();
        let start = path(&law, Memory::virgin(), &turns).0;
        // after one way a → b → a the loop repeats
        let (_, tensions) = path(&law, start, &[a, b, a, b, a, b]);
        prop_assert!((tensions[3] - tensions[5]).abs() < 1e-9 && (tensions[2] - tensions[4]).abs() < 1e-9);
        // and a loop inside it is forgotten after it has closed
        let inside = a + 0.4 * (b - a);
        let (with, _) = path(&law, start, &[a, b, a, inside, a, b]);
        let (without, _) = path(&law, start, &[a, b, a, b]);
        for (one, other) in with.stops.iter().zip(without.stops) {
            prop_assert!((one - other).abs() < 1e-11);
        }
    }

    #[test]
    fn closed_cycles_lose_energy(turns in prop::collection::vec(0.0..0.016_f64, 1..5), a in 0.0..0.015_f64, b in 0.0..0.015_f64) {
        let law = law();
        let start = path(&law, Memory::virgin(), &turns).0;
        let settled = path(&law, start, &[a, b, a]).0;
        let loss = work(&law, settled, &[b, a]);
        // a cycle within the narrowest stop is elastic: the trapezoids of both directions are then equal to rounding
        prop_assert!(loss > -1e-9, "{loss}");
        if (a - b).abs() > 0.0005 && a.min(b) > 1e-4 {
            prop_assert!(loss > 0.0);
        }
    }

    #[test]
    fn more_strain_is_more_tension(turns in prop::collection::vec(0.0..0.016_f64, 1..6), a in -0.001..0.03_f64, step in 1e-6..0.01_f64) {
        let law = law();
        let memory = path(&law, Memory::virgin(), &turns).0;
        prop_assert!(law.tension(a + step, &memory).0 > law.tension(a, &memory).0);
        prop_assert!(law.tension(a, &memory).1 > 0.0);
    }

    #[test]
    fn tensions_stay_between_the_branches(turns in prop::collection::vec(0.0..0.02_f64, 1..8)) {
        let law = law();
        let (memory, tensions) = path(&law, Memory::virgin(), &turns);
        prop_assert!(memory.stops.iter().all(|stop| stop.abs() <= 1.0));
        for (strain, tension) in turns.iter().zip(tensions) {
            let (up, down) = (law.loading(*strain).0, law.unloading(*strain).0);
            prop_assert!(tension <= up + 1e-9 && tension >= down - 1e-9);
        }
    }
}
