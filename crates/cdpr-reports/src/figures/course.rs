//! Course of a fit: panels of curves over its steps.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::end_names;
use super::figure::Figure;

/// Curves over the steps of a fit that share a unit.
pub struct CoursePanel {
    /// Quantity of the curves.
    pub title: String,
    /// Label of the upright axis, with its unit.
    pub label: String,
    /// Curves with their names.
    pub curves: Vec<(String, Vec<f64>)>,
    /// Kind of the upright axis.
    pub height: CourseHeight,
}

/// Kind of a panel's upright axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CourseHeight {
    /// Changes from zero, all curves with one look.
    Change,
    /// Sizes, by ratio where they differ much.
    Size,
    /// Values in the range that they take.
    Value,
}

const PANEL: (f64, f64) = (270.0, 140.0);
/// From the corner of one panel to that of the next.
const PITCH: (f64, f64) = (470.0, 226.0);
const CORNER: (f64, f64) = (84.0, 36.0);
const COLUMNS: usize = 2;
/// Room for names behind the last panel of a row.
const NAMES: f64 = 100.0;
/// Curves of a panel that are named, those that end farthest from zero.
const NAMED: usize = 4;

/// Panels over the steps of a fit from the start on; `None` without a step.
pub fn course(panels: &[CoursePanel]) -> Option<Figure> {
    over_steps(panels, "Course of the fit", "step")
}

/// Panels over the rounds of a campaign from the controller before the first on; `None` without a round.
pub fn rounds(panels: &[CoursePanel]) -> Option<Figure> {
    over_steps(panels, "Course of the campaign", "round")
}

fn over_steps(panels: &[CoursePanel], label: &str, step: &str) -> Option<Figure> {
    let steps = panels.iter().flat_map(|panel| &panel.curves).map(|(_, values)| values.len()).max()?;
    if steps < 2 {
        return None;
    }
    let rows = panels.len().div_ceil(COLUMNS);
    let size = (CORNER.0 + PITCH.0 + PANEL.0 + NAMES, CORNER.1 + PITCH.1 * (rows - 1) as f64 + PANEL.1 + 48.0);
    let mut drawing = Drawing::new(size.0, size.1, label).with_style(super::penalty_path::STYLE);
    for (k, panel) in panels.iter().enumerate() {
        let left = CORNER.0 + PITCH.0 * (k % COLUMNS) as f64;
        let top = CORNER.1 + PITCH.1 * (k / COLUMNS) as f64;
        panel.draw(&mut drawing, (left, top), (steps - 1, step));
    }
    Some(drawing.finish())
}

impl CoursePanel {
    fn draw(&self, drawing: &mut Drawing, (left, top): (f64, f64), (last, step): (usize, &str)) {
        let (right, bottom) = (left + PANEL.0, top + PANEL.1);
        drawing.text("panel", Anchor::Start, (left, top - 14.0), &self.title);
        let x = Axis::counting(0.0, last as f64, (left, right), 10);
        x.draw_below(drawing, top, bottom, step);
        let values = self.curves.iter().flat_map(|(_, values)| values.iter().copied());
        let is_change = self.height == CourseHeight::Change;
        let Some((low, high)) = finite_range(values.chain(is_change.then_some(0.0))) else {
            drawing.text("tick", Anchor::Middle, (0.5 * (left + right), 0.5 * (top + bottom)), "not a finite number");
            return;
        };
        let y = match self.height {
            CourseHeight::Size => Axis::fitting(low, high, (bottom, top), 4),
            _ => Axis::linear(low, high, (bottom, top), 5),
        };
        y.draw_left(drawing, left, right, &self.label);
        if is_change {
            drawing.line("zero", (left, y.place(0.0)), (right, y.place(0.0)));
        }
        for (look, (_, values)) in self.curves.iter().enumerate() {
            let finite = values.iter().enumerate().filter(|(_, value)| value.is_finite());
            let points: Vec<(f64, f64)> = finite.map(|(step, &value)| (x.place(step as f64), y.place(value))).collect();
            let look = if is_change { 0 } else { look };
            drawing.polyline(&format!("path kind-{look}"), &points, false);
        }
        let end = |values: &[f64]| values.last().copied().filter(|value| value.is_finite());
        let mut ends: Vec<(&str, f64)> =
            self.curves.iter().filter_map(|(name, values)| Some((name.as_str(), end(values)?))).collect();
        ends.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
        ends.truncate(NAMED);
        let ends = ends.into_iter().filter(|(name, value)| !name.is_empty() && *value != 0.0);
        end_names::draw(drawing, right, top, bottom, ends.map(|(name, value)| (name, y.place(value))).collect());
    }
}
