//! The interface of controllers: times of calls, their inputs, and the commands between two calls.

use std::convert::Infallible;
use std::ops::ControlFlow;
use std::sync::{Arc, Mutex};

use super::super::{
    Between, ControlError, Controller, Measured, RunEnd, Scenario, Setpoint, Simulation, StepError, Summary,
};
use super::*;

const PLATE: &str = "[machine]\nrobot = \"plate\"\ncable_damping_N_s_per_m = 4.0\n[start]\npose = [0.6, 0.6, 0]\ntension_method = \"closed-form\"\n\
                     tension_limits_N = [60, 140]\n[time]\nduration_s = 0.1\nrecord_s = 0.001\n";

/// A recorded call: time of the command, and the time and tension of the first cable that the controller saw.
type Question = (f64, f64, f64);

/// Shortens the first cable by 0.1 mm at every call, and records all calls.
#[derive(Clone, Debug)]
struct Stairs {
    period: Option<f64>,
    count: u32,
    asked: Arc<Mutex<Vec<Question>>>,
}

impl Stairs {
    fn every(period: Option<f64>) -> Self {
        Self { period, count: 0, asked: Arc::default() }
    }
}

impl Controller for Stairs {
    fn command(
        &mut self,
        time: f64,
        wanted: &Setpoint,
        measured: &Measured<'_>,
        out: &mut [Command],
    ) -> Result<(), ControlError> {
        self.count += 1;
        self.asked.lock().unwrap().push((time, measured.time, measured.tensions[0]));
        out[0] = Command::Length(wanted.lengths[0] - 1e-4 * f64::from(self.count));
        Ok(())
    }

    fn period(&self) -> Option<f64> {
        self.period
    }

    fn reset(&mut self) {
        self.count = 0;
    }

    fn boxed_clone(&self) -> Box<dyn Controller> {
        Box::new(self.clone())
    }
}

fn simulation(more: &str, controller: impl Controller + 'static) -> Simulation {
    let scenario = Scenario::from_toml_bytes((PLATE.to_owned() + more).as_bytes(), "scenario.toml").unwrap();
    Simulation::with_controller(&scenario, plate(), Box::new(controller)).unwrap()
}

fn run(mut simulation: Simulation) -> (Vec<PlantState>, Summary) {
    let mut rows = Vec::new();
    let summary = simulation.run(|_, state| {
        rows.push(state.clone());
        Ok::<_, Infallible>(ControlFlow::Continue(()))
    });
    (rows, summary.unwrap())
}

/// Change of the first controlled length at the rows (0.1 mm).
fn changes(rows: &[PlantState]) -> Vec<f64> {
    let start = rows[0].cables[0].controlled_length;
    rows.iter().map(|row| 1e4 * (row.cables[0].controlled_length - start)).collect()
}

/// Without a period there is a call for every step: for its end, with measurements from its start.
#[test]
fn a_controller_without_a_period_is_asked_for_every_step() {
    let stairs = Stairs::every(None);
    let asked = stairs.asked.clone();
    let (rows, summary) = run(simulation("", stairs));
    assert_eq!((summary.end, summary.steps), (RunEnd::Completed, 100));
    let asked = asked.lock().unwrap();
    assert_eq!(asked.len(), 100);
    for (index, (time, seen, tension)) in asked.iter().enumerate() {
        assert_eq!((*seen, *tension), (rows[index].time, rows[index].cables[0].tension));
        assert_eq!(*time, rows[index + 1].time);
    }
    assert!((changes(&rows)[100] + 100.0).abs() < 1e-9);
}

/// Calls lie at multiples of the period, on the grid of steps or off it, with either integrator; the steps of the grid
/// do not change.
#[test]
fn a_period_is_kept_beside_the_grid_and_by_either_integrator() {
    for (period, count, steps) in [(0.02, 5, 100), (0.0075, 14, 107), (0.0003, 334, 400)] {
        for integrator in ["symplectic", "error-controlled"] {
            let stairs = Stairs { count: 9, ..Stairs::every(Some(period)) };
            let asked = stairs.asked.clone();
            let (rows, summary) = run(simulation(&format!("integrator = \"{integrator}\"\n"), stairs));
            assert_eq!((rows.len(), &summary.end), (101, &RunEnd::Completed));
            assert!(summary.steps == steps || integrator != "symplectic", "{period}: {}", summary.steps);
            let asked = asked.lock().unwrap();
            assert_eq!(asked.len(), count, "{period} {integrator}");
            for (index, (time, seen, _)) in asked.iter().enumerate() {
                assert!((time - period * index as f64).abs() < 1e-9 && time == seen, "{period}: {time}");
            }
            // a run starts anew: the count of an earlier one is forgotten
            assert!((changes(&rows)[100] + count as f64).abs() < 1e-9, "{integrator}: {:?}", changes(&rows)[100]);
        }
    }
}

