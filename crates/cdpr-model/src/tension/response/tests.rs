//! Every derivative equals the central difference of the solver's tensions.

use nalgebra::DMatrix;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::reading::Keyword;
use crate::tension::distribute::{ON_LIMIT, between};
use crate::tension::{Options, Status, dykstra, solve};

/// A spatial or planar problem with a given redundancy whose tensions lie well within reach.
fn problem(rng: &mut ChaCha8Rng, n: usize, redundancy: usize) -> (DMatrix<f64>, Vec<f64>, Limits) {
    let m = n + redundancy;
    let matrix = DMatrix::from_fn(n, m, |_, _| rng.random_range(-1.0..1.0));
    let least: Vec<f64> = (0..m).map(|_| rng.random_range(50.0..150.0)).collect();
    let largest: Vec<f64> = least.iter().map(|least| least + rng.random_range(300.0..900.0)).collect();
    let inside =
        DVector::from_fn(m, |cable, _| least[cable] + (largest[cable] - least[cable]) * rng.random_range(0.02..0.98));
    let wrench = -(&matrix * inside);
    (matrix, wrench.as_slice().to_vec(), Limits::new(least, largest).unwrap())
}

/// Tensions, and the cables that are on no limit.
fn found(method: Method, matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits) -> Option<(Vec<f64>, Vec<usize>)> {
    let answer = solve(method, matrix, wrench, limits, &Options::default()).unwrap();
    let fraction = if method == Method::Dykstra { dykstra::ON_LIMIT } else { ON_LIMIT };
    let free = between(limits, &answer.tensions, fraction);
    (answer.status == Status::Feasible).then_some((answer.tensions, free))
}

/// Compares all changes of one problem; returns the number of comparisons.
fn compare(method: Method, matrix: &DMatrix<f64>, wrench: &[f64], limits: &Limits) -> usize {
    let Some((tensions, free)) = found(method, matrix, wrench, limits) else { return 0 };
    let Ok(response) = Response::of(method, matrix, wrench, limits, &tensions) else { return 0 };
    let (n, m) = matrix.shape();
    let mut compared = 0;
    for (cable, axis) in (0..m).flat_map(|cable| (0..n).map(move |axis| (cable, axis))) {
        for of_matrix in [true, false] {
            // 5 mN of load, or 5 mN of pull of a cable of 500 N
            let h = if of_matrix { 1e-5 } else { 5e-3 };
            let at = |by: f64| {
                let (mut matrix, mut wrench) = (matrix.clone(), wrench.to_vec());
                if of_matrix {
                    matrix[(axis, cable)] += by;
                } else {
                    wrench[axis] += by;
                }
                found(method, &matrix, &wrench, limits)
            };
            let (Some((ahead, free_ahead)), Some((behind, free_behind))) = (at(h), at(-h)) else { continue };
            if free_ahead != free || free_behind != free {
                continue; // a kink: a cable comes to its limit in between
            }
            let mut unit = vec![0.0; n];
            unit[axis] = 1.0;
            let zero = vec![0.0; n];
            let change = match of_matrix {
                true => response.change(cable, &unit, &zero),
                false => response.change(cable, &zero, &unit),
            };
            let slope = (DVector::from_vec(ahead) - DVector::from_vec(behind)) / (2.0 * h);
            let apart = (&slope - &change).amax();
            // rounding of the solves, 1e-10 of 1 kN and ten times that of the projections, and curvature
            let rounding = if method == Method::Dykstra { 2e-6 } else { 2e-7 };
            assert!(
                apart < rounding / h + 1e-4 * slope.amax(),
                "{method}, {n}×{m}, cable {cable}, axis {axis}, matrix {of_matrix}: {apart:e} of {}",
                slope.amax()
            );
            compared += 1;
        }
    }
    compared
}

#[test]
fn every_method_follows_matrix_and_load_as_its_solve_does() {
    for &method in Method::ALL {
        let mut rng = ChaCha8Rng::seed_from_u64(7);
        let mut compared = 0;
        for (n, redundancy) in [(1, 1), (2, 2), (3, 1), (3, 3), (6, 2), (2, 0)] {
            for _ in 0..4 {
                let (matrix, wrench, limits) = problem(&mut rng, n, redundancy);
                compared += compare(method, &matrix, &wrench, &limits);
            }
        }
        assert!(compared > 150, "{method}: {compared}");
    }
}

/// A method without a derivative in closed form is differentiated by differences.
#[test]
fn differences_of_the_solve_are_the_derivative() {
    for method in [Method::Qp, Method::Minimum, Method::Barrier, Method::Centroid, Method::Puncture] {
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        let mut compared = 0;
        for _ in 0..12 {
            let (matrix, wrench, limits) = problem(&mut rng, 3, 2);
            let Some((tensions, _)) = found(method, &matrix, &wrench, &limits) else { continue };
            let chosen = Chosen {
                problem: Problem { structure_matrix: &matrix, wrench: &wrench },
                limits: &limits,
                tensions: &tensions,
            };
            let written = Response::of(method, &matrix, &wrench, &limits, &tensions);
            let (Ok(written), Ok(by_differences)) = (written, Differences::of(method, &chosen)) else { continue };
            let (column, load) = ([0.3, -0.2, 0.5], [4.0, -7.0, 2.0]);
            let pairs = (0..5).flat_map(|cable| {
                let by_load = (written.change(cable, &column, &load), by_differences.change(cable, &column, &load));
                let by_reference = (written.change_by_reference(cable), by_differences.change_by_reference(cable));
                [Some(by_load), method.stays_near_reference().then_some(by_reference)]
            });
            for (change, other) in pairs.flatten() {
                let apart = (&change - &other).amax();
                // rounding of the solves over the step, and curvature within it
                assert!(apart < 1e-3 * (1.0 + change.amax()), "{method}: {apart:e} of {}", change.amax());
                compared += 1;
            }
        }
        assert!(compared > 50, "{method}: {compared}");
    }
}

#[test]
fn a_cable_without_a_range_stays_where_it_is() {
    let mut rng = ChaCha8Rng::seed_from_u64(3);
    let (matrix, wrench, limits) = problem(&mut rng, 2, 3);
    let (mut least, mut largest) = (limits.minimum().to_vec(), limits.maximum().to_vec());
    let middle = limits.middle(1);
    (least[1], largest[1]) = (middle, middle);
    let limits = Limits::new(least, largest).unwrap();
    for method in [Method::Qp, Method::Barrier, Method::Centroid] {
        assert!(compare(method, &matrix, &wrench, &limits) > 0, "{method}");
        let (tensions, _) = found(method, &matrix, &wrench, &limits).unwrap();
        let response = Response::of(method, &matrix, &wrench, &limits, &tensions).unwrap();
        assert!(response.change(0, &[0.3, 0.1], &[1.0, 2.0])[1].abs() < 1e-9, "{method}");
    }
}

#[test]
fn cables_that_are_all_on_their_limits_have_no_derivative() {
    // only the largest tensions of both cables carry the load
    let matrix = DMatrix::from_row_slice(1, 2, &[1.0, 1.0]);
    let limits = Limits::uniform(2, 100.0, 1000.0).unwrap();
    let response = |method| Response::of(method, &matrix, &[-2000.0], &limits, &[1000.0, 1000.0]);
    assert_eq!(response(Method::Qp).unwrap_err(), NotSmooth::Pinned);
    assert_eq!(response(Method::Barrier).unwrap_err(), NotSmooth::Thin { method: Method::Barrier });
    assert_eq!(response(Method::Centroid).unwrap_err(), NotSmooth::Thin { method: Method::Centroid });
}
