//! Errors over the number of poses, one curve for each sensor and model.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::end_names;
use super::figure::Figure;

const WIDTH: f64 = 860.0;
const LEFT: f64 = 80.0;
const RIGHT: f64 = 620.0;
const TOP: f64 = 20.0;
const BOTTOM: f64 = 330.0;

/// Errors of one sensor with one model.
pub struct CostCurve {
    /// Stands at the end of the curve.
    pub name: String,
    /// Number of poses and error (mm).
    pub points: Vec<(f64, f64)>,
}

/// All curves.
pub struct CostCurves {
    /// Curves in the order of their looks.
    pub curves: Vec<CostCurve>,
    /// Errors that are wanted (mm), drawn across.
    pub wanted: Vec<f64>,
}

impl CostCurves {
    /// `None` for fewer than two numbers of poses.
    pub fn svg(&self) -> Option<Figure> {
        let all = || self.curves.iter().flat_map(|curve| curve.points.iter());
        let (low, high) = finite_range(all().map(|point| point.0)).filter(|(low, high)| 0.0 < *low && low < high)?;
        let (least, most) = finite_range(all().map(|point| point.1))?;
        let mut drawing = Drawing::new(WIDTH, BOTTOM + 44.0, "Driven position error over the number of poses")
            .with_style(super::penalty_path::STYLE);
        let x = Axis::logarithmic(low, high, (LEFT, RIGHT), 10);
        let y = Axis::fitting(least, most, (BOTTOM, TOP), 6);
        x.draw_below(&mut drawing, TOP, BOTTOM, "poses measured");
        y.draw_left(&mut drawing, LEFT, RIGHT, "mean driven position error (mm)");
        for wanted in self.wanted.iter().filter(|wanted| y.holds(**wanted)) {
            drawing.line("zero", (LEFT, y.place(*wanted)), (RIGHT, y.place(*wanted)));
            drawing.text("tick", Anchor::Start, (LEFT + 4.0, y.place(*wanted) - 4.0), &format!("{wanted} mm wanted"));
        }
        for (look, curve) in self.curves.iter().enumerate() {
            let points: Vec<(f64, f64)> =
                curve.points.iter().map(|&(poses, error)| (x.place(poses), y.place(error))).collect();
            drawing.polyline(&format!("path kind-{}", look % 6), &points, false);
        }
        let end = |curve: &'_ CostCurve| curve.points.last().map(|point| y.place(point.1));
        let ends = self.curves.iter().filter_map(|curve| Some((curve.name.as_str(), end(curve)?)));
        let right = all().map(|point| x.place(point.0)).fold(LEFT, f64::max);
        end_names::draw(&mut drawing, right, TOP, BOTTOM, ends.collect());
        Some(drawing.finish())
    }
}
