//! Limits judged at every step, runs that end early, and the volume of a run known before it.

use std::convert::Infallible;
use std::ops::ControlFlow;

use super::super::{RunEnd, Scenario, Simulation, StepError, Summary, Violation};
use super::*;
use cdpr_model::robot::Robot;

const PLATE: &str = "[machine]\nrobot = \"plate\"\ncable_damping_N_s_per_m = 2.0\n[start]\npose = [0.6, 0.6, 0]\n\
                     tension_method = \"closed-form\"\ntension_limits_N = [20, 100]\n";

fn limited() -> Robot {
    let mut robot = plate();
    for cable in &mut robot.cables {
        (cable.tension_min, cable.tension_max) = (Some(30.0), Some(75.0));
    }
    robot
}

fn run(text: &str, robot: Robot) -> (Vec<PlantState>, Summary) {
    let scenario = Scenario::from_toml_bytes(text.as_bytes(), "scenario.toml").unwrap();
    let mut simulation = Simulation::new(&scenario, robot).unwrap();
    let mut rows = Vec::new();
    let summary = simulation.run(|_, state| {
        rows.push(state.clone());
        Ok::<_, Infallible>(ControlFlow::Continue(()))
    });
    (rows, summary.unwrap())
}

/// First time, worst tension and duration of a limit.
#[derive(Debug, PartialEq)]
struct Figures {
    first: f64,
    worst: f64,
    duration: f64,
}

