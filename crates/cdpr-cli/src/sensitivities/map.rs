//! How one number moves the platform over the poses, as a picture.

use cdpr::geometry::Pose;
use cdpr::nalgebra::Vector3;

use super::tables::in_world;
use super::words::step;
use super::{Found, place_of};
use crate::failure::Failure;
use crate::figures::{Map, MapPoint};
use crate::laboratory::Laboratory;
use crate::number_format::significant;
use crate::pose_answer::axis_names;

/// Length of the longest arrow, as a share of what the poses span.
const LONGEST: f64 = 0.1;

/// Discs coloured by |∂r/∂p| and arrows along ∂r/∂p at every pose, for the number p of this name; spatial robots from above.
pub(crate) fn map(found: &Found, laboratory: &Laboratory, name: &str) -> Result<String, Failure> {
    let machine = &laboratory.machine;
    let cause = place_of(&found.causes, machine, name, "--map")?;
    let (by, words) = step(found.causes[cause].kind);
    let moves: Vec<(&Pose, Vector3<f64>)> = found
        .commanded
        .iter()
        .zip(&found.poses)
        .filter_map(|(command, at)| {
            let column = at.derivatives.as_ref().ok()?.pose.column(cause);
            let twist = in_world(machine, column.iter().copied());
            Some((&command.pose, twist.fixed_rows::<3>(0) * (1e3 * by)))
        })
        .collect();
    let axes: Vec<usize> = machine.axes().iter().take(2).map(|axis| axis.iamax()).collect();
    let &[across, up] = axes.as_slice() else { return Err(nothing(name)) };
    let largest = moves.iter().map(|(_, by)| by.norm()).fold(0.0, f64::max);
    let seen = |vector: &Vector3<f64>| [vector[across], vector[up]];
    let span = [across, up].map(|axis| {
        let range = moves
            .iter()
            .map(|(pose, _)| pose.position[axis])
            .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
        range[1] - range[0]
    });
    let scale = if largest > 0.0 { LONGEST * span[0].max(span[1]) / largest } else { 0.0 };
    let arrow = |(pose, by): &(&Pose, Vector3<f64>)| [seen(&pose.position), seen(&(pose.position + by * scale))];
    let title = |model: &cdpr::model::Model| format!("{} ({})", model.robot().name, model.composition());
    let names = axis_names(machine.robot());
    let map = Map {
        title: vec![
            format!("How the platform moves with {} changed by {words}", found.causes[cause].name(machine)),
            format!("{} drives {}", title(&laboratory.control), title(machine)),
            format!("longest arrow {} mm", significant(largest, 3)),
        ],
        points: moves.iter().map(|(pose, by)| MapPoint { at: seen(&pose.position), error: by.norm() }).collect(),
        arrows: moves.iter().map(arrow).collect(),
        axes: [names[0].clone(), names[1].clone()],
        // nothing moves: all discs have the first colour
        top: if largest > 0.0 { largest } else { 1.0 },
        colour_label: format!("mm by {words}"),
    };
    map.svg().ok_or_else(|| nothing(name))
}

fn nothing(name: &str) -> Failure {
    let message = format!("--map: no pose tells how the platform moves with \"{name}\"");
    Failure::input("study::no-poses", message, "leave --map out".to_owned())
}
