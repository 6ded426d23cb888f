//! Conditions of the least value along paths, and their ends.

use nalgebra::{DMatrix, DVector, Vector3};

use super::course::{Place, Question};
use super::subproblem::{Group, Subproblem};
use super::{PathSettings, Penalty, Towards, penalty_path};
use crate::fit::{Prior, Settings, fit};
use crate::loss::Loss;
use crate::minimize::dense::DenseEquations;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Fold, Samples, SensorSigmas, Split};
use cdpr_model::model::{Composition, FreeParameters, Model};
use cdpr_model::reading::Keyword;
use cdpr_model::robot::{ParameterKind, Robot};
use cdpr_model::statics::{Load, controlled_lengths};

const SIGMA: f64 = 1e-3;

fn model(composition: Composition) -> Model {
    Model::new(Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap(), composition).unwrap()
}

fn wave(index: usize) -> f64 {
    (1.3 * index as f64).sin() + 0.5 * (4.1 * index as f64).cos()
}

/// Forty poses with rotations up to `turn` (rad); lengths of a robot whose anchors are up to 5 mm elsewhere, with 1 mm up and down.
fn samples(composition: Composition, turn: f64) -> Samples {
    let mut robot = model(composition).robot().clone();
    for (index, cable) in robot.cables.iter_mut().enumerate() {
        // two cables are where the file says
        let size = if index < 2 { 0.0 } else { 5e-3 };
        cable.frame_anchor += size * Vector3::new(wave(index), wave(index + 9), wave(index + 20));
        cable.platform_anchor.x += size * wave(index + 30);
    }
    let model = Model::new(robot, composition).unwrap();
    let home = model.robot().home_or_middle();
    let pose = |index: usize| {
        let t = index as f64;
        let shift = Vector3::new(t.sin(), (1.7 * t).cos(), 0.5 * (2.3 * t).sin());
        let angles = [turn * t.cos(), turn * (1.3 * t).sin(), turn * (0.7 * t).sin()];
        Pose::from_xyz_angles(home.position + shift, angles)
    };
    let poses: Vec<Pose> = (0..40).map(pose).collect();
    let (mut lengths, mut tensions) = (Vec::new(), Vec::new());
    let load = Load::of(model.robot()).unwrap();
    for pose in &poses {
        if model.needs_tensions() {
            let of_pose = model.distribute(pose, &load).unwrap().tensions;
            lengths.extend(controlled_lengths(&model, pose, &of_pose).unwrap());
            tensions.extend(of_pose);
        } else {
            lengths.extend(model.cable_lengths(pose).unwrap());
        }
    }
    lengths.iter_mut().enumerate().for_each(|(index, length)| *length += SIGMA * wave(index));
    let is_elastic = model.needs_tensions();
    let sigmas = SensorSigmas { length: Some(SIGMA), tension: is_elastic.then_some(40.0), ..SensorSigmas::default() };
    Samples { poses, lengths, tensions: is_elastic.then_some(tensions), cable_count: 8, sigmas, ..Samples::default() }
}

fn followed(composition: Composition, data: &Samples, free: &str, path: &PathSettings) -> Vec<Place> {
    let (model, free) = (model(composition), free.parse::<FreeParameters>().unwrap());
    let settings = Settings { loss: Loss::Squared, ..Settings::default() };
    let parameters = free.parameters(&model, &settings.hold).unwrap();
    let question = Question { model: &model, parameters: &parameters, settings: &settings, path };
    question.follow(data, None).unwrap()
}

fn points(penalty: Penalty) -> PathSettings {
    PathSettings { penalty, points: 12, ..PathSettings::default() }
}

