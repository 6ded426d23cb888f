//! Underactuated robots: fewer cables than degrees of freedom, held by their weight.

#![allow(
    clippy::unwrap_used,
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "tests fail by panic and show their figures"
)]

use std::collections::BTreeMap;
use std::path::PathBuf;

use cdpr::equilibrium::elastostatics::{Settings, Solution, Solver, Status};
use cdpr::model::{Composition, Model};
use cdpr::nalgebra::DMatrix;
use cdpr::robot::{Cable, Robot};
use cdpr::statics::{Load, geometric_stiffness, wrench_residual};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

const LENGTH_SETS: usize = 1_000;

/// `None` with a word where the file is absent, a failure where it must be there.
fn robot(name: &str) -> Option<Robot> {
    let path =
        PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/robots").join(format!("{name}.toml"));
    let Ok(text) = std::fs::read(&path) else {
        assert!(std::env::var("CI").as_deref() != Ok("true"), "CI must have {}", path.display());
        eprintln!("skipped: {} is not here (its licence forbids a copy in the repository)", path.display());
        return None;
    };
    Some(Robot::from_toml_bytes(&text, name).unwrap())
}

/// Smallest eigenvalue of −K_G − ∂w/∂x on the twists that leave the lengths of taut cables as they are, from the public
/// matrices (N/m; rotations times the platform radius).
fn stiffness_beside_cables(model: &Model, load: &Load, solution: &Solution) -> f64 {
    let radius = model.platform_radius();
    let scale = DMatrix::from_fn(6, 6, |i, j| if i != j { 0.0 } else { [1.0, 1.0 / radius][i / 3] });
    let geometric = geometric_stiffness(model, &solution.pose, &solution.tensions).unwrap();
    let gradient = load.gradient(&solution.pose);
    let stiffness = &scale * DMatrix::from_fn(6, 6, |i, j| -geometric[(i, j)] - gradient[(i, j)]) * &scale;
    let taut: Vec<usize> = (0..model.cable_count()).filter(|&cable| solution.tensions[cable] > 0.0).collect();
    let columns = &scale * model.structure_matrix(&solution.pose).unwrap().select_columns(&taut);
    // I − A A⁺ᵀ projects on the kernel; what it takes away counts as stiff
    let projector = DMatrix::identity(6, 6) - &columns * columns.clone().pseudo_inverse(1e-10).unwrap();
    let stiff = (DMatrix::identity(6, 6) - &projector) * 1e9;
    let projected = &projector * (&stiffness + stiffness.transpose()) * 0.5 * &projector + stiff;
    projected.symmetric_eigenvalues().min()
}

fn assert_equilibrium(model: &Model, load: &Load, lengths: &[f64], solution: &Solution) {
    assert!(solution.wrench_residual <= 1e-6, "{solution:?}");
    let residual = wrench_residual(model, &solution.pose, &solution.tensions, load).unwrap();
    assert!(residual.amax() < 1e-6, "{residual}");
    for cable in 0..model.cable_count() {
        let excess = model.course(cable, &solution.pose).unwrap().0.length - lengths[cable];
        let tension = solution.tensions[cable];
        assert!(tension >= 0.0 && excess <= 1e-9, "cable {cable}: {tension} N, {excess} m too long");
        assert!(tension == 0.0 || excess.abs() <= 1e-9, "cable {cable}: {tension} N though {excess} m too short");
    }
    let stiffness = stiffness_beside_cables(model, load, solution);
    assert!(stiffness > 0.0, "{stiffness} {solution:?}");
    assert!((stiffness / solution.stability - 1.0).abs() < 1e-4, "{stiffness} {}", solution.stability);
}

#[test]
fn rigid_cables_reach_a_stable_equilibrium_or_say_why_not() {
    for name in ["grab-prototype-33", "irma4u-lab3", "irma4u-mar25"] {
        let Some(robot) = robot(name) else { return };
        let load = Load::of(&robot).unwrap();
        let home = robot.home_or_middle();
        for composition in [Composition::STANDARD, Composition::PULLEY] {
            let model = Model::new(robot.clone(), composition).unwrap();
            let at_home = model.cable_lengths(&home).unwrap();
            let mut solver = Solver::new(&model, &load, &Settings::default()).unwrap();
            let mut rng = ChaCha8Rng::seed_from_u64(33);
            let mut counts = BTreeMap::new();
            let (mut slack, mut iterations, mut restarts) = ([0; 5], 0, 0);
            let start = std::time::Instant::now();
            for _ in 0..LENGTH_SETS {
                let lengths: Vec<f64> = at_home.iter().map(|length| length * rng.random_range(0.7..1.3)).collect();
                let solution = solver.solve(&lengths, &home).unwrap();
                iterations += solution.iterations;
                restarts += solution.restarts;
                match solution.status {
                    Status::Converged => {
                        assert_equilibrium(&model, &load, &lengths, solution);
                        slack[solution.slack] += 1;
                        *counts.entry("stable".to_owned()).or_insert(0) += 1;
                    }
                    status => {
                        let reason = solution.reason.clone().unwrap();
                        let words: String = reason.chars().filter(|letter| !letter.is_ascii_digit()).take(60).collect();
                        println!("{name} {composition}: {reason}");
                        *counts.entry(format!("{status:?}: {words}")).or_insert(0) += 1;
                    }
                }
            }
            println!(
                "{name} {composition}: {counts:?}, by slack cables {slack:?}, {iterations} iterations, {restarts} restarts, {:?}",
                start.elapsed()
            );
            assert!(counts["stable"] >= LENGTH_SETS * 95 / 100, "{counts:?}");
        }
    }
}

/// The stiffer the cables, the nearer to rigid ones: by their compliance.
#[test]
fn elastic_cables_tend_to_rigid_ones() {
    let Some(robot) = robot("irma4u-lab3") else { return };
    let load = Load::of(&robot).unwrap();
    let home = robot.home_or_middle();
    let rigid = Model::new(robot.clone(), Composition::PULLEY).unwrap();
    let lengths: Vec<f64> =
        rigid.cable_lengths(&home).unwrap().iter().zip([1.0, 1.05, 0.97, 1.02]).map(|(q, s)| q * s).collect();
    let settings = Settings::default();
    let expected = Solver::new(&rigid, &load, &settings).unwrap().solve(&lengths, &home).unwrap().clone();
    assert_eq!(expected.status, Status::Converged);
    let mut errors = Vec::new();
    for stiffness in [1e4, 1e5, 1e6, 1e7] {
        let mut robot = robot.clone();
        for cable in &mut robot.cables {
            *cable = Cable { axial_stiffness: Some(stiffness), ..cable.clone() };
        }
        let elastic = Model::new(robot, Composition::PULLEY_ELASTIC).unwrap();
        let found = Solver::new(&elastic, &load, &settings).unwrap().solve(&lengths, &home).unwrap().clone();
        assert_eq!(found.status, Status::Converged, "{:?}", found.reason);
        errors.push((found.pose.position - expected.pose.position).norm());
    }
    assert!(errors[3] < 1e-4 && errors.windows(2).all(|pair| pair[1] < 0.2 * pair[0]), "{errors:?}");
}
