//! Two pieces: soft below the strain of a knee, stiff above, f = c₁ ε up to ε_k, f = c₁ ε_k + c₂ (ε − ε_k) beyond.
//!
//! For ropes whose strands first settle and then carry. The tension is continuous; its slope jumps at the knee, where
//! it counts as c₁.

use super::hysteresis::Memory;
use super::law::Law;
use crate::scalar::Select;

/// The law by its three parameters, in their order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoPiece<T> {
    /// c₁, axial stiffness below the knee (N).
    pub below: T,
    /// c₂, axial stiffness above the knee (N).
    pub above: T,
    /// ε_k, strain of the knee.
    pub knee: T,
}

impl<T: Select> TwoPiece<T> {
    /// Tension f (N) at a strain and the stiffness ∂f/∂ε (N); below strain 0 with the slope c₁.
    #[inline]
    pub fn tension(&self, strain: T) -> (T, T) {
        let Self { below, above, knee } = *self;
        let is_above = knee.is_less(strain);
        let beyond = below * knee + above * (strain - knee);
        (beyond.select(is_above, below * strain), above.select(is_above, below))
    }

    /// Strain ε at a tension (N) and the compliance ∂ε/∂f (1/N): the exact inverse of [`TwoPiece::tension`].
    #[inline]
    pub fn strain(&self, tension: T) -> (T, T) {
        let Self { below, above, knee } = *self;
        let (one, of_knee) = (tension.constant(1.0), below * knee);
        let is_above = of_knee.is_less(tension);
        let beyond = knee + (tension - of_knee) / above;
        (beyond.select(is_above, tension / below), (one / above).select(is_above, one / below))
    }
}

impl Law for TwoPiece<f64> {
    const IS_POINTWISE: bool = true;

    #[inline]
    fn strain(&self, tension: f64) -> (f64, f64) {
        self.strain(tension)
    }

    #[inline]
    fn tension(&self, strain: f64, _: Option<&Memory>) -> Option<(f64, f64)> {
        Some(self.tension(strain))
    }

    #[inline]
    fn strain_by_number(&self, tension: f64, number: usize) -> f64 {
        let Self { below, above, knee } = *self;
        let beyond = tension - below * knee;
        match (number, beyond > 0.0) {
            (0, false) => -tension / (below * below),
            (0, true) => -knee / above,
            (1, true) => -beyond / (above * above),
            (2, true) => 1.0 - below / above,
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Const, SVector};
    use num_dual::{Derivative, DualVec};

    use super::*;
    use crate::cable::stretch::Stretch;

    type Dual = DualVec<f64, Const<4>>;

    const LAW: TwoPiece<f64> = TwoPiece { below: 1e5, above: 8e5, knee: 2e-3 };

    fn variable(value: f64, index: usize) -> Dual {
        Dual::new(value, Derivative::some(SVector::<f64, 4>::ith(index, 1.0)))
    }

    /// The law with its parameters as the first three variables.
    fn dual() -> TwoPiece<Dual> {
        TwoPiece { below: variable(LAW.below, 0), above: variable(LAW.above, 1), knee: variable(LAW.knee, 2) }
    }

    fn gradient(dual: Dual) -> SVector<f64, 4> {
        dual.eps.unwrap_generic(Const, Const::<1>)
    }

    #[test]
    fn the_strain_is_the_inverse_of_the_tension() {
        for tension in [-300.0, 0.0, 150.0, 199.0, 200.0, 201.0, 9000.0] {
            let (strain, compliance) = LAW.strain(tension);
            let (found, stiffness) = LAW.tension(strain);
            // rounding relative to the tension at the knee, 200 N
            assert!((found - tension).abs() <= 1e-12 * f64::max(200.0, f64::abs(tension)), "{tension}: {found}");
            assert!(tension == 200.0 || (compliance * stiffness - 1.0).abs() < 1e-14, "{tension}");
        }
    }

    #[test]
    fn the_force_is_continuous_at_the_knee() {
        let [before, after] = [LAW.knee * (1.0 - 1e-12), LAW.knee * (1.0 + 1e-12)].map(|strain| LAW.tension(strain));
        assert!((after.0 - before.0).abs() < 1e-8 && (before.1, after.1) == (LAW.below, LAW.above));
    }

    #[test]
    fn derivatives_by_strain_tension_and_every_number_agree_with_dual_numbers() {
        for strain in [-1e-3, 1e-3, 5e-3] {
            let (tension, stiffness) = dual().tension(variable(strain, 3));
            assert_eq!((tension.re, stiffness.re), LAW.tension(strain));
            assert!((gradient(tension)[3] / stiffness.re - 1.0).abs() < 1e-14);
        }
        let stretch = Stretch::TwoPiece(LAW);
        for tension in [-100.0, 120.0, 3000.0] {
            let (strain, compliance) = dual().strain(variable(tension, 3));
            let expected = gradient(strain);
            assert!((expected[3] / compliance.re - 1.0).abs() < 1e-14);
            for number in 0..3 {
                let found = stretch.strain_by_number(tension, number);
                let off = (found - expected[number]).abs();
                assert!(off <= 1e-14 * expected[number].abs(), "{number} at {tension}: {found} {}", expected[number]);
            }
        }
    }

    /// With equal slopes there is no knee: strains, tensions and slopes are those of the linear law.
    #[test]
    fn equal_slopes_are_the_linear_law() {
        let (two_piece, linear) =
            (Stretch::TwoPiece(TwoPiece { above: LAW.below, ..LAW }), Stretch::Linear(1.0 / LAW.below));
        for tension in [-300.0, 150.0, 9000.0] {
            let (found, expected) = (two_piece.strain(tension), linear.strain(tension));
            assert!((found.0 / expected.0 - 1.0).abs() < 1e-14 && (found.1 / expected.1 - 1.0).abs() < 1e-15);
            let [found, expected] = [&two_piece, &linear].map(|law| law.tension(expected.0, None).unwrap());
            assert!((found.0 / expected.0 - 1.0).abs() < 1e-14 && (found.1 / expected.1 - 1.0).abs() < 1e-15);
        }
    }
}
