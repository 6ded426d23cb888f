//! Underactuated robots: fewer cables than degrees of freedom, held by their weight.

use std::collections::BTreeMap;
use std::path::PathBuf;

use cdpr_model::equilibrium::elastostatics::{Settings, Solution, Solver, Status};
use cdpr_model::geometry::Twist;
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::{CableStiffness, Robot};
use cdpr_model::statics::{Load, geometric_stiffness, wrench_residual};
use nalgebra::DMatrix;
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
        let excess = model.path(cable, &solution.pose).unwrap().0.length - lengths[cable];
        let tension = solution.tensions[cable];
        assert!(tension >= 0.0 && excess <= 1e-9, "cable {cable}: {tension} N, {excess} m too long");
        assert!(tension == 0.0 || excess.abs() <= 1e-9, "cable {cable}: {tension} N though {excess} m too short");
    }
    let stiffness = stiffness_beside_cables(model, load, solution);
    assert!(stiffness > 0.0, "{stiffness} {solution:?}");
    assert!((stiffness / solution.stability - 1.0).abs() < 1e-4, "{stiffness} {}", solution.stability);
}

/// How the searches ended, by status and the beginning of the reason.
fn tally(model: &Model, length_sets: &[Vec<f64>]) -> BTreeMap<String, usize> {
    let load = Load::of(model.robot()).unwrap();
    let home = model.robot().home_or_middle();
    let mut solver = Solver::new(model, &load, &Settings::default()).unwrap();
    let (mut counts, mut slack, mut iterations, mut restarts) = (BTreeMap::new(), [0; 5], 0, 0);
    let start = std::time::Instant::now();
    for lengths in length_sets {
        let solution = solver.solve(lengths, &home).unwrap();
        iterations += solution.iterations;
        restarts += solution.restarts;
        let end = match solution.status {
            Status::Converged => {
                assert_equilibrium(model, &load, lengths, solution);
                slack[solution.slack] += 1;
                "stable".to_owned()
            }
            status => {
                let reason = solution.reason.as_ref().unwrap();
                format!("{status:?}: {}", reason.chars().take(55).collect::<String>())
            }
        };
        *counts.entry(end).or_insert(0) += 1;
    }
    println!(
        "{} {}: {counts:?}, by slack cables {slack:?}, {iterations} iterations, {restarts} restarts, {:?}",
        model.robot().name,
        model.composition(),
        start.elapsed()
    );
    counts
}

fn models() -> Option<Vec<Model>> {
    let mut models = Vec::new();
    for name in ["grab-prototype-33", "irma4u-lab3", "irma4u-mar25"] {
        let robot = robot(name)?;
        for composition in [Composition::STANDARD, Composition::PULLEY] {
            models.push(Model::new(robot.clone(), composition).unwrap());
        }
    }
    Some(models)
}

/// Lengths of a random pose can be obeyed, though the platform will hang elsewhere.
#[test]
fn lengths_that_some_pose_has_always_lead_to_a_stable_equilibrium() {
    let Some(models) = models() else { return };
    for model in models {
        let home = model.robot().home_or_middle();
        let mut rng = ChaCha8Rng::seed_from_u64(33);
        let mut within = |size: f64| rng.random_range(-size..size);
        let length_sets: Vec<Vec<f64>> = (0..LENGTH_SETS)
            .map(|_| {
                let twist = [0.4, 0.4, 0.3, 0.5, 0.5, 0.5].map(&mut within);
                model.cable_lengths(&home.displaced(&Twist::from(twist))).unwrap()
            })
            .collect();
        let counts = tally(&model, &length_sets);
        assert_eq!(counts.get("stable"), Some(&LENGTH_SETS), "{counts:?}");
    }
}

/// Lengths drawn without a pose may be too short to meet at the platform; nothing else goes wrong.
#[test]
fn lengths_drawn_at_random_lead_to_a_stable_equilibrium_or_are_too_short() {
    let Some(models) = models() else { return };
    for model in models {
        let home = model.cable_lengths(&model.robot().home_or_middle()).unwrap();
        let mut rng = ChaCha8Rng::seed_from_u64(34);
        let mut around = |length: &f64| length * rng.random_range(0.7..1.3);
        let length_sets: Vec<Vec<f64>> = (0..LENGTH_SETS).map(|_| home.iter().map(&mut around).collect()).collect();
        for (end, count) in tally(&model, &length_sets) {
            assert!(end == "stable" || end.contains("too short to meet"), "{count} × {end}");
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
            cable.stiffness = Some(CableStiffness::Axial(stiffness));
        }
        let elastic = Model::new(robot, Composition::PULLEY_ELASTIC).unwrap();
        let found = Solver::new(&elastic, &load, &settings).unwrap().solve(&lengths, &home).unwrap().clone();
        assert_eq!(found.status, Status::Converged, "{:?}", found.reason);
        errors.push((found.pose.position - expected.pose.position).norm());
    }
    assert!(errors[3] < 1e-4 && errors.windows(2).all(|pair| pair[1] < 0.2 * pair[0]), "{errors:?}");
}
