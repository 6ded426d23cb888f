//! Fits: parameters, what the data tell of them, and the way to the optimum.

use cdpr_calibration::fit::{Estimate, Fit, ShiftEstimate};
use cdpr_calibration::{
    ActiveSample, Analysis, Certificate, Correlation, FrameEstimate, Gauge, Loss, Outlier, RecordingFrames,
    StartOptimum, Starts, StoppedBy,
};
use cdpr_model::reading::Keyword;
use schemars::JsonSchema;
use serde::Serialize;

use super::adapters::{keys, tables};
use super::table_schema::nullable_numbers;
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
    /// Optimal value.
    value: f64,
    /// Standard deviation; null where the data do not determine it.
    sigma: Option<f64>,
    /// Value minus start.
    change: f64,
    /// Standard deviation of the prior.
    prior_sigma: Option<f64>,
    /// True when the value lies on a bound, to rounding and the tolerance of the fit.
    at_bound: bool,
}

/// Rank and condition of the Jacobian.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Analysis")]
#[schemars(rename = "Determination", transform = nullable_numbers)]
struct DeterminationKeys {
    /// Rank of the Jacobian of all residuals by all free parameters.
    rank: usize,
    /// Singular values in SI units, from large to small (eq. 4.23).
    singular_values: Vec<f64>,
    /// Ratio of the largest to the smallest singular value; null below full rank.
    condition: f64,
    /// Condition with columns of length one.
    condition_scaled: f64,
    /// Directions in parameter space that the data leave open or nearly so.
    weak_directions: Vec<String>,
    /// Number of those directions; sentences tell several at once.
    weak_direction_count: usize,
    /// Largest standard deviation along any of them (m, scales times the mean length and the like); null where one is not determined at all, 0 without any.
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
    /// 2-norm over the cables of modelled minus recorded lengths at the measured pose (m).
    residual_m: f64,
    /// Weight that the loss leaves to it.
    weight: f64,
    /// The deviation in words, and the cables concerned.
    reason: String,
}

/// Frame with its standard deviations.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "FrameEstimate")]
#[schemars(rename = "FrameEstimate")]
struct FrameKeys {
    /// Origin (m).
    position_m: [f64; 3],
    /// Angles of R = Rx Ry Rz (rad).
    rotation_rad: [f64; 3],
    /// The same rotation.
    quaternion_xyzw: [f64; 4],
    /// Standard deviations of the origin (m).
    sigma_position_m: [f64; 3],
    /// Standard deviations of small rotations about the axes of the frame that it is given in (rad).
    sigma_rotation_rad: [f64; 3],
}

/// Freedom that the data leave of the frames, and what fixes it.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Gauge")]
#[schemars(rename = "Gauge")]
struct GaugeKeys {
    /// `least-change`: of the file's anchors.
    kind: &'static str,
    /// `translation`, `rotation`; empty where the data leave nothing free.
    free: Vec<&'static str>,
    /// Number of free directions.
    directions: usize,
}