/// Held, a new length is reached a step after the call; on lines, at the next call. Both integrators have the same
/// lengths.
#[test]
fn commands_are_held_or_go_on_lines_between_two_questions() {
    for integrator in ["symplectic", "error-controlled"] {
        let more = format!("integrator = \"{integrator}\"\n");
        let of = |between: Between| {
            let mut simulation = simulation(&more, Stairs::every(Some(0.02)));
            simulation.between = between;
            changes(&run(simulation).0)
        };
        let (held, lines) = (of(Between::Hold), of(Between::Line));
        for row in 0..=100_usize {
            let expected = if row == 0 { 0.0 } else { -1.0 - ((row - 1) / 20) as f64 };
            assert!((held[row] - expected).abs() < 1e-9, "{integrator} held, row {row}: {}", held[row]);
            // no line leads to the first answer
            let expected = match row {
                0 => 0.0,
                1..=20 => -1.0,
                _ => -(row as f64) / 20.0,
            };
            assert!((lines[row] - expected).abs() < 1e-9, "{integrator} lines, row {row}: {}", lines[row]);
        }
    }
}

/// A clone of a simulation continues independently, with the state of its controller, to the same bits.
#[test]
fn a_cloned_simulation_has_a_controller_of_its_own() {
    let whole = simulation("", Stairs::every(Some(0.03)));
    let (first, second) = (run(whole.clone()).0, run(whole).0);
    assert_eq!(first, second);
}

/// A controller that has no command, one for other winches, and one whose period is not positive.
#[test]
fn controllers_that_cannot_go_on_end_the_run_with_their_reason() {
    #[derive(Clone, Debug)]
    struct Refuses(Command);
    impl Controller for Refuses {
        fn command(
            &mut self,
            time: f64,
            _: &Setpoint,
            _: &Measured<'_>,
            out: &mut [Command],
        ) -> Result<(), ControlError> {
            out[2] = self.0;
            if time < 0.05 { Ok(()) } else { Err(ControlError::new("nobody knows")) }
        }
        fn period(&self) -> Option<f64> {
            Some(0.01)
        }
        fn reset(&mut self) {}
        fn boxed_clone(&self) -> Box<dyn Controller> {
            Box::new(self.clone())
        }
    }
    let (rows, summary) = run(simulation("", Refuses(Command::Speed(0.0))));
    assert_eq!(summary.end, RunEnd::Failed(StepError::Control(ControlError::new("nobody knows"))));
    assert!((rows.last().unwrap().time - 0.05).abs() < 1e-12);
    let (_, summary) = run(simulation("", Refuses(Command::Tension(100.0))));
    let RunEnd::Failed(error) = summary.end else { panic!("completed") };
    assert!(error.to_string().contains("cable 3 is commanded a tension"), "{error}");
    let scenario = Scenario::from_toml_bytes(PLATE.as_bytes(), "scenario.toml").unwrap();
    let never = Box::new(Stairs::every(Some(0.0)));
    let error = Simulation::with_controller(&scenario, plate(), never).unwrap_err();
    assert!(error.to_string().contains("above 0 s"), "{error}");
}

/// Commands that depend on measurements may have kinks anywhere: the integrator with error control then stops at every
/// step of the scenario.
#[test]
fn error_control_asks_a_controller_that_looks_at_every_step_of_the_scenario() {
    let stairs = Stairs::every(None);
    let asked = stairs.asked.clone();
    let more = "integrator = \"error-controlled\"\n";
    let mut simulation = simulation(more, stairs);
    simulation.time.record_s = Some(0.05);
    assert_eq!(run(simulation).0.len(), 3);
    assert_eq!(asked.lock().unwrap().len(), 100);
}

/// Kinds for other winches, and keys of other kinds, are refused with the words that resolve it.
#[test]
fn kinds_of_control_are_refused_with_what_they_are_for() {
    let read = |control: &str| {
        let text = PLATE.replace("[time]", &format!("[control]\n{control}\n[time]"));
        Scenario::from_toml_bytes(text.as_bytes(), "s.toml").unwrap_err()
    };
    let torques = read("kind = \"torques\"");
    assert!(torques.to_string().contains("winches = \"drums\"") && torques.line() == Some(9), "{torques}");
    let other = read("kind = \"lenghts\"");
    assert!(other.to_string().contains("lengths, length-changes, torques"), "{other}");
    let alien = read("time_s = [0, 1]");
    assert!(alien.to_string().contains("time_s does not belong to kind = \"lengths\""), "{alien}");
    let missing = read("kind = \"length-changes\"\ntime_s = [0]");
    assert!(missing.to_string().contains("needs the key length_change_m"), "{missing}");
    let unknown = read("speed = 1");
    assert!(unknown.to_string().contains("unknown key `speed`") && unknown.line() == Some(9), "{unknown}");
    let quoted = read("kind = \"length-changes\"\ntime_s = \"0\"");
    assert!(quoted.to_string().contains("a sequence") && quoted.line() == Some(10), "{quoted}");
    let refused = |rows: &str| {
        let text = PLATE.replace("[time]", &format!("[control]\nkind = \"length-changes\"\n{rows}\n[time]"));
        let scenario = Scenario::from_toml_bytes(text.as_bytes(), "s.toml").unwrap();
        Simulation::new(&scenario, plate()).unwrap_err()
    };
    for (rows, key, words) in [
        ("time_s = [1, 0]\nlength_change_m = [[0,0,0,0], [0,0,0,0]]", "time_s", "ascending"),
        ("time_s = [0, 1]\nlength_change_m = [[0,0,0,0]]", "length_change_m", "1 rows, time_s 2 times"),
        ("time_s = [0]\nlength_change_m = [[0,0,0]]", "length_change_m", "each of the 4 cables"),
    ] {
        let error = refused(rows);
        assert!(error.to_string().contains(words), "{error}");
        assert_eq!(error.key().map(|key| (key.table, key.key)), Some(("control", key)));
    }
}
