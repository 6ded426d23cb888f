//! Bar of the colours beside a plot, with numbers at their borders.

use super::colour;
use super::drawing::{Anchor, Drawing};

/// The bar of a plot.
pub(super) struct ColourBar<'a> {
    /// Left side of the bar, and its top and bottom.
    pub(super) left: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
    /// Values at its bottom and top.
    pub(super) ends: [f64; 2],
    /// Number of intervals between numbers.
    pub(super) intervals: u32,
    /// The number of a value.
    pub(super) number: &'a dyn Fn(f64) -> String,
    pub(super) label: &'a str,
    /// Distance of the label from the left side.
    pub(super) label_at: f64,
}

impl ColourBar<'_> {
    /// Intervals at the borders of colours, half as many in low plots.
    pub(super) fn intervals_of(height: f64) -> u32 {
        if height < 200.0 { 3 } else { 6 }
    }

    pub(super) fn draw(&self, drawing: &mut Drawing) {
        let Self { left, top, bottom, ends: [low, high], intervals, .. } = *self;
        let height = (bottom - top) / colour::COUNT as f64;
        for step in 0..colour::COUNT {
            let upper = bottom - height * (step + 1) as f64;
            drawing.rectangle("swatch", (left, upper), (14.0, height + 0.3), Some(colour::of_step(step)));
        }
        for tick in 0..=intervals {
            let share = f64::from(tick) / f64::from(intervals);
            let text = (self.number)(low + share * (high - low));
            drawing.text("tick", Anchor::Start, (left + 19.0, bottom - share * (bottom - top) + 4.0), &text);
        }
        drawing.upright_text((left + self.label_at, 0.5 * (bottom + top)), self.label);
    }
}
