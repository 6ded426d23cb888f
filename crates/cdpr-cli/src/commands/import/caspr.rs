//! `cdpr import caspr`: a model of CASPR as a robot file.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_model::reading::Size;
use cdpr_model::robot::caspr::{Files, Finding, Import, Loss, Options, import};
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::files;
use crate::numbers::Unreadable;

const EXAMPLES: &str = "\
Examples:
  cdpr import caspr CoGiRo_bodies.xml CoGiRo_cables.xml --out cogiro.toml
  cdpr import caspr CAROCA_bodies.xml CAROCA_cables.xml --cable-set with_rotating_pulleys \\
      --name caroca-pulleys --out caroca-pulleys.toml
  cdpr import caspr model_bodies.xml model_cables.xml --strict --out model.toml --format json";

/// Make a robot file of a model of CASPR: one rigid link, a set of its cables.
///
/// Joints: SPATIAL_EULER_XYZ and SPATIAL_QUATERNION (3R3T), T_XYZ (3T), PLANAR_XY, _YZ, _XZ (1R2T), P_XY, P_XZ (2T). Chains
/// of links, other joints and cables over several points are refused. Passive springs are left out and devices of variable
/// stiffness become rigid; both are told with name and line, and noted in the robot file.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// CASPR's file of bodies.
    #[arg(value_name = "BODIES.xml")]
    bodies: PathBuf,

    /// CASPR's file of cables.
    #[arg(value_name = "CABLES.xml")]
    cables: PathBuf,

    /// Which of the cable sets; the file's default when left out.
    #[arg(long, value_name = "NAME")]
    cable_set: Option<String>,

    /// Name of the robot, one word; made of the bodies file's name when left out.
    #[arg(long, value_name = "NAME", value_parser = one_word)]
    name: Option<String>,

    /// Refuse models of which something that acts on the platform would be left out or simplified.
    #[arg(long)]
    strict: bool,

    /// Robot file to write.
    #[arg(long, value_name = "ROBOT.toml")]
    out: PathBuf,
}

fn one_word(text: &str) -> Result<String, Unreadable> {
    let is_word = !text.is_empty() && !text.contains(char::is_whitespace);
    if is_word { Ok(text.to_owned()) } else { Err("a name is one word; use hyphens for spaces".into()) }
}

#[derive(Serialize)]
struct Imported {
    robot: String,
    motion_pattern: &'static str,
    out: String,
    taken: Taken,
    /// Forces and parts that act in CASPR and are not in the robot.
    refused: Vec<Finding>,
    /// Parts that were taken incompletely, or do not act.
    reported: Vec<Finding>,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct Taken {
    link: String,
    joint: String,
    cable_set: String,
    cable_sets: Vec<String>,
    cables: Vec<String>,
    pulleys: usize,
    elastic_cables: usize,
}

pub(super) fn run(arguments: &Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let (bodies_name, cables_name) = (arguments.bodies.display().to_string(), arguments.cables.display().to_string());
    let (bodies, cables) = (files::read(&arguments.bodies, Size::Text)?, files::read(&arguments.cables, Size::Text)?);
    let model = Files { bodies: &bodies, bodies_name: &bodies_name, cables: &cables, cables_name: &cables_name };
    let options = Options { cable_set: arguments.cable_set.as_deref(), name: arguments.name.as_deref() };
    let import = import(&model, &options)?;
    let acts = |finding: &&Finding| finding.loss != Loss::Ignored;
    if let Some(first) = import.findings.iter().find(acts).filter(|_| arguments.strict) {
        let count = import.findings.iter().filter(acts).count();
        let message = format!("--strict: {count} elements cannot be imported wholly, the first is {first}");
        return Err(Failure::input(
            "caspr::not-wholly",
            message,
            "without --strict they are left out or simplified, and listed",
        ));
    }
    files::write(&arguments.out, import.robot.to_toml().as_bytes())?;
    import.findings.iter().filter(acts).for_each(|finding| output.remark(&finding.to_string()));
    output.answer(&Imported::new(import, arguments.out.display().to_string()))
}

impl Imported {
    fn new(import: Import, out: String) -> Self {
        let (refused, reported) = import.findings.into_iter().partition(|finding| finding.loss == Loss::LeftOut);
        let robot = import.robot;
        let count = |has: fn(&cdpr_model::robot::Cable) -> bool| robot.cables.iter().filter(|cable| has(cable)).count();
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

impl Answer for Imported {
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
