//! Benchmark of robots and control models under the same rules (sec. 7.2; C38).
//!
//! Every robot is driven as its own machine, with numbers that deviate from its file as those of built robots do, by
//! every control model that its file supports: with the numbers of the file, and after identification from one record
//! of the same sensors. Errors are those of eq. 3.4–3.8; relative errors are divided by the diagonal of the poses, so
//! that robots of different size are comparable.

mod machine;
mod rules;
#[cfg(test)]
mod tests;

use std::borrow::Cow;

use serde::{Deserialize, Serialize};

use crate::Experiment;
use crate::parts::{self, Parts, nullable};
use cdpr_calibration::fit::{self, Prior, fit};
use cdpr_model::control::CommandedPose;
use cdpr_model::model::Composition;
use cdpr_model::robot::{ParameterKind, Robot};
use machine::Machine;
use rules::BenchmarkError;
pub use rules::BenchmarkRules;

/// Errors over the poses, driven on the machine without sensor noise.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[expect(non_snake_case, reason = "the fields are the keys of the answer, units included")]
pub struct BenchmarkErrors {
    /// Mean position error ε_x (m; eq. 3.4).
    #[serde(with = "nullable")]
    pub position_mean_m: f64,
    /// Largest position error (m; eq. 3.8).
    #[serde(with = "nullable")]
    pub position_max_m: f64,
    /// Mean position error divided by the diagonal of the poses (eq. 3.5–3.7).
    #[serde(with = "nullable")]
    pub position_relative: f64,
    /// Mean rotation error ε_Φ (rad); `None` if the platform does not turn.
    pub rotation_mean_rad: Option<f64>,
    /// Mean magnitude of length errors ε_q (m; eq. 6.6).
    #[serde(with = "nullable")]
    pub length_mean_abs_m: f64,
    /// Mean over poses of the 2-norm of tension errors ε_f (N); `None` for control models that command no tensions.
    pub tension_mean_norm_N: Option<f64>,
    /// Fraction of the poses at which the machine comes to rest within its tension limits.
    #[serde(with = "nullable")]
    pub reach_share: f64,
}

/// Result of one robot under one control model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BenchmarkRow {
    /// Name of the robot.
    pub robot: String,
    /// Motion pattern.
    pub motion_pattern: Cow<'static, str>,
    /// Number of cables m.
    pub cables: usize,
    /// Composition of the machine.
    pub machine: String,
    /// Composition of the control model.
    pub model: String,
    /// Number of commanded poses.
    pub poses: usize,
    /// Diagonal d of the box of the poses (m).
    #[serde(with = "nullable")]
    pub diagonal_m: f64,
    /// Errors with the numbers of the file.
    pub nominal: BenchmarkErrors,
    /// Count of free parameters.
    pub parameter_count: usize,
    /// Number of samples n_s used for identification.
    pub samples: usize,
    /// Errors with identified numbers; `None` if nothing was identified.
    pub identified: Option<BenchmarkErrors>,
    /// Reason for which nothing was identified.
    pub reason: Option<String>,
}

/// Results of all robots under all models.
#[derive(Clone, Debug, PartialEq)]
pub struct Benchmark {
    /// Rules.
    pub rules: BenchmarkRules,
    /// Results robot by robot, each with its models from the simplest to the richest.
    pub rows: Vec<BenchmarkRow>,
    /// Robots that cannot take part, with the reason.
    pub left_out: Vec<(String, String)>,
}

/// Results of one robot: a part of a benchmark.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BenchmarkPart {
    rows: Vec<BenchmarkRow>,
    /// Reason for which the robot cannot take part.
    left_out: Option<String>,
}

/// Drives these robots, each by the control models that its file supports, restricted to `models` if given.
pub fn benchmark(robots: &[Robot], models: Option<&[Composition]>, rules: &BenchmarkRules) -> Benchmark {
    benchmark_in_parts(robots, models, rules, &parts::here)
}

/// The same in parts, one for each robot.
pub fn benchmark_in_parts(
    robots: &[Robot],
    models: Option<&[Composition]>,
    rules: &BenchmarkRules,
    parts: &Parts<'_, BenchmarkPart>,
) -> Benchmark {
    let found = parts(robots.len(), &|index| match of_robot(&robots[index], models, rules) {
        Ok(rows) => BenchmarkPart { rows, left_out: None },
        Err(reason) => BenchmarkPart { rows: Vec::new(), left_out: Some(reason.to_string()) },
    });
    let mut benchmark = Benchmark { rules: *rules, rows: Vec::new(), left_out: Vec::new() };
    for (robot, found) in robots.iter().zip(found) {
        benchmark.rows.extend(found.rows);
        benchmark.left_out.extend(found.left_out.map(|reason| (robot.name.clone(), reason)));
    }
    benchmark
}

