//! The cost after each step of a fit.

use super::axis::{Axis, finite_range};
use super::drawing::Drawing;
use super::figure::Figure;
use crate::number_format::significant;

const WIDTH: f64 = 860.0;
const LEFT: f64 = 90.0;
const RIGHT: f64 = 840.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 210.0;

/// The weighted sum of squares by step; `None` for fewer than two finite values.
pub fn convergence(history: &[f64]) -> Option<Figure> {
    let (low, high) = finite_range(history.iter().copied())?;
    if history.len() < 2 {
        return None;
    }
    let mut drawing = Drawing::new(WIDTH, BOTTOM + 44.0, "Weighted sum of squares after each step");
    let y = Axis::fitting(low, high, (BOTTOM, TOP), 6);
    let x = Axis::counting(0.0, (history.len() - 1) as f64, (LEFT, RIGHT), 12);
    x.draw_below(&mut drawing, TOP, BOTTOM, "step");
    y.draw_left(&mut drawing, LEFT, RIGHT, "weighted sum of squares");
    let finite = history.iter().enumerate().filter(|(_, value)| value.is_finite());
    let points: Vec<(f64, f64)> = finite.map(|(step, &value)| (x.place(step as f64), y.place(value))).collect();
    drawing.polyline("curve", &points, false);
    let finite = history.iter().enumerate().filter(|(_, value)| value.is_finite());
    for (&point, (step, value)) in points.iter().zip(finite).take(200) {
        drawing.circle("dot plain", point, 3.5, &format!("step {step}: {}", significant(*value, 5)));
    }
    Some(drawing.finish())
}
