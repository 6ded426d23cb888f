//! Checks of a scenario that need no robot, with the place of each mistake.

use super::{Control, ControlKind, EventKind, EventTable, Integrator, Scenario, Time};
use crate::plant::plant::Winches;
use crate::reading::{ReadError, Step, TomlDocument};

/// Most steps of a run, and most numbers in a row of times.
const STEP_LIMIT: f64 = 1e9;

pub(super) fn check(scenario: &Scenario, document: &TomlDocument<'_>) -> Result<(), ReadError> {
    let place = Place { document };
    check_time(&scenario.time, &place)?;
    if let Some(damping) = scenario.machine.cable_damping_N_s_per_m.filter(|damping| !(*damping >= 0.0)) {
        let message = format!("cable_damping_N_s_per_m is {damping}; a damper takes energy, it is 0 or more");
        return Err(place.error(&["machine", "cable_damping_N_s_per_m"], message));
    }
    let start = &scenario.start;
    if start.tensions_N.is_some() && start.tension_method.is_some() {
        let message = "tensions_N and tension_method exclude each other".to_owned();
        return Err(place.error(&["start", "tension_method"], message).with_help("keep one of them"));
    }
    if let Some(index) = start.tensions_N.iter().flatten().position(|tension| !(*tension >= 0.0)) {
        let message = format!("cable {}: a cable cannot push", index + 1);
        return Err(place.error(&["start", "tensions_N"], message));
    }
    check_control(&scenario.control, scenario.machine.winches, &place)?;
    if let Some(series) = &scenario.wrench {
        check_series(&series.time_s, series.wrench.len(), ("wrench", "wrench"), &place)?;
    }
    scenario.event.iter().enumerate().try_for_each(|(index, event)| check_event(index, event, &place))
}

/// Makes errors at places of the file.
struct Place<'a> {
    document: &'a TomlDocument<'a>,
}

impl Place<'_> {
    fn error(&self, path: &[&str], message: String) -> ReadError {
        let steps: Vec<Step<'_>> = path.iter().map(|key| Step::Key(key)).collect();
        self.document.error_at(&steps, "scenario::value", message)
    }

    fn at_event(&self, index: usize, key: &str, message: String) -> ReadError {
        let path = [Step::Key("event"), Step::Index(index), Step::Key(key)];
        self.document.error_at(&path, "scenario::value", message)
    }
}

fn check_time(time: &Time, place: &Place<'_>) -> Result<(), ReadError> {
    let wrong = |key: &str, message: String, help: &str| Err(place.error(&["time", key], message).with_help(help));
    let is_positive = |value: f64| value > 0.0 && value.is_finite();
    if !is_positive(time.duration_s) {
        return wrong("duration_s", format!("duration_s is {}; it is a time above 0 s", time.duration_s), "e.g. 10");
    }
    if !is_positive(time.step_s) {
        return wrong("step_s", format!("step_s is {}; it is a time above 0 s", time.step_s), "e.g. 0.001");
    }
    if time.duration_s / time.step_s > STEP_LIMIT {
        let message = format!("{} s in steps of {} s are more than {STEP_LIMIT:e} steps", time.duration_s, time.step_s);
        return wrong("step_s", message, "take larger steps, or a shorter time");
    }
    if let Some(tolerance) = time.tolerance {
        if time.integrator == Integrator::Symplectic {
            let message = "tolerance belongs to integrator = \"error-controlled\"".to_owned();
            return wrong("tolerance", message, "drop it, or name that integrator");
        }
        if !(1e-13..=1e-3).contains(&tolerance) {
            let message = format!("tolerance is {tolerance:e}; it is a number from 1e-13 to 1e-3");
            return wrong("tolerance", message, "e.g. 1e-10");
        }
    }
    let Some(record) = time.record_s else { return Ok(()) };
    let multiple = record / time.step_s;
    if !is_positive(record) || (multiple - multiple.round()).abs() > 1e-6 || multiple.round() < 1.0 {
        let message = format!("record_s is {record}; rows are recorded after whole steps of {} s", time.step_s);
        return wrong("record_s", message, "take a whole multiple of step_s");
    }
    Ok(())
}

fn check_control(control: &Control, winches: Winches, place: &Place<'_>) -> Result<(), ReadError> {
    let kind = |message: &str| Err(place.error(&["control", "kind"], message.to_owned()));
    match (control.kind, winches) {
        (ControlKind::Torques, Winches::Ideal) => {
            return kind("ideal winches have no torques: say winches = \"drums\" in [machine], or another kind");
        }
        (ControlKind::LengthChanges, Winches::Drums) => {
            return kind("drums follow torques, not lengths: say winches = \"ideal\" in [machine], or another kind");
        }
        _ => {}
    }
    let is_told = control.kind == ControlKind::LengthChanges;
    for (key, is_stated) in
        [("time_s", control.time_s.is_some()), ("length_change_m", control.length_change_m.is_some())]
    {
        if is_told && !is_stated {
            return Err(place.error(&["control"], format!("kind = \"length-changes\" needs the key {key}")));
        }
        if !is_told && is_stated {
            let message = format!("{key} belongs to kind = \"length-changes\"");
            return Err(place.error(&["control", key], message));
        }
    }
    let rows = control.length_change_m.as_ref().map_or(0, Vec::len);
    control.time_s.iter().try_for_each(|times| check_series(times, rows, ("control", "length_change_m"), place))
}

fn check_series(times: &[f64], rows: usize, (table, key): (&str, &str), place: &Place<'_>) -> Result<(), ReadError> {
    let rises = times.windows(2).all(|pair| pair[0] < pair[1]) && times.iter().all(|time| time.is_finite());
    if times.is_empty() || !rises {
        return Err(place.error(&[table, "time_s"], "time_s are ascending times, one at least".to_owned()));
    }
    if rows != times.len() {
        return Err(place.error(&[table, key], format!("{key} has {rows} rows, time_s {} times", times.len())));
    }
    Ok(())
}

fn check_event(index: usize, event: &EventTable, place: &Place<'_>) -> Result<(), ReadError> {
    if !(event.time_s >= 0.0 && event.time_s.is_finite()) {
        let message = format!("event {}: time_s is {}; it is a time from 0 s on", index + 1, event.time_s);
        return Err(place.at_event(index, "time_s", message));
    }
    let stated = [
        ("cable", event.cable.is_some()),
        ("length_m", event.length_m.is_some()),
        ("mass_kg", event.mass_kg.is_some()),
        ("position_m", event.position_m.is_some()),
        ("wrench", event.wrench.is_some()),
    ];
    let (word, needed, others): (&str, &[&str], &[&str]) = match event.kind {
        EventKind::CableBreak => ("cable-break", &["cable"], &[]),
        EventKind::WinchStop => ("winch-stop", &["cable"], &[]),
        EventKind::Slip => ("slip", &["cable", "length_m"], &[]),
        EventKind::Load => ("load", &["mass_kg"], &["position_m"]),
        EventKind::Wrench => ("wrench", &["wrench"], &[]),
    };
    for (key, is_stated) in stated {
        if is_stated && !needed.contains(&key) && !others.contains(&key) {
            let message = format!("event {}: {key} does not belong to kind = \"{word}\"", index + 1);
            return Err(place.at_event(index, key, message));
        }
        if !is_stated && needed.contains(&key) {
            let message = format!("event {}: kind = \"{word}\" needs the key {key}", index + 1);
            return Err(place.at_event(index, "kind", message));
        }
    }
    Ok(())
}
