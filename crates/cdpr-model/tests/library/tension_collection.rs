//! The exact programme on random poses of eight robots of the shared collection: verdicts against a linear programme
//! of clarabel and against all vertices, optima against their conditions.

use std::path::Path;

use super::distribution::{Opinion, Problem};
use super::problems::random_problem;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_model::tension::quadratic::{Solver, Status};
use cdpr_testing::property;
use nalgebra::{DMatrix, DVector};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Poses of the usual run; `cargo xtask soak` draws four times as many in a round.
const POSES: usize = 25_000;
/// Part of the largest limit within which a problem is on the boundary.
const BOUNDARY: f64 = 1e-6;

/// Planar, suspended and constrained, with and without pulleys, redundancy 0, 1 and 2.
const ROBOTS: [&str; 8] = [
    "planar-example",
    "kntu-planar",
    "cablerobot-simulator-icosahedron",
    "cogiro",
    "caroca-pulleys",
    "spatial-7-cable",
    "fast",
    "ipanema-2",
];

/// The robots, where the collection is at hand.
fn models() -> Option<Vec<Model>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/robots");
    if !folder.is_dir() {
        assert!(std::env::var_os("CI").is_none_or(|ci| ci != "true"), "{} is absent", folder.display());
        println!("skipped: {} is absent", folder.display());
        return None;
    }
    let read = |name: &&str| {
        let bytes = std::fs::read(folder.join(format!("{name}.toml"))).expect("readable");
        Model::new(Robot::from_toml_bytes(&bytes, name).expect("valid"), Composition::STANDARD).expect("a model")
    };
    Some(ROBOTS.iter().map(read).collect())
}

/// p and H of f = p + H λ, by the singular values of nalgebra: nothing of ours.
fn solutions(problem: &Problem) -> (DVector<f64>, DMatrix<f64>) {
    let (n, m) = problem.matrix.shape();
    let mut square = DMatrix::zeros(m, m);
    let scales: Vec<f64> = problem.matrix.row_iter().map(|row| 1.0 / row.norm()).collect();
    for row in 0..n {
        square.set_row(row, &(problem.matrix.row(row) * scales[row]));
    }
    let right = DVector::from_fn(m, |row, _| if row < n { -problem.wrench[row] * scales[row] } else { 0.0 });
    let factors = square.svd(true, true);
    let basis = factors.v_t.as_ref().expect("asked for").rows(n, m - n).transpose();
    (factors.solve(&right, 1e-12).expect("asked for"), basis)
}

/// By how much of the largest limit the best vertex keeps all limits: all points where as many cables as the redundancy
/// stand at a limit, and of those the one that misses the others least.
fn best_vertex(problem: &Problem) -> f64 {
    let (point, basis) = solutions(problem);
    let (m, redundancy) = basis.shape();
    let (least, largest) = (problem.limits.minimum(), problem.limits.maximum());
    let missed = |f: &dyn Fn(usize) -> f64| {
        (0..m).fold(f64::NEG_INFINITY, |most, cable| most.max(least[cable] - f(cable)).max(f(cable) - largest[cable]))
    };
    let mut best = f64::INFINITY;
    let ends = |cable: usize| [least[cable] - point[cable], largest[cable] - point[cable]];
    match redundancy {
        0 => best = missed(&|cable| point[cable]),
        1 => {
            for (cable, end) in (0..m).flat_map(|cable| ends(cable).map(|end| (cable, end))) {
                let along = end / basis[cable];
                best = best.min(missed(&|other| point[other] + along * basis[other]));
            }
        }
        _ => {
            for first in 0..m {
                for second in first + 1..m {
                    let (a, b) = (basis.row(first), basis.row(second));
                    let determinant = a[0] * b[1] - a[1] * b[0];
                    if determinant.abs() < 1e-12 {
                        continue;
                    }
                    for (u, v) in ends(first).into_iter().flat_map(|u| ends(second).map(|v| (u, v))) {
                        let x = [(u * b[1] - v * a[1]) / determinant, (v * a[0] - u * b[0]) / determinant];
                        best = best.min(missed(&|k| point[k] + basis[(k, 0)] * x[0] + basis[(k, 1)] * x[1]));
                    }
                }
            }
        }
    }
    -best / problem.largest_limit()
}

/// How far the tensions are from the optimum at most (N). Multipliers y near clarabel's make A y + f_m − f vanish for tensions
/// off their limits and have the right sign for those on them but for ε; then f is the exact optimum for a reference that is
/// ε away, and a projection on a convex set moves by no more than its reference does.
fn distance_from_optimum(problem: &Problem, tensions: &[f64], multipliers: &[f64]) -> f64 {
    let (n, m) = problem.matrix.shape();
    let limits = &problem.limits;
    let gap = 1e-9 * problem.largest_limit();
    let is_free = |k: usize| tensions[k] > limits.minimum()[k] + gap && tensions[k] < limits.maximum()[k] - gap;
    let free: Vec<usize> = (0..m).filter(|k| is_free(*k)).collect();
    let mut y = DVector::from_column_slice(multipliers);
    let slope = |y: &DVector<f64>, k: usize| tensions[k] - limits.middle(k) - problem.matrix.column(k).dot(y);
    if !free.is_empty() {
        // the smallest change of y that serves the free cables, rows of the balance divided by their length
        let scales: Vec<f64> = problem.matrix.row_iter().map(|row| 1.0 / row.norm()).collect();
        let rows = DMatrix::from_fn(free.len(), n, |i, row| problem.matrix[(row, free[i])] * scales[row]);
        let right = DVector::from_fn(free.len(), |i, _| slope(&y, free[i]));
        let change = rows.svd(true, true).solve(&right, 1e-10).expect("asked for");
        (0..n).for_each(|row| y[row] += change[row] * scales[row]);
    }
    let wrong = |k: usize| {
        let slope = slope(&y, k);
        let (at_least, at_largest) =
            (tensions[k] <= limits.minimum()[k] + gap, tensions[k] >= limits.maximum()[k] - gap);
        match (at_least, at_largest) {
            // at the least tension the reference pulls below it, f − f_m − A y ≥ 0
            (true, false) => slope.min(0.0),
            (false, true) => slope.max(0.0),
            (true, true) => 0.0,
            (false, false) => slope,
        }
    };
    (0..m).map(|k| wrong(k).powi(2)).sum::<f64>().sqrt()
}

