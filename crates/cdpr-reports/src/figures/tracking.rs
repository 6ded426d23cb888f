//! Commanded and emerging tension of every cable over the poses of a path, and their difference below, as small multiples on one scale each.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::figure::Figure;

pub(super) const STYLE: &str = include_str!("tracking.css");

const COLUMNS: usize = 2;
const PANEL: (f64, f64) = (350.0, 96.0);
/// Height of the differences below a panel, and the gap between.
const DIFFERENCE: (f64, f64) = (58.0, 12.0);
/// From the corner of one panel to that of the next.
const PITCH: (f64, f64) = (425.0, 222.0);
const CORNER: (f64, f64) = (72.0, 54.0);
/// Length of a sample line in the legend.
const SAMPLE: f64 = 30.0;

/// Tensions of one cable (N), each with the number of its pose.
pub struct TrackedCable {
    /// Name of the cable.
    pub name: String,
    /// Commanded by the control model.
    pub commanded: Vec<(usize, f64)>,
    /// Emerging on the machine.
    pub emerging: Vec<(usize, f64)>,
}

impl TrackedCable {
    /// Emerging less commanded tension at the poses that have both.
    fn differences(&self) -> Vec<(usize, f64)> {
        let wanted = |pose: usize| self.commanded.iter().find(|point| point.0 == pose).map(|point| point.1);
        let difference = |&(pose, tension): &(usize, f64)| Some((pose, tension - wanted(pose)?));
        self.emerging.iter().filter_map(difference).collect()
    }
}

/// Tensions of every cable with their difference below, the commanded ones dashed; `None` without finite values.
pub fn tension_tracking(cables: &[TrackedCable]) -> Option<Figure> {
    let all = || cables.iter().flat_map(|cable| cable.commanded.iter().chain(&cable.emerging));
    let (low, high) = finite_range(all().map(|point| point.1))?;
    let (first, last) = finite_range(all().map(|point| point.0 as f64))?;
    let differences: Vec<Vec<(usize, f64)>> = cables.iter().map(TrackedCable::differences).collect();
    let largest = finite_range(differences.iter().flatten().map(|point| point.1.abs()))?.1.max(LEAST_DIFFERENCE);
    let rows = cables.len().div_ceil(COLUMNS);
    let height = CORNER.1 + PITCH.1 * rows as f64 - 10.0;
    let width = CORNER.0 + PITCH.0 * (cables.len().min(COLUMNS) - 1) as f64 + PANEL.0 + 16.0;
    let mut drawing = Drawing::new(width, height, "Commanded and emerging tensions by cable").with_style(STYLE);
    legend(&mut drawing);
    for (index, (cable, differences)) in cables.iter().zip(&differences).enumerate() {
        let left = CORNER.0 + PITCH.0 * (index % COLUMNS) as f64;
        let top = CORNER.1 + PITCH.1 * (index / COLUMNS) as f64;
        let (right, bottom) = (left + PANEL.0, top + PANEL.1);
        let x = Axis::counting(first, last, (left, right), 5);
        let y = Axis::linear(low, high, (bottom, top), 4);
        y.draw_left(&mut drawing, left, right, "tension in N");
        drawing.text("panel", Anchor::Start, (left, top - 7.0), &format!("cable {}", cable.name));
        curve(&mut drawing, "curve wanted", (&x, &y), &cable.commanded);
        curve(&mut drawing, "curve", (&x, &y), &cable.emerging);
        let (top, bottom) = (bottom + DIFFERENCE.1, bottom + DIFFERENCE.1 + DIFFERENCE.0);
        let y = Axis::linear(-largest, largest, (bottom, top), 3);
        let is_last = index + COLUMNS >= cables.len();
        x.draw_below(&mut drawing, top, bottom, if is_last { "pose" } else { "" });
        y.draw_left(&mut drawing, left, right, "apart in N");
        drawing.line("zero", (left, y.place(0.0)), (right, y.place(0.0)));
        curve(&mut drawing, "curve", (&x, &y), differences);
    }
    Some(drawing.finish())
}

/// Differences below this are rounding, and drawn as none (N).
const LEAST_DIFFERENCE: f64 = 0.1;

fn curve(drawing: &mut Drawing, class: &str, (x, y): (&Axis, &Axis), series: &[(usize, f64)]) {
    for run in runs(series) {
        let points: Vec<(f64, f64)> = run.iter().map(|&(pose, value)| (x.place(pose as f64), y.place(value))).collect();
        match points[..] {
            [alone] => drawing.circle("speck", alone, 1.8, ""),
            _ => drawing.polyline(class, &points, false),
        }
    }
}

/// Stretches of poses that follow each other: nothing is drawn across a pose without an answer.
fn runs(series: &[(usize, f64)]) -> impl Iterator<Item = &[(usize, f64)]> {
    series.chunk_by(|before, after| after.0 == before.0 + 1)
}

fn legend(drawing: &mut Drawing) {
    let mut left = CORNER.0;
    for (class, name) in [("curve wanted", "commanded"), ("curve", "emerging")] {
        drawing.polyline(class, &[(left, 18.0), (left + SAMPLE, 18.0)], false);
        drawing.text("", Anchor::Start, (left + SAMPLE + 8.0, 22.0), name);
        left += SAMPLE + 110.0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_pose_without_an_answer_breaks_the_line() {
        let series = [(1, 10.0), (2, 11.0), (4, 12.0), (5, 13.0), (6, 14.0)];
        let lengths: Vec<usize> = runs(&series).map(<[_]>::len).collect();
        assert_eq!(lengths, [2, 3]);
        let cable = |emerging: &[(usize, f64)]| TrackedCable {
            name: "1".to_owned(),
            commanded: series.to_vec(),
            emerging: emerging.to_vec(),
        };
        let lines = |figure: Figure| figure.file().matches("<path class=\"curve").count();
        // two lines of the legend, two of what is commanded, two of what emerges, two of the difference
        assert_eq!(lines(tension_tracking(&[cable(&series)]).unwrap()), 8);
        assert!(tension_tracking(&[]).is_none());
    }
}
