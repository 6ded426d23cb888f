//! What `cdpr reachable` answers.

use cdpr::metamodel::Experiment;
use cdpr::workspace::{Bounds, Point, Region};
use serde::Serialize;
use serde_json::{Map, Value, json};

use super::Differential;
use crate::answer::Answer;
use crate::study_file::{BEYOND_THE_WHOLE, is_beyond_the_whole, title};
use crate::table::{Table, cell};
use cdpr_reports::number_format::significant;

/// What a method found; sizes in m² or m³.
pub(super) struct Found {
    pub(super) method: &'static str,
    pub(super) reached: Option<f64>,
    pub(super) error_bound: Option<f64>,
    pub(super) physical: Option<f64>,
    pub(super) model: Option<f64>,
    pub(super) emerging: Option<f64>,
    pub(super) points: u64,
    pub(super) feasible_points: u64,
    pub(super) at_bounds: AtBounds,
    /// Parts that do not touch, with a point of each (m).
    pub(super) parts: Option<Vec<(f64, Point)>>,
    /// Largest error (m) and what is reached with it.
    pub(super) by_accuracy: Vec<(f64, f64)>,
    /// Corners of the hull of a planar robot in order (m): where poses are commanded, where the platform comes to rest.
    pub(super) outlines: Option<[Vec<Point>; 2]>,
    pub(super) differential: Option<Differential>,
    pub(super) reason: Option<String>,
}

/// Which workspaces reach the faces of the box, so that more of them may lie outside.
#[derive(Clone, Copy)]
pub(super) struct AtBounds {
    pub(super) physical: bool,
    pub(super) model: bool,
    pub(super) reachable: bool,
}

impl AtBounds {
    fn names(self) -> Vec<&'static str> {
        let all = [("physical", self.physical), ("model", self.model), ("reachable", self.reachable)];
        all.into_iter().filter(|(_, reaches)| *reaches).map(|(name, _)| name).collect()
    }

    /// What to think of the sizes, if any is cut.
    fn words(self) -> Option<String> {
        let (list, ends) = match self.names().as_slice() {
            [] => return None,
            [one] => (format!("the {one} workspace"), "reaches"),
            [rest @ .., last] => (format!("the {} and the {last} workspace", rest.join(", the ")), "reach"),
        };
        let them = if ends == "reaches" { "it" } else { "them" };
        let share = match self.physical && !self.reachable {
            true => "; the shares are those of the part inside",
            false => "",
        };
        Some(format!(
            "{list} {ends} the faces of the box, so that more of {them} may lie outside{share}: see --bounds\n"
        ))
    }
}

#[derive(Serialize)]
pub(super) struct ReachableAnswer {
    status: &'static str,
    reason: Option<String>,
    control: String,
    machine: String,
    method: &'static str,
    bounds_m: Vec<f64>,
    position_error_max_m: Option<f64>,
    #[serde(flatten)]
    sizes: Map<String, Value>,
    share: Option<f64>,
    /// Remark on a share above 100 %.
    #[serde(skip_serializing_if = "Option::is_none")]
    remark: Option<&'static str>,
    error_bound: Option<f64>,
    points: u64,
    feasible_points: u64,
    reaches_bounds: bool,
    /// Workspaces that reach the faces of the box.
    at_bounds: Vec<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    parts: Option<Vec<Value>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    by_accuracy: Vec<Value>,
    #[serde(skip_serializing_if = "Option::is_none")]
    outline_m: Option<Vec<[f64; 2]>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    emerging_outline_m: Option<Vec<[f64; 2]>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    differential: Option<Value>,
    winch_offsets_m: Vec<f64>,
    #[serde(skip)]
    found: Found,
    #[serde(skip)]
    unit: &'static str,
}

