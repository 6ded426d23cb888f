//! Properties of the distribution; the comparison with another solver is in `tests/library/tension_oracle.rs`.

use nalgebra::{DMatrix, DVector};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::*;
use crate::reading::Keyword;
use crate::scalar::{LANES, Unit, dispatch_on};
use crate::tension::{self, LimitsError, Method, Options, Reference};
use cdpr_testing::property;

/// A point on a vertical line between two cables: f₁ − f₂ = w.
fn tug_of_war() -> DMatrix<f64> {
    DMatrix::from_row_slice(1, 2, &[1.0, -1.0])
}

/// Two cables up, one down, in one line.
fn two_against_one() -> DMatrix<f64> {
    DMatrix::from_row_slice(1, 3, &[1.0, 1.0, -1.0])
}

fn limits(count: usize) -> Limits {
    Limits::uniform(count, 1000.0, 4500.0).unwrap()
}

fn random_problem(rng: &mut ChaCha8Rng) -> (DMatrix<f64>, Vec<f64>, Limits) {
    let (m, n) = (rng.random_range(1..=12), rng.random_range(1..=6));
    let matrix = DMatrix::from_fn(n, m, |_, _| rng.random_range(-1.0..1.0));
    let least: Vec<f64> = (0..m).map(|_| rng.random_range(0.0..100.0)).collect();
    let largest: Vec<f64> = least.iter().map(|least| least + rng.random_range(0.0..1000.0)).collect();
    let inside = DVector::from_fn(m, |i, _| least[i] + (largest[i] - least[i]) * rng.random_range(-0.2..1.2));
    let wrench = -(&matrix * inside);
    (matrix, wrench.as_slice().to_vec(), Limits::new(least, largest).unwrap())
}

/// By hand: f₁ = f₂ + 1000 and f₁ + f₂ = 2 · 2750 in the middle.
#[test]
fn the_tensions_of_a_tug_of_war_are_those_done_by_hand() {
    let found = solve(&tug_of_war(), &[-1000.0], &limits(2), None).unwrap();
    assert_eq!(found.status, Status::Feasible);
    assert!((found.tensions[0] - 3250.0).abs() < 1e-9 && (found.tensions[1] - 2250.0).abs() < 1e-9);
    assert!(found.reason().is_none() && found.certificate().is_none());
    // at the upper limit of cable 1 cable 2 follows
    let far = solve(&tug_of_war(), &[-3000.0], &limits(2), None).unwrap();
    assert!((far.tensions[0] - 4250.0).abs() < 1e-9 && (far.tensions[1] - 1250.0).abs() < 1e-9);
}

#[test]
fn the_reason_names_the_cables_and_the_newtons() {
    for (matrix, w, reason) in [
        (
            two_against_one(),
            -10300.0,
            "even with cable 3 at the least tension, cables 1 and 2 would need 11.3 kN together, their limits allow 9.00 kN",
        ),
        (
            tug_of_war(),
            -4000.0,
            "even with cable 2 at the least tension, cable 1 would need 5.00 kN, its limit allows 4.50 kN",
        ),
        (
            DMatrix::from_row_slice(1, 2, &[1.0, 0.5]),
            -9000.0,
            "cables 1 and 2 would need 9.00 kN together (counted as 1.00 f1 + 0.50 f2), their limits allow 6.75 kN",
        ),
        (
            DMatrix::from_row_slice(1, 2, &[1.0, 1.0]),
            500.0,
            "cables 1 and 2 would have to push with 500 N together, their limits ask for a pull of 2.00 kN",
        ),
        (
            DMatrix::from_row_slice(1, 1, &[2.0]),
            -1000.0,
            "cable 1 may pull with 500 N at most, its limit asks for 1.00 kN",
        ),
    ] {
        let found = solve(&matrix, &[w], &limits(matrix.ncols()), None).unwrap();
        assert_eq!((found.status, found.reason().as_deref()), (Status::Infeasible, Some(reason)));
        assert!(found.certificate().unwrap().proves(&matrix, &[w], &limits(matrix.ncols())));
    }
}

