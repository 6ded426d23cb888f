//! The answer of what is reached.

use cdpr_model::control::MapEffect;
use cdpr_study::Experiment;
use cdpr_study::reachable::{Census, Image, Reachable, emerging_size};
use cdpr_workspace::grid::{self, Grid};
use cdpr_workspace::hull::Hull;
use cdpr_workspace::{Bounds, Point, Region, components};
use serde::Serialize;
use serde_json::{Map, Value, json};

use super::Differential;
use crate::answers::{BEYOND_THE_WHOLE, beyond_map, control_title, is_beyond_the_whole, size_key, title};

/// Findings of a method; sizes in m² or m³.
pub struct Found {
    /// Method that found them.
    pub method: &'static str,
    /// Reachable, by commanded poses.
    pub reached: Option<f64>,
    /// Bound of the error of the reachable one.
    pub error_bound: Option<f64>,
    /// The machine is wrench-feasible.
    pub physical: Option<f64>,
    /// The control model is wrench-feasible.
    pub model: Option<f64>,
    /// Reachable, by emerging poses.
    pub emerging: Option<f64>,
    /// Reachable as one linear step tells, NaN where that has no size; `None` if nobody asked.
    pub linear: Option<f64>,
    /// Poses judged.
    pub points: u64,
    /// Poses of these that are reached.
    pub feasible_points: u64,
    /// Workspaces that the box cuts.
    pub at_bounds: AtBounds,
    /// Parts that do not touch, with a point of each (m).
    pub parts: Option<Vec<(f64, Point)>>,
    /// Largest error (m) and what is reached with it.
    pub by_accuracy: Vec<(f64, f64)>,
    /// Corners of the hull of a planar robot in order (m): where poses are commanded, where the platform comes to rest.
    pub outlines: Option<[Vec<Point>; 2]>,
    /// A change of one number.
    pub differential: Option<Differential>,
    /// Effect of the map that corrects the control model; the size without it is nothing where the hull has none.
    pub compensation: Option<MapEffect<Option<f64>>>,
    /// Reason why the answer is negative.
    pub reason: Option<String>,
}

impl Found {
    /// Findings in the cells of a grid: those that are reached, also with each of these largest errors (m), and the wrench-feasible ones of machine and control model.
    pub fn of_grid(
        reachable: &Reachable,
        region: &Region<'_>,
        grid: &Grid,
        census: &Census,
        answers: &[bool],
        [physical, model]: [Option<grid::Outcome>; 2],
        thresholds: &[f64],
    ) -> Self {
        let reached = grid::outcome(grid, answers);
        let cells = answers.iter().enumerate().filter(|(_, holds)| **holds);
        let cells: Vec<_> = cells.map(|(cell, _)| (cell / grid.slab_points(), cell % grid.slab_points())).collect();
        let with_error = |&most: &f64| (most, grid::outcome(grid, &census.reached(Some(most))).size);
        let reaches = |outcome: &Option<grid::Outcome>| outcome.as_ref().is_some_and(|outcome| outcome.reaches_bounds);
        let parts = components(grid, answers).into_iter();
        let points: Vec<Point> = cells.iter().map(|&(slab, index)| grid.point(slab, index)).collect();
        let size = |region: &Region<'_>| Some(grid::count(region, grid).outcome(grid).size);
        Self {
            method: "grid",
            reached: Some(reached.size),
            error_bound: Some(reached.error_bound),
            at_bounds: AtBounds {
                physical: reaches(&physical),
                model: reaches(&model),
                reachable: reached.reaches_bounds,
            },
            physical: physical.map(|outcome| outcome.size),
            model: model.map(|outcome| outcome.size),
            emerging: Some(emerging_size(reachable, region, grid, &cells)),
            linear: None,
            points: grid.points(),
            feasible_points: cells.len() as u64,
            parts: Some(parts.map(|part| (part.size, grid.point(part.first.0, part.first.1))).collect()),
            by_accuracy: thresholds.iter().map(with_error).collect(),
            outlines: None,
            differential: None,
            compensation: reachable.map_effect(region, &points, size),
            reason: None,
        }
    }

