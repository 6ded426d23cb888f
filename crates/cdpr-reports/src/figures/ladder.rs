//! Candidates against the criterion, with bars of one standard error.

use cdpr_calibration::selection::SelectionCriterion;

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::figure::Figure;
use crate::report::within;

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
    /// Value of the best candidate.
    pub limit: f64,
    /// The same in words.
    pub limit_words: String,
    /// Label of the axis, with its unit.
    pub axis_label: String,
}

/// Name, value and error in a line.
fn words(criterion: SelectionCriterion, name: &str, value: Option<f64>, error: Option<f64>) -> String {
    let Some(value) = value.filter(|value| value.is_finite()) else { return String::new() };
    format!("{name}: {}", criterion.format_with_error(value, error.unwrap_or(f64::NAN)))
}

/// Places of names and plot.
struct Layout {
    /// Letters of a name in one line.
    letters: usize,
    /// Width of the plot.
    plot: f64,
    /// Names above their rungs, not left of them: for narrow windows.
    above: bool,
}

const WIDE: Layout = Layout { letters: 38, plot: 400.0, above: false };
const NARROW: Layout = Layout { letters: 50, plot: 320.0, above: true };

/// Width of a letter of a name.
const LETTER: f64 = 6.65;
/// Height of a line of a name.
const LINE: f64 = 13.0;
const TOP: f64 = 30.0;
/// Longer names are cut.
const MOST_LINES: usize = 4;

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
        let best = best.and_then(|best| Some((candidates[best].1?, candidates[best].2.unwrap_or(0.0))));
        let limit = best.map(|(value, _)| value);
        let words = best.map(|(value, error)| within(criterion, value, error)).unwrap_or_default();
        Self {
            rungs: candidates.iter().enumerate().map(rung).collect(),
            limit: shown(limit),
            limit_words: format!("best: {words}"),
            axis_label: format!("{criterion} on {data_words} in {}", criterion.unit()),
        }
    }

    /// The chart as SVG; `None` when no candidate has a value.
    pub fn svg(&self) -> Option<Figure> {
        self.drawn(&WIDE)
    }

    /// The same for narrow windows: each name above its rung.
    pub(crate) fn narrow_svg(&self) -> Option<Figure> {
        self.drawn(&NARROW)
    }

    fn drawn(&self, layout: &Layout) -> Option<Figure> {
        let axis = |pixels| {
            let values = self.rungs.iter().filter(|rung| rung.value.is_finite());
            let low = |rung: &Rung| (rung.value - rung.standard_error.max(0.0)).max(0.7 * rung.value);
            let (low, _) = finite_range(values.clone().map(low))?;
            let (_, high) = finite_range(values.flat_map(|rung| [rung.value, rung.value + rung.standard_error]))?;
            Some(if low > 0.0 { Axis::logarithmic(low, high, pixels, 7) } else { Axis::linear(0.0, high, pixels, 7) })
        };
        let names: Vec<Vec<String>> = self.rungs.iter().map(|rung| wrapped(&rung.name, layout.letters)).collect();
        let longest = names.iter().flatten().map(|line| line.chars().count()).max().unwrap_or(0);
        let left = if layout.above { 14.0 } else { 46.0 + LETTER * longest as f64 };
        let right = left + layout.plot;
        let axis = axis((left, right))?;
        let rows = rows(&names, layout);
        let bottom = rows.last().map_or(TOP, |row| row.bottom);
        let mut drawing =
            Drawing::new(right + 25.0, bottom + 46.0, "Candidates against the criterion on validation data");
        if let Some(chosen) = self.rungs.iter().position(|rung| rung.recommended) {
            let Row { top, bottom, .. } = rows[chosen];
            drawing.rectangle("chosen-row", (4.0, top + 1.0), (right - 4.0, bottom - top - 2.0), None);
        }
        let scale = if axis.is_logarithmic() { ", logarithmic" } else { "" };
        axis.draw_below(&mut drawing, TOP, bottom, &format!("{}{scale}", self.axis_label));
        if self.limit.is_finite() {
            let x = axis.place(self.limit);
            match layout.above {
                // not through the names
                true => rows.iter().for_each(|row| drawing.line("limit", (x, row.rung - 10.0), (x, row.bottom))),
                false => drawing.line("limit", (x, TOP - 4.0), (x, bottom)),
            }
            // the words stay inside the picture at either end
            let anchor = if x > 0.5 * (left + right) { Anchor::End } else { Anchor::Start };
            drawing.text("tick", anchor, (x, TOP - 10.0), &self.limit_words);
        }
        for (index, rung) in self.rungs.iter().enumerate() {
            draw_name(&mut drawing, layout, left, (index, &names[index], &rows[index]), rung.recommended);
            match rung.value.is_finite() {
                true => draw_rung(&mut drawing, &axis, rows[index].rung, rung),
                false => draw_nothing(&mut drawing, (left, right), rows[index].rung, axis.place(self.limit)),
            }
        }
        Some(drawing.finish())
    }
}