/// Two cables along x cannot hold a load along y; along x they can.
#[test]
fn a_load_outside_the_range_of_the_cables_is_infeasible_and_told() {
    let matrix = DMatrix::from_row_slice(2, 2, &[1.0, -1.0, 0.0, 0.0]);
    let along = solve(&matrix, &[-500.0, 0.0], &limits(2), None).unwrap();
    assert_eq!(along.status, Status::Feasible);
    assert!((along.tensions[0] - along.tensions[1] - 500.0).abs() < 1e-9);
    let across = solve(&matrix, &[-500.0, -981.0], &limits(2), None).unwrap();
    assert_eq!(across.status, Status::Infeasible);
    assert!(across.certificate().unwrap().proves(&matrix, &[-500.0, -981.0], &limits(2)));
    let reason = across.reason().unwrap();
    assert!(reason.contains("[0.000, 1.000]") && reason.contains("981 N"), "{reason}");
}

/// Optimality: balance, limits, and f − f_ref = A y + Σ multipliers of the right sign at limits (Karush, Kuhn, Tucker),
/// checked by projection on the rows and the limits that are met.
#[test]
fn every_verdict_proves_itself() {
    let mut rng = ChaCha8Rng::seed_from_u64(31);
    let (mut feasible, mut infeasible) = (0, 0);
    for case in 0..3000 {
        let (matrix, wrench, limits) = random_problem(&mut rng);
        let found = solve(&matrix, &wrench, &limits, None).unwrap();
        match found.status {
            Status::Feasible => {
                feasible += 1;
                assert!(limits.contain(&found.tensions, 0.0), "case {case}");
                // 12 tensions of 1000 N, balanced to the limits' tolerance 1e-10 each
                assert!(found.wrench_residual.iter().all(|residual| residual.abs() < 2e-6), "case {case}: {found:?}");
            }
            Status::Infeasible => {
                infeasible += 1;
                assert!(found.certificate().unwrap().proves(&matrix, &wrench, &limits), "case {case}: {found:?}");
            }
            Status::Undecided => panic!("case {case}: {found:?}"),
        }
    }
    assert!(feasible > 500 && infeasible > 500, "{feasible} {infeasible}");
}

#[test]
fn the_result_does_not_depend_on_what_was_solved_before() {
    let mut rng = ChaCha8Rng::seed_from_u64(32);
    for case in 0..200 {
        let (matrix, wrench, limits) = random_problem(&mut rng);
        let mut solver = Solver::new(matrix.ncols(), matrix.nrows());
        for step in 0..20 {
            let wrench: Vec<f64> = wrench.iter().map(|w| w * (1.0 + 0.2 * rng.random_range(-1.0..1.0))).collect();
            let cold = solve(&matrix, &wrench, &limits, None).unwrap();
            let warm = solver.solve(&matrix, &wrench, &limits, None).unwrap();
            assert_eq!(warm.status, cold.status, "case {case}, step {step}");
            if cold.status == Status::Feasible {
                let apart = warm.tensions.iter().zip(&cold.tensions).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                // both are within the tolerance of 1e-7 N of the limits, times the condition of the active rows
                assert!(apart < 1e-5, "case {case}, step {step}: {apart:e} N");
            }
        }
        solver.forget();
        let fresh = solver.solve(&matrix, &wrench, &limits, None).unwrap().tensions.clone();
        assert_eq!(fresh, solve(&matrix, &wrench, &limits, None).unwrap().tensions);
    }
}

/// Moments in N·m, N·mm or N·km are the same problem; so are forces in N or kN.
#[test]
fn units_of_rows_and_forces_do_not_matter() {
    let mut rng = ChaCha8Rng::seed_from_u64(33);
    for case in 0..500 {
        let (matrix, wrench, limits) = random_problem(&mut rng);
        let found = solve(&matrix, &wrench, &limits, None).unwrap();
        let factors: Vec<f64> = (0..matrix.nrows()).map(|_| 10f64.powi(rng.random_range(-4..=4))).collect();
        let rows = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| factors[i] * matrix[(i, j)]);
        let scaled: Vec<f64> = wrench.iter().zip(&factors).map(|(w, factor)| 1e-3 * w * factor).collect();
        let kilonewtons = |limits: &[f64]| limits.iter().map(|limit| 1e-3 * limit).collect();
        let small = Limits::new(kilonewtons(limits.minimum()), kilonewtons(limits.maximum())).unwrap();
        let other = solve(&rows, &scaled, &small, None).unwrap();
        assert_eq!(found.status, other.status, "case {case}");
        if found.status == Status::Feasible {
            let apart = found.tensions.iter().zip(&other.tensions).map(|(a, b)| (a - 1e3 * b).abs());
            assert!(apart.fold(0.0, f64::max) < 1e-5, "case {case}");
        }
    }
}

