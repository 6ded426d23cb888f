//! Doubts about a response: limits of its record, before its figures.

use super::{Banded, Model, Root, Solution};
use crate::verdict::{Doubt, DoubtKind};

/// Part of the excited frequencies that has to be trusted.
const TRUSTED: f64 = 0.5;
/// Mean square of residuals above which a model does not explain its points.
const MISFIT: f64 = 2.0;
/// Part of the cut-off by which its interval may end beside it.
const WIDE: f64 = 0.1;
/// Width of a resonance in resolutions from which on it is told from a sharper one.
const RESOLVED: f64 = 1.0;
/// Distance of a zero from a pole, as a part of the pole's, within which it may cancel it.
const BESIDE: f64 = 0.3;
/// Distance within which it does, however well both are known.
const TOUCHING: f64 = 0.02;
/// Blur of windows that is worth a word.
const BLURRED: f64 = 0.01;

impl Solution {
    /// Finds doubts and remarks; figures that are not to be trusted are taken out.
    pub(super) fn judge(&mut self) {
        let mut doubts: Vec<Doubt> = self.coherence_doubt().into_iter().collect();
        match &self.model {
            None => doubts.push(self.no_model()),
            Some(model) => {
                doubts.extend(self.band_doubt());
                doubts.extend(self.resolution_doubt(model));
                doubts.extend(model.doubts());
                doubts.extend(self.cutoff.and_then(wide_doubt));
            }
        }
        doubts.sort_by_key(|doubt| std::cmp::Reverse(doubt.finding.severity));
        self.doubts = doubts;
        if self.verdict().is_negative() {
            (self.cutoff, self.peak) = (None, None);
        }
        self.remarks = self.told();
    }

    fn coherence_doubt(&self) -> Option<Doubt> {
        let (limit, share) = (self.coherence_limit, self.trusted_share);
        let words = format!(
            "not to be trusted: the coherence reaches {limit} over {:.0} % of the excited frequencies (on a logarithmic scale), and half of them is needed: input and \
             output are not those of one linear machine, or noise hides the output; drive with more amplitude, or longer",
            100.0 * share
        );
        (share < TRUSTED).then(|| Doubt::new(DoubtKind::Coherence, words))
    }

    fn no_model(&self) -> Doubt {
        let trusted = self.points.iter().filter(|point| point.is_trusted).count();
        let words = format!(
            "no model: {trusted} of {} points have a coherence of {} or more, {:.3} Hz apart, of which every second one is independent, and 8 of these are needed: the record of {:.1} s is too \
             short, excites too few frequencies, or is too noisy",
            self.points.len(),
            self.coherence_limit,
            self.resolution,
            self.duration
        );
        Doubt::new(DoubtKind::Band, words)
    }

    /// A gain that does not fall by 3 dB where it can be told.
    fn band_doubt(&self) -> Option<Doubt> {
        let ([first, last], reference) = (self.band?, self.reference_gain?);
        let model = self.model.as_ref().filter(|_| self.cutoff.is_none())?;
        let level = 20.0 * (model.transfer.response(last).norm() / reference.value).log10();
        let words = format!(
            "no cut-off: at {last:.2} Hz, the highest frequency of trusted coherence, the gain is {level:+.1} dB against that at {first:.2} Hz, and it is nowhere below −3 dB: the \
             cut-off lies above; excite higher frequencies, or with more amplitude there"
        );
        Some(Doubt::new(DoubtKind::Band, words))
    }

    /// A resonance sharper than the record resolves.
    fn resolution_doubt(&self, model: &Model) -> Option<Doubt> {
        let [first, last] = self.band?;
        let inside =
            model.poles.iter().filter(|pole| pole.value.im > 0.0 && (first..=last).contains(&pole.frequency()));
        let width = |pole: &&Root| 2.0 * pole.damping().abs() * pole.frequency();
        let sharpest = inside.min_by(|a, b| width(a).total_cmp(&width(b)))?;
        let width = width(&sharpest);
        let words = format!(
            "the record is too short: the resonance at {:.2} Hz is {width:.3} Hz wide and frequencies are told apart from {:.3} Hz on; longer windows (now {:.1} s) of a longer record are needed, {:.1} s or more",
            sharpest.frequency(),
            self.resolution,
            1.0 / self.resolution,
            8.0 / width,
        );
        (width < RESOLVED * self.resolution && self.windows > 0).then(|| Doubt::new(DoubtKind::Band, words))
    }

