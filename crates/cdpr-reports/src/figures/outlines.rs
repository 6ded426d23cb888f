//! Outlines of regions over one another, and how one of them moves.

use super::arrow;
use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing, LINE, title_width};
use super::figure::Figure;
use super::frame::Frame;

const STYLE: &str = include_str!("outlines.css");

/// Which line an outline is drawn with.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Look {
    /// Outline of all that could be reached: grey.
    Background,
    /// Outline that the picture is about: thick and blue.
    Nominal,
    /// The outline moved to first order: dashed.
    FirstOrder,
    /// The outline found anew.
    Changed,
}

impl Look {
    fn class(self) -> &'static str {
        match self {
            Self::Background => "outline background",
            Self::Nominal => "outline nominal",
            Self::FirstOrder => "outline first-order",
            Self::Changed => "outline changed",
        }
    }
}

/// A closed line with its name.
pub struct Outline {
    /// Stands in the legend.
    pub name: String,
    /// Its line and filling.
    pub look: Look,
    /// Corners in order (m).
    pub points: Vec<[f64; 2]>,
}

/// The chart.
pub struct Outlines {
    /// Lines of text above the plot; the first is the title.
    pub title: Vec<String>,
    /// Names of the two axes, e.g. x and y.
    pub axes: [String; 2],
    /// From back to front.
    pub outlines: Vec<Outline>,
    /// Arrows from a point to another (m), with their name in the legend.
    pub arrows: (String, Vec<[[f64; 2]; 2]>),
    /// Points with names beside them (m), frame anchors for one.
    pub points: Vec<(String, [f64; 2])>,
    /// A point with its name in the legend.
    pub center: (String, [f64; 2]),
}

/// Largest width and height of the plot.
const SIZE: (f64, f64) = (520.0, 480.0);
const LEFT: f64 = 64.0;
/// Distance and width of the legend.
const LEGEND: (f64, f64) = (26.0, 300.0);
/// Length of a sample line in the legend.
const SAMPLE: f64 = 26.0;

impl Outlines {
    /// The chart as SVG, both axes to the same scale; `None` where no outline has a finite point.
    pub fn svg(&self) -> Option<Figure> {
        let corners = || self.outlines.iter().flat_map(|outline| &outline.points);
        let points = || corners().chain(self.points.iter().map(|point| &point.1));
        let ranges = [0, 1].map(|axis| finite_range(points().map(|point| point[axis])));
        let [Some(horizontal), Some(vertical)] = ranges else { return None };
        let top = 14.0 + LINE * self.title.len() as f64;
        let Frame { x, y, right, bottom } = Frame::new([horizontal, vertical], LEFT, top, SIZE);
        let legend = top + LINE * (self.outlines.len() + 3) as f64;
        let widest = LEFT + title_width(&self.title);
        let size = ((right + LEGEND.0 + LEGEND.1).max(widest), (bottom + 46.0).max(legend));
        let label = self.title.first().map_or("", |title| title);
        let mut drawing = Drawing::new(size.0, size.1, label).with_style(STYLE);
        drawing.title(LEFT, &self.title);
        x.draw_below(&mut drawing, top, bottom, &format!("{} in m", self.axes[0]));
        y.draw_left(&mut drawing, LEFT, right, &format!("{} in m", self.axes[1]));
        let place = |point: &[f64; 2]| (x.place(point[0]), y.place(point[1]));
        for outline in &self.outlines {
            let corners: Vec<(f64, f64)> = outline.points.iter().map(place).collect();
            drawing.polyline(outline.look.class(), &corners, true);
        }
        for [from, to] in arrow::some_of(&self.arrows.1) {
            arrow::draw(&mut drawing, place(from), place(to));
        }
        self.draw_points(&mut drawing, (&x, &y), right);
        cross(&mut drawing, place(&self.center.1));
        self.draw_legend(&mut drawing, (right + LEGEND.0, top));
        Some(drawing.finish())
    }

    /// Discs with their names, to the left where the right edge is near.
    fn draw_points(&self, drawing: &mut Drawing, (x, y): (&Axis, &Axis), right: f64) {
        for (name, point) in &self.points {
            let at = (x.place(point[0]), y.place(point[1]));
            drawing.circle("dot plain", at, 3.5, name);
            let width = 6.5 * name.chars().count() as f64;
            match at.0 + width + 8.0 < right {
                true => drawing.text("tick", Anchor::Start, (at.0 + 6.0, at.1 - 6.0), name),
                false => drawing.text("tick", Anchor::End, (at.0 - 6.0, at.1 - 6.0), name),
            }
        }
    }

    /// One line for each outline, the front one first, then arrows and centre.
    fn draw_legend(&self, drawing: &mut Drawing, (left, top): (f64, f64)) {
        let mut line = top + 6.0;
        let mut next = |drawing: &mut Drawing, name: &str| {
            drawing.text("", Anchor::Start, (left + SAMPLE + 8.0, line + 4.0), name);
            line += LINE;
            line - LINE
        };
        for outline in self.outlines.iter().rev() {
            let y = next(drawing, &outline.name);
            drawing.polyline(outline.look.class(), &[(left, y), (left + SAMPLE, y)], false);
        }
        let (name, arrows) = &self.arrows;
        if !arrows.is_empty() {
            let y = next(drawing, name);
            arrow::draw(drawing, (left, y), (left + SAMPLE, y));
        }
        let y = next(drawing, &self.center.0);
        cross(drawing, (left + 0.5 * SAMPLE, y));
    }
}

fn cross(drawing: &mut Drawing, (x, y): (f64, f64)) {
    drawing.line("axis", (x - 5.0, y), (x + 5.0, y));
    drawing.line("axis", (x, y - 5.0), (x, y + 5.0));
}
