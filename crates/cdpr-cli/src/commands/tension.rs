//! `cdpr tension`: tensions that balance the load.

use std::process::ExitCode;

use cdpr_model::cable::GeometryError;
use cdpr_model::equilibrium::distribution::{self, DistributionError};
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::{Load, StaticsError};
use cdpr_model::tension::{Intervals, Limits, Method, Solver, Status, intervals};
use clap::Args;

use crate::answer::Output;
use crate::failure::Failure;
use crate::inputs::{ModelArguments, PoseArgument, limits_of, load_of};
use crate::numbers::{NumberList, finite_number, number_from_zero};
use crate::tension_method::{MethodArguments, Wishes, methods_in_words, refused};
use cdpr_reports::answers::{TensionAnswer, TensionsFound as Found, undetermined_words};

const EXAMPLES: &str = "\
Examples:
  cdpr tension planar-example --pose 0,5.2
  cdpr tension planar-example --pose 0,5.2 --wrench 0,-1962 --min 1000 --max 8000 --method closed-form
  cdpr tension cogiro --pose 0,0,2,0,0,0 --format json
  cdpr tension planar-example --pose 0,5.2 --method maximum --p 1
  cdpr tension planar-example --pose 0,5.2 --wrench 0,-40000 --method nearest-wrench
  cdpr tension planar-example --pose 0,5.2 --reference previous --previous 5000,5000,3000,3000 --rate 20000 --time-step 0.05";

/// Tension distribution: cable tensions that balance the load at a pose within their limits.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES, long_about = long_about())]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    pose: PoseArgument,

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

fn long_about() -> String {
    let intent = "Tension distribution: cable tensions that balance the load at a pose within their limits, or which cables exclude it";
    format!("{intent}.\n\n{}", methods_in_words())
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    let robot = model.robot();
    let pose = arguments.pose.of(robot)?;
    let load = load_of(robot, arguments.wrench.as_ref())?;
    let limits = limits_of(robot, arguments.min, arguments.max)?;
    let method = arguments.choice.method;
    let wishes = arguments.choice.wishes(&model);
    let (found, limits, intervals) = find(&model, &pose, &load, limits, method, &wishes)?;
    let remark = intervals.and_then(|intervals| undetermined_words(&model, &intervals));
    remark.iter().for_each(|remark| output.remark(remark));
    output.answer(&TensionAnswer::new(&model, &pose, method, found, &limits))
}

/// Answer of the method, the limits in force, and the interval of each tension within them.
fn find(
    model: &Model,
    pose: &Pose,
    load: &Load,
    limits: Limits,
    method: Method,
    wishes: &Wishes,
) -> Result<(Found, Limits, Option<Intervals>), Failure> {
    if let Err(reason) = model.structure_matrix(pose) {
        return match reason {
            GeometryError::NotFinite { .. } => Err(Failure::numerical(reason.to_string())),
            _ => Ok((Found::nothing("infeasible", reason.to_string(), None), limits, None)),
        };
    }
    let wrench = load.in_pattern(model, pose).as_slice().to_vec();
    let options = wishes.options();
    let mut solver = Solver::new(method, model.cable_count(), model.dof());
    // what sagging cables pull follows their tensions: the method is asked until both agree
    let balance = distribution::balance(model, pose, &wrench, &mut |matrix, wrench| {
        let answer = solver.solve(matrix, wrench, &limits, &options)?;
        Ok(answer.has_tensions().then(|| answer.tensions.clone()).filter(|f| f.iter().all(|tension| *tension >= 0.0)))
    });
    let balance = match balance {
        Ok(balance) => balance,
        // a cable that hangs in no shape is an answer about the pose
        Err(DistributionError::Statics(ref error @ StaticsError::CableState { reason, .. }))
            if !reason.is_overflow() =>
        {
            return Ok((Found::nothing("no-shape", error.to_string(), Some(wrench)), limits, None));
        }
        Err(DistributionError::Tension(error)) => return Err(refused(&error)),
        Err(error) => return Err(Failure::numerical(error.to_string())),
    };
    if let Some(reason) = balance.reason {
        return Ok((Found::nothing(reason.status(), reason.to_string(), Some(wrench)), limits, None));
    }
    solver.forget();
    let answer = solver.solve(&balance.matrix, &balance.wrench, &limits, &options).map_err(|error| refused(&error))?;
    if !matches!(answer.status, Status::Feasible | Status::Infeasible | Status::NotFound) {
        return Err(Failure::numerical(answer.reason().unwrap_or_default()));
    }
    let found = Found::of(answer, wrench);
    let found = match method.may_leave_load() {
        true => found.lacking(model, answer, wishes.moment_length(model)),
        false => found,
    };
    let limits = answer.limits.clone();
    // the pull of a sagging cable follows its tension: its balance holds at these tensions only
    let asked = found.is_feasible() && model.cables().has_fixed_directions();
    let pairs: Vec<[f64; 2]> =
        limits.minimum().iter().zip(limits.maximum()).map(|(least, most)| [*least, *most]).collect();
    let intervals = if asked {
        intervals(&balance.matrix, &balance.wrench, &pairs).map_err(|error| refused(&error))?
    } else {
        None
    };
    let intervals = intervals.filter(|intervals| intervals.freedom > 0);
    let found = match &intervals {
        Some(intervals) => found.between(intervals),
        None => found,
    };
    Ok((found, limits, intervals))
}
