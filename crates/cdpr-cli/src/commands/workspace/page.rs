//! The interactive page of what was found.

use std::path::Path;

use cdpr::geometry::Pose;
use cdpr::nalgebra::{UnitQuaternion, Vector3};
use cdpr::reading::Size;
use cdpr::tension::Limits;
use cdpr::workspace::hull::Hull;
use cdpr::workspace::{Bounds, Point, Polygon, Region, Side};

use super::Arguments;
use super::Found as Outline;
use super::answer::WorkspaceAnswer;
use super::question::Question;
use crate::failure::Failure;
use crate::files;
use cdpr_reports::answers::WrenchAnswer;
use cdpr_reports::number_format::short;
use cdpr_reports::workspace_page::{self, Finding, Shape, WorkspacePage, findings_of};

/// Beyond what was found the grid of the page reaches by this share of its size: what fails is worth a look too.
const MARGIN: f64 = 0.15;

/// Surfaces of more triangles would make the page larger than a browser likes.
const MOST_TRIANGLES: usize = 100_000;

/// The results of the pages to lay over the new one, to be read before a long computation.
pub(super) fn earlier(arguments: &Arguments) -> Result<Vec<Finding>, Failure> {
    if arguments.page.is_none() && !arguments.overlay.is_empty() {
        let help = "add --page FILE.html";
        return Err(Failure::input(
            "workspace::overlay",
            "--overlay lays results over a page, but no page is written",
            help,
        ));
    }
    let read: Result<Vec<Vec<Finding>>, Failure> = arguments.overlay.iter().map(|path| findings_in(path)).collect();
    Ok(read?.concat())
}

/// What the page is about besides the question.
pub(super) struct Found<'a> {
    pub(super) answer: &'a WorkspaceAnswer,
    pub(super) shape: &'a Outline,
    pub(super) earlier: Vec<Finding>,
}

/// Writes the page.
pub(super) fn write(
    path: &Path,
    question: &Question<'_>,
    region: &Region<'_>,
    found: Found<'_>,
) -> Result<(), Failure> {
    let Found { answer, shape, earlier } = found;
    let hull = match shape {
        Outline::Hull(hull) => Some(hull),
        _ => None,
    };
    let statics = question.statics();
    let start = start(question, region, hull);
    let limits = statics.map(|(_, limits)| limit_words(limits));
    let own = finding(answer, region, shape, limits.as_deref());
    let is_found = own.is_some();
    let findings: Vec<Finding> = own.into_iter().chain(earlier).collect();
    let bounds = bounds(&question.bounds, &corners(region, shape));
    let mut facts = vec![("Criterion", region.criterion().name().to_owned()), ("Archetype", archetype_words(region))];
    facts.extend(limits.map(|words| ("Tension limits", words)));
    if let Some((load, _)) = statics {
        let load = WrenchAnswer::new(question.model.robot(), &load.wrench(&start));
        let with_value = |(heading, value): (String, String)| match heading.split_once(' ') {
            Some((name, unit)) => format!("{name} {value} {unit}"),
            None => format!("{heading} {value}"),
        };
        let parts: Vec<String> = load.heading().into_iter().zip(load.cells()).map(with_value).collect();
        facts.push(("Load", parts.join(", ")));
    }
    let mut warnings = answer.remarks();
    warnings.extend(answer.reason().map(str::to_owned));
    let page = workspace_page::render(&WorkspacePage {
        model: question.model,
        criterion: region.criterion().name(),
        unit: region.criterion().unit(),
        judge: &|pose| region.judge(&region.point(&pose.position)),
        statics,
        start: &start,
        bounds: &bounds,
        findings: &findings,
        is_found,
        facts: &facts,
        warnings: &warnings,
        command: &crate::command_line(),
        version: env!("CARGO_PKG_VERSION"),
    });
    let html = page.map_err(|error| Failure::unwritable("the page of the workspace", &error))?;
    files::write(path, html.as_bytes())
}

