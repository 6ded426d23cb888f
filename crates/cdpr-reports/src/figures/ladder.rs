//! Candidates against the error by which they are compared, with the differences to the best that decide.

use cdpr_calibration::selection::{ComparedError, SelectionCriterion};

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::figure::Figure;
use crate::table::wrapped;

/// One candidate.
pub struct Rung {
    /// Its name.
    pub name: String,
    /// Error on validation data in the axis' unit; NaN without one.
    pub value: f64,
    /// Standard error of the difference to the best; NaN where it is not known.
    pub standard_error: f64,
    /// Largest difference that is none.
    pub as_good_within: f64,
    /// True for a candidate that is as good as the best.
    pub is_as_good: bool,
    /// Error and difference in words.
    pub words: String,
    /// True for the recommended one.
    pub recommended: bool,
}

/// The chart.
pub struct Ladder {
    /// The candidates from simple to complex.
    pub rungs: Vec<Rung>,
    /// Error of the best candidate.
    pub best: f64,
    /// The same in words.
    pub best_words: String,
    /// Label of the axis, with its unit.
    pub axis_label: String,
}

impl Rung {
    /// Radius of the dot (pixels).
    fn radius(&self) -> f64 {
        if self.recommended { 6.5 } else { 4.5 }
    }

    /// Ends of the bar (pixels); `None` where the dot would hide it.
    fn bar(&self, axis: &Axis) -> Option<[f64; 2]> {
        let ends = [-1.0, 1.0].map(|side| axis.place(self.value + side * self.standard_error));
        let is_wider = ends[1] - axis.place(self.value) > self.radius() + 1.0;
        (self.value.is_finite() && self.standard_error.is_finite() && is_wider).then_some(ends)
    }
}

/// A candidate's name with the error by which it is compared, where it is.
pub struct NamedError<'a> {
    /// Name of the candidate.
    pub name: &'a str,
    /// Error and difference to the best.
    pub compared: Option<ComparedError>,
}

