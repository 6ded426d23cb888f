//! Search from soft cables to stiff ones, which avoids the narrow valleys that stiff cables cause in the energy.

use super::attempt::Attempt;
use super::descent::{Stop, Tensions};
use super::problem::Problem;
use crate::geometry::Pose;

/// Stiffness of the softest cables tried, times the mean length and relative to the load.
const SOFTEST: f64 = 100.0;
/// Factor from one stiffness to the next.
const STIFFER: f64 = 10.0;

impl Problem<'_> {
    /// Descends with the stiffness of all cables limited, and raises the limit until it has no effect; `None` if cables
    /// are soft anyway or the load has no force.
    pub(super) fn attempt_from_soft(&self, start: &Pose, tensions: &mut Tensions) -> Option<Attempt> {
        let stiffest = self.springs.iter().flat_map(|springs| springs.stiffness).fold(0.0, f64::max);
        let mut limit = SOFTEST * self.force() / self.mean_length;
        if !(limit > 0.0 && limit < stiffest) {
            return None;
        }
        let mut springs = self.springs.to_vec();
        let (mut pose, mut iterations) = (*start, 0);
        while limit < stiffest {
            for (soft, own) in springs.iter_mut().zip(self.springs) {
                soft.stiffness = own.stiffness.map(|stiffness| stiffness.min(limit));
            }
            let stiffness_scale = springs.iter().flat_map(|springs| springs.stiffness).sum();
            let end = Problem { springs: &springs, stiffness_scale, ..*self }.descend(&pose, tensions);
            iterations += end.iterations;
            if end.stop == Stop::Degenerate {
                return None;
            }
            pose = end.pose;
            limit *= STIFFER;
        }
        let end = self.descend(&pose, tensions);
        Some(self.attempt(end, iterations + end.iterations, tensions))
    }
}
