//! Wrenches of groups of cables, which act on a part of the platform.

use super::cable_states::cable_state;
use super::error::{StaticsError, check_tensions};
use crate::geometry::{Pose, Wrench};
use crate::model::Model;

/// Wrench that a group of cables (0-based) exerts on the platform, A₁ᵀ f₁ (eq. 5.11; world axes, moment about the
/// platform origin; N, N·m).
///
/// If the group's cables are fixed to one mounting unit, the section between that unit and the remaining platform
/// carries this wrench, provided that no other load acts on the unit: the wrenches of groups that together contain all
/// cables add up to −w. Components outside the motion pattern are zero.
pub fn section_wrench(model: &Model, pose: &Pose, tensions: &[f64], cables: &[usize]) -> Result<Wrench, StaticsError> {
    check_tensions(model, tensions)?;
    let count = model.cable_count();
    let mut wrench = Wrench::zeros();
    for (place, &index) in cables.iter().enumerate() {
        let cable = index + 1;
        if index >= count {
            return Err(StaticsError::UnknownCable { cable, count });
        }
        if cables[..place].contains(&index) {
            return Err(StaticsError::RepeatedCable { cable });
        }
        wrench += cable_state(model, pose, index, tensions[index])?.wrench();
    }
    // the basis is orthonormal, so this keeps what the pattern has
    Ok(model.twist_basis().iter().map(|twist| twist * twist.dot(&wrench)).sum())
}
