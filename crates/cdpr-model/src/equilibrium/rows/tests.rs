use nalgebra::Vector3;

use super::*;
use crate::geometry::{Pose, Wrench};
use crate::model::Composition;
use crate::robot::Robot;

fn model(composition: &str) -> Model {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    Model::new(robot, composition.parse().unwrap()).unwrap()
}

fn poses(count: u32) -> Vec<Pose> {
    let pose = |k: u32| {
        let t = f64::from(k);
        let position = Vector3::new(2.0 * t.sin(), 2.0 * (1.3 * t).cos(), 2.5 + 2.0 * (0.7 * t).sin());
        Pose::from_xyz_angles(position, [0.15 * (0.9 * t).sin(), 0.15 * t.cos(), 0.15 * (0.4 * t).sin()])
    };
    (0..count).map(pose).collect()
}

#[test]
fn lengths_of_rows_are_those_of_the_single_pose_for_any_number_of_rows() {
    let model = model("standard");
    for count in [0, 1, 8, 511, 512, 513, 5000] {
        let poses = poses(count);
        let rows: Vec<[f64; 7]> = poses.iter().map(Pose::numbers).collect();
        let mut lengths = vec![f64::NAN; 8 * rows.len()];
        model.lengths_of_rows(rows[..].into(), &mut lengths).unwrap();
        for (pose, lengths) in poses.iter().zip(lengths.chunks(8)) {
            assert_eq!(model.cable_lengths(pose).unwrap(), lengths);
        }
    }
}

#[test]
fn arrays_that_do_not_fit_are_refused_with_the_row() {
    let model = model("standard");
    let mut rows = vec![Pose::identity().numbers(); 6000];
    let mut lengths = vec![0.0; 48_000];
    let short = model.lengths_of_rows(rows[..].into(), &mut lengths[1..]).unwrap_err();
    assert_eq!(short.to_string(), "expected 48000 lengths, one per pose and cable, found 47999");
    rows[5432][6] = 0.9;
    rows[5433][6] = 0.8;
    let error = model.lengths_of_rows(rows[..].into(), &mut lengths).unwrap_err();
    assert_eq!(error, RowsError::Pose(PoseRowError::Norm { row: 5432, norm: 0.9 }));
    let limits = Limits::uniform(8, 0.0, 1e4).unwrap();
    let load = Load::constant(Wrench::zeros());
    let mut statuses = vec![tension::Status::Undecided; 6000];
    let error = model
        .tensions_of_rows(&load, &limits, Method::ClosedForm, rows[..].into(), &mut lengths, &mut statuses)
        .unwrap_err();
    assert_eq!(error, RowsError::Pose(PoseRowError::Norm { row: 5432, norm: 0.9 }));
}

#[test]
fn forward_problems_of_rows_are_those_of_the_single_problem() {
    for composition in ["standard", "elastic"] {
        let model = model(composition);
        let load = Load::constant(Wrench::new(0.0, 0.0, -3000.0, 0.0, -100.0, 0.0));
        let poses = poses(700);
        let taut = if composition == "elastic" { 0.06 } else { 0.0 };
        let shorter = |pose| model.cable_lengths(pose).unwrap().into_iter().map(move |length| length - taut);
        let lengths: Vec<f64> = poses.iter().flat_map(shorter).collect();
        let guesses: Vec<[f64; 6]> = poses
            .iter()
            .map(|pose| {
                let ([x, y, z], [i, j, k]) = (pose.position.into(), pose.xyz_angles());
                [x + 0.05, y, z - 0.03, i, j + 0.02, k]
            })
            .collect();
        let (mut found, mut statuses) = (vec![[0.0; 7]; 700], vec![Status::NotConverged; 700]);
        let (mut rms, mut iterations, mut tensions) = (vec![0.0; 700], vec![0; 700], vec![0.0; 5600]);
        let answers = ForwardAnswers {
            poses: &mut found,
            statuses: &mut statuses,
            residual_rms: Some(&mut rms),
            iterations: Some(&mut iterations),
            tensions: Some(&mut tensions),
        };
        let problems = ForwardRows { lengths: &lengths, guesses: guesses[..].into(), load: Some(&load) };
        let mut state = State::at_home(&model);
        model.forward_of_rows(&problems, &ForwardSettings::default(), &mut state, answers).unwrap();
        let mut batch = PoseBatch::default();
        batch.fill_rows(&guesses[..]).unwrap();
        for item in 0..700 {
            let lengths = &lengths[8 * item..8 * item + 8];
            let single = model.forward(lengths, Some(&load), Some(&batch.get(item)), &mut state).unwrap();
            assert_eq!((single.pose.numbers(), single.status), (found[item], statuses[item]));
            assert_eq!(single.iterations, iterations[item]);
            let tensions = &tensions[8 * item..8 * item + 8];
            match composition {
                "elastic" => assert_eq!(single.tensions, tensions),
                _ => assert!(tensions.iter().all(|tension| tension.is_nan()) && rms[item] == single.residual_rms),
            }
        }
    }
}

#[test]
fn one_guess_serves_all_problems() {
    let model = model(&Composition::STANDARD.to_string());
    let poses = poses(20);
    let lengths: Vec<f64> = poses.iter().flat_map(|pose| model.cable_lengths(pose).unwrap()).collect();
    let (mut found, mut statuses) = ([[0.0; 7]; 20], [Status::NotConverged; 20]);
    let guess = [Pose::identity().numbers()];
    let problems = ForwardRows { lengths: &lengths, guesses: guess[..].into(), load: None };
    let answers = ForwardAnswers {
        poses: &mut found,
        statuses: &mut statuses,
        residual_rms: None,
        iterations: None,
        tensions: None,
    };
    model.forward_of_rows(&problems, &ForwardSettings::default(), &mut State::at_home(&model), answers).unwrap();
    for (pose, found) in poses.iter().zip(found) {
        assert!((Pose::from_numbers(found).position - pose.position).norm() < 1e-9);
    }
}
