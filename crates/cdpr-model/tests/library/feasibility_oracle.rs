//! Wrench feasibility in batches against clarabel: random poses of nine robots.
//!
//! How near a pose is to the boundary is measured by a linear programme, as a part of the largest limit
//! ([`Problem::margin`]). Nearer than 1e-6 either verdict counts as right.

use super::distribution::{Opinion, Problem};
use super::support::{builtin, random_pose, within_pattern};
use cdpr_model::equilibrium::feasibility::feasible;
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::model::{Composition, Model};
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_testing::property;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Robots with redundancy 0, 1 and 2, and a load that their limits bear in a part of their travel (N, N·m).
const ROBOTS: [(&str, [f64; 3]); 9] = [
    ("cablerobot-simulator-helicopter", [1000.0, 9000.0, -7500.0]),
    ("cablerobot-simulator-icosahedron", [1000.0, 14_000.0, -5000.0]),
    ("ipanema-1", [50.0, 700.0, -300.0]),
    ("cogiro", [0.0, 5000.0, -3000.0]),
    ("macarm", [20.0, 500.0, -200.0]),
    ("spatial-7-cable", [20.0, 600.0, -300.0]),
    ("caroca", [100.0, 5000.0, -2000.0]),
    ("kntu-planar", [5.0, 100.0, -30.0]),
    ("planar-example", [100.0, 1000.0, -300.0]),
];
/// Poses of the usual run; `cargo xtask soak` draws four times as many in a round.
const POSES: usize = 25_000;
const BOUNDARY: f64 = 1e-6;

/// Feasible and infeasible poses, those at the boundary, and what was wrong.
#[derive(Debug, Default)]
struct Tally {
    feasible: usize,
    infeasible: usize,
    boundary: usize,
    wrong: Vec<String>,
}

fn compare(name: &str, [least, largest, weight]: [f64; 3], seed: u64) -> Tally {
    let model = Model::new(builtin(name), Composition::STANDARD).expect("a model");
    let home = model.robot().home_or_middle();
    let limits = Limits::uniform(model.cable_count(), least, largest).expect("in order");
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let mut tally = Tally::default();
    for tenth in 0..10 {
        // from loads that nearly every pose bears to such as hardly any does, so that boundaries lie everywhere
        let size = 0.2 * 1.5_f64.powi(tenth) * weight;
        let mut part = || size * rng.random_range(-0.5..0.5);
        let down = if model.robot().motion_pattern.is_planar() { size } else { 0.0 };
        let wrench = Wrench::new(part(), part() + down, size, 0.2 * part(), 0.2 * part(), 0.2 * part());
        let load = Load::constant(wrench);
        let pose = |_| within_pattern(&model, &home, &random_pose(model.robot(), 0.3, &mut rng));
        let poses: Vec<Pose> = (0..property::sample(POSES) / ROBOTS.len() / 10 + 1).map(pose).collect();
        let mut answers = vec![false; poses.len()];
        feasible(&model, &load, &limits, &poses, &mut answers).expect("fits");
        for (pose, answer) in poses.iter().zip(answers) {
            let Ok(matrix) = model.structure_matrix(pose) else {
                assert!(!answer, "a pose without courses");
                continue;
            };
            let wrench = load.in_pattern(&model, pose).as_slice().to_vec();
            *(if answer { &mut tally.feasible } else { &mut tally.infeasible }) += 1;
            let problem = Problem { matrix, wrench, limits: limits.clone() };
            match problem.conic().solve() {
                Opinion::Optimum(_) if answer => {}
                Opinion::Infeasible if !answer => {}
                _ => {
                    let margin = problem.margin();
                    tally.boundary += usize::from(margin.abs() < BOUNDARY);
                    if margin.abs() >= BOUNDARY && answer != (margin > 0.0) {
                        tally.wrong.push(format!("{name}, margin {margin:e}: {pose:?}"));
                    }
                }
            }
        }
    }
    tally
}

#[test]
fn batches_decide_as_an_interior_point_solver_does() {
    let tallies: Vec<Tally> = std::thread::scope(|scope| {
        let spawn = |(seed, &(name, numbers)): (usize, &(&'static str, [f64; 3]))| {
            scope.spawn(move || compare(name, numbers, property::first_seed() + seed as u64))
        };
        let running: Vec<_> = ROBOTS.iter().enumerate().map(spawn).collect();
        running.into_iter().map(|one| one.join().expect("compares")).collect()
    });
    let mut sums = [0; 3];
    for (tally, (name, _)) in tallies.iter().zip(ROBOTS) {
        assert!(tally.wrong.is_empty(), "{} wrong, first {}", tally.wrong.len(), tally.wrong[0]);
        assert!(tally.feasible > 2 && tally.infeasible > 20, "{name}: a one-sided test: {tallies:?}");
        sums = [sums[0] + tally.feasible, sums[1] + tally.infeasible, sums[2] + tally.boundary];
    }
    assert!(sums[0] > 2500 && sums[1] > 2500 && sums[2] < 20, "{sums:?}");
}
