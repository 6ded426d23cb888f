//! States and lengths of a model's cables at a pose with given tensions.

use super::error::StaticsError;
use crate::cable::law::{CableLengths, unit_spring};
use crate::cable::stretch::hysteresis::Memory;
use crate::cable::{CableInput, CableState};
use crate::geometry::Pose;
use crate::model::Model;

/// State of one cable (0-based) of a model at a pose with a tension (N), measured at the outlet or at the place that
/// the file states.
pub fn cable_state(model: &Model, pose: &Pose, index: usize, tension: f64) -> Result<CableState, StaticsError> {
    state_of(model, pose, index, model.measured_tension(index, tension))
}

/// State of one cable (0-based) with a tension at its outlet (N), as forward problems give it.
pub fn cable_state_at_outlet(
    model: &Model,
    pose: &Pose,
    index: usize,
    tension: f64,
) -> Result<CableState, StaticsError> {
    state_of(model, pose, index, CableInput::OutletTension(tension))
}

fn state_of(model: &Model, pose: &Pose, index: usize, input: CableInput) -> Result<CableState, StaticsError> {
    // a pose without a path gives the error of the geometry
    let (path, end) = model.checked_path(index, pose.position.into(), &pose.rotation_rows())?;
    let state = model.law(index).state_on(&path, &end, input, None);
    let state = state.and_then(CableState::unless_overstretched);
    state.map_err(|reason| StaticsError::of_cable(index, path.length, reason))
}

/// State of one straight cable (0-based) as a spring of 1 N/m, with the tension of any sign (N) that `tension` gives
/// for its length (m).
pub fn unit_spring_state(
    model: &Model,
    pose: &Pose,
    index: usize,
    tension: impl FnOnce(f64) -> f64,
) -> Result<CableState, StaticsError> {
    let (path, end) = model.checked_path(index, pose.position.into(), &pose.rotation_rows())?;
    Ok(unit_spring(&path, &end, model.law(index).recording, tension(path.length)))
}

/// Lengths of one cable (0-based) with a tension at the place where the robot measures it (N; NaN if unknown), starting
/// from a memory or never loaded: the exact inverse of the cable law (eq. 2.37, 2.41). All cables share the rows of the
/// pose's rotation.
pub fn cable_lengths(
    model: &Model,
    pose: &Pose,
    rotation: &[[f64; 3]; 3],
    index: usize,
    tension: f64,
    memory: Option<&Memory>,
) -> Result<CableLengths, StaticsError> {
    let (path, end) = model.checked_path(index, pose.position.into(), rotation)?;
    let input = |tension| model.measured_tension(index, tension);
    let lengths = model.law(index).lengths_on(&path, &end, tension, input, memory);
    lengths.map_err(|reason| StaticsError::of_cable(index, path.length, reason))
}
