//! The answer of what is reached.

use cdpr_model::compensation::Beyond;
use cdpr_model::control::MapEffect;
use cdpr_study::Experiment;
use cdpr_study::reachable::{CountedCells, Image, Reachable, emerging_size};
use cdpr_workspace::grid;
use cdpr_workspace::hull::Hull;
use cdpr_workspace::{Audit, CONFIDENCE};
use cdpr_workspace::{Bounds, Point, Region, components};
use schemars::JsonSchema;
use serde::{Serialize, Serializer};
use serde_json::json;

use super::Differential;
use super::differential::DifferentialKeys;
use crate::answers::{BEYOND_THE_WHOLE, Size, beyond_map, control_title, is_beyond_the_whole, title};
use crate::keys::BeyondKeys;
use crate::keys::table_schema::{EmergingSize, LinearSize, ModelSize, PartSize, PhysicalSize, ReachableSize};

/// Question of a search.
#[derive(Clone, Copy)]
pub struct Searched<'a> {
    /// Control model, machine and limits.
    pub experiment: &'a Experiment,
    /// Orientation that counts.
    pub region: &'a Region<'a>,
    /// Box that was searched.
    pub bounds: &'a Bounds,
}

/// Cells of a grid that refined itself whose emerging neighbours are asked for.
const MOST_MOVED: usize = 20_000;

/// Sizes of the workspaces of a study; keys and units as in JSON.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Reachable")]
pub struct ReachableAnswer {
    status: &'static str,
    /// Reason why the answer is negative.
    pub(super) reason: Option<String>,
    pub(super) control: String,
    pub(super) machine: String,
    /// Method that found the sizes.
    pub(super) method: &'static str,
    /// Box that was searched.
    bounds_m: Vec<f64>,
    /// Largest position error that counts as reached.
    position_error_max_m: Option<f64>,
    /// Largest difference of a tension from the commanded one that counts as reached.
    #[serde(rename = "tension_error_max_N", skip_serializing_if = "Option::is_none")]
    tension_error_max: Option<f64>,
    /// Reachable, by emerging poses.
    #[serde(flatten)]
    #[schemars(with = "EmergingSize")]
    pub(super) emerging: Size,
    /// Reachable set by one linear step; `None` if it was not asked for, null without a size.
    #[serde(flatten)]
    #[schemars(with = "LinearSize")]
    pub(super) linear: Option<Size>,
    /// The control model is wrench-feasible.
    #[serde(flatten)]
    #[schemars(with = "ModelSize")]
    pub(super) model: Size,
    /// The machine is wrench-feasible.
    #[serde(flatten)]
    #[schemars(with = "PhysicalSize")]
    pub(super) physical: Size,
    /// Reachable, by commanded poses.
    #[serde(flatten)]
    #[schemars(with = "ReachableSize")]
    pub(super) reachable: Size,
    /// Reachable share of the physical workspace.
    share: Option<f64>,
    /// Effect of the map that corrects the control model.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) compensation: Option<MapAnswer>,
    /// Remark on a share above 100 %, or on poses beyond the samples of a map.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) remark: Option<String>,
    /// Bound of the error of the reachable one.
    pub(super) error_bound: Option<f64>,
    /// Probability with which the bound holds, where points drawn at random show it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) confidence: Option<f64>,
    /// Poses judged.
    pub(super) points: u64,
    /// Poses of these that are reached.
    pub(super) feasible_points: u64,
    /// True where the box cuts the reachable workspace.
    pub(super) reaches_bounds: bool,
    /// Workspaces that reach the faces of the box, so that more of them may lie outside.
    pub(super) at_bounds: Vec<&'static str>,
    /// Parts that do not touch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) parts: Option<Vec<Part>>,
    /// Sizes by the largest position error.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) by_accuracy: Vec<WithError>,
    /// Corners of the hull of a planar robot, in order: where poses are commanded.
    #[serde(skip_serializing_if = "Option::is_none")]
    outline_m: Option<Vec<[f64; 2]>>,
    /// The same where the platform comes to rest.
    #[serde(skip_serializing_if = "Option::is_none")]
    emerging_outline_m: Option<Vec<[f64; 2]>>,
    /// A change of one number.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<DifferentialKeys>")]
    pub(super) differential: Option<Differential>,
    winch_offsets_m: Vec<f64>,
}

/// Effect of a map.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "MappedReachable")]
pub(super) struct MapAnswer {
    #[serde(flatten, with = "BeyondKeys")]
    beyond: Beyond,
    /// Size reached without it; none where the hull has none.
    pub(super) without: SizeAndShare,
}

/// Size with its share of the physical workspace.
#[derive(Serialize, JsonSchema)]
pub(super) struct SizeAndShare {
    #[serde(flatten)]
    #[schemars(with = "ReachableSize")]
    pub(super) size: Size,
    /// Share of the physical workspace; null without one.
    share: Option<f64>,
}

