//! Errors and sensitivities over the workspace: discs at the positions, coloured by size, and arrows.

use super::arrow;
use super::axis::{Axis, finite_range};
use super::colour;
use super::colour_bar::ColourBar;
use super::drawing::{Drawing, LINE, title_width};
use super::figure::Figure;
use super::frame::Frame;
use crate::number_format::significant;

/// One sample.
pub struct MapPoint {
    /// Coordinates along the two axes of the map (m).
    pub at: [f64; 2],
    /// Error in the unit of the colour bar.
    pub error: f64,
}

/// The chart.
pub struct Map {
    /// Lines of text above the plot; the first is the title.
    pub title: Vec<String>,
    /// The samples.
    pub points: Vec<MapPoint>,
    /// From a point to another (m).
    pub arrows: Vec<[[f64; 2]; 2]>,
    /// Names of the two axes, e.g. x and y.
    pub axes: [String; 2],
    /// Error of the last colour; larger ones share it.
    pub top: f64,
    /// Label of the colours, with its unit.
    pub colour_label: String,
}

const STYLE: &str = include_str!("map.css");

const LEFT: f64 = 78.0;
const TOP: f64 = 14.0;
/// Largest width and height of the plot.
const SIZE: (f64, f64) = (560.0, 380.0);
/// More discs than this are thinned out.
const MOST_POINTS: usize = 1500;

impl Map {
    /// The chart as SVG, both axes to the same scale; `None` without points.
    pub fn svg(&self) -> Option<Figure> {
        let points = thinned(&self.points);
        let places = || points.iter().map(|point| point.at).chain(arrow::some_of(&self.arrows).map(|[_, to]| *to));
        let ranges = [0, 1].map(|axis| finite_range(places().map(|at| at[axis])));
        let [Some(horizontal), Some(vertical)] = ranges else { return None };
        let top = TOP + LINE * self.title.len() as f64;
        let Frame { x, y, right, bottom } = Frame::new([horizontal, vertical], LEFT, top, SIZE);
        let widest = LEFT + title_width(&self.title);
        let mut drawing = Drawing::new((right + 130.0).max(widest), bottom + 46.0, &self.colour_label);
        if !self.arrows.is_empty() {
            drawing = drawing.with_style(STYLE);
        }
        drawing.title(LEFT, &self.title);
        x.draw_below(&mut drawing, top, bottom, &format!("{} in m", self.axes[0]));
        y.draw_left(&mut drawing, LEFT, right, &format!("{} in m", self.axes[1]));
        self.draw_points(&mut drawing, &points, &x, &y);
        let place = |point: &[f64; 2]| (x.place(point[0]), y.place(point[1]));
        for [from, to] in arrow::some_of(&self.arrows) {
            arrow::draw(&mut drawing, place(from), place(to));
        }
        let bar = ColourBar {
            left: right + 28.0,
            top,
            bottom,
            ends: [0.0, self.top],
            intervals: ColourBar::intervals_of(bottom - top),
            number: &|value| significant(value, 3),
            label: &self.colour_label,
            label_at: 84.0,
        };
        bar.draw(&mut drawing);
        Some(drawing.finish())
    }

    /// Small errors first, so that large ones lie on top.
    fn draw_points(&self, drawing: &mut Drawing, points: &[&MapPoint], x: &Axis, y: &Axis) {
        let radius = if points.len() > 400 { 3.0 } else { 4.5 };
        for step in 0..colour::COUNT {
            let own = points.iter().filter(|point| colour::step_of(point.error, self.top) == step);
            let centres: Vec<(f64, f64)> = own.map(|point| (x.place(point.at[0]), y.place(point.at[1]))).collect();
            if !centres.is_empty() {
                drawing.discs(colour::of_step(step), &centres, radius);
            }
        }
    }
}

/// Every point where they are few; else the worst of each run of consecutive ones.
fn thinned(points: &[MapPoint]) -> Vec<&MapPoint> {
    let run = points.len().div_ceil(MOST_POINTS).max(1);
    let worst = |run: &'_ [MapPoint]| -> Option<usize> {
        (0..run.len()).filter(|&k| run[k].error.is_finite()).max_by(|&a, &b| run[a].error.total_cmp(&run[b].error))
    };
    points.chunks(run).filter_map(|run| worst(run).map(|k| &run[k])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An arrow that leads out of the points widens the plot: its tip is inside the frame.
    #[test]
    fn no_arrow_is_cut_at_the_edge() {
        let point = |x: f64| MapPoint { at: [x, 0.0], error: 1.0 };
        let map = |arrows: Vec<[[f64; 2]; 2]>| Map {
            title: vec!["errors".to_owned()],
            points: vec![point(0.0), point(1.0)],
            arrows,
            axes: ["x".to_owned(), "y".to_owned()],
            top: 1.0,
            colour_label: "error in mm".to_owned(),
        };
        let figure = map(vec![[[1.0, 0.0], [3.0, 0.5]]]).svg().unwrap();
        let line = figure.body.lines().find(|line| line.contains("class=\"arrow\"")).unwrap();
        let at = |name: &str| -> f64 {
            line.split_once(&format!(" {name}=\"")).unwrap().1.split_once('"').unwrap().0.parse().unwrap()
        };
        assert!(at("x2") < figure.width && at("y2") > 0.0 && at("x2") > at("x1") + 100.0, "{line}");
    }
}