/// ∂(½χ²)/∂(a, b) at anchors of one cable by the formula of a straight cable: Σ ρ/σ² (u, −Rᵀ u).
fn pulls(data: &Samples, cable: usize, values: &[f64]) -> [f64; 6] {
    let vector = |first: usize| {
        Vector3::new(values[6 * cable + first], values[6 * cable + first + 1], values[6 * cable + first + 2])
    };
    let (a, b) = (vector(0), vector(3));
    let mut sum = [0.0; 6];
    for (sample, pose) in data.poses.iter().enumerate() {
        let along = a - pose.position - pose.rotation * b;
        let fraction = (along.norm() - data.lengths_of(sample)[cable]) / (SIGMA * SIGMA);
        let (by_a, by_b) = (along.normalize() * fraction, pose.rotation.inverse() * along.normalize() * -fraction);
        (0..3).for_each(|k| (sum[k], sum[3 + k]) = (sum[k] + by_a[k], sum[3 + k] + by_b[k]));
    }
    sum
}

/// Karush, Kuhn and Tucker: |pull| ≤ λ where a change is 0, pull = −λ sign p elsewhere. The descent stops at 1e-8 λ and rounding: 8e-8 λ in
/// all down to a hundredth of the largest λ, and more of the small ones, where rounding along weak directions is all that is left.
#[test]
fn every_place_of_a_lasso_path_fulfils_its_conditions() {
    let data = samples(Composition::STANDARD, 0.2);
    let places = followed(Composition::STANDARD, &data, "frame-anchor,platform-anchor", &points(Penalty::Lasso));
    let start: Vec<f64> = places[0].values.clone();
    let (mut counts, mut worst) = (Vec::new(), 0.0_f64);
    for place in &places {
        assert!(place.converged, "λ {}", place.lambda);
        for cable in 0..8 {
            for (k, pull) in pulls(&data, cable, &place.values).into_iter().enumerate() {
                let change = place.values[6 * cable + k] - start[6 * cable + k];
                let tolerance = 1e-6 * place.lambda + 1e-3;
                let off = match change == 0.0 {
                    true => pull.abs() - place.lambda,
                    false => (pull + place.lambda.copysign(change)).abs(),
                };
                assert!(off <= tolerance, "λ {} {cable} {k}: {pull}", place.lambda);
                let is_large = place.lambda >= 0.01 * places[0].lambda;
                worst = if is_large { worst.max(off / place.lambda) } else { worst };
            }
        }
        counts.push(place.is_off.iter().filter(|is_off| **is_off).count());
    }
    // the number of the book
    assert!(worst <= 8e-8, "{worst}");
    assert_eq!((counts[0], counts[12]), (0, 48));
    assert!(counts[4] > 0 && counts[4] < 40, "{counts:?}");
}

#[test]
fn a_path_begins_at_the_file_and_ends_at_least_squares() {
    for composition in [Composition::STANDARD, Composition::ELASTIC] {
        let data = samples(composition, 0.2);
        let free = if composition == Composition::ELASTIC { "frame-anchor,compliance,wrench" } else { "frame-anchor" };
        let (model, list) = (model(composition), free.parse::<FreeParameters>().unwrap());
        let settings = Settings { loss: Loss::Squared, ..Settings::default() };
        let best = fit(&model, &data, &list, &settings).unwrap();
        for &penalty in Penalty::ALL {
            let places = followed(composition, &data, free, &points(penalty));
            let first = &places[0];
            for (k, estimate) in best.parameters.iter().enumerate() {
                if penalty != Penalty::Ridge {
                    // a wrench goes through its rows, which rounds
                    let off = (first.values[k] - estimate.start).abs();
                    assert!(off <= 1e-15 * estimate.start.abs(), "{penalty} {}: {off}", estimate.name);
                }
                let off = (places[12].values[k] - estimate.value).abs();
                // the fit stops at 1e-10 m; its weights agree to a millionth
                let sigma = estimate.sigma.unwrap();
                assert!(off <= 1e-4 * sigma, "{penalty} {}: {off} of {sigma}", estimate.name);
            }
            // just below the first penalty something moves
            let some = places[1].is_off.iter().any(|is_off| *is_off);
            assert!(some, "{penalty}");
        }
    }
}