/// Size reached with a largest position error.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "ReachableWithError")]
pub(super) struct WithError {
    /// Largest position error that counts as reached (m).
    pub(super) position_error_max_m: f64,
    #[serde(flatten)]
    pub(super) reached: SizeAndShare,
}

/// Part of a workspace that touches no other, with one of its points.
#[derive(JsonSchema)]
#[schemars(rename = "WorkspacePart")]
pub(super) struct Part {
    #[schemars(flatten, with = "PartSize")]
    pub(super) size: Size<f64>,
    /// One of its points (m).
    position_m: Vec<f64>,
}

impl Serialize for Part {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        json!({ self.size.key(): self.size.value, "position_m": self.position_m }).serialize(serializer)
    }
}

impl ReachableAnswer {
    /// Answer of a method that judged so many poses, of which so many are reached, with the sizes of what is reached by commanded and by emerging poses and of the
    /// wrench-feasible workspaces of machine and control model.
    fn new(
        Searched { experiment, region, bounds }: Searched<'_>,
        method: &'static str,
        [points, feasible_points]: [u64; 2],
        [reachable, emerging, physical, model]: [Option<f64>; 4],
    ) -> Self {
        let is_planar = region.dimension() == 2;
        let size = |name, value| Size { name, is_planar, value };
        let limits = experiment.study.limits.as_ref();
        let mut answer = Self {
            status: "found",
            reason: None,
            control: control_title(experiment),
            machine: title(&experiment.machine),
            method,
            bounds_m: bounds.ends(),
            position_error_max_m: limits.and_then(|limits| limits.position_error_max_m),
            tension_error_max: limits.and_then(|limits| limits.tension_error_max_N),
            emerging: size("emerging", emerging),
            linear: None,
            model: size("model", model),
            physical: size("physical", physical),
            reachable: size("reachable", reachable),
            share: None,
            compensation: None,
            remark: None,
            error_bound: None,
            confidence: None,
            points,
            feasible_points,
            reaches_bounds: false,
            at_bounds: Vec::new(),
            parts: None,
            by_accuracy: Vec::new(),
            outline_m: None,
            emerging_outline_m: None,
            differential: None,
            winch_offsets_m: experiment.offsets.clone(),
        };
        answer.share = answer.share_of(reachable);
        answer.remark = is_beyond_the_whole(answer.share).then(|| BEYOND_THE_WHOLE.to_owned());
        answer
    }

    /// Answer by the cells of a grid: those that are reached, also with each of these largest errors (m), and the wrench-feasible ones of machine and control model.
    ///
    /// The bound of the error is that of the audit; without one that of the cells at the boundary.
    pub fn of_grid(
        searched: Searched<'_>,
        reachable: &Reachable,
        CountedCells { grid, census, answers }: &CountedCells,
        audit: Option<&Audit>,
        [physical, model]: [Option<grid::Outcome>; 2],
        thresholds: &[f64],
    ) -> Self {
        let region = searched.region;
        let reached = grid::outcome(grid, answers);
        let cells = answers.iter().enumerate().filter(|(_, holds)| **holds);
        let cells: Vec<_> = cells.map(|(cell, _)| (cell / grid.slab_points(), cell % grid.slab_points())).collect();
        let points: Vec<Point> = cells.iter().map(|&(slab, index)| grid.point(slab, index)).collect();
        let size = |region: &Region<'_>| Some(grid::count(region, grid).outcome(grid).size);
        let of = |outcome: &Option<grid::Outcome>| outcome.as_ref().map(|outcome| outcome.size);
        let reaches = |outcome: &Option<grid::Outcome>| outcome.as_ref().is_some_and(|outcome| outcome.reaches_bounds);
        // the ratio of the sizes changes slowly from cell to cell: of a grid that refined itself some of them show it
        let stride = audit.map_or(1, |_| cells.len().div_ceil(MOST_MOVED).max(1));
        let some: Vec<_> = cells.iter().copied().step_by(stride).collect();
        let all_of_some = cells.len() as f64 / some.len().max(1) as f64;
        let emerging = all_of_some * emerging_size(reachable, region, grid, &some);
        let sizes = [Some(reached.size), Some(emerging), of(&physical), of(&model)];
        let answer = Self::new(searched, "grid", [grid.points(), cells.len() as u64], sizes);
        let is_planar = answer.reachable.is_planar;
        let part = |part: cdpr_workspace::Component| Part {
            size: Size { name: "", is_planar, value: part.size },
            position_m: grid.point(part.first.0, part.first.1)[..region.dimension()].to_vec(),
        };
        let with_error = |&most: &f64| WithError {
            position_error_max_m: most,
            reached: answer.reached(Some(grid::outcome(grid, &census.reached(Some(most))).size)),
        };
        let map = reachable.map_effect(region, &points, size);
        Self {
            error_bound: Some(audit.map_or(reached.error_bound, Audit::error_bound)),
            confidence: audit.map(|_| CONFIDENCE),
            parts: Some(components(grid, answers).into_iter().map(part).collect()),
            by_accuracy: thresholds.iter().map(with_error).collect(),
            ..answer.cut_by([reaches(&physical), reaches(&model), reached.reaches_bounds])
        }
        .with_map(map, &format!("{} poses reached", cells.len()))
    }

