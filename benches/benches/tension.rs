//! Tension distribution at one pose, CableRobot Simulator (m = 8, n = 6): `cargo bench -p benches --bench tension`.
//!
//! `feasible` are random poses with loads that tensions drawn from within the limits balance, `infeasible` the same with
//! tensions drawn from beyond them; every problem has another structure matrix. `path` are 256 poses along a line under one
//! load: cold as if each were the first, warm from the limits that were active at the pose before.
//!
//! The tables come first: the exact programme beside clarabel, and every method with the steps it took. Candidates take turns in
//! short rounds of the wall clock; `best` is the least of the rounds, what the machine gives with nothing else on it.

mod clock;
#[path = "../../crates/cdpr-model/tests/distribution/mod.rs"]
mod distribution;

use std::hint::black_box;

use cdpr::geometry::Pose;
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::{DVector, Vector3};
use cdpr::reading::Keyword;
use cdpr::robot::Robot;
use cdpr::tension::quadratic::{Solver, Status, solve};
use cdpr::tension::{self, Limits, Method, Options, closed_form};
use clock::{Time, times};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, Criterion};
use distribution::{Conic, Opinion, Problem};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const COUNT: usize = 256;

/// The problem at this pose whose load these tensions, as parts of the limits' range, balance.
fn problem(model: &Model, pose: &Pose, parts: &DVector<f64>) -> Problem {
    let limits = Limits::uniform(model.cable_count(), 1000.0, 9000.0).expect("in order");
    let matrix = model.structure_matrix(pose).expect("courses");
    let wrench = -(&matrix * parts.map(|part| 1000.0 + 8000.0 * part));
    Problem { matrix, wrench: wrench.as_slice().to_vec(), limits }
}

fn status(problem: &Problem) -> Status {
    solve(&problem.matrix, &problem.wrench, &problem.limits, None).expect("fits").status
}

/// Random poses, with the parts of the range drawn from this interval, that end in this way.
fn random_problems(model: &Model, parts: [f64; 2], wanted: Status) -> Vec<Problem> {
    let mut rng = ChaCha8Rng::seed_from_u64(51);
    let mut problems = Vec::new();
    while problems.len() < COUNT {
        let mut vector = |size: f64| Vector3::from_fn(|_, _| size * rng.random_range(-1.0..1.0));
        let position = Vector3::new(0.0, 0.0, 1.6) + vector(1.5).component_mul(&Vector3::new(1.0, 1.0, 0.25));
        let pose = Pose::from_xyz_angles(position, vector(0.15).into());
        let candidate = problem(model, &pose, &DVector::from_fn(8, |_, _| rng.random_range(parts[0]..parts[1])));
        if status(&candidate) == wanted {
            problems.push(candidate);
        }
    }
    problems
}

/// One load along a line through the workspace.
fn path(model: &Model) -> Vec<Problem> {
    let at = |step: usize| {
        let part = step as f64 / COUNT as f64 - 0.5;
        Pose::from_xyz_angles(Vector3::new(2.0 * part, -part, 1.6), [0.0, 0.0, 0.2 * part])
    };
    let parts = DVector::from_column_slice(&[0.75, 0.05, 0.55, 0.25, 0.65, 0.0, 0.55, 0.2]);
    let wrench = problem(model, &at(COUNT / 2), &parts).wrench;
    (0..COUNT).map(|step| Problem { wrench: wrench.clone(), ..problem(model, &at(step), &parts) }).collect()
}

/// Time per problem of a solver that keeps its memory.
fn bench_reused(group: &mut BenchmarkGroup<WallTime>, name: &str, problems: &[Problem], cold: bool) {
    let mut solver = Solver::new(8, 6);
    let mut problems = problems.iter().cycle();
    group.bench_function(name, |bencher| {
        bencher.iter(|| {
            let problem = problems.next().expect("has no end");
            if cold {
                solver.forget();
            }
            solver.solve(black_box(&problem.matrix), &problem.wrench, &problem.limits, None).map(|found| found.status)
        });
    });
}

/// Rounds of each candidate, and how long one lasts at least (s).
const ROUNDS: usize = 301;
const SHORT: f64 = 0.0005;