    fn told(&self) -> Vec<String> {
        let mut told = Vec::new();
        told.extend(self.jitter.map(|jitter| {
            format!(
                "rows lie up to {:.1} % of a step beside an even grid of {:.6} s: input and output were interpolated onto it, linearly",
                100.0 * jitter / self.step,
                self.step
            )
        }));
        let marked = self.points.iter().filter(|point| !point.is_trusted).count();
        if marked > 0 {
            told.push(format!(
                "{marked} of {} points have a coherence below {}: they weigh little, and tell neither band nor cut-off",
                self.points.len(),
                self.coherence_limit
            ));
        }
        if self.blur > BLURRED {
            told.push(format!(
                "windows of {:.2} s blur the response by up to {:.1} % of its gain: points have the blur, the model does not",
                1.0 / self.resolution,
                100.0 * self.blur
            ));
        }
        told.extend(self.model.iter().flat_map(Model::told));
        told
    }
}

/// A cut-off that lies anywhere.
fn wide_doubt(cutoff: Banded) -> Option<Doubt> {
    let [low, high] = cutoff.band();
    let words = format!(
        "the cut-off is known to no better than {:.2} Hz (95 %: {low:.2} to {high:.2} Hz): record longer, or with more amplitude around it",
        cutoff.value
    );
    ((high - low) > 2.0 * WIDE * cutoff.value).then(|| Doubt::new(DoubtKind::Shape, words))
}

impl Model {
    fn doubts(&self) -> Vec<Doubt> {
        let mut doubts = Vec::new();
        let mut add = |kind: DoubtKind, words: String| doubts.push(Doubt::new(kind, words));
        if !self.converged {
            add(DoubtKind::NotConverged, "the fit of the model ended before its optimum".to_owned());
        }
        if !(self.misfit <= MISFIT) {
            add(
                DoubtKind::Shape,
                format!(
                    "the model is {:.1} standard deviations of its points from them (root mean square, 1 is expected): the machine has more poles than were allowed, or is not linear; \
                     bands are widened by this factor",
                    self.misfit.sqrt()
                ),
            );
        }
        for pole in self.poles.iter().filter(|pole| pole.value.im >= 0.0 && pole.value.re >= 0.0) {
            add(
                DoubtKind::Shape,
                format!(
                    "unstable: a pole at {:+.3} ± {:.3} rad/s (real part, one standard deviation), {:.2} Hz: the machine was held by a controller while it was recorded, or the model \
                     follows noise",
                    pole.value.re,
                    pole.sigma[0],
                    pole.frequency()
                ),
            );
        }
        if let Some(delay) = self.delay.filter(|delay| delay.value < -2.0 * delay.sigma) {
            add(
                DoubtKind::Shape,
                format!(
                    "the output leads the input by {:.2} ± {:.2} ms: are columns exchanged, or clocks shifted?",
                    -1e3 * delay.value,
                    1e3 * delay.sigma
                ),
            );
        }
        for (pole, zero) in self.cancelled() {
            add(
                DoubtKind::Shape,
                format!(
                    "the pole at {:.2} Hz and the zero at {:.2} Hz lie within their uncertainty and cancel: the record does not tell whether there are any; fewer poles explain it alike",
                    pole.frequency(),
                    zero.frequency()
                ),
            );
        }
        doubts
    }

    /// Poles with zeros that lie beside them within three standard deviations, or touch them.
    fn cancelled(&self) -> Vec<(Root, Root)> {
        let size = |root: &Root| root.sigma[0].hypot(root.sigma[1]);
        let is_near = |pole: &Root, zero: &Root| {
            let distance = (pole.value - zero.value).norm();
            let is_within = distance < 3.0 * size(pole).hypot(size(zero)) && distance < BESIDE * pole.value.norm();
            is_within || distance < TOUCHING * pole.value.norm()
        };
        let upper = |roots: &[Root]| roots.iter().copied().filter(|root| root.value.im >= 0.0).collect::<Vec<Root>>();
        let zeros = upper(&self.zeros);
        let partner = |pole: Root| zeros.iter().find(|zero| is_near(&pole, zero)).map(|zero| (pole, *zero));
        upper(&self.poles).into_iter().filter_map(partner).collect()
    }

    fn told(&self) -> Vec<String> {
        let mut told = Vec::new();
        for zero in self.zeros.iter().filter(|zero| zero.value.im >= 0.0 && zero.value.re > 0.0) {
            told.push(format!(
                "not of minimum phase: a zero on the right, at {:+.3} ± {:.3} rad/s, {:.2} Hz; a controller cannot take its delay back",
                zero.value.re,
                zero.sigma[0],
                zero.frequency()
            ));
        }
        if !self.alternatives.is_empty() {
            let name = |one: &super::Alternative| format!("{} (criterion {:+.1})", one.orders, one.difference);
            let names: Vec<String> = self.alternatives.iter().take(4).map(name).collect();
            told.push(format!(
                "the record does not tell {} from {}: differences of the criterion below 2 decide nothing",
                self.transfer.orders(),
                names.join(", ")
            ));
        }
        told
    }
}
