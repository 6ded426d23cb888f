//! Laws that stiffen: inverse, derivatives, the straight part beyond the end.

use nalgebra::Const;
use num_dual::{Derivative, DualVec};
use proptest::prelude::*;

use super::polynomial::Polynomial;
use super::polynomial_law;
use crate::scalar::{Lanes, Portable};
use cdpr_testing::property;

type Dual = DualVec<f64, Const<1>>;

fn variable(value: f64) -> Dual {
    Dual::new(value, Derivative::some(nalgebra::SVector::from([1.0])))
}

fn derivative(dual: Dual) -> f64 {
    dual.eps.unwrap_generic(Const, Const::<1>)[0]
}

/// A stiffening cable, one that softens and is used up to 9 kN, and a linear one.
fn laws() -> [Polynomial; 3] {
    [
        polynomial_law(&[1e5, 4e6, 8e8], None).unwrap(),
        polynomial_law(&[2e5, -6e5], Some(9000.0)).unwrap(),
        polynomial_law(&[2e5], None).unwrap(),
    ]
}

#[test]
fn the_strain_is_the_inverse_of_the_tension() {
    for law in laws() {
        for tension in [-500.0, 0.0, 1e-9, 3.0, 500.0, 8999.0, 12000.0, 3e5] {
            let (strain, compliance) = law.strain(tension);
            let (found, stiffness) = law.tension(strain);
            // rounding of the strain, some 1e-16 of it, times the stiffness
            assert!((found - tension).abs() <= 1e-14 * f64::abs(tension), "{law:?} at {tension}: {found}");
            assert!((compliance * stiffness - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn derivatives_agree_with_dual_numbers() {
    for law in laws() {
        for strain in [-0.01, 1e-4, 0.02, 0.2] {
            let (tension, stiffness) = law.tension(variable(strain));
            assert!((derivative(tension) / stiffness.re - 1.0).abs() < 1e-13, "{law:?} at {strain}");
        }
        for tension in [-50.0, 20.0, 8000.0, 2e4] {
            let (strain, compliance) = law.strain(variable(tension));
            assert!((derivative(strain) / compliance.re - 1.0).abs() < 1e-12, "{law:?} at {tension}");
        }
    }
}

#[test]
fn one_coefficient_is_the_linear_law() {
    let law = polynomial_law(&[2e5], None).unwrap();
    for strain in [-0.01, 0.0, 0.03] {
        assert_eq!(law.tension(strain), (2e5 * strain, 2e5));
    }
    assert!((law.strain(5000.0).0 - 0.025).abs() < 1e-17);
}

/// Higher coefficients that go to zero leave the linear law, in value and derivative.
#[test]
fn stiffening_switches_off_smoothly() {
    for size in [1.0, 1e-3, 1e-6] {
        let law = polynomial_law(&[2e5, size * 1e7], None).unwrap();
        let (tension, stiffness) = law.tension(0.02);
        // 1e7 · 0.02² and its derivative
        assert!((tension - 4000.0).abs() <= size * 4001.0 && (stiffness - 2e5).abs() <= size * 4.001e5);
    }
}

#[test]
fn the_law_has_no_kink_where_it_becomes_straight() {
    let law = &laws()[1];
    let (end, step) = (law.end(), 1e-9);
    let (below, above) = (law.tension(end - step), law.tension(end + step));
    // the slope changes by 1.2e6 per strain below the end
    assert!((below.1 - above.1).abs() <= 2.0 * 1.2e6 * step);
    assert!((law.tension(end).0 - 9000.0).abs() < 1e-9);
}

#[test]
fn lanes_agree_with_single_numbers() {
    let tensions = [-5.0, 0.0, 1.0, 10.0, 100.0, 1000.0, 9000.0, 20_000.0];
    for law in laws() {
        let strains = law.strain(Portable::new(tensions)).0;
        for (strain, tension) in strains.to_array().into_iter().zip(tensions) {
            // a lane continues until the slowest has converged, so that its last bit may differ
            assert!((strain - law.strain(tension).0).abs() <= 4.0 * f64::EPSILON * f64::abs(strain));
        }
        let back = strains.to_array().map(|strain| law.tension(strain).0.to_bits());
        assert_eq!(law.tension(strains).0.to_array().map(f64::to_bits), back);
    }
}

proptest! {
    #![proptest_config(property::cases(256))]

    #[test]
    fn more_strain_is_more_tension(c2 in 0.0..1e7_f64, c3 in 0.0..1e9_f64, a in -0.1..0.3_f64, step in 1e-6..0.1_f64) {
        let law = polynomial_law(&[1e5, c2, c3], None).unwrap();
        prop_assert!(law.tension(a + step).0 > law.tension(a).0);
    }
}
