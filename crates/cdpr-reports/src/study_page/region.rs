//! Regions with errors on a regular grid, which the page draws contours through: of the plane of a planar robot, and slices through
//! the poses of a spatial one.

use cdpr_model::geometry::Pose;
use cdpr_study::Experiment;
use cdpr_study::field::{Field, Sample, field};
use cdpr_workspace::{Bounds, Criterion};

use super::StudyPageError;
use crate::answers::axis_names;
use crate::html_page::{Nodes, nodes};
use crate::number_format::{short, significant};

/// Numbers that a page may hold for one region (about 9 bytes each).
const MOST_NUMBERS: usize = 30_000;
/// Nodes of a region at most: more would not be seen.
const MOST_NODES: usize = 3_000;
/// The region around the poses reaches further than their box by this share of its longer side.
const AROUND: f64 = 0.1;

/// Slices of a spatial robot at most; where its poses have more levels, as many evenly spaced ones.
const MOST_SLICES: usize = 5;
/// Levels nearer to each other than this are one (m).
const SAME_LEVEL: f64 = 1e-6;

/// A part of a plane.
pub(super) struct Region {
    /// Name for readers.
    pub(super) name: String,
    /// The plane that it lies in, of a spatial robot.
    pub(super) slice: Option<Slice>,
    /// Nodes along the two axes.
    pub(super) axes: [Nodes; 2],
    /// Outcome of control model and machine at every node, the first axis running fastest.
    pub(super) samples: Vec<Sample>,
    /// Margin of the machine's wrench feasibility at every node; `None` where its limits are unknown.
    pub(super) physical: Option<Vec<f64>>,
    /// Margin of what counts as reached at every node; `None` where nothing is asked for.
    pub(super) reachable: Option<Vec<f64>>,
    /// The same as one linear step tells; `None` for a rigid machine too.
    pub(super) linear: Option<Vec<f64>>,
}

/// A plane across an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Slice {
    /// The axis across, from 0.
    pub(super) axis: usize,
    /// Coordinate of the cut (m).
    pub(super) level: f64,
}

impl Slice {
    /// The two axes that it runs along.
    pub(super) fn along(&self) -> [usize; 2] {
        [[1, 2], [0, 2], [0, 1]][self.axis]
    }
}

impl Region {
    /// Description for readers.
    pub(super) fn statement(&self) -> String {
        let [first, second] = [self.axes[0], self.axes[1]];
        format!(
            "{}: {} × {} grid points, {} m × {} m apart",
            self.name,
            first.count,
            second.count,
            significant(first.step, 3),
            significant(second.step, 3)
        )
    }
}

/// The surroundings of the poses and the whole workspace; of a spatial robot slices through the surroundings of the poses.
pub(super) fn regions(experiment: &Experiment, found: &Field) -> Result<Vec<Region>, StudyPageError> {
    let robot = experiment.machine.robot();
    let angle = angle(experiment, found)?;
    if !robot.motion_pattern.is_planar() {
        return slices(experiment, found, angle);
    }
    let plane = Plane { experiment, slice: None, angle, most_numbers: MOST_NUMBERS };
    let poses: Vec<[f64; 2]> =
        found.samples.iter().map(|sample| robot.plane.components(&sample.commanded.position)).collect();
    let around_poses = widened(box_of(&poses));
    let mut boxes = vec![("the whole workspace", plane.whole(box_of(&poses))?)];
    boxes.extend(around_poses.map(|ends| ("the surroundings of the poses", ends)));
    boxes.into_iter().map(|(name, ends)| plane.region(name.to_owned(), ends)).collect()
}

/// Level slices at the heights of the poses; upright ones where the poses lie in an upright plane; none along a line.
fn slices(experiment: &Experiment, found: &Field, angle: Vec<f64>) -> Result<Vec<Region>, StudyPageError> {
    let along = |axis: usize| found.samples.iter().map(move |sample| sample.commanded.position[axis]);
    let extent =
        |axis: usize| along(axis).fold(f64::NEG_INFINITY, f64::max) - along(axis).fold(f64::INFINITY, f64::min);
    let Some(axis) =
        [2, 1, 0].into_iter().find(|&axis| (0..3).all(|other| other == axis || extent(other) > SAME_LEVEL))
    else {
        return Ok(Vec::new());
    };
    let levels = levels(along(axis).collect());
    let names = axis_names(experiment.machine.robot());
    let slice = |level: &f64| {
        let slice = Slice { axis, level: *level };
        let [first, second] = slice.along();
        let poses: Vec<[f64; 2]> = along(first).zip(along(second)).map(|(a, b)| [a, b]).collect();
        let name = format!("{}–{} at {} = {} m", names[first], names[second], names[axis], short(*level));
        let plane = Plane {
            experiment,
            slice: Some(slice),
            angle: angle.clone(),
            most_numbers: 2 * MOST_NUMBERS / levels.len(),
        };
        widened(box_of(&poses)).map(|ends| plane.region(name, ends))
    };
    levels.iter().filter_map(slice).collect()
}

/// Those that differ, in order; evenly spaced ones where there are too many.
fn levels(mut all: Vec<f64>) -> Vec<f64> {
    all.sort_by(f64::total_cmp);
    all.dedup_by(|a, b| (*a - *b).abs() < SAME_LEVEL);
    match all[..] {
        [low, .., high] if all.len() > MOST_SLICES => {
            (0..MOST_SLICES).map(|k| low + (high - low) * k as f64 / (MOST_SLICES - 1) as f64).collect()
        }
        _ => all,
    }
}

