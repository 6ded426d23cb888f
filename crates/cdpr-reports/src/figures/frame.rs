//! Two axes to the same scale.

use super::axis::Axis;

/// Least width and height of a plot, so that labels have room.
const LEAST: (f64, f64) = (150.0, 120.0);

/// Axes of a plot in which a metre is as long across as up.
pub(super) struct Frame {
    pub(super) x: Axis,
    pub(super) y: Axis,
    /// Pixels of the right and of the lower edge.
    pub(super) right: f64,
    pub(super) bottom: f64,
}

impl Frame {
    /// Around these ranges with some margin, from a corner and at most so large (pixels).
    pub(super) fn new(ranges: [(f64, f64); 2], left: f64, top: f64, most: (f64, f64)) -> Self {
        let [horizontal, vertical] = ranges.map(|(low, high)| {
            let margin = 0.04 * (high - low).max(1e-3);
            (low - margin, high + margin)
        });
        let spans = (horizontal.1 - horizontal.0, vertical.1 - vertical.0);
        let scale = (most.0 / spans.0).min(most.1 / spans.1);
        let size = ((spans.0 * scale).max(LEAST.0), (spans.1 * scale).max(LEAST.1));
        // what lacks room is widened to both sides
        let grown = |range: (f64, f64), pixels: f64| {
            let (middle, half) = (0.5 * (range.0 + range.1), 0.5 * pixels / scale);
            (middle - half, middle + half)
        };
        let (horizontal, vertical) = (grown(horizontal, size.0), grown(vertical, size.1));
        let (right, bottom) = (left + size.0, top + size.1);
        Self {
            x: Axis::exact(horizontal.0, horizontal.1, (left, right), (size.0 / 70.0) as usize),
            y: Axis::exact(vertical.0, vertical.1, (bottom, top), (size.1 / 26.0) as usize),
            right,
            bottom,
        }
    }
}
