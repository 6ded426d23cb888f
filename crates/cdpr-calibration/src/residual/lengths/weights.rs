//! Row weights from sensor accuracies.

use super::pose_lanes::{CableValues, PoseLanes};
use crate::fit::{ASSUMED_NOISE, InputError};
use cdpr_model::cable::outlet::Outlet;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::scalar::{Kernel, LANES, Lanes, add, constants, cross, dispatch, dot, sub};

/// Weights of the length residuals, and whether they are known or only relative.
#[derive(Clone, Debug)]
pub(crate) struct Weights {
    /// 1/σ of each residual, cable by cable, each padded with zeros to whole groups of lanes (1/m).
    inverse_sigma: Vec<f64>,
    /// Samples with their padding.
    rows: usize,
    /// False when no sensor accuracy is known: all weights are then equal and the noise is estimated from the residuals.
    pub(crate) absolute: bool,
    /// Noise that the weights stand for, as a multiple of what is stated or assumed.
    pub(crate) noise: f64,
}

impl Weights {
    /// The same σ for every row (m).
    pub(crate) fn even(sigma: f64, cables: usize, samples: usize, poses: &PoseLanes) -> Self {
        let rows = poses.groups() * LANES;
        let weight = |place: usize| if place % rows < samples { 1.0 / sigma } else { 0.0 };
        Self { inverse_sigma: (0..cables * rows).map(weight).collect(), rows, absolute: false, noise: 1.0 }
    }

    /// 1/σ of one cable's residuals, padding included (1/m).
    pub(crate) fn of_cable(&self, cable: usize) -> &[f64] {
        &self.inverse_sigma[cable * self.rows..][..self.rows]
    }

    /// The same weights for a noise that is some times as large.
    pub(crate) fn for_noise(&self, factor: f64) -> Self {
        let inverse_sigma = self.inverse_sigma.iter().map(|weight| weight / factor).collect();
        Self { inverse_sigma, noise: self.noise * factor, ..*self }
    }

    /// True when no weight differs by more than a millionth: the optimum then moves by less than that share of σ.
    pub(crate) fn is_close_to(&self, other: &Self) -> bool {
        self.inverse_sigma.iter().zip(&other.inverse_sigma).all(|(a, b)| (a - b).abs() <= 1e-6 * a)
    }
}

/// Weight of every recorded length: its variance is σ_q² + J Σ_x Jᵀ, since the pose is measured too (see the book, “Models”).
///
/// J is the row −\[u; b × u\] of the robot's motion pattern; the scale multiplies it. An unknown pose accuracy counts as
/// exact, an unknown length accuracy likewise; without either all rows weigh the same.
pub(crate) fn length_weights(model: &Model, samples: &Samples, poses: &PoseLanes) -> Result<Weights, InputError> {
    let (weights, is_regular) = weights_of(model, |cable| CableValues::of(model, cable), samples, poses);
    if !is_regular {
        for (sample, pose) in samples.poses.iter().enumerate() {
            for cable in 0..model.cable_count() {
                model.path(cable, pose).map_err(|reason| InputError::Degenerate { sample: sample + 1, reason })?;
            }
        }
    }
    Ok(weights)
}

/// [`length_weights`] for cables with these values, and whether none looks as if it had no path at some pose.
pub(crate) fn weights_of(
    model: &Model,
    values: impl Fn(usize) -> CableValues,
    samples: &Samples,
    poses: &PoseLanes,
) -> (Weights, bool) {
    let sigmas = samples.sigmas;
    let (length, position, rotation) =
        (sigmas.length.unwrap_or(0.0), sigmas.position.unwrap_or(0.0), sigmas.rotation.unwrap_or(0.0));
    let rows = poses.groups() * LANES;
    let mut weights = Weights {
        inverse_sigma: vec![0.0; rows * model.cable_count()],
        rows,
        // a rotation accuracy alone leaves rows without moment arm at no variance at all
        absolute: length > 0.0 || position > 0.0,
        noise: 1.0,
    };
    let mut variances = Variances { length: length * length, position: [0.0; 3], rotation: [0.0; 3] };
    for basis in model.twist_basis() {
        for k in 0..3 {
            // the directions of every motion pattern are axes of the world
            variances.position[k] += (position * basis[k]).powi(2);
            variances.rotation[k] += (rotation * basis[3 + k]).powi(2);
        }
    }
    let mut regular = true;
    for (cable, inverse_sigma) in weights.inverse_sigma.chunks_mut(rows).enumerate() {
        let values = values(cable);
        regular &= dispatch(WriteWeights { values: &values, poses, variances: &variances, inverse_sigma });
        if !weights.absolute {
            inverse_sigma.fill(1.0 / ASSUMED_NOISE);
        }
        inverse_sigma[samples.len()..].fill(0.0);
    }
    (weights, regular)
}

/// Variances of what is measured, per axis of the world.
struct Variances {
    /// (m²)
    length: f64,
    /// (m²)
    position: [f64; 3],
    /// (rad²)
    rotation: [f64; 3],
}

/// 1/σ of one cable's residuals at every pose; answers whether no pose looks degenerate.
struct WriteWeights<'a> {
    values: &'a CableValues,
    poses: &'a PoseLanes,
    variances: &'a Variances,
    inverse_sigma: &'a mut [f64],
}

impl Kernel for WriteWeights<'_> {
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) -> bool {
        let (by_position, by_rotation) = (constants(l, self.variances.position), constants(l, self.variances.rotation));
        let (zero, one) = (l.constant(0.0), l.constant(1.0));
        let scale_squared = l.constant(self.values.scale * self.values.scale);
        let mut finite = zero;
        let mut regular = true;
        for group in 0..self.poses.groups() {
            let (position, rotation) = self.poses.at(l, group);
            let (path, moment_arm) = self.values.path(position, &rotation);
            let u = path.direction;
            let moment = cross(moment_arm, u);
            let mut pose_variance = zero;
            for k in 0..3 {
                pose_variance = pose_variance + by_position[k] * u[k] * u[k] + by_rotation[k] * moment[k] * moment[k];
            }
            let variance = l.constant(self.variances.length) + scale_squared * pose_variance;
            (one / variance.sqrt()).store(&mut self.inverse_sigma[group * LANES..]);
            finite = finite + (path.length + dot(u, u));
            if let Outlet::Swivel { frame_anchor, swivel_axis, .. } = self.values.outlet {
                let d = sub(add(position, moment_arm), constants(l, frame_anchor));
                let along = dot(d, constants(l, swivel_axis));
                // generous: the exact test decides afterwards
                let near_axis = (dot(d, d) - along * along).is_less(l.constant(1e-12) * dot(d, d));
                regular &= !l.any(near_axis);
            }
        }
        regular && finite.sum().is_finite()
    }
}
