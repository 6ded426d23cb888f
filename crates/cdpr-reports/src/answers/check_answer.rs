//! Facts about a robot that does not move.

use cdpr_model::cable::GeometryError;
use cdpr_model::equilibrium::ForwardProblem;
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Model, Supported};
use cdpr_model::robot::{Assumption, Robot};
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_model::tension::quadratic::{self, Status};
use nalgebra::DMatrix;
use schemars::JsonSchema;
use serde::Serialize;

use super::missing_effects::{self, MissingEffect, missing_effects};
use super::{Answer, PoseAnswer, assumed_numbers, inertia_doubt};
use crate::keys::FoundKeys;

/// Facts, models and oddities of a robot at its home pose.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "RobotCheck")]
pub struct CheckAnswer {
    robot: String,
    /// `checked`, or `singular` for a home pose that the cables do not hold.
    status: &'static str,
    reason: Option<String>,
    name: String,
    title: Option<String>,
    motion_pattern: &'static str,
    /// Number of degrees of freedom.
    degrees_of_freedom: usize,
    cable_count: usize,
    /// The home pose, and what the cables can do there.
    home: Home,
    /// Models that `--model` can name for this file.
    models: Models,
    /// Numbers of the file that no source states and nobody measured.
    assumptions: Vec<Assumption>,
    warnings: Vec<String>,
    /// Doubts about numbers of the file, which are warnings too.
    findings: Vec<FoundKeys>,
}

/// Models that `--model` can name for this file.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "SupportedModels")]
struct Models {
    /// As many effects as the file supports at once.
    richest: String,
    /// All effects that it supports, also those that exclude each other.
    effects: Vec<&'static str>,
    /// Effects that the file does not support.
    missing: Vec<MissingEffect>,
}

/// Home pose, and what the cables can do there.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "HomePose")]
struct Home {
    pose: PoseAnswer,
    /// Rank of the structure matrix; null where a cable has no unique path.
    rank: Option<usize>,
    /// Condition of the structure matrix, moment rows divided by the mean platform radius; null where it has none.
    condition: Option<f64>,
    /// True where tensions within the limits hold the load; null where this is not known.
    feasible: Option<bool>,
    /// The reason in words.
    feasible_note: String,
}

impl Models {
    fn new(supported: &Supported) -> Self {
        let others = supported.alternatives.iter().map(|(effect, _)| *effect);
        Self {
            richest: supported.richest.to_string(),
            effects: supported.richest.effects().chain(others).collect(),
            missing: missing_effects(supported),
        }
    }

    fn words(&self) -> String {
        match self.effects.as_slice() {
            [] => "standard".to_owned(),
            [only] => format!("standard, {only}"),
            several => format!("standard, {}; at most {}", several.join(", "), self.richest),
        }
    }
}

/// Whether tensions within limits balance the load, and why (not), or what is missing for an answer.
fn feasibility(model: &Model, pose: &Pose) -> (Option<bool>, String) {
    let unknown = |reason: String| (None, format!("not assessed: {reason}"));
    let load = match Load::of(model.robot()) {
        Ok(load) => load,
        Err(missing) => return unknown(missing.to_string()),
    };
    let limits = match Limits::of(model.robot(), None, None) {
        Ok(limits) => limits,
        Err(missing) => return unknown(missing.to_string()),
    };
    let matrix = match model.structure_matrix(pose) {
        Ok(matrix) => matrix,
        Err(reason) => return unknown(reason.to_string()),
    };
    match quadratic::solve(&matrix, load.in_pattern(model, pose).as_slice(), &limits, None) {
        Ok(found) if found.status == Status::Feasible => {
            (Some(true), "tensions within their limits balance the load".to_owned())
        }
        Ok(found) if found.status == Status::Infeasible => (Some(false), found.reason().unwrap_or_default()),
        Ok(found) => unknown(found.reason().unwrap_or_default()),
        Err(error) => unknown(error.to_string()),
    }
}

/// Aᵀ with its moment rows divided by the mean platform radius, so that all rows are without unit.
fn scaled_structure_matrix(model: &Model, pose: &Pose) -> Result<DMatrix<f64>, GeometryError> {
    let mut matrix = model.structure_matrix(pose)?;
    let radius = model.platform_radius();
    for row in model.robot().motion_pattern.translations()..model.dof() {
        matrix.row_mut(row).scale_mut(1.0 / radius);
    }
    Ok(matrix)
}

fn rank_and_condition(matrix: &DMatrix<f64>) -> (usize, f64) {
    let values = matrix.clone().singular_values();
    let (largest, smallest) = (values.max(), values.min());
    // singular values below this are rounding of an exact zero
    let tolerance = 10.0 * matrix.ncols().max(matrix.nrows()) as f64 * f64::EPSILON * largest;
    let rank = values.iter().filter(|&&value| value > tolerance).count();
    (rank, if rank == matrix.nrows() { largest / smallest } else { f64::INFINITY })
}

/// Said of robots with fewer cables than degrees of freedom.
fn load_warning(model: &Model) -> Option<String> {
    let (dof, cables) = (model.dof(), model.cable_count());
    if cables >= dof {
        return None;
    }
    let answer = match ForwardProblem::of(model, Load::of(model.robot()).is_ok()) {
        ForwardProblem::Equilibrium => "`fk` answers where cables and load are in equilibrium",
        ForwardProblem::LeastSquares => "while the file states no load, `fk` calls it singular",
    };
    Some(format!("{cables} cables cannot hold {dof} degrees of freedom: the pose also depends on the load; {answer}"))
}

