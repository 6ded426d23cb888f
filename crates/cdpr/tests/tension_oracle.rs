//! The exact quadratic programme against clarabel: 100 000 problems, verdicts and optima.
//!
//! How near a problem is to the boundary of what is feasible is measured by a linear programme: by how much of the largest
//! limit all limits could be narrower, or would have to be wider ([`Problem::margin`]). Nearer than 1e-6 either verdict counts as right.

mod distribution;
mod support;

use cdpr::geometry::Pose;
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::{DVector, Vector3};
use cdpr::robot::{Cable, Robot, builtin};
use cdpr::tension::Limits;
use cdpr::tension::quadratic::{self, Status};
use distribution::{Opinion, Problem};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use support::{builtin as robot, random_direction, random_pose, within_pattern};

const PROBLEMS: usize = 100_000;
/// Part of the largest limit within which a problem is on the boundary.
const BOUNDARY: f64 = 1e-6;

/// All built-in robots (redundancy 0, 1 and 2), and made-up ones with redundancy 0 to 6.
fn models() -> Vec<Model> {
    let mut rng = ChaCha8Rng::seed_from_u64(41);
    let mut robots: Vec<Robot> = builtin::names().map(robot).collect();
    for redundancy in 0..=6 {
        robots.push(made_up(&robot("planar-example"), 2 + redundancy, &mut rng));
        robots.push(made_up(&robot("kntu-planar"), 3 + redundancy, &mut rng));
        robots.push(made_up(&support::simulator(), 6 + redundancy, &mut rng));
    }
    robots.into_iter().map(|robot| Model::new(robot, Composition::STANDARD).expect("a model")).collect()
}

/// Cables from anywhere on a sphere to anywhere on a platform, in the plane of the robot that lends its motion pattern.
fn made_up(pattern: &Robot, cable_count: usize, rng: &mut ChaCha8Rng) -> Robot {
    let home = pattern.home.expect("has a home pose").position;
    let planar = pattern.motion_pattern != support::simulator().motion_pattern;
    let flat = |v: Vector3<f64>| if planar { Vector3::new(v.x, v.y, 0.0) } else { v };
    let platform = if pattern.cables.iter().any(|cable| cable.platform_anchor.norm() > 0.0) { 0.5 } else { 0.0 };
    let cable = |_| Cable {
        frame_anchor: home + flat(8.0 * random_direction(rng)),
        platform_anchor: flat(platform * random_direction(rng)),
        ..pattern.cables[0].clone()
    };
    let cables = (0..cable_count).map(cable).collect();
    Robot { name: format!("made up with {cable_count} cables"), cables, travel: None, ..pattern.clone() }
}

/// A random pose, limits and a load that tensions within or beyond the limits balance.
fn random_problem(model: &Model, rng: &mut ChaCha8Rng) -> Problem {
    let home: Pose = model.robot().home.expect("has a home pose");
    let matrix = loop {
        let pose = within_pattern(model, &home, &random_pose(model.robot(), 0.2, rng));
        if let Ok(matrix) = model.structure_matrix(&pose) {
            break matrix;
        }
    };
    let limits = random_limits(model, rng);
    let reach = rng.random_range(0.0..4.0);
    let away = DVector::from_fn(limits.cable_count(), |cable, _| {
        0.5 * reach * rng.random_range(-1.0..1.0) * (limits.maximum()[cable] - limits.minimum()[cable])
    });
    let middle = DVector::from_fn(limits.cable_count(), |cable, _| limits.middle(cable));
    let problem = |part: f64| {
        let wrench = -(&matrix * (&middle + part * &away));
        Problem { matrix: matrix.clone(), wrench: wrench.as_slice().to_vec(), limits: limits.clone() }
    };
    if rng.random_ratio(9, 10) {
        return problem(1.0);
    }
    // one in ten is near the boundary, on either side
    let beyond = 10_f64.powf(rng.random_range(-5.0..-2.0)) * if rng.random() { 1.0 } else { -1.0 };
    problem(edge(&problem) * (1.0 + beyond))
}

/// Where the loads of this ray stop being feasible, to 1e-7.
fn edge(problem: &impl Fn(f64) -> Problem) -> f64 {
    let is_feasible = |part| {
        let Problem { matrix, wrench, limits } = problem(part);
        quadratic::solve(&matrix, &wrench, &limits, None).expect("fits").status == Status::Feasible
    };
    let (mut inside, mut outside) = (0.0, 10.0);
    while outside - inside > 1e-7 * outside {
        let middle = 0.5 * (inside + outside);
        *(if is_feasible(middle) { &mut inside } else { &mut outside }) = middle;
    }
    inside
}

