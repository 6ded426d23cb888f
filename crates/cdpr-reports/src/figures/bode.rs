//! Gain, phase and coherence over frequency, with a fitted curve and its band.

use super::axis::{Axis, finite_range};
use super::drawing::{Anchor, Drawing};
use super::figure::Figure;

const WIDTH: f64 = 760.0;
const LEFT: f64 = 80.0;
const RIGHT: f64 = 730.0;
const TOP: f64 = 30.0;
const HEIGHT: f64 = 190.0;
/// From the top of one panel to that of the next.
const PITCH: f64 = 245.0;
/// Height of the panel of the coherence.
const LOW: f64 = 90.0;

/// Estimate at one frequency.
pub struct BodePoint {
    /// Frequency (Hz).
    pub frequency: f64,
    /// Gain, and half the width of its interval.
    pub gain: (f64, f64),
    /// Phase (°), and half the width of its interval.
    pub phase: (f64, f64),
    /// Coherence, 0 to 1.
    pub coherence: f64,
    /// Drawn full; others are open.
    pub is_trusted: bool,
}

/// Fitted curve at one frequency.
pub struct BodeCurve {
    /// Frequency (Hz).
    pub frequency: f64,
    /// Gain, and half the width of its interval.
    pub gain: (f64, f64),
    /// Phase (°), and half the width of its interval.
    pub phase: (f64, f64),
}

/// The picture.
pub struct Bode<'a> {
    /// Contents in words.
    pub label: &'a str,
    /// Label of the gain, with its unit.
    pub gain_label: &'a str,
    /// Estimates, ascending.
    pub points: &'a [BodePoint],
    /// Fitted curve, ascending; empty for none.
    pub curve: &'a [BodeCurve],
    /// Frequencies to mark (Hz), with words.
    pub marks: &'a [(f64, String)],
    /// Coherence from which on points are trusted.
    pub limit: f64,
}

/// A value with half the width of its interval.
type Ranged = (f64, f64);

impl Bode<'_> {
    /// The drawing; `None` without two frequencies or without a gain.
    pub fn svg(&self) -> Option<Figure> {
        let frequencies = self.points.iter().map(|point| point.frequency).filter(|frequency| *frequency > 0.0);
        let (first, last) = finite_range(frequencies).filter(|(first, last)| first < last)?;
        let gains = self.points.iter().map(|point| point.gain.0).chain(self.curve.iter().map(|one| one.gain.0));
        let (least, most) = finite_range(gains.filter(|gain| *gain > 0.0))?;
        let phases = self.points.iter().filter(|point| point.is_trusted).map(|point| point.phase.0);
        let phases = finite_range(phases.chain(self.curve.iter().map(|one| one.phase.0))).unwrap_or((-180.0, 180.0));
        let [gain_top, phase_top, low_top] = [0.0, 1.0, 2.0].map(|panel| TOP + PITCH * panel);
        let bottom = low_top + LOW;
        let mut drawing = Drawing::new(WIDTH, bottom + 46.0, self.label);
        let x = Axis::logarithmic(first, last, (LEFT, RIGHT), 8);
        let gain = Axis::logarithmic(least, most, (gain_top + HEIGHT, gain_top), 5);
        let phase = Axis::linear(phases.0, phases.1, (phase_top + HEIGHT, phase_top), 5);
        let coherence = Axis::exact(0.0, 1.0, (bottom, low_top), 2);
        for (top, height, y, label) in [
            (gain_top, HEIGHT, &gain, self.gain_label),
            (phase_top, HEIGHT, &phase, "phase in °"),
            (low_top, LOW, &coherence, "coherence"),
        ] {
            x.draw_below(&mut drawing, top, top + height, if top == low_top { "frequency in Hz" } else { "" });
            y.draw_left(&mut drawing, LEFT, RIGHT, label);
        }
        for (frequency, words) in self.marks {
            let at = x.place(*frequency);
            drawing.line("limit", (at, gain_top), (at, phase_top + HEIGHT));
            drawing.text("tick", Anchor::Middle, (at, gain_top - 8.0), words);
        }
        let limit = coherence.place(self.limit);
        drawing.line("limit", (LEFT, limit), (RIGHT, limit));
        self.draw_curve(&mut drawing, &x, &gain, |one| one.gain);
        self.draw_curve(&mut drawing, &x, &phase, |one| one.phase);
        self.draw_points(&mut drawing, &x, &gain, |point| point.gain);
        self.draw_points(&mut drawing, &x, &phase, |point| point.phase);
        self.draw_points(&mut drawing, &x, &coherence, |point| (point.coherence, 0.0));
        Some(drawing.finish())
    }

    fn draw_curve(&self, drawing: &mut Drawing, x: &Axis, y: &Axis, of: impl Fn(&BodeCurve) -> Ranged) {
        let edge = |one: &BodeCurve, side: f64| (x.place(one.frequency), y.place(of(one).0 + side * of(one).1));
        let upper = self.curve.iter().map(|one| edge(one, 1.0));
        let lower = self.curve.iter().rev().map(|one| edge(one, -1.0));
        let band: Vec<(f64, f64)> = upper.chain(lower).collect();
        let line: Vec<(f64, f64)> = self.curve.iter().map(|one| edge(one, 0.0)).collect();
        if line.len() > 1 {
            drawing.polyline("band", &band, true);
            drawing.polyline("curve", &line, false);
        }
    }

    fn draw_points(&self, drawing: &mut Drawing, x: &Axis, y: &Axis, of: impl Fn(&BodePoint) -> Ranged) {
        for point in self.points.iter().filter(|point| of(point).0.is_finite() && point.frequency > 0.0) {
            let (value, width) = of(point);
            let at = x.place(point.frequency);
            if width > 0.0 && point.is_trusted {
                drawing.line("bar plain", (at, y.place(value - width)), (at, y.place(value + width)));
            }
            let (class, radius) = if point.is_trusted { ("dot plain", 2.0) } else { ("dot open", 2.0) };
            drawing.circle(class, (at, y.place(value)), radius, "");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_curve_and_marks_are_drawn_and_one_frequency_is_no_picture() {
        let point = |frequency: f64| BodePoint {
            frequency,
            gain: (1.0 / frequency, 0.01),
            phase: (-frequency, 1.0),
            coherence: 0.9,
            is_trusted: frequency < 5.0,
        };
        let curve = |frequency: f64| BodeCurve { frequency, gain: (1.0 / frequency, 0.01), phase: (-frequency, 1.0) };
        let (points, curves) = ([1.0, 2.0, 10.0].map(point), [1.0, 10.0].map(curve));
        let marks = [(2.0, "cut-off".to_owned())];
        let of = |points: &[BodePoint]| {
            Bode { label: "a", gain_label: "gain", points, curve: &curves, marks: &marks, limit: 0.5 }.svg()
        };
        let text = of(&points).unwrap().file();
        for (part, count) in [("dot plain", 6), ("dot open", 3), ("class=\"band\"", 2), (">cut-off<", 1)] {
            assert_eq!(text.matches(part).count(), count, "{part}: {text}");
        }
        assert!(of(&points[..1]).is_none());
    }
}
