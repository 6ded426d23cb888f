//! Scenario files: rows, events, errors.

use std::convert::Infallible;
use std::ops::ControlFlow;

use super::super::scenario::located;
use super::super::{PlantError, RunEnd, Scenario, Simulation, Summary};
use super::*;

const PLATE: &str = "[machine]\nrobot = \"plate\"\ncable_damping_N_s_per_m = 2.0\n[start]\npose = [0.6, 0.6, 0]\n\
                     tension_method = \"closed-form\"\ntension_limits_N = [20, 100]\n[time]\nduration_s = 0.1\n";

fn simulation(text: &str) -> Result<Simulation, PlantError> {
    let scenario = Scenario::from_toml_bytes(text.as_bytes(), "scenario.toml").unwrap();
    let mut robot = plate();
    robot.home = None;
    Simulation::new(&scenario, robot)
}

fn run(text: &str) -> (Vec<PlantState>, Summary, Simulation) {
    let mut simulation = simulation(text).unwrap();
    let mut rows = Vec::new();
    let summary = simulation.run(|_, state| {
        rows.push(state.clone());
        Ok::<_, Infallible>(ControlFlow::Continue(()))
    });
    (rows, summary.unwrap(), simulation)
}

#[test]
fn rows_stand_at_the_times_of_the_record_and_at_the_end() {
    let text = PLATE.to_owned() + "record_s = 0.03\n";
    let (rows, summary, _) = run(&text);
    assert_eq!(rows.iter().map(|row| row.time).collect::<Vec<_>>(), [0.0, 0.03, 0.06, 0.09, 0.1]);
    assert_eq!((summary.end, summary.steps), (RunEnd::Completed, 100));
}

/// An event between two steps splits one of them; a row at the time of an event shows the state before it.
#[test]
fn events_happen_at_their_time_and_after_its_row() {
    let text = PLATE.to_owned()
        + "record_s = 0.01\n[[event]]\ntime_s = 0.05\nkind = \"cable-break\"\ncable = 2\n[[event]]\ntime_s = 0.0204\n\
           kind = \"wrench\"\nwrench = [5, 0, 0.1]\n";
    let (rows, summary, _) = run(&text);
    assert_eq!(summary.steps, 101);
    assert_eq!(
        summary.events.iter().map(|event| event.happening.kind()).collect::<Vec<_>>(),
        ["wrench", "cable-break"]
    );
    assert_eq!(rows.len(), 11);
    assert!(apart(&rows[2].pose, &rows[0].pose) < 1e-9 && apart(&rows[3].pose, &rows[0].pose) > 1e-6);
    assert!(rows[5].cables[1].tension > 0.0 && rows[6].cables[1].tension == 0.0);
    assert!(rows[6].cables[1].is_broken);
}

/// Commanded lengths are reached at the end of every step, and a stopped winch stays.
#[test]
fn ideal_winches_follow_and_stopped_ones_stay() {
    let text = PLATE.to_owned()
        + "record_s = 0.01\n[control]\nkind = \"length-changes\"\ntime_s = [0, 0.1]\nlength_change_m = [[0, 0, 0, 0], [-0.01, -0.01, 0.01, 0.01]]\n\
           [[event]]\ntime_s = 0.05\nkind = \"winch-stop\"\ncable = 1\n[[event]]\ntime_s = 0.02\nkind = \"slip\"\ncable = 4\nlength_m = 0.004\n";
    let (rows, _, _) = run(&text);
    let change =
        |row: usize, cable: usize| rows[row].cables[cable].controlled_length - rows[0].cables[cable].controlled_length;
    assert!((change(4, 0) + 0.004).abs() < 1e-12 && (change(10, 0) + 0.005).abs() < 1e-12, "{}", change(10, 0));
    assert!((change(10, 1) + 0.01).abs() < 1e-12 && (change(10, 3) - 0.01).abs() < 1e-12);
    assert_eq!(rows[10].cables[3].slip, 0.004);
}

