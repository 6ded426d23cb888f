//! Tables and drawings of a field of errors.

use std::fmt::Write;

use cdpr_model::geometry::{MotionPattern, Twist};
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_study::field::{Field, Sample};

use crate::NamedFile;
use crate::answers::axis_names;
use crate::figures::{Figure, Map, MapPoint, TrackedCable, tension_tracking};
use crate::number_format::short;

/// Names of the columns of a twist or wrench of a robot, translations then turns: `{before}{axis}{after}`, of a planar robot along the axes of its plane.
fn columns(robot: &Robot, [before, after]: [&str; 2], [turn, turned]: [&str; 2]) -> Vec<String> {
    let axes = axis_names(robot);
    let turns = match robot.motion_pattern {
        MotionPattern::Planar => vec![format!("{turn}{turned}")],
        MotionPattern::Spatial => axes.iter().map(|axis| format!("{turn}{axis}{turned}")).collect(),
        _ => Vec::new(),
    };
    axes.iter().map(|axis| format!("{before}{axis}{after}")).chain(turns).collect()
}

/// Names of the columns of the commanded pose, of the error twists, and of Aᵀ f + w of the cables held there.
fn headings(robot: &Robot) -> [Vec<String>; 3] {
    let turns: &[&str] = match robot.motion_pattern {
        MotionPattern::Planar => &["angle_rad"],
        MotionPattern::Spatial => &["qx", "qy", "qz", "qw"],
        _ => &[],
    };
    let position = axis_names(robot).into_iter().map(|axis| format!("{axis}_m"));
    let pose = position.chain(turns.iter().map(|name| (*name).to_owned())).collect();
    let turn = if robot.motion_pattern == MotionPattern::Planar { "turn" } else { "r" };
    let mut twists = columns(robot, ["d", "_m"], [turn, "_rad"]);
    twists.extend(columns(robot, ["linear_d", "_m"], [&format!("linear_{turn}"), "_rad"]));
    let moment = if robot.motion_pattern == MotionPattern::Planar { "residual" } else { "residual_" };
    [pose, twists, columns(robot, ["residual_", "_N"], [moment, "_Nm"])]
}

/// One row per commanded pose in the degrees of freedom of the robot, of a planar one along the axes of its plane; empty cells where there is no answer.
pub fn errors_table(found: &Field, robot: &Robot) -> String {
    let cables = found.samples.iter().find_map(|sample| Some(sample.outcome.tensions.as_ref()?.len())).unwrap_or(0);
    let (pattern, basis) = (robot.motion_pattern, robot.motion_pattern.twist_basis(robot.plane));
    let [pose, twists, residual] = headings(robot);
    let mut text = format!("pose,status,{},{}", pose.join(","), twists.join(","));
    (1..=cables).for_each(|cable| text.push_str(&format!(",tension_N_{cable}")));
    let commands = found.summary.tension_error.is_some();
    let commanded = if commands { cables } else { 0 };
    (1..=commanded).for_each(|cable| text.push_str(&format!(",commanded_tension_N_{cable}")));
    if cables > 0 {
        text.push_str(&format!(",{}", residual.join(",")));
    }
    text.push('\n');
    for (index, sample) in found.samples.iter().enumerate() {
        let mut cells = vec![(index + 1).to_string(), sample.outcome.status.name().to_owned()];
        cells.extend(match pattern {
            MotionPattern::Spatial => {
                let (position, turn) = (sample.commanded.position, sample.commanded.rotation.coords);
                position.iter().chain(turn.iter()).map(f64::to_string).collect::<Vec<_>>()
            }
            _ => pattern.pose_to_components(robot.plane, &sample.commanded).iter().map(f64::to_string).collect(),
        });
        let twist = |twist: &Option<Twist>| -> Vec<String> {
            // + 0.0: the sign of zero says nothing
            let cell = |axis: &Twist| twist.map_or_else(String::new, |twist| (axis.dot(&twist) + 0.0).to_string());
            basis.iter().map(cell).collect()
        };
        cells.extend(twist(&sample.exact));
        cells.extend(twist(&sample.linear));
        let listed = |tensions: &Option<Vec<f64>>, count: usize| -> Vec<String> {
            let tensions = tensions.as_deref().unwrap_or(&[]);
            (0..count).map(|cable| tensions.get(cable).map_or_else(String::new, f64::to_string)).collect()
        };
        cells.extend(listed(&sample.outcome.tensions, cables));
        cells.extend(listed(&sample.outcome.commanded_tensions, commanded));
        if cables > 0 {
            cells.extend(twist(&sample.residual_wrench));
        }
        let _ = writeln!(text, "{}", cells.join(","));
    }
    text
}

