//! Tensions that balance a load within limits, or a proof that none do.

use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::model::Model;
use cdpr_model::tension::quadratic::Certificate;
use cdpr_model::tension::{self, Intervals, Limits, Method, Status};
use schemars::JsonSchema;
use serde::Serialize;

use super::{Answer, PoseAnswer};
use crate::keys::{InfeasibilityKeys, Maybe};
use crate::number_format::cell;
use crate::table::Table;

/// Tensions at a pose, or the reason why there are none.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Tensions")]
pub struct TensionAnswer {
    robot: String,
    model: String,
    pose: PoseAnswer,
    /// Method by which tensions were chosen.
    method: Method,
    #[serde(flatten)]
    found: Found,
    /// Smallest tension allowed, cable by cable (N).
    #[serde(rename = "tension_min_N")]
    minimum: Vec<f64>,
    /// Largest tension allowed, cable by cable (N).
    #[serde(rename = "tension_max_N")]
    maximum: Vec<f64>,
    #[serde(skip)]
    cable_names: Vec<String>,
}

/// Finding of a method; null where there is nothing.
#[derive(Default, Serialize, JsonSchema)]
pub struct Found {
    status: &'static str,
    reason: Option<String>,
    /// False where the method found no tensions though there are some.
    #[serde(skip_serializing_if = "Option::is_none")]
    proved: Option<bool>,
    #[serde(rename = "tensions_N")]
    tensions: Option<Vec<f64>>,
    /// Least and largest tension of each cable while all balance the load within limits, where they have a choice.
    #[serde(rename = "tension_intervals_N", skip_serializing_if = "Option::is_none")]
    intervals: Option<Vec<[f64; 2]>>,
    /// Wrench that the tensions balance.
    #[serde(rename = "wrench_N_Nm")]
    wrench: Option<Vec<f64>>,
    /// Difference of the wrench of the tensions from that (N, N·m).
    wrench_residual: Option<Vec<f64>>,
    #[serde(flatten)]
    missing: Option<Missing>,
    /// Proof of infeasibility: Σ weights · tensions is `required_N` in equilibrium and at most `reachable_N` within limits.
    #[serde(with = "Maybe::<InfeasibilityKeys>", skip_serializing_if = "Option::is_none")]
    certificate: Option<Certificate>,
    /// Steps of the method.
    iterations: Option<u32>,
}

/// Difference of the wrench of the tensions from the one asked for (N, N·m).
#[derive(Serialize, JsonSchema)]
struct Missing {
    /// Wrench that is missing (N, N·m).
    #[serde(rename = "missing_wrench_N_Nm")]
    wrench: Vec<f64>,
    /// Magnitude of its force (N).
    #[serde(rename = "missing_force_N")]
    force: f64,
    /// Magnitude of its moment (N·m).
    #[serde(rename = "missing_moment_Nm")]
    moment: f64,
    /// Length by which moments count (m); null for a platform that does not turn.
    #[serde(rename = "moment_length_m")]
    moment_length: Option<f64>,
}

impl TensionAnswer {
    /// Finding of a method at a pose within the limits in force.
    pub fn new(model: &Model, pose: &Pose, method: Method, found: Found, limits: &Limits) -> Self {
        let robot = model.robot();
        Self {
            robot: robot.name.clone(),
            model: model.composition().to_string(),
            pose: PoseAnswer::new(robot, pose),
            method,
            found,
            minimum: limits.minimum().to_vec(),
            maximum: limits.maximum().to_vec(),
            cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
        }
    }
}

impl Found {
    /// Nothing, not even a method's answer: the status in a word, the reason, and the wrench to balance, where one is known.
    pub fn nothing(status: &'static str, reason: String, wrench: Option<Vec<f64>>) -> Self {
        Self { status, reason: Some(reason), wrench, ..Self::default() }
    }

    /// Finding of a method that was asked for tensions that balance a wrench.
    pub fn of(answer: &tension::Answer, wrench: Vec<f64>) -> Self {
        let (status, proved) = match answer.status {
            Status::Feasible => ("feasible", None),
            Status::Infeasible => ("infeasible", Some(true)),
            _ => ("infeasible", Some(false)),
        };
        let is_shown = answer.has_tensions();
        Self {
            status,
            reason: answer.reason(),
            proved,
            tensions: is_shown.then(|| answer.tensions.clone()),
            wrench: Some(wrench),
            wrench_residual: is_shown.then(|| answer.wrench_residual.clone()),
            intervals: None,
            missing: None,
            certificate: answer.certificate().cloned(),
            iterations: Some(answer.iterations),
        }
    }

    /// True of tensions that balance the load within their limits.
    pub fn is_feasible(&self) -> bool {
        self.status == "feasible"
    }

    /// The same with how far each tension may go while all balance the load within limits.
    pub fn between(self, intervals: &Intervals) -> Self {
        Self { intervals: Some(intervals.ranges.clone()), ..self }
    }

    /// The same with the part of the load that the tensions lack, moments weighed by a length (m).
    pub fn lacking(self, model: &Model, answer: &tension::Answer, moment_length: Option<f64>) -> Self {
        let wrench = answer.missing_wrench();
        let norm = |turns: bool| {
            let rows = model.twist_basis().iter().zip(&wrench).filter(|(twist, _)| is_turn(twist) == turns);
            rows.map(|(_, rest)| rest * rest).sum::<f64>().sqrt()
        };
        let (force, moment) = (norm(false), norm(true));
        Self { missing: Some(Missing { wrench, force, moment, moment_length }), ..self }
    }
}

/// True of a direction that turns the platform, whose wrench component is a moment.
pub fn is_turn(twist: &Twist) -> bool {
    twist.fixed_rows::<3>(3).norm() > 0.0
}

impl Answer for TensionAnswer {
    fn is_negative(&self) -> bool {
        self.found.status != "feasible"
    }

    fn words(&self, width: Option<usize>) -> String {
        let Found { status, reason, tensions, proved, missing, .. } = &self.found;
        let status = match proved {
            Some(false) => format!("not found by {}", self.method),
            _ => (*status).to_owned(),
        };
        let mut text = format!("{}, model {}, at {}: {status}\n", self.robot, self.model, self.pose.words());
        if let Some(reason) = reason {
            text.push_str(&format!("{reason}\n"));
        }
        if let (Some(Missing { force, moment, moment_length, .. }), Some(_)) = (missing, reason) {
            text.push_str(&format!("these tensions lack {force:.3} N of the load"));
            if let Some(length) = moment_length {
                text.push_str(&format!(" and {moment:.3} N·m (moments divided by {length:.3} m)"));
            }
            text.push('\n');
        }
        let Some(tensions) = tensions else { return text };
        let mut heading = vec!["cable", "tension N", "least N", "largest N"];
        if self.found.intervals.is_some() {
            heading.extend(["possible from N", "to N"]);
        }
        let mut table = Table::with_heading(heading.into_iter().map(str::to_owned).collect());
        for (cable, name) in self.cable_names.iter().enumerate() {
            let limits = [self.minimum[cable], self.maximum[cable]];
            let mut numbers = vec![tensions[cable], limits[0], limits[1]];
            numbers.extend(self.found.intervals.iter().flat_map(|ranges| ranges[cable]));
            let cells = numbers.into_iter().map(|number| cell(Some(number), 3));
            table.row([name.clone()].into_iter().chain(cells).collect());
        }
        format!("{text}\n{}", table.text(width))
    }
}
