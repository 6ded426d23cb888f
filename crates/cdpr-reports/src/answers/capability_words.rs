//! What a box allows, in words and as a page with maps.

use cdpr_model::robot::Robot;
use cdpr_workspace::Point;
use cdpr_workspace::capability::{Found, Limit, LimitedBy, Quantity, Solution};
use minijinja::{Value, context};

use super::capability_answer::{COLUMNS, is_of_tension, name_of};
use super::{AskedCapability, CapabilityAnswer, axis_names, components};
use crate::figures::{BoxCell, BoxMap};
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::number_format::{NONE, fixed, short, significant};

const TEMPLATE: &str = include_str!("capability.html");

/// Cells along the longer side of a map.
const CELLS: usize = 40;

/// Row of the table of a quantity.
pub(super) fn row_of(asked: &AskedCapability<'_>, found: &Found) -> Vec<String> {
    let robot = asked.model.robot();
    let (name, unit) = name_of(robot, found.quantity);
    let number = |value: f64| match value.is_finite() {
        true => format!("{} {unit}", significant(value, 4)),
        false => NONE.to_owned(),
    };
    let direction = found.limited_by.direction.map(|direction| {
        let parts: Vec<String> = components(robot, &direction).into_iter().map(|part| fixed(part, 2)).collect();
        format!(", towards ({})", parts.join(", "))
    });
    vec![
        name,
        number(found.value),
        number(found.at_least),
        format!("{} %", significant(1e2 * found.gap(), 2)),
        format!("({}) m", point_words(robot, &found.at)),
        limit_words(robot, &found.limited_by) + &direction.unwrap_or_default(),
    ]
}

pub(super) fn point_words(robot: &Robot, point: &Point) -> String {
    let parts: Vec<String> =
        point.iter().take(axis_names(robot).len()).map(|part| short((1e4 * part).round() / 1e4 + 0.0)).collect();
    parts.join(", ")
}

/// The limit and its cable.
pub(super) fn limit_words(robot: &Robot, limited_by: &LimitedBy) -> String {
    let cable = limited_by.cable.map(|cable| {
        let (number, name) = ((cable + 1).to_string(), &robot.cables[cable].name);
        let says_no_more = name.strip_prefix("cable").unwrap_or(name).trim() == number;
        if says_no_more { format!("cable {number}") } else { format!("cable {number} (“{name}”)") }
    });
    let of = cable.unwrap_or_else(|| "the cables".to_owned());
    let words = match limited_by.limit {
        Limit::TensionMax => format!("largest tension of {of}"),
        Limit::TensionMin => format!("least tension of {of}"),
        Limit::Gravity => "gravity alone acts this way: cables do not push".to_owned(),
        Limit::NoWrenchClosure => "no wrench closure: no cable pulls this way".to_owned(),
        Limit::CableSpeed => format!("speed of {of}"),
        Limit::DriveSpeed => format!("speed of the drive of {of}"),
        _ => format!("{of} has no path"),
    };
    let others = |cables: &[usize]| -> Vec<String> {
        cables.iter().filter(|other| Some(**other) != limited_by.cable).map(|other| (other + 1).to_string()).collect()
    };
    let (most, least) = (others(&limited_by.at_largest), others(&limited_by.at_least));
    if !is_of_tension(limited_by.limit) || most.len() + least.len() == 0 {
        return words;
    }
    let list =
        |cables: Vec<String>, end: &str| (!cables.is_empty()).then(|| format!("{} at the {end}", cables.join(", ")));
    let rest: Vec<String> = [list(most, "largest"), list(least, "least")].into_iter().flatten().collect();
    format!("{words} (with {})", rest.join(" and "))
}

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
        let values = context! {
            headline => prose(&headline),
            of => prose(&self.shown.heading),
            facts => vec![
                fact("Orientation", orientation_words(asked)),
                fact("Poses judged", solution.poses.to_string()),
            ],
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

/// What holds everywhere in the box.
fn promise(asked: &AskedCapability<'_>, solution: &Solution) -> String {
    let robot = asked.model.robot();
    let all = solution.found.iter().filter(|found| !matches!(found.quantity, Quantity::AxisAcceleration(_)));
    let part = |found: &Found| {
        let (name, unit) = name_of(robot, found.quantity);
        match found.at_least.is_finite() {
            true => format!("{name}: at least {} {unit}", significant(found.at_least, 3)),
            false => format!("{name}: not proved everywhere"),
        }
    };
    let parts: Vec<String> = all.map(part).collect();
    if parts.is_empty() { "The robot file tells none of the quantities".to_owned() } else { capital(&parts.join("; ")) }
}

fn orientation_words(asked: &AskedCapability<'_>) -> String {
    let robot = asked.model.robot();
    let pose = asked.capability.pose(&asked.bounds.middle());
    let all = robot.motion_pattern.pose_to_components(robot.plane, &pose);
    let angles = &all[asked.model.axes().len()..];
    let parts: Vec<String> = angles.iter().map(|angle| format!("{:.4} rad", angle + 0.0)).collect();
    match parts.len() {
        0 => "a point".to_owned(),
        1 => parts[0].clone(),
        _ => format!("rx, ry, rz = {}", parts.join(", ")),
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

fn capital(name: &str) -> String {
    let mut letters = name.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
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
