//! How one number moves the platform over the poses, as a picture.

use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_study::Experiment;
use cdpr_study::tolerance::Deviations;
use nalgebra::Vector3;

use super::step;
use super::tables::in_world;
use crate::answers::{axis_names, title};
use crate::figures::{Map, MapPoint};
use crate::number_format::significant;

/// Length of the longest arrow, as a share of what the poses span.
const LONGEST: f64 = 0.1;

/// Discs coloured by |∂r/∂p| and arrows along ∂r/∂p at every pose, for the number p that is `cause` among those of the deviations; spatial robots from
/// above. `None` if no pose tells.
pub fn map(found: &Deviations, experiment: &Experiment, cause: usize) -> Option<String> {
    let machine = &experiment.machine;
    let (by, words) = step(found.causes[cause].kind);
    let moves = moves(found, machine, cause, 1e3 * by);
    let axes: Vec<usize> = machine.axes().iter().take(2).map(|axis| axis.iamax()).collect();
    let &[across, up] = axes.as_slice() else { return None };
    let largest = moves.iter().map(|(_, by)| by.norm()).fold(0.0, f64::max);
    let seen = |vector: &Vector3<f64>| [vector[across], vector[up]];
    let span = |axis: usize| {
        let along = || moves.iter().map(|(pose, _)| pose.position[axis]);
        along().fold(f64::NEG_INFINITY, f64::max) - along().fold(f64::INFINITY, f64::min)
    };
    let scale = if largest > 0.0 { LONGEST * span(across).max(span(up)) / largest } else { 0.0 };
    let arrow = |(pose, by): &(&Pose, Vector3<f64>)| [seen(&pose.position), seen(&(pose.position + by * scale))];
    let names = axis_names(machine.robot());
    let map = Map {
        title: vec![
            format!("How the platform moves with {} changed by {words}", found.causes[cause].name(machine)),
            format!("{} drives {}", title(&experiment.control), title(machine)),
            format!("longest arrow {} mm", significant(largest, 3)),
        ],
        points: moves.iter().map(|(pose, by)| MapPoint { at: seen(&pose.position), error: by.norm() }).collect(),
        arrows: moves.iter().map(arrow).collect(),
        axes: [names[0].clone(), names[1].clone()],
        // nothing moves: all discs have the first colour
        top: if largest > 0.0 { largest } else { 1.0 },
        colour_label: format!("mm by {words}"),
    };
    map.svg().map(|map| map.file())
}

/// The commanded poses, and ∂r/∂p there times a factor.
fn moves<'a>(found: &'a Deviations, machine: &Model, cause: usize, by: f64) -> Vec<(&'a Pose, Vector3<f64>)> {
    let both = found.commanded.iter().zip(&found.poses);
    both.filter_map(|(command, at)| {
        let column = at.derivatives.as_ref().ok()?.pose.column(cause);
        Some((&command.pose, in_world(machine, column.iter().copied()).fixed_rows::<3>(0) * by))
    })
    .collect()
}