/// ½χ² + ½ λ u² is ½(χ² + (u/σ)²) with λ = 1/σ²: a prior.
#[test]
fn a_ridge_is_a_prior() {
    let data = samples(Composition::STANDARD, 0.2);
    let places = followed(Composition::STANDARD, &data, "frame-anchor", &points(Penalty::Ridge));
    let place = &places[4];
    let prior = Prior { kind: ParameterKind::FrameAnchor, sigma: place.lambda.sqrt().recip() };
    let settings = Settings { loss: Loss::Squared, priors: vec![prior], ..Settings::default() };
    let free = "frame-anchor".parse().unwrap();
    let found = fit(&model(Composition::STANDARD), &data, &free, &settings).unwrap();
    for (estimate, value) in found.parameters.iter().zip(&place.values) {
        // the fit's tolerance
        assert!((estimate.value - value).abs() < 1e-9, "{}: {} {value}", estimate.name, estimate.value);
    }
    assert!(found.parameters.iter().any(|estimate| estimate.change.abs() > 1e-4));
}

/// Either all three coordinates of an anchor move or none, and a group at rest pulls with less than λ √3.
#[test]
fn group_lasso_moves_whole_anchors() {
    let data = samples(Composition::STANDARD, 0.2);
    let places = followed(Composition::STANDARD, &data, "frame-anchor,platform-anchor", &points(Penalty::GroupLasso));
    let start = places[0].values.clone();
    let mut mixed = 0;
    for place in &places {
        assert!(place.converged);
        let off: Vec<bool> = place.is_off.chunks(3).map(|anchor| anchor.iter().all(|is_off| *is_off)).collect();
        for (anchor, is_off) in off.iter().enumerate() {
            let own = &place.is_off[3 * anchor..][..3];
            assert!(own.iter().all(|other| other == is_off), "λ {} anchor {anchor}", place.lambda);
            let all = pulls(&data, anchor / 2, &place.values);
            let pull = Vector3::from_column_slice(&all[3 * (anchor % 2)..][..3]);
            let change = Vector3::from_fn(|k, _| place.values[3 * anchor + k] - start[3 * anchor + k]);
            let strength = 3.0_f64.sqrt() * place.lambda;
            let tolerance = 1e-6 * strength + 1e-3;
            match is_off {
                false => assert!(pull.norm() <= strength + tolerance),
                true => assert!((pull + change.normalize() * strength).norm() <= tolerance, "λ {}", place.lambda),
            }
        }
        mixed += usize::from(off.contains(&true) && off.contains(&false));
    }
    assert!(mixed >= 3);
}

/// One orientation tells only a − R b: with b penalised towards 0 and a free, b = 0 exactly for every λ > 0 (sec. 6.3), and the squares are those
/// of the full model.
#[test]
fn constant_orientation_leaves_no_platform_anchor() {
    let data = samples(Composition::STANDARD, 0.0);
    let path =
        PathSettings { towards: Towards::Zero, shrink: "platform-anchor".parse().unwrap(), ..points(Penalty::Lasso) };
    let places = followed(Composition::STANDARD, &data, "frame-anchor,platform-anchor", &path);
    let full = fit(
        &model(Composition::STANDARD),
        &data,
        &"frame-anchor,platform-anchor".parse().unwrap(),
        &Settings { loss: Loss::Squared, ..Settings::default() },
    )
    .unwrap();
    let least = full.history.last().copied().unwrap();
    for place in &places[..12] {
        for cable in 0..8 {
            assert_eq!(place.values[6 * cable + 3..6 * cable + 6], [0.0; 3], "λ {}", place.lambda);
        }
        assert!((place.squares / least - 1.0).abs() < 1e-9, "{} {least}", place.squares);
    }
}

/// Wrench and length rows tie all parameters together; the conditions hold as for the rows of single cables.
#[test]
fn an_elastic_path_lets_parameters_enter_one_after_the_other() {
    let data = samples(Composition::ELASTIC, 0.2);
    let places =
        followed(Composition::ELASTIC, &data, "frame-anchor,platform-anchor,compliance", &points(Penalty::Lasso));
    let counts: Vec<usize> = places.iter().map(|place| place.is_off.iter().filter(|is_off| **is_off).count()).collect();
    assert!(places.iter().all(|place| place.converged), "{counts:?}");
    assert_eq!((counts[0], counts[12]), (0, 56));
    assert!(counts.windows(2).all(|pair| pair[1] + 4 >= pair[0]), "{counts:?}");
    assert!(places.windows(2).all(|pair| pair[1].squares <= pair[0].squares * (1.0 + 1e-9)));
}