/// The file's limits where it has some, or other ones for each cable.
fn random_limits(model: &Model, rng: &mut ChaCha8Rng) -> Limits {
    if let (true, Ok(limits)) = (rng.random(), Limits::of(model.robot(), None, None)) {
        return limits;
    }
    let size = 10_f64.powf(rng.random_range(1.0..5.0));
    let largest: Vec<f64> = (0..model.cable_count()).map(|_| size * rng.random_range(0.3..1.0)).collect();
    let least = largest.iter().map(|largest| largest * rng.random_range(0.0..0.5)).collect();
    Limits::new(least, largest).expect("in order")
}

/// What came of the problems of one redundancy.
#[derive(Debug, Default)]
struct Tally {
    feasible: usize,
    infeasible: usize,
    boundary: usize,
    unclear: usize,
    wrong: Vec<String>,
    /// Largest difference of the optimum, as a part of it.
    cost: f64,
    /// Largest difference of a tension, as a part of the largest limit.
    tension: f64,
}

impl Tally {
    fn compare(&mut self, model: &Model, problem: &Problem) {
        let Problem { matrix, wrench, limits } = problem;
        let ours = quadratic::solve(matrix, wrench, limits, None).expect("fits");
        match ours.certificate() {
            None => self.feasible += 1,
            Some(proof) => {
                self.infeasible += 1;
                assert!(proof.proves(matrix, wrench, limits), "{problem:?} {ours:?}");
            }
        }
        match (ours.status, problem.conic().solve()) {
            (Status::Feasible, Opinion::Optimum(theirs)) => {
                let [our_cost, their_cost] = [&ours.tensions, &theirs].map(|tensions| problem.cost(tensions));
                // of a smaller optimum clarabel's absolute tolerance of 1e-8 would be more than 1e-5
                self.cost = self.cost.max((our_cost - their_cost).abs() / their_cost.max(1e-3));
                let apart = ours.tensions.iter().zip(&theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                self.tension = self.tension.max(apart / problem.largest_limit());
            }
            (Status::Infeasible, Opinion::Infeasible) => {}
            (_, opinion) => {
                let margin = problem.margin();
                self.unclear += usize::from(opinion == Opinion::Unclear);
                self.boundary += usize::from(margin.abs() < BOUNDARY);
                let right = if margin > 0.0 { Status::Feasible } else { Status::Infeasible };
                if margin.abs() >= BOUNDARY && ours.status != right || ours.status == Status::Undecided {
                    self.wrong.push(format!("{}, margin {margin:e}: {problem:?} {ours:?}", model.robot().name));
                }
            }
        }
    }

    fn add(&mut self, other: Self) {
        self.feasible += other.feasible;
        self.infeasible += other.infeasible;
        self.boundary += other.boundary;
        self.unclear += other.unclear;
        self.wrong.extend(other.wrong);
        self.cost = self.cost.max(other.cost);
        self.tension = self.tension.max(other.tension);
    }
}

/// Every `step`-th problem from the `first` on, by redundancy.
fn tallies(models: &[Model], first: usize, step: usize) -> [Tally; 7] {
    let mut tallies: [Tally; 7] = Default::default();
    for case in (first..PROBLEMS).step_by(step) {
        let model = &models[case % models.len()];
        let mut rng = ChaCha8Rng::seed_from_u64(case as u64);
        tallies[model.cable_count() - model.dof()].compare(model, &random_problem(model, &mut rng));
    }
    tallies
}

#[test]
fn verdicts_and_optima_are_those_of_an_interior_point_solver() {
    let models = models();
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut sums: [Tally; 7] = Default::default();
    std::thread::scope(|scope| {
        let spawn = |first| {
            scope.spawn({
                let models = &models;
                move || tallies(models, first, threads)
            })
        };
        for part in (0..threads).map(spawn).collect::<Vec<_>>() {
            sums.iter_mut().zip(part.join().expect("compares")).for_each(|(sum, part)| sum.add(part));
        }
    });
    let mut total = 0;
    for tally in &sums {
        total += tally.feasible + tally.infeasible;
        assert!(tally.wrong.is_empty(), "{} wrong, first {}", tally.wrong.len(), tally.wrong[0]);
        assert!(tally.feasible > 1000 && tally.infeasible > 1000, "a one-sided test: {tally:?}");
        assert!(tally.boundary < 10 && tally.unclear < 100, "an evasive test: {tally:?}");
        assert!(tally.cost < 1e-6, "{tally:?}");
        // the square root of clarabel's 1e-8, as the optimum is flat
        assert!(tally.tension < 1e-4, "{tally:?}");
    }
    assert_eq!(total, PROBLEMS);
}
