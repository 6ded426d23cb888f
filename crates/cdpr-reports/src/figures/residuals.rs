//! Length residuals of every cable against the sample number, as small multiples on one scale.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::figure::Figure;

const COLUMNS: usize = 2;
const PANEL: (f64, f64) = (350.0, 90.0);
/// From the corner of one panel to that of the next.
const PITCH: (f64, f64) = (425.0, 138.0);
const CORNER: (f64, f64) = (72.0, 26.0);
/// More samples than this are drawn as a band from smallest to largest.
const MOST_DOTS: usize = 300;
/// Pieces of such a band.
const PIECES: usize = 175;

/// Residuals (mm) by cable, each a list of sample number and value; `None` without finite values.
pub fn residuals(cables: &[(String, Vec<(usize, f64)>)]) -> Option<Figure> {
    let all = || cables.iter().flat_map(|(_, series)| series);
    let (low, high) = finite_range(all().map(|point| point.1))?;
    let largest = low.abs().max(high.abs());
    let (first, last) = finite_range(all().map(|point| point.0 as f64))?;
    let rows = cables.len().div_ceil(COLUMNS);
    let height = CORNER.1 + PITCH.1 * (rows - 1) as f64 + PANEL.1 + 46.0;
    let mut drawing = Drawing::new(CORNER.0 + PITCH.0 + PANEL.0 + 16.0, height, "Length residuals by cable");
    for (index, (name, series)) in cables.iter().enumerate() {
        let left = CORNER.0 + PITCH.0 * (index % COLUMNS) as f64;
        let top = CORNER.1 + PITCH.1 * (index / COLUMNS) as f64;
        let (right, bottom) = (left + PANEL.0, top + PANEL.1);
        let x = Axis::counting(first, last, (left, right), 5);
        let y = Axis::linear(-largest, largest, (bottom, top), 5);
        let is_last = index + COLUMNS >= cables.len();
        x.draw_below(&mut drawing, top, bottom, if is_last { "sample" } else { "" });
        y.draw_left(&mut drawing, left, right, "residual in mm");
        drawing.line("zero", (left, y.place(0.0)), (right, y.place(0.0)));
        drawing.text("panel", Anchor::Start, (left, top - 7.0), name);
        draw_series(&mut drawing, &x, &y, series);
    }
    Some(drawing.finish())
}

fn draw_series(drawing: &mut Drawing, x: &Axis, y: &Axis, series: &[(usize, f64)]) {
    let finite: Vec<(usize, f64)> = series.iter().copied().filter(|point| point.1.is_finite()).collect();
    if finite.len() <= MOST_DOTS {
        for (sample, value) in finite {
            drawing.circle("speck", (x.place(sample as f64), y.place(value)), 1.8, "");
        }
        return;
    }
    let pieces: Vec<&[(usize, f64)]> = finite.chunks(finite.len().div_ceil(PIECES)).collect();
    let middle = |piece: &[(usize, f64)]| x.place(piece[piece.len() / 2].0 as f64);
    let edge = |pick: fn(f64, f64) -> f64| {
        let at = |piece: &&[(usize, f64)]| {
            let value = piece.iter().map(|point| point.1).reduce(pick).unwrap_or(0.0);
            (middle(piece), y.place(value))
        };
        pieces.iter().map(at).collect::<Vec<_>>()
    };
    let mut outline = edge(f64::max);
    outline.extend(edge(f64::min).into_iter().rev());
    drawing.polyline("band", &outline, true);
    let mean = |piece: &&[(usize, f64)]| piece.iter().map(|point| point.1).sum::<f64>() / piece.len() as f64;
    let means: Vec<(f64, f64)> = pieces.iter().map(|piece| (middle(piece), y.place(mean(piece)))).collect();
    drawing.polyline("curve thin", &means, false);
}