#[derive(Debug, Default)]
struct Tally {
    feasible: usize,
    infeasible: usize,
    boundary: usize,
    unclear: usize,
    wrong: Vec<String>,
    far: usize,
    distance: f64,
}

impl Tally {
    fn compare(&mut self, name: &str, solver: &mut Solver, problem: &Problem) {
        let Problem { matrix, wrench, limits } = problem;
        solver.forget();
        let ours = solver.solve(matrix, wrench, limits, None).expect("fits");
        let is_feasible = ours.status == Status::Feasible;
        *(if is_feasible { &mut self.feasible } else { &mut self.infeasible }) += 1;
        let opinion = problem.is_feasible();
        self.unclear += usize::from(opinion == Opinion::Unclear);
        let by_vertices = best_vertex(problem);
        let clarabel_agrees = matches!(opinion, Opinion::Optimum(_)) == is_feasible && opinion != Opinion::Unclear;
        if !clarabel_agrees || (by_vertices > 0.0) != is_feasible {
            let margin = problem.margin();
            self.boundary += usize::from(margin.abs() < BOUNDARY);
            let vertices_differ = (by_vertices > 0.0) != is_feasible && by_vertices.abs() > BOUNDARY;
            if margin.abs() >= BOUNDARY && ((margin > 0.0) != is_feasible || vertices_differ) {
                self.wrong.push(format!("{name}, margin {margin:e}, vertices {by_vertices:e}: {problem:?} {ours:?}"));
            }
        }
        if is_feasible {
            let (_, multipliers) = problem.conic().solve_with_multipliers();
            let distance = distance_from_optimum(problem, &ours.tensions, &multipliers);
            // ten digits of the largest limit, which for FAST is 1.2 MN
            self.far += usize::from(distance > f64::max(1e-6, 1e-10 * problem.largest_limit()));
            self.distance = self.distance.max(distance);
        }
    }
}

#[test]
fn random_poses_of_eight_robots_get_the_right_verdict_and_the_optimum() {
    let Some(models) = models() else { return };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let poses = property::sample(POSES);
    let tallies = |first: usize| {
        let mut tallies: [Tally; 8] = Default::default();
        let mut solvers: Vec<Solver> =
            models.iter().map(|model| Solver::new(model.cable_count(), model.dof())).collect();
        for case in (first..poses).step_by(threads) {
            let robot = case % ROBOTS.len();
            let mut rng = ChaCha8Rng::seed_from_u64(property::first_seed() + 1_000_000 + case as u64);
            let problem = random_problem(&models[robot], &mut rng);
            tallies[robot].compare(ROBOTS[robot], &mut solvers[robot], &problem);
        }
        tallies
    };
    let parts: Vec<[Tally; 8]> = std::thread::scope(|scope| {
        let tallies = &tallies;
        let spawned: Vec<_> = (0..threads).map(|first| scope.spawn(move || tallies(first))).collect();
        spawned.into_iter().map(|part| part.join().expect("compares")).collect()
    });
    let mut total = 0;
    for (robot, name) in ROBOTS.iter().enumerate() {
        let of = |count: &dyn Fn(&Tally) -> usize| parts.iter().map(|part| count(&part[robot])).sum::<usize>();
        let [feasible, infeasible] = [of(&|tally| tally.feasible), of(&|tally| tally.infeasible)];
        let [boundary, unclear, far] =
            [of(&|tally| tally.boundary), of(&|tally| tally.unclear), of(&|tally| tally.far)];
        let distance = parts.iter().fold(0.0_f64, |most, part| most.max(part[robot].distance));
        println!(
            "{name}: {feasible} feasible, {infeasible} not, {boundary} on the boundary, {unclear} unclear, optimum within {distance:e} N"
        );
        total += feasible + infeasible;
        let wrong: Vec<&String> = parts.iter().flat_map(|part| &part[robot].wrong).collect();
        assert!(wrong.is_empty(), "{} wrong, first {}", wrong.len(), wrong[0]);
        assert!(feasible > 250 && infeasible > 250, "a one-sided test of {name}");
        assert!(boundary < 10, "an evasive test of {name}: {boundary}");
        assert_eq!(
            far, 0,
            "{name}: {far} optima further than 1e-6 N and 1e-10 of the largest limit, the furthest {distance:e} N"
        );
    }
    assert_eq!(total, poses);
}
