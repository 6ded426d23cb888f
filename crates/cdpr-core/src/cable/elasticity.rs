//! Linear elasticity of a straight cable: tension from geometric and controlled length.
//!
//! f = (q − q_θ)/c with a compliance that is linear in the lengths, c = κ_q q + κ_θ q_θ + c₀, holds three laws in one
//! formula:
//!
//! | law | κ_q | κ_θ | c₀ |
//! |---|---|---|---|
//! | by actual length (eq. 2.33–2.36) | 1/EA | 0 | q_h/EA + series |
//! | by unstrained length | 0 | 1/EA | q_h/EA + series |
//! | constant spring | 0 | 0 | 1/k + series |
//!
//! q_h is the hidden length between winch and outlet; further compliances add in series (eq. 6.18). All zero is a rigid
//! cable, for which only the inverse, q_θ = q, has a meaning.

use crate::scalar::Real;

/// Length that divides the specific stiffness.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "files", derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema))]
#[cfg_attr(feature = "files", serde(rename_all = "lowercase"))]
pub enum StiffnessBasis {
    /// k = EA/q, the dissertation's law.
    Actual,
    /// k = EA/q_θ.
    Unstrained,
}

/// Compliance c = κ_q q + κ_θ q_θ + c₀ of one cable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Elasticity<T> {
    /// κ_q, compliance per geometric length q (1/N).
    pub by_length: T,
    /// κ_θ, compliance per controlled length q_θ (1/N).
    pub by_controlled_length: T,
    /// c₀, independent of the lengths (m/N).
    pub constant: T,
}

/// A tension with its derivatives; negative if the cable would have to push, which is the caller's case to handle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tension<T> {
    /// f (N).
    pub value: T,
    /// ∂f/∂q at fixed q_θ (N/m), the entry of K.
    pub by_length: T,
    /// ∂f/∂q_θ at fixed q (N/m), minus the entry of K_θ.
    pub by_controlled_length: T,
}

/// A controlled length with its derivatives.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ControlledLength<T> {
    /// q_θ (m).
    pub value: T,
    /// ∂q_θ/∂q at fixed tension.
    pub by_length: T,
    /// ∂q_θ/∂f at fixed length (m/N); minus the effective compliance.
    pub by_tension: T,
    /// ∂q_θ/∂κ by the specific compliance κ = 1/EA, hidden length included (m·N); 0 under the law of constant springs.
    pub by_compliance: T,
    /// ∂q_θ/∂q_h by the hidden length.
    pub by_hidden_length: T,
}

impl Elasticity<f64> {
    /// A cable that does not stretch.
    pub const RIGID: Self = Self { by_length: 0.0, by_controlled_length: 0.0, constant: 0.0 };

    /// Constant spring k (N/m) with a compliance in series (m/N).
    #[inline]
    pub fn spring(stiffness: f64, series: f64) -> Self {
        Self { constant: 1.0 / stiffness + series, ..Self::RIGID }
    }

    /// Cable with specific compliance κ = 1/EA (1/N), proportional to the length that `basis` names, with hidden length
    /// q_h (m) and a compliance in series (m/N).
    #[inline]
    pub fn specific(compliance: f64, basis: StiffnessBasis, hidden_length: f64, series: f64) -> Self {
        let constant = compliance * hidden_length + series;
        match basis {
            StiffnessBasis::Actual => Self { by_length: compliance, by_controlled_length: 0.0, constant },
            StiffnessBasis::Unstrained => Self { by_length: 0.0, by_controlled_length: compliance, constant },
        }
    }

    /// True when the cable does not stretch.
    #[inline]
    pub fn is_rigid(&self) -> bool {
        *self == Self::RIGID
    }
}

impl<T: Real> Elasticity<T> {
    /// Returns the compliance c at a geometric and a controlled length (m/N).
    #[inline(always)]
    pub fn compliance(&self, length: T, controlled_length: T) -> T {
        self.by_length * length + self.by_controlled_length * controlled_length + self.constant
    }

    /// Tension f = (q − q_θ)/c with its derivatives, negative if the cable would have to push; not finite for a rigid
    /// cable.
    #[inline(always)]
    pub fn tension(&self, length: T, controlled_length: T) -> Tension<T> {
        let one = length.constant(1.0);
        let inverse = one / self.compliance(length, controlled_length);
        let value = (length - controlled_length) * inverse;
        Tension {
            value,
            by_length: (one - value * self.by_length) * inverse,
            by_controlled_length: -((one + value * self.by_controlled_length) * inverse),
        }
    }

    /// Controlled length at which a cable of this geometric length has this tension (eq. 2.37): the exact inverse of
    /// [`Elasticity::tension`], and q for a rigid cable.
    #[inline(always)]
    pub fn controlled_length(&self, length: T, tension: T) -> T {
        let stretch = self.by_length * length + self.constant;
        (length - tension * stretch) / (length.constant(1.0) + tension * self.by_controlled_length)
    }

