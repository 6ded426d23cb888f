//! A Monte-Carlo tolerance study, 10 000 robots at 75 poses: `cargo bench -p benches --bench tolerance`, on one core with
//! `RAYON_NUM_THREADS=1`.
//!
//! The CableRobot Simulator of eq. 6.27–6.30 with elastic cables, all anchors and stiffnesses deviating. `one by one` is the same
//! study as one writes it first: a model and an operation per robot, asked pose by pose; it draws a hundredth of the robots and
//! its time counts a hundredfold.

#![expect(clippy::print_stdout, reason = "times are the answer")]

use std::hint::black_box;
use std::time::Instant;

use cdpr::control::{CommandedPose, Initial};
use cdpr::control::{Operation, Status, winch_offsets};
use cdpr::model::{Composition, Model};
use cdpr::robot::{ParameterKind, Robot};
use cdpr::study::Distribution;
use cdpr::study::Study;
use cdpr::study::sensitivity::{Kind, Offsets, ParameterDeviation, PoseSensitivity, Sensitivity, Setting, Side};
use cdpr::study::tolerance::{Engine, Settings, monte_carlo};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution as _, StandardNormal};

const ROBOTS: usize = 10_000;
const SHARE: usize = 100;

fn sigma(cause: &ParameterDeviation) -> f64 {
    match (cause.side, cause.kind) {
        (Side::Machine, Kind::Parameter(ParameterKind::FrameAnchor | ParameterKind::PlatformAnchor)) => 1e-3,
        (Side::Machine, Kind::Parameter(ParameterKind::AxialStiffness)) => 0.03,
        _ => 0.0,
    }
}

/// The study as one writes it first: the mean error.
fn one_by_one(
    (control, machine): (&Model, &Model),
    offsets: &[f64],
    causes: &[ParameterDeviation],
    poses: &[CommandedPose],
    robots: usize,
) -> f64 {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let (mut sum, mut count) = (0.0, 0.0);
    for _ in 0..robots {
        let mut robot = machine.robot().clone();
        for cause in causes.iter().filter(|cause| sigma(cause) > 0.0) {
            let unit: f64 = StandardNormal.sample(&mut rng);
            cause.deviate(machine, &mut robot, sigma(cause) * unit);
        }
        let deviating = Model::new(robot, machine.composition()).expect("a model");
        let mut operation = Operation::new(control, &deviating, offsets).expect("the same robot");
        for command in poses {
            let outcome = operation.answer(command);
            if outcome.status == Status::Converged {
                sum += (outcome.pose.position - command.pose.position).norm();
                count += 1.0;
            }
        }
    }
    sum / count
}

fn main() {
    let name = "cablerobot-simulator-helicopter-elastostatic-calibrated";
    let robot = Robot::builtin(name).expect("built in");
    let control = Model::new(robot.clone(), Composition::STANDARD).expect("a model");
    let machine = Model::new(robot.clone(), Composition::ELASTIC).expect("a model");
    let path = format!("{}/../studies/twin-tolerances.toml", env!("CARGO_MANIFEST_DIR"));
    let study = Study::from_toml_bytes(&std::fs::read(&path).expect("a study"), &path).expect("a study");
    let tensions = vec![3678.0, 2169.0, 4250.0, 1708.0, 3985.0, 2394.0, 4715.0, 1684.0];
    let initial = Initial { tensions_N: Some(tensions), tension_method: None, ..study.initial.clone() };
    let pose = study.initial_pose(&robot).expect("a pose");
    let poses = study.commanded_poses(&robot, Vec::new(), 0).expect("poses");
    assert_eq!(poses.len(), 75);
    let offsets = winch_offsets(&initial, &control, &machine, &pose).expect("offsets");
    let setting = Setting { initial: &initial, pose, former: None, offsets: Offsets::Kept };
    let mut sensitivity = Sensitivity::new(&control, &machine, &offsets, &setting).expect("sensitivities");
    let causes = sensitivity.causes().to_vec();

    let start = Instant::now();
    let nominal: Vec<PoseSensitivity> =
        poses.iter().map(|command| sensitivity.at(command).expect("valid input")).collect();
    println!("derivatives by {} parameters at 75 poses: {:.1} ms", causes.len(), 1e3 * start.elapsed().as_secs_f64());

    let sigmas: Vec<f64> = causes.iter().map(sigma).collect();
    let mut seconds = Vec::new();
    for engine in [Engine::Exact, Engine::Linear] {
        let settings = Settings {
            causes: &causes,
            sigmas: &sigmas,
            distribution: Distribution::Normal,
            robots: ROBOTS,
            seed: 1,
            engine,
            history: None,
        };
        let start = Instant::now();
        let drawn = monte_carlo(&control, &machine, &setting, &offsets, &poses, &nominal, &settings);
        let drawn = black_box(drawn.expect("valid input"));
        seconds.push(start.elapsed().as_secs_f64());
        assert_eq!(drawn.unanswered, 0);
        println!("{engine:?}: {:.2} s, mean error {:.3} mm", seconds[seconds.len() - 1], 1e3 * drawn.error.mean);
    }
    let start = Instant::now();
    let mean = black_box(one_by_one((&control, &machine), &offsets, &causes, &poses, ROBOTS / SHARE));
    let single = start.elapsed().as_secs_f64() * SHARE as f64;
    println!("one by one: {single:.2} s, mean error {:.3} mm", 1e3 * mean);
    println!("ratio: exact × {:.1}, linear × {:.0}", single / seconds[0], single / seconds[1]);
}
