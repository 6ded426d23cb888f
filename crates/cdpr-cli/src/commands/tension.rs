//! `cdpr tension`: tensions that balance the load.

use std::process::ExitCode;

use cdpr::cable::GeometryError;
use cdpr::equilibrium::distribution::{self, DistributionError};
use cdpr::geometry::Pose;
use cdpr::model::Model;
use cdpr::statics::{Load, StaticsError};
use cdpr::tension::{self, Limits, Method, Solver, Status};
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::{ModelArguments, limits_of, load_of, pose_of};
use crate::numbers::{NumberList, finite_number, number_from_zero};
use crate::table::{Table, cell};
use crate::tension_method::{MethodArguments, Wishes, is_turn, refused};
use cdpr_reports::answers::PoseAnswer;

const EXAMPLES: &str = "\
Examples:
  cdpr tension planar-example --pose 0,5.2
  cdpr tension planar-example --pose 0,5.2 --wrench 0,-1962 --min 1000 --max 8000 --method closed-form
  cdpr tension cogiro --pose 0,0,2,0,0,0 --format json
  cdpr tension planar-example --pose 0,5.2 --method maximum --p 1
  cdpr tension planar-example --pose 0,5.2 --wrench 0,-40000 --method nearest-wrench
  cdpr tension planar-example --pose 0,5.2 --reference previous --previous 5000,5000,3000,3000 --rate 20000 --time-step 0.05";

/// Tension distribution: cable tensions that balance the load at a pose within their limits.
///
/// qp: the tensions nearest to a reference, exactly, or which cables cannot.
/// closed-form: the nearest ones that balance the load (eq. 3.41), whether or not they keep the limits.
/// improved-closed-form: the same, with cables that break their limits put on them (may find none where there are some).
/// puncture: low tensions on the way to these. dykstra: those of qp by alternating projections.
/// centroid: the middle of all allowed tensions. barrier: far from all limits, smooth along a path.
/// minimum, maximum: the lowest and highest tensions. nearest-wrench: the most of the load that the limits permit.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, verbatim_doc_comment)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    /// Platform pose (m, rad), components as in `cdpr ik --pose`.
    #[arg(long, value_name = "POSE", allow_hyphen_values = true)]
    pose: NumberList,

    /// External wrench fx,fy | fx,fy,m | fx,fy,fz | fx,fy,fz,mx,my,mz (N, N·m; world axes, moment about the platform
    /// origin), instead of the robot's external wrench and weight.
    #[arg(long, value_name = "WRENCH", allow_hyphen_values = true)]
    wrench: Option<NumberList>,

    /// Least tension of every cable (N), instead of the robot's.
    #[arg(long, value_name = "N", value_parser = number_from_zero, allow_hyphen_values = true)]
    min: Option<f64>,

    /// Largest tension of every cable (N), instead of the robot's.
    #[arg(long, value_name = "N", value_parser = finite_number, allow_hyphen_values = true)]
    max: Option<f64>,

    #[command(flatten)]
    choice: MethodArguments,
}

#[derive(Serialize)]
struct Tensions {
    robot: String,
    model: String,
    pose: PoseAnswer,
    method: Method,
    #[serde(flatten)]
    found: Found,
    #[serde(rename = "tension_min_N")]
    minimum: Vec<f64>,
    #[serde(rename = "tension_max_N")]
    maximum: Vec<f64>,
    #[serde(skip)]
    cable_names: Vec<String>,
}

/// What a method says; null where there is nothing.
#[derive(Default, Serialize)]
struct Found {
    status: &'static str,
    reason: Option<String>,
    /// False where the method found no tensions though there are some.
    #[serde(skip_serializing_if = "Option::is_none")]
    proved: Option<bool>,
    #[serde(rename = "tensions_N")]
    tensions: Option<Vec<f64>>,
    wrench: Option<Vec<f64>>,
    wrench_residual: Option<Vec<f64>>,
    #[serde(flatten)]
    missing: Option<Missing>,
    #[serde(skip_serializing_if = "Option::is_none")]
    certificate: Option<Certificate>,
    iterations: Option<u32>,
}

/// What the nearest wrench lacks to the one asked for.
#[derive(Serialize)]
struct Missing {
    #[serde(rename = "missing_wrench")]
    wrench: Vec<f64>,
    #[serde(rename = "missing_force_N")]
    force: f64,
    #[serde(rename = "missing_moment_Nm")]
    moment: f64,
    #[serde(rename = "moment_length_m")]
    moment_length: Option<f64>,
}

/// The proof of infeasibility: Σ weights · tensions is `required_N` in equilibrium and at most `reachable_N` within limits.
#[derive(Serialize)]
struct Certificate {
    direction: Vec<f64>,
    weights: Vec<f64>,
    #[serde(rename = "required_N")]
    required: f64,
    #[serde(rename = "reachable_N")]
    reachable: f64,
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let robot = model.robot();
    let pose = pose_of(robot, "--pose", &arguments.pose)?;
    let load = load_of(robot, arguments.wrench.as_ref())?;
    let limits = limits_of(robot, arguments.min, arguments.max)?;
    let method = arguments.choice.method;
    let wishes = arguments.choice.wishes(&model);
    let (found, limits) = find(&model, &pose, &load, limits, method, &wishes)?;
    output.answer(&Tensions {
        robot: robot.name.clone(),
        model: model.composition().to_string(),
        pose: PoseAnswer::new(robot, &pose),
        method,
        found,
        minimum: limits.minimum().to_vec(),
        maximum: limits.maximum().to_vec(),
        cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
    })
}

