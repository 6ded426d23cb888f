//! How often errors of each size occur.

use super::axis::Axis;
use super::drawing::{Anchor, Drawing};
use super::finite_range;

const WIDTH: f64 = 860.0;
const LEFT: f64 = 80.0;
const RIGHT: f64 = 840.0;
const TOP: f64 = 30.0;
const BOTTOM: f64 = 230.0;

/// Non-negative values in bins from 0, with a mark at the mean; `None` without finite values.
pub(in super::super) fn histogram(values: &[f64], axis_label: &str, mean: (f64, &str)) -> Option<String> {
    let finite: Vec<f64> = values.iter().copied().filter(|value| value.is_finite()).collect();
    let (_, high) = finite_range(finite.iter().copied())?;
    let bins = ((finite.len() as f64).sqrt().ceil() as usize).clamp(5, 40);
    let x = Axis::linear(0.0, high, (LEFT, RIGHT), 8);
    let top_value = x.top();
    let mut counts = vec![0_usize; bins];
    for value in &finite {
        let bin = (value / top_value * bins as f64) as usize;
        counts[bin.min(bins - 1)] += 1;
    }
    let most = counts.iter().copied().max().unwrap_or(1);
    let mut drawing = Drawing::new(WIDTH, BOTTOM + 44.0, "Histogram of position errors");
    let y = Axis::counting(0.0, 1.08 * most as f64, (BOTTOM, TOP), 5);
    x.draw_below(&mut drawing, TOP, BOTTOM, axis_label);
    y.draw_left(&mut drawing, LEFT, RIGHT, "samples");
    let width = (RIGHT - LEFT) / bins as f64;
    for (bin, &count) in counts.iter().enumerate().filter(|(_, count)| **count > 0) {
        let upper = y.place(count as f64);
        drawing.rectangle("column", (LEFT + width * bin as f64, upper), (width - 1.0, BOTTOM - upper), None);
    }
    if mean.0.is_finite() {
        let at = x.place(mean.0);
        drawing.line("limit", (at, TOP - 4.0), (at, BOTTOM));
        let anchor = if at > 0.5 * (LEFT + RIGHT) { Anchor::End } else { Anchor::Start };
        drawing.text("tick", anchor, (at, TOP - 10.0), mean.1);
    }
    Some(drawing.finish())
}
