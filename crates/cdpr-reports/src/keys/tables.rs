//! Rows of campaigns, chains, benchmarks and tolerances.

use cdpr_calibration::ErrorBlocks;
use cdpr_calibration::fit::Status;
use cdpr_study::accuracy::Accuracy;
use cdpr_study::benchmark::{Benchmark, BenchmarkErrors, BenchmarkRow, BenchmarkRules};
use cdpr_study::campaign::Round;
use cdpr_study::sensitivity::{Kind, KindInfluence, Side};
use cdpr_study::sweep::Row;
use cdpr_study::tolerance::{Allowance, Engine, MonteCarlo, Quantiles};
use serde::Serialize;

use super::adapters::tables;
use super::{Each, ErrorBlockKeys, Maybe, Word};

/// Round of a campaign.
#[derive(Serialize)]
#[serde(remote = "Round")]
pub(crate) struct RoundKeys {
    round: usize,
    poses: usize,
    new_poses: usize,
    candidates: usize,
    #[serde(with = "Maybe::<ErrorBlockKeys>")]
    validation: Option<ErrorBlocks>,
    #[serde(with = "ErrorBlockKeys")]
    predicted: ErrorBlocks,
    driven: Option<Accuracy>,
    reach_share: f64,
    deviation_m: Option<f64>,
    parameter_count: usize,
    rank: usize,
    fit: Status,
}

/// Robots under all models.
#[derive(Serialize)]
#[serde(remote = "Benchmark")]
pub(crate) struct BenchmarkKeys {
    #[serde(with = "BenchmarkRuleKeys")]
    rules: BenchmarkRules,
    #[serde(with = "Each::<BenchmarkRowKeys>")]
    rows: Vec<BenchmarkRow>,
    left_out: Vec<(String, String)>,
}

/// Result of one robot under one control model.
#[derive(Serialize)]
#[serde(remote = "BenchmarkRow")]
struct BenchmarkRowKeys {
    robot: String,
    motion_pattern: &'static str,
    cables: usize,
    machine: String,
    model: String,
    poses: usize,
    diagonal_m: f64,
    #[serde(with = "BenchmarkErrorKeys")]
    nominal: BenchmarkErrors,
    parameter_count: usize,
    samples: usize,
    #[serde(with = "Maybe::<BenchmarkErrorKeys>")]
    identified: Option<BenchmarkErrors>,
    reason: Option<String>,
}

/// Errors over the poses, driven on the machine without sensor noise.
#[derive(Serialize)]
#[serde(remote = "BenchmarkErrors")]
#[expect(non_snake_case, reason = "the fields are the keys, units included")]
struct BenchmarkErrorKeys {
    position_mean_m: f64,
    position_max_m: f64,
    position_relative: f64,
    rotation_mean_rad: Option<f64>,
    length_mean_abs_m: f64,
    tension_mean_norm_N: Option<f64>,
    reach_share: f64,
}

/// Deviations of machines, positions of poses and sensors of the benchmark.
#[derive(Serialize)]
#[serde(remote = "BenchmarkRules")]
struct BenchmarkRuleKeys {
    anchor_deviation: f64,
    stiffness_deviation: f64,
    strain_at_largest_tension: f64,
    box_share: f64,
    turned_poses: usize,
    turn_rad: f64,
    measured_poses: usize,
    position_m: f64,
    rotation_rad: f64,
    length_m: f64,
    tension_share: f64,
    seed: u64,
}

/// Point of a sweep, without the sizes whose unit depends on the robot.
#[derive(Serialize)]
#[serde(remote = "Row")]
pub(crate) struct SweepRowKeys {
    point: usize,
    values: Vec<f64>,
    cells: u64,
    reason: Option<String>,
}

/// Influence of a kind of deviation over the poses.
#[derive(Serialize)]
#[serde(remote = "KindInfluence")]
pub(crate) struct KindInfluenceKeys {
    side: Side,
    #[serde(serialize_with = "kind")]
    kind: Kind,
    count: usize,
    unit: &'static str,
    #[serde(rename = "position_rms_m_per_unit")]
    position_rms: f64,
    #[serde(rename = "position_max_m_per_unit")]
    position_max: f64,
}

/// Tolerances of one kind, in its `unit`.
#[derive(Serialize)]
#[serde(remote = "Allowance")]
pub(crate) struct AllowanceKeys {
    side: Side,
    #[serde(serialize_with = "kind")]
    kind: Kind,
    unit: &'static str,
    #[serde(rename = "sigma_alone")]
    alone: f64,
    #[serde(rename = "worst_case_alone")]
    alone_worst_case: f64,
    #[serde(rename = "sigma_joint")]
    joint: Option<f64>,
    #[serde(rename = "worst_case_joint")]
    joint_worst_case: Option<f64>,
}

pub(crate) fn kind<S: serde::Serializer>(kind: &Kind, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_str(kind)
}

/// Statistics of drawn robots.
#[derive(Serialize)]
#[serde(remote = "MonteCarlo")]
pub(crate) struct MonteCarloKeys {
    #[serde(with = "Word")]
    engine: Engine,
    robots: usize,
    unanswered: usize,
    reason: Option<String>,
    #[serde(rename = "position_error_m", with = "QuantileKeys")]
    error: Quantiles,
    #[serde(rename = "rotation_error_rad", with = "QuantileKeys")]
    rotation_error: Quantiles,
    #[serde(rename = "deviation_m", with = "QuantileKeys")]
    deviation: Quantiles,
    #[serde(rename = "mean_of_robot_m", with = "QuantileKeys")]
    mean_of_robot: Quantiles,
    #[serde(rename = "max_of_robot_m", with = "QuantileKeys")]
    max_of_robot: Quantiles,
}

/// Mean and quantiles of a set of numbers.
#[derive(Serialize)]
#[serde(remote = "Quantiles")]
struct QuantileKeys {
    mean: f64,
    rms: f64,
    median: f64,
    p95: f64,
    p99: f64,
    max: f64,
}

tables!(
    RoundKeys: Round,
    BenchmarkRowKeys: BenchmarkRow,
    BenchmarkErrorKeys: BenchmarkErrors,
    KindInfluenceKeys: KindInfluence,
    AllowanceKeys: Allowance,
    MonteCarloKeys: MonteCarlo,
);
