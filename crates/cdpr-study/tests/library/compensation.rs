//! Maps on the twin of sec. 6, whose elasticity a kinematic controller does not know: smooth errors, and noise.

use super::studies::experiment;
use cdpr_calibration::compensation::*;
use cdpr_calibration::evaluation::evaluate_fitted;
use cdpr_calibration::fit::{Settings, fit};
use cdpr_model::compensation::{Beyond, Compensation, MapError};
use cdpr_model::control::CommandedPose;
use cdpr_model::control::{InputError, Outcome};
use cdpr_model::equilibrium::State;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_study::Experiment;
use cdpr_study::campaign::{CampaignError, Order};
use cdpr_study::field::field;
use cdpr_study::reachable::Varied;
use cdpr_study::sensitivity::Offsets;
use nalgebra::Vector3;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

/// The twin with its controller calibrated by all of its 91 poses, and their record.
fn calibrated() -> (Experiment, Samples) {
    let twin = experiment("twin-campaign");
    let record = twin.record(&twin.poses(Vec::new(), 0).unwrap(), 1).unwrap().samples;
    let found = fit(&twin.control, &record, &"frame-anchor".parse().unwrap(), &Settings::default()).unwrap();
    (twin.with_control(found.model), record)
}

/// Mean distance by which the machine misses poses under lengths with corrections (m).
fn driven(experiment: &Experiment, poses: &[Pose], map: Option<&Compensation>) -> f64 {
    let (control, machine) = (&experiment.control, &experiment.machine);
    let mut state = State::at(machine, &experiment.start);
    let missed = |pose: &Pose| {
        let mut lengths = control.cable_lengths(pose).unwrap();
        let correction = map.map_or(vec![0.0; lengths.len()], |map| map.at(pose).lengths);
        lengths.iter_mut().zip(correction).for_each(|(length, own)| *length += own);
        let found = machine.forward(&lengths, None, Some(pose), &mut state).unwrap();
        (found.pose.position - pose.position).norm()
    };
    poses.iter().map(missed).sum::<f64>() / poses.len() as f64
}

/// Kinematics leaves smooth errors of the elastic twin: a map of 91 noisy samples halves the errors that were not fitted to, predicted on another record and driven on the
/// machine.
#[test]
fn smooth_errors_of_the_twin_are_halved_where_nothing_was_fitted() {
    let (twin, record) = calibrated();
    let found = compensate(&twin.control, &record, None, 0).unwrap();
    assert!(found.helps, "{:?}", found.judged);
    let Judged { without, with, .. } = &found.judged;
    assert!(with.length_error_m.rms < 0.7 * without.length_error_m.rms, "{:?}", found.judged);
    // other poses of the same box, by sensors without noise
    let others = twin.poses(Vec::new(), 5).unwrap();
    let fresh: Vec<_> =
        others[75..].iter().filter(|command| found.map.at(&command.pose).fraction == 1.0).cloned().collect();
    assert!(fresh.len() >= 8, "{} of 16 turned poses are among the samples", fresh.len());
    let exact = twin.record_exactly(&fresh).unwrap().samples;
    let alone = evaluate_fitted(&twin.control, &exact).unwrap().blocks();
    let (corrected, _) = evaluate_compensated(&twin.control, &exact, &found.map).unwrap();
    let corrected = corrected.blocks();
    let ratio = corrected.position_error_m.mean / alone.position_error_m.mean;
    assert!(ratio < 0.7, "{} {}", corrected.position_error_m.mean, alone.position_error_m.mean);
    let poses: Vec<Pose> = fresh.iter().map(|command| command.pose).collect();
    let (before, after) = (driven(&twin, &poses, None), driven(&twin, &poses, Some(&found.map)));
    assert!(after < 0.7 * before, "{after} {before}");
    studies_drive_with_maps(&twin, &found.map, &fresh, [before, after]);
}