/// Name, error and difference to the best in a line.
fn words(criterion: SelectionCriterion, name: &str, compared: &ComparedError) -> String {
    let difference = compared.difference;
    let than_best = match compared.is_as_good {
        _ if difference.mean == 0.0 => "the least".to_owned(),
        is_as_good => format!(
            "{} more than the best{}",
            criterion.format_with_error(difference.mean, difference.standard_error),
            if is_as_good { ", which is as good" } else { "" }
        ),
    };
    format!("{name}: {}, {than_best}", criterion.format_with_error(compared.mean, f64::NAN))
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
/// Longer names are cut.
const MOST_LINES: usize = 4;
const TOP: f64 = 30.0;

impl Ladder {
    /// Chart of the errors by which candidates are compared, by name, and the place of the recommended one. `criterion` is what was asked for: its unit is that
    /// of errors of the whole pose too.
    pub fn of(
        criterion: SelectionCriterion,
        data_words: &str,
        candidates: &[NamedError<'_>],
        recommended: Option<usize>,
    ) -> Self {
        let rung = |(place, NamedError { name, compared }): (usize, &NamedError<'_>)| {
            let shown = |of: fn(&ComparedError) -> f64| criterion.in_unit(compared.as_ref().map_or(f64::NAN, of));
            Rung {
                name: (*name).to_owned(),
                value: shown(|compared| compared.mean),
                standard_error: shown(|compared| compared.difference.standard_error),
                as_good_within: shown(|compared| compared.as_good_within),
                is_as_good: compared.is_some_and(|compared| compared.is_as_good),
                words: compared.as_ref().map(|compared| words(criterion, name, compared)).unwrap_or_default(),
                recommended: recommended == Some(place),
            }
        };
        let any = candidates.iter().find_map(|own| own.compared);
        let best = any.map_or(f64::NAN, |any| any.mean - any.difference.mean);
        let error = match any.is_some_and(|any| any.is_of_pose) {
            true => "mean pose error".to_owned(),
            false => criterion.to_string(),
        };
        Self {
            rungs: candidates.iter().enumerate().map(rung).collect(),
            best: criterion.in_unit(best),
            best_words: format!("best: {}", criterion.format_with_error(best, f64::NAN)),
            axis_label: format!("{error} on {data_words} in {}", criterion.unit()),
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
        let names: Vec<Vec<String>> = self.rungs.iter().map(|rung| name_lines(&rung.name, layout.letters)).collect();
        let longest = names.iter().flatten().map(|line| line.chars().count()).max().unwrap_or(0);
        let left = if layout.above { 14.0 } else { 46.0 + LETTER * longest as f64 };
        let right = left + layout.plot;
        let axis = self.axis(left, right)?;
        let rows = rows(&names, layout);
        let bottom = rows.last().map_or(TOP, |row| row.bottom);
        let keys = self.keys(&axis);
        let height = bottom + 46.0 + KEY * keys.len() as f64 + 6.0;
        let mut drawing = Drawing::new(right + 25.0, height, "Candidates against the error by which they are compared");
        if let Some(chosen) = self.rungs.iter().position(|rung| rung.recommended) {
            let Row { top, bottom, .. } = rows[chosen];
            drawing.rectangle("chosen-row", (4.0, top + 1.0), (right - 4.0, bottom - top - 2.0), None);
        }
        let scale = if axis.is_logarithmic() { ", logarithmic" } else { "" };
        axis.draw_below(&mut drawing, TOP, bottom, &format!("{}{scale}", self.axis_label));
        let x = axis.place(self.best);
        for (rung, row) in self.rungs.iter().zip(&rows) {
            // not through the names
            let top = if layout.above { row.rung - 10.0 } else { row.top };
            let width = axis.place(self.best + rung.as_good_within) - x;
            if width.is_finite() && rung.value.is_finite() {
                drawing.rectangle("as-good", (x, top), (width.max(LEAST_BAND), row.bottom - top), None);
            }
            drawing.line("limit", (x, top), (x, row.bottom));
        }
        // the words stay inside the picture at either end
        let anchor = if x > 0.5 * (left + right) { Anchor::End } else { Anchor::Start };
        drawing.text("tick", anchor, (x, TOP - 10.0), &self.best_words);
        for (index, rung) in self.rungs.iter().enumerate() {
            draw_name(&mut drawing, layout, left, (index, &names[index], &rows[index]), rung.recommended);
            match rung.value.is_finite() {
                true => draw_rung(&mut drawing, &axis, rows[index].rung, rung),
                false => draw_nothing(&mut drawing, (left, right), rows[index].rung, x),
            }
        }
        // wide drawings have the keys below the plot, where the axis is
        let keys_left = if layout.above { left } else { (right - KEY_WIDTH).max(14.0) };
        for (place, key) in keys.iter().enumerate() {
            key.draw(&mut drawing, keys_left, bottom + 56.0 + KEY * place as f64);
        }
        Some(drawing.finish())
    }

    /// The axis over all errors and what of their bars is worth the room.
    fn axis(&self, left: f64, right: f64) -> Option<Axis> {
        let pixels = (left, right);
        let values = || self.rungs.iter().filter(|rung| rung.value.is_finite());
        let error = |rung: &Rung| Some(rung.standard_error).filter(|error| error.is_finite()).unwrap_or(0.0);
        let low = |rung: &Rung| (rung.value - error(rung)).max(0.7 * rung.value);
        let (low, _) = finite_range(values().map(low).chain([self.best]))?;
        let ends = |rung: &Rung| [rung.value + error(rung), self.best + rung.as_good_within];
        let (_, high) = finite_range(values().flat_map(ends))?;
        Some(if low > 0.0 { Axis::logarithmic(low, high, pixels, 7) } else { Axis::linear(0.0, high, pixels, 7) })
    }

    /// Keys to the marks that the drawing has.
    fn keys(&self, axis: &Axis) -> Vec<Key> {
        let has = |is_such: fn(&Rung) -> bool| self.rungs.iter().filter(|rung| rung.value.is_finite()).any(is_such);
        let mut keys = Vec::new();
        if has(|rung| rung.is_as_good) {
            keys.push(Key::AsGood);
        }
        if has(|rung| !rung.is_as_good) {
            keys.push(Key::Worse);
        }
        if self.rungs.iter().any(|rung| rung.bar(axis).is_some()) {
            keys.push(Key::Bar);
        }
        keys
    }
}

/// Height of a line of the keys, and width of the longest one.
const KEY: f64 = 18.0;
const KEY_WIDTH: f64 = 400.0;
/// A band of a pixel could not be seen.
const LEAST_BAND: f64 = 3.0;

/// Key to a mark, below the plot.
enum Key {
    /// Full dot in the shade.
    AsGood,
    /// Hollow dot.
    Worse,
    /// Bar.
    Bar,
}

impl Key {
    fn draw(&self, drawing: &mut Drawing, x: f64, y: f64) {
        let middle = x + 13.0;
        let words = match self {
            Self::AsGood => {
                drawing.rectangle("as-good", (x, y - 8.0), (26.0, 16.0), None);
                drawing.circle("dot plain", (middle, y), 4.5, "");
                "as good as the best: the difference lies in the shade"
            }
            Self::Worse => {
                drawing.circle("dot open", (middle, y), 4.0, "");
                "worse than the best"
            }
            Self::Bar => {
                draw_bar(drawing, "plain", [x + 3.0, x + 23.0], y);
                "± one standard error of the difference, if wider"
            }
        };
        drawing.text("tick", Anchor::Start, (x + 34.0, y + 4.0), words);
    }
}

/// A name in lines of at most so many letters; what four lines cannot hold is cut.
fn name_lines(name: &str, letters: usize) -> Vec<String> {
    let mut lines = wrapped(name, letters);
    if lines.len() > MOST_LINES {
        lines.truncate(MOST_LINES);
        lines[MOST_LINES - 1].pop();
        lines[MOST_LINES - 1].push('…');
    }
    lines
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
        let height = if layout.above { text + 22.0 } else { (text + 3.0).max(17.0) };
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
    let x = axis.place(rung.value);
    if let Some(ends) = rung.bar(axis) {
        draw_bar(drawing, class, ends, y);
    }
    let class = if rung.is_as_good { class } else { "open" };
    drawing.circle(&format!("dot {class}"), (x, y), rung.radius(), &rung.words);
}

fn draw_bar(drawing: &mut Drawing, class: &str, [from, to]: [f64; 2], y: f64) {
    drawing.line(&format!("bar {class}"), (from, y), (to, y));
    for x in [from, to] {
        drawing.line(&format!("bar {class}"), (x, y - 5.0), (x, y + 5.0));
    }
}

#[cfg(test)]
mod tests {
    use cdpr_calibration::Difference;

    use super::*;

    fn compared(name: &str, mean: f64, [difference, standard_error]: [f64; 2], is_of_pose: bool) -> NamedError<'_> {
        let as_good_within = standard_error.max(0.01 * (mean - difference));
        let is_as_good = difference <= as_good_within;
        let difference = Difference { mean: difference, standard_error };
        let compared = Some(ComparedError { unit: "m", is_of_pose, mean, difference, as_good_within, is_as_good });
        NamedError { name, compared }
    }

    #[test]
    fn names_break_after_separators_and_lose_nothing() {
        let name = "elastic:frame-anchor,platform-anchor,length-offset,compliance,wrench";
        let lines = name_lines(name, 38);
        assert_eq!(lines, ["elastic:frame-anchor,platform-anchor,", "length-offset,compliance,wrench"]);
        assert_eq!(lines.concat(), name);
        let long = name_lines(&"a-long-parameter,".repeat(20), 20);
        assert!(long.len() == MOST_LINES && long[MOST_LINES - 1].ends_with('…'), "{long:?}");
    }

    #[test]
    fn the_scale_is_logarithmic_and_the_best_says_its_value() {
        let candidates = [
            compared("standard", 0.006, [0.002, 0.0002], true),
            compared("near", 0.0042, [0.0002, 0.0003], true),
            compared("elastic", 0.004, [0.0, 0.0], true),
        ];
        let ladder = Ladder::of(SelectionCriterion::Position, "validation data", &candidates, Some(1));
        for figure in [ladder.svg().unwrap(), ladder.narrow_svg().unwrap()] {
            assert!(figure.body.contains("mean pose error on validation data in mm, logarithmic"), "{}", figure.body);
            assert!(figure.body.contains("best: 4.00 mm"), "{}", figure.body);
            let count = |class: &str| figure.body.matches(&format!("class=\"{class}\"")).count();
            // with the keys: a full dot, a hollow one and a bar of three lines; the best has no bar, the recommended one has its own
            assert_eq!([count("dot plain"), count("dot chosen"), count("dot open")], [2, 1, 2], "{}", figure.body);
            assert_eq!([count("bar plain"), count("bar chosen")], [6, 3], "{}", figure.body);
            assert_eq!([count("as-good"), count("limit")], [4, 3], "{}", figure.body);
        }
        assert_eq!(ladder.rungs[1].words, "near: 4.20 mm, 0.20 ± 0.30 mm more than the best, which is as good");
        assert_eq!(ladder.rungs[2].words, "elastic: 4.00 mm, the least");
    }

    /// A dot lies in the shade if and only if its candidate is as good, for errors in any unit.
    #[test]
    fn shade_and_dots_agree_for_every_criterion() {
        let candidates = [[0.02, 0.01], [0.004, 0.005], [0.0, 0.0], [0.0003, 0.0]];
        let candidates = candidates.map(|[mean, error]| compared("standard", 0.04 + mean, [mean, error], false));
        for criterion in [SelectionCriterion::Rotation, SelectionCriterion::Length, SelectionCriterion::Tension] {
            let ladder = Ladder::of(criterion, "validation data", &candidates, None);
            assert_eq!(ladder.axis_label, format!("{criterion} on validation data in {}", criterion.unit()));
            let is_inside = |rung: &Rung| rung.value <= ladder.best + rung.as_good_within;
            assert!(ladder.rungs.iter().all(|rung| is_inside(rung) == rung.is_as_good));
            assert_eq!(ladder.rungs.iter().map(|rung| rung.is_as_good).collect::<Vec<_>>(), [false, true, true, true]);
        }
        let none = ["standard", "elastic"].map(|name| NamedError { name, compared: None });
        assert!(Ladder::of(SelectionCriterion::Position, "validation data", &none, None).svg().is_none());
    }
}