fn of_robot(
    robot: &Robot,
    models: Option<&[Composition]>,
    rules: &BenchmarkRules,
) -> Result<Vec<BenchmarkRow>, BenchmarkError> {
    let machine = Machine::of(robot, rules)?;
    let is_asked = |model: &Composition| models.is_none_or(|asked| asked.contains(model));
    let supported = machine.controls(robot).into_iter().filter(is_asked);
    supported.map(|control| row(robot, &machine, control, rules)).collect()
}

fn row(
    robot: &Robot,
    machine: &Machine,
    control: Composition,
    rules: &BenchmarkRules,
) -> Result<BenchmarkRow, BenchmarkError> {
    let experiment = machine.under(robot, control)?;
    let nominal = errors(&experiment, &machine.poses)?;
    let identified = identified(&experiment, machine, rules);
    let (reason, found) = match identified {
        Ok(found) => (None, Some(found)),
        Err(reason) => (Some(reason.to_string()), None),
    };
    Ok(BenchmarkRow {
        robot: robot.name.clone(),
        motion_pattern: robot.motion_pattern.name().into(),
        cables: robot.cable_count(),
        machine: experiment.machine.composition().to_string(),
        model: control.to_string(),
        poses: machine.poses.len(),
        diagonal_m: diagonal(&machine.poses),
        nominal,
        parameter_count: found.as_ref().map_or(0, |found| found.0),
        samples: found.as_ref().map_or(0, |found| found.1),
        identified: found.map(|found| found.2),
        reason,
    })
}

/// Number of parameters and samples, and errors after identification. Free parameters are the frame anchors, and for
/// elastic models the compliances too.
fn identified(
    experiment: &Experiment,
    machine: &Machine,
    rules: &BenchmarkRules,
) -> Result<(usize, usize, BenchmarkErrors), BenchmarkError> {
    let record = experiment.record(&machine.measured, rules.seed)?.samples;
    let free = match experiment.control.needs_tensions() {
        true => "frame-anchor,compliance",
        false => "frame-anchor",
    };
    // anchors deviate with the standard deviation from which the machine's were drawn
    let prior = Prior { kind: ParameterKind::FrameAnchor, sigma: machine.anchor_sigma };
    let settings = fit::Settings { priors: vec![prior], ..fit::Settings::default() };
    let found = fit(&experiment.control, &record, &free.parse()?, &settings)?;
    let errors = errors(&experiment.with_control(found.model), &machine.poses)?;
    Ok((found.parameters.len(), record.len(), errors))
}

fn errors(experiment: &Experiment, poses: &[CommandedPose]) -> Result<BenchmarkErrors, BenchmarkError> {
    let reachable = experiment.reachable()?;
    let assessment = experiment.assess(poses)?;
    let reached = poses
        .iter()
        .zip(&assessment.outcomes)
        .filter(|(pose, outcome)| reachable.verdict(&pose.pose, outcome).reason.is_none())
        .count();
    let accuracy = assessment.accuracy;
    let turns = experiment.machine.robot().motion_pattern.has_rotation();
    Ok(BenchmarkErrors {
        position_mean_m: accuracy.position_error_m.mean,
        position_max_m: accuracy.position_error_m.max,
        position_relative: accuracy.position_error_m.mean / diagonal(poses),
        rotation_mean_rad: turns.then_some(accuracy.rotation_error_rad.mean),
        length_mean_abs_m: accuracy.length_error_m.mean_abs,
        tension_mean_norm_N: accuracy.tension_error_N.map(|error| error.mean_norm),
        reach_share: reached as f64 / poses.len().max(1) as f64,
    })
}

/// Diagonal of the box of the positions (m; eq. 3.7).
fn diagonal(poses: &[CommandedPose]) -> f64 {
    let along = |axis: usize| poses.iter().map(move |command| command.pose.position[axis]);
    let side = |axis: usize| along(axis).fold(f64::NEG_INFINITY, f64::max) - along(axis).fold(f64::INFINITY, f64::min);
    (0..3).map(|axis| side(axis).powi(2)).sum::<f64>().sqrt()
}
