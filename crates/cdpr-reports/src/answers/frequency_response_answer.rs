//! Frequency response of a record, with the transfer function fitted to it.

use cdpr_calibration::Verdict;
use cdpr_calibration::frequency_response::{Alternative, Banded, Model, Point, Root, Solution};
use cdpr_calibration::selection::Warnings;
use cdpr_model::reading::Keyword;
use schemars::JsonSchema;
use serde::Serialize;

use super::identification_words::reason_of;
use crate::keys::WarningKeys;

/// Response at one frequency.
#[derive(Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "keys carry their units")]
#[schemars(rename = "ResponsePoint")]
struct PointAnswer {
    /// Frequency (Hz).
    frequency_Hz: f64,
    /// Gain (output's unit per input's unit).
    gain: f64,
    /// Phase (rad), −π to π; negative where the output is late.
    phase_rad: f64,
    /// Share of the output's power that the input explains, 0 to 1.
    coherence: f64,
    /// Standard deviation of the gain.
    gain_sigma: f64,
    /// Standard deviation of the phase (rad).
    phase_sigma_rad: f64,
    /// False where the coherence is below `coherence_limit`.
    trusted: bool,
}

/// Pole or zero.
#[derive(Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "keys carry their units")]
#[schemars(rename = "Root")]
struct RootAnswer {
    /// Real part (rad/s); negative for a stable pole.
    real_rad_per_s: f64,
    /// Imaginary part (rad/s).
    imaginary_rad_per_s: f64,
    /// Natural frequency (Hz).
    frequency_Hz: f64,
    /// Damping ratio; negative on the right of the imaginary axis.
    damping: f64,
}

/// Standard deviations of a pole or zero.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "RootSigma")]
struct RootSigma {
    /// Of the real part (rad/s).
    real_rad_per_s: f64,
    /// Of the imaginary part (rad/s); 0 for a real one.
    imaginary_rad_per_s: f64,
}

/// Standard deviations of a transfer function.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "TransferSigma")]
struct SigmaAnswer {
    /// Of the gain.
    gain: f64,
    /// Of the delay (s); null where the function has none.
    delay_s: Option<f64>,
    /// Of the poles, in their order.
    poles: Vec<RootSigma>,
    /// Of the zeros.
    zeros: Vec<RootSigma>,
}

/// Orders that the record does not tell from those of the model.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "OtherOrders")]
struct AlternativeAnswer {
    /// Number of poles.
    poles: usize,
    /// Number of zeros.
    zeros: usize,
    /// Whether there is a delay.
    delay: bool,
    /// Schwarz's criterion less that of the model.
    criterion_difference: f64,
}

/// Transfer function: gain · exp(−s·delay) · ∏(1 − s/zero) / ∏(1 − s/pole).
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "TransferFunction")]
struct ModelAnswer {
    /// Gain at zero frequency (output's unit per input's unit), extrapolated below the band.
    gain: f64,
    /// Delay (s); 0 where the record tells none.
    delay_s: f64,
    /// Poles, slowest first.
    poles: Vec<RootAnswer>,
    /// Zeros, slowest first.
    zeros: Vec<RootAnswer>,
    /// Standard deviations.
    sigma: SigmaAnswer,
    /// Root of the mean square of the residuals in standard deviations; about 1 where the function explains the points.
    misfit: f64,
    /// Orders that the record does not tell from these.
    alternatives: Vec<AlternativeAnswer>,
}

/// Frequency response of a record.
#[derive(Serialize, JsonSchema)]
#[expect(non_snake_case, reason = "keys carry their units")]
#[schemars(rename = "FrequencyResponse")]
pub struct FrequencyResponseAnswer {
    status: &'static str,
    /// False where nobody should work with the figures; the warnings say why.
    trusted: bool,
    #[serde(skip)]
    pub(super) verdict: Verdict,
    /// Reason of a negative answer.
    pub(super) reason: Option<String>,
    /// File of the record.
    record: String,
    /// Column of the input.
    pub(super) input: String,
    /// Column of the output.
    pub(super) output: String,
    /// h1 or sine.
    pub(super) method: &'static str,
    /// Number of samples.
    samples: usize,
    /// Length of the record (s).
    duration_s: f64,
    /// Number of samples in a second (Hz).
    sample_rate_Hz: f64,
    /// Number of windows averaged; null for a stepped sine.
    windows: Option<usize>,
    /// Distance of frequencies that are told apart (Hz).
    resolution_Hz: f64,
    /// Least coherence of a trusted point.
    coherence_limit: f64,
    /// Part of the excited frequencies, on a logarithmic scale, that are trusted.
    trusted_share: f64,
    /// Lowest and highest trusted frequency (Hz); null without trusted points.
    band_Hz: Option<[f64; 2]>,
    /// Lowest trusted frequency (Hz), whose gain cut-off and peak are told against.
    reference_frequency_Hz: Option<f64>,
    /// Gain of the model there.
    reference_gain: Option<f64>,
    /// First frequency (Hz) with a gain 3 dB below the reference; null where the record does not tell it.
    cutoff_Hz: Option<f64>,
    /// Interval of the cut-off (Hz), 95 %.
    cutoff_band_Hz: Option<[f64; 2]>,
    /// Largest gain of the model in the band; null as for the cut-off.
    peak_gain: Option<f64>,
    /// Interval of the peak's gain, 95 %.
    peak_gain_band: Option<[f64; 2]>,
    /// Frequency of the peak (Hz); null where the gain does not fall to both sides within the band.
    peak_frequency_Hz: Option<f64>,
    /// Interval of the peak's frequency (Hz), 95 %.
    peak_frequency_band_Hz: Option<[f64; 2]>,
    /// Fitted transfer function; null where points are too few.
    model: Option<ModelAnswer>,
    /// Response at the frequencies that the input excites.
    points: Vec<PointAnswer>,
    /// File of the page.
    report: Option<String>,
    #[serde(flatten, with = "WarningKeys")]
    #[schemars(with = "WarningKeys")]
    warnings: Warnings,
    #[serde(skip)]
    pub(super) solution: Solution,
}

