//! Doubts about laws of stretch that a record does not follow.

use super::Solution;
use crate::verdict::{Doubt, DoubtKind};

/// Largest error of both branches (rms), as a share of the range of tensions: ten times what the dissertation's branches leave (sec. 5.1).
const LARGEST_SHARE: f64 = 0.05;

impl Solution {
    /// Doubts about the laws, a sentence each; empty if the branches follow the record and a polynomial rises with it.
    pub fn doubts(&self) -> Vec<Doubt> {
        let range = self.tensions[1] - self.tensions[0];
        let fraction = self.hysteresis.rms / range;
        let mut doubts = Vec::new();
        if !(fraction <= LARGEST_SHARE) {
            doubts.push(Doubt::new(
                DoubtKind::Law,
                format!(
                    "not to be trusted: the tensions of both branches are {:.1} N (rms) from the recorded ones, {:.1} % of their range: the record is not that of a \
                     cable between these elongations, its rows are out of order, or it is too noisy",
                    self.hysteresis.rms,
                    100.0 * fraction
                ),
            ));
        }
        if self.polynomial.is_none() {
            let words = "no polynomial rises with the record: the effect `polynomial` gets no key";
            doubts.push(Doubt::new(DoubtKind::NoPolynomial, words));
        }
        doubts
    }
}
