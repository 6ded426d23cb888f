//! Lengths of one cable with a tension at a pose: the inverse of the cable laws.

use super::StaticsError;
use super::holding::held_at;
use crate::cable::stretch::hysteresis::Memory;
use crate::geometry::Pose;
use crate::model::Model;

/// Lengths of a cable at rest, the course on which it lies, and its tensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct CableLengths {
    /// Strained length from frame anchor to platform anchor (m).
    pub(crate) length: f64,
    /// q_θ (m); NaN where it depends on a tension that is unknown.
    pub(crate) controlled_length: f64,
    /// Direction of the pull at the platform anchor (unit vector, world).
    pub(crate) direction: [f64; 3],
    /// Wrap angle (rad).
    pub(crate) wrap_angle: f64,
    /// Tension at the outlet (N).
    pub(crate) outlet_tension: f64,
    /// Tension at the platform anchor (N) of a cable with weight.
    pub(crate) platform_tension: Option<f64>,
}

/// Lengths of one cable (0-based) with a tension where the robot measures it (N; NaN where it is unknown), from a memory of its own or
/// never loaded: the exact inverse of the cable law (eq. 2.37, 2.41). The rows of the pose's rotation are shared by all cables.
#[inline]
pub(crate) fn cable_lengths(
    model: &Model,
    (pose, rotation): (&Pose, &[[f64; 3]; 3]),
    index: usize,
    tension: f64,
    memory: Option<&Memory>,
) -> Result<CableLengths, StaticsError> {
    let (course, _) = model.checked_course(index, pose.position.into(), rotation)?;
    let composition = model.composition();
    let of_course = |controlled_length: f64| CableLengths {
        length: course.length,
        controlled_length,
        direction: course.direction,
        wrap_angle: course.wrap_angle,
        outlet_tension: tension,
        platform_tension: None,
    };
    if !composition.depends_on_tension() {
        return Ok(of_course(course.length));
    }
    if tension.is_nan() {
        return Ok(of_course(f64::NAN));
    }
    if composition.has_closed_form() {
        return controlled_length(model, index, course.length, tension).map(of_course);
    }
    let hold = held_at(model, pose, index, tension, memory)?.hold;
    Ok(CableLengths {
        length: hold.strained_length,
        controlled_length: hold.controlled_length,
        direction: hold.direction,
        wrap_angle: hold.wrap_angle,
        outlet_tension: hold.outlet_tension,
        platform_tension: composition.is_sagging().then_some(hold.platform_tension),
    })
}

/// q_θ of one cable, which must be positive.
pub(super) fn controlled_length(model: &Model, index: usize, length: f64, tension: f64) -> Result<f64, StaticsError> {
    let controlled = model.elasticity(index).controlled_length(length, tension);
    // written so that NaN is refused too
    if !(controlled > 0.0) {
        return Err(StaticsError::Overstretched { cable: index + 1, tension, length });
    }
    Ok(controlled)
}
