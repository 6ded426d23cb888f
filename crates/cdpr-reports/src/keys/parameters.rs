//! Parameters of a fit beyond their values: courses, profiles, resampling, penalties and scales.

use cdpr_calibration::fit::{Profile, ProfilePoint, RowWeights};
use cdpr_calibration::{
    Conditioning, CourseStep, Evidence, Influence, KindCondition, KindScale, PathParameter, PathPoint, Reduction,
    Resampled, ResampledDeviation,
};
use cdpr_model::geometry::MotionPattern;
use cdpr_model::robot::ParameterKind;
use serde::Serialize;

use super::Each;
use super::adapters::tables;

/// Step of a fit.
#[derive(Serialize)]
#[serde(remote = "CourseStep")]
pub(crate) struct CourseStepKeys {
    values: Vec<f64>,
    step_m: Option<f64>,
    length_rms_m: f64,
    #[serde(rename = "force_rms_N")]
    force_rms: Option<f64>,
    #[serde(rename = "moment_rms_Nm")]
    moment_rms: Option<f64>,
    position_rms_m: Option<f64>,
    rank: usize,
    condition: f64,
    condition_scaled: f64,
}

/// Course of the weighted squares over one parameter, in its `unit`.
#[derive(Serialize)]
#[serde(remote = "Profile")]
pub(crate) struct ProfileKeys {
    parameter: String,
    unit: &'static str,
    value: f64,
    sigma: f64,
    quantile_95: f64,
    threshold: f64,
    interval: [Option<f64>; 2],
    length_rms_m: f64,
    given_length_rms_m: f64,
    #[serde(with = "Each::<ProfilePointKeys>")]
    points: Vec<ProfilePoint>,
}

/// One value of a profiled parameter.
#[derive(Serialize)]
#[serde(remote = "ProfilePoint")]
struct ProfilePointKeys {
    shift: f64,
    held: f64,
    refitted: f64,
    length_rms_m: f64,
    position_mean_m: f64,
}

/// Parameters of data drawn anew.
#[derive(Serialize)]
#[serde(remote = "Resampled")]
pub(crate) struct ResampledKeys {
    replicates: usize,
    failed: usize,
    block_length: usize,
    #[serde(with = "Each::<ResampledDeviationKeys>")]
    parameters: Vec<ResampledDeviation>,
    warning: Option<String>,
}

/// Standard deviations of a parameter, in its `unit`.
#[derive(Serialize)]
#[serde(remote = "ResampledDeviation")]
struct ResampledDeviationKeys {
    parameter: String,
    unit: &'static str,
    linear: Option<f64>,
    bootstrap: f64,
    bias: f64,
    ratio: Option<f64>,
}

/// Least value at one penalty.
#[derive(Serialize)]
#[serde(remote = "PathPoint")]
pub(crate) struct PathPointKeys {
    lambda: f64,
    parameter_count: usize,
    validation: Option<f64>,
    standard_error: Option<f64>,
    squares: f64,
    converged: bool,
    values: Vec<f64>,
    changes_m: Vec<f64>,
}

/// Free parameter of a path, in its `unit`.
#[derive(Serialize)]
#[serde(remote = "PathParameter")]
pub(crate) struct PathParameterKeys {
    name: String,
    unit: &'static str,
    centre: f64,
    is_penalised: bool,
    enters: Option<f64>,
}

/// Smaller model that data show, each pair of the full model and the smaller one.
#[derive(Serialize)]
#[serde(remote = "Reduction")]
pub(crate) struct ReductionKeys {
    evidence: Evidence,
    reason: String,
    patterns: [MotionPattern; 2],
    parameter_count: [usize; 2],
    left: Vec<String>,
    position_mean_m: [f64; 2],
    #[serde(rename = "standard_error_m")]
    standard_error: f64,
}

/// Condition of the Jacobian of a model on data.
#[derive(Serialize)]
#[serde(remote = "Conditioning")]
pub(crate) struct ConditioningKeys {
    #[serde(with = "RowWeightKeys")]
    row_weights: RowWeights,
    parameter_count: usize,
    rank: usize,
    condition: f64,
    condition_unit_columns: f64,
    #[serde(with = "Each::<KindConditionKeys>")]
    kinds: Vec<KindCondition>,
    #[serde(with = "Each::<KindScaleKeys>")]
    scales: Vec<KindScale>,
    condition_scaled: f64,
    #[serde(with = "Each::<InfluenceKeys>")]
    influences: Vec<Influence>,
}

/// Weights of the rows of lengths and wrenches.
#[derive(Serialize)]
#[serde(remote = "RowWeights")]
struct RowWeightKeys {
    #[serde(rename = "wrench_per_N")]
    wrench: f64,
    #[serde(rename = "length_per_m")]
    length: f64,
}

/// Condition of one kind of parameters.
#[derive(Serialize)]
#[serde(remote = "KindCondition")]
struct KindConditionKeys {
    #[serde(serialize_with = "kind")]
    kind: ParameterKind,
    parameter_count: usize,
    condition: f64,
}

/// Scale of a kind of parameters in its SI unit.
#[derive(Serialize)]
#[serde(remote = "KindScale")]
struct KindScaleKeys {
    #[serde(serialize_with = "kind")]
    kind: ParameterKind,
    factor: f64,
}

/// Factor of the condition.
#[derive(Serialize)]
#[serde(remote = "Influence")]
struct InfluenceKeys {
    name: &'static str,
    factor: f64,
    words: String,
}

fn kind<S: serde::Serializer>(kind: &ParameterKind, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(kind.name())
}

tables!(
    CourseStepKeys: CourseStep,
    ProfileKeys: Profile,
    ProfilePointKeys: ProfilePoint,
    ResampledKeys: Resampled,
    ResampledDeviationKeys: ResampledDeviation,
    PathPointKeys: PathPoint,
    PathParameterKeys: PathParameter,
    KindConditionKeys: KindCondition,
    KindScaleKeys: KindScale,
    InfluenceKeys: Influence,
);
