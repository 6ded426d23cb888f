//! Axes: from values to pixels, with ticks at round numbers.

use super::drawing::{Anchor, Drawing};
use crate::number_format as number;

/// How values are spaced.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Spacing {
    Linear,
    Logarithmic,
}

/// One axis.
pub(super) struct Axis {
    low: f64,
    high: f64,
    /// Pixels of `low` and `high`.
    pixels: (f64, f64),
    spacing: Spacing,
    ticks: Vec<(f64, String)>,
}

impl Axis {
    /// Evenly spaced over the values, widened to round numbers with about `count` ticks.
    pub(super) fn linear(low: f64, high: f64, pixels: (f64, f64), count: usize) -> Self {
        let (low, high) = widened(low, high);
        let step = round_step((high - low) / count.max(1) as f64);
        let (first, last) = ((low / step + 1e-9).floor(), (high / step - 1e-9).ceil());
        let mut axis = Self { low: first * step, high: last * step, pixels, spacing: Spacing::Linear, ticks: vec![] };
        axis.put_ticks(step);
        axis
    }

    /// Evenly spaced over exactly these values, with ticks at round numbers inside.
    pub(super) fn exact(low: f64, high: f64, pixels: (f64, f64), count: usize) -> Self {
        let (low, high) = widened(low, high);
        let mut axis = Self { low, high, pixels, spacing: Spacing::Linear, ticks: vec![] };
        axis.put_ticks(round_step((high - low) / count.max(1) as f64));
        axis
    }

    /// Over sample numbers: like [`Axis::exact`] with ticks at whole numbers.
    pub(super) fn counting(low: f64, high: f64, pixels: (f64, f64), count: usize) -> Self {
        let mut axis = Self { low, high: high.max(low + 1.0), pixels, spacing: Spacing::Linear, ticks: vec![] };
        axis.put_ticks(round_step((axis.high - low) / count.max(1) as f64).max(1.0));
        axis
    }

    fn put_ticks(&mut self, step: f64) {
        let decimals = (-(step * 1.000_001).log10().floor()).max(0.0) as i32;
        let (first, last) = ((self.low / step - 1e-9).ceil() as i64, (self.high / step + 1e-9).floor() as i64);
        let label = |value: f64| match decimals > 6 || value.abs() >= 1e6 {
            true => number::significant(value, 2),
            false => number::fixed(value, decimals),
        };
        self.ticks = (first..=last).map(|k| (k as f64 * step, label(k as f64 * step))).collect();
    }

    /// Spaced by ratio over positive values, widened to round numbers, with about `count` labels.
    pub(super) fn logarithmic(low: f64, high: f64, pixels: (f64, f64), count: usize) -> Self {
        let (first, last) = ((low.log10() + 1e-9).floor() as i32, (high.log10() - 1e-9).ceil() as i32);
        let last = last.max(first + 1);
        let mut ticks = Vec::new();
        if last - first <= 2 {
            // few decades: 1, 2, 5 as well, and the ends no farther than needed
            let steps = (first..=last).flat_map(|decade| [1.0, 2.0, 5.0].map(|m| (m, decade)));
            let all: Vec<(f64, String)> = steps
                .map(|(m, decade)| (m * 10_f64.powi(decade), number::significant(m * 10_f64.powi(decade), 1)))
                .collect();
            let below = all.iter().rposition(|tick| tick.0 <= low * 1.000_001).unwrap_or(0);
            let above = all.iter().position(|tick| tick.0 >= high * 0.999_999).unwrap_or(all.len() - 1);
            ticks = all[below..=above.max(below + 1).min(all.len() - 1)].to_vec();
        } else {
            let stride = ((last - first) as usize).div_ceil(count.max(1)).max(1);
            let decades = (first..=last).step_by(stride);
            ticks.extend(decades.map(|decade| (10_f64.powi(decade), number::power_of_ten(decade))));
        }
        let low = ticks.first().map_or(low, |tick| tick.0);
        let high = ticks.last().map_or(high, |tick| tick.0).max(high);
        Self { low, high, pixels, spacing: Spacing::Logarithmic, ticks }
    }

    /// Spaced by ratio over exactly these positive values, with ticks at the powers of ten inside.
    pub(super) fn exact_logarithmic(low: f64, high: f64, pixels: (f64, f64)) -> Self {
        let (first, last) = ((low.log10() - 1e-9).ceil() as i32, (high.log10() + 1e-9).floor() as i32);
        let ticks = (first..=last).map(|decade| (10_f64.powi(decade), number::power_of_ten(decade))).collect();
        Self { low, high: high.max(low * 1.01), pixels, spacing: Spacing::Logarithmic, ticks }
    }

    /// Logarithmic when the values span more than a factor 12, else linear from zero.
    pub(super) fn fitting(low: f64, high: f64, pixels: (f64, f64), count: usize) -> Self {
        match low > 0.0 && high > 12.0 * low {
            true => Self::logarithmic(low, high, pixels, count),
            false => Self::linear(0.0, high, pixels, count),
        }
    }