/// Why the home pose is singular; fewer cables than degrees of freedom can hold no more than their number of them.
fn singular(model: &Model, rank: usize) -> Option<String> {
    let (dof, cables) = (model.dof(), model.cable_count());
    (rank < dof.min(cables)).then(|| {
        format!("at the home pose the cables resist only {rank} of {dof} degrees of freedom: it is a singular pose")
    })
}

/// Warnings about keys that the file leaves open or states strangely.
fn file_warnings(robot: &Robot) -> Vec<String> {
    let mut warnings = Vec::new();
    let mut warn = |applies: bool, text: &str| {
        if applies {
            warnings.push(text.to_owned());
        }
    };
    warn(robot.home.is_none(), "no [home_pose]: the middle of the frame anchors, unturned, stands for it");
    if let (Some(home), Some(travel)) = (&robot.home, &robot.travel) {
        let axes = 0..3;
        let outside = axes.into_iter().any(|axis| {
            // the plane of a planar robot leaves one axis without extent
            home.position[axis] < travel.min[axis] || home.position[axis] > travel.max[axis]
        });
        warn(outside, "the home pose lies outside the [workspace] box");
    }
    let some = |has: fn(&cdpr_model::robot::Cable) -> bool| robot.cables.iter().any(has);
    let all = |has: fn(&cdpr_model::robot::Cable) -> bool| robot.cables.iter().all(has);
    warn(
        !all(|cable| cable.tension_min.is_some() && cable.tension_max.is_some()),
        "tension limits are missing (tension_min_N, tension_max_N)",
    );
    let mass_or_wrench = robot.platform.mass.is_some() || robot.external_wrench.is_some();
    warn(!mass_or_wrench, "neither platform mass_kg nor [external_wrench] is known");
    let has_radius = some(|cable| cable.pulley_radius().is_some_and(|radius| radius > 0.0));
    warn(
        has_radius && !all(|cable| cable.pulley_swivel_axis().is_some()),
        "pulley radii without pulley_swivel_axis: the model `pulley` needs both, `cdpr place-pulleys` adds the axes",
    );
    warnings.extend(inertia_doubt::of_robot(robot));
    warnings
}

impl CheckAnswer {
    /// The answer for the standard model of a robot that supports these effects.
    pub fn of(model: &Model, supported: &Supported) -> Self {
        let robot = model.robot();
        let pose = robot.home_or_middle();
        let doubts = robot.doubts();
        let mut warnings: Vec<String> = doubts.iter().map(|doubt| doubt.text.clone()).collect();
        warnings.extend(file_warnings(robot));
        warnings.extend(load_warning(model));
        let (rank, condition, reason) = match scaled_structure_matrix(model, &pose) {
            Ok(matrix) => {
                let (rank, condition) = rank_and_condition(&matrix);
                (Some(rank), Some(condition), singular(model, rank))
            }
            Err(reason) => (None, None, Some(format!("the home pose is singular: {reason}"))),
        };
        warnings.extend(reason.clone());
        let (feasible, feasible_note) = feasibility(model, &pose);
        Self {
            robot: robot.name.clone(),
            status: if reason.is_none() { "checked" } else { "singular" },
            reason,
            name: robot.name.clone(),
            title: robot.title.clone(),
            motion_pattern: robot.motion_pattern.name(),
            degrees_of_freedom: model.dof(),
            cable_count: model.cable_count(),
            home: Home { pose: PoseAnswer::new(robot, &pose), rank, condition, feasible, feasible_note },
            models: Models::new(supported),
            assumptions: robot.assumptions.clone(),
            warnings,
            findings: doubts.iter().map(FoundKeys::of).collect(),
        }
    }
}

impl Answer for CheckAnswer {
    fn is_negative(&self) -> bool {
        self.reason.is_some()
    }

    fn words(&self, _width: Option<usize>) -> String {
        let Self { name, motion_pattern, degrees_of_freedom, cable_count, home, .. } = self;
        let title = self.title.as_ref().map(|title| format!(": {title}")).unwrap_or_default();
        let structure = match (home.rank, home.condition) {
            (Some(rank), Some(number)) if number.is_finite() => {
                format!("rank {rank} of {degrees_of_freedom}, condition {number:.3}")
            }
            (Some(rank), _) => format!("rank {rank} of {degrees_of_freedom}"),
            _ => "none: a cable has no course".to_owned(),
        };
        let mut text = format!(
            "{name}{title}\n\nmotion pattern    {motion_pattern}\ncables            {cable_count}\n\
             home pose         {}\nstructure matrix  {structure}\ntensions          {}\nmodels            {}\n{}",
            home.pose.words(),
            home.feasible_note,
            self.models.words(),
            missing_effects::line(&self.models.missing),
        );
        if self.warnings.is_empty() {
            text.push_str("\nno warnings\n");
        } else {
            text.push_str("\nwarnings\n");
            self.warnings.iter().for_each(|warning| text.push_str(&format!("  {warning}\n")));
        }
        text + &assumed_numbers::section("assumed numbers, neither printed nor measured", &self.assumptions)
    }
}