/// An experiment drives by the lengths of its map, beyond the samples by those of the model alone, says what it would be without, and refuses questions of other models.
fn studies_drive_with_maps(twin: &Experiment, map: &Compensation, inside: &[CommandedPose], [before, after]: [f64; 2]) {
    let mut twin = twin.clone();
    twin.study.control.compensation = Some("map.toml".to_owned());
    assert!(matches!(twin.assess(inside), Err(InputError::NoMap { file }) if file == "map.toml"));
    let corrected = twin.clone().with_compensation(map.clone()).unwrap();
    let far = Pose { position: twin.start.position + 0.9 * Vector3::z(), ..twin.start };
    let poses: Vec<CommandedPose> = inside.iter().cloned().chain([CommandedPose::at(far)]).collect();
    let found = corrected.assess(&poses).unwrap();
    let mean = |of: &[Outcome]| {
        let missed =
            |(command, outcome): (&CommandedPose, &Outcome)| (outcome.pose.position - command.pose.position).norm();
        inside.iter().zip(of).map(missed).sum::<f64>() / inside.len() as f64
    };
    let alone = corrected.without_compensation().assess(&poses).unwrap();
    // forward problems from other starts end within a nanometre
    assert!((mean(&found.outcomes) - after).abs() < 1e-8 && (mean(&alone.outcomes) - before).abs() < 1e-8);
    assert_eq!(found.outcomes.last(), alone.outcomes.last());
    let effect = found.accuracy.compensation.as_ref().unwrap();
    assert_eq!((effect.beyond, &effect.without), (Beyond { outside: 1, fading: 0 }, &alone.accuracy));
    let commands: Vec<Pose> = poses.iter().map(|command| command.pose).collect();
    let driving = corrected.driving().unwrap();
    assert_eq!(driving.outcomes(&commands), found.outcomes);
    let summary = field(&driving, &commands).summary;
    let effect = summary.compensation.unwrap();
    assert_eq!((effect.beyond.outside, effect.without.position_error_m), (1, alone.accuracy.position_error_m));
    assert_eq!(summary.position_error_m, found.accuracy.position_error_m);
    // one linear step from the corrected lengths
    assert!(summary.linear_residual_m.max < 0.2 * summary.position_error_m.max);
    let refused = |found: Result<(), InputError>| matches!(found, Err(InputError::Map { .. }));
    assert!(refused(corrected.sensitivity(Offsets::Kept).map(drop)));
    let (reachable, causes) = (corrected.reachable().unwrap(), corrected.causes(Offsets::Kept));
    assert!(refused(Varied::new(&reachable, &causes[0], 1e-3).map(drop)));
    let limits = corrected.known_limits().unwrap();
    assert!(refused(corrected.initial_tension_task(&limits).map(drop)));
    let mut record = |_: &Order<'_>| -> Result<Option<Samples>, CampaignError> { Ok(None) };
    let campaign = corrected.campaign(&poses, 0, &mut record).map(drop);
    assert!(matches!(campaign, Err(CampaignError::Machine(InputError::Map { .. }))));
    assert!(corrected.with_control(twin.machine.clone()).compensation.is_none());
    let other = Experiment { control: twin.machine.clone(), ..twin };
    assert!(matches!(other.with_compensation(map.clone()), Err(MapError::OtherModel { .. })));
}

/// A model that is right leaves noise, of which no map is made.
#[test]
fn noise_is_refused() {
    let twin = experiment("twin-campaign");
    let record = twin.record(&twin.poses(Vec::new(), 0).unwrap(), 1).unwrap().samples;
    for seed in 0..3 {
        let found = compensate(&twin.machine, &record, None, seed).unwrap();
        assert!(!found.helps && found.reason.contains("does not help"), "{:?}", found.judged);
    }
    // lengths of a rigid robot with noise of their own
    let model = Model::new(Robot::builtin("planar-example").unwrap(), Composition::STANDARD).unwrap();
    let mut refused = 0;
    for seed in 0..40 {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let samples = planar(&model, 30, |_, _| 1e-3 * Distribution::<f64>::sample(&StandardNormal, &mut rng));
        refused += usize::from(!compensate(&model, &samples, None, seed).unwrap().helps);
    }
    // two standard errors let one in forty pass by chance
    assert!(refused >= 38, "{refused} of 40");
}

