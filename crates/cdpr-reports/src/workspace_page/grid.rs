//! The grid of poses that the page interpolates between: verdict, reason and tensions at each node.

use cdpr_model::equilibrium::distribution;
use cdpr_model::geometry::Pose;
use cdpr_workspace::Verdict;
use nalgebra::Vector3;
use rayon::prelude::*;
use schemars::JsonSchema;
use serde::{Serialize, Serializer};

use super::WorkspacePage;
use crate::answers::axis_names;
use crate::html_page::{Nodes, digits, nodes};
use crate::number_format::significant;

/// Numbers that a page may hold for its grid (about 6 bytes each).
const MOST_NUMBERS: usize = 90_000;
/// Nodes of a grid at most: more would not be seen.
const MOST_NODES: usize = 8_000;

/// A direction of the grid and its nodes along it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "GridAxis")]
pub(super) struct Axis {
    pub(super) name: String,
    /// World, of length one.
    #[serde(serialize_with = "components")]
    #[schemars(with = "[f64; 3]")]
    pub(super) direction: Vector3<f64>,
    #[serde(flatten)]
    pub(super) nodes: Nodes,
}

fn components<S: Serializer>(direction: &Vector3<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    <[f64; 3]>::from(*direction).serialize(serializer)
}

/// Finding at a node.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Node {
    pub(super) verdict: Verdict,
    /// Per cable (N); `None` where none keep the limits.
    pub(super) tensions: Option<Vec<f64>>,
}

/// How far interpolated tensions are from computed ones in the middle of the cells.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub(super) struct InterpolationError {
    pub(super) cells: usize,
    /// Mean over cells of the largest difference of a cable.
    #[serde(rename = "mean_N")]
    pub(super) mean: f64,
    #[serde(rename = "largest_N")]
    pub(super) largest: f64,
}

/// The grid, first axis running fastest.
pub(super) struct Grid {
    pub(super) axes: Vec<Axis>,
    /// Position that all nodes share across the axes (world, m).
    pub(super) base: Vector3<f64>,
    pub(super) nodes: Vec<Node>,
    pub(super) interpolation: Option<InterpolationError>,
}

impl Grid {
    pub(super) fn compute(page: &WorkspacePage<'_>) -> Self {
        let axes = axes(page);
        let along: Vector3<f64> =
            axes.iter().map(|axis| axis.direction * axis.direction.dot(&page.start.position)).sum();
        let mut grid = Self { axes, base: page.start.position - along, nodes: Vec::new(), interpolation: None };
        let count = grid.axes.iter().map(|axis| axis.nodes.count).product::<usize>();
        let at = |node: usize| grid.pose(page, &grid.coordinates(node, 0.0));
        let node = |pose: Pose| Node { verdict: (page.judge)(&pose), tensions: tensions(page, &pose) };
        grid.nodes = (0..count).into_par_iter().map(|index| node(at(index))).collect();
        grid.interpolation = grid.check(page);
        grid
    }

    /// Coordinates along the axes of a node, moved on by a share of a cell (m).
    fn coordinates(&self, node: usize, share: f64) -> Vec<f64> {
        let mut rest = node;
        let along = |axis: &Axis| {
            let index = rest % axis.nodes.count;
            rest /= axis.nodes.count;
            axis.nodes.at(index as f64 + share)
        };
        self.axes.iter().map(along).collect()
    }

    fn pose(&self, page: &WorkspacePage<'_>, coordinates: &[f64]) -> Pose {
        let along = |(axis, coordinate): (&Axis, &f64)| axis.direction * *coordinate;
        let position = self.base + self.axes.iter().zip(coordinates).map(along).sum::<Vector3<f64>>();
        Pose { position, rotation: page.start.rotation }
    }

    /// The corners of the cell whose first corner is `node`; `None` at the far ends.
    fn corners(&self, node: usize) -> Option<Vec<usize>> {
        let (mut rest, mut stride) = (node, 1);
        let mut corners = vec![node];
        for axis in &self.axes {
            if axis.nodes.count > 1 {
                if rest % axis.nodes.count + 1 == axis.nodes.count {
                    return None;
                }
                corners.extend(corners.clone().into_iter().map(|corner| corner + stride));
            }
            rest /= axis.nodes.count;
            stride *= axis.nodes.count;
        }
        Some(corners)
    }

    /// Compares interpolation with computation in the middle of every cell all of whose corners have tensions.
    fn check(&self, page: &WorkspacePage<'_>) -> Option<InterpolationError> {
        let difference = |node: usize| -> Option<f64> {
            let corners = self.corners(node)?;
            let known: Option<Vec<&Vec<f64>>> =
                corners.iter().map(|&corner| self.nodes[corner].tensions.as_ref()).collect();
            let known = known?;
            let computed = tensions(page, &self.pose(page, &self.coordinates(node, 0.5)))?;
            let mean = |cable: usize| known.iter().map(|tensions| tensions[cable]).sum::<f64>() / known.len() as f64;
            Some(computed.iter().enumerate().map(|(cable, f)| (f - mean(cable)).abs()).fold(0.0, f64::max))
        };
        let found: Vec<f64> = (0..self.nodes.len()).into_par_iter().filter_map(difference).collect();
        let cells = found.len();
        let (mean, largest) = (found.iter().sum::<f64>() / cells as f64, found.iter().copied().fold(0.0, f64::max));
        (cells > 0).then(|| InterpolationError { cells, mean: digits(mean, 3), largest: digits(largest, 3) })
    }

    /// Description of the grid for readers.
    pub(super) fn statement(&self) -> String {
        let joined = |of: &dyn Fn(&Axis) -> String| self.axes.iter().map(of).collect::<Vec<_>>().join(" × ");
        let counts = joined(&|axis| axis.nodes.count.to_string());
        let steps = joined(&|axis| significant(axis.nodes.step, 3));
        let held = self.nodes.iter().filter(|node| node.verdict.holds()).count();
        format!("{counts} = {} grid points, {steps} m apart; the criterion holds at {held} of them", self.nodes.len())
    }

    /// How good interpolation is, for readers.
    pub(super) fn check_words(&self) -> Option<String> {
        let InterpolationError { cells, mean, largest } = self.interpolation?;
        let cells = if cells == 1 { "1 cell".to_owned() } else { format!("{cells} cells") };
        Some(format!(
            "in the middle of {cells}, interpolated tensions differ from computed ones by {} N on average and by {} N at most",
            significant(mean, 2),
            significant(largest, 2)
        ))
    }
}

/// Evenly spaced nodes that fill the box, as many as a page may hold, the spacing about the same along all axes.
fn axes(page: &WorkspacePage<'_>) -> Vec<Axis> {
    let robot = page.model.robot();
    let directions = match robot.motion_pattern.is_planar() {
        true => vec![robot.plane.first_axis(), robot.plane.second_axis()],
        false => vec![Vector3::x(), Vector3::y(), Vector3::z()],
    };
    let numbers_per_node = robot.cable_count() + 4;
    let most = (MOST_NUMBERS / numbers_per_node).min(MOST_NODES);
    let named = axis_names(robot).into_iter().zip(directions);
    let along = named.zip(nodes(page.bounds, most));
    along.map(|((name, direction), nodes)| Axis { name, direction, nodes }).collect()
}

fn tensions(page: &WorkspacePage<'_>, pose: &Pose) -> Option<Vec<f64>> {
    let (load, limits) = page.statics?;
    let found = distribution::solve(page.model, pose, load, limits).ok()?;
    found.reason.is_none().then_some(found.tensions)
}