/// The orientation that all poses share, else the one at which the winches were set, as the pattern's components beyond the
/// position.
fn angle(experiment: &Experiment, found: &Field) -> Result<Vec<f64>, StudyPageError> {
    let robot = experiment.machine.robot();
    let first = found.samples.first().map(|sample| sample.commanded);
    let is_shared = |pose: &Pose| found.samples.iter().all(|sample| sample.commanded.angle_to(pose) < 1e-9);
    let pose = match first.filter(is_shared) {
        Some(pose) => pose,
        None => experiment.start,
    };
    let pattern = robot.motion_pattern;
    Ok(pattern.pose_to_components(robot.plane, &pose)[pattern.translations()..].to_vec())
}

/// Least and largest component along both axes.
fn box_of(points: &[[f64; 2]]) -> [[f64; 2]; 2] {
    let ends = |axis: usize| {
        let along = || points.iter().map(|point| point[axis]);
        [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
    };
    [ends(0), ends(1)]
}

/// The box and what is around it; nothing around a single point.
fn widened(ends: [[f64; 2]; 2]) -> Option<[[f64; 2]; 2]> {
    let longest = ends.iter().map(|[low, high]| high - low).fold(0.0, f64::max);
    let more = AROUND * longest;
    (more > 0.0 && more.is_finite()).then(|| ends.map(|[low, high]| [low - more, high + more]))
}

/// Axes of poses with two components to choose.
struct Plane<'a> {
    experiment: &'a Experiment,
    slice: Option<Slice>,
    /// Components of the pose beyond its position (rad).
    angle: Vec<f64>,
    /// Numbers that the page may hold for a region.
    most_numbers: usize,
}

impl Plane<'_> {
    /// The box of the machine's physical workspace and of the poses, or a box around the robot where that workspace is unknown
    /// or empty.
    fn whole(&self, poses: [[f64; 2]; 2]) -> Result<[[f64; 2]; 2], StudyPageError> {
        let around = Bounds::around(&self.experiment.machine)?;
        let ends: Vec<[f64; 2]> = around.ends().as_chunks::<2>().0.to_vec();
        let axes = nodes(&[ends[0], ends[1]], MOST_NODES);
        let places = self.places(&axes);
        let held: Vec<[f64; 2]> = match self.physical(&places)? {
            Some(margins) => {
                places.iter().zip(margins).filter(|(_, margin)| *margin >= 0.0).map(|(at, _)| *at).collect()
            }
            None => Vec::new(),
        };
        if held.is_empty() {
            return Ok([ends[0], ends[1]]);
        }
        let [found, step] = [box_of(&held), [[axes[0].step; 2], [axes[1].step; 2]]];
        let with_poses = |axis: usize| {
            let [low, high] = found[axis];
            [(low - step[axis][0]).min(poses[axis][0]), (high + step[axis][1]).max(poses[axis][1])]
        };
        Ok([with_poses(0), with_poses(1)])
    }

    fn region(&self, name: String, ends: [[f64; 2]; 2]) -> Result<Region, StudyPageError> {
        let experiment = self.experiment;
        let numbers_per_node = 2 * experiment.machine.dof() + experiment.machine.cable_count() + 5;
        let axes = nodes(&ends, (self.most_numbers / numbers_per_node).min(MOST_NODES));
        let places = self.places(&axes);
        let poses = self.poses(&places)?;
        let samples = field(&experiment.driving()?, &poses).samples;
        let reachable = experiment.reachable().ok();
        let linear = reachable.as_ref().filter(|_| experiment.tensions_emerge()).map(|reachable| {
            let criterion = reachable.by_linear_step();
            poses.iter().map(|pose| criterion.judge(pose).margin).collect()
        });
        let reachable = reachable.map(|reachable| {
            samples.iter().map(|sample| reachable.verdict(&sample.commanded, &sample.outcome).margin).collect()
        });
        Ok(Region {
            name,
            slice: self.slice,
            axes: [axes[0], axes[1]],
            samples,
            physical: self.physical(&places)?,
            reachable,
            linear,
        })
    }

    fn physical(&self, places: &[[f64; 2]]) -> Result<Option<Vec<f64>>, StudyPageError> {
        let Some(criterion) = self.experiment.feasible(&self.experiment.machine) else { return Ok(None) };
        let poses = self.poses(places)?;
        Ok(Some(poses.iter().map(|pose| criterion.judge(pose).margin).collect()))
    }

    /// The nodes, the first axis running fastest.
    fn places(&self, axes: &[Nodes]) -> Vec<[f64; 2]> {
        let [first, second] = [axes[0], axes[1]];
        let row = |up: usize| (0..first.count).map(move |across| [first.at(across as f64), second.at(up as f64)]);
        (0..second.count).flat_map(row).collect()
    }

    fn poses(&self, places: &[[f64; 2]]) -> Result<Vec<Pose>, StudyPageError> {
        let robot = self.experiment.machine.robot();
        let pose = |at: &[f64; 2]| {
            let mut position = at.to_vec();
            if let Some(Slice { axis, level }) = self.slice {
                position.insert(axis, level);
            }
            robot.motion_pattern.pose(robot.plane, &[position, self.angle.clone()].concat())
        };
        let poses: Result<Vec<Pose>, _> = places.iter().map(pose).collect();
        Ok(poses?)
    }
}
