//! The interactive page of a workspace: one HTML file with robot, results and a grid of verdicts and tensions, in which the
//! platform can be dragged.
//!
//! Everything the page shows was computed here: its program interpolates between the nodes of the grid and says so.

mod contents;
mod found;
mod grid;
mod overlay;
pub(crate) mod page_data;
mod sentences;
#[cfg(test)]
mod tests;

use minijinja::{Value, context};

use crate::answers::PoseAnswer;
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use grid::Grid;

pub use contents::{Finding, Shape, WorkspacePage};
pub use found::{FoundWorkspace, Outline};
pub use overlay::{OverlayError, findings_of};

const TEMPLATE: &str = include_str!("workspace.html");

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
