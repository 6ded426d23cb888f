//! Promises of residual vectors, costs and the least largest norm.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};
use nalgebra::Vector3;

use super::minimax;
use super::problem::ObjectiveVectors;
use super::vectors::{Stacked, Vectors};
use super::{Minimize, Objective};
use crate::geometry::Wrench;
use crate::identification::fit::{Minimizer, Settings, fit};
use crate::identification::recorded_curves::curve;
use crate::measurement::{Samples, SensorSigmas};
use crate::model::{Composition, FreeParameters, Model, place_pulleys};
use crate::robot::{ExternalWrench, Robot};
use crate::statics::{Load, controlled_lengths};

/// Eleven turned poses; lengths of the model under its load plus two millimetres up and down, tensions plus ten newtons.
fn samples(model: &Model) -> Samples {
    let poses = curve(model, 11, 1.0);
    let wave = |index: usize| (1.3 * index as f64).sin();
    let (mut lengths, mut tensions) = (Vec::new(), Vec::new());
    for pose in &poses {
        if model.needs_tensions() {
            let load = Load::of(model.robot()).unwrap();
            let of_pose = model.distribute(pose, &load).unwrap().tensions;
            lengths.extend(controlled_lengths(model, pose, &of_pose).unwrap());
            tensions.extend(of_pose);
        } else {
            lengths.extend(model.cable_lengths(pose).unwrap());
        }
    }
    lengths.iter_mut().enumerate().for_each(|(index, length)| *length += 2e-3 * wave(index));
    tensions.iter_mut().enumerate().for_each(|(index, tension)| *tension += 10.0 * wave(index + 5));
    let sigmas =
        SensorSigmas { position: Some(1e-3), rotation: Some(1e-3), tension: Some(40.0), ..SensorSigmas::default() };
    let tensions = (!tensions.is_empty()).then_some(tensions);
    Samples { poses, lengths, tensions, cable_count: model.cable_count(), sigmas, ..Samples::default() }
}

fn crane(composition: Composition) -> Model {
    let robot = Robot::builtin("cablerobot-simulator-helicopter").unwrap();
    let mut robot = place_pulleys(&robot, &[(0.161, Vector3::z()); 8], &robot.home_or_middle()).unwrap();
    let wrench = Wrench::new(100.0, -50.0, -3000.0, 20.0, 30.0, -10.0);
    robot.external_wrench = Some(ExternalWrench { wrench, includes_gravity: true, note: None });
    for cable in &mut robot.cables {
        cable.stiffness = Some(crate::robot::CableStiffness::Axial(2e6));
    }
    Model::new(robot, composition).unwrap()
}

/// Predicted poses end where a step gains no more than rounding of the cost, 1e-9 m: over steps of a millimetre that and their square are some 1e-6.
/// Without the curvature of lengths that do not fit by 2 mm derivatives would be wrong by 1e-4.
#[test]
fn derivatives_of_vectors_are_those_of_differences() {
    let both = Composition::PULLEY_ELASTIC;
    let rigid = "frame-anchor,platform-anchor,length-offset,length-scale,pulley-radius";
    let elastic = "frame-anchor,platform-anchor,length-offset,length-scale,pulley-radius,compliance,wrench,tension-scale,tension-offset";
    for (composition, free, objective) in [
        (Composition::PULLEY, rigid, Objective::Length),
        (Composition::PULLEY, rigid, Objective::Pose),
        (both, elastic, Objective::Length),
        (both, elastic, Objective::Pose),
    ] {
        let model = crane(composition);
        let samples = samples(&model);
        let parameters =
            free.parse::<FreeParameters>().unwrap().parameters(&model, &FreeParameters::default()).unwrap();
        let settings = Settings { objective, ..Settings::default() };
        let (mut vectors, _) = ObjectiveVectors::of(&model, &samples, &parameters, &settings).unwrap();
        let values: Vec<f64> = parameters.iter().map(|parameter| parameter.value(model.robot())).collect();
        let (mut here, mut there) = (Stacked::new(&vectors, values.len()), Stacked::new(&vectors, values.len()));
        assert!(vectors.write(&values, &mut here), "{objective:?}: {:?}", vectors.unpredicted());
        for (k, parameter) in parameters.iter().enumerate() {
            let step = match parameter.unit(model.robot()) {
                "1/N" => 1e-12,
                "N" | "N·m" => 1.0,
                "" => 1e-4,
                _ => 1e-3,
            };
            let mut at = |sign: f64| {
                let mut moved = values.clone();
                moved[k] += sign * step;
                assert!(vectors.write(&moved, &mut there));
                there.residuals.clone()
            };
            let difference = (at(1.0) - at(-1.0)) / (2.0 * step);
            let exact = here.jacobian.column(k);
            let error = (&difference - exact).amax() / difference.amax().max(1e-9);
            assert!(error < 1e-5, "{objective:?} {}: {error:.1e}", parameter.name(model.robot()));
        }
    }
}

