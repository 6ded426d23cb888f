//! Rows of campaigns, chains, benchmarks and tolerances.

use cdpr_model::reading::Keyword;
use cdpr_study::benchmark::{Benchmark, BenchmarkErrors, BenchmarkRow, BenchmarkRules};
use cdpr_study::campaign::Round;
use cdpr_study::chain::{ChainStep, Identified};
use cdpr_study::sensitivity::{Influence, KindInfluence};
use cdpr_study::sweep::Row;
use cdpr_study::tolerance::{Allowance, MonteCarlo, Quantiles};

use super::adapters::keys;
use super::{AccuracyKeys, Each, ErrorBlockKeys, Maybe};

keys! {
    /// Round of a campaign.
    RoundKeys of Round {
        round, poses, new_poses, candidates, validation by Maybe<ErrorBlockKeys>, predicted by ErrorBlockKeys,
        driven by Maybe<AccuracyKeys>, reach_share, deviation_m, parameter_count, rank, fit.name(),
    }
    /// Stage of a chain with its errors.
    ChainStepKeys of ChainStep {
        name, words, section, samples, position_mean_m, rotation_mean_rad, length_mean_abs_m,
        tension_mean_norm = "tension_mean_norm_N", tension_range = "tension_range_N", slack_samples,
        identified by Maybe<IdentifiedKeys>,
    }
    /// Size and condition of an identification.
    IdentifiedKeys of Identified { parameter_count, rank, condition, condition_scaled, iterations }
    /// Robots under all models.
    BenchmarkKeys of Benchmark { rules by BenchmarkRuleKeys, rows by Each<BenchmarkRowKeys>, left_out }
    /// Result of one robot under one control model.
    BenchmarkRowKeys of BenchmarkRow {
        robot, motion_pattern, cables, machine, model, poses, diagonal_m, nominal by BenchmarkErrorKeys,
        parameter_count, samples, identified by Maybe<BenchmarkErrorKeys>, reason,
    }
    /// Errors over the poses, driven on the machine without sensor noise.
    BenchmarkErrorKeys of BenchmarkErrors {
        position_mean_m, position_max_m, position_relative, rotation_mean_rad, length_mean_abs_m,
        tension_mean_norm_N, reach_share,
    }
    /// Deviations of machines, positions of poses and sensors of the benchmark.
    BenchmarkRuleKeys of BenchmarkRules {
        anchor_deviation, stiffness_deviation, strain_at_largest_tension, box_share, turned_poses, turn_rad,
        measured_poses, position_m, rotation_rad, length_m, tension_share, seed,
    }
    /// Point of a sweep, without the sizes whose unit depends on the robot.
    SweepRowKeys of Row { point, values, cells, reason }
    /// Influence of a parameter over the poses, per its `unit`.
    InfluenceKeys of Influence {
        cause.side.name() = "side", cause.kind.to_string() = "kind", cause.kind.unit() = "unit",
        position_mean = "position_mean_m_per_unit", position_max = "position_max_m_per_unit",
        rotation_mean = "rotation_mean_rad_per_unit", rotation_max = "rotation_max_rad_per_unit",
        tension_mean = "tension_mean_N_per_unit", tension_max = "tension_max_N_per_unit",
    }
    /// Influence of a kind of deviation over the poses.
    KindInfluenceKeys of KindInfluence {
        side.name(), kind.to_string(), count, unit, position_rms = "position_rms_m_per_unit",
        position_max = "position_max_m_per_unit",
    }
    /// Tolerances of one kind, in its `unit`.
    AllowanceKeys of Allowance {
        side.name(), kind.to_string(), unit, alone = "sigma_alone", alone_worst_case = "worst_case_alone",
        joint = "sigma_joint", joint_worst_case = "worst_case_joint",
    }
    /// Statistics of drawn robots.
    MonteCarloKeys of MonteCarlo {
        engine.name(), robots, unanswered, reason, error = "position_error_m" by QuantileKeys,
        rotation_error = "rotation_error_rad" by QuantileKeys, deviation = "deviation_m" by QuantileKeys,
        mean_of_robot = "mean_of_robot_m" by QuantileKeys, max_of_robot = "max_of_robot_m" by QuantileKeys,
    }
    /// Mean and quantiles of a set of numbers.
    QuantileKeys of Quantiles { mean, rms, median, p95, p99, max }
}