    /// Findings of the rays of a hull: the reachable one, the wrench-feasible ones of machine and control model, and where the platform comes to rest.
    pub fn of_hull(found: &Hull, [physical, model]: [Option<&Hull>; 2], image: Option<Image>) -> Self {
        let (measure, is_whole) = (found.measure(), found.is_star_shaped());
        let size = |hull: &Hull| hull.measure().map(|measure| measure.size);
        let reaches = |hull: &Hull| hull.rays_at_bounds > 0;
        Self {
            method: "hull",
            reached: measure.filter(|_| is_whole).map(|measure| measure.size),
            error_bound: measure.map(|measure| measure.error_bound),
            physical: physical.and_then(size),
            model: model.and_then(size),
            emerging: image.as_ref().map(|image| image.size),
            linear: None,
            points: found.points,
            feasible_points: found.feasible_points,
            at_bounds: AtBounds {
                physical: physical.is_some_and(reaches),
                model: model.is_some_and(reaches),
                reachable: reaches(found),
            },
            parts: None,
            by_accuracy: Vec::new(),
            outlines: (found.dimension() == 2)
                .then(|| [found.vertices(), image.map_or_else(Vec::new, |image| image.vertices)]),
            differential: None,
            compensation: None,
            reason: (!is_whole).then(|| {
                let rays = found.rays_again;
                format!("{rays} rays enter the reachable workspace again after they have left it: its hull would be wrong, use --method grid")
            }),
        }
    }
}

/// Workspaces that reach the faces of the box, so that more of them may lie outside.
#[derive(Clone, Copy)]
pub struct AtBounds {
    /// The machine is wrench-feasible.
    pub physical: bool,
    /// The control model is wrench-feasible.
    pub model: bool,
    /// The reachable one.
    pub reachable: bool,
}

impl AtBounds {
    /// Names of these workspaces.
    pub fn names(self) -> Vec<&'static str> {
        let all = [("physical", self.physical), ("model", self.model), ("reachable", self.reachable)];
        all.into_iter().filter(|(_, reaches)| *reaches).map(|(name, _)| name).collect()
    }
}

/// Sizes of the workspaces of a study; keys and units as in JSON.
#[derive(Serialize)]
pub struct ReachableAnswer {
    /// Outcome in a word.
    pub status: &'static str,
    /// Reason why the answer is negative.
    pub reason: Option<String>,
    /// Control model.
    pub control: String,
    /// Machine.
    pub machine: String,
    /// Method that found them.
    pub method: &'static str,
    /// Box that was searched.
    pub bounds_m: Vec<f64>,
    /// Largest position error that counts as reached.
    pub position_error_max_m: Option<f64>,
    /// Largest difference of a tension from the commanded one that counts as reached.
    #[serde(rename = "tension_error_max_N", skip_serializing_if = "Option::is_none")]
    pub tension_error_max: Option<f64>,
    /// Sizes by their keys.
    #[serde(flatten)]
    pub sizes: Map<String, Value>,
    /// Reachable share of the physical workspace.
    pub share: Option<f64>,
    /// Effect of the map that corrects the control model.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub compensation: Option<Value>,
    /// Remark on a share above 100 %, or on poses beyond the samples of a map.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub remark: Option<String>,
    /// Bound of the error of the reachable one.
    pub error_bound: Option<f64>,
    /// Poses judged.
    pub points: u64,
    /// Poses of these that are reached.
    pub feasible_points: u64,
    /// True where the box cuts the reachable workspace.
    pub reaches_bounds: bool,
    /// Workspaces that reach the faces of the box.
    pub at_bounds: Vec<&'static str>,
    /// Parts that do not touch.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub parts: Option<Vec<Value>>,
    /// Sizes by the largest position error.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub by_accuracy: Vec<Value>,
    /// Corners of the hull of commanded poses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outline_m: Option<Vec<[f64; 2]>>,
    /// Corners of the hull of emerging poses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub emerging_outline_m: Option<Vec<[f64; 2]>>,
    /// A change of one number.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub differential: Option<Value>,
    /// Winch offsets.
    pub winch_offsets_m: Vec<f64>,
    /// The findings themselves.
    #[serde(skip)]
    pub found: Found,
    /// Unit of the sizes.
    #[serde(skip)]
    pub unit: &'static str,
}

