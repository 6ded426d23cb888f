//! Stability of an equilibrium, and the stiffness up to which it is indifferent.

/// Stability of an equilibrium under small displacements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// Forces drive the platform back from a displacement in any direction.
    Stable,
    /// In some direction the stiffness is too small to drive the platform back.
    Indifferent,
    /// In some direction forces drive the platform away.
    Unstable,
}

impl Stability {
    /// Judges an equilibrium by its smallest stiffness and the largest indifferent one (N/m); NaN is indifferent.
    pub fn of(smallest: f64, indifferent: f64) -> Self {
        if smallest > indifferent {
            Self::Stable
        } else if smallest < -indifferent {
            Self::Unstable
        } else {
            Self::Indifferent
        }
    }
}

/// Fraction of the cables' stiffness up to which an equilibrium is indifferent.
const OF_CABLES: f64 = 1e-9;
/// Fraction of the load's pendulum stiffness up to which an equilibrium is indifferent.
const OF_LOAD: f64 = 1e-6;
/// Fraction of the cables' stiffness that may be rounding.
const ROUNDING: f64 = 1e-12;

/// Stiffness up to which an equilibrium is indifferent (N/m), of either sign: the smaller of 1e-9 of the cables' total
/// stiffness and 1e-6 of the load's force over the mean cable length (the stiffness with which a load holds a
/// pendulum), but at least 1e-12 of the cables' total stiffness.
pub fn indifferent_stiffness(cables: f64, force: f64, mean_length: f64) -> f64 {
    let by_load = if force > 0.0 { OF_LOAD * force / mean_length } else { f64::INFINITY };
    f64::min(OF_CABLES * cables, by_load).max(ROUNDING * cables)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Eight cables of 2e5 N/m and 9 m: the limit is set by the cables, by a light load, and by rounding.
    #[test]
    fn a_stiffness_counts_as_none_beside_cables_and_load_and_never_below_rounding() {
        for (force, expected) in [(0.0, 1.6e-3), (900.0, 1e-4), (0.9, 1.6e-6)] {
            let found = indifferent_stiffness(1.6e6, force, 9.0);
            assert!((found / expected - 1.0).abs() < 4.0 * f64::EPSILON, "{force} N: {found}");
        }
        let judged = [2e-4, 5e-5, 0.0, -5e-5, -2e-4, f64::NAN].map(|smallest| Stability::of(smallest, 1e-4));
        let [stable, none, unstable] = [Stability::Stable, Stability::Indifferent, Stability::Unstable];
        assert_eq!(judged, [stable, none, none, none, unstable, none]);
    }
}
