//! Parameters over a penalty (Figs. 4.9, 4.32, 4.38), and the error on data held out below them.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::end_names;
use super::figure::Figure;
use crate::number_format::significant;

/// Path of a penalty, in units for people.
pub struct PathCurves {
    /// Unit of λ.
    pub unit: &'static str,
    /// Penalties above 0, from large to small.
    pub lambdas: Vec<f64>,
    /// Parameters off the centre at each.
    pub counts: Vec<usize>,
    /// Kind, name and changes (mm of cable) of every parameter.
    pub parameters: Vec<(String, String, Vec<f64>)>,
    /// Centre that changes are counted from.
    pub centre: &'static str,
    /// Validation errors with their standard errors; empty without.
    pub errors: Vec<(f64, f64)>,
    /// Words for the error with its unit.
    pub error_label: String,
    /// Places of the best and of the chosen error.
    pub marked: Option<[usize; 2]>,
}

const LEFT: f64 = 96.0;
const WIDTH: f64 = 560.0;
const TOP: f64 = 70.0;
const HEIGHTS: [f64; 2] = [300.0, 140.0];
const BETWEEN: f64 = 40.0;
/// Parameters that are named at the end of their curves.
const NAMED: usize = 10;
/// Looks of the curves of a kind.
pub(super) const STYLE: &str = include_str!("penalty_path.css");
/// Kinds with looks of their own.
const LOOKS: usize = 6;

impl PathCurves {
    /// The drawing; `None` without penalties.
    pub fn svg(&self) -> Option<Figure> {
        let (low, high) = finite_range(self.lambdas.iter().copied())?;
        let is_validated = self.errors.iter().any(|(error, _)| error.is_finite());
        let lower = if is_validated { BETWEEN + HEIGHTS[1] } else { 0.0 };
        let mut drawing =
            Drawing::new(LEFT + WIDTH + 190.0, TOP + HEIGHTS[0] + lower + 50.0, "Parameters over a penalty")
                .with_style(STYLE);
        // strong penalties left
        let x = Axis::exact_logarithmic(low, high, (LEFT + WIDTH, LEFT));
        let bottom = TOP + HEIGHTS[0];
        let label = format!("penalty λ in {}", self.unit);
        x.draw_below(&mut drawing, TOP, bottom, if is_validated { "" } else { &label });
        self.draw_counts(&mut drawing, &x);
        let kinds = self.draw_parameters(&mut drawing, &x)?;
        self.legend(&mut drawing, &kinds);
        if is_validated {
            let (top, bottom) = (bottom + BETWEEN, bottom + BETWEEN + HEIGHTS[1]);
            x.draw_below(&mut drawing, top, bottom, &label);
            self.draw_errors(&mut drawing, &x, (top, bottom))?;
        }
        if let Some([_, chosen]) = self.marked {
            let place = self.lambdas.get(chosen).map_or(LEFT + WIDTH, |&lambda| x.place(lambda));
            drawing.line("limit", (place, TOP), (place, bottom + lower));
        }
        Some(drawing.finish())
    }

    /// Number of parameters above the plot, where it changes and there is room.
    fn draw_counts(&self, drawing: &mut Drawing, x: &Axis) {
        drawing.text("tick", Anchor::End, (LEFT - 16.0, TOP - 12.0), "parameters");
        let mut last = (f64::NEG_INFINITY, usize::MAX);
        for (&lambda, &count) in self.lambdas.iter().zip(&self.counts) {
            let place = x.place(lambda);
            if count != last.1 && place - last.0 >= 26.0 {
                drawing.text("tick", Anchor::Middle, (place, TOP - 12.0), &count.to_string());
                last = (place, count);
            }
        }
    }

