//! Benchmark of robots and control models under the same rules (sec. 7.2; C38).
//!
//! Every robot is driven as its own machine, whose numbers deviate from its file as those of built robots do, by every control model that its file supports:
//! as the file has it, and after identification from one record of the same sensors. Errors are those of eq. 3.4–3.8, relative ones by the diagonal of the
//! poses, so that robots of different size stand side by side.

mod machine;
mod rules;
#[cfg(test)]
mod tests;

use serde::Serialize;

use crate::Experiment;
use cdpr_calibration::fit::{self, Prior, fit};
use cdpr_model::control::CommandedPose;
use cdpr_model::model::Composition;
use cdpr_model::robot::{ParameterKind, Robot};
use cdpr_model::scalar::map_all;
use machine::Machine;
use rules::BenchmarkError;
pub use rules::BenchmarkRules;

/// Errors over the poses, driven on the machine without noise.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[expect(non_snake_case, reason = "the fields are the keys of the answer, units included")]
pub struct BenchmarkErrors {
    /// Mean position error ε_x (m; eq. 3.4).
    pub position_mean_m: f64,
    /// Largest (m; eq. 3.8).
    pub position_max_m: f64,
    /// Mean over the diagonal of the poses (eq. 3.5–3.7).
    pub position_relative: f64,
    /// Mean rotation error ε_Φ (rad).
    pub rotation_mean_rad: Option<f64>,
    /// Mean magnitude of length errors ε_q (m; eq. 6.6).
    pub length_mean_abs_m: f64,
    /// Mean over poses of the 2-norm of tension errors ε_f (N); of control models that command tensions.
    pub tension_mean_norm_N: Option<f64>,
    /// Share of the poses at which the machine rests within its tension limits.
    pub reach_share: f64,
}

/// A robot under a control model.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BenchmarkRow {
    /// Robot.
    pub robot: String,
    /// Motion pattern.
    pub motion_pattern: &'static str,
    /// Number of cables m.
    pub cables: usize,
    /// Model that answers.
    pub machine: String,
    /// Control model.
    pub model: String,
    /// Poses driven to.
    pub poses: usize,
    /// Diagonal of their box d (m).
    pub diagonal_m: f64,
    /// With the numbers of the file.
    pub nominal: BenchmarkErrors,
    /// Free parameters.
    pub parameter_count: usize,
    /// Samples n_s that were identified from.
    pub samples: usize,
    /// With identified ones.
    pub identified: Option<BenchmarkErrors>,
    /// Reason why nothing was identified.
    pub reason: Option<String>,
}

/// All robots under all models.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Benchmark {
    /// Rules.
    pub rules: BenchmarkRules,
    /// Robots in their order, each with its models from poor to rich.
    pub rows: Vec<BenchmarkRow>,
    /// Robots that cannot take part, with the reason.
    pub left_out: Vec<(String, String)>,
}

/// Drives these robots, each by the control models that its file supports and that are asked for (all without).
pub fn benchmark(robots: &[Robot], models: Option<&[Composition]>, rules: &BenchmarkRules) -> Benchmark {
    let found = map_all(robots.len(), |index| of_robot(&robots[index], models, rules));
    let mut benchmark = Benchmark { rules: *rules, rows: Vec::new(), left_out: Vec::new() };
    for (robot, found) in robots.iter().zip(found) {
        match found {
            Ok(rows) => benchmark.rows.extend(rows),
            Err(reason) => benchmark.left_out.push((robot.name.clone(), reason.to_string())),
        }
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
        motion_pattern: robot.motion_pattern.name(),
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

/// Number of parameters and samples, and errors with what was identified. Free are the frame anchors, of elastic models with compliances.
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
    // anchors lie as drawn to what anchors deviate
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
