//! Runs of a library's integrator with error control against the symplectic step: two methods, one machine.

use std::convert::Infallible;
use std::ops::ControlFlow;

use super::super::error_control::Passage;
use super::super::{Scenario, Simulation};
use super::*;
use cdpr_model::geometry::Wrench;

/// A plate with dampers that stays taut while its lengths change, one of its cables slips and a wrench acts, all
/// between two steps.
fn scenario(step: f64, more: &str) -> String {
    format!(
        "[machine]\nrobot = \"plate\"\ncable_damping_N_s_per_m = 4.0\n[start]\npose = [0.6, 0.6, 0]\ntension_method = \"closed-form\"\n\
         tension_limits_N = [60, 140]\ndisplacement = [0.002, -0.001, 0.003]\n[control]\nkind = \"length-changes\"\ntime_s = [0, 0.2, 0.4]\n\
         length_change_m = [[0, 0, 0, 0], [-0.004, 0.001, 0.003, -0.002], [0, 0, 0, 0]]\n[[event]]\ntime_s = 0.1003\nkind = \"slip\"\n\
         cable = 2\nlength_m = 0.002\n[[event]]\ntime_s = 0.15\nkind = \"wrench\"\nwrench = [3, -2, 0.1]\n[time]\nduration_s = 0.3\n\
         step_s = {step}\nrecord_s = 0.1\n{more}"
    )
}

