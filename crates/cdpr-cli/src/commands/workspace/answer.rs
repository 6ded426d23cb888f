//! What `cdpr workspace` answers.

use std::path::Path;

use cdpr::workspace::grid::{Count, Grid};
use cdpr::workspace::hull::{Hull, Status};
use cdpr::workspace::mesh::Mesh;
use cdpr::workspace::{Point, Region, octree};
use serde::Serialize;

use super::Method;
use super::question::Question;
use crate::answer::Answer;
use crate::number_format::significant;

#[derive(Default, Serialize)]
pub(super) struct WorkspaceAnswer {
    status: &'static str,
    reason: Option<String>,
    robot: String,
    model: String,
    criterion: String,
    archetype: &'static str,
    orientations: usize,
    method: &'static str,
    bounds_m: Vec<f64>,
    #[serde(rename = "area_m2", skip_serializing_if = "Unless::is_other")]
    area: Unless,
    #[serde(rename = "volume_m3", skip_serializing_if = "Unless::is_other")]
    volume: Unless,
    error_bound: Option<f64>,
    points: u64,
    feasible_points: u64,
    reaches_bounds: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    centroid_m: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    cell_m: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    grid_points: Option<u64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    start_cell_m: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rays: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rays_again: Option<usize>,
    #[serde(skip_serializing_if = "Option::is_none")]
    center_m: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    outline_m: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    #[serde(rename = "surface_m2")]
    surface: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mesh: Option<String>,
    /// The page, where one was written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) page: Option<String>,
}

/// A size, or null where there is none; left out where the robot has the other kind.
#[derive(Default, Serialize)]
#[serde(untagged)]
enum Unless {
    #[default]
    Other,
    Size(Option<f64>),
}

impl Unless {
    fn is_other(&self) -> bool {
        matches!(self, Self::Other)
    }
}

fn components(point: &Point, dimension: usize) -> Option<Vec<f64>> {
    Some(point[..dimension].iter().map(|part| part + 0.0).collect())
}

fn common(question: &Question<'_>, region: &Region<'_>, size: Option<f64>) -> WorkspaceAnswer {
    let is_planar = region.dimension() == 2;
    WorkspaceAnswer {
        status: "found",
        robot: question.model.robot().name.clone(),
        model: question.model.composition().to_string(),
        criterion: region.criterion().name().to_owned(),
        archetype: region.archetype(),
        orientations: region.orientations().len(),
        method: match question.method {
            Method::Grid => "grid",
            Method::Octree => "octree",
            Method::Hull => "hull",
        },
        bounds_m: question.bounds.ends(),
        area: if is_planar { Unless::Size(size) } else { Unless::Other },
        volume: if is_planar { Unless::Other } else { Unless::Size(size) },
        ..WorkspaceAnswer::default()
    }
}

/// Says why nothing was found, if nothing was.
fn judged(mut answer: WorkspaceAnswer, question: &Question<'_>, region: &Region<'_>) -> WorkspaceAnswer {
    if answer.feasible_points > 0 {
        return answer;
    }
    let point = question.home(region);
    let place: Vec<String> = point[..region.dimension()].iter().map(|part| significant(*part, 4)).collect();
    let why = region.judge(&point).reason;
    let why = why.map_or_else(String::new, |why| format!("; at ({}) m: {why}", place.join(", ")));
    answer.status = "empty";
    answer.reason = Some(format!("the criteria hold at none of {} poses in the bounds{why}", answer.points));
    answer
}

pub(super) fn empty(question: &Question<'_>, region: &Region<'_>) -> WorkspaceAnswer {
    judged(WorkspaceAnswer { error_bound: None, ..common(question, region, Some(0.0)) }, question, region)
}

pub(super) fn by_grid(question: &Question<'_>, region: &Region<'_>, grid: &Grid, count: &Count) -> WorkspaceAnswer {
    let (outcome, dimension) = (count.outcome(grid), region.dimension());
    let cell = [0, 1, 2].map(|axis| question.bounds.extent(axis) / grid.counts()[axis] as f64);
    let answer = WorkspaceAnswer {
        error_bound: Some(outcome.error_bound),
        points: count.points,
        feasible_points: count.feasible_points,
        reaches_bounds: outcome.reaches_bounds,
        centroid_m: (count.feasible_points > 0).then(|| components(&outcome.centroid, dimension)).flatten(),
        cell_m: components(&cell, dimension),
        ..common(question, region, Some(outcome.size))
    };
    judged(answer, question, region)
}

