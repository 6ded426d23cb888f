//! Optimum, smoothness, effect of the width, and the reason given when a part of the load is left.

use nalgebra::{DMatrix, DVector};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::tension::{Answer, Limits, Method, Options, Reference, Response, Status, null_space, solve};

/// Two cables up, two down by half: redundancy 3, at loads along one axis.
fn matrix() -> DMatrix<f64> {
    DMatrix::from_row_slice(1, 4, &[1.0, 0.6, -1.0, -0.3])
}

fn limits() -> Limits {
    Limits::new(vec![100.0; 4], vec![900.0, 1000.0, 800.0, 1000.0]).unwrap()
}

fn answer(method: Method, load: f64) -> Answer {
    solve(method, &matrix(), &[-load], &limits(), &Options::default()).unwrap()
}

/// A problem with tensions well inside the limits, or near to one.
fn problem(rng: &mut ChaCha8Rng, n: usize, m: usize) -> (DMatrix<f64>, Vec<f64>, Limits) {
    let matrix = DMatrix::from_fn(n, m, |_, _| rng.random_range(-1.0..1.0));
    let least: Vec<f64> = (0..m).map(|_| rng.random_range(50.0..150.0)).collect();
    let largest: Vec<f64> = least.iter().map(|least| least + rng.random_range(300.0..900.0)).collect();
    let inside =
        DVector::from_fn(m, |cable, _| least[cable] + (largest[cable] - least[cable]) * rng.random_range(0.02..0.98));
    let wrench = -(&matrix * inside);
    (matrix, wrench.as_slice().to_vec(), Limits::new(least, largest).unwrap())
}

/// Σ φ as the paper writes it, in units of half the largest range.
fn cost(tensions: &[f64], limits: &Limits, reference: &[f64], options: &Options<'_>) -> f64 {
    let ranges = limits.minimum().iter().zip(limits.maximum());
    let unit = 0.5 * ranges.clone().fold(0.0_f64, |most, (least, largest)| most.max(largest - least));
    let barrier = options.smoothing.powi(2);
    let terms = tensions.iter().zip(reference).zip(ranges).map(|((f, reference), (least, largest))| {
        let norm = ((f - reference) / unit).abs().powf(options.p) / options.p;
        norm - barrier * (((f - least) / unit).ln() + ((largest - f) / unit).ln())
    });
    terms.sum()
}

/// With one degree of redundancy the optimum is the least point of a line, found without derivatives.
#[test]
fn the_answer_is_the_least_cost_along_the_line_of_balanced_tensions() {
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    for case in 0..120 {
        let (matrix, wrench, limits) = problem(&mut rng, 1 + case % 4, 2 + case % 4);
        let p = [2.0, 3.0, 2.5, 8.0][case % 4];
        let reference: Vec<f64> = (0..matrix.ncols()).map(|_| rng.random_range(0.0..1000.0)).collect();
        let smoothing = [0.1, 0.03, 0.5][case % 3];
        let options = Options { p, smoothing, reference: Reference::Given(&reference), ..Options::default() };
        let found = solve(Method::Smooth, &matrix, &wrench, &limits, &options).unwrap();
        assert_eq!(found.status, Status::Feasible, "case {case}: {:?}", found.reason());
        let way = null_space(&matrix).unwrap();
        let at = |part: f64| {
            let f: Vec<f64> = found.tensions.iter().zip(way.iter()).map(|(f, way)| f + part * way).collect();
            if limits.contain(&f, -1e-12) { cost(&f, &limits, &reference, &options) } else { f64::INFINITY }
        };
        // golden section for a convex function that is infinite beyond the limits
        let (mut low, mut high) = (-2000.0, 2000.0);
        for _ in 0..80 {
            let [a, b] = [0.618, 0.382].map(|part| high - part * (high - low));
            // outside the allowed part on both sides, the end nearer to the answer is the better one
            let (at_a, at_b) = (at(a), at(b));
            let a_is_better = if at_a.is_infinite() && at_b.is_infinite() { a.abs() < b.abs() } else { at_a < at_b };
            if a_is_better { high = b } else { low = a }
        }
        let apart = 0.5 * (low + high);
        // the cost is flat to rounding over 1e-8 of the range about its least point
        assert!(apart.abs() < 1e-3 && at(0.0) <= at(apart) + 1e-12, "case {case}, p = {p}: {apart} N");
    }
}

/// Largest change of slope from one step of the load to the next: it goes to 0 with the step if there is no kink.
fn kink(method: Method, loads: [f64; 2], step: f64) -> f64 {
    let count = ((loads[1] - loads[0]) / step) as usize;
    let found: Vec<_> = (0..count).map(|index| answer(method, loads[0] + step * index as f64).tensions).collect();
    let bends = found.windows(3).flat_map(|three| {
        let bend = |cable: usize| (three[0][cable] - 2.0 * three[1][cable] + three[2][cable]).abs() / step;
        (0..4).map(bend).collect::<Vec<_>>()
    });
    bends.fold(0.0, f64::max)
}

#[test]
fn tensions_pass_a_limit_without_a_kink_where_qp_has_one() {
    // the third cable comes to its least tension at 215 N + 2.45 · 350 N = 1072.5 N
    let bends = |method| [4.0, 2.0, 1.0].map(|step| kink(method, [900.0, 1200.0], step));
    let [sharp, smooth] = [Method::Qp, Method::Smooth].map(bends);
    assert!(sharp.iter().all(|bend| *bend > 0.1), "{sharp:?}");
    assert!(smooth[1] < 0.6 * smooth[0] && smooth[2] < 0.6 * smooth[1], "{smooth:?}");
}