impl ReachableAnswer {
    pub(super) fn new(experiment: &Experiment, region: &Region<'_>, bounds: &Bounds, found: Found) -> Self {
        let is_planar = region.dimension() == 2;
        let key = |name: &str| format!("{name}_{}", if is_planar { "area_m2" } else { "volume_m3" });
        let share = |size: f64| found.physical.filter(|whole| *whole > 0.0).map(|whole| size / whole);
        let named = [
            ("reachable", found.reached),
            ("physical", found.physical),
            ("model", found.model),
            ("emerging", found.emerging),
        ];
        let sizes = named.iter().map(|(name, size)| (key(name), json!(size))).collect();
        let dimension = region.dimension();
        let part = |(size, point): &(f64, Point)| json!({ key("part").replace("part_", ""): size, "position_m": &point[..dimension] });
        let at = |(most, size): &(f64, f64)| json!({ "position_error_max_m": most, key("reachable"): size, "share": share(*size) });
        let outline = |which: usize| -> Option<Vec<[f64; 2]>> {
            Some(found.outlines.as_ref()?[which].iter().map(|&[x, y, _]| [x, y]).collect())
        };
        Self {
            status: if found.reason.is_none() {
                "found"
            } else if found.feasible_points == 0 {
                "empty"
            } else {
                "not-star-shaped"
            },
            reason: found.reason.clone(),
            control: title(&experiment.control),
            machine: title(&experiment.machine),
            method: found.method,
            bounds_m: bounds.ends(),
            position_error_max_m: experiment.study.limits.as_ref().and_then(|limits| limits.position_error_max_m),
            sizes,
            share: found.reached.and_then(share),
            remark: is_beyond_the_whole(found.reached.and_then(share)).then_some(BEYOND_THE_WHOLE),
            error_bound: found.error_bound,
            points: found.points,
            feasible_points: found.feasible_points,
            reaches_bounds: found.at_bounds.reachable,
            at_bounds: found.at_bounds.names(),
            parts: found.parts.as_ref().map(|parts| parts.iter().map(part).collect()),
            by_accuracy: found.by_accuracy.iter().map(at).collect(),
            outline_m: outline(0),
            emerging_outline_m: outline(1),
            differential: found.differential.as_ref().map(|found| json!(found)),
            winch_offsets_m: experiment.offsets.clone(),
            unit: if is_planar { "m²" } else { "m³" },
            found,
        }
    }
}

impl Answer for ReachableAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self) -> String {
        let Self { control, machine, found, unit, .. } = self;
        let mut text = format!("{control} drives {machine}\n");
        if let Some(reason) = &self.reason {
            text.push_str(&format!("{reason}\n"));
        }
        let mut table = Table::new(["workspace", unit, "of the physical one"]);
        let percent = |size: Option<f64>| {
            let share = size.zip(found.physical.filter(|whole| *whole > 0.0)).map(|(size, whole)| 100.0 * size / whole);
            share.map_or_else(String::new, |share| format!("{share:.1} %"))
        };
        let mut row = |name: String, size: Option<f64>| {
            table.row(vec![name, cell(size, 3), percent(size)]);
        };
        row("physical: the machine is wrench-feasible".to_owned(), found.physical);
        row("model: the control model is".to_owned(), found.model);
        row("reachable, by commanded poses".to_owned(), found.reached);
        row("reachable, by emerging poses".to_owned(), found.emerging);
        for (most, size) in &found.by_accuracy {
            row(format!("reachable to {} mm", significant(1e3 * most, 3)), Some(*size));
        }
        text.push_str(&format!("\n{}", table.text()));
        if let Some(remark) = self.remark {
            text.push_str(&format!("\n{remark}\n"));
        }
        if let Some(bound) = self.error_bound {
            text.push_str(&format!(
                "\nthe reachable one is known to ± {bound:.3} {unit} ({} points, {})\n",
                self.points, self.method
            ));
        }
        if let Some(Differential {
            parameter, unit: of, change, size_rate, first_order_size, recomputed_size, ..
        }) = &found.differential
        {
            let anew = recomputed_size.map_or_else(|| "has no hull".to_owned(), |size| format!("is {size:.3} {unit}"));
            let of = if *of == "1" { String::new() } else { format!(" {of}") };
            text.push_str(&format!(
                "\nwith {parameter} changed by {change}{of} it is {first_order_size:.3} {unit} to first order ({size_rate:.3} {unit} per{}), found \
                 anew it {anew}\n",
                if of.is_empty() { " 1".to_owned() } else { of.clone() }
            ));
        }
        if let Some(parts) = found.parts.as_ref().filter(|parts| parts.len() > 1) {
            let small: f64 = parts[1..].iter().map(|part| part.0).sum();
            text.push_str(&format!(
                "it has {} parts that do not touch; the largest has {:.3} {unit}, the others together {small:.3} {unit}\n",
                parts.len(),
                parts[0].0
            ));
        }
        text.push_str(&found.at_bounds.words().unwrap_or_default());
        text
    }
}
