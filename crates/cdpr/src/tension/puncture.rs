//! The puncture method (Müller, Reichert and Bruckmann 2015): low tensions without a search.
//!
//! The minimum-norm tensions that balance the load, −A⁺ᵀ w, have the least norm and mostly break the lower limits. The way from
//! there to the (improved) closed form stays balanced; the first point of it that keeps all limits is taken. Where the
//! minimum-norm tensions keep the limits themselves, they are the answer.
//!
//! **Where it fails:** where the improved closed form does. **Continuity:** continuous wherever that is; with kinks where
//! another cable is the one that stands at its limit. **Warm start:** none.

use super::Limits;
use super::affine::Affine;
use super::improved_closed_form;

/// Writes the tensions; true when they keep the limits. `minimum_norm` is memory for one number per cable.
pub(super) fn search(
    balanced: &mut Affine,
    limits: &Limits,
    reference: &[f64],
    minimum_norm: &mut [f64],
    tensions: &mut [f64],
) -> bool {
    minimum_norm.copy_from_slice(balanced.minimum_norm());
    if !improved_closed_form::search(balanced, limits, reference, tensions) {
        return false;
    }
    let mut part = 0.0_f64;
    for (cable, (outer, inner)) in minimum_norm.iter().zip(tensions.iter()).enumerate() {
        let (least, largest) = (limits.minimum()[cable], limits.maximum()[cable]);
        let limit = outer.clamp(least, largest);
        if limit != *outer && inner != outer {
            part = part.max((limit - outer) / (inner - outer));
        }
    }
    let part = part.min(1.0);
    for (inner, outer) in tensions.iter_mut().zip(minimum_norm.iter()) {
        *inner = outer + part * (*inner - outer);
    }
    true
}