/// Heights of a candidate's row, and of its dot.
struct Row {
    top: f64,
    bottom: f64,
    rung: f64,
}

fn rows(names: &[Vec<String>], layout: &Layout) -> Vec<Row> {
    let mut top = TOP;
    let row = |lines: &Vec<String>| {
        let text = LINE * lines.len() as f64;
        let height = if layout.above { text + 22.0 } else { (text + 8.0).max(22.0) };
        let rung = if layout.above { top + text + 12.0 } else { top + 0.5 * height };
        let row = Row { top, bottom: top + height, rung };
        top += height;
        row
    };
    names.iter().map(row).collect()
}

fn draw_name(
    drawing: &mut Drawing,
    layout: &Layout,
    left: f64,
    (index, lines, row): (usize, &[String], &Row),
    recommended: bool,
) {
    let class = if recommended { "name chosen" } else { "name" };
    let first = if layout.above { row.top + 12.0 } else { row.rung + 4.0 - 0.5 * LINE * (lines.len() - 1) as f64 };
    for (line, text) in lines.iter().enumerate() {
        let y = first + LINE * line as f64;
        let text = if line == 0 { format!("{}  {text}", index + 1) } else { text.clone() };
        match layout.above {
            true => drawing.text(class, Anchor::Start, (left, y), &text),
            false => drawing.text(class, Anchor::End, (left - 12.0, y), &text),
        }
    }
}

/// Words on the side of the threshold that has room for them.
fn draw_nothing(drawing: &mut Drawing, (left, right): (f64, f64), y: f64, limit: f64) {
    const WORDS: &str = "no value: see the table";
    match limit - left > right - limit {
        true => drawing.text("tick", Anchor::Start, (left + 8.0, y + 4.0), WORDS),
        false => drawing.text("tick", Anchor::End, (right - 8.0, y + 4.0), WORDS),
    }
}

fn draw_rung(drawing: &mut Drawing, axis: &Axis, y: f64, rung: &Rung) {
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

/// A name in lines of at most so many letters, broken after its separators; what four lines cannot hold is cut.
fn wrapped(name: &str, letters: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for piece in name.split_inclusive([':', ',', '+']) {
        let last = lines.len() - 1;
        let length = lines[last].chars().count();
        match length > 0 && length + piece.chars().count() > letters {
            true => lines.push(piece.to_owned()),
            false => lines[last].push_str(piece),
        }
    }
    if lines.len() > MOST_LINES {
        lines.truncate(MOST_LINES);
        lines[MOST_LINES - 1].push('…');
    }
    lines.into_iter().map(|line| shortened(line, letters)).collect()
}

fn shortened(line: String, letters: usize) -> String {
    match line.chars().count() > letters {
        true => line.chars().take(letters - 1).chain(['…']).collect(),
        false => line,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_break_after_separators_and_lose_nothing() {
        let name = "elastic:frame-anchor,platform-anchor,length-offset,compliance,wrench";
        let lines = wrapped(name, 38);
        assert_eq!(lines, ["elastic:frame-anchor,platform-anchor,", "length-offset,compliance,wrench"]);
        assert_eq!(lines.concat(), name);
        let long = wrapped(&"a-long-parameter,".repeat(20), 20);
        assert!(long.len() == MOST_LINES && long[MOST_LINES - 1].ends_with('…'), "{long:?}");
    }

    #[test]
    fn the_scale_is_logarithmic_and_the_threshold_says_its_value() {
        let candidates = [("standard", Some(0.006), Some(0.0002)), ("elastic", Some(0.004), Some(0.0003))];
        let ladder = Ladder::of(SelectionCriterion::Position, "validation data", &candidates, [Some(1), Some(1)]);
        for figure in [ladder.svg().unwrap(), ladder.narrow_svg().unwrap()] {
            assert!(figure.body.contains("in mm, logarithmic"), "{}", figure.body);
            assert!(figure.body.contains("best: 4.00 mm"), "{}", figure.body);
        }
        assert_eq!(ladder.svg().unwrap().body.matches("class=\"limit\"").count(), 1);
    }
}
