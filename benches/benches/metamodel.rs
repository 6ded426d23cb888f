//! The meta-model over regions, on one core with `RAYON_NUM_THREADS=1`: `cargo bench -p benches --bench metamodel`.
//!
//! The same work as in `benches/peers/metamodel.py`, which prints the same rows for SciPy: an accuracy map of the planar example
//! with 100 × 100 commanded positions, the hull of the reachable workspace of the CableRobot Simulator's twin with 642 rays, and the
//! planar map once more in two shards. `--bench tolerance` has the Monte-Carlo study.

#![expect(clippy::print_stdout, reason = "times are the answer")]

use std::hint::black_box;
use std::time::Instant;

use cdpr::control::Initial;
use cdpr::control::{Driving, winch_offsets};
use cdpr::geometry::Pose;
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::UnitQuaternion;
use cdpr::robot::Robot;
use cdpr::study::field;
use cdpr::study::reachable::{Reachable, Requirements};
use cdpr::tension::Limits;
use cdpr::workspace::{Archetype, Bounds, Region, hull};

/// Median of so many runs (s).
fn median(runs: usize, mut work: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..runs)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[runs / 2]
}

fn row(problem: &str, seconds: f64, count: usize, value: f64) {
    println!(
        "{{\"lib\": \"cdpr\", \"problem\": \"{problem}\", \"seconds\": {seconds:.5}, \"count\": {count}, \"value\": {value:.6}}}"
    );
}

fn models(control: &str, machine: &str) -> (Model, Model) {
    let robot = |name: &str| Robot::builtin(name).expect("built in");
    let control = Model::new(robot(control), Composition::STANDARD).expect("a model");
    (control, Model::new(robot(machine), Composition::ELASTIC).expect("a model"))
}

fn planar_map() {
    let (control, machine) = models("planar-example", "planar-example");
    let initial: Initial =
        toml::from_str("pose = [0, 5.2]\ntension_method = \"closed-form\"").expect("keys of a study");
    let robot = control.robot();
    let at = |x: f64, y: f64| robot.motion_pattern.pose(robot.plane, &[x, y]).expect("two numbers");
    let pose = at(0.0, 5.2);
    let offsets = winch_offsets(&initial, &control, &machine, &pose).expect("offsets");
    let part = |k: usize| k as f64 / 99.0;
    let poses: Vec<Pose> =
        (0..10_000).map(|index| at(-4.0 + 8.0 * part(index % 100), 0.5 + 5.5 * part(index / 100))).collect();
    let mean = |poses: &[Pose]| {
        let driving = Driving::new(&control, &machine, &offsets).expect("one robot");
        let outcomes = driving.outcomes(poses);
        let errors = poses.iter().zip(&outcomes).map(|(pose, outcome)| (outcome.pose.position - pose.position).norm());
        errors.sum::<f64>() / poses.len() as f64
    };
    let seconds = median(11, || {
        black_box(mean(black_box(&poses)));
    });
    row("planar accuracy map 100 x 100, exact (goal 0.040)", seconds, poses.len(), 1e3 * mean(&poses));
    let half = median(11, || {
        black_box(mean(black_box(&poses[..5000])));
    });
    row("one shard of two of the same", half, 5000, half / seconds);
    let driving = Driving::new(&control, &machine, &offsets).expect("one robot");
    let both = median(11, || {
        black_box(field::field(&driving, black_box(&poses)));
    });
    let missed = field::field(&driving, &poses).summary.linear_residual_m.mean;
    row("the same, exact and linear", both, poses.len(), 1e3 * missed);
}

fn twin_hull() {
    let names = ["cablerobot-simulator-helicopter", "cablerobot-simulator-helicopter-elastostatic-calibrated"];
    let (control, machine) = models(names[0], names[1]);
    let upright = Archetype::ConstantOrientation(UnitQuaternion::identity());
    let bounds = Bounds::around(&machine).expect("a box");
    let settings = hull::Settings { rays: 642, ..hull::Settings::new(&bounds) };
    let find = || {
        let requirements = Requirements {
            tensions: Some(Limits::of(machine.robot(), None, None).expect("limits")),
            position_error_max: None,
            rotation_error_max: None,
            tension_error_max: None,
        };
        let driving = Driving::new(&control, &machine, &[0.0; 8]).expect("one robot");
        let reachable = Reachable::new(driving, requirements).expect("requirements");
        let region = Region::new(&machine, &reachable, &upright).expect("a region");
        hull::solve(&region, &bounds, &[0.0, 0.0, 1.5], &settings).expect("a centre within")
    };
    let seconds = median(11, || {
        let _ = black_box(find());
    });
    let found = find();
    let size = found.measure().map_or(f64::NAN, |measure| measure.size);
    row("reachable hull of the twin, 642 rays (goal 0.1)", seconds, found.points as usize, size);
}

fn main() {
    planar_map();
    twin_hull();
}
