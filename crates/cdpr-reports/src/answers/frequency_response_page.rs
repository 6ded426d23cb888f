//! The page of a frequency response: gain, phase and coherence with the model and its band, poles and zeros.

use cdpr_calibration::frequency_response::{CurvePoint, Point, Solution};
use minijinja::{Value, context};
use std::f64::consts::TAU;

use super::frequency_response_answer::FrequencyResponseAnswer;
use super::frequency_response_words::{ROOT_COLUMNS, figures, gain_unit, model_words, root_rows};
use crate::figures::{Bode, BodeCurve, BodePoint, Figure};
use crate::html_page::{Page, PageError, PageKind, plain, prose};
use crate::number_format::significant;

const TEMPLATE: &str = include_str!("frequency_response.html");

/// Half the width of a 95 % interval in standard deviations.
const WIDTH: f64 = 1.959_964;

impl FrequencyResponseAnswer {
    /// The page; `command` makes it again.
    pub fn page(&self, command: &str, version: &str) -> Result<String, PageError> {
        let row = |cells: &Vec<String>| context! { cells => cells.iter().map(|cell| prose(cell)).collect::<Vec<_>>() };
        let model = self.solution.model.as_ref();
        let values = context! {
            headline => prose(&self.headline()),
            of => prose(&self.heading()),
            words => figures(self).iter().map(|words| prose(words)).collect::<Vec<_>>(),
            figure => self.figure().map(|figure| Value::from_safe_string(figure.inline())),
            model => model.map(|model| prose(&model_words(model))),
            columns => ROOT_COLUMNS,
            rows => model.map(|model| root_rows(model).iter().map(row).collect::<Vec<Value>>()).unwrap_or_default(),
            warnings => self.warnings().list().iter().map(|words| prose(words)).collect::<Vec<_>>(),
            command => plain(command),
        };
        let title = "Frequency response";
        Page { kind: PageKind::Response, title, class: "wide", template: TEMPLATE, values, data: None, version }
            .render()
    }

    fn headline(&self) -> String {
        match (&self.reason, self.solution.cutoff) {
            (Some(reason), _) => reason.clone(),
            (None, Some(cutoff)) => {
                let [low, high] = cutoff.band().map(|end| significant(end, 4));
                format!("Cut-off at {} Hz (95 %: {low} to {high} Hz)", significant(cutoff.value, 4))
            }
            (None, None) => "No cut-off".to_owned(),
        }
    }

    /// Gain, phase and coherence; `None` without two points.
    fn figure(&self) -> Option<Figure> {
        let solution = &self.solution;
        let curve = unwound(solution);
        let points: Vec<BodePoint> = solution.points.iter().map(|point| bode_point(point, &curve)).collect();
        let marks: Vec<(f64, String)> = solution
            .cutoff
            .iter()
            .map(|cutoff| (cutoff.value, format!("−3 dB: {} Hz", significant(cutoff.value, 4))))
            .collect();
        let gain_label = format!("gain in {}", gain_unit(&self.input, &self.output));
        let label = "Gain, phase and coherence over frequency";
        let limit = solution.coherence_limit;
        Bode { label, gain_label: &gain_label, points: &points, curve: &curve, marks: &marks, limit }.svg()
    }
}

/// The model's curve with a phase that does not jump.
fn unwound(solution: &Solution) -> Vec<BodeCurve> {
    let mut before = 0.0;
    let mut one = |point: &CurvePoint| {
        let phase = near(point.response.arg(), before);
        before = phase;
        BodeCurve {
            frequency: point.frequency,
            gain: (point.response.norm(), WIDTH * point.gain_sigma),
            phase: (phase.to_degrees(), WIDTH * point.phase_sigma.to_degrees()),
        }
    };
    solution.model.iter().flat_map(|model| &model.curve).map(&mut one).collect()
}

/// The phase (rad) by whole turns near another one.
fn near(phase: f64, other: f64) -> f64 {
    phase - TAU * ((phase - other) / TAU).round()
}

/// A point whose phase is by whole turns near that of the curve.
fn bode_point(point: &Point, curve: &[BodeCurve]) -> BodePoint {
    let distance = |one: &&BodeCurve| (one.frequency / point.frequency).ln().abs();
    let beside = curve.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).map_or(0.0, |one| one.phase.0);
    let sigma = point.sigma / point.gain();
    BodePoint {
        frequency: point.frequency,
        gain: (point.gain(), WIDTH * point.sigma),
        phase: (near(point.phase(), beside.to_radians()).to_degrees(), WIDTH * sigma.to_degrees()),
        coherence: point.coherence,
        is_trusted: point.is_trusted,
    }
}
