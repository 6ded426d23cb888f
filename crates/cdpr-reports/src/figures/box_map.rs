//! A quantity over a section of a box: cells coloured between its least and largest value, and the pose with the least.

use super::axis::finite_range;
use super::colour;
use super::colour_bar::ColourBar;
use super::drawing::{Anchor, Drawing, LINE, Rectangle, title_width};
use super::figure::Figure;
use super::frame::Frame;
use crate::number_format::significant;

/// Value at the middle of a cell.
pub struct BoxCell {
    /// Coordinates along the two axes of the map (m).
    pub at: [f64; 2],
    /// Value in the unit of the label; NaN where there is none.
    pub value: f64,
}

/// The chart.
pub struct BoxMap {
    /// Lines of text above the plot; the first is the title.
    pub title: Vec<String>,
    /// The cells.
    pub cells: Vec<BoxCell>,
    /// Sides of a cell (m).
    pub sides: [f64; 2],
    /// Names of the two axes, e.g. x and y.
    pub axes: [String; 2],
    /// Quantity with its unit.
    pub label: String,
    /// Place that is marked (m), and its words.
    pub marked: ([f64; 2], String),
}

const LEFT: f64 = 78.0;
const TOP: f64 = 14.0;
/// Largest width and height of the plot.
const SIZE: (f64, f64) = (440.0, 330.0);
/// Least spread of the colours, as a share of the values: less is one colour.
const SPREAD: f64 = 1e-6;

impl BoxMap {
    /// The chart as SVG, both axes to the same scale; `None` without cells.
    pub fn svg(&self) -> Option<Figure> {
        let ends = |axis: usize| {
            let half = 0.5 * self.sides[axis];
            finite_range(self.cells.iter().flat_map(|cell| [cell.at[axis] - half, cell.at[axis] + half]))
        };
        let (horizontal, vertical) = (ends(0)?, ends(1)?);
        let values = || self.cells.iter().map(|cell| cell.value).filter(|value| value.is_finite());
        let range = finite_range(values());
        let top = TOP + LINE * (self.title.len() as f64 + 1.5);
        let Frame { x, y, right, bottom } = Frame::new([horizontal, vertical], LEFT, top, SIZE);
        let widest = LEFT + title_width(&self.title);
        let mut drawing = Drawing::new((right + 130.0).max(widest), bottom + 46.0, &self.label);
        drawing.title(LEFT, &self.title);
        let place = |at: [f64; 2]| (x.place(at[0]), y.place(at[1]));
        let (wide, tall) = {
            let (from, to) = (place([0.0; 2]), place(self.sides));
            ((to.0 - from.0).abs(), (to.1 - from.1).abs())
        };
        if let Some((low, high)) = range {
            let spread = (high - low).max(SPREAD * high.abs()).max(f64::MIN_POSITIVE);
            for step in 0..colour::COUNT {
                let own = |cell: &&BoxCell| cell.value.is_finite() && colour::step_of(cell.value - low, spread) == step;
                let corner = |cell: &BoxCell| {
                    let (x, y) = place(cell.at);
                    // overlaps hide seams
                    ((x - 0.5 * wide, y - 0.5 * tall), (wide + 0.4, tall + 0.4))
                };
                let all: Vec<Rectangle> = self.cells.iter().filter(own).map(corner).collect();
                if !all.is_empty() {
                    drawing.rectangles("cell", colour::of_step(step), &all);
                }
            }
            let bar = ColourBar {
                left: right + 28.0,
                top,
                bottom,
                ends: [low, low + spread],
                intervals: ColourBar::intervals_of(bottom - top),
                number: &|value| significant(value, 4),
                label: &self.label,
                label_at: 84.0,
            };
            bar.draw(&mut drawing);
        }
        x.draw_below(&mut drawing, bottom, bottom, &format!("{} in m", self.axes[0]));
        y.draw_left(&mut drawing, LEFT, LEFT, &format!("{} in m", self.axes[1]));
        let (at, words) = &self.marked;
        let key = top - 0.9 * LINE;
        drawing.circle("dot bad", (LEFT + 6.0, key), 4.0, "");
        drawing.text("tick", Anchor::Start, (LEFT + 14.0, key + 4.0), words);
        drawing.circle("dot bad", place(*at), 4.5, words);
        Some(drawing.finish())
    }
}