/// What the method says, and the limits in force.
fn find(
    model: &Model,
    pose: &Pose,
    load: &Load,
    limits: Limits,
    method: Method,
    wishes: &Wishes,
) -> Result<(Found, Limits), Failure> {
    if let Err(reason) = model.structure_matrix(pose) {
        return match reason {
            GeometryError::NotFinite { .. } => Err(Failure::numerical(reason.to_string())),
            _ => Ok((Found { status: "infeasible", reason: Some(reason.to_string()), ..Found::default() }, limits)),
        };
    }
    let wrench = load.in_pattern(model, pose).as_slice().to_vec();
    let options = wishes.options();
    let mut solver = Solver::new(method, model.cable_count(), model.dof());
    // what sagging cables pull follows their tensions: the method is asked until both agree
    let balance = distribution::balance(model, pose, &wrench, &mut |matrix, wrench| {
        let answer = solver.solve(matrix, wrench, &limits, &options)?;
        Ok(is_shown(answer).then(|| answer.tensions.clone()).filter(|f| f.iter().all(|tension| *tension >= 0.0)))
    });
    let balance = match balance {
        Ok(balance) => balance,
        // a cable that hangs in no shape is an answer about the pose
        Err(DistributionError::Statics(ref error @ StaticsError::CableState { reason, .. }))
            if !reason.is_overflow() =>
        {
            let reason = Some(error.to_string());
            return Ok((Found { status: "no-shape", reason, wrench: Some(wrench), ..Found::default() }, limits));
        }
        Err(DistributionError::Tension(error)) => return Err(refused(&error)),
        Err(error) => return Err(Failure::numerical(error.to_string())),
    };
    if let Some(reason) = balance.reason {
        let (status, reason) = (reason.status(), Some(reason.to_string()));
        return Ok((Found { status, reason, wrench: Some(wrench), ..Found::default() }, limits));
    }
    solver.forget();
    let answer = solver.solve(&balance.matrix, &balance.wrench, &limits, &options).map_err(|error| refused(&error))?;
    let missing = (method == Method::NearestWrench).then(|| missing(model, answer, wishes));
    Ok((Found { wrench: Some(wrench), missing, ..found_by(answer)? }, answer.limits.clone()))
}

/// True of tensions that a user may look at: those to be used, those that a closed form always gives, and those that do most
/// for the load.
fn is_shown(answer: &tension::Answer) -> bool {
    match answer.method {
        Method::ClosedForm => true,
        Method::NearestWrench => answer.status == Status::Feasible || answer.certificate().is_some(),
        _ => answer.status == Status::Feasible,
    }
}

fn found_by(answer: &tension::Answer) -> Result<Found, Failure> {
    let reason = answer.reason();
    let (status, proved) = match answer.status {
        Status::Feasible => ("feasible", None),
        Status::Infeasible => ("infeasible", Some(true)),
        Status::NotFound => ("infeasible", Some(false)),
        _ => return Err(Failure::numerical(reason.unwrap_or_default())),
    };
    let certificate = answer.certificate().map(|proof| Certificate {
        direction: proof.direction.clone(),
        weights: proof.weights.clone(),
        required: proof.required,
        reachable: proof.reachable,
    });
    let is_shown = is_shown(answer);
    Ok(Found {
        status,
        reason,
        proved,
        tensions: is_shown.then(|| answer.tensions.clone()),
        wrench_residual: is_shown.then(|| answer.wrench_residual.clone()),
        certificate,
        iterations: Some(answer.iterations),
        ..Found::default()
    })
}

fn missing(model: &Model, answer: &tension::Answer, wishes: &Wishes) -> Missing {
    let wrench = answer.missing_wrench();
    let norm = |turns: bool| {
        let rows = model.twist_basis().iter().zip(&wrench).filter(|(twist, _)| is_turn(twist) == turns);
        rows.map(|(_, rest)| rest * rest).sum::<f64>().sqrt()
    };
    let (force, moment) = (norm(false), norm(true));
    Missing { wrench, force, moment, moment_length: wishes.moment_length(model) }
}

impl Answer for Tensions {
    fn is_negative(&self) -> bool {
        self.found.status != "feasible"
    }

    fn words(&self) -> String {
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
            text.push_str(&format!("the nearest wrench lacks {force:.3} N"));
            if let Some(length) = moment_length {
                text.push_str(&format!(" and {moment:.3} N·m (moments divided by {length:.3} m)"));
            }
            text.push('\n');
        }
        let Some(tensions) = tensions else { return text };
        let mut table = Table::new(["cable", "tension N", "least N", "largest N"]);
        for (cable, name) in self.cable_names.iter().enumerate() {
            let limits = [self.minimum[cable], self.maximum[cable]];
            let numbers = [tensions[cable], limits[0], limits[1]].map(|number| cell(Some(number), 3));
            table.row([vec![name.clone()], numbers.to_vec()].concat());
        }
        format!("{text}\n{}", table.text())
    }
}