/// Anchors that coincide make equal rows in the null space: ties everywhere, and the search still ends.
#[test]
fn ties_do_not_cycle() {
    let count = 16;
    let matrix = DMatrix::from_fn(2, count, |row, cable| if (cable / 2 % 2 == 0) == (row == 0) { 1.0 } else { -1.0 });
    let limits = limits(count);
    for (w, status) in
        [(0.0, Status::Feasible), (-7000.0 * 4.0, Status::Infeasible), (3500.0 * 8.0, Status::Infeasible)]
    {
        let found = solve(&matrix, &[w, -w], &limits, None).unwrap();
        let edge = solve(&matrix, &[w, w], &limits, None).unwrap();
        assert_ne!(found.status, Status::Undecided);
        assert_eq!(edge.status, if w == 0.0 { Status::Feasible } else { Status::Infeasible });
        assert!(found.status == Status::Feasible || status == Status::Infeasible, "{found:?}");
    }
}

#[test]
fn what_cannot_be_calculated_with_is_refused() {
    let error = |matrix: DMatrix<f64>, wrench: &[f64], limits: &Limits, reference| {
        solve(&matrix, wrench, limits, reference).unwrap_err().to_string()
    };
    let limits = limits(2);
    assert!(error(tug_of_war(), &[0.0, 0.0], &limits, None).contains("expected 1 wrench components"));
    assert!(error(two_against_one(), &[0.0], &limits, None).contains("limits of 3 cables"));
    assert!(error(tug_of_war(), &[0.0], &limits, Some(&[1.0])).contains("expected 2 reference tensions"));
    assert!(error(tug_of_war(), &[f64::NAN], &limits, None).contains("wrench is not finite"));
    assert!(error(tug_of_war(), &[1e300], &limits, None).contains("wrench is not finite"));
    assert!(error(tug_of_war() * f64::INFINITY, &[0.0], &limits, None).contains("structure matrix is not finite"));
    assert!(error(tug_of_war(), &[0.0], &limits, Some(&[1.0, f64::NAN])).contains("reference is not finite"));
    assert!(matches!(Limits::uniform(2, 2.0, 1.0), Err(LimitsError::EmptyRange { cable: 1, .. })));
    assert!(matches!(Limits::uniform(2, f64::NAN, 1.0), Err(LimitsError::NotFinite { cable: 1, .. })));
    assert!(matches!(Limits::new(vec![0.0], vec![1.0, 2.0]), Err(LimitsError::Count { .. })));
}

/// The vector unit depends on the machine; results must not.
#[test]
fn the_fixed_size_balance_gives_the_same_bits_on_every_unit() {
    let mut rng = ChaCha8Rng::seed_from_u64(34);
    for cables in 6..=8 {
        let matrix = DMatrix::from_fn(6, cables, |_, _| rng.random_range(-1.0..1.0));
        let wrench: Vec<f64> = (0..6).map(|_| rng.random_range(-1000.0..1000.0)).collect();
        let on = |unit| {
            let [mut scales, mut factors, mut triangle] = [vec![0.0; 6], vec![0.0; 6], vec![0.0; 36]];
            let (mut reflectors, mut solutions) = (vec![[0.0; LANES]; 6], vec![[0.0; LANES]; cables - 5]);
            let problem = fixed::Solutions::<6> {
                structure_matrix: matrix.as_slice(),
                wrench: &wrench,
                row_scales: &mut scales,
                factors: &mut factors,
                reflectors: &mut reflectors,
                triangle: &mut triangle,
                solutions: &mut solutions,
            };
            assert_eq!(dispatch_on(unit, problem), Some(true));
            let numbers = [scales, factors, triangle, reflectors.concat(), solutions.concat()].concat();
            numbers.iter().map(|number| number.to_bits()).collect::<Vec<_>>()
        };
        for unit in Unit::available() {
            assert_eq!(on(unit), on(Unit::Portable), "{unit:?}, {cables} cables");
        }
    }
}