impl FrequencyResponseAnswer {
    /// Response of a record of a name with so many samples, between two columns.
    pub fn new(solution: Solution, record: String, samples: usize, input: String, output: String) -> Self {
        let warnings = Warnings { doubts: solution.doubts.clone(), remarks: solution.remarks.clone() };
        let verdict = solution.verdict();
        let (value, band) = (|one: Banded| one.value, |one: Banded| one.band());
        let peak_frequency = solution.peak.and_then(|peak| peak.frequency);
        Self {
            status: verdict.fit_status(),
            trusted: verdict.is_trusted(),
            verdict,
            reason: reason_of(verdict, &warnings.doubts),
            record,
            input,
            output,
            method: solution.method.name(),
            samples,
            duration_s: solution.duration,
            sample_rate_Hz: 1.0 / solution.step,
            windows: Some(solution.windows).filter(|windows| *windows > 0),
            resolution_Hz: solution.resolution,
            coherence_limit: solution.coherence_limit,
            trusted_share: solution.trusted_share,
            band_Hz: solution.band,
            reference_frequency_Hz: solution.band.map(|band| band[0]),
            reference_gain: solution.reference_gain.map(value),
            cutoff_Hz: solution.cutoff.map(value),
            cutoff_band_Hz: solution.cutoff.map(band),
            peak_gain: solution.peak.map(|peak| peak.gain.value),
            peak_gain_band: solution.peak.map(|peak| peak.gain.band()),
            peak_frequency_Hz: peak_frequency.map(value),
            peak_frequency_band_Hz: peak_frequency.map(band),
            model: solution.model.as_ref().map(ModelAnswer::of),
            points: solution.points.iter().map(PointAnswer::of).collect(),
            report: None,
            warnings,
            solution,
        }
    }

    /// The answer with the file of its page.
    pub fn with_report(self, report: Option<String>) -> Self {
        Self { report, ..self }
    }

    /// Name of the record, and what was made of it.
    pub(super) fn heading(&self) -> String {
        let way = match self.windows {
            Some(windows) => format!("{windows} windows of {:.2} s", 1.0 / self.resolution_Hz),
            None => format!("{} steps of a sine", self.points.len()),
        };
        format!(
            "{}: {} to {}, {} samples in {:.1} s ({:.0} Hz), {way}",
            self.record, self.input, self.output, self.samples, self.duration_s, self.sample_rate_Hz
        )
    }

    pub(super) fn warnings(&self) -> &Warnings {
        &self.warnings
    }
}

impl PointAnswer {
    fn of(point: &Point) -> Self {
        Self {
            frequency_Hz: point.frequency,
            gain: point.gain(),
            phase_rad: point.phase(),
            coherence: point.coherence,
            gain_sigma: point.sigma,
            phase_sigma_rad: point.sigma / point.gain(),
            trusted: point.is_trusted,
        }
    }
}

impl ModelAnswer {
    fn of(model: &Model) -> Self {
        let roots = |roots: &[Root]| roots.iter().map(RootAnswer::of).collect();
        let sigmas = |roots: &[Root]| {
            let sigma = |root: &Root| RootSigma { real_rad_per_s: root.sigma[0], imaginary_rad_per_s: root.sigma[1] };
            roots.iter().map(sigma).collect()
        };
        let alternative = |one: &Alternative| AlternativeAnswer {
            poles: one.orders.poles,
            zeros: one.orders.zeros,
            delay: one.orders.has_delay,
            criterion_difference: one.difference,
        };
        Self {
            gain: model.gain.value,
            delay_s: model.delay.map_or(0.0, |delay| delay.value),
            poles: roots(&model.poles),
            zeros: roots(&model.zeros),
            sigma: SigmaAnswer {
                gain: model.gain.sigma,
                delay_s: model.delay.map(|delay| delay.sigma),
                poles: sigmas(&model.poles),
                zeros: sigmas(&model.zeros),
            },
            misfit: model.misfit.sqrt(),
            alternatives: model.alternatives.iter().map(alternative).collect(),
        }
    }
}

impl RootAnswer {
    fn of(root: &Root) -> Self {
        Self {
            real_rad_per_s: root.value.re,
            imaginary_rad_per_s: root.value.im,
            frequency_Hz: root.frequency(),
            damping: root.damping(),
        }
    }
}
