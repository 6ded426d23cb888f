//! Sizes of workspaces with what is known of their errors.

use cdpr_model::model::Model;
use cdpr_workspace::grid::{Count, Grid};
use cdpr_workspace::hull::{Hull, Status};
use cdpr_workspace::mesh::Mesh;
use cdpr_workspace::octree::Octree;
use cdpr_workspace::refine::{Goal, Refined};
use cdpr_workspace::{Audit, Bounds, CONFIDENCE, Point, Region, Side, largest_rank};
use schemars::JsonSchema;
use serde::Serialize;

use super::Answer;
use super::workspace_parts::{Singular, Unless};
use crate::keys::{AuditKeys, Maybe};
use crate::number_format::significant;

/// Question of a search.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    /// The model.
    pub model: &'a Model,
    /// Criteria and orientations.
    pub region: &'a Region<'a>,
    /// Box that was searched.
    pub bounds: &'a Bounds,
    /// Bound of the error that is wanted.
    pub goal: &'a Goal,
    /// Home position, where it is looked for first.
    pub home: Point,
}

/// Area or volume of the poses at which criteria hold, with a bound of its error.
#[derive(Default, Serialize, JsonSchema)]
#[schemars(rename = "Workspace")]
pub struct WorkspaceAnswer {
    status: &'static str,
    reason: Option<String>,
    robot: String,
    model: String,
    /// Name of the criterion.
    criterion: String,
    /// Kind of workspace by its orientations.
    archetype: &'static str,
    /// Number of orientations at which each position is judged.
    orientations: usize,
    /// Method that found the size.
    method: &'static str,
    /// Box that was searched, ends along each axis (m).
    bounds_m: Vec<f64>,
    /// Area (m²), of a planar robot; null where it has none.
    #[serde(rename = "area_m2", skip_serializing_if = "Unless::is_other")]
    area: Unless,
    /// Volume (m³), of a spatial robot; null where it has none.
    #[serde(rename = "volume_m3", skip_serializing_if = "Unless::is_other")]
    volume: Unless,
    /// `value`, or a `lower bound` or `upper bound` of the size over more orientations than were judged.
    size_is: &'static str,
    /// Bound of the error of the size (m² or m³); null where there is none.
    error_bound: Option<f64>,
    /// Probability of the bound.
    #[serde(skip_serializing_if = "Option::is_none")]
    confidence: Option<f64>,
    /// Why the bound is no smaller, where it is larger than wanted.
    #[serde(skip_serializing_if = "Option::is_none")]
    bound_limited_by: Option<String>,
    /// Poses judged.
    points: u64,
    /// Poses of these that belong to the workspace.
    feasible_points: u64,
    /// Random points at which the result is judged.
    #[serde(with = "Maybe::<AuditKeys>", skip_serializing_if = "Option::is_none")]
    random_points: Option<Audit>,
    /// True where the workspace reaches the box.
    reaches_bounds: bool,
    /// Rank of the structure matrix, where it is below full rank everywhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    singular: Option<Singular>,
    /// Centroid (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    centroid_m: Option<Vec<f64>>,
    /// Edges of the cells (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    cell_m: Option<Vec<f64>>,
    /// Number of points of the grid.
    #[serde(skip_serializing_if = "Option::is_none")]
    grid_points: Option<u64>,
    /// Edges of the cells that the search starts with (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    start_cell_m: Option<Vec<f64>>,
    /// Number of rays of the hull.
    #[serde(skip_serializing_if = "Option::is_none")]
    rays: Option<usize>,
    /// Rays that enter the workspace again.
    #[serde(skip_serializing_if = "Option::is_none")]
    rays_again: Option<usize>,
    /// Centre of the rays (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    center_m: Option<Vec<f64>>,
    /// Length of the outline (m).
    #[serde(skip_serializing_if = "Option::is_none")]
    outline_m: Option<f64>,
    /// Area of the surface (m²).
    #[serde(skip_serializing_if = "Option::is_none")]
    #[serde(rename = "surface_m2")]
    surface: Option<f64>,
    /// File of the mesh.
    #[serde(skip_serializing_if = "Option::is_none")]
    mesh: Option<String>,
    /// Page that was written.
    #[serde(skip_serializing_if = "Option::is_none")]
    page: Option<String>,
}

