//! Shares of a workspace over a parameter, one curve for each required accuracy.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::figure::Figure;

const WIDTH: f64 = 860.0;
const LEFT: f64 = 80.0;
const RIGHT: f64 = 740.0;
const TOP: f64 = 20.0;
const BOTTOM: f64 = 330.0;
/// Least distance of the names at the ends of the curves.
const LINE: f64 = 15.0;

/// Looks of the curves, in turn.
const TONES: [&str; 6] = ["tone-1", "tone-2", "tone-3", "tone-4", "tone-5", "tone-6"];

/// One curve with its name.
pub struct ShareCurve {
    /// Stands at the end of the curve.
    pub name: String,
    /// Value of the parameter and share.
    pub points: Vec<(f64, f64)>,
}

/// All curves.
pub struct Shares {
    /// The parameter with its unit.
    pub parameter: String,
    /// Curves in the order of their names.
    pub curves: Vec<ShareCurve>,
}

impl Shares {
    /// `None` for fewer than two points.
    pub fn svg(&self) -> Option<Figure> {
        let all = || self.curves.iter().flat_map(|curve| curve.points.iter());
        let (low, high) = finite_range(all().map(|point| point.0)).filter(|(low, high)| low < high)?;
        let top = all().map(|point| point.1).fold(0.0, f64::max);
        let mut drawing = Drawing::new(WIDTH, BOTTOM + 44.0, "Share of the physical workspace that is reached");
        let is_wide = low > 0.0 && high > 12.0 * low;
        let x = match is_wide {
            true => Axis::logarithmic(low, high, (LEFT, RIGHT), 10),
            false => Axis::exact(low, high, (LEFT, RIGHT), 10),
        };
        let y = Axis::linear(0.0, 100.0 * top.max(0.01), (BOTTOM, TOP), 6);
        x.draw_below(&mut drawing, TOP, BOTTOM, &self.parameter);
        y.draw_left(&mut drawing, LEFT, RIGHT, "reached share of the physical workspace (%)");
        let place = |&(value, share): &(f64, f64)| (x.place(value), y.place(100.0 * share));
        let mut names = Vec::new();
        for (index, curve) in self.curves.iter().enumerate() {
            let points: Vec<(f64, f64)> = curve.points.iter().map(place).collect();
            let tone = TONES[index % TONES.len()];
            drawing.polyline(&format!("curve {tone}"), &points, false);
            names.extend(points.last().map(|end| (*end, &curve.name, tone)));
        }
        // names from top to bottom, none over another and none below the plot; looser accuracies above tighter ones
        names[1..].reverse();
        names.sort_by(|a, b| a.0.1.total_cmp(&b.0.1));
        let mut lines: Vec<f64> = names.iter().map(|name| name.0.1).collect();
        for index in 1..lines.len() {
            lines[index] = lines[index].max(lines[index - 1] + LINE);
        }
        let mut below = BOTTOM + LINE;
        for line in lines.iter_mut().rev() {
            *line = line.min(below - LINE);
            below = *line;
        }
        for ((end, name, tone), line) in names.into_iter().zip(lines) {
            drawing.line(&format!("curve thin {tone}"), end, (RIGHT + 14.0, line));
            drawing.text("label", Anchor::Start, (RIGHT + 18.0, line + 4.0), name);
        }
        Some(drawing.finish())
    }
}
