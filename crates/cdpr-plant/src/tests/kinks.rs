//! Cables that go slack and taut again within one step.

use super::oracle::reference;
use super::*;

/// Fine step for the search of the excursion (s).
const FINE: f64 = 2e-5;

/// The simulator displaced by this size and moving.
fn swinging(size: f64, damping: f64) -> (Plant, PlantState) {
    let plant = plant(simulator(), Composition::ELASTIC, damping);
    let shift = [0.004, -0.003, 0.003, 0.002, -0.002, 0.003].map(|part| size * part);
    let mut state = displaced(&plant, &at_home(&plant, 6000.0), &shift);
    state.set_twist(&Twist::new(0.05, -0.03, 0.02, 0.1, 0.15, -0.1));
    plant.observe(&mut state).unwrap();
    (plant, state)
}

/// Least unclipped sum of law and damper of all cables along the motion (N), and the interval in which it is negative
/// (s).
fn excursion(size: f64, damping: f64, step: f64) -> (f64, f64, f64) {
    let (plant, mut state) = swinging(size, damping);
    let (mut least, mut from, mut until) = (f64::MAX, f64::MAX, 0.0);
    for index in 1..=(0.12_f64 / step).round() as usize {
        hold(&plant, &mut state, step, 1);
        let sums = (0..8).map(|cable| plant.unclipped(&state, cable, &state.twist()));
        let low = sums.fold(f64::MAX, f64::min);
        least = f64::min(least, low);
        if low < 0.0 {
            (from, until) = (f64::min(from, index as f64 * step), index as f64 * step);
        }
    }
    (least, from, until)
}

/// A motion in which one cable is slack for some tenths of a millisecond, and the time at which it goes slack (s).
fn grazing(damping: f64) -> (f64, f64) {
    let (mut taut, mut slack) = (1.0, 12.0);
    loop {
        let size = 0.5 * (taut + slack);
        let (least, from, until) = excursion(size, damping, FINE);
        match (least > 0.0, until - from) {
            (true, _) => taut = size,
            (_, long) if long > 6e-4 => slack = size,
            (_, short) if short > 2e-4 => return (size, from),
            _ => taut = size,
        }
    }
}

/// A millisecond in the middle of which a cable is slack, and taut at both ends: with a cut there it is as accurate as
/// any other step.
#[test]
fn a_cable_that_is_slack_within_one_step_only_is_seen() {
    for damping in [0.0, 300.0] {
        let (size, from) = grazing(damping);
        let (plant, mut start) = swinging(size, damping);
        let before = from - 3e-4;
        hold(&plant, &mut start, before / 1000.0, 1000);
        let mut gaps = [0.0; 2];
        for (is_cut, gap) in [(true, 0), (false, 1)] {
            let mut state = start.clone();
            let lengths: Vec<f64> = state.cables.iter().map(|cable| cable.controlled_length).collect();
            let command = Command::lengths(&lengths);
            match is_cut {
                true => plant.step(&mut state, &command, 1e-3).unwrap(),
                false => {
                    plant.prepare(&mut state, &command, 1e-3).unwrap();
                    plant.stages(&mut state, 1e-3).unwrap();
                    plant.observe(&mut state).unwrap();
                }
            }
            let is_taut = |state: &PlantState| state.cables.iter().all(|cable| cable.tension > 0.0);
            assert!(is_taut(&start) && is_taut(&state), "neither end shows it");
            // lets the error of the momentum become one of the pose
            hold(&plant, &mut state, 1e-4, 100);
            gaps[gap] = apart(&reference(&plant, &start, damping, 0.011), &state.pose);
        }
        println!("damping {damping}: {:.1e} m cut, {:.1e} m uncut", gaps[0], gaps[1]);
        // with dampers the kink of the force lies within a kick, at a fixed pose
        let tolerance = if damping == 0.0 { 2e-12 } else { 1e-9 };
        assert!(gaps[0] < tolerance && gaps[1] > 5.0 * gaps[0], "{damping}: {gaps:?}");
    }
}
