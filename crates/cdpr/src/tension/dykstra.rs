//! Dykstra's alternating projections on the balanced tensions and on the limits (Boyle and Dykstra 1986).
//!
//! x ← P_balance(y), y ← P_limits(x + q), q ← x + q − y: with the correction q the points tend to the balanced tensions within
//! limits that are nearest to the reference, those of the quadratic programme (without it to some allowed ones). The projection
//! on the balance is p + H Hᵀ y, that on the limits cuts off.
//!
//! **Stop rule:** no tension of x misses its limits, and none differs from y, by more than 1e-9 of the largest limit; or
//! 10 000 rounds. Where the allowed tensions are a thin set, rounds in which nothing seems to move are part of the method, so
//! that "no change" is no stop rule. **Where it fails:** the rounds needed grow without bound as the angle between balance
//! and limits closes, at the boundary of what is feasible; it then says so. **Continuity:** that of the optimum, to the stop
//! rule. **Warm start:** none: another start would tend to another point.

use super::Limits;
use super::affine::Affine;

/// Rounds before giving up.
pub(super) const MAX_ROUNDS: u32 = 10_000;

/// Rounds before it is asked whether there are tensions at all.
pub(super) const FIRST_ROUNDS: u32 = 200;

/// State of the search: y, q and the rounds so far; x are the tensions of the caller.
#[derive(Clone, Debug)]
pub(super) struct Search {
    cut: Vec<f64>,
    correction: Vec<f64>,
    rounds: u32,
}

impl Search {
    pub(super) fn new(cable_count: usize) -> Self {
        Self { cut: vec![0.0; cable_count], correction: vec![0.0; cable_count], rounds: 0 }
    }

    /// Starts at the reference.
    pub(super) fn begin(&mut self, balanced: &Affine, reference: &[f64], tensions: &mut [f64]) {
        balanced.nearest(reference, tensions);
        self.correction.fill(0.0);
        self.rounds = 0;
    }

    pub(super) fn rounds(&self) -> u32 {
        self.rounds
    }

    /// Goes on for this many rounds; true once the tensions keep the limits.
    pub(super) fn run(&mut self, rounds: u32, balanced: &Affine, limits: &Limits, tensions: &mut [f64]) -> bool {
        // ten times the rounding of limits
        let tolerance = 10.0 * limits.tolerance();
        for _ in 0..rounds {
            self.rounds += 1;
            let mut apart = 0.0_f64;
            for (cable, x) in tensions.iter().enumerate() {
                let wanted = x + self.correction[cable];
                self.cut[cable] = wanted.clamp(limits.minimum()[cable], limits.maximum()[cable]);
                self.correction[cable] = wanted - self.cut[cable];
                apart = apart.max((x - self.cut[cable]).abs());
            }
            if apart <= tolerance {
                return true;
            }
            balanced.nearest(&self.cut, tensions);
        }
        false
    }
}