fn components(point: &Point, dimension: usize) -> Option<Vec<f64>> {
    Some(point[..dimension].iter().map(|part| part + 0.0).collect())
}

fn common(asked: &Asked<'_>, method: &'static str, size: Option<f64>) -> WorkspaceAnswer {
    let region = asked.region;
    let is_planar = region.dimension() == 2;
    WorkspaceAnswer {
        status: "found",
        robot: asked.model.robot().name.clone(),
        model: asked.model.composition().to_string(),
        criterion: region.criterion().name().to_owned(),
        archetype: region.archetype(),
        orientations: region.orientations().len(),
        method,
        bounds_m: asked.bounds.ends(),
        size_is: match region.side() {
            Side::Exact => "value",
            Side::AtLeast => "lower bound",
            Side::AtMost => "upper bound",
        },
        area: if is_planar { Unless::Size(size) } else { Unless::Other },
        volume: if is_planar { Unless::Other } else { Unless::Size(size) },
        ..WorkspaceAnswer::default()
    }
}

/// Says how exact the size is, and why nothing was found, if nothing was.
fn judged(mut answer: WorkspaceAnswer, asked: &Asked<'_>, audit: &Audit) -> WorkspaceAnswer {
    let region = asked.region;
    let Audit { points, feasible_points, .. } = *audit;
    answer.random_points = Some(audit.clone());
    if let Some(size) = answer.size() {
        answer.error_bound = Some(audit.error_bound());
        answer.confidence = Some(CONFIDENCE);
        answer.bound_limited_by = limit(asked, answer.method, audit, size);
    }
    let dof = asked.model.dof();
    answer.singular = largest_rank(asked.model, region, &audit.inside)
        .filter(|rank| *rank < dof)
        .map(|rank| Singular { rank, degrees_of_freedom: dof });
    if answer.feasible_points > 0 || feasible_points > 0 {
        return answer;
    }
    let point = asked.home;
    let place: Vec<String> = point[..region.dimension()].iter().map(|part| significant(*part, 4)).collect();
    let why = region.judge(&point).reason;
    let why = why.map_or_else(String::new, |why| format!("; at ({}) m: {why}", place.join(", ")));
    answer.status = "empty";
    let judged = answer.points + points;
    answer.reason = Some(format!("the criteria hold at none of {judged} poses in the bounds{why}"));
    answer
}

/// Reason why the bound of the error stays above the part of the size that is wanted.
fn limit(asked: &Asked<'_>, method: &str, audit: &Audit, size: f64) -> Option<String> {
    let wanted = asked.goal.fraction;
    let is_small = audit.error_bound() <= wanted * size || (size == 0.0 && audit.missed == 0);
    let finer = if method == "hull" { "--rays" } else { "--step" };
    (!is_small).then(|| match asked.goal.refines {
        true => format!(
            "more poses than a search judges by itself would bring the bound of the error below {} %: give a finer {finer}, \
             or --bounds closer around the workspace",
            significant(100.0 * wanted, 2)
        ),
        false => format!("the {finer} that was asked for"),
    })
}

impl WorkspaceAnswer {
    /// Nothing was found to start rays from.
    pub fn empty(asked: &Asked<'_>, audit: &Audit) -> Self {
        let answer = judged(common(asked, "hull", Some(0.0)), asked, audit);
        Self { points: audit.points, ..answer }
    }

