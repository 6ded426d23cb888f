//! Placed pulleys of a swept machine.

use nalgebra::Vector3;

use super::point_error::PointError;
use crate::Study;
use cdpr_model::control::InputError;
use cdpr_model::model::place_pulleys;
use cdpr_model::robot::{Cable, Robot};

/// The machine with a pulley of this radius at every cable, placed so that it touches the anchor at the initial pose.
///
/// The swivel axis is `axis` for all cables, or that of each cable in the file.
pub(super) fn with_pulleys(
    machine: &Robot,
    study: &Study,
    radius: f64,
    axis: Option<&[f64]>,
) -> Result<Robot, PointError> {
    let common = match axis {
        None => None,
        Some(&[first, second]) if machine.motion_pattern.is_planar() => Some(machine.plane.embed([first, second])),
        Some(&[x, y, z]) => Some(Vector3::new(x, y, z)),
        Some(_) => return Err(PointError::SwivelAxis),
    };
    let pulley = |cable: &Cable| -> Result<(f64, Vector3<f64>), PointError> {
        let axis = common.or(cable.pulley_swivel_axis());
        let axis = axis.ok_or_else(|| PointError::NoSwivelAxis { cable: cable.name.clone() })?;
        Ok((radius, axis.try_normalize(0.0).ok_or(PointError::NoDirection)?))
    };
    let pulleys: Vec<_> = machine.cables.iter().map(pulley).collect::<Result<_, _>>()?;
    let pose = study.initial_pose(machine).map_err(InputError::from)?;
    Ok(place_pulleys(machine, &pulleys, &pose)?)
}
