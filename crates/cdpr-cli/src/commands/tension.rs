//! `cdpr tension`: tensions that balance the load.

use std::process::ExitCode;
use std::str::FromStr;

use cdpr::cable::DegenerateCourse;
use cdpr::equilibrium::distribution::{self, DistributionError};
use cdpr::geometry::Pose;
use cdpr::model::Model;
use cdpr::statics::Load;
use cdpr::tension::quadratic::{self, Status};
use cdpr::tension::{InputError, Limits, closed_form};
use clap::Args;
use serde::Serialize;

use crate::answer::{Answer, Output};
use crate::failure::Failure;
use crate::inputs::{ModelArguments, limits_of, load_of, pose_of};
use crate::numbers::{NumberList, finite_number, number_from_zero};
use crate::pose_answer::PoseAnswer;
use crate::table::{Table, cell};

const EXAMPLES: &str = "\
Examples:
  cdpr tension planar-example --pose 0,5.2
  cdpr tension planar-example --pose 0,5.2 --wrench 0,-1962 --min 1000 --max 8000 --method closed-form
  cdpr tension cogiro --pose 0,0,2,0,0,0 --format json";

/// Tension distribution: cable tensions that balance the load at a pose within their limits.
///
/// `qp` gives the tensions nearest to the middle of the limits that keep them, exactly, or says which cables cannot.
/// `closed-form` gives the nearest ones that balance the load (eq. 3.41), whether or not they keep the limits.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
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

    /// How the tensions are chosen: qp | closed-form.
    #[arg(long, value_name = "METHOD", default_value = "qp")]
    method: Method,
}

/// Methods of this version.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
enum Method {
    Qp,
    ClosedForm,
}

/// Methods that the command will know.
const LATER: [&str; 8] = [
    "improved-closed-form",
    "puncture",
    "dykstra",
    "centroid",
    "minimum",
    "maximum",
    "barrier",
    "nearest-wrench",
];

impl FromStr for Method {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        match text {
            "qp" => Ok(Self::Qp),
            "closed-form" => Ok(Self::ClosedForm),
            _ if LATER.contains(&text) => {
                Err(format!("the method `{text}` is not part of this version; it has qp and closed-form"))
            }
            _ => Err(format!("there is no method `{text}`; there are qp and closed-form")),
        }
    }
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
    #[serde(rename = "tensions_N")]
    tensions: Option<Vec<f64>>,
    wrench: Option<Vec<f64>>,
    wrench_residual: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    certificate: Option<Certificate>,
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
    output.answer(&Tensions {
        robot: robot.name.clone(),
        model: model.composition().to_string(),
        pose: PoseAnswer::new(robot, &pose),
        method: arguments.method,
        found: find(&model, &pose, &load, &limits, arguments.method)?,
        minimum: limits.minimum().to_vec(),
        maximum: limits.maximum().to_vec(),
        cable_names: robot.cables.iter().map(|cable| cable.name.clone()).collect(),
    })
}

fn find(model: &Model, pose: &Pose, load: &Load, limits: &Limits, method: Method) -> Result<Found, Failure> {
    if let Err(reason) = model.structure_matrix(pose) {
        return match reason {
            DegenerateCourse::NotFinite { .. } => Err(Failure::numerical(reason.to_string())),
            _ => Ok(Found { status: "infeasible", reason: Some(reason.to_string()), ..Found::default() }),
        };
    }
    let wrench = load.in_pattern(model, pose).as_slice().to_vec();
    let refused = |error: InputError| match error {
        InputError::NotFinite { .. } => Failure::numerical(error.to_string()),
        _ => Failure::refused("--wrench", &error),
    };
    // what sagging cables pull follows their tensions: the method is asked until both agree
    let balance = distribution::balance(model, pose, &wrench, &mut |matrix, wrench| {
        Ok(match method {
            Method::Qp => {
                let found = quadratic::solve(matrix, wrench, limits, None)?;
                (found.status == Status::Feasible).then_some(found.tensions)
            }
            Method::ClosedForm => {
                let tensions = closed_form::solve(matrix, wrench, limits)?.tensions;
                tensions.iter().all(|tension| *tension >= 0.0).then_some(tensions)
            }
        })
    });
    let balance = balance.map_err(|error| match error {
        DistributionError::Tension(error) => refused(error),
        error => Failure::numerical(error.to_string()),
    })?;
    if let Some(reason) = balance.reason {
        let status = reason.status();
        return Ok(Found { status, reason: Some(reason.words().to_owned()), wrench: Some(wrench), ..Found::default() });
    }
    let found = match method {
        Method::Qp => by_quadratic_programme(
            quadratic::solve(&balance.matrix, &balance.wrench, limits, None).map_err(refused)?,
        )?,
        Method::ClosedForm => {
            let solution = closed_form::solve(&balance.matrix, &balance.wrench, limits).map_err(refused)?;
            let reason = solution.reason(limits);
            Found {
                status: if reason.is_none() { "feasible" } else { "infeasible" },
                reason,
                tensions: Some(solution.tensions),
                wrench_residual: Some(solution.wrench_residual),
                ..Found::default()
            }
        }
    };
    Ok(Found { wrench: Some(wrench), ..found })
}

fn by_quadratic_programme(distribution: quadratic::Distribution) -> Result<Found, Failure> {
    let reason = distribution.reason();
    match distribution.status {
        Status::Feasible => Ok(Found {
            status: "feasible",
            tensions: Some(distribution.tensions),
            wrench_residual: Some(distribution.wrench_residual),
            ..Found::default()
        }),
        Status::Infeasible => Ok(Found {
            status: "infeasible",
            reason,
            certificate: distribution.certificate().map(|proof| Certificate {
                direction: proof.direction.clone(),
                weights: proof.weights.clone(),
                required: proof.required,
                reachable: proof.reachable,
            }),
            ..Found::default()
        }),
        _ => Err(Failure::numerical(reason.unwrap_or_default())),
    }
}

impl Answer for Tensions {
    fn is_negative(&self) -> bool {
        self.found.status != "feasible"
    }

    fn words(&self) -> String {
        let Found { status, reason, tensions, .. } = &self.found;
        let mut text = format!("{}, model {}, at {}: {status}\n", self.robot, self.model, self.pose.words());
        if let Some(reason) = reason {
            text.push_str(&format!("{reason}\n"));
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
