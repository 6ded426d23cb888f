//! Robots of CASPR (the MATLAB simulator of D. Lau and others): a file of bodies and a file of cables, both XML.
//!
//! CASPR's models are more general than a [`Robot`]: chains of links, driven joints, cables over several points,
//! springs. An element that changes the robot is an error with its position; elements imported in part, or left out,
//! are listed in [`Import::findings`] and in the notes of the robot.
//!
//! ```
//! use cdpr::robot::caspr::{Files, Options, import};
//! # let bodies = br#"<bodies_system><links><link_rigid num="1" name="Plate"><joint type="P_XY" q_initial="1 1"/><physical>
//! #   <mass>2</mass><com_location>0 0 0</com_location><inertia ref="com"><Ixx>0</Ixx><Iyy>0</Iyy><Izz>0</Izz><Ixy>0</Ixy>
//! #   <Ixz>0</Ixz><Iyz>0</Iyz></inertia></physical><parent><num>0</num><location>0 0 0</location></parent></link_rigid>
//! #   </links></bodies_system>"#;
//! # let cable = |name: &str, anchor: &str| format!("<cable_ideal name='{name}' attachment_reference='joint'>
//! #   <properties><force_min>1</force_min><force_max>9</force_max></properties><attachments>
//! #   <attachment><link>0</link><location>{anchor}</location></attachment>
//! #   <attachment><link>1</link><location>0 0 0</location></attachment></attachments></cable_ideal>");
//! # let cables = format!("<cables default_cable_set='a'><cable_set id='a'>{}{}</cable_set></cables>",
//! #   cable("left", "0 2 0"), cable("right", "2 2 0"));
//! # let cables = cables.as_bytes();
//!
//! let files = Files { bodies, bodies_name: "plate_bodies.xml", cables, cables_name: "plate_cables.xml" };
//! let import = import(&files, &Options::default())?;
//! assert_eq!((import.robot.name.as_str(), import.robot.cable_count()), ("plate", 2));
//! # Ok::<(), cdpr::reading::ReadError>(())
//! ```

mod bodies;
mod cables;
mod findings;
mod joint;
#[cfg(test)]
mod tests;

use nalgebra::Vector3;

use findings::Findings;
pub use findings::{Finding, Loss};

use super::{Robot, Source};
use crate::reading::{Element, ReadError, XmlDocument};

/// CASPR's constant of gravity (m/s²), along −z of the world.
const GRAVITY: f64 = 9.81;

/// A model's two files: their bytes, and their names for errors.
#[derive(Clone, Copy, Debug)]
pub struct Files<'a> {
    /// Content of `…_bodies.xml`.
    pub bodies: &'a [u8],
    /// Name of the bodies file.
    pub bodies_name: &'a str,
    /// Content of `…_cables.xml`.
    pub cables: &'a [u8],
    /// Name of the cables file.
    pub cables_name: &'a str,
}

/// Options of an import.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options<'a> {
    /// Name of the cable set; `None` takes the file's default.
    pub cable_set: Option<&'a str>,
    /// Name of the robot; `None` takes it from the bodies file's name.
    pub name: Option<&'a str>,
}

/// A robot read from CASPR's files, with the parts of them that it lacks.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The robot.
    pub robot: Robot,
    /// Name of the link that became the platform.
    pub link: String,
    /// CASPR's name of its joint.
    pub joint: String,
    /// Name of the imported cable set.
    pub cable_set: String,
    /// All cable sets of the file.
    pub cable_sets: Vec<String>,
    /// Elements that the robot lacks, in the order of the files.
    pub findings: Vec<Finding>,
}

/// Reads a model into a robot.
pub fn import(files: &Files<'_>, options: &Options<'_>) -> Result<Import, ReadError> {
    let mut findings = Findings::default();
    let bodies = XmlDocument::parse(files.bodies, files.bodies_name)?;
    let body = bodies::read(&bodies.root("bodies_system")?, &mut findings)?;
    let cables = XmlDocument::parse(files.cables, files.cables_name)?;
    let root = cables.root("cables")?;
    let set = cables::read(&root, options.cable_set, &body, &mut findings)?;
    let joint = body.joint;
    let gravity = Vector3::new(0.0, 0.0, -GRAVITY);
    let robot = Robot {
        name: options.name.map_or_else(|| plain_name(files.bodies_name), str::to_owned),
        title: Some(body.link.clone()).filter(|link| !link.is_empty()),
        motion_pattern: joint.pattern,
        kind: None,
        plane: joint.plane,
        gravity: Some(joint.in_plane(&gravity)),
        notes: notes(&joint, &set, &findings.0),
        source: Some(Source {
            file: Some(format!("{}, {}", file_part(files.bodies_name), file_part(files.cables_name))),
            ..Source::default()
        }),
        assumptions: Vec::new(),
        platform: body.platform,
        home: Some(body.home),
        external_wrench: None,
        travel: body.travel,
        cables: set.cables,
        reference_checks: Vec::new(),
        calibration: None,
        tracked: None,
        obstacles: Vec::new(),
    };
    Ok(Import {
        robot: checked(&robot, &set.element)?,
        link: body.link,
        joint: joint.name.to_owned(),
        cable_set: set.name,
        cable_sets: set.all,
        findings: findings.0,
    })
}

/// The robot read back from its own file, which refuses the values that a robot file may not have.
fn checked(robot: &Robot, set: &Element<'_, '_>) -> Result<Robot, ReadError> {
    Robot::from_toml(&robot.to_toml(), "robot").map_err(|error| {
        let refused = set.error("caspr::not-a-robot", format!("this makes no robot: {}", error.message));
        match error.help {
            Some(help) => refused.with_help(help),
            None => refused,
        }
    })
}

/// Notes on the origin, for the robot file.
fn notes(joint: &joint::Joint, set: &cables::CableSet<'_, '_>, findings: &[Finding]) -> Vec<String> {
    let mut notes = vec![format!("CASPR joint {}, cable set {} of [{}].", joint.name, set.name, set.all.join(", "))];
    let acts = |finding: &&Finding| finding.loss != Loss::Ignored;
    notes.extend(findings.iter().filter(acts).map(|finding| {
        let name = finding.name.as_ref().map(|name| format!(" \"{name}\"")).unwrap_or_default();
        format!("Import: {}{name}: {}.", finding.element, finding.why)
    }));
    notes
}

/// The last part of a path.
fn file_part(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

/// The name `cogiro` for `path/CoGiRo_bodies.xml`.
fn plain_name(path: &str) -> String {
    let file = file_part(path);
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let stem = stem.strip_suffix("_bodies").unwrap_or(stem).to_lowercase();
    let words: Vec<&str> = stem.split(|c: char| !c.is_ascii_alphanumeric()).filter(|word| !word.is_empty()).collect();
    if words.is_empty() { "imported".to_owned() } else { words.join("-") }
}
