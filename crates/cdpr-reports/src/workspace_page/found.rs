//! The page of a search.

use cdpr_model::geometry::Pose;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::hull::Hull;
use cdpr_workspace::mesh::Mesh;
use cdpr_workspace::{Bounds, Point, Region, Side};
use nalgebra::{UnitQuaternion, Vector3};

use super::{Finding, Shape, WorkspacePage, render};
use crate::PageError;
use crate::answers::{Asked, WorkspaceAnswer, WrenchAnswer};
use crate::number_format::short;

/// A finding besides its numbers.
pub enum Outline {
    /// Only its size.
    Size,
    /// Rays and where they end.
    Hull(Hull),
    /// The boundary.
    Surface(Mesh),
}

impl Outline {
    /// The boundary as triangles, where it is known.
    pub fn mesh(&self, region: &Region<'_>) -> Option<Mesh> {
        match self {
            Self::Size => None,
            Self::Hull(hull) => Some(hull.mesh(region)),
            Self::Surface(mesh) => Some(mesh.clone()),
        }
    }
}

/// A workspace that was searched, with all that its page shows.
pub struct FoundWorkspace<'a> {
    /// Question of the search.
    pub asked: Asked<'a>,
    /// Load and limits, where both are known.
    pub statics: Option<(&'a Load, &'a Limits)>,
    /// The answer.
    pub answer: &'a WorkspaceAnswer,
    /// Its form.
    pub outline: &'a Outline,
    /// Results of earlier pages to lay over.
    pub earlier: Vec<Finding>,
    /// The command that makes the page again.
    pub command: &'a str,
    /// Version of the program.
    pub version: &'a str,
}

impl FoundWorkspace<'_> {
    /// The page as HTML.
    pub fn page(self) -> Result<String, PageError> {
        let Self { asked, statics, answer, outline, .. } = self;
        let region = asked.region;
        let hull = match outline {
            Outline::Hull(hull) => Some(hull),
            _ => None,
        };
        let start = start(&asked, hull);
        let limits = statics.map(|(_, limits)| limit_words(limits));
        let own = finding(answer, region, outline, limits.as_deref());
        let is_found = own.is_some();
        let findings: Vec<Finding> = own.into_iter().chain(self.earlier).collect();
        let bounds = bounds(asked.bounds, &corners(region, outline));
        let mut facts =
            vec![("Criterion", region.criterion().name().to_owned()), ("Archetype", archetype_words(region))];
        facts.extend(limits.map(|words| ("Tension limits", words)));
        facts.extend(statics.map(|(load, _)| ("Load", load_words(&asked, load, &start))));
        let mut warnings = answer.remarks();
        warnings.extend(answer.reason().map(str::to_owned));
        render(&WorkspacePage {
            model: asked.model,
            answer,
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
            command: self.command,
            version: self.version,
        })
    }
}

/// The load at a pose with its names and units.
fn load_words(asked: &Asked<'_>, load: &Load, start: &Pose) -> String {
    let load = WrenchAnswer::new(asked.model.robot(), &load.wrench(start));
    let with_value = |(heading, value): (String, String)| match heading.split_once(' ') {
        Some((name, unit)) => format!("{name} {value} {unit}"),
        None => format!("{heading} {value}"),
    };
    load.heading().into_iter().zip(load.cells()).map(with_value).collect::<Vec<_>>().join(", ")
}

/// Beyond what was found the grid of the page reaches by this share of its size: what fails is worth a look too.
const MARGIN: f64 = 0.15;

/// Surfaces of more triangles would make the page larger than a browser likes.
const MOST_TRIANGLES: usize = 100_000;

/// The centre of the hull, or the home position, in the orientation nearest to none.
fn start(asked: &Asked<'_>, hull: Option<&Hull>) -> Pose {
    let region = asked.region;
    let point = hull.map_or(asked.home, |hull| hull.center);
    let turn = |rotation: &&UnitQuaternion<f64>| rotation.angle();
    let nearest = region.orientations().iter().min_by(|a, b| turn(a).total_cmp(&turn(b)));
    Pose { position: region.position(&point), rotation: nearest.copied().unwrap_or_else(UnitQuaternion::identity) }
}

fn finding(answer: &WorkspaceAnswer, region: &Region<'_>, shape: &Outline, limits: Option<&str>) -> Option<Finding> {
    let method = answer.method().to_owned();
    let shape = match shape {
        Outline::Hull(hull) if hull.dimension() == 2 => {
            let corners = hull.vertices().iter().map(|point| [point[0], point[1]]).collect();
            Shape::Areas(hull.is_star_shaped().then_some(vec![corners])?)
        }
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
