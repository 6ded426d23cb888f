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
    RoundKeys as "CampaignRound" of Round {
        /// Number of the round, from 1.
        round,
        /// Samples measured so far.
        poses,
        /// Samples of this round.
        new_poses,
        /// Candidates that the controller of the round before reached and that were not yet measured.
        candidates,
        /// Errors on held-out samples; null if there are too few samples to hold some out.
        validation by Maybe<ErrorBlockKeys>,
        /// Errors of the model of the round before on this round's samples, to which it was not fitted.
        predicted by ErrorBlockKeys,
        /// Errors with which the identified controller drives the study's machine over all its poses; null if records come from files.
        driven by Maybe<AccuracyKeys>,
        /// Fraction of the study's poses that the identified controller reaches on the study's machine.
        reach_share,
        /// Root mean square over the study's poses of the driven position's deviation due to the parameters' uncertainty (m); null if a parameter is not determined.
        deviation_m,
        /// Count of free parameters.
        parameter_count,
        /// Rank of the Jacobian.
        rank,
        /// Status of the fit.
        fit.name(),
    }
    /// Stage of a chain with its errors.
    ChainStepKeys of ChainStep {
        /// Name of the stage.
        name,
        /// Description of the stage.
        words,
        /// Section of the dissertation.
        section,
        /// Number of samples or poses.
        samples,
        /// Mean position error (m).
        position_mean_m,
        /// Mean rotation error (rad).
        rotation_mean_rad,
        /// Mean magnitude of the length errors (m).
        length_mean_abs_m,
        /// Mean over poses of the 2-norm of the tension errors (N).
        tension_mean_norm = "tension_mean_norm_N",
        /// Smallest and largest tension of the machine (N).
        tension_range = "tension_range_N",
        /// Poses at which a cable is slack.
        slack_samples,
        /// Size of the identification; null for a stage without one.
        identified by Maybe<IdentifiedKeys>,
    }
    /// Size and condition of an identification.
    IdentifiedKeys as "IdentificationSize" of Identified {
        /// Count of free parameters.
        parameter_count,
        /// Number of directions that the data determine: the rank of the Jacobian.
        rank,
        /// Condition number of the Jacobian.
        condition,
        /// Condition number of the Jacobian with columns of length one.
        condition_scaled,
        /// Steps of the fit.
        iterations,
    }
    /// Robots under all models.
    BenchmarkKeys of Benchmark {
        /// Rules.
        rules by BenchmarkRuleKeys,
        /// Results robot by robot, each with its models from the simplest to the richest.
        rows by Each<BenchmarkRowKeys>,
        /// Robots that cannot take part, with the reason.
        left_out,
    }
    /// Result of one robot under one control model.
    BenchmarkRowKeys of BenchmarkRow {
        /// Name of the robot.
        robot,
        /// Motion pattern.
        motion_pattern,
        /// Number of cables m.
        cables,
        /// Composition of the machine.
        machine,
        /// Composition of the control model.
        model,
        /// Number of commanded poses.
        poses,
        /// Diagonal d of the box of the poses (m).
        diagonal_m,
        /// Errors with the numbers of the file.
        nominal by BenchmarkErrorKeys,
        /// Count of free parameters.
        parameter_count,
        /// Number of samples n_s used for identification.
        samples,
        /// Errors with identified numbers; null if nothing was identified.
        identified by Maybe<BenchmarkErrorKeys>,
        /// Reason for which nothing was identified.
        reason,
    }
    /// Errors over the poses, driven on the machine without sensor noise.
    BenchmarkErrorKeys as "BenchmarkErrors" of BenchmarkErrors {
        /// Mean position error ε_x (m; eq. 3.4).
        position_mean_m,
        /// Largest position error (m; eq. 3.8).
        position_max_m,
        /// Mean position error divided by the diagonal of the poses (eq. 3.5–3.7).
        position_relative,
        /// Mean rotation error ε_Φ (rad); null if the platform does not turn.
        rotation_mean_rad,
        /// Mean magnitude of length errors ε_q (m; eq. 6.6).
        length_mean_abs_m,
        /// Mean over poses of the 2-norm of tension errors ε_f (N); null for control models that command no tensions.
        tension_mean_norm_N,
        /// Fraction of the poses at which the machine comes to rest within its tension limits.
        reach_share,
    }
    /// Deviations of machines, positions of poses and sensors of the benchmark.
    BenchmarkRuleKeys as "BenchmarkRules" of BenchmarkRules {
        /// Standard deviation of anchors per axis: for frame anchors as a fraction of their mean distance from their middle, for platform anchors of their distance from the platform origin.
        anchor_deviation,
        /// Standard deviation of stiffnesses, as a fraction of the stiffness.
        stiffness_deviation,
        /// Strain at the largest tension, for cables whose file states no stiffness.
        strain_at_largest_tension,
        /// Fraction of the travel box, about the home pose, that the poses cover: a grid of 5 along each translation, 3 along the last of three.
        box_share,
        /// Count of poses with random orientations within ± `turn_rad`, for robots that turn.
        turned_poses,
        /// Largest turn (rad).
        turn_rad,
        /// Count of measured poses, chosen at random.
        measured_poses,
        /// Standard deviation of measured positions per axis (m).
        position_m,
        /// Standard deviation of measured orientations per axis (rad).
        rotation_rad,
        /// Standard deviation of measured lengths (m).
        length_m,
        /// Standard deviation of measured tensions, as a fraction of the largest tension.
        tension_share,
        /// Seed of deviations, poses and noise.
        seed,
    }
    /// Point of a sweep, without the sizes whose unit depends on the robot.
    SweepRowKeys of Row {
        /// Index of the point, from 0.
        point,
        /// Value of each parameter.
        values,
        /// Cells of the grid.
        cells,
        /// Reason in words for which there is no reachable workspace: the machine cannot be set up, or the box lies outside its reach.
        reason,
    }
    /// Influence of a parameter over the poses, per its `unit`.
    InfluenceKeys as "ParameterInfluence" of Influence {
        /// Side of the deviation: control model, machine or winches.
        cause.side.name() = "side",
        /// Kind of the parameter.
        cause.kind.to_string() = "kind",
        /// Unit of the kind; empty for a ratio.
        cause.kind.unit() = "unit",
        /// Mean distance that the platform moves (m per unit).
        position_mean = "position_mean_m_per_unit",
        /// Largest distance (m per unit).
        position_max = "position_max_m_per_unit",
        /// Mean angle that the platform turns (rad per unit).
        rotation_mean = "rotation_mean_rad_per_unit",
        /// Largest angle (rad per unit).
        rotation_max = "rotation_max_rad_per_unit",
        /// Mean over the poses of the largest change of a tension (N per unit); null for a rigid machine.
        tension_mean = "tension_mean_N_per_unit",
        /// Largest over the poses (N per unit); null for a rigid machine.
        tension_max = "tension_max_N_per_unit",
    }
    /// Influence of a kind of deviation over the poses.
    KindInfluenceKeys of KindInfluence {
        /// Side of the deviation: control model, machine or winches.
        side.name(),
        /// Kind of the deviation.
        kind.to_string(),
        /// Number of causes.
        count,
        /// Unit of the kind.
        unit,
        /// Root mean square over the poses (m per unit).
        position_rms = "position_rms_m_per_unit",
        /// Value at the worst pose (m per unit).
        position_max = "position_max_m_per_unit",
    }
    /// Tolerances of one kind, in its `unit`.
    AllowanceKeys of Allowance {
        /// Side of the deviation: control model, machine or winches.
        side.name(),
        /// Kind of the deviation.
        kind.to_string(),
        /// Unit of the kind.
        unit,
        /// Standard deviation of each number if all others are exact; null for numbers without effect.
        alone = "sigma_alone",
        /// Largest deviation of each number in the worst case if all others are exact.
        alone_worst_case = "worst_case_alone",
        /// Standard deviation of each number if all named kinds deviate, each by the same fraction of its own allowance; null for other kinds.
        joint = "sigma_joint",
        /// Largest deviation of each number in the worst case, if all named kinds deviate; null for other kinds.
        joint_worst_case = "worst_case_joint",
    }
    /// Statistics of drawn robots.
    MonteCarloKeys of MonteCarlo {
        /// Method by which they answered.
        engine.name(),
        /// Robots drawn.
        robots,
        /// Pairs of robot and pose without an answer, which do not count.
        unanswered,
        /// Reason for which the first of them has no answer.
        reason,
        /// Distance from the commanded position over all robots and poses (m).
        error = "position_error_m" by QuantileKeys,
        /// Angle from the commanded orientation (rad).
        rotation_error = "rotation_error_rad" by QuantileKeys,
        /// Distance from the position of the robot without deviations (m).
        deviation = "deviation_m" by QuantileKeys,
        /// Mean error of each robot over the poses; quantiles over the robots (m).
        mean_of_robot = "mean_of_robot_m" by QuantileKeys,
        /// Largest error of each robot; quantiles over the robots (m).
        max_of_robot = "max_of_robot_m" by QuantileKeys,
    }
    /// Mean and quantiles of a set of numbers.
    QuantileKeys as "Quantiles" of Quantiles {
        /// Mean.
        mean,
        /// Root mean square.
        rms,
        /// Median: half of the numbers are smaller.
        median,
        /// 95th percentile.
        p95,
        /// 99th percentile.
        p99,
        /// Largest.
        max,
    }
}
