//! Tension of a straight cable in motion: the law is continued below zero, where a damper may still make the cable
//! pull.

use super::{CableLaw, Kind};
use crate::cable::elasticity::Tension;
use crate::cable::stretch::hysteresis::Memory;

/// Newton steps and halvings of the strain; a stiffening law in series with a compliance takes about six.
const STEPS: usize = 60;

impl CableLaw {
    /// Tension at a geometric and a controlled length (m) with its derivatives, negative where a bar would push. The
    /// caller adds the damper's tension before it clips the sum at zero. `memory` stands in for the law's own memory if
    /// given.
    ///
    /// `None` for cables that do not stretch and for cables with weight.
    #[inline]
    pub fn continued_tension(
        &self,
        length: f64,
        controlled_length: f64,
        memory: Option<&Memory>,
    ) -> Option<Tension<f64>> {
        match self.kind {
            Kind::Linear(law, _) if !law.is_rigid() => Some(law.tension(length, controlled_length)),
            Kind::Stretching => self.continued_stretch(length, controlled_length, memory),
            Kind::Rigid | Kind::Linear(..) | Kind::Sagging(_) => None,
        }
    }

    /// Solves c_s T(ε) + (q_θ + q_h)(1 + ε) = q + q_h for the strain ε and returns the tension there.
    fn continued_stretch(&self, length: f64, controlled_length: f64, memory: Option<&Memory>) -> Option<Tension<f64>> {
        let (strained, unstrained) = (length + self.hidden_length, controlled_length + self.hidden_length);
        let mut strain = strained / unstrained - 1.0;
        let series = self.series_compliance;
        if series > 0.0 {
            // the strain lies between 0 and the strain without the compliance in series
            let (mut low, mut high) = (strain.min(0.0), strain.max(0.0));
            for _ in 0..STEPS {
                let (tension, slope) = self.stretch.tension(strain, memory)?;
                let gap = series * tension + unstrained * (1.0 + strain) - strained;
                if gap > 0.0 {
                    high = strain
                } else {
                    low = strain
                }
                let mut next = strain - gap / (series * slope + unstrained);
                if !(next >= low && next <= high) {
                    next = 0.5 * (low + high);
                }
                let moved = (next - strain).abs();
                strain = next;
                if moved <= 4.0 * f64::EPSILON * strain.abs() {
                    break;
                }
            }
        }
        let (value, slope) = self.stretch.tension(strain, memory)?;
        let by_length = slope / (series * slope + unstrained);
        Some(Tension { value, by_length, by_controlled_length: -by_length * (1.0 + strain) })
    }
}
