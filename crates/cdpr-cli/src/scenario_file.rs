//! Scenario files with their robots.

use std::path::Path;

use cdpr_model::reading::ErrorCode;
use cdpr_model::reading::Size;
use cdpr_plant::scenario::located;
use cdpr_plant::{PlantError, Scenario, Simulation};

use crate::answer::Output;
use crate::failure::Failure;
use crate::file_kind::FileKind;
use crate::files;
use crate::session;
use crate::study_file::robot_of_study;

/// Reads a scenario and its robot, whose path is relative to the scenario's folder, and sets the machine on its start.
pub(crate) fn read(path: &Path, output: &Output) -> Result<Simulation, Failure> {
    let name = path.display().to_string();
    let bytes = files::read(path, Size::Text)?;
    let scenario = Scenario::from_toml_bytes(&bytes, &name);
    let scenario = scenario.map_err(|error| FileKind::Scenario.refusal(&bytes, error))?;
    let robot = robot_of_study(&scenario.machine.robot, path.parent().unwrap_or(Path::new("")))?;
    output.about(&robot.name);
    let simulation = match session::controller() {
        Some(controller) => Simulation::with_controller(&scenario, robot, controller),
        None => Simulation::new(&scenario, robot),
    };
    simulation.map_err(|error| refused(&error, &scenario, (&bytes, &name)))
}

/// The failure at its place in the scenario, or of the robot that lacks something.
fn refused(error: &PlantError, scenario: &Scenario, (bytes, name): (&[u8], &str)) -> Failure {
    match located(error, error.code(), bytes, name) {
        Some(error) => error.into(),
        None => Failure::refused(&scenario.machine.robot, error),
    }
}