    /// Answer by the rays of a hull: the reachable one, the wrench-feasible ones of machine and control model, where the platform comes to rest, and the effect of
    /// a map.
    pub fn of_hull(
        searched: Searched<'_>,
        found: &Hull,
        [physical, model]: [Option<&Hull>; 2],
        image: Option<Image>,
        map: Option<MapEffect<Option<f64>>>,
    ) -> Self {
        let measure = found.measure();
        let size = |hull: &Hull| hull.measure().map(|measure| measure.size);
        let reaches = |hull: &Hull| hull.rays_at_bounds > 0;
        let plane = |points: Vec<Point>| points.into_iter().map(|[x, y, _]| [x, y]).collect();
        let reached = size(found).filter(|_| found.is_star_shaped());
        let emerging = image.as_ref().map(|image| image.size);
        let sizes = [reached, emerging, physical.and_then(size), model.and_then(size)];
        let answer = Self::new(searched, "hull", [found.points, found.feasible_points], sizes);
        let is_planar = answer.reachable.is_planar;
        let answer = Self {
            error_bound: measure.map(|measure| measure.error_bound),
            outline_m: is_planar.then(|| plane(found.vertices())),
            emerging_outline_m: is_planar.then(|| plane(image.map_or_else(Vec::new, |image| image.vertices))),
            ..answer.cut_by([physical.is_some_and(reaches), model.is_some_and(reaches), reaches(found)])
        }
        .with_map(map, "the corners of the hull");
        match found.is_star_shaped() {
            true => answer,
            false => answer.negative(format!(
                "{} rays enter the reachable workspace again after they have left it: its hull would be wrong, use --method grid",
                found.rays_again
            )),
        }
    }

    /// Share of the physical workspace; `None` if that has no size.
    pub(super) fn share_of(&self, size: Option<f64>) -> Option<f64> {
        let whole = self.physical.value.filter(|whole| *whole > 0.0);
        size.zip(whole).map(|(size, whole)| size / whole)
    }

    fn reached(&self, value: Option<f64>) -> SizeAndShare {
        SizeAndShare { size: Size { value, ..self.reachable }, share: self.share_of(value) }
    }

    /// The same with the workspaces that the box cuts: those of machine and control model, and the reachable one.
    fn cut_by(self, reaches: [bool; 3]) -> Self {
        let all = ["physical", "model", "reachable"].into_iter().zip(reaches);
        Self {
            at_bounds: all.filter_map(|(name, reaches)| reaches.then_some(name)).collect(),
            reaches_bounds: reaches[2],
            ..self
        }
    }

    /// The same with the effect of a map on poses at these places.
    fn with_map(self, map: Option<MapEffect<Option<f64>>>, places: &str) -> Self {
        let Some(MapEffect { beyond, without }) = map else { return self };
        let remarks: Vec<String> = self.remark.iter().cloned().chain(beyond_map(beyond, places)).collect();
        let without = self.reached(without);
        Self {
            compensation: Some(MapAnswer { beyond, without }),
            remark: (!remarks.is_empty()).then(|| remarks.join("; ")),
            ..self
        }
    }

    /// The same with what is reached as one linear step tells, NaN where that has no size.
    #[must_use]
    pub fn with_linear(self, size: Option<f64>) -> Self {
        Self { linear: size.map(|size| Size { name: "linear", value: Some(size), ..self.reachable }), ..self }
    }

    /// The same with a change of one number.
    #[must_use]
    pub fn with_differential(self, differential: Option<Differential>) -> Self {
        Self { differential, ..self }
    }

    /// The same with the reason why nothing is reached, told of an answer without any pose.
    #[must_use]
    pub fn explained(self, why: impl FnOnce() -> String) -> Self {
        match self.feasible_points {
            0 => {
                let reason = format!("none of {} commanded poses is reached{}", self.points, why());
                self.negative(reason)
            }
            _ => self,
        }
    }

    fn negative(self, reason: String) -> Self {
        let status = if self.feasible_points == 0 { "empty" } else { "not-star-shaped" };
        Self { status, reason: Some(reason), ..self }
    }
}