/// Position errors over the plane of a planar robot; of a spatial one seen along each axis, from above height by height where
/// the poses have few heights.
pub fn error_maps(found: &Field, machine: &Model) -> Vec<NamedFile> {
    let names = ["x", "y", "z"];
    let axes: Vec<usize> = machine.axes().iter().map(|axis| axis.iamax()).collect();
    let views: Vec<[usize; 2]> = match axes.as_slice() {
        &[first, second] => vec![[first, second]],
        _ => vec![[0, 1], [0, 2], [1, 2]],
    };
    let top = 1e3 * found.summary.position_error_m.max;
    let drawn = |[first, second]: [usize; 2], height: Option<f64>| {
        let point = |sample: &Sample| {
            let error = sample.exact?.fixed_rows::<3>(0).norm();
            let position = sample.commanded.position;
            let is_there = height.is_none_or(|height| (position.z - height).abs() < SAME_HEIGHT);
            is_there.then(|| MapPoint { at: [position[first], position[second]], error: 1e3 * error })
        };
        let (at, of) = height.map_or_else(Default::default, |height| {
            let height = short(height);
            (format!("-at-z-{}", height.replace('−', "-")), format!(" at z = {height} m"))
        });
        let map = Map {
            title: Vec::new(),
            arrows: Vec::new(),
            points: found.samples.iter().filter_map(point).collect(),
            axes: [names[first], names[second]].map(str::to_owned),
            top,
            colour_label: format!("position error in mm{of}"),
        };
        Some(NamedFile::new(format!("error-map-{}{}{at}.svg", names[first], names[second]), map.svg()?.file()))
    };
    let of_poses: Vec<f64> = found.samples.iter().map(|sample| sample.commanded.position.z).collect();
    let heights = if axes.len() > 2 { levels(&of_poses) } else { Vec::new() };
    let views = views.into_iter().map(|view| (view, None));
    views
        .chain(heights.into_iter().map(|height| ([0, 1], Some(height))))
        .filter_map(|(view, at)| drawn(view, at))
        .collect()
}

/// Commanded and emerging tensions of every cable over the poses in their order (Figs. 4.17, 4.18); `None` if none are commanded.
pub fn tracking_figure(found: &Field, machine: &Model) -> Option<Figure> {
    found.summary.tension_error?;
    let of_cable = |index: usize| {
        let along = |tensions: &dyn Fn(&Sample) -> Option<f64>| {
            let all = found.samples.iter().enumerate();
            all.filter_map(|(pose, sample)| Some((pose + 1, tensions(sample)?))).collect()
        };
        let at = |tensions: &Option<Vec<f64>>| tensions.as_ref()?.get(index).copied();
        TrackedCable {
            name: machine.robot().cables[index].name.clone(),
            commanded: along(&|sample| at(&sample.outcome.commanded_tensions)),
            emerging: along(&|sample| at(&sample.outcome.tensions).filter(|_| sample.exact.is_some())),
        }
    };
    tension_tracking(&(0..machine.cable_count()).map(of_cable).collect::<Vec<_>>())
}

/// Heights nearer to each other than this are one (m).
pub(crate) const SAME_HEIGHT: f64 = 1e-6;
/// More heights than this are no levels but a cloud.
const MOST_HEIGHTS: usize = 7;

/// The different ones among the heights of poses; empty if all have the same, or nearly each its own.
pub(crate) fn levels(of_poses: &[f64]) -> Vec<f64> {
    let mut heights = of_poses.to_vec();
    heights.sort_by(f64::total_cmp);
    heights.dedup_by(|a, b| (*a - *b).abs() < SAME_HEIGHT);
    let are_levels = (2..=MOST_HEIGHTS).contains(&heights.len()) && of_poses.len() >= 4 * heights.len();
    if are_levels { heights } else { Vec::new() }
}
