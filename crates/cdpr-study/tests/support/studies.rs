//! Studies of the repository with their robots, and what their machines record.

use cdpr_model::measurement::Samples;
use cdpr_model::robot::Robot;
use cdpr_study::{Experiment, Robots, Study};

use super::support::builtin;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../studies");

/// A study by its name.
pub(crate) fn study(name: &str) -> Study {
    read(name, |text| text)
}

/// A study with its models and winch offsets.
pub(crate) fn experiment(name: &str) -> Experiment {
    experiment_with(name, |text| text)
}

/// A study, changed as text, with its models and winch offsets.
pub(crate) fn experiment_with(name: &str, change: impl Fn(String) -> String) -> Experiment {
    let study = read(name, change);
    let robots = Robots::of(&study, |robot| match robot.strip_suffix(".toml") {
        Some(_) => Robot::from_toml(&std::fs::read_to_string(format!("{FOLDER}/{robot}")).unwrap(), robot),
        None => Ok(builtin(robot)),
    });
    Experiment::new(study, robots.unwrap()).unwrap()
}

/// What the machine of a study records.
pub(crate) fn record(name: &str, seed: u64) -> Samples {
    let experiment = experiment(name);
    let poses = experiment.poses(Vec::new(), seed).unwrap();
    experiment.record(&poses, seed).unwrap().samples
}

fn read(name: &str, change: impl Fn(String) -> String) -> Study {
    let text = change(std::fs::read_to_string(format!("{FOLDER}/{name}.toml")).unwrap());
    Study::from_toml_bytes(text.as_bytes(), name).unwrap()
}
