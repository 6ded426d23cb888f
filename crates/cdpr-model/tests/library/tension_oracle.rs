//! The exact quadratic programme against clarabel: 100 000 problems, verdicts and optima.
//!
//! How near a problem is to the boundary of what is feasible is measured by a linear programme: by how much of the largest
//! limit all limits could be narrower, or would have to be wider ([`Problem::margin`]). Nearer than 1e-6 either verdict counts as right.

use super::distribution::{Opinion, Problem};
use super::problems::{models, random_problem};
use cdpr_model::model::Model;
use cdpr_model::tension::quadratic::{self, Status};
use cdpr_testing::property;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// Problems of the usual run; `cargo xtask soak` draws four times as many in a round.
const PROBLEMS: usize = 25_000;
/// Part of the largest limit within which a problem is on the boundary.
const BOUNDARY: f64 = 1e-6;
/// Part of an optimum to which clarabel's usual tolerances are trusted; of a difference beyond it clarabel is asked again, to 1e-12.
const DOUBT: f64 = 1e-6;

/// What came of the problems of one redundancy.
#[derive(Debug, Default)]
struct Tally {
    feasible: usize,
    infeasible: usize,
    boundary: usize,
    unclear: usize,
    /// Optima of which clarabel was asked again.
    doubted: usize,
    wrong: Vec<String>,
    /// Largest difference of the optimum, as a part of it.
    cost: f64,
    /// Largest difference of a tension, as a part of the largest limit.
    tension: f64,
}

/// How far two answers to a problem are from each other.
struct Apart {
    /// As a part of the optimum; of one below 1e-3 clarabel's absolute tolerance of 1e-8 would be more than 1e-5 of it.
    cost: f64,
    /// Of the tension that differs most, as a part of the largest limit.
    tension: f64,
}

impl Apart {
    fn of(problem: &Problem, ours: &[f64], theirs: &[f64]) -> Self {
        let [our_cost, their_cost] = [ours, theirs].map(|tensions| problem.cost(tensions));
        let tension = ours.iter().zip(theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        Self { cost: (our_cost - their_cost).abs() / their_cost.max(1e-3), tension: tension / problem.largest_limit() }
    }
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
                let apart = Apart::of(problem, &ours.tensions, &theirs);
                if apart.cost < DOUBT {
                    return self.note(&apart);
                }
                self.doubted += 1;
                match problem.conic().solve_sharply() {
                    Opinion::Optimum(sharper) => self.note(&Apart::of(problem, &ours.tensions, &sharper)),
                    _ => self.unclear += 1,
                }
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

    fn note(&mut self, apart: &Apart) {
        self.cost = self.cost.max(apart.cost);
        self.tension = self.tension.max(apart.tension);
    }

    fn add(&mut self, other: Self) {
        self.feasible += other.feasible;
        self.infeasible += other.infeasible;
        self.boundary += other.boundary;
        self.unclear += other.unclear;
        self.doubted += other.doubted;
        self.wrong.extend(other.wrong);
        self.cost = self.cost.max(other.cost);
        self.tension = self.tension.max(other.tension);
    }
}

/// Every `step`-th problem from the `first` on, by redundancy.
fn tallies(models: &[Model], first: usize, step: usize) -> [Tally; 7] {
    let mut tallies: [Tally; 7] = Default::default();
    for case in (first..property::sample(PROBLEMS)).step_by(step) {
        let model = &models[case % models.len()];
        let mut rng = ChaCha8Rng::seed_from_u64(property::first_seed() + case as u64);
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
        assert!(tally.feasible > 250 && tally.infeasible > 250, "a one-sided test: {tally:?}");
        assert!(tally.boundary < 10 && tally.unclear < 100 && tally.doubted < 100, "an evasive test: {tally:?}");
        // clarabel keeps limits and balance to 1e-8, which steep multipliers make up to 1.3e-5 of the optimum in 1e6 problems of the soak
        assert!(tally.cost < DOUBT, "{tally:?}");
        // the square root of clarabel's 1e-8, as the optimum is flat
        assert!(tally.tension < 1e-4, "{tally:?}");
    }
    assert_eq!(total, property::sample(PROBLEMS));
}
