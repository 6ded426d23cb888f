//! `cdpr workspace`: where the platform can be.

mod arguments;
mod cell_search;
mod counting;
mod orientations;
mod page;
mod question;

use std::process::ExitCode;

pub(crate) use arguments::Arguments;
use arguments::Method;
use cdpr_workspace::Region;
use cdpr_workspace::criterion::registry::CriterionRequest;
use cdpr_workspace::hull::Center;
use cdpr_workspace::refine::{ByHull, ByOctree, refine};
use cell_search::{CellSearch, Counted};
pub(super) use orientations::rotation;
use question::Question;

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::meshes::{check_mesh_file, write_mesh};
use crate::progress::Progress;
use crate::session::command_line;
use cdpr_reports::answers::WorkspaceAnswer;
use cdpr_reports::workspace_page::{FoundWorkspace, Outline};

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    check_files(&arguments)?;
    let earlier = page::earlier(&arguments)?;
    let wanted = arguments.criterion.iter().map(|text| text.parse::<CriterionRequest>());
    let wanted = wanted.collect::<Result<Vec<_>, _>>().map_err(|error| Failure::refused("--criterion", &error))?;
    let model = arguments.model.read()?;
    let mut question = Question::new(&arguments, &model)?;
    let criterion = question.criterion(&wanted)?;
    let region = question.region(criterion.as_ref())?;
    question.look_closer(&arguments, &region)?;
    let (mut answer, found) = find(&arguments, &question, &region)?;
    if let Some(path) = &arguments.mesh
        && let Some(mesh) = found.mesh(&region)
    {
        write_mesh(path, &mesh)?;
        answer.set_mesh(path.display().to_string(), &mesh);
    }
    if let Some(path) = &arguments.page {
        let _progress = Progress::spinner("judging the grid of the page");
        let page = FoundWorkspace {
            asked: question.asked(&region),
            statics: question.statics(),
            answer: &answer,
            outline: &found,
            earlier,
            command: &command_line(),
            version: env!("CARGO_PKG_VERSION"),
        };
        let html = page.page().map_err(|error| Failure::unwritable("the page of the workspace", &error))?;
        files::write(path, html.as_bytes())?;
        answer.set_page(path.display().to_string());
    }
    answer.remarks().iter().for_each(|remark| output.remark(remark));
    output.answer(&answer)
}

/// The workspace, with its surface where a file shall show it.
fn find(
    arguments: &Arguments,
    question: &Question<'_>,
    region: &Region<'_>,
) -> Result<(WorkspaceAnswer, Outline), Failure> {
    // the page shows the part of the box where the surface is, of planar robots too
    let is_shown = arguments.mesh.is_some() || arguments.page.is_some();
    let bounds = &question.bounds;
    let asked = question.asked(region);
    let (answer, found) = match arguments.method {
        Method::Grid => {
            let mut search = CellSearch::new(question, region, arguments.resume.as_deref(), is_shown);
            let refined = refine(region, bounds, &question.goal, &mut search)?;
            let _progress = Progress::spinner("drawing the surface");
            let cells = refined.found.cells.as_ref();
            let found = cells.map_or(Outline::Size, |cells| Outline::Surface(cells.surface(region)));
            let Counted { grid, count, .. } = &refined.found;
            (WorkspaceAnswer::by_grid(&asked, grid, count, &refined.audit), found)
        }
        Method::Octree => {
            let _progress = Progress::spinner("following the boundary");
            let mut search = ByOctree { region, bounds, step: question.step };
            let refined = refine(region, bounds, &question.goal, &mut search)
                .map_err(|error| Failure::refused("--step", &error))?;
            let found = if is_shown { Outline::Surface(refined.found.surface()) } else { Outline::Size };
            (WorkspaceAnswer::by_octree(&asked, &refined), found)
        }
        Method::Hull => {
            let _progress = Progress::spinner("following rays");
            match question.center(region)? {
                Center::Nowhere(audit) => (WorkspaceAnswer::empty(&asked, &audit), Outline::Size),
                Center::At(center) => {
                    let mut search = ByHull { region, bounds, center, settings: question.rays(region) };
                    let mut refined = refine(region, bounds, &question.goal, &mut search)
                        .map_err(|error| Failure::refused("--method hull", &error))?;
                    refined.found.doubt(&refined.audit);
                    (WorkspaceAnswer::by_hull(&asked, &refined), Outline::Hull(refined.found))
                }
            }
        }
    };
    Ok((answer, found))
}

/// Options about files that the method would not write.
fn check_files(arguments: &Arguments) -> Result<(), Failure> {
    let refused = |code, message: String, help: &str| Err(Failure::input(code, message, help));
    arguments.mesh.as_ref().map_or(Ok(()), |path| check_mesh_file("--mesh", path))?;
    match (&arguments.mesh, &arguments.resume) {
        (Some(_), Some(_)) => {
            let message =
                "--mesh draws a surface from all cells, but the state of --resume keeps no more than their number"
                    .to_owned();
            refused("workspace::resume", message, "leave --resume or --mesh out, or use --method octree")
        }
        (_, Some(_)) if arguments.method != Method::Grid => {
            let message = "--resume keeps the state of a count of cells, but the method is another".to_owned();
            refused("workspace::resume", message, "leave --resume out, or use --method grid")
        }
        _ => Ok(()),
    }
}