#[test]
fn cross_validation_keeps_the_parameters_that_matter() {
    let data = samples(Composition::STANDARD, 0.2);
    let model = model(Composition::STANDARD);
    let free = "frame-anchor".parse().unwrap();
    let settings = Settings::default();
    let found = fit(&model, &data, &free, &settings).unwrap();
    let folds: Vec<Fold> = Split::KFold(5).folds(&data, 1).unwrap();
    let path = penalty_path(&model, &data, &found, &settings, &free, &points(Penalty::Lasso), &folds).unwrap();
    let (best, chosen) = (path.best.unwrap(), path.chosen.unwrap());
    let error = |point: usize| path.points[point].validation.unwrap();
    assert!(chosen <= best && error(chosen) <= error(best) + path.points[best].standard_error.unwrap());
    assert!(error(best) < 0.5 * error(0), "{} {}", error(best), error(0));
    assert_eq!(path.left.len(), 24 - path.points[chosen].parameter_count);
    for (k, parameter) in path.parameters.iter().enumerate() {
        let is_left = path.left.contains(&parameter.name);
        let change = path.points[chosen].changes_m[k];
        assert_eq!(is_left, change == 0.0, "{} {change}", parameter.name);
        assert_eq!(is_left, path.points[chosen].values[k] == parameter.centre, "{} {change}", parameter.name);
        assert!(is_left || parameter.enters.is_some_and(|lambda| lambda >= path.points[chosen].lambda));
    }
}

#[test]
fn other_costs_have_no_path() {
    let data = samples(Composition::STANDARD, 0.2);
    let (model, free) = (model(Composition::STANDARD), "frame-anchor".parse().unwrap());
    let found = fit(&model, &data, &free, &Settings::default()).unwrap();
    let settings = Settings { loss: Loss::Huber, ..Settings::default() };
    let refused = penalty_path(&model, &data, &found, &settings, &free, &PathSettings::default(), &[]).unwrap_err();
    assert!(refused.to_string().contains("the loss `huber`"), "{refused}");
}

/// Collinear columns, a bound in the way, groups beside single ones: the conditions of a convex problem prove its least value.
#[test]
fn quadratic_problems_end_at_their_least_value() {
    let rows = DMatrix::from_fn(12, 7, |i, j| match j {
        6 => wave(7 * i) + 1e-3 * wave(i + 50),
        j => wave(7 * i + j),
    });
    let quadratic = DenseEquations {
        cost: 0.0,
        gradient: rows.tr_mul(&DVector::from_fn(12, |i, _| wave(i + 100))),
        hessian: rows.tr_mul(&rows),
    };
    let at = DVector::zeros(7);
    let groups = [vec![0], vec![1, 2, 3], vec![4], vec![5], vec![6]];
    let groups: Vec<Group> =
        groups.into_iter().map(|members| Group { weight: (members.len() as f64).sqrt(), members }).collect();
    let mut bounds = vec![(f64::NEG_INFINITY, f64::INFINITY); 7];
    bounds[4] = (-0.01, 0.01);
    for lambda in [1e-3, 0.1, 1.0, 3.0, 100.0] {
        let problem = Subproblem { quadratic: &quadratic, at: &at, groups: &groups, lambda, bounds: &bounds };
        let mut z = DVector::zeros(7);
        problem.solve(&mut z, 1e-10);
        let gradient = &quadratic.gradient + &quadratic.hessian * &z;
        for group in &groups {
            let violation = group.violation(lambda, &z, &gradient, &bounds);
            assert!(violation <= 1e-9, "λ {lambda}, {:?}: {violation}", group.members);
        }
        assert!(z[4].abs() <= 0.01);
    }
}