pub(super) fn by_octree(question: &Question<'_>, region: &Region<'_>, outcome: &octree::Outcome) -> WorkspaceAnswer {
    let answer = WorkspaceAnswer {
        error_bound: Some(outcome.error_bound),
        points: outcome.points,
        feasible_points: outcome.feasible_points,
        reaches_bounds: outcome.reaches_bounds,
        grid_points: Some(outcome.grid_points),
        start_cell_m: components(&outcome.start_cell, region.dimension()),
        ..common(question, region, Some(outcome.size))
    };
    judged(answer, question, region)
}

pub(super) fn by_hull(question: &Question<'_>, region: &Region<'_>, hull: &Hull) -> WorkspaceAnswer {
    let (measure, dimension) = (hull.measure(), region.dimension());
    let surface = measure.map(|measure| measure.surface);
    let mut answer = WorkspaceAnswer {
        error_bound: measure.map(|measure| measure.error_bound),
        points: hull.points,
        feasible_points: hull.feasible_points,
        reaches_bounds: hull.rays_at_bounds > 0,
        centroid_m: measure.and_then(|measure| components(&measure.centroid, dimension)),
        rays: Some(hull.radii.len()),
        rays_again: Some(hull.rays_again),
        center_m: components(&hull.center, dimension),
        outline_m: surface.filter(|_| dimension == 2),
        surface: surface.filter(|_| dimension == 3),
        ..common(question, region, measure.map(|measure| measure.size))
    };
    if let Status::NotStarShaped { rays, direction } = &hull.status {
        let parts: Vec<String> = direction[..dimension].iter().map(|part| significant(*part, 3)).collect();
        answer.status = "not-star-shaped";
        answer.reason = Some(format!(
            "{rays} of {} rays enter the workspace again after they have left it, one of them in the direction ({}): seen from \
             this center it has gaps or dents, so that the hull would give a wrong size; use --method octree or grid, or \
             another --center",
            hull.radii.len(),
            parts.join(", ")
        ));
    }
    answer
}

impl WorkspaceAnswer {
    /// The surface was written there. Its area is told where no other is.
    pub(super) fn set_mesh(&mut self, path: &Path, mesh: &Mesh) {
        self.mesh = Some(path.display().to_string());
        if matches!(self.area, Unless::Other) && self.status == "found" {
            self.surface = self.surface.or_else(|| Some(mesh.area()));
        }
    }

    /// Area (m²) or volume (m³), where there is one.
    pub(super) fn size(&self) -> Option<f64> {
        match (&self.area, &self.volume) {
            (Unless::Size(size), _) | (_, Unless::Size(size)) => *size,
            _ => None,
        }
    }

    /// The size is known to ± this (m², m³).
    pub(super) fn error_bound(&self) -> Option<f64> {
        self.error_bound
    }

    /// How it was found.
    pub(super) fn method(&self) -> &'static str {
        self.method
    }

    /// Why the answer is negative, if it is.
    pub(super) fn reason(&self) -> Option<&str> {
        self.reason.as_deref()
    }

    /// What a careful reader should know.
    pub(super) fn remarks(&self) -> Vec<String> {
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
        if let Some(start) = &self.start_cell_m {
            let sides: Vec<String> = start.iter().map(|side| significant(*side, 3)).collect();
            remarks.push(format!(
                "parts and gaps of the workspace that fit into a start cell of {} m and touch nothing else are not seen",
                sides.join(" × ")
            ));
        }
        remarks
    }
}

impl Answer for WorkspaceAnswer {
    fn is_negative(&self) -> bool {
        self.status != "found"
    }

    fn words(&self) -> String {
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
            text.push_str(&format!(
                "{name} {} {unit}, within {} {unit}\n",
                significant(*size, 5),
                significant(bound, 2)
            ));
        }
        let rays = self.rays.map_or_else(String::new, |rays| format!(" along {rays} rays"));
        text.push_str(&format!(
            "{}: {} points judged{rays}, {} of them hold\n",
            self.method, self.points, self.feasible_points
        ));
        if let Some(mesh) = &self.mesh {
            text.push_str(&format!("surface written to {mesh}\n"));
        }
        if let Some(page) = &self.page {
            text.push_str(&format!("page written to {page}\n"));
        }
        text
    }
}