/// The figures of every cable and limit from the intervals that a run found.
fn figures(found: &[Violation]) -> Vec<((usize, Option<&'static str>), Figures)> {
    let mut all: Vec<((usize, Option<&'static str>), Figures)> = Vec::new();
    for one in found {
        let key = (one.cable, one.limit);
        match all.iter_mut().find(|(other, _)| *other == key) {
            Some((_, figures)) => {
                figures.duration += one.duration;
                let pick = if one.limit == Some("tension_max_N") { f64::max } else { f64::min };
                figures.worst = pick(figures.worst, one.worst);
            }
            None => all.push((key, Figures { first: one.from, worst: one.worst, duration: one.duration })),
        }
    }
    all
}

/// The figures of a limit computed from rows at every step.
fn of_rows(rows: &[PlantState], (cable, limit): (usize, Option<&'static str>)) -> Figures {
    let tension = |row: &PlantState| row.cables[cable].tension;
    let is_largest = limit == Some("tension_max_N");
    let breaks = |row: &PlantState| if is_largest { tension(row) > 75.0 } else { tension(row) < 30.0 };
    let pick = if is_largest { f64::max } else { f64::min };
    Figures {
        first: rows.iter().find(|row| breaks(row)).map_or(f64::NAN, |row| row.time),
        worst: rows.iter().map(tension).reduce(pick).unwrap(),
        duration: rows.windows(2).filter(|pair| breaks(&pair[1])).map(|pair| pair[1].time - pair[0].time).sum(),
    }
}

/// A plate that swings for a second between its two rows: its violations are those computed from rows at every step.
#[test]
fn limits_are_judged_at_every_step_and_not_at_rows() {
    let text = PLATE.to_owned() + "displacement = [0.005, 0, 0]\n[time]\nduration_s = 1.0\nrecord_s = ";
    let (rare, summary) = run(&(text.clone() + "1.0\n"), limited());
    let (rows, often) = run(&(text.clone() + "0.001\n"), limited());
    assert_eq!((rare.len(), rows.len()), (2, 1001));
    let found = figures(&summary.violations);
    for limit in ["tension_min_N", "tension_max_N"] {
        assert!(found.iter().any(|(key, _)| key.1 == Some(limit)), "{limit}: {found:?}");
    }
    for (key, figures) in &found {
        let expected = of_rows(&rows, *key);
        assert_eq!((figures.first, figures.worst), (expected.first, expected.worst), "{key:?}");
        assert!(
            (figures.duration - expected.duration).abs() < 1e-12 && expected.duration > 0.01,
            "{key:?}: {figures:?}"
        );
    }
    assert!(often.violations.len() > found.len(), "stretches less than a record apart are one");
    let low = found.iter().filter(|(key, _)| key.1 == Some("tension_min_N")).map(|(_, figures)| figures.worst);
    assert_eq!(low.fold(f64::INFINITY, f64::min), summary.tension_min, "the least tension is that of the worst limit");
    // steps with error control are fewer, and each is judged
    let (_, controlled) = run(&(text + "1.0\nintegrator = \"error-controlled\"\n"), limited());
    for ((key, one), (other_key, other)) in found.iter().zip(figures(&controlled.violations)) {
        assert_eq!(*key, other_key);
        assert!((one.worst - other.worst).abs() < 2.0, "{one:?} {other:?}");
        assert!((one.duration - other.duration).abs() < 0.1, "{one:?} {other:?}");
    }
}

/// Tensions at a limit do not break it, a cable that breaks breaks no limit, and a slack one breaks a limit if a least
/// tension is stated.
#[test]
fn rounding_breaks_and_slack_cables_are_judged_as_what_they_are() {
    let still = PLATE.to_owned() + "[time]\nduration_s = 0.2\n";
    let at_rest = run(&still, limited()).0.remove(0);
    let mut robot = plate();
    for (cable, state) in robot.cables.iter_mut().zip(&at_rest.cables) {
        (cable.tension_min, cable.tension_max) = (Some(state.tension), Some(state.tension));
    }
    assert_eq!(run(&still, robot).1.violations, []);
    let broken = still.clone() + "[[event]]\ntime_s = 0.05\nkind = \"cable-break\"\ncable = 2\n";
    let (_, summary) = run(&broken, limited());
    assert!(summary.violations.iter().all(|found| found.cable != 1), "{:?}", summary.violations);
    let slack = still + "[[event]]\ntime_s = 0.05\nkind = \"slip\"\ncable = 2\nlength_m = 0.5\n";
    let of_second = |robot: Robot| {
        let found = run(&slack, robot).1.violations.into_iter().find(|found| found.cable == 1).unwrap();
        (found.limit, found.worst)
    };
    assert_eq!(of_second(limited()), (Some("tension_min_N"), 0.0));
    let mut unlimited = plate();
    unlimited.cables.iter_mut().for_each(|cable| (cable.tension_min, cable.tension_max) = (None, None));
    assert_eq!(of_second(unlimited), (None, 0.0));
}

/// A winch that reels in all its cable and 0.24 m more would have a length of −0.24 m and 281 MN: the run ends before.
#[test]
fn a_cable_without_length_ends_the_run() {
    let end = |step: &str| {
        let text = PLATE.to_owned()
            + "[control]\nkind = \"length-changes\"\ntime_s = [0, 0.1]\nlength_change_m = [[0, 0, 0, 0], [0, 0, -2.0, 0]]\n[time]\nduration_s = 0.1\n"
            + step;
        let (rows, summary) = run(&text, plate());
        assert!(rows.iter().all(|row| row.cables[2].controlled_length > 0.0));
        summary.end
    };
    for step in ["record_s = 0.001\n", "integrator = \"error-controlled\"\n"] {
        let RunEnd::Failed(error) = end(step) else { panic!("it went on") };
        assert!(matches!(error, StepError::NoLength { cable: 3, length } if length <= 0.0), "{error}");
        assert!(error.to_string().starts_with("cable 3 has no length left"), "{error}");
    }
}

/// A moment of 1e6 N·m would turn the platform by thousands of radians per step (40 s for 1000 steps): the run ends
/// within some steps.
#[test]
fn a_spin_beyond_a_radian_a_step_ends_the_run() {
    let text = "[machine]\nrobot = \"simulator\"\n[start]\npose = [0, 0, 1.5, 0, 0, 0]\ntension_method = \"closed-form\"\n\
                [[event]]\ntime_s = 0\nkind = \"wrench\"\nwrench = [0, 0, 0, 0, 0, 1e6]\n[time]\nduration_s = 1.0\n";
    let (_, summary) = run(text, simulator());
    let RunEnd::Failed(error) = summary.end else { panic!("it went on for {} steps", summary.steps) };
    assert!(matches!(error, StepError::Spin { turn } if turn > 1.0), "{error}");
    assert!(summary.steps < 100, "{}", summary.steps);
    // half a radian per step is accepted
    let spins = |rate: f64| {
        let text = PLATE.to_owned() + &format!("twist = [0, 0, {rate}]\n[time]\nduration_s = 0.001\n");
        run(&text, plate()).1.end
    };
    assert_eq!(spins(500.0), RunEnd::Completed);
    assert!(matches!(spins(1001.0), RunEnd::Failed(StepError::Spin { .. })));
}

/// Rows of the log, of the encoders, and of an inertial unit that is faster than the steps.
#[test]
fn how_much_is_recorded_is_known_before() {
    let text = PLATE.to_owned()
        + "[sensors]\nrate_Hz = 50\n[sensors.encoders]\n[sensors.imu]\nrate_Hz = 5000\n[time]\nduration_s = 1.0\n";
    let scenario = Scenario::from_toml_bytes(text.as_bytes(), "scenario.toml").unwrap();
    let volume = Simulation::new(&scenario, plate()).unwrap().volume;
    assert_eq!((volume.log_rows, volume.rows), (101, 101 + 51 + 1001));
    assert_eq!((volume.duration, volume.record_interval), (1.0, 0.01));
}
