//! The page of what a box allows, with a map of each quantity.

use cdpr_model::robot::Robot;
use cdpr_workspace::Point;
use cdpr_workspace::capability::{Found, Quantity, Solution};
use minijinja::{Value, context};

use super::capability_answer::CapabilityAnswer;
use super::capability_words::{AskedCapability, COLUMNS, limit_words, name_of, point_words, rounded_down};
use super::pose_answer::axis_names;
use crate::figures::{BoxCell, BoxMap};
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::number_format::{short, significant};

const TEMPLATE: &str = include_str!("capability.html");

/// Cells along the longer side of a map.
const CELLS: usize = 40;

impl CapabilityAnswer {
    /// The page with a map of each quantity; `command` makes it again.
    pub fn page(
        &self,
        asked: &AskedCapability<'_>,
        solution: &Solution,
        command: &str,
        version: &str,
    ) -> Result<String, PageError> {
        let row = |cells: &Vec<String>| context! { cells => cells.iter().map(|cell| prose(cell)).collect::<Vec<_>>() };
        let fact = |term: &str, text: String| context! { term => term, text => prose(&text) };
        let headline = self.reason().map_or_else(|| promise(asked, solution), capital);
        let orientation = orientation_words(asked).map(|words| ("Orientation", words));
        let facts = orientation.into_iter().chain([("Poses judged", solution.poses.to_string())]);
        let values = context! {
            headline => prose(&headline),
            of => prose(&self.shown.heading),
            facts => facts.map(|(term, text)| fact(term, text)).collect::<Vec<_>>(),
            columns => COLUMNS,
            rows => self.shown.rows.iter().map(row).collect::<Vec<Value>>(),
            words => self.shown.words.iter().map(|word| prose(word)).collect::<Vec<_>>(),
            figures => maps(asked, solution),
            warnings => self.warnings().iter().map(|words| prose(words)).collect::<Vec<_>>(),
            command => plain(command),
        };
        let title = "Payload, acceleration and speed in a box";
        Page { kind: PageKind::Capability, title, class: "wide", template: TEMPLATE, values, data: None, version }
            .render()
    }
}

/// Promise that holds everywhere in the box.
fn promise(asked: &AskedCapability<'_>, solution: &Solution) -> String {
    let robot = asked.model.robot();
    let all = solution.found.iter().filter(|found| !matches!(found.quantity, Quantity::AxisAcceleration(_)));
    let part = |found: &Found| {
        let (name, unit) = name_of(robot, found.quantity);
        match found.at_least.is_finite() {
            true => format!("{name}: at least {} {unit}", significant(rounded_down(found.at_least, 3), 3)),
            false => format!("{name}: not proved everywhere"),
        }
    };
    let parts: Vec<String> = all.map(part).collect();
    if parts.is_empty() { "The robot file tells none of the quantities".to_owned() } else { capital(&parts.join("; ")) }
}

/// The orientation; `None` for a point.
fn orientation_words(asked: &AskedCapability<'_>) -> Option<String> {
    let robot = asked.model.robot();
    let pose = asked.capability.pose(&asked.bounds.middle());
    let all = robot.motion_pattern.pose_to_components(robot.plane, &pose);
    let angles = &all[asked.model.axes().len()..];
    let parts: Vec<String> = angles.iter().map(|angle| format!("{:.4} rad", angle + 0.0)).collect();
    match parts.len() {
        0 => None,
        1 => Some(format!("angle {}", parts[0])),
        _ => Some(format!("rx, ry, rz = {}", parts.join(", "))),
    }
}

/// A map of each quantity that differs over the box, at the level of its least value.
fn maps(asked: &AskedCapability<'_>, solution: &Solution) -> Vec<Value> {
    let robot = asked.model.robot();
    let quantities = asked.capability.quantities();
    let marked: Vec<(usize, Point, String)> = match &solution.not_held {
        Some(not_held) => vec![(0, not_held.at, "the own load is not held here".to_owned())],
        None => solution
            .found
            .iter()
            .enumerate()
            .map(|(index, found)| (index, found.at, least_words(robot, found)))
            .collect(),
    };
    let one = |(index, at, words): (usize, Point, String)| {
        let (name, unit) = name_of(robot, *quantities.get(index)?);
        let cells = section(asked, index, &at);
        let is_flat = |cells: &[BoxCell]| {
            let values = cells.iter().map(|cell| cell.value).filter(|value| value.is_finite());
            let (low, high) =
                values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
            solution.not_held.is_none() && high - low <= 1e-9 * high.abs()
        };
        if is_flat(&cells) {
            return None;
        }
        let axes = axis_names(robot);
        let level = axes.get(2).map(|axis| format!(" at {axis} = {} m", short((1e4 * at[2]).round() / 1e4)));
        let map = BoxMap {
            title: vec![format!("{}{}", capital(&name), level.unwrap_or_default())],
            sides: [0, 1].map(|axis| asked.bounds.extent(axis) / count(asked, axis) as f64),
            cells,
            axes: [axes[0].clone(), axes[1].clone()],
            label: format!("{name} in {unit}"),
            marked: ([at[0], at[1]], words),
        };
        let figure = Value::from_safe_string(map.svg()?.inline());
        let limit = solution.found.get(index).map(|found| limit_words(robot, &found.limited_by));
        let caption = match limit {
            Some(limit) => format!("Values at the middles of cells; at the mark: {limit}."),
            None => "Values at the middles of cells; where nothing is drawn the own load is not held.".to_owned(),
        };
        Some(context! { figure, caption => prose(&caption) })
    };
    marked.into_iter().filter_map(one).collect()
}

fn least_words(robot: &Robot, found: &Found) -> String {
    let unit = name_of(robot, found.quantity).1;
    format!("least value {} {unit} at ({}) m", significant(found.value, 4), point_words(robot, &found.at))
}

/// Cells along an axis of a map.
fn count(asked: &AskedCapability<'_>, axis: usize) -> usize {
    let longer = asked.bounds.extent(0).max(asked.bounds.extent(1));
    ((CELLS as f64 * asked.bounds.extent(axis) / longer).round() as usize).max(4)
}

/// Values in the middle of the cells of a section of the box.
fn section(asked: &AskedCapability<'_>, index: usize, at: &Point) -> Vec<BoxCell> {
    let [wide, tall] = [0, 1].map(|axis| count(asked, axis));
    let along = |axis: usize, step: usize, count: usize| {
        asked.bounds.least()[axis] + asked.bounds.extent(axis) * (step as f64 + 0.5) / count as f64
    };
    let cell = |place: usize| {
        let middle = [along(0, place % wide, wide), along(1, place / wide, tall)];
        let values = asked.capability.values(&[middle[0], middle[1], at[2]]);
        BoxCell { at: middle, value: values.map_or(f64::NAN, |values| values[index]) }
    };
    (0..wide * tall).map(cell).collect()
}

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}
