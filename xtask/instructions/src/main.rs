//! Work whose instructions are counted, as a guard against regressions: `cargo xtask instructions` runs this program under
//! callgrind and compares with `counts.toml`.
//!
//! A package of its own, so that no dependency of the library's tests is compiled for it; run with `RAYON_NUM_THREADS=1`, because callgrind
//! tells the threads apart. Without callgrind it does the work twice. `--portable`: on the vector unit that every machine of the target has.
#![expect(clippy::print_stdout, reason = "the names in the order of the counts")]

use std::hint::black_box;

use cdpr::equilibrium::{elastostatics, forward_kinematics};
use cdpr::geometry::{Pose, Twist};
use cdpr::identification::Loss;
use cdpr::identification::fit::{Settings, Status, fit};
use cdpr::measurement::Samples;
use cdpr::model::{Composition, FreeParameters, Model, place_pulleys};
use cdpr::nalgebra::{DMatrix, DVector, Vector3};
use cdpr::robot::{Robot, builtin};
use cdpr::scalar::Unit;
use cdpr::statics::{Load, controlled_lengths};
use cdpr::tension::{Limits, closed_form, quadratic};

const POSES: u32 = 64;
const ELASTIC: &str = "cablerobot-simulator-helicopter-elastostatic-calibrated";
const RIGID: &str = "cablerobot-simulator-helicopter";

fn main() {
    if std::env::args().nth(1).as_deref() == Some("--portable") {
        Unit::limit(Unit::Portable);
    }
    let unit = Unit::available().last().expect("every machine has the portable one");
    println!("unit {unit:?}");
    inverse_kinematics();
    forward();
    tensions();
    identification();
    let text = builtin::find(RIGID).expect("built in");
    count("robot file, read", &mut || usize::from(Robot::from_toml(black_box(text), "robot.toml").is_ok()));
}

/// Does the work twice, counted the second time: what the first use of something prepares is not counted.
fn count(name: &str, work: &mut dyn FnMut() -> usize) {
    let first = work();
    assert!(first > 0, "{name} succeeds at nothing");
    println!("count {name}");
    assert_eq!(first, counted(work), "{name} differs the second time");
}

/// Callgrind counts while it is in this function, and knows it by its name.
#[inline(never)]
fn counted(work: &mut dyn FnMut() -> usize) -> usize {
    black_box(work())
}

/// A number in [0, 1) for each step and axis, evenly spread (R. Kronecker's sequence).
fn spread(step: u32, axis: u32) -> f64 {
    (f64::from(step) * f64::from(2 + 3 * axis).sqrt()).fract()
}

fn pose(step: u32) -> Pose {
    let part = |axis| 2.0 * spread(step + 1, axis) - 1.0;
    let position = Vector3::new(1.5 * part(0), 1.5 * part(1), 1.6 + 0.4 * part(2));
    Pose::from_xyz_angles(position, [0.15 * part(4), 0.15 * part(5), 0.15 * part(7)])
}

fn poses() -> Vec<Pose> {
    (0..POSES).map(pose).collect()
}

/// 0.1 m and 3° beside a pose.
fn beside(pose: &Pose) -> Pose {
    let along = Vector3::new(1.0, -1.0, 1.0).normalize();
    let (shift, turn) = (0.1 * along, 3.0_f64.to_radians() * along);
    pose.displaced(&Twist::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z))
}

fn model(robot: &str, composition: Composition) -> Model {
    Model::new(Robot::builtin(robot).expect("built in"), composition).expect("a model")
}

fn with_pulleys() -> Model {
    let robot = Robot::builtin(RIGID).expect("built in");
    let robot = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).expect("placed");
    Model::new(robot, Composition::PULLEY).expect("a model")
}

fn inverse_kinematics() {
    let (standard, pulley, elastic) =
        (model(RIGID, Composition::STANDARD), with_pulleys(), model(ELASTIC, Composition::ELASTIC));
    let poses = poses();
    for (name, model) in [("inverse kinematics, standard", &standard), ("inverse kinematics, pulley", &pulley)] {
        count(name, &mut || poses.iter().filter(|pose| model.cable_lengths(black_box(pose)).is_ok()).count());
    }
    let tensions = [3000.0; 8];
    count("inverse kinematics, elastic", &mut || {
        poses.iter().filter(|pose| controlled_lengths(&elastic, black_box(pose), &tensions).is_ok()).count()
    });
    count("structure matrix", &mut || {
        poses.iter().filter(|pose| standard.structure_matrix(black_box(pose)).is_ok()).count()
    });
}