    /// Cells of a grid that hold.
    pub fn by_grid(asked: &Asked<'_>, grid: &Grid, count: &Count, audit: &Audit) -> Self {
        let (outcome, dimension) = (count.outcome(grid), asked.region.dimension());
        let cell = [0, 1, 2].map(|axis| asked.bounds.extent(axis) / grid.counts()[axis] as f64);
        let answer = Self {
            points: count.points,
            feasible_points: count.feasible_points,
            reaches_bounds: outcome.reaches_bounds,
            centroid_m: (count.feasible_points > 0).then(|| components(&outcome.centroid, dimension)).flatten(),
            cell_m: components(&cell, dimension),
            ..common(asked, "grid", Some(outcome.size))
        };
        judged(answer, asked, audit)
    }

    /// Cells refined at the boundary.
    pub fn by_octree(asked: &Asked<'_>, refined: &Refined<Octree<'_>>) -> Self {
        let outcome = refined.found.outcome();
        let answer = Self {
            points: outcome.points,
            feasible_points: outcome.feasible_points,
            reaches_bounds: outcome.reaches_bounds,
            grid_points: Some(outcome.grid_points),
            start_cell_m: components(&outcome.start_cell, asked.region.dimension()),
            ..common(asked, "octree", Some(outcome.size))
        };
        judged(answer, asked, &refined.audit)
    }

    /// Rays from a centre.
    pub fn by_hull(asked: &Asked<'_>, refined: &Refined<Hull>) -> Self {
        let hull = &refined.found;
        let (measure, dimension) = (hull.measure(), asked.region.dimension());
        let surface = measure.map(|measure| measure.surface);
        let mut answer = Self {
            points: hull.points,
            feasible_points: hull.feasible_points,
            reaches_bounds: hull.rays_at_bounds > 0,
            centroid_m: measure.and_then(|measure| components(&measure.centroid, dimension)),
            rays: Some(hull.radii.len()),
            rays_again: Some(hull.rays_again),
            center_m: components(&hull.center, dimension),
            outline_m: surface.filter(|_| dimension == 2),
            surface: surface.filter(|_| dimension == 3),
            ..common(asked, "hull", measure.map(|measure| measure.size))
        };
        answer = judged(answer, asked, &refined.audit);
        if let Some(reason) = no_hull(hull, asked) {
            answer.status = "not-star-shaped";
            answer.reason = Some(reason);
        }
        answer
    }
}

/// Why a hull would give a wrong size.
fn no_hull(hull: &Hull, asked: &Asked<'_>) -> Option<String> {
    let cure = "so that the hull would give a wrong size; use --method octree or grid, or another --center";
    match &hull.status {
        Status::NotStarShaped { rays, direction } => {
            let parts: Vec<String> = direction[..hull.dimension()].iter().map(|part| significant(*part, 3)).collect();
            Some(format!(
                "{rays} of {} rays enter the workspace again after they have left it, one of them in the direction ({}): seen \
                 from this center it has gaps or dents, {cure}",
                hull.radii.len(),
                parts.join(", ")
            ))
        }
        Status::LeavesOut { size } => {
            let unit = if asked.bounds.dimension() == 2 { "m²" } else { "m³" };
            Some(format!(
                "points drawn at random show that at least {} {unit} of the workspace lie outside what {} rays see from this \
                 center, in parts too thin or too far aside for them, {cure}",
                significant(*size, 2),
                hull.radii.len()
            ))
        }
        _ => None,
    }
}

impl WorkspaceAnswer {
    /// Tells the file of the page.
    pub fn set_page(&mut self, path: String) {
        self.page = Some(path);
    }

    /// Tells the file of the surface, and its area where no other is told.
    pub fn set_mesh(&mut self, path: String, mesh: &Mesh) {
        self.mesh = Some(path);
        if matches!(self.area, Unless::Other) && self.status == "found" {
            self.surface = self.surface.or_else(|| Some(mesh.area()));
        }
    }

    /// Area (m²) or volume (m³), where there is one.
    pub fn size(&self) -> Option<f64> {
        match (&self.area, &self.volume) {
            (Unless::Size(size), _) | (_, Unless::Size(size)) => *size,
            _ => None,
        }
    }

