//! Arrows, which a figure gives the looks of `arrow` and `arrow-head`.

use super::drawing::Drawing;

/// More arrows than this hide each other.
const MOST: usize = 120;
/// Half the width and the length of the head of an arrow (pixels).
const HEAD: (f64, f64) = (2.4, 6.0);

/// Evenly many of them, where there are too many.
pub(super) fn some_of<T>(arrows: &[T]) -> impl Iterator<Item = &T> {
    arrows.iter().step_by(arrows.len().div_ceil(MOST).max(1))
}

/// A line with a head, which shrinks with short arrows.
pub(super) fn draw(drawing: &mut Drawing, from: (f64, f64), to: (f64, f64)) {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let length = dx.hypot(dy);
    // what is shorter than a pixel shows no direction
    if length < 1.0 {
        return;
    }
    drawing.line("arrow", from, to);
    let shrunk = (length / (1.5 * HEAD.1)).min(1.0);
    let (along, across) = (HEAD.1 * shrunk / length, HEAD.0 * shrunk / length);
    let corner = |side: f64| (to.0 - along * dx - side * across * dy, to.1 - along * dy + side * across * dx);
    drawing.polyline("arrow-head", &[to, corner(1.0), corner(-1.0)], true);
}