fn forward() {
    let (standard, elastic) = (model(RIGID, Composition::STANDARD), model(ELASTIC, Composition::ELASTIC));
    let problem = |pose: &Pose| (standard.cable_lengths(pose).expect("lengths"), beside(pose));
    let problems: Vec<_> = poses().iter().map(problem).collect();
    let settings = forward_kinematics::Settings::default();
    let mut solver = forward_kinematics::Solver::new(&standard, &settings).expect("valid settings");
    count("forward kinematics, standard", &mut || {
        let mut converges = |(lengths, guess): &(Vec<f64>, Pose)| {
            solver.solve(black_box(lengths), guess).expect("valid input").status
                == forward_kinematics::Status::Converged
        };
        problems.iter().filter(|problem| converges(problem)).count()
    });
    let load = Load::of(elastic.robot()).expect("a load");
    let settings = elastostatics::Settings::default();
    let mut solver = elastostatics::Solver::new(&elastic, &load, &settings).expect("valid settings");
    count("forward problem, elastic", &mut || {
        let mut converges = |(lengths, guess): &(Vec<f64>, Pose)| {
            let shorter: [f64; 8] = std::array::from_fn(|cable| lengths[cable] - 0.03);
            solver.solve(black_box(&shorter), guess).expect("valid input").status == elastostatics::Status::Converged
        };
        problems.iter().filter(|problem| converges(problem)).count()
    });
}

/// Structure matrices, and wrenches that tensions drawn from this part of the limits' range balance.
fn tension_problems(parts: [f64; 2], limits: &Limits, wanted: quadratic::Status) -> Vec<(DMatrix<f64>, Vec<f64>)> {
    let standard = model(RIGID, Composition::STANDARD);
    let problem = |step: u32| {
        let matrix = standard.structure_matrix(&pose(step)).expect("courses");
        let part = |cable| parts[0] + (parts[1] - parts[0]) * spread(step + 1, 11 + cable as u32);
        let wrench = -(&matrix * DVector::from_fn(8, |cable, _| 1000.0 + 8000.0 * part(cable)));
        (matrix, wrench.as_slice().to_vec())
    };
    let is_wanted = |(matrix, wrench): &(DMatrix<f64>, Vec<f64>)| {
        quadratic::solve(matrix, wrench, limits, None).expect("fits").status == wanted
    };
    (0..).map(problem).filter(is_wanted).take(POSES as usize).collect()
}

fn tensions() {
    let limits = Limits::uniform(8, 1000.0, 9000.0).expect("in order");
    let feasible = tension_problems([0.0, 1.0], &limits, quadratic::Status::Feasible);
    let infeasible = tension_problems([-0.5, 1.5], &limits, quadratic::Status::Infeasible);
    let mut solver = closed_form::Solver::new(8, 6);
    count("tensions, closed form", &mut || {
        let mut solves =
            |(matrix, wrench): &(_, Vec<f64>)| solver.solve(black_box(matrix), wrench, &limits, None).is_ok();
        feasible.iter().filter(|problem| solves(problem)).count()
    });
    let mut solver = quadratic::Solver::new(8, 6);
    for (name, problems) in
        [("tensions, quadratic, feasible", feasible), ("tensions, quadratic, infeasible", infeasible)]
    {
        count(name, &mut || {
            let mut solves = |(matrix, wrench): &(_, Vec<f64>)| {
                solver.forget();
                solver.solve(black_box(matrix), wrench, &limits, None).is_ok()
            };
            problems.iter().filter(|problem| solves(problem)).count()
        });
    }
}

/// 48 parameters from the lengths that anchors up to 5 mm elsewhere give, half a millimetre wrong.
fn identification() {
    let nominal = model(RIGID, Composition::STANDARD);
    let mut robot = nominal.robot().clone();
    for (index, cable) in (0..).zip(&mut robot.cables) {
        cable.frame_anchor += Vector3::from_fn(|axis, _| 0.01 * spread(index + 1, axis as u32) - 0.005);
    }
    let machine = Model::new(robot, Composition::STANDARD).expect("a model");
    let poses = poses();
    let lengths = (0..).zip(&poses).flat_map(|(step, pose)| {
        let lengths = machine.cable_lengths(pose).expect("lengths");
        (0..).zip(lengths).map(move |(cable, length)| length + 1e-3 * spread(step + 1, 20 + cable) - 5e-4)
    });
    let samples = Samples { lengths: lengths.collect(), poses, cable_count: 8, ..Samples::default() };
    let free: FreeParameters = "frame-anchor,platform-anchor".parse().expect("parameters");
    let settings = Settings { loss: Loss::Squared, ..Settings::default() };
    count("identification, kinematic", &mut || {
        let fit = fit(&nominal, black_box(&samples), &free, &settings).expect("enough samples");
        usize::from(fit.status == Status::Converged)
    });
}
