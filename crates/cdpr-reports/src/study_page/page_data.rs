//! The data that the program of the page draws from: one JSON block, which `viewer/src/data.ts` describes.
//!
//! Positions and vectors along the axes of the robot's files. No physics is left to the program.

use cdpr_model::geometry::{MotionPattern, Twist};
use cdpr_model::robot::Robot;
use cdpr_study::field::Sample;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::Serialize;

use super::StudyPage;
use super::region::Region;
use crate::answers::{StudyAnswer, components};
use crate::html_page::{Nodes, PageKind, RobotPicture, data_block, digits};

/// Numbers that a page may hold for its poses (about 9 bytes each).
const MOST_NUMBERS: usize = 25_000;

/// Data of a study: the answer, and what its pictures need besides.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "StudyData")]
pub(crate) struct PageData<'a> {
    /// Kind of the page.
    #[schemars(extend("const" = "study"))]
    page: &'static str,
    /// Name of the study.
    name: &'a str,
    result: &'a StudyAnswer,
    /// Robot of the machine.
    robot: RobotPicture,
    samples: SampleData,
    /// The whole workspace first; slices of a spatial robot.
    regions: Vec<RegionData>,
}

/// Commanded poses, each with its answer.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "CommandedSamples")]
struct SampleData {
    /// Poses of the study; more than are listed where the list was thinned out.
    total: usize,
    /// From 1, as in errors.csv.
    number: Vec<usize>,
    /// Components of the pose: position (m), then angles (rad).
    commanded: Vec<Vec<f64>>,
    emerging: Vec<Option<Vec<f64>>>,
    /// Reason for which there is no answer.
    reason: Vec<Option<String>>,
    #[serde(flatten)]
    points: PointData,
}

/// Findings at every pose of a list, along the axes of the robot; null where there is none.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Points")]
struct PointData {
    error_m: Vec<Option<Vec<f64>>>,
    /// Empty for a point; the angle of a planar platform; a rotation vector in space.
    error_rad: Vec<Option<Vec<f64>>>,
    linear_m: Vec<Option<Vec<f64>>>,
    linear_rad: Vec<Option<Vec<f64>>>,
    /// Per cable.
    #[serde(rename = "tensions_N")]
    tensions: Vec<Option<Vec<f64>>>,
    /// Largest difference of a tension from the commanded one; empty where none are commanded.
    #[serde(rename = "tension_error_N")]
    tension_error: Vec<Option<f64>>,
    /// Residual force of the cables held at the commanded pose; empty for a rigid machine.
    #[serde(rename = "residual_N")]
    residual: Vec<Option<f64>>,
}

/// Regular grid in the plane of a planar robot or on a slice through space, the first axis running fastest.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "StudyRegion")]
struct RegionData {
    name: String,
    /// Axes of the robot that the two of the grid run along, from 0.
    plane: [usize; 2],
    /// Coordinate of a slice through space (m); null in the plane of a planar robot.
    level_m: Option<f64>,
    axes: [Nodes; 2],
    #[serde(flatten)]
    points: PointData,
    /// Margins: where they are zero a workspace ends. Null for −∞.
    physical: Option<Vec<Option<f64>>>,
    reachable: Option<Vec<Option<f64>>>,
    /// The same as one linear step predicts.
    linear: Option<Vec<Option<f64>>>,
}

/// The block.
pub(super) fn json(page: &StudyPage<'_>, regions: &[Region]) -> String {
    let robot = page.experiment.machine.robot();
    data_block(&PageData {
        page: PageKind::Study.name(),
        name: page.name,
        result: page.answer,
        robot: RobotPicture::of(robot, &[]),
        samples: samples(page),
        regions: regions.iter().map(|region| region_data(robot, region)).collect(),
    })
}

/// True when the page holds a part of the poses only.
pub(super) fn is_thinned(page: &StudyPage<'_>) -> bool {
    step(page) > 1
}

/// Every how many-th pose is held.
fn step(page: &StudyPage<'_>) -> usize {
    let machine = &page.experiment.machine;
    let numbers = 4 * machine.robot().motion_pattern.dof() + machine.cable_count() + 3;
    (page.found.samples.len() * numbers).div_ceil(MOST_NUMBERS).max(1)
}

