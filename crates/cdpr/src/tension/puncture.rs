//! The puncture method (Müller, Reichert and Bruckmann 2015): low tensions without a search.
//!
//! The shortest tensions that balance the load, −A⁺ᵀ w, have the least norm and mostly break the lower limits. The way from
//! there to the (improved) closed form stays balanced; the first point of it that keeps all limits is taken. Where the
//! shortest tensions keep the limits themselves, they are the answer.
//!
//! **Where it fails:** where the improved closed form does. **Continuity:** continuous wherever that is; with kinks where
//! another cable is the one that stands at its limit. **Warm start:** none.

use super::Limits;
use super::affine::Affine;
use super::improved_closed_form;

/// Writes the tensions; true when they keep the limits. `shortest` is memory for one number per cable.
pub(super) fn search(
    balanced: &mut Affine,
    limits: &Limits,
    reference: &[f64],
    shortest: &mut [f64],
    tensions: &mut [f64],
) -> bool {
    shortest.copy_from_slice(balanced.shortest());
    if !improved_closed_form::search(balanced, limits, reference, tensions) {
        return false;
    }
    let mut part = 0.0_f64;
    for (cable, (outer, inner)) in shortest.iter().zip(tensions.iter()).enumerate() {
        let (least, largest) = (limits.minimum()[cable], limits.maximum()[cable]);
        let limit = outer.clamp(least, largest);
        if limit != *outer && inner != outer {
            part = part.max((limit - outer) / (inner - outer));
        }
    }
    let part = part.min(1.0);
    for (inner, outer) in tensions.iter_mut().zip(shortest.iter()) {
        *inner = outer + part * (*inner - outer);
    }
    true
}
