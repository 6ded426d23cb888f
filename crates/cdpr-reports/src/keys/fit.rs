//! Fits: parameters, what the data tell of them, and the way to the optimum.

use cdpr_calibration::fit::{Estimate, Fit, ShiftEstimate};
use cdpr_calibration::{
    ActiveSample, Analysis, Certificate, Correlation, FrameEstimate, Gauge, Loss, Outlier, RecordingFrames,
    StartOptimum, Starts, StoppedBy,
};
use cdpr_model::reading::Keyword;
use schemars::JsonSchema;
use serde::Serialize;

use super::adapters::{keys, nullable_numbers, tables};
use super::{Each, Maybe, Word};

/// Identified parameter.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Estimate")]
#[schemars(rename = "Estimate", transform = nullable_numbers)]
pub(crate) struct EstimateKeys {
    /// Name, e.g. `frame-anchor[1].x`.
    name: String,
    /// Unit of the numbers; empty for a ratio.
    unit: &'static str,
    /// Value of the robot as given; null where its file states none.
    nominal: Option<f64>,
    /// Value before the fit.
    start: f64,
    value: f64,
    /// Standard deviation; null where the data do not determine it.
    sigma: Option<f64>,
    /// Value minus start.
    change: f64,
    /// Standard deviation of the prior.
    prior_sigma: Option<f64>,
    at_bound: bool,
}

/// Rank and condition of the Jacobian.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Analysis")]
#[schemars(rename = "Determination", transform = nullable_numbers)]
struct DeterminationKeys {
    rank: usize,
    /// Singular values in SI units, from large to small (eq. 4.23).
    singular_values: Vec<f64>,
    condition: f64,
    /// Condition with columns of length one.
    condition_scaled: f64,
    /// Directions in parameter space that the data leave open or nearly so.
    weak_directions: Vec<String>,
    weak_direction_count: usize,
    #[serde(rename = "weak_direction_deviation_m")]
    weak_deviation: f64,
}

/// Sample beyond 8 robust standard deviations.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Outlier")]
#[schemars(rename = "Outlier")]
pub(crate) struct OutlierKeys {
    /// Number in the data, from 1.
    sample: usize,
    /// Line of the file, from 1.
    line: Option<usize>,
    residual_m: f64,
    /// Weight that the loss leaves to it.
    weight: f64,
    reason: String,
}

/// Frame with its standard deviations.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "FrameEstimate")]
#[schemars(rename = "FrameEstimate")]
struct FrameKeys {
    position_m: [f64; 3],
    rotation_rad: [f64; 3],
    quaternion_xyzw: [f64; 4],
    sigma_position_m: [f64; 3],
    sigma_rotation_rad: [f64; 3],
}

/// Freedom that the data leave of the frames, and what fixes it.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Gauge")]
#[schemars(rename = "Gauge")]
struct GaugeKeys {
    kind: &'static str,
    free: Vec<&'static str>,
    directions: usize,
}

/// Frames of tracker and marker.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "RecordingFrames")]
#[schemars(rename = "RecordingFrames")]
pub(crate) struct RecordingFrameKeys {
    #[serde(rename = "tracker_frame", with = "Maybe::<FrameKeys>", skip_serializing_if = "Option::is_none")]
    tracker: Option<FrameEstimate>,
    #[serde(rename = "marker_frame", with = "Maybe::<FrameKeys>", skip_serializing_if = "Option::is_none")]
    marker: Option<FrameEstimate>,
    #[serde(with = "GaugeKeys")]
    gauge: Gauge,
}

/// Change of a cable's recorded lengths inside the record.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "ShiftEstimate")]
#[schemars(rename = "LengthShift")]
pub(crate) struct ShiftKeys {
    /// Name, e.g. `length-offset[3]@52` or `length-drift[3]`.
    #[serde(getter = "shift_name")]
    parameter: String,
    /// Cable, counted from 1.
    #[serde(getter = "shift_cable")]
    cable: usize,
    /// Line of the data file from which on lengths are changed, the header being line 1; null of a drift.
    #[serde(getter = "ShiftEstimate::line")]
    line: Option<usize>,
    /// Change of the recorded length, after the line less before it, or over the record.
    #[serde(rename = "change_m")]
    change: f64,
    #[serde(rename = "sigma_m")]
    sigma: f64,
    #[serde(getter = "ShiftEstimate::offset_before")]
    length_offset_before_m: f64,
    /// Length offset that the calibrated robot has.
    #[serde(rename = "length_offset_after_m")]
    offset_after: f64,
    /// Speed of a drift; null of a step, or where rows have no times.
    #[serde(getter = "ShiftEstimate::rate")]
    rate_m_per_s: Option<f64>,
}

fn shift_name(estimate: &ShiftEstimate) -> String {
    estimate.shift.to_string()
}

