//! Robots that are built in.

use cdpr_model::robot::Robot;
use schemars::JsonSchema;
use serde::Serialize;

use super::Answer;
use crate::table::Table;

/// Names and sizes of robots, and which of their numbers are assumed.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "RobotList")]
pub struct RobotsAnswer {
    /// Built-in robots.
    robots: Vec<Entry>,
}

/// Built-in robot.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "RobotEntry")]
struct Entry {
    name: String,
    motion_pattern: &'static str,
    cable_count: usize,
    title: Option<String>,
    /// Keys of numbers that no source states and nobody measured.
    assumptions: Vec<String>,
}

impl RobotsAnswer {
    /// A list of robots.
    pub fn of(robots: impl Iterator<Item = Robot>) -> Self {
        let entry = |robot: Robot| Entry {
            motion_pattern: robot.motion_pattern.name(),
            cable_count: robot.cable_count(),
            name: robot.name,
            title: robot.title,
            assumptions: robot.assumptions.into_iter().map(|assumption| assumption.key).collect(),
        };
        Self { robots: robots.map(entry).collect() }
    }
}

impl Answer for RobotsAnswer {
    fn words(&self, width: Option<usize>) -> String {
        let mut table = Table::new(["name", "pattern", "cables", "assumed", "title"]);
        for entry in &self.robots {
            let assumed = match entry.assumptions.len() {
                0 => String::new(),
                count => count.to_string(),
            };
            let title = entry.title.clone().unwrap_or_default();
            let pattern = entry.motion_pattern.to_owned();
            table.row(vec![entry.name.clone(), pattern, entry.cable_count.to_string(), assumed, title]);
        }
        let mut text = table.left_column(4).text(width);
        if self.robots.iter().any(|entry| !entry.assumptions.is_empty()) {
            text.push_str("\nassumed: numbers of the file that no source states and nobody measured; `cdpr check NAME` names them with their reasons\n");
        }
        text
    }
}