impl ReachableAnswer {
    /// The answer with its status.
    pub fn new(experiment: &Experiment, region: &Region<'_>, bounds: &Bounds, found: Found) -> Self {
        let is_planar = region.dimension() == 2;
        let key = |name: &str| size_key(name, is_planar);
        let share = |size: f64| found.physical.filter(|whole| *whole > 0.0).map(|whole| size / whole);
        let named = [
            ("reachable", found.reached),
            ("physical", found.physical),
            ("model", found.model),
            ("emerging", found.emerging),
        ];
        let linear = found.linear.map(|size| ("linear", Some(size)));
        let sizes = named.iter().chain(&linear).map(|(name, size)| (key(name), json!(size))).collect();
        let dimension = region.dimension();
        let part = |(size, point): &(f64, Point)| json!({ key("part").replace("part_", ""): size, "position_m": &point[..dimension] });
        let at = |(most, size): &(f64, f64)| json!({ "position_error_max_m": most, key("reachable"): size, "share": share(*size) });
        let outline = |which: usize| -> Option<Vec<[f64; 2]>> {
            Some(found.outlines.as_ref()?[which].iter().map(|&[x, y, _]| [x, y]).collect())
        };
        let too_large = is_beyond_the_whole(found.reached.and_then(share)).then(|| BEYOND_THE_WHOLE.to_owned());
        let places = match found.method {
            "grid" => format!("{} poses reached", found.feasible_points),
            _ => "the corners of the hull".to_owned(),
        };
        let beyond = found.compensation.as_ref().map(|map| map.beyond).unwrap_or_default();
        let beyond = beyond_map(beyond, &places);
        let remarks: Vec<String> = too_large.into_iter().chain(beyond).collect();
        Self {
            status: if found.reason.is_none() {
                "found"
            } else if found.feasible_points == 0 {
                "empty"
            } else {
                "not-star-shaped"
            },
            reason: found.reason.clone(),
            control: control_title(experiment),
            machine: title(&experiment.machine),
            method: found.method,
            bounds_m: bounds.ends(),
            position_error_max_m: experiment.study.limits.as_ref().and_then(|limits| limits.position_error_max_m),
            tension_error_max: experiment.study.limits.as_ref().and_then(|limits| limits.tension_error_max_N),
            sizes,
            share: found.reached.and_then(share),
            compensation: found.compensation.as_ref().map(|map| {
                json!({ "outside": map.beyond.outside, "fading": map.beyond.fading, "without": { key("reachable"): map.without, "share": map.without.and_then(share) } })
            }),
            remark: (!remarks.is_empty()).then(|| remarks.join("; ")),
            error_bound: found.error_bound,
            points: found.points,
            feasible_points: found.feasible_points,
            reaches_bounds: found.at_bounds.reachable,
            at_bounds: found.at_bounds.names(),
            parts: found.parts.as_ref().map(|parts| parts.iter().map(part).collect()),
            by_accuracy: found.by_accuracy.iter().map(at).collect(),
            outline_m: outline(0),
            emerging_outline_m: outline(1),
            differential: found.differential.as_ref().map(|found| found.json(key)),
            winch_offsets_m: experiment.offsets.clone(),
            unit: if is_planar { "m²" } else { "m³" },
            found,
        }
    }
}
