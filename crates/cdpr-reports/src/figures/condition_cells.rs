//! Condition over the scales of two kinds of parameters (Fig. 4.12): cells coloured by the power of ten.

use super::axis::{Axis, finite_range};
use super::colour;
use super::colour_bar::ColourBar;
use super::drawing::{Anchor, Drawing, Rectangle};
use super::figure::Figure;
use crate::number_format::condition;

/// Map of a condition.
pub struct ConditionCells {
    /// Labels of both scales.
    pub labels: [String; 2],
    /// Scales with the condition, the first running fastest, by equal ratios.
    pub cells: Vec<([f64; 2], f64)>,
    /// Scales that are marked.
    pub marked: Option<[f64; 2]>,
    /// Words for the mark.
    pub words: &'static str,
}

const LEFT: f64 = 92.0;
const TOP: f64 = 40.0;
const SIDE: f64 = 360.0;

impl ConditionCells {
    /// The chart; `None` without cells.
    pub fn svg(&self) -> Option<Figure> {
        let finite = || self.cells.iter().filter(|(_, value)| value.is_finite());
        let ranges = [0, 1].map(|axis| finite_range(self.cells.iter().map(|(at, _)| at[axis])));
        let [Some(first), Some(second)] = ranges else { return None };
        let (low, high) = finite_range(finite().map(|(_, value)| value.log10()))?;
        let count = (self.cells.len() as f64).sqrt().round().max(2.0);
        // half a cell beyond the outer ones
        let beyond = |(low, high): (f64, f64)| {
            let half = (high / low).powf(0.5 / (count - 1.0));
            (low / half, high * half)
        };
        let (first, second) = (beyond(first), beyond(second));
        let x = Axis::exact_logarithmic(first.0, first.1, (LEFT, LEFT + SIDE));
        let y = Axis::exact_logarithmic(second.0, second.1, (TOP + SIDE, TOP));
        let mut drawing = Drawing::new(LEFT + SIDE + 130.0, TOP + SIDE + 50.0, "Condition over two scales");
        let size = SIDE / count;
        let shade = |value: f64| colour::step_of(value.log10() - low, high - low);
        for step in 0..colour::COUNT {
            let own = finite().filter(|(_, value)| shade(*value) == step);
            let corner = |at: &[f64; 2]| (x.place(at[0]) - 0.5 * size, y.place(at[1]) - 0.5 * size);
            // overlaps hide seams
            let all: Vec<Rectangle> = own.map(|(at, _)| (corner(at), (size + 0.4, size + 0.4))).collect();
            if !all.is_empty() {
                drawing.rectangles("cell", colour::of_step(step), &all);
            }
        }
        x.draw_below(&mut drawing, TOP + SIDE, TOP + SIDE, &self.labels[0]);
        y.draw_left(&mut drawing, LEFT, LEFT, &self.labels[1]);
        self.mark(&mut drawing, &x, &y);
        let bar = ColourBar {
            left: LEFT + SIDE + 26.0,
            top: TOP,
            bottom: TOP + SIDE,
            ends: [low, high],
            intervals: 5,
            number: &|power| condition(10_f64.powf(power)),
            label: "condition",
            label_at: 88.0,
        };
        bar.draw(&mut drawing);
        Some(drawing.finish())
    }

    /// The least cell, and the scales asked for.
    fn mark(&self, drawing: &mut Drawing, x: &Axis, y: &Axis) {
        let least = self.cells.iter().filter(|(_, value)| value.is_finite()).min_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((at, value)) = least {
            let words = format!("least of the map: {}", condition(*value));
            drawing.circle("dot bad", (LEFT + 6.0, 16.0), 4.0, "");
            drawing.text("tick", Anchor::Start, (LEFT + 14.0, 20.0), &words);
            drawing.circle("dot bad", (x.place(at[0]), y.place(at[1])), 4.0, &words);
        }
        if let Some(at) = self.marked {
            drawing.circle("dot chosen", (LEFT + 186.0, 16.0), 3.0, "");
            drawing.text("tick", Anchor::Start, (LEFT + 194.0, 20.0), self.words);
            drawing.circle("dot chosen", (x.place(at[0]), y.place(at[1])), 3.0, self.words);
        }
    }
}
