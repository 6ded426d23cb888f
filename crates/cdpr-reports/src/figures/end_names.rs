//! Names at the right ends of curves, apart from each other.

use super::drawing::{Anchor, Drawing};

/// Least distance of names (pixels).
const LINE: f64 = 14.0;

/// Names with the heights at which their curves end at `right`, between top and bottom.
pub(super) fn draw(drawing: &mut Drawing, right: f64, top: f64, bottom: f64, mut ends: Vec<(&str, f64)>) {
    ends.sort_by(|a, b| a.1.total_cmp(&b.1));
    let mut heights: Vec<f64> = ends.iter().map(|end| end.1.max(top)).collect();
    for k in 1..heights.len() {
        heights[k] = heights[k].max(heights[k - 1] + LINE);
    }
    let overflow = heights.last().map_or(0.0, |last| (last - bottom).max(0.0));
    let mut most = bottom;
    for height in heights.iter_mut().rev().filter(|_| overflow > 0.0) {
        *height = height.min(most);
        most = *height - LINE;
    }
    for ((name, end), height) in ends.into_iter().zip(heights) {
        drawing.line("zero", (right, end), (right + 10.0, height));
        drawing.text("name", Anchor::Start, (right + 14.0, height + 4.0), name);
    }
}