/// Usual numbers, numbers of any size that a double has, and no numbers.
fn extreme(rng: &mut ChaCha8Rng) -> f64 {
    match rng.random_range(0..10) {
        0..=5 => rng.random_range(-10.0..10.0),
        6 | 7 => rng.random_range(-1.0..1.0_f64).signum() * 10f64.powf(rng.random_range(-320.0..308.0)),
        8 => [0.0, -0.0, 1.0, 5e-324, f64::MIN_POSITIVE, 1e154, -1e154][rng.random_range(0..7)],
        _ => [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e308, -1e308, 1e100][rng.random_range(0..6)],
    }
}

/// Overflow ends in "undecided" with a reason, not in a panic or in unusable tensions.
#[test]
fn extreme_numbers_are_refused_or_end_in_a_status_that_is_true() {
    let mut counts = [0; 4];
    for case in property::seeds(10_000) {
        let mut rng = ChaCha8Rng::seed_from_u64(case);
        let n = rng.random_range(1..=6);
        let m = rng.random_range(1..=n + 3);
        let is_plain = rng.random_bool(0.5);
        let number = |rng: &mut ChaCha8Rng| if is_plain { rng.random_range(-1.0..1.0) } else { extreme(rng) };
        let matrix = DMatrix::from_fn(n, m, |_, _| number(&mut rng));
        let wrench: Vec<f64> = (0..n).map(|_| 100.0 * extreme(&mut rng)).collect();
        let ends: Vec<[f64; 2]> = (0..m)
            .map(|_| [extreme(&mut rng), extreme(&mut rng)])
            .map(|[a, b]| if a <= b { [a, b] } else { [b, a] })
            .collect();
        let limits = Limits::new(ends.iter().map(|end| end[0]).collect(), ends.iter().map(|end| end[1]).collect());
        let Ok(limits) = limits else { continue };
        let reference: Vec<f64> = (0..m).map(|_| extreme(&mut rng)).collect();
        let options = Options { reference: Reference::Given(&reference), ..Options::default() };
        for &method in Method::ALL {
            for options in [&options, &Options::default()] {
                let Ok(found) = tension::solve(method, &matrix, &wrench, &limits, options) else { continue };
                let words = found.reason();
                assert_eq!(words.is_none(), found.status == tension::Status::Feasible, "case {case}, {method}");
                counts[found.status as usize] += 1;
                let is_finite = found.tensions.iter().chain(&found.wrench_residual).all(|number| number.is_finite());
                match found.status {
                    tension::Status::Feasible => {
                        assert!(is_finite && limits.contain(&found.tensions, 0.0), "case {case}, {method}: {found:?}");
                    }
                    tension::Status::Infeasible => {
                        let proof = found.certificate().unwrap();
                        assert!(proof.reachable < proof.required, "case {case}, {method}: {found:?}");
                        assert!(proof.required.is_finite() && proof.reachable.is_finite(), "case {case}: {found:?}");
                    }
                    _ => {}
                }
            }
        }
    }
    assert!(counts[0] > 1000 && counts[1] > 1000, "{counts:?}");
}

/// The work of the centroid grows by a factor of about twenty per degree of redundancy: it ends with a reason, not
/// after minutes.
#[test]
fn a_set_of_too_many_dimensions_has_no_centroid_in_words() {
    let mut rng = ChaCha8Rng::seed_from_u64(36);
    for (redundancy, is_found) in [(3, true), (4, true), (9, false), (14, false)] {
        let matrix = DMatrix::from_fn(2, 2 + redundancy, |_, _| rng.random_range(-1.0..1.0));
        let limits = limits(2 + redundancy);
        let wrench: Vec<f64> = (matrix.column_sum() * -2500.0).as_slice().to_vec();
        let found = tension::solve(Method::Centroid, &matrix, &wrench, &limits, &Options::default()).unwrap();
        let reason = found.reason().unwrap_or_default();
        assert_eq!(found.status == tension::Status::Feasible, is_found, "{redundancy}: {reason}");
        assert!(is_found || reason.contains(&format!("{redundancy} dimensions")), "{reason}");
    }
}
