//! Forward statics: the pose that tensions and load leave the platform.

use super::support::{builtin, displaced, random_pose, within_pattern};
use cdpr_model::equilibrium::forward_statics::{Settings, Status, solve};
use cdpr_model::geometry::{Pose, Wrench};
use cdpr_model::model::{Composition, Model};
use cdpr_model::statics::{Load, wrench_residual};
use nalgebra::DVector;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

/// Tensions of at least `least` (N) that balance the load; nothing where the pseudoinverse finds none.
fn tensions(model: &Model, load: &Load, pose: &Pose, least: f64, middle: f64) -> Option<Vec<f64>> {
    let structure_matrix = model.structure_matrix(pose).ok()?;
    let middle = DVector::repeat(model.cable_count(), middle);
    let wrench = load.in_pattern(model, pose) + &structure_matrix * &middle;
    let tensions = &middle - structure_matrix.svd(true, true).solve(&wrench, 1e-9).ok()?;
    tensions.iter().all(|f| *f >= least).then(|| tensions.as_slice().to_vec())
}

#[test]
fn the_pose_whose_tensions_were_given_is_found_again() {
    for (name, middle, composition) in [
        ("cablerobot-simulator-helicopter", 3000.0, Composition::STANDARD),
        ("caroca-pulleys", 300.0, Composition::PULLEY),
        ("cogiro", 500.0, Composition::STANDARD),
        ("planar-example", 3000.0, Composition::STANDARD),
    ] {
        let robot = builtin(name);
        let model = Model::new(robot.clone(), composition).unwrap();
        let load = Load::of(&robot).unwrap_or_else(|_| Load::constant(Wrench::new(0.0, 0.0, -2000.0, 0.0, 0.0, 0.0)));
        let mut rng = ChaCha8Rng::seed_from_u64(21);
        let (mut again, mut other, mut stable) = (0, 0, 0);
        while again + other < 500 {
            let pose = within_pattern(&model, &robot.home_or_middle(), &random_pose(&robot, 0.1, &mut rng));
            let Some(tensions) = tensions(&model, &load, &pose, 1.0, middle) else { continue };
            let guess = within_pattern(&model, &pose, &displaced(&pose, 0.05, 0.02, &mut rng));
            let solution = solve(&model, &tensions, &load, &guess, &Settings::default()).unwrap();
            assert!(matches!(solution.status, Status::Converged | Status::Unstable), "{name}: {solution:?}");
            assert_eq!(solution.reason.is_none(), solution.status == Status::Converged);
            let residual = wrench_residual(&model, &solution.pose, &tensions, &load).unwrap();
            assert!(residual.amax() < 1e-5, "{name}: {residual}");
            stable += usize::from(solution.status == Status::Converged);
            let error = (solution.pose.position - pose.position).norm() + solution.pose.angle_to(&pose);
            // forces are right to 1e-9 of some 1e4 N, the softest direction has some 100 N/m
            if error < 1e-6 { again += 1 } else { other += 1 }
        }
        println!("{name}: {again} found again, {other} other equilibria, {stable} stable");
        assert!(again > 400, "{name}: {again}");
    }
}

/// Two weights over pulleys: a point between equal tensions T sinks until 2 T sin α = m g.
#[test]
fn a_point_between_two_weights_hangs_where_the_parallelogram_of_forces_says() {
    let mut robot = builtin("planar-example");
    robot.cables.truncate(2);
    robot.cables[0].frame_anchor = nalgebra::Vector3::new(-3.0, 4.0, 0.0);
    robot.cables[1].frame_anchor = nalgebra::Vector3::new(3.0, 4.0, 0.0);
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let load = Load::constant(Wrench::new(0.0, -120.0, 0.0, 0.0, 0.0, 0.0));
    let mut rng = ChaCha8Rng::seed_from_u64(5);
    for _ in 0..100 {
        let guess = Pose {
            position: nalgebra::Vector3::new(rng.random_range(-2.0..2.0), rng.random_range(-2.0..3.0), 0.0),
            ..Pose::identity()
        };
        let solution = solve(&model, &[100.0, 100.0], &load, &guess, &Settings::default()).unwrap();
        assert_eq!(solution.status, Status::Converged, "{:?}", solution.reason);
        // sin α = 0.6, so the depth is 3 · 0.6/0.8 below the anchors
        assert!(solution.pose.position.x.abs() < 1e-9 && (solution.pose.position.y - 1.75).abs() < 1e-9);
    }
    let torn = solve(&model, &[50.0, 50.0], &load, &Pose::identity(), &Settings::default()).unwrap();
    assert_eq!(torn.status, Status::NotConverged);
    assert!(torn.reason.unwrap().contains("no pose near it balances these tensions"));
}

#[test]
fn tensions_that_are_none_are_refused() {
    let model = Model::new(builtin("planar-example"), Composition::STANDARD).unwrap();
    let load = Load::of(model.robot()).unwrap();
    let home = model.robot().home_or_middle();
    for bad in [vec![100.0; 3], vec![100.0, -1.0, 100.0, 100.0], vec![f64::NAN; 4]] {
        assert!(solve(&model, &bad, &load, &home, &Settings::default()).is_err(), "{bad:?}");
    }
}
