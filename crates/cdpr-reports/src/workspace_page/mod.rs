//! The interactive page of a workspace: one HTML file with robot, results and a grid of verdicts and tensions, in which the
//! platform can be dragged.
//!
//! Everything the page shows was computed here: its program interpolates between the nodes of the grid and says so.

mod found;
mod grid;
mod overlay;
mod page_data;
mod sentences;
#[cfg(test)]
mod tests;

use cdpr::geometry::Pose;
use cdpr::model::Model;
use cdpr::statics::Load;
use cdpr::tension::Limits;
use cdpr::workspace::Verdict;
use cdpr::workspace::mesh::Mesh;
use minijinja::{Value, context};

use crate::answers::PoseAnswer;
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::number_format::significant;
use grid::Grid;

pub use found::{FoundWorkspace, Outline};
pub use overlay::{OverlayError, findings_of};

const TEMPLATE: &str = include_str!("workspace.html");

/// Contents of a page.
pub struct WorkspacePage<'a> {
    /// Robot and effects.
    pub model: &'a Model,
    /// Name of what has to hold at a pose.
    pub criterion: &'a str,
    /// Unit of its margin; `1` for none.
    pub unit: &'a str,
    /// The full answer at a pose; of a set of orientations whatever the set says of the position.
    pub judge: &'a (dyn Fn(&Pose) -> Verdict + Sync),
    /// Load and limits of the tensions that are shown; `None` shows none.
    pub statics: Option<(&'a Load, &'a Limits)>,
    /// Pose of the platform when the page is opened, and how it is turned at every pose of the grid.
    pub start: &'a Pose,
    /// Box of the grid, least and largest coordinate (m): along x, y and z, or along the two axes of a planar robot.
    pub bounds: &'a [[f64; 2]],
    /// Results: the one that the command found first, if it found one, then those to compare it with.
    pub findings: &'a [Finding],
    /// True where the first result is the command's own: its size is the headline.
    pub is_found: bool,
    /// Facts that the results depend on, as pairs of words.
    pub facts: &'a [(&'a str, String)],
    /// Warnings; text between backticks is shown as code.
    pub warnings: &'a [String],
    /// The command that makes the same page again.
    pub command: &'a str,
    /// Version of the program.
    pub version: &'a str,
}

/// A workspace that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Name that tells it from others: criterion and limits, say.
    pub name: String,
    /// Its volume (m³) or area (m²).
    pub measure: f64,
    /// The measure is known to ± this (m³, m²).
    pub error_bound: Option<f64>,
    /// Its form.
    pub shape: Shape,
}

/// The form of a finding.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// The surface of a volume, with margin and limiting cable at its vertices where they are known.
    Surface {
        /// The surface.
        mesh: Mesh,
        /// The method that found it: a hull, or the cells of a grid or an octree.
        method: String,
    },
    /// Closed lines in the coordinates of the plane's axes (m); a point belongs to the area when an odd number encloses it.
    Areas(Vec<Vec<[f64; 2]>>),
    /// Only the measure is known: from a grid, say.
    Unknown,
}

impl Finding {
    fn unit(&self, is_planar: bool) -> &'static str {
        match (&self.shape, is_planar) {
            (Shape::Areas(_), _) | (Shape::Unknown, true) => "m²",
            _ => "m³",
        }
    }

    /// E.g. "243.1 ± 0.8 m³".
    fn words(&self, is_planar: bool) -> String {
        let bound = self.error_bound.map(|bound| format!(" ± {}", significant(bound, 2))).unwrap_or_default();
        format!("{}{bound} {}", significant(self.measure, 4), self.unit(is_planar))
    }
}

/// Computes the grid; HTML of the page.
pub fn render(page: &WorkspacePage<'_>) -> Result<String, PageError> {
    let grid = Grid::compute(page);
    let robot = page.model.robot();
    let title = format!("Workspace of {}", robot.name);
    let is_planar = robot.motion_pattern.is_planar();
    let values = context! {
        is_planar,
        line => page.findings.first().filter(|_| page.is_found).map(|finding| finding.words(is_planar)),
        criterion => plain(page.criterion),
        facts => facts(page),
        findings => page.findings.iter().enumerate().map(|(index, finding)| finding_row(index, finding, is_planar)).collect::<Vec<_>>(),
        statement => grid.statement(),
        check => grid.check_words(),
        has_tensions => page.statics.is_some(),
        turned => robot.motion_pattern.has_rotation(),
        pose => PoseAnswer::new(robot, page.start).words(),
        warnings => page.warnings.iter().map(|warning| prose(warning)).collect::<Vec<_>>(),
        command => plain(page.command),
    };
    let data = Some(page_data::json(page, &grid));
    Page {
        kind: PageKind::Workspace,
        title: &title,
        class: "wide",
        template: TEMPLATE,
        values,
        data,
        version: page.version,
    }
    .render()
}

fn facts(page: &WorkspacePage<'_>) -> Value {
    let robot = page.model.robot();
    let name = match &robot.title {
        Some(title) => format!("{} ({title})", robot.name),
        None => robot.name.clone(),
    };
    let own =
        [("Robot", name), ("Cables", robot.cable_count().to_string()), ("Model", page.model.composition().to_string())];
    let all = own.iter().chain(page.facts.iter());
    all.map(|(term, text)| context! { term => *term, text => plain(text) }).collect()
}

fn finding_row(index: usize, finding: &Finding, is_planar: bool) -> Value {
    let letter = char::from(b'A' + (index % 26) as u8).to_string();
    let form = match &finding.shape {
        Shape::Surface { mesh, method } if method == "hull" => format!("hull of {} triangles", mesh.triangles.len()),
        Shape::Surface { mesh, method } => {
            format!("surface of the {}, {} triangles", plain(method), mesh.triangles.len())
        }
        Shape::Areas(outlines) if outlines.len() == 1 => "1 outline".to_owned(),
        Shape::Areas(outlines) => format!("{} outlines", outlines.len()),
        Shape::Unknown => "no surface: measure only".to_owned(),
    };
    context! { letter, name => plain(&finding.name), measure => finding.words(is_planar), form }
}