/// All ways to the optimum end at the same cost.
#[test]
fn every_minimizer_ends_at_the_same_cost() {
    let model = crane(Composition::PULLEY);
    let samples = samples(&model);
    for (objective, minimize) in [(Objective::Pose, Minimize::Squares), (Objective::Length, Minimize::Mean)] {
        let cost = |minimizer: Minimizer| {
            let settings = Settings { objective, minimize, minimizer, ..Settings::default() };
            let found = fit(&model, &samples, &"frame-anchor".parse().unwrap(), &settings).unwrap();
            *found.history.last().unwrap()
        };
        let costs = Minimizer::ALL.map(cost);
        for other in &costs[1..] {
            assert!((other / costs[0] - 1.0).abs() < 1e-10, "{objective:?} {minimize:?}: {costs:?}");
        }
    }
}

/// The problem linearised at the least largest norm, as a second-order cone programme of another solver, has that norm as its least value.
#[test]
fn the_least_largest_norm_is_that_of_a_cone_programme() {
    let model = crane(Composition::PULLEY);
    let samples = samples(&model);
    let free: FreeParameters = "frame-anchor".parse().unwrap();
    let parameters = free.parameters(&model, &FreeParameters::default()).unwrap();
    for objective in Objective::ALL {
        let settings = Settings { objective, ..Settings::default() };
        let (mut vectors, _) = ObjectiveVectors::of(&model, &samples, &parameters, &settings).unwrap();
        let start: Vec<f64> = parameters.iter().map(|parameter| parameter.value(model.robot())).collect();
        let found = minimax::minimise(&mut vectors, &parameters, &[1.0; 24], &start, 2000).unwrap();
        assert!(found.converged);
        let mut stacked = Stacked::new(&vectors, start.len());
        assert!(vectors.write(&found.values, &mut stacked));
        let least = cone_programme(&stacked);
        let largest = found.certificate.largest;
        assert!((largest / least - 1.0).abs() < 1e-6, "{objective:?}: {largest} {least}");
        let sum: f64 = found.certificate.active.iter().map(|active| active.multiplier).sum();
        assert!((sum - 1.0).abs() < 1e-6 && found.certificate.subgradient < 1e-5, "{:?}", found.certificate);
    }
}

/// min t where ‖r_j + J_j d‖ ≤ t for every sample.
fn cone_programme(stacked: &Stacked) -> f64 {
    let (count, size) = (stacked.jacobian.ncols(), stacked.size);
    let rows = stacked.samples() * (size + 1);
    // slack = right − A x in the cone: first t, then the vector
    let mut columns = vec![vec![0.0; rows]; count + 1];
    let mut right = vec![0.0; rows];
    for sample in 0..stacked.samples() {
        let first = sample * (size + 1);
        columns[count][first] = -1.0;
        for row in 0..size {
            right[first + 1 + row] = stacked.residuals[sample * size + row];
            for (k, column) in columns.iter_mut().enumerate().take(count) {
                column[first + 1 + row] = -stacked.jacobian[(sample * size + row, k)];
            }
        }
    }
    let by_rows: Vec<Vec<f64>> = (0..rows).map(|row| columns.iter().map(|column| column[row]).collect()).collect();
    let mut objective = vec![0.0; count + 1];
    objective[count] = 1.0;
    let cones = vec![SupportedConeT::SecondOrderConeT(size + 1); stacked.samples()];
    let tight =
        DefaultSettings { verbose: false, tol_gap_rel: 1e-10, tol_gap_abs: 1e-10, ..DefaultSettings::default() };
    let none = CscMatrix::zeros((count + 1, count + 1));
    let mut solver = DefaultSolver::new(&none, &objective, &CscMatrix::from(&by_rows), &right, &cones, tight).unwrap();
    solver.solve();
    assert!(matches!(solver.solution.status, SolverStatus::Solved | SolverStatus::AlmostSolved));
    solver.solution.obj_val
}