/// Results of a page that `cdpr workspace --page` wrote.
fn findings_in(path: &Path) -> Result<Vec<Finding>, Failure> {
    let page = files::read(path, Size::Table)?;
    let help = "give a page that `cdpr workspace --page` wrote";
    findings_of(&String::from_utf8_lossy(&page))
        .map_err(|error| Failure::refused(&path.display().to_string(), &error).with_help(help))
}

/// The centre of the hull, or the home position, in the orientation nearest to none.
fn start(question: &Question<'_>, region: &Region<'_>, hull: Option<&Hull>) -> Pose {
    let point = hull.map_or_else(|| question.home(region), |hull| hull.center);
    let turn = |rotation: &&UnitQuaternion<f64>| rotation.angle();
    let nearest = region.orientations().iter().min_by(|a, b| turn(a).total_cmp(&turn(b)));
    Pose { position: region.position(&point), rotation: nearest.copied().unwrap_or_else(UnitQuaternion::identity) }
}

fn finding(answer: &WorkspaceAnswer, region: &Region<'_>, shape: &Outline, limits: Option<&str>) -> Option<Finding> {
    let method = answer.method().to_owned();
    let shape = match shape {
        Outline::Hull(hull) if hull.dimension() == 2 => Shape::Areas(vec![Polygon::of(hull)?.vertices]),
        Outline::Hull(hull) => Shape::Surface { mesh: hull.mesh(region), method },
        Outline::Surface(mesh) if region.dimension() == 3 && (1..=MOST_TRIANGLES).contains(&mesh.triangles.len()) => {
            Shape::Surface { mesh: mesh.clone(), method }
        }
        _ => Shape::Unknown,
    };
    let mut name = vec![region.criterion().name().to_owned()];
    name.extend(limits.map(str::to_owned));
    if region.orientations().len() > 1 {
        name.push(region.archetype().to_owned());
        name.extend(match region.side() {
            Side::Exact => None,
            Side::AtLeast => Some("at least".to_owned()),
            Side::AtMost => Some("at most".to_owned()),
        });
    }
    name.push(answer.method().to_owned());
    Some(Finding { name: name.join(", "), measure: answer.size()?, error_bound: answer.error_bound(), shape })
}

fn limit_words(limits: &Limits) -> String {
    let (least, largest) = (limits.minimum(), limits.maximum());
    let same = |values: &[f64]| values.iter().all(|value| Some(value) == values.first());
    match (least.first(), largest.first()) {
        (Some(from), Some(to)) if same(least) && same(largest) => {
            format!("{} N to {} N", short(*from), short(*to))
        }
        _ => "limits of each cable".to_owned(),
    }
}

fn archetype_words(region: &Region<'_>) -> String {
    match region.orientations() {
        [_] => region.archetype().to_owned(),
        many => format!("{} of {} orientations", region.archetype(), many.len()),
    }
}

/// Corners of what was found, along the axes of the box (m).
fn corners(region: &Region<'_>, shape: &Outline) -> Vec<Point> {
    match shape {
        Outline::Size => Vec::new(),
        Outline::Hull(hull) => hull.vertices(),
        Outline::Surface(mesh) => mesh.vertices.iter().map(|vertex| region.point(&Vector3::from(*vertex))).collect(),
    }
}

/// The box of what was found and a little around it; where nothing was the box that was searched.
fn bounds(searched: &Bounds, corners: &[Point]) -> Vec<[f64; 2]> {
    let ends: Vec<[f64; 2]> = searched.ends().as_chunks::<2>().0.to_vec();
    if corners.is_empty() {
        return ends;
    }
    let around = |(axis, [low, high]): (usize, [f64; 2])| {
        let along = || corners.iter().map(|corner| corner[axis]);
        let (least, largest) = (along().fold(high, f64::min), along().fold(low, f64::max));
        let more = MARGIN * (largest - least);
        [(least - more).max(low), (largest + more).min(high)]
    };
    ends.into_iter().enumerate().map(around).collect()
}
