//! Quantities over time: panels above each other with one axis of time, events and broken limits marked through all of them.

use super::axis::{Axis, finite_range};
use super::colour::CABLES;
use super::drawing::{Anchor, Drawing};
use super::end_names;
use super::figure::Figure;

/// Curves over time that share a unit.
pub struct TimePanel {
    /// Quantity of the curves.
    pub title: String,
    /// Label of the upright axis, with its unit.
    pub label: String,
    /// Curves with their names, a value for each time.
    pub curves: Vec<(String, Vec<f64>)>,
    /// Heights of limits.
    pub limits: Vec<f64>,
}

/// Panels over time.
pub struct Timeline<'a> {
    /// Contents in words.
    pub label: &'a str,
    /// Times of all values (s), ascending.
    pub times: &'a [f64],
    /// Panels from top to bottom.
    pub panels: Vec<TimePanel>,
    /// Times of events (s), numbered from 1.
    pub events: &'a [f64],
    /// Stretches of time (s) to mark.
    pub marked: &'a [(f64, f64)],
}

const LEFT: f64 = 92.0;
const RIGHT: f64 = 700.0;
const TOP: f64 = 40.0;
const HEIGHT: f64 = 150.0;
/// From the top of one panel to that of the next.
const PITCH: f64 = 200.0;
/// Room for names behind the curves.
const NAMES: f64 = 120.0;
/// Looks of the curves.
pub(super) const STYLE: &str = include_str!("timeline.css");
/// Parts of the time of which a curve keeps its least and its largest value.
const PARTS: usize = 500;

impl Timeline<'_> {
    /// The drawing; `None` without two times.
    pub fn svg(&self) -> Option<Figure> {
        let (first, last) = finite_range(self.times.iter().copied()).filter(|(first, last)| first < last)?;
        let bottom = TOP + PITCH * (self.panels.len().max(1) - 1) as f64 + HEIGHT;
        let ends = format!("{LEFT} {RIGHT} {TOP} {bottom} {first} {last}");
        let mut drawing =
            Drawing::new(RIGHT + NAMES, bottom + 46.0, self.label).with_style(STYLE).with_attribute("time", &ends);
        let x = Axis::exact(first, last, (LEFT, RIGHT), 8);
        for (index, panel) in self.panels.iter().enumerate() {
            let top = TOP + PITCH * index as f64;
            let name = if index + 1 == self.panels.len() { "time in s" } else { "" };
            self.draw(&mut drawing, panel, &x, (top, name));
        }
        for (number, &time) in self.events.iter().enumerate() {
            drawing.line("limit", (x.place(time), TOP - 6.0), (x.place(time), bottom));
            drawing.text("tick", Anchor::Middle, (x.place(time), TOP - 24.0), &format!("{}", number + 1));
        }
        Some(drawing.finish())
    }

    fn draw(&self, drawing: &mut Drawing, panel: &TimePanel, x: &Axis, (top, name): (f64, &str)) {
        let bottom = top + HEIGHT;
        for &(from, to) in self.marked {
            let width = (x.place(to) - x.place(from)).max(1.0);
            drawing.rectangle("violated", (x.place(from), top), (width, HEIGHT), None);
        }
        drawing.text("panel", Anchor::Start, (LEFT, top - 10.0), &panel.title);
        x.draw_below(drawing, top, bottom, name);
        let values = panel.curves.iter().flat_map(|(_, values)| values.iter().copied());
        let Some((low, high)) = finite_range(values.chain(panel.limits.iter().copied())) else { return };
        let y = Axis::linear(low, high, (bottom, top), 4);
        y.draw_left(drawing, LEFT, RIGHT, &panel.label);
        for &limit in &panel.limits {
            drawing.line("limit", (LEFT, y.place(limit)), (RIGHT, y.place(limit)));
        }
        let mut ends = Vec::new();
        for (look, (name, values)) in panel.curves.iter().enumerate() {
            let points: Vec<(f64, f64)> = extremes(self.times, values, PARTS)
                .into_iter()
                .map(|(time, value)| (x.place(time), y.place(value)))
                .collect();
            ends.extend(points.last().map(|end| (name.as_str(), end.1)));
            drawing.polyline(&format!("over-time cable-{}", 1 + look % CABLES.len()), &points, false);
        }
        end_names::draw(drawing, RIGHT, top, bottom, ends);
    }
}

/// Values with their times; of many only the least and the largest of each part of the time, so that no peak is lost.
fn extremes(times: &[f64], values: &[f64], parts: usize) -> Vec<(f64, f64)> {
    let finite = times.iter().copied().zip(values.iter().copied()).filter(|(_, value)| value.is_finite());
    let all: Vec<(f64, f64)> = finite.collect();
    if all.len() <= 2 * parts {
        return all;
    }
    let part = |range: &[(f64, f64)]| {
        let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
        let mut pair: Vec<(f64, f64)> =
            range.iter().min_by(by_value).into_iter().chain(range.iter().max_by(by_value)).copied().collect();
        pair.sort_by(|a, b| a.0.total_cmp(&b.0));
        pair.dedup();
        pair
    };
    all.chunks(all.len().div_ceil(parts)).flat_map(part).chain(all.last().copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_peak_of_a_long_record_is_lost() {
        let times: Vec<f64> = (0..60_000).map(|k| 1e-3 * f64::from(k)).collect();
        let values: Vec<f64> = (0..60_000).map(|k| if k == 31_415 { 7.0 } else { f64::from(k % 3) }).collect();
        let kept = extremes(&times, &values, 500);
        assert!(kept.len() <= 1001, "{}", kept.len());
        assert!(kept.contains(&(31.415, 7.0)) && kept.last() == Some(&(59.999, 2.0)));
        assert!(kept.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    }

    #[test]
    fn one_moment_is_no_course_and_two_are() {
        let panel = || TimePanel {
            title: "Tensions".to_owned(),
            label: "tension in N".to_owned(),
            curves: vec![("1".to_owned(), vec![5.0, 6.0])],
            limits: vec![1.0],
        };
        let of = |times: &[f64]| {
            Timeline { label: "a", times, panels: vec![panel()], events: &[0.5], marked: &[(0.1, 0.2)] }.svg()
        };
        assert!(of(&[0.0]).is_none());
        let text = of(&[0.0, 1.0]).unwrap().inline();
        assert!(text.contains("data-time=\"92 700 40 190 0 1\"") && text.contains("class=\"violated\""), "{text}");
    }
}