    /// [`Elasticity::controlled_length`] with its derivatives; `hidden_length` (m) and the `specific` compliance (1/N)
    /// are those the law was built from.
    #[inline(always)]
    pub fn controlled_length_gradient(
        &self,
        length: T,
        tension: T,
        hidden_length: T,
        specific: T,
        is_by_unstrained: bool,
    ) -> ControlledLength<T> {
        let one = length.constant(1.0);
        let inverse = one / (one + tension * self.by_controlled_length);
        let value = (length - tension * (self.by_length * length + self.constant)) * inverse;
        let strained = if is_by_unstrained { value } else { length };
        ControlledLength {
            value,
            by_length: (one - tension * self.by_length) * inverse,
            by_tension: -(self.compliance(length, value) * inverse),
            by_compliance: -(tension * (strained + hidden_length) * inverse),
            by_hidden_length: -(tension * specific * inverse),
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Const, SVector};
    use num_dual::DualVec;

    use super::*;

    type Dual = DualVec<f64, Const<4>>;

    fn law(basis: StiffnessBasis) -> Elasticity<f64> {
        Elasticity::specific(1.0 / 2e5, basis, 3.0, 2e-7)
    }

    fn laws() -> [Elasticity<f64>; 3] {
        [law(StiffnessBasis::Actual), law(StiffnessBasis::Unstrained), Elasticity::spring(4e4, 1e-6)]
    }

    #[test]
    fn the_controlled_length_is_the_inverse_of_the_tension() {
        for law in laws() {
            for tension in [0.0, 1.0, 9000.0] {
                let controlled = law.controlled_length(7.5, tension);
                // rounding of q − q_θ (1e-15 m) over the compliance (1e-5 m/N)
                assert!((law.tension(7.5, controlled).value - tension).abs() < 1e-9, "{law:?}");
            }
        }
        assert_eq!(Elasticity::RIGID.controlled_length(7.5, 9000.0), 7.5);
    }

    #[test]
    fn derivatives_of_the_tension_agree_with_dual_numbers() {
        let variable =
            |value: f64, index: usize| Dual::new(value, num_dual::Derivative::some(SVector::<f64, 4>::ith(index, 1.0)));
        for law in laws() {
            let dual = Elasticity {
                by_length: law.by_length.into(),
                by_controlled_length: law.by_controlled_length.into(),
                constant: law.constant.into(),
            };
            let found = law.tension(7.5, 7.3);
            let expected = dual.tension(variable(7.5, 0), variable(7.3, 1)).value;
            let gradient = expected.eps.unwrap_generic(Const, Const::<1>);
            assert!((found.by_length / gradient[0] - 1.0).abs() < 1e-13);
            assert!((found.by_controlled_length / gradient[1] - 1.0).abs() < 1e-13);
        }
    }

    #[test]
    fn derivatives_of_the_controlled_length_agree_with_dual_numbers() {
        let variable =
            |value: f64, index: usize| Dual::new(value, num_dual::Derivative::some(SVector::<f64, 4>::ith(index, 1.0)));
        for basis in [StiffnessBasis::Actual, StiffnessBasis::Unstrained] {
            let is_by_unstrained = basis == StiffnessBasis::Unstrained;
            let (specific, hidden) = (variable(5e-6, 2), variable(3.0, 3));
            let constant = specific * hidden + 2e-7;
            let zero = Dual::from(0.0);
            let dual = match is_by_unstrained {
                true => Elasticity { by_length: zero, by_controlled_length: specific, constant },
                false => Elasticity { by_length: specific, by_controlled_length: zero, constant },
            };
            let expected = dual.controlled_length(variable(7.5, 0), variable(6000.0, 1));
            let gradient = expected.eps.unwrap_generic(Const, Const::<1>);
            let found = law(basis).controlled_length_gradient(7.5, 6000.0, 3.0, 5e-6, is_by_unstrained);
            let analytic = [found.by_length, found.by_tension, found.by_compliance, found.by_hidden_length];
            assert!((found.value - expected.re).abs() < 1e-14);
            for (analytic, dual) in analytic.iter().zip(gradient.iter()) {
                assert!((analytic / dual - 1.0).abs() < 1e-13, "{basis:?}: {analytic} {dual}");
            }
        }
    }

    /// The stiffnesses by geometric and by controlled length differ by 1 + strain: mixing them is off by percents.
    #[test]
    fn the_two_stiffnesses_differ_by_the_strain() {
        let law = Elasticity { by_length: 5e-6, ..Elasticity::RIGID };
        let (length, controlled) = (7.5, 7.2);
        let tension = law.tension(length, controlled);
        assert!((-tension.by_controlled_length / tension.by_length - length / controlled).abs() < 1e-13);
    }
}
