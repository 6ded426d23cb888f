//! Singular values of the Jacobian on a logarithmic axis.

use super::axis::{Axis, finite_range};
use super::drawing::Drawing;
use super::figure::Figure;

const WIDTH: f64 = 860.0;
const LEFT: f64 = 80.0;
const RIGHT: f64 = 840.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 230.0;

/// Singular values from large to small; those beyond `rank` are marked. `None` without positive values.
pub fn spectrum(values: &[f64], rank: usize) -> Option<Figure> {
    let (smallest, largest) = finite_range(values.iter().copied().filter(|&value| value > 0.0))?;
    // rounding errors far below would squeeze the rest
    let low = smallest.max(largest * 1e-18);
    let mut drawing = Drawing::new(WIDTH, BOTTOM + 44.0, "Singular values of the Jacobian");
    let y = Axis::logarithmic(low, largest, (BOTTOM, TOP), 8);
    let x = Axis::counting(0.5, values.len() as f64 + 0.5, (LEFT, RIGHT), 12);
    x.draw_below(&mut drawing, TOP, BOTTOM, "number of the singular value");
    y.draw_left(&mut drawing, LEFT, RIGHT, "singular value");
    let radius = if values.len() > 120 { 2.5 } else { 4.0 };
    for (index, value) in values.iter().enumerate() {
        let class = if index < rank { "dot plain" } else { "dot bad" };
        let title = format!("{}: {}", index + 1, crate::number_format::significant(*value, 4));
        drawing.circle(class, (x.place(index as f64 + 1.0), y.place(*value)), radius, &title);
    }
    Some(drawing.finish())
}