    /// The size is known to ± this (m², m³).
    pub fn error_bound(&self) -> Option<f64> {
        self.error_bound
    }

    /// How it was found.
    pub fn method(&self) -> &'static str {
        self.method
    }

    /// Why the answer is negative, if it is.
    pub fn reason(&self) -> Option<&str> {
        self.reason.as_deref()
    }

    /// Remarks for a careful reader.
    pub fn remarks(&self) -> Vec<String> {
        let mut remarks = Vec::new();
        if self.reaches_bounds {
            remarks.push(
                "the workspace reaches the bounds, so that more of it may lie outside: widen --bounds".to_owned(),
            );
        }
        if let Some(again) = self.rays_again.filter(|again| *again > 0 && self.status == "found") {
            remarks.push(format!(
                "{again} of the rays enter the workspace again after they have left it, for so short a way that the bound of the \
                 error covers what they see there"
            ));
        }
        if let Some(Singular { rank, degrees_of_freedom }) = self.singular {
            remarks.push(format!(
                "the structure matrix has rank {rank} of {degrees_of_freedom} wherever it was looked at in the workspace: the \
                 cables balance the load, but in some direction none of them acts, so that any other load there moves the \
                 platform; add --criterion wrench-closure or stability to ask for more"
            ));
        }
        if let Some(limit) = &self.bound_limited_by {
            remarks.push(format!("the bound of the error is large: {limit}"));
        }
        remarks
    }
}

impl WorkspaceAnswer {
    /// The size with its bound; where orientations are samples the side on which it lies.
    fn size_words(&self, name: &str, unit: &str, [size, bound]: [f64; 2]) -> String {
        let (size, bound) = (significant(size, 5), significant(bound, 2));
        let sure =
            self.confidence.map_or_else(String::new, |share| format!(" ({} % sure)", significant(100.0 * share, 3)));
        let within = format!("{size} {unit}, within {bound} {unit}{sure}");
        let count = self.orientations;
        match self.size_is {
            "lower bound" => {
                format!("{name} at least that of the {count} orientations judged: {within}; others may add to it\n")
            }
            "upper bound" => {
                format!("{name} at most that of the {count} orientations judged: {within}; others may take from it\n")
            }
            _ => format!("{name} {within}\n"),
        }
    }
}

impl Answer for WorkspaceAnswer {
    fn is_negative(&self) -> bool {
        self.status != "found"
    }

    fn words(&self, _width: Option<usize>) -> String {
        let mut text = format!("{}, model {}: {}, {}", self.robot, self.model, self.criterion, self.archetype);
        if self.orientations > 1 {
            text.push_str(&format!(" ({} orientations)", self.orientations));
        }
        text.push('\n');
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{}: {reason}\n", self.status));
        }
        let (name, unit, size) = match (&self.area, &self.volume) {
            (Unless::Size(size), _) => ("area", "m²", size),
            (_, Unless::Size(size)) => ("volume", "m³", size),
            _ => return text,
        };
        if let (Some(size), Some(bound)) = (size, self.error_bound) {
            text.push_str(&self.size_words(name, unit, [*size, bound]));
        }
        let rays = self.rays.map_or_else(String::new, |rays| format!(" along {rays} rays"));
        text.push_str(&format!(
            "{}: {} points judged{rays}, {} of them hold\n",
            self.method, self.points, self.feasible_points
        ));
        if let Some(Audit { points, missed, added, .. }) =
            self.random_points.as_ref().filter(|_| self.error_bound.is_some())
        {
            text.push_str(&format!(
                "bound of the error: at {points} points drawn at random, {missed} of the workspace are missed and {added} counted that are \
                 none of it\n"
            ));
        }
        if let Some(mesh) = &self.mesh {
            text.push_str(&format!("surface written to {mesh}\n"));
        }
        if let Some(page) = &self.page {
            text.push_str(&format!("page written to {page}\n"));
        }
        text
    }
}
