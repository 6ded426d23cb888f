//! `cdpr import caspr`: a model of CASPR as a robot file.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_model::reading::Size;
use cdpr_model::robot::caspr::{Files, Finding, Loss, Options, import};
use cdpr_reports::answers::ImportAnswer;
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::file_kind::FileKind;
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

pub(super) fn run(arguments: &Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let (bodies_name, cables_name) = (arguments.bodies.display().to_string(), arguments.cables.display().to_string());
    let (bodies, cables) = (files::read(&arguments.bodies, Size::Text)?, files::read(&arguments.cables, Size::Text)?);
    let model = Files { bodies: &bodies, bodies_name: &bodies_name, cables: &cables, cables_name: &cables_name };
    let options = Options { cable_set: arguments.cable_set.as_deref(), name: arguments.name.as_deref() };
    let import = import(&model, &options).map_err(|error| match error.file_name == cables_name {
        true => FileKind::CasprCables.refusal(&cables, error),
        false => FileKind::CasprBodies.refusal(&bodies, error),
    })?;
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
    output.answer(&ImportAnswer::new(import, arguments.out.display().to_string()))
}
