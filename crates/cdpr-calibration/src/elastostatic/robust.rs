//! The optimum of an elastic model under a robust loss.

use super::adjust::{Adjust, NEAR_PROMISE};
use super::descent::End;
use super::linearization::Linearization;
use crate::fit::InputError;
use crate::loss::Tail;
use crate::misfit::Misfit;
use crate::norms::{Norms, RESCALINGS, SAME_SCALE};

/// An optimum and what belongs to it.
pub(super) struct Found {
    pub(super) end: End,
    pub(super) linearization: Linearization,
    pub(super) norms: Norms,
    pub(super) misfit: Misfit,
    /// Noise that the weights stand for.
    pub(super) noise: f64,
}

/// The least loss at a scale that agrees with its residuals, from an optimum of least squares.
///
/// Corrections of poses and tensions are the same as with least squares: they make each sample's norm the least, and with it any loss
/// that grows with the norm.
pub(super) fn minimise(
    tail: Tail,
    squared: &Adjust<'_>,
    end: &End,
    linearization: &Linearization,
    norms: &Norms,
) -> Result<Found, InputError> {
    let Adjust { problem, sigmas, noise } = *squared;
    let absolute = norms.is_absolute();
    let misfit = problem.misfit(end, linearization);
    let mut found =
        Found { end: end.clone(), linearization: linearization.clone(), norms: norms.clone(), misfit, noise };
    let mut scale = found.norms.deviation;
    for _ in 0..RESCALINGS {
        if !absolute && !problem.settings.priors.is_empty() {
            // a prior needs the scale of the noise
            found.noise *= scale;
            found.linearization.scale_weights(scale);
            scale = 1.0;
        }
        let robust = problem.under(tail.at(found.norms.dimension(), scale));
        let adjust = Adjust { problem: &robust, sigmas, noise: found.noise };
        let near = robust.descend(&found.end.values, &found.linearization, NEAR_PROMISE);
        let trail = found.end.trail.then(near.trail);
        found.end = End { iterations: found.end.iterations + near.iterations, trail, ..near };
        adjust.settle(&mut found.end, &mut found.linearization)?;
        found.norms = adjust.norms(&found.end, &found.linearization, absolute)?;
        found.misfit = robust.misfit(&found.end, &found.linearization);
        let ratio = found.norms.deviation / scale;
        if (ratio - 1.0).abs() < SAME_SCALE || !found.norms.are_finite() {
            break;
        }
        scale = found.norms.deviation;
    }
    Ok(found)
}
