//! Candidates against the criterion, with bars of one standard error.

use cdpr::identification::selection::SelectionCriterion;

use super::axis::Axis;
use super::drawing::{Anchor, Drawing};
use super::figure::Figure;
use super::finite_range;
use crate::number_format::significant;

/// One candidate.
pub struct Rung {
    /// Its name.
    pub name: String,
    /// Criterion on validation data in the axis' unit; NaN without one.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// Value and error in words.
    pub words: String,
    /// True for the recommended one.
    pub recommended: bool,
}

/// The chart.
pub struct Ladder {
    /// The candidates from simple to complex.
    pub rungs: Vec<Rung>,
    /// Best value plus one standard error.
    pub limit: f64,
    /// Label of the axis, with its unit.
    pub axis_label: String,
}

/// Name, value and error in a line.
fn words(criterion: SelectionCriterion, name: &str, value: Option<f64>, error: Option<f64>) -> String {
    let Some(value) = value.filter(|value| value.is_finite()) else { return String::new() };
    let error = error.filter(|error| error.is_finite());
    let error = error.map_or_else(String::new, |error| format!(" ± {}", significant(criterion.in_unit(error), 2)));
    format!("{name}: {}{error} {}", significant(criterion.in_unit(value), 4), criterion.unit())
}

/// Width of the plot.
const PLOT: f64 = 400.0;
/// Width of a letter of a name.
const LETTER: f64 = 6.65;
const TOP: f64 = 30.0;
const ROW: f64 = 28.0;
/// Longer names are cut.
const NAME_LENGTH: usize = 90;

impl Ladder {
    /// Chart of a criterion: name, value and standard error (SI) of every candidate, and the places of the best and of the recommended one.
    pub fn of(
        criterion: SelectionCriterion,
        data_words: &str,
        candidates: &[(&str, Option<f64>, Option<f64>)],
        [best, recommended]: [Option<usize>; 2],
    ) -> Self {
        let shown = |value: Option<f64>| criterion.in_unit(value.unwrap_or(f64::NAN));
        let rung = |(place, &(name, value, error)): (usize, &(&str, Option<f64>, Option<f64>))| Rung {
            name: name.to_owned(),
            value: shown(value),
            standard_error: shown(error),
            words: words(criterion, name, value, error),
            recommended: recommended == Some(place),
        };
        let limit = best.and_then(|best| Some(candidates[best].1? + candidates[best].2.unwrap_or(0.0)));
        Self {
            rungs: candidates.iter().enumerate().map(rung).collect(),
            limit: shown(limit),
            axis_label: format!("{criterion} on {data_words} in {}", criterion.unit()),
        }
    }

    /// The chart as SVG; `None` when no candidate has a value.
    pub fn svg(&self) -> Option<Figure> {
        let values = self.rungs.iter().filter(|rung| rung.value.is_finite());
        let (low, _) = finite_range(values.clone().map(|rung| rung.value))?;
        let (_, high) = finite_range(values.flat_map(|rung| [rung.value, rung.value + rung.standard_error]))?;
        let bottom = TOP + ROW * self.rungs.len() as f64;
        let longest = self.rungs.iter().map(|rung| rung.name.chars().count().min(NAME_LENGTH)).max().unwrap_or(0);
        let left = 46.0 + LETTER * longest as f64;
        let right = left + PLOT;
        let mut drawing =
            Drawing::new(right + 25.0, bottom + 46.0, "Candidates against the criterion on validation data");
        let axis = Axis::fitting(low, high, (left, right), 7);
        if let Some(chosen) = self.rungs.iter().position(|rung| rung.recommended) {
            let y = TOP + ROW * chosen as f64;
            drawing.rectangle("chosen-row", (4.0, y + 1.0), (right - 4.0, ROW - 2.0), None);
        }
        let scale = if axis.is_logarithmic() { ", logarithmic" } else { "" };
        axis.draw_below(&mut drawing, TOP, bottom, &format!("{}{scale}", self.axis_label));
        if self.limit.is_finite() {
            let x = axis.place(self.limit);
            drawing.line("limit", (x, TOP - 4.0), (x, bottom));
            // the words stay inside the picture at either end
            let anchor = if x > 0.5 * (left + right) { Anchor::End } else { Anchor::Start };
            drawing.text("tick", anchor, (x, TOP - 10.0), "best + one standard error");
        }
        for (index, rung) in self.rungs.iter().enumerate() {
            draw_rung(&mut drawing, &axis, left, (index, rung));
        }
        Some(drawing.finish())
    }
}

fn draw_rung(drawing: &mut Drawing, axis: &Axis, left: f64, (index, rung): (usize, &Rung)) {
    let y = TOP + ROW * (index as f64 + 0.5);
    let name = shortened(&format!("{}  {}", index + 1, rung.name));
    let class = if rung.recommended { "name chosen" } else { "name" };
    drawing.text(class, Anchor::End, (left - 12.0, y + 4.0), &name);
    if !rung.value.is_finite() {
        drawing.text("tick", Anchor::Start, (left + 8.0, y + 4.0), "no value: see the table");
        return;
    }
    let class = if rung.recommended { "chosen" } else { "plain" };
    if rung.standard_error.is_finite() {
        let (from, to) = (axis.place(rung.value - rung.standard_error), axis.place(rung.value + rung.standard_error));
        drawing.line(&format!("bar {class}"), (from, y), (to, y));
        for x in [from, to] {
            drawing.line(&format!("bar {class}"), (x, y - 5.0), (x, y + 5.0));
        }
    }
    let radius = if rung.recommended { 6.5 } else { 4.5 };
    drawing.circle(&format!("dot {class}"), (axis.place(rung.value), y), radius, &rung.words);
}

fn shortened(name: &str) -> String {
    match name.chars().count() > NAME_LENGTH {
        true => name.chars().take(NAME_LENGTH - 1).chain(['…']).collect(),
        false => name.to_owned(),
    }
}