/// Frames of tracker and marker.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "RecordingFrames")]
#[schemars(rename = "RecordingFrames")]
pub(crate) struct RecordingFrameKeys {
    /// Pose of the tracker's world in the frame of the robot, where it was free.
    #[serde(rename = "tracker_frame", with = "Maybe::<FrameKeys>", skip_serializing_if = "Option::is_none")]
    tracker: Option<FrameEstimate>,
    /// Pose of the marker on the platform, where it was free.
    #[serde(rename = "marker_frame", with = "Maybe::<FrameKeys>", skip_serializing_if = "Option::is_none")]
    marker: Option<FrameEstimate>,
    /// Freedom that the data leave of them.
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
    /// Standard deviation, frames and clock as found (m).
    #[serde(rename = "sigma_m")]
    sigma: f64,
    /// Length offset that the robot had before the fit (m).
    #[serde(getter = "ShiftEstimate::offset_before")]
    length_offset_before_m: f64,
    /// Length offset that the calibrated robot has (m).
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
    /// The status in words, with numbers.
    reason: String,
    /// Steps of the cable that needed most.
    iterations: u32,
    /// The free parameters, ordered by cable.
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
    /// Number of free parameters.
    #[serde(getter = "parameter_count")]
    parameter_count: usize,
    /// The loss of the optimum, as chosen or found.
    #[serde(with = "Word")]
    loss: Loss,
    /// Samples beyond 8 robust standard deviations.
    #[serde(with = "Each::<OutlierKeys>")]
    outliers: Vec<Outlier>,
    /// How late poses are recorded (s), where the offset of the clocks was free.
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
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Fit")]
pub(crate) struct PoselessFitKeys {
    #[serde(flatten, getter = "itself", with = "EstimatesKeys")]
    estimates: Fit,
    #[serde(flatten, with = "SeparationKeys")]
    analysis: Analysis,
    /// The rule that ended the search; of cables that were identified apart that of the one whose end says least of an optimum.
    #[serde(with = "StoppedByKeys")]
    stopped_by: StoppedBy,
    /// Optima that the starts led to. Cables of a kinematic model are identified apart, each from its own best start: the best optimum may then be one that no start led all cables to.
    #[serde(with = "StartsKeys")]
    starts: Starts,
}

/// Fit of one model.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Fit")]
#[schemars(transform = nullable_numbers)]
pub(crate) struct FitKeys {
    #[serde(flatten, getter = "itself", with = "CandidateFitKeys")]
    of_candidate: Fit,
    #[serde(flatten, with = "SeparationKeys")]
    analysis: Analysis,
    /// The rule that ended the search; of cables that were identified apart that of the one whose end says least of an optimum.
    #[serde(with = "StoppedByKeys")]
    stopped_by: StoppedBy,
    /// Optima that the starts led to. Cables of a kinematic model are identified apart, each from its own best start: the best optimum may then be one that no start led all cables to.
    #[serde(with = "StartsKeys")]
    starts: Starts,
    /// Norm of a sample's residuals from which on it counts less; null for least squares.
    loss_threshold: f64,
    /// Standard deviation of the offset of the clocks (s).
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
    CorrelationKeys of Correlation {
        /// Name of the one.
        first,
        /// Name of the other.
        second,
        /// Correlation coefficient of their errors.
        coefficient,
    }
    /// Strongly correlated parameters, and the half width of 95 % intervals.
    SeparationKeys of Analysis {
        /// Pairs of parameters with a correlation above 0.95.
        correlations by Each<CorrelationKeys>,
        /// Half width of a 95 % interval of a parameter, in standard deviations: 1.96, or Student's t where residuals tell the noise.
        quantile_95,
    }
    /// End of a search by a rule.
    StoppedByKeys of StoppedBy {
        /// The rule.
        rule.name(),
        /// Its number: metres, a share of the cost, or steps.
        value,
        /// Limit of this number.
        limit,
    }
    /// Optima that the starts of a fit led to.
    StartsKeys of Starts {
        /// Starts: the file's values and points of a scrambled Sobol sequence.
        count,
        /// Starts whose descent did not converge, or that had no residuals.
        unconverged,
        /// How far the other starts are from the file's values, kind by kind.
        ranges,
        /// Optima, best first.
        optima by Each<StartOptimumKeys>,
    }
    /// Optimum that some of the starts led to.
    StartOptimumKeys of StartOptimum {
        /// Weighted sum of squared residuals and priors.
        cost,
        /// Starts that ended here; 0 for one that joins the best ends of cables that were identified apart.
        starts,
        /// The same as a fraction of all starts.
        fraction = "share",
        /// Largest difference of a parameter between two starts that ended here (m; others than lengths by their effect on cable lengths).
        spread_m,
        /// Largest difference of a parameter from the best optimum (m).
        distance_m,
    }
    /// Samples whose norms no change of the parameters makes smaller together.
    CertificateKeys as "OptimumCertificate" of Certificate {
        /// The largest norm.
        largest,
        /// Samples (from 1) that have it, with their multipliers, which sum to one over all samples.
        active by Each<ActiveSampleKeys>,
        /// ‖Σ λ ∂‖r‖²/∂p‖/Σ λ ‖∂‖r‖²/∂p‖: 0 where nothing makes all of them smaller to first order.
        subgradient,
        /// Bound of what the largest norm lies above the least near here, relative; null where the search did not end there.
        gap,
    }
    /// Sample that holds the largest norm up.
    ActiveSampleKeys of ActiveSample {
        /// Number of the sample, from 1.
        sample,
        /// λ.
        multiplier,
    }
}
