//! Range of strain in which a polynomial rises.

use cdpr_core::cable::stretch::Stretch;
use cdpr_core::cable::stretch::polynomial::Polynomial;

use super::StretchError;
use crate::robot::Cable;
use crate::scalar::polynomial::{bisect, derivative, horner, sign_changes};

/// Largest strain for which polynomials are checked: no cable becomes a thousand times longer.
const RISING_RANGE: f64 = 1e3;

/// Slope, as a fraction of that at zero, below which it counts as zero.
const FLATNESS: f64 = 1e-12;

/// Strain up to which f = Σ cₖ εᵏ (k from 1) is used; an error if it is no law.
///
/// This is 1000 for a polynomial that rises everywhere. A polynomial that stops rising is accepted if it reaches the
/// largest tension in use before, and is used up to there.
pub(crate) fn rising_range(coefficients: &[f64], largest_tension: Option<f64>) -> Result<f64, StretchError> {
    let &stiffness = coefficients.first().ok_or(StretchError::NoCoefficients)?;
    if !coefficients.iter().all(|c| c.is_finite()) {
        return Err(StretchError::NotFinite { key: "tension_of_strain_N" });
    }
    if !(stiffness > 0.0) {
        return Err(StretchError::NoStiffness { found: stiffness });
    }
    let slope: Vec<f64> = coefficients.iter().zip(1..).map(|(c, k)| c * f64::from(k)).collect();
    let Some(turn) = first_turn(&slope) else { return Ok(RISING_RANGE) };
    let tension = |strain: f64| strain * horner(coefficients, strain);
    match largest_tension {
        Some(largest) if largest < tension(turn) => Ok(bisect(0.0, turn, |strain| tension(strain) < largest)),
        largest => Err(StretchError::Turns { strain: turn, tension: tension(turn), largest }),
    }
}

/// Least strain at which the slope is no longer positive.
fn first_turn(slope: &[f64]) -> Option<f64> {
    let flat = FLATNESS * slope[0];
    let mut marks = sign_changes(&derivative(slope), RISING_RANGE);
    marks.push(RISING_RANGE);
    let mut before = 0.0;
    for mark in marks {
        if horner(slope, mark) <= flat {
            return Some(bisect(before, mark, |strain| horner(slope, strain) > flat));
        }
        before = mark;
    }
    None
}

/// The law f = Σ cₖ εᵏ with `coefficients` c₁, c₂, … (N).
///
/// A polynomial that stops rising is accepted if it reaches `largest_tension` (N) before, and is used up to there;
/// otherwise the error states the strain at which it stops.
pub fn polynomial_law(coefficients: &[f64], largest_tension: Option<f64>) -> Result<Polynomial, StretchError> {
    let end = rising_range(coefficients, largest_tension)?;
    Ok(Polynomial::rising_to(end, coefficients.iter().copied().collect()))
}

/// The law of the cable, used up to its largest tension; `None` if it has no coefficients.
pub(super) fn law(cable: &Cable) -> Result<Option<Stretch>, StretchError> {
    let coefficients = cable.tension_of_strain.as_deref();
    let law = coefficients.map(|coefficients| polynomial_law(coefficients, cable.tension_max)).transpose()?;
    Ok(law.map(Stretch::Polynomial))
}

/// Number of coefficients of the cable.
pub(super) fn count(cable: &Cable) -> usize {
    cable.tension_of_strain.as_ref().map_or(0, Vec::len)
}

/// Gives a cable a stiffening law with this axial stiffness (N) at zero strain.
pub(super) fn sample(cable: &mut Cable, stiffness: f64) {
    cable.tension_of_strain = Some(vec![stiffness, 60.0 * stiffness]);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_stiffening_polynomial_rises_everywhere() {
        assert_eq!(rising_range(&[2e5, 1e7, 3e9], None), Ok(RISING_RANGE));
        // the slope 1 − 2ε + 1.5ε² stays above 1/3
        assert_eq!(rising_range(&[1.0, -1.0, 0.5], None), Ok(RISING_RANGE));
    }

    #[test]
    fn a_polynomial_that_turns_beyond_the_largest_tension_is_used_up_to_there() {
        // f = ε − ε²/2 turns at ε = 1 with f = 1/2; f = 0.375 at ε = 1/2
        assert!((rising_range(&[1.0, -0.5], Some(0.375)).unwrap() - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_polynomial_that_turns_within_use_is_refused_with_the_place() {
        for largest in [None, Some(0.6)] {
            let Err(StretchError::Turns { strain, tension, .. }) = rising_range(&[1.0, -0.5], largest) else {
                panic!("accepted with {largest:?}")
            };
            assert!((strain - 1.0).abs() < 1e-9 && (tension - 0.5).abs() < 1e-9);
        }
        // it falls between two turns only: 0.2, 0.4
        let slope = [0.08, -0.6, 1.0];
        let coefficients = [slope[0], slope[1] / 2.0, slope[2] / 3.0];
        assert!(
            matches!(rising_range(&coefficients, None), Err(StretchError::Turns { strain, .. }) if (strain - 0.2).abs() < 1e-9)
        );
    }

    /// (ε − 1)² touches zero at 1: at the tension there the stiffness is zero.
    #[test]
    fn a_slope_that_only_touches_zero_is_refused() {
        assert!(matches!(rising_range(&[1.0, -1.0, 1.0 / 3.0], None), Err(StretchError::Turns { .. })));
    }

    #[test]
    fn what_is_no_polynomial_is_refused() {
        assert_eq!(rising_range(&[], None), Err(StretchError::NoCoefficients));
        assert_eq!(rising_range(&[0.0, 1.0], None), Err(StretchError::NoStiffness { found: 0.0 }));
        assert!(matches!(rising_range(&[1.0, f64::NAN], None), Err(StretchError::NotFinite { .. })));
    }
}
