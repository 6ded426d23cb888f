//! Correlations of the errors of all pairs of parameters, as a square of colours.

use super::colour::diverging;
use super::drawing::{Anchor, Drawing};
use crate::number_format as number;

/// Largest width of the square.
const SIZE: f64 = 620.0;
/// Largest and smallest cell.
const CELL: (f64, f64) = (22.0, 2.0);
/// Least distance of two names.
const NAME_PITCH: f64 = 8.5;
/// Colour of pairs of which one is not determined.
const UNKNOWN: &str = "#8c8c8c";
const STEPS: usize = 20;

/// The map; `None` for fewer than two parameters.
pub fn correlations(names: &[String], rows: &[Vec<f64>]) -> Option<String> {
    let count = names.len();
    if count < 2 {
        return None;
    }
    let cell = (SIZE / count as f64).clamp(CELL.1, CELL.0);
    let font = (0.95 * cell).clamp(8.0, 11.0);
    let longest = names.iter().map(|name| name.chars().count()).max().unwrap_or(0) as f64;
    let margin = 12.0 + 0.6 * font * longest;
    let side = cell * count as f64;
    let right = margin + side;
    let mut drawing = Drawing::new(right + 110.0, right + 16.0, "Correlations of the errors of the parameters");
    let stride = (NAME_PITCH / cell).ceil().max(1.0) as usize;
    for (index, name) in names.iter().enumerate().step_by(stride) {
        let middle = margin + cell * (index as f64 + 0.5);
        drawing.small_text(Anchor::End, (margin - 5.0, middle + 0.35 * font), font, name);
        drawing.small_upright_text((middle + 0.35 * font, margin - 5.0), font, name);
    }
    for (row, values) in rows.iter().enumerate().take(count) {
        for (column, value) in values.iter().enumerate().take(count) {
            let corner = (margin + cell * column as f64, margin + cell * row as f64);
            // a hair more, so that no white shows between cells
            drawing.rectangle("cell", corner, (cell + 0.2, cell + 0.2), Some(colour(*value)));
        }
    }
    bar(&mut drawing, right + 28.0, margin, side.clamp(120.0, 260.0));
    Some(drawing.finish())
}

fn colour(value: f64) -> &'static str {
    if value.is_finite() { diverging(value) } else { UNKNOWN }
}

fn bar(drawing: &mut Drawing, left: f64, top: f64, height: f64) {
    let piece = height / STEPS as f64;
    for step in 0..STEPS {
        let value = 1.0 - 2.0 * (step as f64 + 0.5) / STEPS as f64;
        drawing.rectangle("cell", (left, top + piece * step as f64), (14.0, piece + 0.3), Some(colour(value)));
    }
    for value in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        let y = top + 0.5 * (1.0 - value) * height;
        drawing.text("tick", Anchor::Start, (left + 19.0, y + 4.0), &number::fixed(value, 1));
    }
    drawing.upright_text((left + 64.0, top + 0.5 * height), "correlation");
}
