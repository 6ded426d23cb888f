//! Candidates that were judged, and the choice among them.

use cdpr_calibration::fit::Fit;
use cdpr_calibration::selection::{HeldOut, Judgement, Preference, RequirementOutcome};
use cdpr_calibration::{Coverage, ErrorBlocks, Information, NoiseSource, PoseRange, PredictedBand};
use schemars::JsonSchema;
use serde::Serialize;

use super::adapters::tables;
use super::fit::CandidateFitKeys;
use super::table_schema::nullable_numbers;
use super::{Each, ErrorBlockKeys, Maybe, Word};

/// Ranges of the poses, and the validation samples that lie beyond those of their fit.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Coverage")]
#[schemars(rename = "Coverage")]
pub(crate) struct CoverageKeys {
    /// Ranges of the components of the pose.
    #[serde(with = "Each::<PoseRangeKeys>")]
    ranges: Vec<PoseRange>,
    /// Validation samples.
    validation: usize,
    /// Validation samples outside the range of the data that the predicting fit saw.
    outside: usize,
}

/// Smallest and largest value of a component of the pose, in the data of the fit and in those of the validation.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "PoseRange")]
#[schemars(rename = "PoseRange", transform = nullable_numbers)]
struct PoseRangeKeys {
    /// The component: a world axis, or `rx`, `ry`, `rz`, `angle`.
    name: String,
    /// Unit of the numbers: m or rad.
    unit: &'static str,
    /// Smallest value in the data of the reported fit.
    fit_min: f64,
    /// Largest value in the data of the reported fit.
    fit_max: f64,
    /// Smallest value in validation data.
    validation_min: f64,
    /// Largest value in validation data.
    validation_max: f64,
}

/// Choice of one criterion.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Preference")]
#[schemars(rename = "Preference", transform = nullable_numbers)]
pub(crate) struct PreferenceKeys {
    /// Name of the criterion.
    name: &'static str,
    /// The criterion in words, with what counts as no difference.
    words: String,
    /// Name of the chosen candidate.
    #[serde(rename = "candidate")]
    candidate_name: String,
    /// Its value (SI).
    value: f64,
    /// Value of the recommended candidate.
    of_recommended: Option<f64>,
}

/// Outcome of a requirement, in the unit of its metric.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "RequirementOutcome")]
#[schemars(rename = "RequirementOutcome", transform = nullable_numbers)]
struct RequirementKeys {
    /// Name of the error figure with its unit.
    metric: &'static str,
    /// Largest value allowed.
    limit: f64,
    /// The candidate's value on validation data; null without any.
    value: f64,
    /// True when the value keeps the limit and every validation sample has part in it.
    met: bool,
    /// Validation samples.
    samples: usize,
    /// Those of them that have part in the value.
    samples_with_value: usize,
}

/// Criterion on data held out (SI).
#[derive(Serialize, JsonSchema)]
#[serde(remote = "HeldOut")]
#[schemars(rename = "HeldOut", transform = nullable_numbers)]
struct HeldOutKeys {
    /// Mean over the samples that all compared candidates answer (SI).
    criterion: f64,
    /// Its standard error by block bootstrap.
    standard_error: f64,
    /// Number of these samples.
    samples: usize,
}

/// Likelihood and information criteria.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Information")]
#[schemars(rename = "Information", transform = nullable_numbers)]
struct InformationKeys {
    /// ln L of the rows at the optimum.
    log_likelihood: f64,
    /// Rows that say something, without those of samples that no candidate explains.
    rows: usize,
    /// As many independent rows as these tell: rows divided by the correlation time of consecutive samples.
    effective_rows: f64,
    /// Directions that the data determine: one with a prior counts by the share that the data tell, 1 − σ²/σ_prior².
    effective_parameters: f64,
    /// Noise in units of the stated or assumed accuracies.
    noise: f64,
    /// Source of that noise.
    #[serde(with = "Word")]
    noise_source: NoiseSource,
    /// Whether wrenches are rows besides lengths: only candidates with the same rows are compared.
    with_wrenches: bool,
    /// −2 ln L · (effective rows/rows) + 2 k.
    aic: f64,
    /// The same corrected for few rows, + 2 k (k + 1)/(n − k − 1); null where there are as many parameters as rows.
    aicc: f64,
    /// −2 ln L · (effective rows/rows) + k ln n.
    bic: f64,
}

/// Errors on the data that one fold held out.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Fold")]
struct Fold {
    /// Name of the fold.
    name: String,
    #[serde(flatten, with = "ErrorBlockKeys")]
    errors: ErrorBlocks,
}

/// Error by which a candidate is compared with the best one.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Compared", transform = nullable_numbers)]
struct Compared {
    /// Error: `pose` (distance and turn of the platform anchors together, m) or `criterion`.
    by: &'static str,
    /// Unit of the numbers.
    unit: &'static str,
    /// Mean over the samples.
    mean: f64,
    /// Difference to that of the best.
    difference: f64,
    /// Standard error of the difference.
    difference_standard_error: f64,
    /// Largest difference that is none.
    as_good_within: f64,
    /// True where the candidate is as good as the best.
    as_good_as_best: bool,
}