    /// Curves and names of the largest; the kinds in their order.
    fn draw_parameters(&self, drawing: &mut Drawing, x: &Axis) -> Option<Vec<&str>> {
        let all = self.parameters.iter().flat_map(|(_, _, changes)| changes.iter().copied());
        let (low, high) = finite_range(all.chain([0.0]))?;
        let y = Axis::linear(low, high, (TOP + HEIGHTS[0], TOP), 6);
        y.draw_left(drawing, LEFT, LEFT + WIDTH, &format!("change from {} in mm of cable", self.centre));
        drawing.line("zero", (LEFT, y.place(0.0)), (LEFT + WIDTH, y.place(0.0)));
        let mut kinds: Vec<&str> = Vec::new();
        for (kind, _, changes) in &self.parameters {
            let look = kinds.iter().position(|other| other == kind).unwrap_or_else(|| {
                kinds.push(kind);
                kinds.len() - 1
            });
            let points: Vec<(f64, f64)> =
                self.lambdas.iter().zip(changes).map(|(&lambda, &change)| (x.place(lambda), y.place(change))).collect();
            drawing.polyline(&format!("path kind-{}", look % LOOKS), &points, false);
        }
        self.draw_names(drawing, &y);
        Some(kinds)
    }

    /// Names of the parameters that end farthest from the centre, apart from each other.
    fn draw_names(&self, drawing: &mut Drawing, y: &Axis) {
        let end = |changes: &[f64]| changes.get(self.lambdas.len() - 1).copied().unwrap_or(0.0);
        let mut ends: Vec<(&str, f64)> =
            self.parameters.iter().map(|(_, name, changes)| (name.as_str(), end(changes))).collect();
        ends.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        ends.truncate(NAMED);
        ends.retain(|(_, change)| *change != 0.0);
        let ends = ends.into_iter().map(|(name, change)| (name, y.place(change))).collect();
        end_names::draw(drawing, LEFT + WIDTH, TOP, TOP + HEIGHTS[0], ends);
    }

    fn legend(&self, drawing: &mut Drawing, kinds: &[&str]) {
        let mut left = LEFT;
        for (look, kind) in kinds.iter().enumerate() {
            drawing.polyline(&format!("path key kind-{}", look % LOOKS), &[(left, 16.0), (left + 26.0, 16.0)], false);
            drawing.text("tick", Anchor::Start, (left + 32.0, 20.0), kind);
            left += 54.0 + 6.6 * kind.chars().count() as f64;
        }
        if self.marked.is_some() {
            drawing.line("limit", (left, 16.0), (left + 26.0, 16.0));
            drawing.text("tick", Anchor::Start, (left + 32.0, 20.0), "chosen: as good as the best");
            drawing.circle("dot bad", (left + 214.0, 16.0), 3.5, "");
            drawing.text("tick", Anchor::Start, (left + 222.0, 20.0), "least held-out error");
        }
    }

    fn draw_errors(&self, drawing: &mut Drawing, x: &Axis, (top, bottom): (f64, f64)) -> Option<()> {
        let ends = self.errors.iter().flat_map(|(error, deviation)| {
            let deviation = if deviation.is_finite() { *deviation } else { 0.0 };
            [error - deviation, error + deviation]
        });
        let (_, high) = finite_range(ends.clone())?;
        let (low, _) = finite_range(ends)?;
        let y = match high > 12.0 * low && low > 0.0 {
            true => Axis::logarithmic(low, high, (bottom, top), 4),
            false => Axis::linear(low, high, (bottom, top), 4),
        };
        y.draw_left(drawing, LEFT, LEFT + WIDTH, &self.error_label);
        let marked = self.marked.unwrap_or([usize::MAX; 2]);
        for (k, (&lambda, &(error, deviation))) in self.lambdas.iter().zip(&self.errors).enumerate() {
            if !error.is_finite() {
                continue;
            }
            let class = if marked[1] == k { "chosen" } else { "plain" };
            if deviation.is_finite() {
                let ends = [error - deviation, error + deviation].map(|value| (x.place(lambda), y.place(value)));
                drawing.line(&format!("bar {class}"), ends[0], ends[1]);
            }
            let words = format!("λ = {} {}: {}", significant(lambda, 3), self.unit, significant(error, 3));
            let class = if marked[0] == k && marked[1] != k { "bad" } else { class };
            drawing.circle(&format!("dot {class}"), (x.place(lambda), y.place(error)), 3.5, &words);
        }
        Some(())
    }
}