#[test]
fn the_derivative_is_that_of_the_answer_through_a_limit() {
    let mut compared = 0;
    for load in (-60..140).map(|index| 10.0 * f64::from(index) + 3.0) {
        let here = answer(Method::Smooth, load);
        if here.status != Status::Feasible {
            continue;
        }
        let response = Response::of(Method::Smooth, &matrix(), &[-load], &limits(), &here.tensions).unwrap();
        let change = response.change(0, &[0.0], &[-1.0]);
        let [ahead, behind] = [1e-3, -1e-3].map(|by| answer(Method::Smooth, load + by).tensions);
        for cable in 0..4 {
            let slope = (ahead[cable] - behind[cable]) / 2e-3;
            assert!((change[cable] - slope).abs() < 1e-5, "{load} N, cable {cable}: {} {slope}", change[cable]);
        }
        compared += 1;
    }
    assert!(compared > 150, "{compared}");
}

/// Rows of several degrees of freedom and all entries of the matrix.
#[test]
fn the_derivative_is_that_of_the_answer_by_matrix_and_load() {
    let mut rng = ChaCha8Rng::seed_from_u64(8);
    for _ in 0..10 {
        let (matrix, wrench, limits) = problem(&mut rng, 3, 5);
        let at = |by: f64, column: &[f64; 3], load: &[f64; 3]| {
            let (mut matrix, mut wrench) = (matrix.clone(), wrench.clone());
            for row in 0..3 {
                matrix[(row, 2)] += by * column[row];
                wrench[row] += by * load[row];
            }
            solve(Method::Smooth, &matrix, &wrench, &limits, &Options::default()).unwrap().tensions
        };
        let (column, load) = ([1e-3, -2e-3, 5e-4], [0.4, -0.7, 0.2]);
        let here = at(0.0, &column, &load);
        let response = Response::of(Method::Smooth, &matrix, &wrench, &limits, &here).unwrap();
        let change = response.change(2, &column, &load);
        let [ahead, behind] = [1e-3, -1e-3].map(|by| at(by, &column, &load));
        for cable in 0..5 {
            let slope = (ahead[cable] - behind[cable]) / 2e-3;
            assert!((change[cable] - slope).abs() < 1e-5 * (1.0 + slope.abs()), "{} {slope}", change[cable]);
        }
    }
}

#[test]
fn without_width_the_answer_is_that_of_qp_and_of_the_least_norm() {
    let mut rng = ChaCha8Rng::seed_from_u64(2);
    for case in 0..60 {
        let (matrix, wrench, limits) = problem(&mut rng, 1 + case % 6, 3 + case % 7);
        let zeros = vec![0.0; matrix.ncols()];
        for (method, reference) in [(Method::Qp, Reference::Middle), (Method::Minimum, Reference::Given(&zeros))] {
            let goal = solve(method, &matrix, &wrench, &limits, &Options::default()).unwrap();
            let apart = |smoothing: f64| {
                let options = Options { smoothing, reference, ..Options::default() };
                let found = solve(Method::Smooth, &matrix, &wrench, &limits, &options).unwrap();
                assert_eq!(found.status, Status::Feasible, "case {case}, {smoothing}: {:?}", found.reason());
                found.tensions.iter().zip(&goal.tensions).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()))
            };
            // by the width where a tension just touches its limit, by its square elsewhere; 450 N are half a range
            let [wide, narrow] = [1e-2, 1e-4].map(apart);
            assert!(wide < 20.0 && narrow < 0.2, "case {case}, {method}: {wide} N, {narrow} N");
        }
    }
}

#[test]
fn a_load_beyond_reach_is_given_up_without_a_kink_and_in_words() {
    // at most 900 + 0.6 · 1000 − 100 − 0.3 · 100 N
    let edge = 1370.0;
    let inside = answer(Method::Smooth, edge - 10.0);
    assert!(inside.status == Status::Feasible && inside.wrench_residual[0].abs() < 1e-9, "{inside:?}");
    // qp finds the only remaining point, and a smooth answer stays away from it
    let near = answer(Method::Smooth, edge - 1e-4);
    assert_eq!(near.status, Status::NotFound);
    let reason = near.reason().unwrap();
    assert!(reason.contains("of the load") && reason.contains("qp does"), "{reason}");
    let beyond = answer(Method::Smooth, edge + 50.0);
    assert_eq!(beyond.status, Status::Infeasible);
    assert!(beyond.has_tensions() && limits().contain(&beyond.tensions, 0.0), "{beyond:?}");
    let lacking = beyond.missing_wrench()[0].abs();
    assert!((lacking - 50.0).abs() < 1.0 && beyond.certificate().is_some(), "{lacking} N");
    // balance is lost 0.02 N before the edge, gradually over thousandths of a newton
    let bends = [4e-4, 2e-4, 1e-4].map(|step| kink(Method::Smooth, [edge - 0.05, edge + 0.01], step));
    assert!(bends[1] < 0.6 * bends[0] && bends[2] < 0.6 * bends[1], "{bends:?}");
}

#[test]
fn a_sum_of_tensions_is_refused() {
    let refused = solve(Method::Smooth, &matrix(), &[0.0], &limits(), &Options { p: 1.5, ..Options::default() });
    assert!(refused.unwrap_err().to_string().contains("from 2 to 8"));
    let refused =
        solve(Method::Smooth, &matrix(), &[0.0], &limits(), &Options { smoothing: 0.0, ..Options::default() });
    assert!(refused.unwrap_err().to_string().contains("smoothing width"));
}