/// Fit of a candidate and its errors.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "Judgement")]
#[schemars(rename = "Judgement", transform = nullable_numbers)]
pub(crate) struct JudgementKeys {
    /// How far the candidate may be relied on.
    #[serde(getter = "status")]
    status: &'static str,
    #[serde(flatten, with = "CandidateFitKeys")]
    fit: Fit,
    /// Errors on the data of the fit.
    #[serde(with = "ErrorBlockKeys")]
    train: ErrorBlocks,
    /// Errors on data held out.
    #[serde(with = "ErrorBlockKeys")]
    validation: ErrorBlocks,
    /// Errors on data held out, fold by fold.
    #[serde(getter = "folds")]
    folds: Vec<Fold>,
    /// Mean error by which candidates are compared (SI); null for a candidate that cannot be judged by it.
    criterion: f64,
    /// Its standard error by block bootstrap.
    standard_error: f64,
    /// Difference of the errors to those of the best candidate on the same samples, by which candidates are compared (m); null where these errors are no distances,
    /// or the candidate is not compared.
    #[serde(getter = "difference_m")]
    difference_m: Option<f64>,
    /// Standard error of the difference.
    #[serde(getter = "difference_standard_error_m")]
    difference_standard_error_m: Option<f64>,
    /// Error by which candidates are compared, on the same samples as that of the best; null for one that is not compared.
    #[serde(getter = "compared")]
    compared: Option<Compared>,
    /// Mean position error as a fraction of the diagonal of the validation positions (eq. 3.5).
    relative_position_error: Option<f64>,
    /// Bands of predicted poses, where no pose is measured.
    #[serde(flatten, with = "Maybe::<PredictedBandKeys>")]
    #[schemars(with = "Option<PredictedBandKeys>")]
    pose_band: Option<PredictedBand>,
    /// Criterion on regions left out, where they were asked for.
    #[serde(rename = "leave_region_out", with = "Maybe::<HeldOutKeys>", skip_serializing_if = "Option::is_none")]
    regions: Option<HeldOut>,
    #[serde(flatten, with = "Maybe::<InformationKeys>")]
    #[schemars(with = "Option<InformationKeys>")]
    information: Option<Information>,
    /// Validation samples that criterion and standard error are of.
    compared_samples: usize,
    /// Reason against judging the candidate.
    disqualified: Option<String>,
    /// Doubts about the parameters with their numbers.
    #[serde(getter = "cautions")]
    cautions: Vec<String>,
    /// Validation samples that no candidate explains and no figure counts.
    #[serde(getter = "set_aside_samples")]
    set_aside_samples: usize,
    /// The limits and how the candidate stands to them.
    #[serde(with = "Each::<RequirementKeys>")]
    requirements: Vec<RequirementOutcome>,
    /// False where nobody should work with the candidate.
    #[serde(getter = "trusted")]
    trusted: bool,
    /// Reasons not to trust the candidate.
    #[serde(getter = "reasons_of_distrust", skip_serializing_if = "Vec::is_empty")]
    distrust: Vec<String>,
    /// Warnings about the fit.
    #[serde(getter = "warnings")]
    warnings: Vec<String>,
}

fn status(judgement: &Judgement) -> &'static str {
    judgement.verdict().fit_status()
}

fn difference_m(judgement: &Judgement) -> Option<f64> {
    judgement.difference.filter(|_| judgement.compared_unit == "m").map(|difference| difference.mean)
}

fn difference_standard_error_m(judgement: &Judgement) -> Option<f64> {
    let difference = judgement.difference.filter(|_| judgement.compared_unit == "m")?;
    Some(difference.standard_error).filter(|error| error.is_finite())
}

fn compared(judgement: &Judgement) -> Option<Compared> {
    let found = judgement.compared_error()?;
    Some(Compared {
        by: if found.is_of_pose { "pose" } else { "criterion" },
        unit: found.unit,
        mean: found.mean,
        difference: found.difference.mean,
        difference_standard_error: found.difference.standard_error,
        as_good_within: found.as_good_within,
        as_good_as_best: found.is_as_good,
    })
}

fn folds(judgement: &Judgement) -> Vec<Fold> {
    judgement.folds.iter().map(|(name, errors)| Fold { name: name.clone(), errors: *errors }).collect()
}

fn cautions(judgement: &Judgement) -> Vec<String> {
    judgement.fit.cautions()
}

fn set_aside_samples(judgement: &Judgement) -> usize {
    judgement.set_aside.len()
}

fn trusted(judgement: &Judgement) -> bool {
    judgement.verdict().is_trusted()
}

fn reasons_of_distrust(judgement: &Judgement) -> Vec<String> {
    judgement.distrust.reasons.iter().map(|doubt| doubt.words().to_owned()).collect()
}

fn warnings(judgement: &Judgement) -> Vec<String> {
    judgement.fit.outlier_warning.iter().chain(&judgement.fit.warnings).cloned().collect()
}

/// Bands of the poses that a robot predicts which was calibrated without measured poses: root mean squares over the sampled poses.
#[derive(Serialize, JsonSchema)]
#[serde(remote = "PredictedBand")]
#[schemars(rename = "PredictedBand", transform = nullable_numbers)]
pub(crate) struct PredictedBandKeys {
    /// By free parameters.
    #[serde(rename = "pose_band_by_parameters_m")]
    by_parameters_m: f64,
    /// By held numbers within their accuracies.
    #[serde(rename = "pose_band_by_held_m")]
    by_held_m: f64,
    /// Both.
    #[serde(rename = "pose_band_m")]
    band_m: f64,
    /// The largest at a sampled pose.
    #[serde(rename = "pose_band_max_m")]
    largest_m: f64,
    /// Diagonal of the box of the sampled positions.
    #[serde(rename = "sampled_diagonal_m")]
    diagonal_m: f64,
}

tables!(
    PredictedBandKeys: PredictedBand,
    PoseRangeKeys: PoseRange,
    PreferenceKeys: Preference,
    RequirementKeys: RequirementOutcome,
    HeldOutKeys: HeldOut,
    InformationKeys: Information,
    JudgementKeys: Judgement,
);
