//! The elastostatic forward problem: every equilibrium is found again, and nothing that is none is called one.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "tests fail by panic and show their figures"
)]

mod support;

use cdpr::equilibrium::elastostatics::{Settings, Solution, Solver, Status};
use cdpr::geometry::Pose;
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::DVector;
use cdpr::robot::{Cable, Robot};
use cdpr::statics::Load;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use support::{builtin, displaced, random_pose, with_pulleys};

const POSES: usize = 10_000;

/// Tensions that balance the load, near the middle of the limits (eq. 3.41); nothing where they leave the limits.
fn tensions(model: &Model, load: &Load, pose: &Pose, limits: [f64; 2]) -> Option<Vec<f64>> {
    let structure_matrix = model.structure_matrix(pose).ok()?;
    let wrench = load.in_pattern(model, pose);
    let middle = DVector::repeat(model.cable_count(), 0.5 * (limits[0] + limits[1]));
    let short = structure_matrix.clone().svd(true, true).solve(&(wrench + &structure_matrix * &middle), 1e-9).ok()?;
    let tensions = middle - short;
    tensions.iter().all(|f| (limits[0]..limits[1]).contains(f)).then(|| tensions.as_slice().to_vec())
}

fn size(robot: &Robot) -> f64 {
    let anchors = || robot.cables.iter().map(|cable| cable.frame_anchor);
    let first = robot.cables[0].frame_anchor;
    (anchors().fold(first, |a, b| a.sup(&b)) - anchors().fold(first, |a, b| a.inf(&b))).norm()
}

fn distance(a: &Pose, b: &Pose, radius: f64) -> f64 {
    (a.position - b.position).norm().hypot(radius * a.angle_to(b))
}

/// How the searches ended.
#[derive(Debug, Default)]
struct Tally {
    found: usize,
    other_stable: usize,
    start_unstable: usize,
    not_converged: usize,
    worst_pose: f64,
    worst_tension: f64,
    worst_balance: f64,
    most_iterations: u32,
    iterations: u32,
    restarts: u32,
    first_reason: Option<String>,
}

fn tally(robot: &Robot, composition: Composition, limits: [f64; 2]) -> Tally {
    let model = Model::new(robot.clone(), composition).unwrap();
    let load = Load::of(robot).unwrap();
    let scale = size(robot) / size(&support::simulator());
    let mut rng = ChaCha8Rng::seed_from_u64(2021);
    let mut solver = Solver::new(&model, &load, &Settings::default()).unwrap();
    let mut tally = Tally::default();
    for _ in 0..POSES {
        let (pose, expected) = loop {
            let pose = random_pose(robot, 10_f64.to_radians(), &mut rng);
            if let Some(tensions) = tensions(&model, &load, &pose, limits) {
                break (pose, tensions);
            }
        };
        let lengths: Vec<f64> = (0..model.cable_count())
            .map(|cable| {
                let (course, _) = model.course(cable, &pose).unwrap();
                model.elasticity(cable).controlled_length(course.length, expected[cable])
            })
            .collect();
        let guess = displaced(&pose, 0.1 * scale, 3_f64.to_radians(), &mut rng);
        let solution = solver.solve(&lengths, &guess).unwrap();
        tally.add(solution, &pose, &expected, model.platform_radius());
    }
    tally
}

impl Tally {
    fn add(&mut self, solution: &Solution, pose: &Pose, expected: &[f64], radius: f64) {
        let error = distance(&solution.pose, pose, radius);
        let tension_error = solution
            .tensions
            .iter()
            .zip(expected)
            .map(|(found, expected)| (found - expected).abs())
            .fold(0.0, f64::max);
        self.iterations += solution.iterations;
        self.restarts += solution.restarts;
        self.most_iterations = self.most_iterations.max(solution.iterations);
        match solution.status {
            Status::Converged if error < 1e-9 && tension_error < 1e-4 => {
                self.found += 1;
                self.worst_pose = self.worst_pose.max(error);
                self.worst_tension = self.worst_tension.max(tension_error);
                self.worst_balance = self.worst_balance.max(solution.wrench_residual);
            }
            Status::Converged if solution.stability > 0.0 && error > 1e-3 => self.other_stable += 1,
            Status::Unstable if error < 1e-9 => self.start_unstable += 1,
            _ => {
                self.not_converged += 1;
                self.first_reason.get_or_insert(format!("{error:e} {tension_error:e} {solution:?}"));
            }
        }
    }
}

fn stretchable(robot: &Robot, stiffness: f64) -> Robot {
    let mut robot = robot.clone();
    for cable in &mut robot.cables {
        *cable = Cable { axial_stiffness: cable.axial_stiffness.or(Some(stiffness)), ..cable.clone() };
    }
    robot
}

#[test]
fn elastic_robots_find_every_pose_again() {
    for (name, limits, stiffness) in [
        ("cablerobot-simulator-helicopter-elastostatic-calibrated", [500.0, 10_000.0], 4e5),
        ("cogiro", [10.0, 5000.0], 5e5),
    ] {
        let robot = stretchable(&builtin(name), stiffness);
        let placed = with_pulleys(&robot, 0.01 * size(&robot));
        for (robot, composition) in [(&robot, Composition::ELASTIC), (&placed, Composition::PULLEY_ELASTIC)] {
            let start = std::time::Instant::now();
            let tally = tally(robot, composition, limits);
            println!("{name} {composition}: {tally:?} {:?}", start.elapsed());
            assert_eq!(tally.not_converged, 0, "{name} {composition}: {tally:?}");
        }
    }
}