/// The poses, evenly thinned out to what a page may hold; the largest error always stays.
fn samples(page: &StudyPage<'_>) -> SampleData {
    let robot = page.experiment.machine.robot();
    let all = &page.found.samples;
    let size = |index: &usize| all[*index].exact.map(|error| error.fixed_rows::<3>(0).norm());
    let answered = (0..all.len()).filter(|index| size(index).is_some());
    let worst = answered.max_by(|a, b| size(a).unwrap_or(0.0).total_cmp(&size(b).unwrap_or(0.0)));
    let step = step(page);
    let kept: Vec<usize> = (0..all.len()).filter(|index| index % step == 0 || Some(*index) == worst).collect();
    let pose = |pose| short(robot.motion_pattern.pose_to_components(robot.plane, pose), 7);
    SampleData {
        total: all.len(),
        number: kept.iter().map(|index| index + 1).collect(),
        commanded: kept.iter().map(|&index| pose(&all[index].commanded)).collect(),
        emerging: kept.iter().map(|&index| all[index].exact.map(|_| pose(&all[index].outcome.pose))).collect(),
        reason: kept.iter().map(|&index| all[index].outcome.reason.clone()).collect(),
        points: points(robot, &kept.iter().map(|&index| &all[index]).collect::<Vec<_>>(), 6),
    }
}

fn region_data(robot: &Robot, region: &Region) -> RegionData {
    let margins = |margins: &Vec<f64>| {
        margins.iter().map(|margin| margin.is_finite().then(|| digits(*margin, 4))).collect::<Vec<_>>()
    };
    RegionData {
        name: region.name.clone(),
        plane: region.slice.map_or([0, 1], |slice| slice.along()),
        level_m: region.slice.map(|slice| slice.level),
        axes: region.axes,
        points: points(robot, &region.samples.iter().collect::<Vec<_>>(), 4),
        physical: region.physical.as_ref().map(margins),
        reachable: region.reachable.as_ref().map(margins),
        linear: region.linear.as_ref().map(margins),
    }
}

/// Errors with six digits, for the page subtracts them; tensions with so many.
fn points(robot: &Robot, samples: &[&Sample], tension_digits: usize) -> PointData {
    let shift = |twist: &Twist| short(components(robot, &twist.fixed_rows::<3>(0).into_owned()), 6);
    let turn = |twist: &Twist| short(turned(robot, &twist.fixed_rows::<3>(3).into_owned()), 6);
    let exact = |of: &dyn Fn(&Twist) -> Vec<f64>| samples.iter().map(|sample| sample.exact.as_ref().map(of)).collect();
    let linear =
        |of: &dyn Fn(&Twist) -> Vec<f64>| samples.iter().map(|sample| sample.linear.as_ref().map(of)).collect();
    let tensions = |sample: &&Sample| {
        let answered = sample.outcome.tensions.clone().filter(|_| sample.exact.is_some());
        answered.map(|tensions| short(tensions, tension_digits))
    };
    let known = |all: Vec<Option<f64>>| if all.iter().any(Option::is_some) { all } else { Vec::new() };
    let tension_error = |sample: &&Sample| {
        let errors = sample.outcome.tension_errors().filter(|_| sample.exact.is_some())?;
        Some(digits(errors.iter().fold(0.0, |largest: f64, error| largest.max(error.abs())), 4))
    };
    let residual = |sample: &&Sample| Some(digits(sample.residual_wrench?.fixed_rows::<3>(0).norm(), 4));
    PointData {
        error_m: exact(&shift),
        error_rad: exact(&turn),
        linear_m: linear(&shift),
        linear_rad: linear(&turn),
        tensions: samples.iter().map(tensions).collect(),
        tension_error: known(samples.iter().map(tension_error).collect()),
        residual: known(samples.iter().map(residual).collect()),
    }
}

/// A rotation vector in the components that the pattern can turn by.
fn turned(robot: &Robot, vector: &Vector3<f64>) -> Vec<f64> {
    match robot.motion_pattern {
        MotionPattern::Planar => vec![vector.dot(&robot.plane.normal())],
        pattern if pattern.has_rotation() => vector.as_slice().to_vec(),
        _ => Vec::new(),
    }
}

fn short(values: Vec<f64>, count: usize) -> Vec<f64> {
    values.into_iter().map(|value| digits(value, count)).collect()
}
