//! Tension distributions printed by Miermeister 2021, that its misprints do not give them, and laws for any problem.

use super::support::builtin;
use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_model::tension::quadratic::{self, Status};
use cdpr_model::tension::{Limits, closed_form};
use cdpr_testing::property;
use nalgebra::{DMatrix, DVector, Vector3};
use proptest::prelude::*;

/// Figures 3.17 and 3.18a: load, tensions.
const PLANAR: [([f64; 2], [f64; 4]); 2] =
    [([0.0, -1962.0], [5807.9, 5908.7, 2390.0, 2421.2]), ([0.0, 0.0], [5196.3, 5247.2, 3379.9, 3394.4])];

/// Tensions of the section load of eq. 5.18 with the limits 1000 and 9000 N.
const SECTIONS: [f64; 8] = [7491.0, 2431.0, 7146.0, 3049.0, 7929.0, 3156.0, 8360.0, 2679.0];

/// Largest difference of the closed form from the printed tensions (N); the programme gives the same within the limits.
fn difference(robot: Robot, pose: Vector3<f64>, wrench: &[f64], limits: [f64; 2], printed: &[f64]) -> f64 {
    let model = Model::new(robot, Composition::STANDARD).expect("a model");
    let matrix = model.structure_matrix(&Pose { position: pose, ..Pose::identity() }).expect("has courses");
    let limits = Limits::uniform(printed.len(), limits[0], limits[1]).expect("in order");
    let closed = closed_form::solve(&matrix, wrench, &limits).expect("fits");
    assert!(closed.balanced);
    let apart = |found: &[f64]| found.iter().zip(printed).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let programme = quadratic::solve(&matrix, wrench, &limits, None).expect("fits");
    if closed.within_limits {
        // the nearest of all is the nearest of those that keep the limits
        let pairs = programme.tensions.iter().zip(&closed.tensions);
        assert!(pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e-6, "{programme:?}");
    }
    apart(&closed.tensions)
}

#[test]
fn both_methods_give_the_printed_tensions() {
    for (wrench, printed) in PLANAR {
        let found =
            difference(builtin("planar-example"), Vector3::new(0.0, 5.2, 0.0), &wrench, [1000.0, 8000.0], &printed);
        // printed to 0.1 N
        assert!(found < 0.1, "{found}");
    }
    let wrench = [0.0, 0.0, -7500.0, 0.0, -600.0, 327.0];
    let robot = builtin("cablerobot-simulator-helicopter-design");
    let found = difference(robot, Vector3::new(0.0, 0.0, 2.5), &wrench, [1000.0, 9000.0], &SECTIONS);
    // printed to 1 N
    assert!(found < 0.51, "{found}");
}

/// Eq. 3.38 has the load along x; eq. 5.18 names the frame of eq. 5.8.
#[test]
fn the_misprints_do_not_give_the_printed_tensions() {
    let at = Vector3::new(0.0, 5.2, 0.0);
    assert!(difference(builtin("planar-example"), at, &[-1962.0, 0.0], [1000.0, 8000.0], &PLANAR[0].1) > 100.0);
    let wrench = [0.0, 0.0, -7500.0, 0.0, -600.0, 327.0];
    let mut robot = builtin("cablerobot-simulator-helicopter-design");
    let frame = builtin("cablerobot-simulator-icosahedron");
    for (cable, other) in robot.cables.iter_mut().zip(&frame.cables) {
        cable.frame_anchor = other.frame_anchor;
    }
    assert!(difference(robot, Vector3::new(0.0, 0.0, 2.5), &wrench, [1000.0, 9000.0], &SECTIONS) > 100.0);
}

proptest! {
    #![proptest_config(property::cases(500))]

    /// Limits, balance, and optimality: no step along the null space that the limits allow leads nearer to the middle
    /// (Karush, Kuhn and Tucker in the form of a variational inequality, against other allowed tensions).
    #[test]
    fn the_programme_keeps_limits_balances_and_is_nearest(
        (n, m) in (1_usize..=6).prop_flat_map(|n| (Just(n), n..=12)),
        entries in prop::collection::vec(-1.0..1.0, 72),
        parts in prop::collection::vec(0.0..1.0, 12),
        others in prop::collection::vec(-1.0..1.0, 12),
    ) {
        let matrix = DMatrix::from_fn(n, m, |row, cable| entries[row * 12 + cable]);
        let limits = Limits::uniform(m, 100.0, 1100.0).expect("in order");
        let inside = DVector::from_fn(m, |cable, _| 100.0 + 1000.0 * parts[cable]);
        let wrench = -(&matrix * &inside);
        let found = quadratic::solve(&matrix, wrench.as_slice(), &limits, None).expect("fits");
        prop_assert_eq!(found.status, Status::Feasible);
        prop_assert!(limits.contain(&found.tensions, 0.0));
        // twelve tensions of 1 kN, each within 1e-7 N of the balance
        prop_assert!(found.wrench_residual.iter().all(|rest| rest.abs() < 2e-6), "{:?}", found.wrench_residual);
        let f = DVector::from_column_slice(&found.tensions);
        let to_middle = f.map(|f| 600.0 - f);
        // a known allowed distribution, and one beside it: (f_m − f)·(g − f) ≤ 0 for the nearest f
        let pseudo_inverse = matrix.clone().pseudo_inverse(1e-9).expect("has one");
        let beside = DVector::from_fn(m, |cable, _| 1000.0 * others[cable]);
        let along = &beside - &pseudo_inverse * (&matrix * &beside);
        let steps = (0..m).map(|i| ((along[i].signum() * 500.0 + 600.0) - inside[i]) / along[i]);
        let reach = steps.filter(|step| step.is_finite()).fold(1.0, f64::min).max(0.0);
        for other in [inside.clone(), &inside + reach * along] {
            // squares of a thousand newtons, to the limits' tolerance of 1e-7 N
            prop_assert!(to_middle.dot(&(other - &f)) < 1e-2, "{found:?}");
        }
    }
}
