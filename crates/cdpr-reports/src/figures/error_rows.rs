//! Errors of several models or stages: a row each, a panel for each kind of error.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::figure::Figure;
use crate::number_format::significant;

/// A kind of error.
pub struct ErrorPanel {
    /// Label of the axis, with its unit.
    pub label: String,
    /// Both series in the order of the rows; NaN where there is nothing.
    pub values: Vec<[f64; 2]>,
    /// Panel (from 0) whose axis this one has too, so that both can be compared.
    pub like: Option<usize>,
}

/// Rows of dots.
pub struct ErrorRows {
    /// Words for those who cannot see the figure.
    pub label: &'static str,
    /// Names of the rows.
    pub names: Vec<String>,
    /// Names of the series, the second of what stands beside; values of a series alone are written beside their dots.
    pub series: (&'static str, Option<&'static str>),
    /// Kinds of errors.
    pub panels: Vec<ErrorPanel>,
}

const WIDTH: f64 = 860.0;
/// Panels beside each other at most.
const ABREAST: usize = 3;
const GAP: f64 = 36.0;
/// Panels are no wider.
const MOST: f64 = 420.0;
const ROW: f64 = 22.0;
/// Below the rows: ticks, label, room to the next panels.
const BELOW: f64 = 62.0;
const LETTER: f64 = 6.2;
/// Longer names are cut.
const LETTERS: usize = 54;
/// Room for a value behind its dot.
const NUMBER: f64 = 44.0;
/// Looks and radii of the series: discs in rings where both are the same.
const OWN: (&str, f64) = ("dot chosen", 3.5);
const OTHER: (&str, f64) = ("dot bad", 5.5);

impl ErrorRows {
    /// `None` without rows or finite values.
    pub fn svg(&self) -> Option<Figure> {
        let panels: Vec<&ErrorPanel> = self.panels.iter().filter(|panel| panel.range().is_some()).collect();
        if panels.is_empty() || self.names.is_empty() {
            return None;
        }
        let longest = self.names.iter().map(|name| name.chars().count().min(LETTERS)).max().unwrap_or(0);
        let left = LETTER * longest as f64 + 16.0;
        let abreast = panels.len().min(ABREAST) as f64;
        let width = ((WIDTH - left - GAP) / abreast - GAP).min(MOST);
        let top = if self.series.1.is_some() { 34.0 } else { 10.0 };
        let tall = ROW * self.names.len() as f64;
        let height = top + (tall + BELOW) * panels.len().div_ceil(ABREAST) as f64 - 14.0;
        let mut drawing = Drawing::new(left + abreast * (width + GAP), height, self.label);
        self.draw_legend(&mut drawing, left);
        for (k, panel) in panels.iter().enumerate() {
            let top = top + (tall + BELOW) * (k / ABREAST) as f64;
            let start = left + (width + GAP) * (k % ABREAST) as f64;
            if k % ABREAST == 0 {
                self.draw_names(&mut drawing, left, top);
            }
            self.draw_panel(&mut drawing, panel, [start, start + width], top);
        }
        Some(drawing.finish())
    }

    /// Panel whose axis a panel has.
    fn group(&self, panel: &ErrorPanel) -> usize {
        let own = || self.panels.iter().position(|other| std::ptr::eq(other, panel));
        panel.like.or_else(own).unwrap_or(0)
    }

    fn draw_legend(&self, drawing: &mut Drawing, left: f64) {
        let (own, Some(other)) = self.series else { return };
        let beside = left + 40.0 + LETTER * own.chars().count() as f64;
        for (x, class, words) in [(left, OWN, own), (beside, OTHER, other)] {
            drawing.circle(class.0, (x + 6.0, 14.0), class.1, "");
            drawing.text("tick", Anchor::Start, (x + 16.0, 18.0), words);
        }
    }

    fn draw_names(&self, drawing: &mut Drawing, left: f64, top: f64) {
        for (row, name) in self.names.iter().enumerate() {
            let cut = name.chars().count() > LETTERS;
            let shown: String = name.chars().take(if cut { LETTERS - 1 } else { LETTERS }).collect();
            let shown = if cut { shown + "…" } else { shown };
            drawing.text("label", Anchor::End, (left - 10.0, middle(top, row) + 4.0), &shown);
        }
    }

    fn draw_panel(&self, drawing: &mut Drawing, panel: &ErrorPanel, [left, right]: [f64; 2], top: f64) {
        let is_like = |other: &&ErrorPanel| self.group(other) == self.group(panel);
        let ranges = || self.panels.iter().filter(is_like).filter_map(ErrorPanel::range);
        let Some((low, high)) = finite_range(ranges().flat_map(|(low, high)| [low, high])) else { return };
        let bottom = top + ROW * self.names.len() as f64;
        let end = if self.series.1.is_some() { right } else { right - NUMBER };
        let axis = Axis::fitting(low, high, (left, end), 3);
        let logarithmic = if axis.is_logarithmic() { ", log." } else { "" };
        axis.draw_below(drawing, top, bottom, &format!("{}{logarithmic}", panel.label));
        for (row, values) in panel.values.iter().enumerate() {
            let y = middle(top, row);
            drawing.line("grid", (left, y), (end, y));
            if values.iter().all(|value| !value.is_finite()) {
                drawing.text("tick", Anchor::Start, (left + 4.0, y + 4.0), "none");
            }
            // the series of interest above the other
            let series = [(values[1], OTHER, self.series.1), (values[0], OWN, Some(self.series.0))];
            for (value, (class, radius), name) in series.into_iter().filter(|(value, ..)| value.is_finite()) {
                let number = significant(value, 3);
                let words = format!("{}, {}: {number}", self.names[row], name.unwrap_or_default());
                drawing.circle(class, (axis.place(value), y), radius, &words);
                if self.series.1.is_none() {
                    drawing.text("tick", Anchor::Start, (axis.place(value) + 8.0, y + 4.0), &number);
                }
            }
        }
    }
}

impl ErrorPanel {
    fn range(&self) -> Option<(f64, f64)> {
        finite_range(self.values.iter().flatten().copied())
    }
}

fn middle(top: f64, row: usize) -> f64 {
    top + ROW * (row as f64 + 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rows(values: Vec<[f64; 2]>, other: Option<&'static str>) -> ErrorRows {
        let names = (0..values.len()).map(|k| format!("stage {k}")).collect();
        let panels = vec![ErrorPanel { label: "error in mm".to_owned(), values, like: None }];
        ErrorRows { label: "Errors", names, series: ("ours", other), panels }
    }

    #[test]
    fn every_value_has_a_dot_and_what_is_missing_is_said() {
        let body = rows(vec![[1.5, 2.0], [3.25, f64::NAN], [f64::NAN; 2]], Some("printed")).svg().unwrap().body;
        assert_eq!(body.matches("<title>stage").count(), 3, "{body}");
        assert!(body.contains("stage 1, ours: 3.25") && body.contains("stage 0, printed: 2.00"), "{body}");
        assert_eq!(body.matches(">none<").count(), 1, "{body}");
        let alone = rows(vec![[1.5, f64::NAN]], None).svg().unwrap().body;
        assert!(alone.contains(">1.50<"), "{alone}");
        assert!(rows(vec![[f64::NAN; 2]], None).svg().is_none() && rows(Vec::new(), None).svg().is_none());
    }
}