fn end(text: &str) -> (Vec<PlantState>, Vec<(f64, &'static str)>, u64) {
    let scenario = Scenario::from_toml_bytes(text.as_bytes(), "scenario.toml").unwrap();
    let mut robot = plate();
    robot.home = None;
    let mut simulation = Simulation::new(&scenario, robot).unwrap();
    let mut rows = Vec::new();
    let summary = simulation.run(|_, state| {
        rows.push(state.clone());
        Ok::<_, Infallible>(ControlFlow::Continue(()))
    });
    let summary = summary.unwrap();
    assert!(summary.tension_min > 0.0, "a slack cable has another order");
    assert_eq!(summary.end, super::super::RunEnd::Completed);
    (rows, summary.events.iter().map(|event| (event.time, event.happening.kind())).collect(), summary.steps)
}

/// The gap falls with the fourth power of the symplectic step, which is its order; rows, events and tensions are the
/// same.
#[test]
fn free_runs_differ_by_the_order_of_the_symplectic_step() {
    let (exact, events, _) = end(&scenario(1e-3, "integrator = \"error-controlled\"\ntolerance = 1e-12\n"));
    let gap = |step: f64| {
        let (rows, happened, steps) = end(&scenario(step, ""));
        assert_eq!((rows.len(), happened), (exact.len(), events.clone()));
        assert!(steps >= (0.3 / step).round() as u64);
        let mut worst: f64 = 0.0;
        for (found, exact) in rows.iter().zip(&exact) {
            assert_eq!(found.time, exact.time);
            worst = worst.max(apart(&found.pose, &exact.pose));
            for (one, other) in found.cables.iter().zip(&exact.cables) {
                assert!((one.controlled_length - other.controlled_length).abs() < 1e-14);
                // springs of 3 kN/m on gaps of 1e-8 m and less, dampers beside them
                assert!((one.tension - other.tension).abs() < 1e-3, "{} {}", one.tension, other.tension);
            }
        }
        worst
    };
    let [coarse, fine] = [5e-3, 2.5e-3].map(gap);
    let order = (coarse / fine).log2();
    println!("gaps {coarse:.1e} {fine:.1e} m, order {order:.2}");
    assert!((3.3..5.0).contains(&order), "{order}");
    assert!(gap(1e-3) < 1e-10, "{:e}", gap(1e-3));
}

/// The error of the result follows the tolerance, and more frequent rows change nothing else.
#[test]
fn results_follow_the_tolerance_and_not_the_rows() {
    let at = |tolerance: &str, record: &str| {
        let text = scenario(1e-3, &format!("integrator = \"error-controlled\"\ntolerance = {tolerance}\n"));
        let (rows, _, steps) = end(&text.replace("record_s = 0.1\n", record));
        (rows.last().unwrap().pose, steps)
    };
    let (exact, most) = at("1e-13", "record_s = 0.1\n");
    let (often, _) = at("1e-13", "record_s = 0.01\n");
    assert!(apart(&exact, &often) < 1e-12, "{:e}", apart(&exact, &often));
    let (rough, few) = at("1e-6", "record_s = 0.1\n");
    let off = apart(&exact, &rough);
    println!("tolerance 1e-6: {off:.1e} m in {few} steps, 1e-13: {most} steps");
    assert!(off < 1e-5 && off > 0.0 && few < most, "{off:e} {few} {most}");
}

/// Drums that turn under torques and a growing wrench, in space.
#[test]
fn drums_and_growing_wrenches_agree_with_small_symplectic_steps() {
    let mut robot = simulator();
    for cable in &mut robot.cables {
        cable.winch.radius = Some(0.1525);
        cable.winch.drum_inertia = Some(0.6);
        cable.winch.viscous_friction = Some(5.0);
    }
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let plant = Plant::with_damping(model, Winches::Drums, vec![Damping { constant: 500.0, time: 1e-4 }; 8]).unwrap();
    let start = at_home(&plant, 6000.0);
    let mut torques = plant.holding_torques(&start).unwrap();
    (torques[0], torques[5]) = (torques[0] + 20.0, torques[5] - 10.0);
    let wrench = Wrench::new(200.0, -100.0, 300.0, 20.0, -10.0, 30.0);
    let time = 0.1;
    let mut controlled = start.clone();
    let passage = Passage { time, tolerance: 1e-12, wrenches: [Wrench::zeros(), wrench] };
    let steps = plant.advance(&mut controlled, &Command::torques(&torques), &passage, &mut |_| {}).unwrap();
    let [coarse, fine] = [400, 800].map(|count| {
        let mut state = start.clone();
        for index in 0..count {
            // the mean over a step: the effect of the wrench's growth within it falls with the square of the step
            state.external = wrench * ((f64::from(index) + 0.5) / f64::from(count));
            plant.step(&mut state, &Command::torques(&torques), time / f64::from(count)).unwrap();
        }
        for ((one, other), before) in controlled.cables.iter().zip(&state.cables).zip(&start.cables) {
            assert!((one.drum_angle - other.drum_angle).abs() < 1e-7, "{} {}", one.drum_angle, other.drum_angle);
            assert!((one.drum_angle - before.drum_angle).abs() > 1e-5, "the drum turns");
        }
        apart(&controlled.pose, &state.pose)
    });
    println!("{steps} steps, {coarse:.1e} and {fine:.1e} m beside the symplectic ones");
    assert!(coarse < 1e-8 && (3.5..4.5).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
    assert!((controlled.time - time).abs() < 1e-15);
}

/// Keys that do not belong together are refused in words, with their line; a tolerance out of reach is reported and leaves the state unchanged.
#[test]
fn what_error_control_is_not_for_is_refused() {
    let controlled = "integrator = \"error-controlled\"\n";
    let read = |text: &str| Scenario::from_toml_bytes(text.as_bytes(), "scenario.toml");
    let wrong = read(&scenario(1e-3, &format!("{controlled}tolerance = 1e-20\n"))).unwrap_err();
    assert!(wrong.to_string().contains("from 1e-13 to 1e-3") && wrong.line() == Some(27), "{wrong}");
    let idle = read(&scenario(1e-3, "tolerance = 1e-9\n")).unwrap_err();
    assert!(idle.to_string().contains("belongs to integrator"), "{idle}");
    // a step of the file that is too large for fixed steps has no effect here
    assert!(Simulation::new(&read(&scenario(0.1, controlled)).unwrap(), plate()).is_ok());

    // dampers that an explicit rule follows in steps of 20 ns, and an infinite wrench
    for (damping, wrench, told) in [(1e9, 10.0, "use a larger tolerance"), (0.0, f64::INFINITY, "beyond all numbers")] {
        let plant = plant(plate(), Composition::ELASTIC, damping);
        let mut state = at_home(&plant, 60.0);
        state.external = Wrench::repeat(wrench);
        let before = state.clone();
        let lengths: Vec<f64> = state.cables.iter().map(|cable| cable.controlled_length).collect();
        let passage = Passage { time: 0.1, tolerance: 1e-10, wrenches: [Wrench::zeros(); 2] };
        let error = plant.advance(&mut state, &Command::lengths(&lengths), &passage, &mut |_| {}).unwrap_err();
        assert!(error.to_string().contains(told), "{error}");
        assert_eq!(state, before);
    }
}
