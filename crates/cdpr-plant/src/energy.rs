//! Energy of a machine, to check its conservation.

use super::cable_motion::CableMotion;
use super::plant::Plant;
use super::state::PlantState;

/// Energy of a machine (J).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Energy {
    /// Kinetic energy of the platform and the drums.
    pub kinetic: f64,
    /// Elastic energy of the cables at their controlled lengths.
    pub elastic: f64,
    /// Potential of the platform's weight and of constant forces, zero at the world's origin; moments of constant
    /// direction have none.
    pub potential: f64,
}

impl Energy {
    /// Sum of all three (J).
    pub fn total(&self) -> f64 {
        self.kinetic + self.elastic + self.potential
    }
}

/// Gauss–Legendre rule of five points on \[−1, 1\] with its weights: exact to the ninth power of the elongation.
const GAUSS: [(f64, f64); 5] = [
    (0.0, 128.0 / 225.0),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

impl Plant {
    /// Energy of a state; `None` if tensions do not depend on lengths alone, as with hysteresis and with sag.
    pub fn energy(&self, state: &PlantState) -> Option<Energy> {
        if self.sags || state.cables.iter().any(|cable| cable.memory.is_some()) {
            return None;
        }
        let elastic: f64 =
            state.cables.iter().enumerate().map(|(index, cable)| self.elastic_energy(index, cable)).sum();
        let twist = state.twist();
        let (weight, _) = self.load.weight();
        let constant = self.load.constant_part() + state.external;
        let added = state.pose.position * state.added.mass + state.pose.rotation * state.added.moment;
        let own = state.pose.transform(self.load.weight().1);
        let potential =
            -weight.dot(&own) - self.gravity.dot(&added) - constant.fixed_rows::<3>(0).dot(&state.pose.position);
        let turning: f64 = self
            .drums
            .iter()
            .zip(&state.cables)
            .map(|(drum, cable)| 0.5 * drum.inertia * cable.drum_speed * cable.drum_speed)
            .sum();
        let kinetic = 0.5 * twist.dot(&(state.inertia.mass_matrix(&state.pose) * twist)) + turning;
        Some(Energy { kinetic, elastic, potential })
    }

    /// Elastic energy ∫ f dq of a cable, from the slack length to its present length (J).
    fn elastic_energy(&self, index: usize, cable: &CableMotion) -> f64 {
        let unstrained = cable.unstrained_length();
        let half = 0.5 * (cable.length - unstrained);
        if cable.is_broken || !(half > 0.0) {
            return 0.0;
        }
        let tension = |at: f64| {
            let length = unstrained + half * (1.0 + at);
            self.model.law(index).continued_tension(length, unstrained, None).map_or(0.0, |tension| tension.value)
        };
        GAUSS.iter().map(|&(at, weight)| weight * tension(at)).sum::<f64>() * half
    }
}