/// A wrench over time that is constant equals the wrench of an event.
#[test]
fn a_constant_series_is_an_event() {
    let series = PLATE.to_owned() + "[wrench]\ntime_s = [0]\nwrench = [[5, -3, 0.1]]\n";
    let event = PLATE.to_owned() + "[[event]]\ntime_s = 0\nkind = \"wrench\"\nwrench = [5, -3, 0.1]\n";
    let ((a, ..), (b, ..)) = (run(&series), run(&event));
    assert_eq!(a.last().unwrap().pose, b.last().unwrap().pose);
    assert!(apart(&a.last().unwrap().pose, &a[0].pose) > 1e-4);
}

/// Errors of the file are reported with their line, including those that only the robot shows.
#[test]
fn mistakes_are_told_at_their_place() {
    let place = |text: &str| Scenario::from_toml_bytes(text.as_bytes(), "s.toml").unwrap_err();
    let negative = place(&PLATE.replace("2.0", "-2.0"));
    assert_eq!((negative.line(), negative.code), (Some(3), "scenario::value"));
    assert!(negative.message.contains("0 or more"), "{negative}");
    let strange = place(&(PLATE.to_owned() + "record_s = 0.0015\n"));
    assert!(strange.to_string().contains("whole multiple of step_s"), "{strange}");
    let idle = place(&(PLATE.to_owned() + "[[event]]\ntime_s = 1\nkind = \"load\"\ncable = 1\n"));
    assert!(idle.to_string().contains("does not belong"), "{idle}");

    let located = |text: &str| {
        let error = simulation(text).unwrap_err();
        (located(&error, "code", text.as_bytes(), "s.toml").and_then(|error| error.line()), error.to_string())
    };
    let (line, large) = located(&(PLATE.to_owned() + "step_s = 0.1\n"));
    assert!(line == Some(10) && large.contains("use step_s = ") && large.contains("Hz"), "{large}");
    let (line, cable) = located(&(PLATE.to_owned() + "[[event]]\ntime_s = 1\nkind = \"cable-break\"\ncable = 5\n"));
    assert!(line == Some(13) && cable.contains("from 1 to 4"), "{cable}");
    let (line, pose) = located(&PLATE.replace("0.6, 0.6, 0", "0.6, 0.6"));
    assert!(line == Some(5) && pose.contains("pose components"), "{pose}");
    let (line, rest) = located(&PLATE.replace("[0.6, 0.6, 0]", "[0.6, 5.6, 0]"));
    assert!(line == Some(4) && rest.contains("no equilibrium"), "{rest}");
}

/// The advised step is accepted, and one twice as large is not.
#[test]
fn the_advised_step_is_the_largest_one() {
    let text = |step: f64| PLATE.to_owned() + &format!("step_s = {step}\n");
    let Err(PlantError::StepTooLarge { largest, .. }) = simulation(&text(0.1)) else { panic!("accepted") };
    assert!(simulation(&text(largest)).is_ok());
    assert!(matches!(simulation(&text(2.5 * largest)), Err(PlantError::StepTooLarge { .. })));
}

#[test]
fn what_the_robot_lacks_is_named() {
    let scenario = Scenario::from_toml_bytes(PLATE.as_bytes(), "scenario.toml").unwrap();
    let mut robot = plate();
    robot.platform.inertia = None;
    let error = Simulation::new(&scenario, robot).unwrap_err().to_string();
    assert!(error.contains("inertia_about_center_of_mass_kg_m2"), "{error}");
    let mut robot = plate();
    robot.cables[2].stiffness = Some(CableStiffness::Compliance(0.0));
    let error = Simulation::new(&scenario, robot).unwrap_err().to_string();
    assert!(error.contains("cable 3 does not stretch"), "{error}");
    let drums = PLATE.replace("robot = \"plate\"", "robot = \"plate\"\nwinches = \"drums\"");
    let scenario = Scenario::from_toml_bytes(drums.as_bytes(), "scenario.toml").unwrap();
    let error = Simulation::new(&scenario, plate()).unwrap_err().to_string();
    assert!(error.contains("drum_radius_m"), "{error}");
}
