//! Robots whose lengths alone determine no pose: four cables at six degrees of freedom.

use nalgebra::Vector3;

use super::*;
use crate::candidate::parse_list;
use crate::selection::{Selection, SelectionCriterion, Settings, Warnings, select};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::simulate::simulate;
use cdpr_model::geometry::{MotionPattern, Plane, Twist};
use cdpr_model::measurement::{Fold, SensorSigmas};
use cdpr_model::model::Composition;
use cdpr_model::robot::{Cable, Platform, Robot};

/// A platform that hangs on four cables, 4 m × 3 m × 2.5 m; its mass may be unknown.
fn suspended(mass: Option<f64>) -> Robot {
    let cable = |index: usize| {
        let (x, y) = ([-1.0, 1.0][index % 2], [-1.0, 1.0][index / 2]);
        Cable {
            name: (index + 1).to_string(),
            frame_anchor: Vector3::new(2.0 * x, 1.5 * y, 2.5),
            platform_anchor: Vector3::new(0.2 * x, 0.15 * y, 0.1),
            ..Cable::default()
        }
    };
    Robot {
        name: "suspended".to_owned(),
        title: None,
        motion_pattern: MotionPattern::Spatial,
        kind: None,
        plane: Plane::default(),
        gravity: Some(Vector3::new(0.0, 0.0, -9.81)),
        notes: vec![],
        assumptions: vec![],
        source: None,
        platform: Platform { mass, center_of_mass: Some(Vector3::zeros()), ..Platform::default() },
        home: Some(Pose { position: Vector3::new(0.0, 0.0, 0.8), ..Pose::identity() }),
        external_wrench: None,
        travel: None,
        cables: (0..4).map(cable).collect(),
        reference_checks: vec![],
        calibration: None,
        tracked: None,
        obstacles: vec![],
    }
}

/// Record of the robot at rest, with winches that read 30 mm too much.
fn recorded(noise: &SensorSigmas) -> Samples {
    let mut machine = suspended(Some(12.0));
    machine.cables.iter_mut().for_each(|cable| cable.length_offset = Some(0.03));
    let model = Model::new(machine, Composition::STANDARD).unwrap();
    let at = |index: i32| {
        let t = f64::from(index);
        let twist = Twist::new(0.6 * (1.3 * t).sin(), 0.4 * (0.7 * t).cos(), 0.2 * t.sin(), 0.0, 0.0, 0.0);
        CommandedPose::at(model.robot().home_or_middle().displaced(&twist))
    };
    let poses: Vec<CommandedPose> = (0..40).map(at).collect();
    let simulated = simulate(&model, &model, &[0.0; 4], &poses, noise, 1).unwrap();
    assert!(simulated.left_out.is_empty(), "{:?}", simulated.left_out);
    simulated.samples
}

fn selected(mass: Option<f64>, samples: &Samples, criterion: SelectionCriterion) -> Selection {
    let (train, validation) = (0..samples.len()).partition(|sample| sample.is_multiple_of(2));
    let fold = Fold { name: "every other".to_owned(), train, validation };
    let candidates = parse_list("standard;standard:length-offset").unwrap();
    let settings = Settings { criterion, ..Settings::default() };
    select(&suspended(mass), &candidates, samples, &[fold], &settings, &crate::progress::unobserved).unwrap()
}

/// The machine rests in equilibrium, and a model that knows its load predicts where, and the tensions.
#[test]
fn under_a_known_load_the_equilibrium_is_predicted() {
    let samples = recorded(&SensorSigmas::default());
    assert!(samples.tensions.as_ref().is_some_and(|tensions| tensions.len() == 4 * samples.len()));
    let mut own = suspended(Some(12.0));
    own.cables.iter_mut().for_each(|cable| cable.length_offset = Some(0.03));
    let model = Model::new(own, Composition::STANDARD).unwrap();
    let blocks = evaluate(&model, &samples).unwrap().blocks();
    assert_eq!((blocks.answered, blocks.samples), (40, 40));
    // both sides stop at 1e-10 m of cable
    assert!(blocks.position_error_m.max < 1e-7 && blocks.rotation_error_rad.max < 1e-7, "{blocks:?}");
    assert!(blocks.tension_error.unwrap().max < 1e-4, "{blocks:?}");
    let given = Model::new(suspended(Some(12.0)), Composition::STANDARD).unwrap();
    let given = evaluate(&given, &samples).unwrap().blocks();
    assert!((0.01..0.1).contains(&given.position_error_m.mean), "30 mm of cable move the platform: {given:?}");
}

/// Lengths alone determine no pose: that is no error of zero.
#[test]
fn without_a_load_no_sample_has_an_error_of_the_pose() {
    let samples = recorded(&SensorSigmas::default());
    let model = Model::new(suspended(None), Composition::STANDARD).unwrap();
    let evaluation = evaluate(&model, &samples).unwrap();
    let blocks = evaluation.blocks();
    assert_eq!((blocks.samples, blocks.answered, blocks.not_converged), (40, 0, 40));
    assert!(blocks.position_error_m.mean.is_nan() && blocks.rotation_error_rad.max.is_nan(), "{blocks:?}");
    // lengths can be compared all the same
    assert_eq!(blocks.length_samples, 40);
    // the offset, and what is slack where the platform rests
    assert!((0.03 - 1e-9..0.032).contains(&blocks.length_error_m.mean_abs), "{blocks:?}");
}

#[test]
fn a_candidate_without_answers_is_never_recommended() {
    let noise = SensorSigmas { position: Some(1e-3), length: Some(2e-4), ..SensorSigmas::default() };
    let mut samples = recorded(&noise);
    samples.tensions = None;
    let found = selected(None, &samples, SelectionCriterion::Position);
    assert_eq!((found.best, found.recommended), (None, None));
    assert!(found.reason.contains("0 of 20 validation samples"), "{}", found.reason);
    let judgements: Vec<_> = found.candidates.iter().map(|one| one.outcome.as_ref().unwrap()).collect();
    assert!(judgements.iter().all(|one| one.criterion.is_nan() && one.disqualified.is_some()));
    // by what can be judged, and where the load is known
    assert_eq!(selected(None, &samples, SelectionCriterion::Length).recommended, Some(1));
    let known = selected(Some(12.0), &samples, SelectionCriterion::Position);
    assert_eq!(known.recommended, Some(1));
    let judgement = known.candidates[1].outcome.as_ref().unwrap();
    assert!((0.0005..0.004).contains(&judgement.criterion), "the sensors' noise is left: {}", judgement.criterion);
}

/// Two of forty samples without an answer: the mean of the others counts for every candidate, and the gap is told.
#[test]
fn means_are_over_the_samples_that_all_candidates_answer() {
    let mut samples = recorded(&SensorSigmas { position: Some(1e-3), length: Some(2e-4), ..SensorSigmas::default() });
    samples.tensions = None;
    // cables far too short to meet: no candidate has an answer there
    samples.lengths[4 * 5..4 * 6].fill(0.6);
    let found = selected(Some(12.0), &samples, SelectionCriterion::Position);
    let judgement = found.candidates[1].outcome.as_ref().unwrap();
    assert_eq!((judgement.compared_samples, judgement.validation.answered), (19, 19), "{}", found.reason);
    assert!(judgement.criterion < 0.01, "{}", judgement.criterion);
    let warnings = found.warnings(&samples, &Warnings::default()).list();
    assert!(warnings.iter().any(|warning| warning.contains("19 of 20")), "{warnings:?}");
}
