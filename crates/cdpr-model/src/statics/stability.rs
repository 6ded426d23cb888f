//! Stability of an equilibrium, and the stiffness that counts as none.

/// Stability of an equilibrium under small displacements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// The platform is driven back in all directions.
    Stable,
    /// In some direction nothing drives it back: its stiffness there counts as none.
    Indifferent,
    /// In some direction it is driven away.
    Unstable,
}

impl Stability {
    /// Judges an equilibrium by its smallest stiffness and the one that counts as none (N/m); what is no number is indifferent.
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

/// Share of the cables' stiffness that counts as none.
const OF_CABLES: f64 = 1e-9;
/// Share of the stiffness by which a load holds a pendulum that counts as none.
const OF_LOAD: f64 = 1e-6;
/// Share of the cables' stiffness that rounding makes of zero.
const ROUNDING: f64 = 1e-12;

/// Stiffness that counts as none (N/m), up or down: 1e-9 of the cables' stiffnesses together, or where it is less 1e-6 of the load's force over the mean
/// cable length, since a load holds a pendulum on stiff cables; never less than 1e-12 of the cables' stiffnesses.
pub fn indifferent_stiffness(cables: f64, force: f64, mean_length: f64) -> f64 {
    let by_load = if force > 0.0 { OF_LOAD * force / mean_length } else { f64::INFINITY };
    f64::min(OF_CABLES * cables, by_load).max(ROUNDING * cables)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Eight cables of 2e5 N/m and 9 m: none beside them, beside a light load that they hold, and beside rounding.
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