    /// True when values are spaced by ratio.
    pub(super) fn is_logarithmic(&self) -> bool {
        self.spacing == Spacing::Logarithmic
    }

    /// Pixel of a value; values outside lie on the end.
    pub(super) fn place(&self, value: f64) -> f64 {
        let share = match self.spacing {
            Spacing::Linear => (value - self.low) / (self.high - self.low),
            Spacing::Logarithmic => (value / self.low).log10() / (self.high / self.low).log10(),
        };
        // a logarithm of a number below zero lies beyond the low end
        let share = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) };
        self.pixels.0 + share * (self.pixels.1 - self.pixels.0)
    }

    /// True of a value between the ends.
    pub(super) fn holds(&self, value: f64) -> bool {
        (self.low..=self.high).contains(&value)
    }

    /// Draws it below a plot, with grid lines up to `top`.
    pub(super) fn draw_below(&self, drawing: &mut Drawing, top: f64, bottom: f64, label: &str) {
        for (value, text) in &self.ticks {
            let x = self.place(*value);
            drawing.line("grid", (x, top), (x, bottom));
            drawing.text("tick", Anchor::Middle, (x, bottom + 16.0), text);
        }
        drawing.line("axis", (self.pixels.0, bottom), (self.pixels.1, bottom));
        let middle = 0.5 * (self.pixels.0 + self.pixels.1);
        drawing.text("label", Anchor::Middle, (middle, bottom + 34.0), label);
    }

    /// Draws it left of a plot, with grid lines up to `right`.
    pub(super) fn draw_left(&self, drawing: &mut Drawing, left: f64, right: f64, label: &str) {
        for (value, text) in &self.ticks {
            let y = self.place(*value);
            drawing.line("grid", (left, y), (right, y));
            drawing.text("tick", Anchor::End, (left - 6.0, y + 4.0), text);
        }
        drawing.line("axis", (left, self.pixels.0), (left, self.pixels.1));
        if !label.is_empty() {
            let longest = self.ticks.iter().map(|tick| tick.1.chars().count()).max().unwrap_or(0);
            let middle = 0.5 * (self.pixels.0 + self.pixels.1);
            drawing.upright_text((left - 18.0 - 6.5 * longest as f64, middle), label);
        }
    }
}

/// Bounds that differ, whatever was given.
fn widened(low: f64, high: f64) -> (f64, f64) {
    if !(low.is_finite() && high.is_finite()) {
        return (0.0, 1.0);
    }
    let size = low.abs().max(high.abs());
    match high - low > 1e-9 * size {
        true => (low, high),
        false if size == 0.0 => (0.0, 1.0),
        false => (low - 0.1 * size, high + 0.1 * size),
    }
}

/// The next larger of 1, 2, 5 times a power of ten.
fn round_step(raw: f64) -> f64 {
    let power = 10_f64.powf(raw.log10().floor());
    let mantissa = [1.0, 2.0, 5.0].into_iter().find(|m| m * power >= raw * 0.999_999).unwrap_or(10.0);
    mantissa * power
}

/// Smallest and largest of the finite values.
pub(super) fn finite_range(values: impl IntoIterator<Item = f64>) -> Option<(f64, f64)> {
    let mut finite = values.into_iter().filter(|value| value.is_finite());
    let first = finite.next()?;
    Some(finite.fold((first, first), |(low, high), value| (low.min(value), high.max(value))))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|tick| tick.1.as_str()).collect()
    }

    #[test]
    fn ticks_are_round_and_cover_the_values() {
        assert_eq!(labels(&Axis::linear(0.0, 0.93, (0.0, 1.0), 5)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(&Axis::linear(-3.0, 7.0, (0.0, 1.0), 3)), ["−5", "0", "5", "10"]);
        assert_eq!(labels(&Axis::logarithmic(2e-3, 3e2, (0.0, 1.0), 8)).len(), 7);
        assert_eq!(labels(&Axis::logarithmic(1.6, 52.0, (0.0, 1.0), 8)), ["1", "2", "5", "10", "20", "50", "100"]);
    }

    #[test]
    fn any_values_give_an_axis_that_places_them_inside() {
        for (low, high) in [(0.0, 0.0), (5.0, 5.0), (f64::NAN, 1.0), (-1e-300, 1e-300), (-1e300, 1e300), (1e-30, 1e30)]
        {
            for axis in [Axis::linear(low, high, (10.0, 90.0), 5), Axis::fitting(low, high, (10.0, 90.0), 5)] {
                assert!(axis.ticks.len() < 40, "{low} {high}");
                for value in [low, high, 0.0, f64::INFINITY, f64::NAN] {
                    assert!((10.0..=90.0).contains(&axis.place(value)), "{low} {high} {value}");
                }
            }
        }
    }
}