/// Times per problem of the exact programme, cold, and of clarabel on the same problems.
#[expect(clippy::print_stdout, reason = "the table is what the bench is for")]
fn compare(feasible: &[Problem], infeasible: &[Problem]) {
    let exact = |problems: &[Problem], solver: &mut Solver| {
        for Problem { matrix, wrench, limits } in problems {
            solver.forget();
            let found = solver.solve(black_box(matrix), wrench, limits, None).expect("fits");
            black_box(found.status);
        }
    };
    // few problems of clarabel make a round already
    let few = COUNT / 32;
    let programmes =
        [feasible, infeasible].map(|problems| problems[..few].iter().map(Problem::conic).collect::<Vec<_>>());
    let interior = |programmes: &[Conic]| {
        for programme in programmes {
            black_box(matches!(programme.solve(), Opinion::Optimum(_)));
        }
    };
    let (mut first, mut second) = (Solver::new(8, 6), Solver::new(8, 6));
    let found = times(
        COUNT,
        ROUNDS,
        SHORT,
        &mut [
            &mut || exact(feasible, &mut first),
            &mut || exact(infeasible, &mut second),
            &mut || interior(&programmes[0]),
            &mut || interior(&programmes[1]),
        ],
    );
    let row = |name: &str, ours: Time, theirs: Time| {
        let share = (COUNT / few) as f64;
        let ratios = [share * theirs.median / ours.median, share * theirs.best / ours.best];
        println!(
            "exact programme, {name}: {:.0} ns, best {:.0}; clarabel ×{:.0}, best ×{:.0} (goal ×60)",
            ours.median, ours.best, ratios[0], ratios[1]
        );
    };
    row("feasible (goal 600 ns)", found[0], found[2]);
    row("infeasible", found[1], found[3]);
    let ratios = [found[1].median / found[0].median, found[1].best / found[0].best];
    println!("infeasible beside feasible: ×{:.2}, best ×{:.2} (goal ×1.4)", ratios[0], ratios[1]);
}

/// Every method through the common interface, cold: times and steps, as the book's table has them.
#[expect(clippy::print_stdout, reason = "the table is what the bench is for")]
fn methods(feasible: &[Problem], infeasible: &[Problem]) {
    println!("\n| method | feasible | best | infeasible | best | steps, feasible | steps, infeasible |");
    println!("|---|---|---|---|---|---|---|");
    for &method in Method::ALL {
        let pass = |problems: &[Problem], solver: &mut tension::Solver, steps: &mut dyn FnMut(u32)| {
            for Problem { matrix, wrench, limits } in problems {
                solver.forget();
                let found = solver.solve(black_box(matrix), wrench, limits, &Options::default()).expect("fits");
                steps(found.iterations);
            }
        };
        let mut solver = tension::Solver::new(method, 8, 6);
        let steps = [feasible, infeasible].map(|problems| {
            let mut all = Vec::with_capacity(COUNT);
            pass(problems, &mut solver, &mut |steps| all.push(steps));
            let mean = all.iter().map(|&steps| f64::from(steps)).sum::<f64>() / all.len() as f64;
            format!("{mean:.1} (most {})", all.iter().max().copied().unwrap_or(0))
        });
        let mut other = tension::Solver::new(method, 8, 6);
        let found = times(
            COUNT,
            ROUNDS,
            SHORT,
            &mut [&mut || pass(feasible, &mut solver, &mut |steps| _ = black_box(steps)), &mut || {
                pass(infeasible, &mut other, &mut |steps| _ = black_box(steps))
            }],
        );
        let time = |nanoseconds: f64| match nanoseconds {
            small if small < 1e3 => format!("{small:.0} ns"),
            large => format!("{:.1} µs", large * 1e-3),
        };
        let [yes, no] = [found[0], found[1]].map(|found| format!("{} | {}", time(found.median), time(found.best)));
        println!("| `{method}` | {yes} | {no} | {} | {} |", steps[0], steps[1]);
    }
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args();
    let robot = Robot::builtin("cablerobot-simulator-helicopter").expect("built in");
    let model = Model::new(robot, Composition::STANDARD).expect("a model");
    let feasible = random_problems(&model, [0.0, 1.0], Status::Feasible);
    let infeasible = random_problems(&model, [-0.5, 1.5], Status::Infeasible);
    let path = path(&model);
    assert!(path.iter().all(|problem| status(problem) == Status::Feasible));
    compare(&feasible, &infeasible);
    methods(&feasible, &infeasible);
    let mut group = criterion.benchmark_group("tension distribution 8 × 6");
    bench_reused(&mut group, "feasible", &feasible, true);
    bench_reused(&mut group, "infeasible", &infeasible, true);
    bench_reused(&mut group, "path, cold", &path, true);
    bench_reused(&mut group, "path, warm", &path, false);
    let mut problems = feasible.iter().cycle();
    group.bench_function("feasible, one call", |bencher| {
        bencher.iter(|| {
            let Problem { matrix, wrench, limits } = problems.next().expect("has no end");
            solve(black_box(matrix), wrench, limits, None).map(|found| found.status)
        });
    });
    let mut closed_form = closed_form::Solver::new(8, 6);
    group.bench_function("feasible, closed form", |bencher| {
        bencher.iter(|| {
            let Problem { matrix, wrench, limits } = problems.next().expect("has no end");
            closed_form.solve(black_box(matrix), wrench, limits, None).map(|found| found.within_limits)
        });
    });
    group.finish();
    criterion.final_summary();
}
