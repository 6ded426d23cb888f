//! Shapes that tensions are chosen by: along a path through the workspace, and where the set is known by hand.

use cdpr_model::geometry::Pose;
use cdpr_model::model::{Composition, Model};
use cdpr_model::tension::{Limits, Method, Options, Solver, Status, solve};
use nalgebra::{DMatrix, Vector3};

/// Tensions along a path through the workspace of the CableRobot Simulator, and their largest step and largest change of
/// direction, both divided by the length of a step.
fn along_path(method: Method, steps: usize) -> [f64; 2] {
    let model = Model::new(super::support::simulator(), Composition::STANDARD).expect("a model");
    let limits = Limits::uniform(8, 1000.0, 6000.0).expect("in order");
    let wrench = [300.0, -200.0, -7000.0, 200.0, 100.0, -50.0];
    let mut solver = Solver::new(method, 8, 6);
    let tensions: Vec<Vec<f64>> = (0..=steps)
        .map(|step| {
            let part = step as f64 / steps as f64;
            let position = Vector3::new(-1.0 + 2.0 * part, 0.8 - 1.2 * part, 1.4 + 0.4 * part);
            let pose = Pose::from_xyz_angles(position, [0.0, 0.02, 0.15 * part]);
            let matrix = model.structure_matrix(&pose).expect("courses");
            let answer = solver.solve(&matrix, &wrench, &limits, &Options::default()).expect("fits");
            assert_eq!(answer.status, Status::Feasible, "{method} at {part}: {:?}", answer.reason());
            answer.tensions.clone()
        })
        .collect();
    let length = 1.0 / steps as f64;
    let largest = |change: &dyn Fn(usize, usize) -> f64, from: usize| {
        let all = (from..steps).flat_map(|step| (0..8).map(move |cable| (step, cable)));
        all.fold(0.0_f64, |most, (step, cable)| most.max(change(step, cable).abs() / length))
    };
    [
        largest(&|step, cable| tensions[step + 1][cable] - tensions[step][cable], 0),
        largest(&|step, cable| tensions[step + 1][cable] - 2.0 * tensions[step][cable] + tensions[step - 1][cable], 1),
    ]
}

/// The slope of the optimum jumps where a cable reaches its limit; that of the barrier does not, so that half the step halves
/// its change.
#[test]
fn the_programme_is_continuous_along_a_path_and_the_barrier_smooth() {
    for method in [Method::Qp, Method::Minimum, Method::Centroid, Method::Barrier, Method::Puncture] {
        let [coarse, fine] = [400, 800].map(|steps| along_path(method, steps));
        // a jump of tensions would double this
        assert!(fine[0] < 1.2 * coarse[0], "{method}: {coarse:?} {fine:?}");
        match method {
            Method::Barrier | Method::Centroid => assert!(fine[1] < 0.6 * coarse[1], "{method}: {coarse:?} {fine:?}"),
            Method::Qp | Method::Minimum => {
                assert!(fine[1] > 0.8 * coarse[1], "no kink on this path: {coarse:?} {fine:?}")
            }
            _ => {}
        }
    }
}

/// Parallel cables that share a load: the allowed tensions are a simplex, or one with a corner cut off.
#[test]
fn the_centroid_of_a_triangle_and_of_a_tetrahedron_is_the_mean_of_its_corners() {
    // f₁ + f₂ + f₃ = 900 with fᵢ ≥ 100 and room above: corners (700, 100, 100) …; the same with four cables
    for count in [2, 3, 4, 5, 6] {
        let matrix = DMatrix::from_element(1, count, 1.0);
        let limits = Limits::uniform(count, 100.0, 5000.0).expect("in order");
        let load = 100.0 * count as f64 + 600.0;
        let answer = solve(Method::Centroid, &matrix, &[-load], &limits, &Options::default()).expect("fits");
        let expected = load / count as f64;
        // rounding of a recursion over up to 5 dimensions
        assert!(answer.tensions.iter().all(|f| (f - expected).abs() < 1e-6), "{count}: {answer:?}");
    }
    // a trapezoid: f₂ at most 300 cuts the corner off. Corners of (f₁, f₂): (100,100) (700,100) (500,300) (100,300)
    let matrix = DMatrix::from_element(1, 3, 1.0);
    let limits = Limits::new(vec![100.0; 3], vec![5000.0, 300.0, 5000.0]).expect("in order");
    let answer = solve(Method::Centroid, &matrix, &[-900.0], &limits, &Options::default()).expect("fits");
    // parallel sides 600 and 400, height 200: distance from the longer one 200/3 · (600 + 2·400)/(600 + 400)
    let f2 = 100.0 + 200.0 / 3.0 * 1400.0 / 1000.0;
    assert!((answer.tensions[1] - f2).abs() < 1e-6, "{answer:?}");
    assert!((answer.tensions[0] - answer.tensions[2]).abs() < 1e-6, "the set is symmetric: {answer:?}");
}
