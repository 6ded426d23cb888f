//! Data of cables that criteria need: keys of the file, paths at a pose, and names.

use nalgebra::Vector3;

use super::clearance::Segment;
use crate::wrench_set::{CABLE_LIMIT, WrenchSetError};
use crate::{Verdict, WorkspaceError};
use cdpr_model::cable::CablePath;
use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::robot::{Cable, Robot};
use cdpr_model::tension::{InputError, Limits};

/// "cable 3", followed by its name if that differs from its number.
pub(super) fn named(robot: &Robot, cable: usize) -> String {
    let (number, name) = ((cable + 1).to_string(), &robot.cables[cable].name);
    match *name == number {
        true => format!("cable {number}"),
        false => format!("cable {number} (\"{name}\")"),
    }
}

/// A number per cable: `given` for all cables, else that of the file.
pub(super) fn per_cable(
    robot: &Robot,
    criterion: &'static str,
    key: &'static str,
    given: Option<f64>,
    of: impl Fn(&Cable) -> Option<f64>,
) -> Result<Vec<f64>, WorkspaceError> {
    let number = |(index, cable)| {
        given.or(of(cable)).ok_or_else(|| WorkspaceError::MissingKey {
            criterion,
            robot: robot.name.clone(),
            key: format!("`{key}` of {}", named(robot, index)),
            cure: "add it, or give the number for all cables".to_owned(),
        })
    };
    robot.cables.iter().enumerate().map(number).collect()
}

/// Least and largest limit per cable. A limit that no cable has is −∞ or ∞; one that some cables have, all must have;
/// one of both is required.
pub(super) fn limits(
    robot: &Robot,
    criterion: &'static str,
    keys: [&'static str; 2],
    given: [Option<f64>; 2],
    of: [fn(&Cable) -> Option<f64>; 2],
) -> Result<Vec<[f64; 2]>, WorkspaceError> {
    let known = [0, 1].map(|end| given[end].is_some() || robot.cables.iter().any(|cable| of[end](cable).is_some()));
    let mut limits = vec![[f64::NEG_INFINITY, f64::INFINITY]; robot.cable_count()];
    for end in [0, 1] {
        // without any limit the larger one is required
        if known[end] || (end == 1 && !known[0]) {
            let numbers = per_cable(robot, criterion, keys[end], given[end], of[end])?;
            limits.iter_mut().zip(numbers).for_each(|(limits, number)| limits[end] = number);
        }
    }
    match limits.iter().position(|[least, largest]| !(least <= largest)) {
        Some(cable) => Err(WorkspaceError::Setting {
            criterion,
            setting: keys[0],
            value: limits[cable][0],
            wanted: "the least limit is a number not above the largest one",
        }),
        None => Ok(limits),
    }
}

/// A number of a criterion that must be finite, and not below zero.
pub(super) fn not_negative(
    criterion: &'static str,
    setting: &'static str,
    value: f64,
    wanted: &'static str,
) -> Result<f64, WorkspaceError> {
    match value >= 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(WorkspaceError::Setting { criterion, setting, value, wanted }),
    }
}

/// Length that compares moments with forces (m), the platform radius if none is given.
pub(super) fn length_scale(model: &Model, criterion: &'static str, given: Option<f64>) -> Result<f64, WorkspaceError> {
    let value = given.unwrap_or_else(|| model.platform_radius());
    match value > 0.0 && value.is_finite() {
        true => Ok(value),
        false => Err(WorkspaceError::Setting {
            criterion,
            setting: "length scale",
            value,
            wanted: "it is a finite length above zero (m)",
        }),
    }
}

/// The platform radius (m) as length scale, of a model whose structure matrix does not depend on tensions.
pub(crate) fn length_scale_of(model: &Model, criterion: &'static str) -> Result<f64, WorkspaceError> {
    fixed_directions(model, criterion)?;
    length_scale(model, criterion, None)
}

/// Refuses limits of another number of cables, and more cables than wrench sets are made of.
pub(crate) fn check_limits(model: &Model, limits: &Limits) -> Result<(), WorkspaceError> {
    let (expected, found) = (model.cable_count(), limits.cable_count());
    if expected != found {
        return Err(InputError::LimitCount { expected, found }.into());
    }
    if expected > CABLE_LIMIT {
        return Err(WrenchSetError::TooManyCables { found: expected }.into());
    }
    Ok(())
}

/// Refuses a model whose structure matrix depends on its tensions, for a criterion that uses the matrix alone.
pub(super) fn fixed_directions(model: &Model, criterion: &'static str) -> Result<(), WorkspaceError> {
    match model.cables().has_fixed_directions() {
        true => Ok(()),
        false => Err(WorkspaceError::SaggingCables { criterion }),
    }
}

/// The path of a cable, and its moment arm b = R b_P (world, m).
pub(super) type CablePathAndArm = (CablePath<f64>, Vector3<f64>);

/// Paths of all cables, or the verdict that a cable has none.
pub(super) fn paths(model: &Model, pose: &Pose) -> Result<Vec<CablePathAndArm>, Verdict> {
    let path = |cable| {
        model.path(cable, pose).map_err(|error| Verdict::impossible(error.to_string(), Some(error.cable() - 1)))
    };
    (0..model.cable_count()).map(path).collect()
}

/// The free parts of all cables, from the outlet to the platform anchor (world); sag is left out.
pub(super) fn straight(model: &Model, pose: &Pose) -> Result<Vec<Segment>, Verdict> {
    let segment = |(path, moment_arm): CablePathAndArm| {
        let anchor = pose.position + moment_arm;
        Segment { from: anchor + Vector3::from(path.direction) * path.free_length, to: anchor }
    };
    Ok(paths(model, pose)?.into_iter().map(segment).collect())
}

/// The degree of freedom with the largest component of a direction: "along x", "about z".
pub(super) fn mainly(model: &Model, direction: impl Iterator<Item = f64>) -> String {
    let largest = direction.enumerate().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).map_or(0, |(row, _)| row);
    let twist = model.twist_basis()[largest];
    let place = twist.iter().position(|&component| component != 0.0).unwrap_or(0);
    format!("{} {}", if place < 3 { "along" } else { "about" }, ["x", "y", "z"][place % 3])
}
