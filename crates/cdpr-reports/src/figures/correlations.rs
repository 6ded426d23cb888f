//! Correlations of the errors of all pairs of parameters, as a triangle of colours.

use super::colour::{DIVERGING, diverging, is_strong};
use super::drawing::{Anchor, Drawing, Rectangle};
use super::figure::Figure;
use crate::number_format as number;

/// Largest width of the triangle.
const SIZE: f64 = 620.0;
/// Largest and smallest cell.
const CELL: (f64, f64) = (22.0, 2.0);
/// Least distance of two names.
const NAME_PITCH: f64 = 8.5;
/// Smaller cells have no room for a sign.
const LEAST_SIGNED: f64 = 5.0;
const TOP: f64 = 10.0;
/// Colour of pairs of which one is not determined.
const UNKNOWN: &str = "#8c8c8c";
const STEPS: usize = 40;

/// Looks of signs.
pub(super) const STYLE: &str = ".sign { font-weight: 700; fill: #ffffff; }\n";

/// The map, its diagonal and what lies below, of rows that reach at least as far; `None` for fewer than two parameters.
pub fn correlations(names: &[String], rows: &[Vec<f64>]) -> Option<Figure> {
    let count = names.len();
    if count < 2 {
        return None;
    }
    let cell = (SIZE / count as f64).clamp(CELL.1, CELL.0);
    let font = (0.95 * cell).clamp(8.0, 11.0);
    let longest = names.iter().map(|name| name.chars().count()).max().unwrap_or(0) as f64;
    let margin = 12.0 + 0.6 * font * longest;
    let side = cell * count as f64;
    let (right, bottom) = (margin + side, TOP + side);
    let label = "Correlations of the errors of the parameters";
    let mut drawing = Drawing::new(right + 110.0, (bottom + margin).max(TOP + 130.0), label)
        .with_style(STYLE)
        .with_attribute("cells", &format!("{margin} {TOP} {cell}"));
    let stride = (NAME_PITCH / cell).ceil().max(1.0) as usize;
    for (index, name) in names.iter().enumerate().step_by(stride) {
        let middle = cell * (index as f64 + 0.5) + 0.35 * font;
        drawing.small_text(Anchor::End, (margin - 5.0, TOP + middle), font, name);
        drawing.small_upright_text((margin + middle, bottom + 5.0), font, name);
    }
    let corner = |row: usize, column: usize| (margin + cell * column as f64, TOP + cell * row as f64);
    let runs = runs(rows, count);
    for fill in DIVERGING.into_iter().chain([UNKNOWN]) {
        // a hair more, so that no white shows between cells
        let size = |run: &Run| (cell * run.length as f64 + 0.2, cell + 0.2);
        let own = runs.iter().filter(|run| run.fill == fill);
        let own: Vec<Rectangle> = own.map(|run| (corner(run.row, run.column), size(run))).collect();
        if !own.is_empty() {
            drawing.rectangles("cell", fill, &own);
        }
    }
    let strong = rows.iter().enumerate().flat_map(|(row, values)| {
        values.iter().take(row).enumerate().map(move |(column, value)| (row, column, *value))
    });
    for (row, column, value) in strong.filter(|(.., value)| cell >= LEAST_SIGNED && is_strong(*value)) {
        let (x, y) = corner(row, column);
        let sign = if value > 0.0 { "+" } else { "−" };
        drawing.text("sign", Anchor::Middle, (x + 0.5 * cell, y + 0.5 * cell + 4.0), sign);
    }
    bar(&mut drawing, right + 28.0, TOP, side.clamp(120.0, 260.0));
    Some(drawing.finish())
}

/// Cells side by side of one colour.
struct Run {
    row: usize,
    column: usize,
    length: usize,
    fill: &'static str,
}

fn runs(rows: &[Vec<f64>], count: usize) -> Vec<Run> {
    let mut found = Vec::new();
    for (row, values) in rows.iter().enumerate().take(count) {
        let mut column = 0;
        for own in values[..values.len().min(row + 1)].chunk_by(|a, b| colour(*a) == colour(*b)) {
            found.push(Run { row, column, length: own.len(), fill: colour(own[0]) });
            column += own.len();
        }
    }
    found
}

fn colour(value: f64) -> &'static str {
    if value.is_finite() { diverging(value) } else { UNKNOWN }
}

fn bar(drawing: &mut Drawing, left: f64, top: f64, height: f64) {
    let piece = height / STEPS as f64;
    for step in 0..STEPS {
        let value = 1.0 - 2.0 * (step as f64 + 0.5) / STEPS as f64;
        drawing.rectangle("swatch", (left, top + piece * step as f64), (14.0, piece + 0.3), Some(colour(value)));
    }
    for value in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        let y = top + 0.5 * (1.0 - value) * height;
        drawing.text("tick", Anchor::Start, (left + 19.0, y + 4.0), &number::fixed(value, 1));
    }
    drawing.upright_text((left + 64.0, top + 0.5 * height), "correlation");
}
