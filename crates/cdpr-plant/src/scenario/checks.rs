//! Checks of a scenario that need no robot; each error names its key.

use super::{Integrator, Scenario, Time};
use crate::series::Series;
use cdpr_model::reading::{ReadError, Step, TomlDocument};

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
    let control = scenario.control.check(scenario.machine.winches);
    control.map_err(|(key, message)| place.error(&["control", key], message))?;
    if let Some(series) = &scenario.wrench {
        Series::check(&series.time_s, series.wrench.len(), "wrench").map_err(|mistake| {
            place.error(&["wrench", if mistake.is_in_times { "time_s" } else { "wrench" }], mistake.message)
        })?;
    }
    for (index, event) in scenario.event.iter().enumerate() {
        let wrong = |(key, message)| place.at_event(index, key, format!("event {}: {message}", index + 1));
        event.check().map_err(wrong)?;
    }
    Ok(())
}

/// Makes errors at keys of the file.
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
