//! Row weights from sensor accuracies.

use nalgebra::Vector3;

use super::fit::{ASSUMED_NOISE, InputError};
use crate::measurement::Samples;
use crate::model::Model;

/// Weights of the length residuals, and whether they are known or only relative.
#[derive(Clone, Debug)]
pub(super) struct Weights {
    /// 1/σ of each residual, sample by sample (1/m).
    pub(super) inverse_sigma: Vec<f64>,
    /// False when no sensor accuracy is known: all weights are then equal and the noise is estimated from the residuals.
    pub(super) absolute: bool,
}

impl Weights {
    /// All weights times a factor.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        Self {
            inverse_sigma: self.inverse_sigma.iter().map(|weight| weight * factor).collect(),
            absolute: self.absolute,
        }
    }

    /// True when no weight differs by more than a millionth: the optimum then moves by less than that share of σ.
    pub(super) fn is_close_to(&self, other: &Self) -> bool {
        self.inverse_sigma.iter().zip(&other.inverse_sigma).all(|(a, b)| (a - b).abs() <= 1e-6 * a)
    }
}

/// Weight of every recorded length: its variance is σ_q² + J Σ_x Jᵀ, since the pose is measured too (maths.md §5).
///
/// J is the row −\[u; b × u\] of the robot's motion pattern; the scale multiplies it. An unknown pose accuracy counts as
/// exact, an unknown length accuracy likewise; without either all rows weigh the same.
pub(super) fn length_weights(model: &Model, samples: &Samples) -> Result<Weights, InputError> {
    let sigmas = samples.sigmas;
    let (length, position, rotation) =
        (sigmas.length.unwrap_or(0.0), sigmas.position.unwrap_or(0.0), sigmas.rotation.unwrap_or(0.0));
    // a rotation accuracy alone leaves rows without lever at no variance at all
    let known = length > 0.0 || position > 0.0;
    let mut inverse_sigma = Vec::with_capacity(samples.lengths.len());
    for (sample, pose) in samples.poses.iter().enumerate() {
        for cable in 0..model.cable_count() {
            let (course, lever) =
                model.course(cable, pose).map_err(|reason| InputError::Degenerate { sample: sample + 1, reason })?;
            let u = Vector3::from(course.direction);
            let moment = lever.cross(&u);
            let scale = model.robot().cables[cable].length_scale.unwrap_or(1.0);
            let pose_variance: f64 = model
                .twist_basis()
                .iter()
                .map(|basis| {
                    let (v, omega) = (basis.fixed_rows::<3>(0), basis.fixed_rows::<3>(3));
                    (position * v.dot(&u)).powi(2) + (rotation * omega.dot(&moment)).powi(2)
                })
                .sum();
            let variance = length * length + scale * scale * pose_variance;
            inverse_sigma.push(1.0 / if known { variance.sqrt() } else { ASSUMED_NOISE });
        }
    }
    Ok(Weights { inverse_sigma, absolute: known })
}
