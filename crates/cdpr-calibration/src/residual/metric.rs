//! Units in which the errors of a pose count together.

use nalgebra::{Matrix3, Vector3};

use crate::fit::{ASSUMED_NOISE, ASSUMED_TENSION_SHARE, InputError};
use cdpr_model::geometry::Twist;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;

/// Factors of errors of position, rotation and tension: standard deviations, stated or assumed.
///
/// Rotations count as positions by a length L.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Metric {
    /// Per metre.
    pub(crate) position: f64,
    /// L (m).
    pub(crate) rotation_length: f64,
    /// Per newton; `None` where tensions do not count.
    pub(crate) tension: Option<f64>,
}

impl Metric {
    pub(crate) fn of(model: &Model, samples: &Samples, rotation_length: Option<f64>) -> Result<Self, InputError> {
        let rotation_length = rotation_length.unwrap_or_else(|| default_length(model, samples));
        let position = position_sigma(samples);
        if !model.needs_tensions() {
            return Ok(Self { position: 1.0 / position, rotation_length, tension: None });
        }
        let tensions = samples.tensions.as_ref().ok_or(InputError::PosesWithoutTensions)?;
        let mean = tensions.iter().sum::<f64>() / tensions.len() as f64;
        let tension = samples.sigmas.tension.unwrap_or(ASSUMED_TENSION_SHARE * mean).max(1e-6 * mean).max(1e-9);
        Ok(Self { position: 1.0 / position, rotation_length, tension: Some(1.0 / tension) })
    }

    /// Factor of a direction of the motion pattern: a shift or a turn.
    pub(crate) fn along(&self, twist: &Twist) -> f64 {
        let is_turn = twist.fixed_rows::<3>(3).norm_squared() > 0.0;
        self.position * if is_turn { self.rotation_length } else { 1.0 }
    }
}

/// Standard deviation of a position, stated or assumed (m).
pub(crate) fn position_sigma(samples: &Samples) -> f64 {
    samples.sigmas.position.filter(|sigma| *sigma > 0.0).unwrap_or(ASSUMED_NOISE)
}

/// σ_r/σ_Φ where both are stated, else the root mean square of ‖b‖; 1 m for a point platform (m).
pub(crate) fn default_length(model: &Model, samples: &Samples) -> f64 {
    if let (Some(position), Some(rotation)) = (samples.sigmas.position, samples.sigmas.rotation)
        && position > 0.0
        && rotation > 0.0
    {
        return position / rotation;
    }
    let cables = &model.robot().cables;
    let squares: f64 = cables.iter().map(|cable| cable.platform_anchor.norm_squared()).sum();
    let length = (squares / cables.len() as f64).sqrt();
    if length > 0.0 { length } else { 1.0 }
}

/// Change of the rotation vector of an error with a turn of the predicted pose (world): the inverse of the left Jacobian of SO(3).
pub(crate) fn by_turn(error: &Twist) -> Matrix3<f64> {
    let vector: Vector3<f64> = error.fixed_rows::<3>(3).into_owned();
    let (angle, cross) = (vector.norm(), vector.cross_matrix());
    let second = match angle < 1e-4 {
        true => 1.0 / 12.0 + angle * angle / 720.0,
        false => 1.0 / (angle * angle) - 0.5 / (angle * (0.5 * angle).tan()),
    };
    Matrix3::identity() - 0.5 * cross + second * cross * cross
}