/// Samples of the planar example on a spiral, with an error of every length by pose and cable.
fn planar(model: &Model, count: usize, mut error: impl FnMut(&Pose, usize) -> f64) -> Samples {
    let mut samples = Samples { cable_count: 4, sigmas: SensorSigmas::default(), ..Samples::default() };
    for k in 0..count {
        let angle = 2.4 * k as f64;
        let radius = 2.0 * ((k as f64 + 0.5) / count as f64).sqrt();
        let pose =
            model.robot().motion_pattern.pose(model.robot().plane, &[radius * angle.cos(), 4.0 + radius * angle.sin()]);
        let pose = pose.unwrap();
        let lengths = model.cable_lengths(&pose).unwrap();
        samples.lengths.extend(lengths.iter().enumerate().map(|(cable, length)| length + error(&pose, cable)));
        samples.poses.push(pose);
    }
    samples
}

/// The lengths of a map lead back: the pose predicted from lengths φ(x) + c(x) is x, though the map is only known at the pose that is looked for.
#[test]
fn lengths_with_their_correction_lead_back_to_the_pose() {
    let model = Model::new(Robot::builtin("planar-example").unwrap(), Composition::STANDARD).unwrap();
    let smooth = |pose: &Pose, cable: usize| 0.02 * (0.5 * pose.position.x + cable as f64).sin();
    let samples = planar(&model, 60, smooth);
    let found = compensate(&model, &samples, None, 0).unwrap();
    assert!(found.helps, "{}", found.reason);
    let mut exact = samples.subset(&(0..30).collect::<Vec<_>>());
    exact.lengths.clear();
    for pose in &exact.poses {
        let correction = found.map.at(pose).lengths;
        exact.lengths.extend(model.cable_lengths(pose).unwrap().iter().zip(correction).map(|(q, own)| q + own));
    }
    let (errors, outside) = evaluate_compensated(&model, &exact, &found.map).unwrap();
    // turns end at a tenth of a nanometre
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    assert!(largest(&errors.position) < 1e-9 && largest(&errors.length) < 1e-12 && outside == Beyond::default());
}

/// A map says nothing beyond its samples, none is made of few, and another robot's is told.
#[test]
fn maps_end_where_their_samples_end() {
    let model = Model::new(Robot::builtin("planar-example").unwrap(), Composition::STANDARD).unwrap();
    let smooth = |pose: &Pose, _: usize| 0.02 * pose.position.x.sin();
    let samples = planar(&model, 40, smooth);
    let map = compensate(&model, &samples, None, 0).unwrap().map;
    let at = |x: f64, y: f64| map.at(&model.robot().motion_pattern.pose(model.robot().plane, &[x, y]).unwrap());
    assert_eq!((at(0.3, 4.2).fraction, at(0.3, 4.2).reason), (1.0, None));
    assert!(matches!(at(3.0, 4.0).known(), Err(MapError::Outside { reason }) if reason.contains("x is")));
    let (_, outside) = evaluate_compensated(&model, &planar(&model, 5, |_, _| 0.0), &map).unwrap();
    assert_eq!(outside, Beyond::default());
    let few = planar(&model, 9, smooth);
    assert!(matches!(
        compensate(&model, &few, None, 0),
        Err(CompensationError::TooFewSamples { samples: 9, least: 10 })
    ));
    let text = map.to_toml();
    let again = Compensation::from_toml_bytes(text.as_bytes(), "map.toml", &model).unwrap();
    assert_eq!(again.to_toml(), text);
    assert_eq!(again.at(&samples.poses[3]), map.at(&samples.poses[3]));
    let other = Model::new(Robot::builtin("planar-example-calibrated").unwrap(), Composition::STANDARD).unwrap();
    assert!(matches!(
        Compensation::from_toml_bytes(text.as_bytes(), "map.toml", &other),
        Err(MapError::OtherModel { .. })
    ));
    let scale = format!("length_scale_m = {:?}", map.facts().length_scale);
    let wrong = [
        ("layout_version = 1", "layout_version = 2"),
        (&scale, "length_scale_m = 0.0"),
        (&scale, "length_scale_m = -1.0"),
    ];
    for (own, other) in wrong {
        assert!(text.contains(own), "{own}");
        let damaged = text.replace(own, other);
        let refused = Compensation::from_toml_bytes(damaged.as_bytes(), "map.toml", &model);
        assert!(matches!(refused, Err(MapError::Read(error)) if error.code == "compensation::file"), "{other}");
    }
    assert!(Compensation::from_toml_bytes(b"layout_version = 1", "map.toml", &model).is_err());
}
