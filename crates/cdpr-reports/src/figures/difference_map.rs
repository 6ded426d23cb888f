//! Two controllers on one machine: where one is better (green discs) and where it is worse (red triangles), by shape, lightness and size as
//! well as by colour.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing, LINE, title_width};
use super::figure::Figure;
use super::frame::Frame;
use crate::number_format::significant;

/// A pose.
#[derive(Clone, Debug)]
pub struct DifferencePoint {
    /// Coordinates along the two axes of the map (m).
    pub at: [f64; 2],
    /// Change of the error in the unit of the label; negative is better.
    pub change: f64,
}

/// The chart: one panel, or several side by side on the same scales.
pub struct DifferenceMap {
    /// Lines of text above the plot; the first is the title.
    pub title: Vec<String>,
    /// Titles of the panels with their poses.
    pub panels: Vec<(String, Vec<DifferencePoint>)>,
    /// Names of the two axes.
    pub axes: [String; 2],
    /// Error that changes, with its unit.
    pub label: String,
    /// The unit alone.
    pub unit: String,
}

const STYLE: &str = include_str!("difference_map.css");

const LEFT: f64 = 78.0;
const TOP: f64 = 14.0;
/// Room between panels, and for the legend on the right.
const GAP: f64 = 64.0;
const LEGEND: f64 = 170.0;
/// Largest width of all panels together, and their largest height.
const SIZE: (f64, f64) = (640.0, 380.0);
/// Radius of the largest change and of a change that is none (pixels).
const RADIUS: (f64, f64) = (9.5, 1.6);
/// Share of the largest change below which nothing is told but a dot.
const NOTHING: f64 = 0.01;

impl DifferenceMap {
    /// The chart as SVG, both axes to the same scale; `None` without points.
    pub fn svg(&self) -> Option<Figure> {
        let points = || self.panels.iter().flat_map(|(_, points)| points);
        let ranges = [0, 1].map(|axis| finite_range(points().map(|point| point.at[axis])));
        let [Some(horizontal), Some(vertical)] = ranges else { return None };
        let largest = points().map(|point| point.change.abs()).filter(|size| size.is_finite()).fold(0.0, f64::max);
        let count = self.panels.len();
        let named = count > 1;
        let top = TOP + LINE * (self.title.len() as f64 + if named { 1.5 } else { 0.0 });
        let most = ((SIZE.0 - GAP * (count - 1) as f64) / count as f64, SIZE.1);
        let mut frames: Vec<(f64, Frame)> = Vec::new();
        for _ in 0..count {
            let left = frames.last().map_or(LEFT, |(_, frame)| frame.right + GAP);
            frames.push((left, Frame::new([horizontal, vertical], left, top, most)));
        }
        let (right, bottom) = frames.last().map(|(_, frame)| (frame.right, frame.bottom))?;
        let widest = LEFT + title_width(&self.title);
        let height = (bottom + 46.0).max(top + 170.0);
        let label = format!("{}: {}", self.title.first().map_or("", String::as_str), self.label);
        let mut drawing = Drawing::new((right + LEGEND).max(widest), height, &label).with_style(STYLE);
        drawing.title(LEFT, &self.title);
        for ((name, points), (left, Frame { x, y, right, bottom })) in self.panels.iter().zip(&frames) {
            if named {
                drawing.text("panel", Anchor::Start, (*left, top - 0.75 * LINE), name);
            }
            x.draw_below(&mut drawing, top, *bottom, &format!("{} in m", self.axes[0]));
            y.draw_left(&mut drawing, *left, *right, &format!("{} in m", self.axes[1]));
            self.draw_points(&mut drawing, points, (x, y), largest);
        }
        self.draw_legend(&mut drawing, (right + 26.0, top + 8.0), largest);
        Some(drawing.finish())
    }

    /// Large changes first, so that small ones stay visible.
    fn draw_points(&self, drawing: &mut Drawing, points: &[DifferencePoint], (x, y): (&Axis, &Axis), largest: f64) {
        let mut sorted: Vec<&DifferencePoint> = points.iter().filter(|point| point.change.is_finite()).collect();
        sorted.sort_by(|a, b| b.change.abs().total_cmp(&a.change.abs()));
        for point in sorted {
            mark(drawing, (x.place(point.at[0]), y.place(point.at[1])), point.change, largest);
        }
    }

    fn draw_legend(&self, drawing: &mut Drawing, (left, top): (f64, f64), largest: f64) {
        let value = |share: f64| format!("{} {}", significant(share * largest, 2), self.unit);
        let mut line = top;
        let mut row = |drawing: &mut Drawing, change: f64, words: &str| {
            mark(drawing, (left + RADIUS.0, line), change, largest);
            drawing.text("tick", Anchor::Start, (left + 2.0 * RADIUS.0 + 8.0, line + 4.0), words);
            line += 24.0;
        };
        for share in [1.0, 0.25] {
            row(drawing, -share * largest, &format!("better by {}", value(share)));
        }
        row(drawing, 0.0, &format!("within {}", value(NOTHING)));
        for share in [0.25, 1.0] {
            row(drawing, share * largest, &format!("worse by {}", value(share)));
        }
    }
}

/// The mark of a change: its area grows with the change.
fn mark(drawing: &mut Drawing, (x, y): (f64, f64), change: f64, largest: f64) {
    let share = if largest > 0.0 { (change.abs() / largest).min(1.0) } else { 0.0 };
    let radius = (RADIUS.0 * share.sqrt()).max(RADIUS.1);
    match share > NOTHING {
        false => drawing.circle("same", (x, y), RADIUS.1, ""),
        true if change < 0.0 => drawing.circle("better", (x, y), radius, ""),
        true => {
            let corner = |turn: f64| (x + 1.2 * radius * turn.sin(), y - 1.2 * radius * turn.cos());
            let third = std::f64::consts::TAU / 3.0;
            drawing.polyline("worse", &[corner(0.0), corner(third), corner(2.0 * third)], true);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Better and worse are different shapes, not colours alone; areas grow with the change.
    #[test]
    fn better_and_worse_differ_without_colours() {
        let point = |x: f64, change: f64| DifferencePoint { at: [x, 0.0], change };
        let map = DifferenceMap {
            title: vec!["a against b".to_owned()],
            panels: vec![(String::new(), vec![point(0.0, -4.0), point(1.0, 4.0), point(2.0, -1.0), point(3.0, 0.0)])],
            axes: ["x".to_owned(), "y".to_owned()],
            label: "change of the position error".to_owned(),
            unit: "mm".to_owned(),
        };
        let svg = map.svg().unwrap().body;
        let marks = |class: &str| svg.lines().filter(|line| line.contains(&format!("class=\"{class}\""))).count();
        // with the two of the legend
        assert_eq!((marks("better"), marks("worse"), marks("same")), (4, 3, 2), "{svg}");
        assert!(svg.contains("r=\"9.5\"") && svg.contains("r=\"4.8\""), "{svg}");
        assert!(svg.contains("better by 4.0 mm") && svg.contains("worse by 1.0 mm"), "{svg}");
    }
}
