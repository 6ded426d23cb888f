//! A robot imported from CASPR's files: what was taken, and what was not.

use cdpr_model::robot::Cable;
use cdpr_model::robot::caspr::{Finding, Import, Loss};
use schemars::JsonSchema;
use serde::Serialize;

use super::Answer;
use crate::keys::{Each, FindingKeys};

/// Robot of another program's model, with what was taken and what was not.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ImportedRobot")]
pub struct ImportAnswer {
    robot: String,
    motion_pattern: &'static str,
    out: String,
    /// Parts of the model that were taken.
    taken: Taken,
    /// Forces and parts that act in CASPR and are not in the robot.
    #[serde(with = "Each::<FindingKeys>")]
    refused: Vec<Finding>,
    /// Parts that were taken incompletely, or do not act.
    #[serde(with = "Each::<FindingKeys>")]
    reported: Vec<Finding>,
    warnings: Vec<String>,
}

/// Parts of another program's model that were taken.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "TakenParts")]
struct Taken {
    /// Name of the platform's link.
    link: String,
    /// Kind of the joint.
    joint: String,
    /// Set of cables that was taken.
    cable_set: String,
    /// Sets of cables of the model.
    cable_sets: Vec<String>,
    /// Names of the cables.
    cables: Vec<String>,
    /// Number of cables with a pulley.
    pulleys: usize,
    /// Number of cables with a stiffness.
    elastic_cables: usize,
}

impl ImportAnswer {
    /// Of an import whose robot is written to a file of a name.
    pub fn new(import: Import, out: String) -> Self {
        let (refused, reported) = import.findings.into_iter().partition(|finding| finding.loss == Loss::LeftOut);
        let robot = import.robot;
        let count = |has: fn(&Cable) -> bool| robot.cables.iter().filter(|cable| has(cable)).count();
        Self {
            motion_pattern: robot.motion_pattern.name(),
            taken: Taken {
                link: import.link,
                joint: import.joint,
                cable_set: import.cable_set,
                cable_sets: import.cable_sets,
                cables: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
                pulleys: count(|cable| cable.pulley_radius().is_some()),
                elastic_cables: count(|cable| cable.axial_stiffness().is_some()),
            },
            warnings: robot.warnings(),
            robot: robot.name,
            out,
            refused,
            reported,
        }
    }
}

impl Answer for ImportAnswer {
    fn words(&self, _width: Option<usize>) -> String {
        let Taken { link, joint, cable_set, cable_sets, cables, pulleys, elastic_cables } = &self.taken;
        let others = cable_sets.iter().filter(|name| *name != cable_set).cloned().collect::<Vec<_>>();
        let others = if others.is_empty() { String::new() } else { format!(" (others: {})", others.join(", ")) };
        let mut text = format!(
            "{}\n\nlink            {link}\njoint           {joint}, motion pattern {}\ncable set       {cable_set}{others}\n\
             cables          {} ({pulleys} with pulleys, {elastic_cables} elastic)\n",
            self.robot,
            self.motion_pattern,
            cables.len(),
        );
        for (heading, findings) in [("left out", &self.refused), ("not taken wholly", &self.reported)] {
            if !findings.is_empty() {
                text.push_str(&format!("\n{heading}\n"));
                findings.iter().for_each(|finding| text.push_str(&format!("  {finding}\n")));
            }
        }
        if !self.warnings.is_empty() {
            text.push_str("\nwarnings\n");
            self.warnings.iter().for_each(|warning| text.push_str(&format!("  {warning}\n")));
        }
        text.push_str(&format!("\nwritten to {}\n", self.out));
        text
    }
}