fn shift_cable(estimate: &ShiftEstimate) -> usize {
    estimate.shift.cable + 1
}

/// Parameters of a fit with what the data tell of them.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Fit")]
#[schemars(rename = "Estimates", transform = nullable_numbers)]
struct EstimatesKeys {
    reason: String,
    iterations: u32,
    #[serde(with = "Each::<EstimateKeys>")]
    parameters: Vec<Estimate>,
    #[serde(flatten, with = "DeterminationKeys")]
    analysis: Analysis,
    /// Residuals in units of the sensor accuracies.
    noise_factor: f64,
    /// Weighted sum of squares after each step.
    history: Vec<f64>,
}

/// Keys of a fit in the list of candidates: loss, starts, outliers, frames and clock.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Fit")]
#[schemars(rename = "CandidateFit")]
pub(crate) struct CandidateFitKeys {
    #[serde(flatten, getter = "itself", with = "EstimatesKeys")]
    estimates: Fit,
    #[serde(getter = "parameter_count")]
    parameter_count: usize,
    #[serde(with = "Word")]
    loss: Loss,
    #[serde(with = "Each::<OutlierKeys>")]
    outliers: Vec<Outlier>,
    /// How late poses are recorded, where the offset of the clocks was free.
    #[serde(getter = "clock_offset", skip_serializing_if = "Option::is_none")]
    clock_offset_s: Option<f64>,
    #[serde(flatten, with = "Maybe::<RecordingFrameKeys>")]
    #[schemars(with = "Option<RecordingFrameKeys>")]
    frames: Option<RecordingFrames>,
    /// Changes of recorded lengths inside the record, where they were free.
    #[serde(rename = "length_shifts", with = "Each::<ShiftKeys>", skip_serializing_if = "Vec::is_empty")]
    shifts: Vec<ShiftEstimate>,
}

/// Fit without measured poses.
#[derive(Serialize)]
#[serde(remote = "Fit")]
pub(crate) struct PoselessFitKeys {
    #[serde(flatten, getter = "itself", with = "EstimatesKeys")]
    estimates: Fit,
    #[serde(flatten, with = "SeparationKeys")]
    analysis: Analysis,
    #[serde(with = "StoppedByKeys")]
    stopped_by: StoppedBy,
    #[serde(with = "StartsKeys")]
    starts: Starts,
}

/// Fit of one model.
#[derive(Serialize)]
#[serde(remote = "Fit")]
pub(crate) struct FitKeys {
    #[serde(flatten, getter = "itself", with = "CandidateFitKeys")]
    of_candidate: Fit,
    #[serde(flatten, with = "SeparationKeys")]
    analysis: Analysis,
    #[serde(with = "StoppedByKeys")]
    stopped_by: StoppedBy,
    #[serde(with = "StartsKeys")]
    starts: Starts,
    /// Norm of a sample's residuals from which on it counts less; null for least squares.
    loss_threshold: f64,
    #[serde(getter = "clock_offset_sigma", skip_serializing_if = "Option::is_none")]
    clock_offset_sigma_s: Option<f64>,
    /// Proof of the least largest error.
    #[serde(with = "Maybe::<CertificateKeys>", skip_serializing_if = "Option::is_none")]
    certificate: Option<Certificate>,
}

fn itself(fit: &Fit) -> &Fit {
    fit
}

fn parameter_count(fit: &Fit) -> usize {
    fit.parameters.len()
}

fn clock_offset(fit: &Fit) -> Option<f64> {
    fit.clock_offset.map(|clock| clock.seconds)
}

fn clock_offset_sigma(fit: &Fit) -> Option<f64> {
    fit.clock_offset.map(|clock| clock.sigma)
}

tables!(
    EstimateKeys: Estimate,
    OutlierKeys: Outlier,
    FrameKeys: FrameEstimate,
    RecordingFrameKeys: RecordingFrames,
    ShiftKeys: ShiftEstimate,
);

keys! {
    /// Two parameters that the data hardly separate.
    CorrelationKeys of Correlation { first, second, coefficient }
    /// Strongly correlated parameters, and the half width of 95 % intervals.
    SeparationKeys of Analysis { correlations by Each<CorrelationKeys>, quantile_95 }
    /// End of a search by a rule.
    StoppedByKeys of StoppedBy { rule.name(), value, limit }
    /// Optima that the starts of a fit led to.
    StartsKeys of Starts { count, unconverged, ranges, optima by Each<StartOptimumKeys> }
    /// Optimum that some of the starts led to.
    StartOptimumKeys of StartOptimum { cost, starts, fraction = "share", spread_m, distance_m }
    /// Samples whose norms no change of the parameters makes smaller together.
    CertificateKeys of Certificate { largest, active by Each<ActiveSampleKeys>, subgradient, gap }
    /// Sample that holds the largest norm up.
    ActiveSampleKeys of ActiveSample { sample, multiplier }
}
