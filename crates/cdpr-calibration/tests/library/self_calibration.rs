//! Calibration without poses: Hangprinters of the shared data, the ranks of requirement C21, and machines without noise.

use super::support::builtin;
use cdpr_calibration::fit::{InputError, Settings, Status};
use cdpr_calibration::unobserved;
use cdpr_calibration::{Comparison, GaugeConvention, SelfCalibration, self_calibrate};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::{InternalSamples, MeasurementFile, ReadingOptions, Samples};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_testing::shared;
use nalgebra::Vector3;

/// Model and length changes of a Hangprinter, of one session or of all.
fn hangprinter(set: &str, session: Option<&str>) -> Option<(Model, InternalSamples)> {
    let read = |name: &str| shared(&format!("measurements/{set}/{name}"));
    let robot = Robot::from_toml_bytes(&read("robot.toml")?, "robot.toml").unwrap();
    let columns = (1..=4).map(|k| (format!("cable_length_change_m_{k}"), format!("length_change_{k}_in_m")));
    let options = ReadingOptions { columns: columns.collect(), skip_invalid: false };
    let text = String::from_utf8(read("samples.csv")?).unwrap();
    let is_of =
        |line: &&str| session.is_none_or(|own| line.starts_with("session") || line.starts_with(&format!("{own},")));
    let text: String = text.lines().filter(is_of).map(|line| format!("{line}\n")).collect();
    let file = MeasurementFile { bytes: text.as_bytes(), name: "samples.csv", options: &options };
    assert!(file.lacks_poses(&robot).unwrap());
    let (samples, _) = file.internal_samples(&robot).unwrap();
    assert!(samples.are_changes);
    Some((Model::new(robot, Composition::STANDARD).unwrap(), samples))
}

/// Motor angles of the Hangprinter with spools, and its five known positions where they are wanted.
fn probe(with_positions: bool) -> Option<(Model, InternalSamples)> {
    let read = |name: &str| shared(&format!("measurements/hangprinter-hp4-probe/{name}"));
    let mut robot = Robot::from_toml_bytes(&read("robot.toml")?, "robot.toml").unwrap();
    for (cable, advantage) in robot.cables.iter_mut().zip([2.0, 2.0, 2.0, 4.0]) {
        let winch = &mut cable.winch;
        (winch.radius, winch.build_up) = (Some(0.075), Some(5e-5));
        (winch.gear_ratio, winch.mechanical_advantage) = (Some(12.75), Some(advantage));
    }
    let text = String::from_utf8(read("samples.csv")?).unwrap();
    let heading: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let axis = |name: &str| name.len() == 3 && name.ends_with("_m");
    let kept = |name: &str| name.starts_with("motor_") || with_positions && axis(name);
    let kept: Vec<usize> = (0..heading.len()).filter(|&k| kept(heading[k])).collect();
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        kept.iter().map(|&k| fields[k]).collect::<Vec<_>>().join(",") + "\n"
    };
    let text: String = text.lines().map(row).collect();
    let columns = (1..=4).map(|k| (format!("motor_angle_rad_{k}"), format!("motor_{k}_in_rad"))).collect();
    let options = ReadingOptions { columns, skip_invalid: true };
    let file = MeasurementFile { bytes: text.as_bytes(), name: "samples.csv", options: &options };
    let (mut internal, _) = file.internal_samples(&robot).unwrap();
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    internal.samples = model.with_lengths(&internal.samples).unwrap().into_owned();
    Some((model, internal))
}

/// Spools, tackle and five known positions of the shared reference: 6.857 mm² from every start; without positions the size hangs on the spools'
/// growth alone, and with the growth free on nothing.
#[test]
fn spools_are_calibrated_where_positions_tell_the_scale() {
    let Some((model, internal)) = probe(true) else { return };
    let settings = Settings { starts: 40, ..Settings::default() };
    let free = "frame-anchor,drum-radius".parse().unwrap();
    let found = self_calibrate(&model, &internal, &free, &settings, &unobserved).unwrap();
    assert_eq!((found.fit.status, found.fit.starts.optima.len()), (Status::Converged, 1));
    assert!((1e6 * found.cost_m2 - 6.8572).abs() < 1e-4, "{}", found.cost_m2);
    assert_eq!((found.gauge.kind, found.gauge.free.len()), ("known", 0));
    let radii = found.fit.parameters.iter().filter(|estimate| estimate.name.starts_with("drum-radius"));
    for (estimate, (value, sigma)) in radii.zip([(75.81, 0.1), (75.94, 0.1), (75.39, 0.1), (75.20, 0.2)]) {
        // as printed
        assert!((1e3 * estimate.value - value).abs() < 0.006, "{} {}", estimate.name, estimate.value);
        assert!((1e3 * estimate.sigma.unwrap() - sigma).abs() < 0.05, "{} {:?}", estimate.name, estimate.sigma);
    }
    assert!(found.fit.warnings.iter().all(|words| !words.contains("scale")), "{:?}", found.fit.warnings);

    let (model, internal) = probe(false).unwrap();
    let calibrate = |free: &str| {
        self_calibrate(&model, &internal, &free.parse().unwrap(), &Settings::default(), &unobserved).unwrap()
    };
    let trap = calibrate("frame-anchor,drum-radius");
    let words = &trap.fit.warnings[0];
    assert!(words.starts_with("scale hangs on a hair") && words.contains("one known distance"), "{words}");
    assert_eq!(trap.gauge.free, ["translation", "rotation", "mirror"]);
    let open = calibrate("frame-anchor,drum-radius,spool-build-up");
    assert_eq!(open.gauge.free, ["translation", "rotation", "mirror", "scale"]);
    assert_eq!(open.gauge.held.last().unwrap(), "frame-anchor[4].z");
    // one distance measured by tape brings the size back
    let mut known = internal.clone();
    let anchors: Vec<Vector3<f64>> = found.fit.model.robot().cables.iter().map(|cable| cable.frame_anchor).collect();
    let distance = (anchors[0] - anchors[1]).norm();
    known.facts = vec![format!("distance[1,2]={distance}+-0.002").parse().unwrap()];
    let free = "frame-anchor,drum-radius".parse().unwrap();
    let cured = self_calibrate(&model, &known, &free, &Settings::default(), &unobserved).unwrap();
    assert!(cured.fit.warnings.iter().all(|words| !words.contains("scale")), "{:?}", cured.fit.warnings);
    let sizes = |robot: &Robot| distances(robot).iter().sum::<f64>();
    let [shrunk, restored, whole] = [&trap, &cured, &found].map(|found| sizes(found.fit.model.robot()));
    println!("size {} of the true one, {} with one distance", shrunk / whole, restored / whole);
    assert!(shrunk / whole < 0.75 && (restored / whole - 1.0).abs() < 0.03);
    let radius = |found: &SelfCalibration| 1e3 * found.fit.model.robot().cables[0].winch.radius.unwrap();
    assert!((radius(&cured) - 75.8).abs() < 2.0, "{} mm", radius(&cured));
    let held = calibrate("frame-anchor");
    assert!(held.fit.warnings.iter().all(|words| !words.contains("scale")), "{:?}", held.fit.warnings);
}

fn calibrated(set: &str, session: Option<&str>, starts: u32) -> Option<SelfCalibration> {
    let (model, samples) = hangprinter(set, session)?;
    let settings = Settings { starts, ..Settings::default() };
    Some(self_calibrate(&model, &samples, &"frame-anchor".parse().unwrap(), &settings, &unobserved).unwrap())
}

#[track_caller]
fn assert_cost(found: &SelfCalibration, expected_mm2: f64, digits: f64) {
    let cost = 1e6 * found.cost_m2;
    assert!(
        (cost - expected_mm2).abs() < digits,
        "{cost} instead of {expected_mm2} mm²: {:?}",
        found.fit.starts.optima
    );
}

/// Reference results of a SciPy program and of the authors (session 2); digits as they state them.
#[test]
fn hangprinters_are_calibrated_from_length_changes_alone() {
    let of = |session: Option<&str>, starts: u32| calibrated("hangprinter-hp3", session, starts);
    let Some(second) = of(Some("2"), 1) else { return };
    assert_cost(&second, 0.25490, 1e-5);
    let anchors =
        [[0.0, -1164.31, -143.53], [998.78, 585.33, -114.98], [-977.11, 518.88, -105.60], [0.0, 0.0, 2874.87]];
    for (cable, expected) in second.fit.model.robot().cables.iter().zip(anchors) {
        let away = (1e3 * cable.frame_anchor - Vector3::from(expected)).amax();
        assert!(away < 0.05, "{away} mm: {}", cable.frame_anchor);
    }
    assert_eq!((second.parameter_count, second.fit.analysis.rank, second.fit.parameters.len()), (12, 9, 9));
    assert_eq!(second.gauge.held, ["frame-anchor[1].x", "frame-anchor[4].x", "frame-anchor[4].y"]);
    assert_eq!(second.gauge.motions, ["turn about x", "turn about y", "turn about z"]);
    assert!(second.gauge.free == ["translation", "rotation", "mirror"] && second.gauge.at_origin);
    assert_cost(&of(Some("1"), 1).unwrap(), 9.4347, 1e-4);
    assert_cost(&of(Some("3"), 20).unwrap(), 24.4415, 1e-4);
    let all = of(None, 1).unwrap();
    assert_cost(&all, 133.2173, 1e-4);
    let last = all.fit.parameters.last().unwrap();
    let sigma = 1e3 * last.sigma.unwrap();
    assert!(last.name == "frame-anchor[4].z" && (sigma / 45.0 - 1.0).abs() < 0.1, "{}: {sigma} mm", last.name);
}

/// From the hand-measured start and from random ones.
#[test]
fn the_older_hangprinter_has_one_best_optimum() {
    let Some(one) = calibrated("hangprinter-hp2", None, 1) else { return };
    let many = calibrated("hangprinter-hp2", None, 40).unwrap();
    println!("{:?} {:?}", one.fit.starts.optima, many.fit.starts.optima);
    assert_cost(&one, 221.392, 1e-3);
    assert_cost(&many, 221.392, 1e-3);
}

/// Lengths of a model at poses, without noise.
pub(super) fn exact(model: &Model, poses: &[Pose]) -> Samples {
    let length = |pose: &Pose, cable: usize| model.recorded_length(cable, model.path(cable, pose).unwrap().0.length);
    let m = model.cable_count();
    let lengths = poses.iter().flat_map(|pose| (0..m).map(move |cable| length(pose, cable))).collect();
    Samples { poses: poses.to_vec(), lengths, cable_count: m, ..Samples::default() }
}

/// Generic poses about the home pose, by a sequence that fills their box.
pub(super) fn generic(model: &Model, count: usize, (range, turn): (f64, f64)) -> Vec<Pose> {
    let home = model.robot().home_or_middle();
    let fraction = |sample: usize, direction: usize| {
        let irrational = [2.0_f64, 3.0, 5.0, 7.0, 11.0, 13.0][direction].sqrt();
        2.0 * ((sample + 1) as f64 * irrational).fract() - 1.0
    };
    let pose = |sample: usize| {
        let twist: Twist = (model.twist_basis().iter().enumerate())
            .map(|(k, twist)| {
                twist * fraction(sample, k) * if twist.fixed_rows::<3>(3).norm() > 0.0 { turn } else { range }
            })
            .sum();
        home.displaced(&twist)
    };
    (0..count).map(pose).collect()
}

/// Parameters, rank and number of gauge motions of lengths at unknown poses.
fn ranks(model: &Model, poses: &[Pose], known: &[bool], free: &str) -> [usize; 3] {
    let mut internal = InternalSamples::without_poses(exact(model, poses), model.dof(), false);
    internal.known.iter_mut().for_each(|own| own.copy_from_slice(known));
    internal.samples.sigmas.rotation = Some(0.0);
    let settings = Settings::default();
    let found = self_calibrate(model, &internal, &free.parse().unwrap(), &settings, &unobserved).unwrap();
    [found.parameter_count, found.fit.analysis.rank, found.gauge.motions.len()]
}

/// Requirement C21, the rows of rigid models: ranks of an independent program.
#[test]
fn ranks_and_gauges_are_those_of_the_requirement() {
    let planar = Model::new(builtin("planar-example"), Composition::STANDARD).unwrap();
    let poses = |count: usize| generic(&planar, count, (1.5, 0.0));
    let unknown = [false; 2];
    assert_eq!(ranks(&planar, &poses(3), &unknown, "frame-anchor"), [8, 5, 3]);
    assert_eq!(ranks(&planar, &poses(5), &unknown, "frame-anchor,length-offset"), [12, 9, 3]);
    assert_eq!(ranks(&planar, &poses(12), &unknown, "frame-anchor,length-offset,length-scale"), [16, 12, 4]);

    let spatial = builtin("cablerobot-simulator-helicopter-kinematic-calibrated");
    let spatial = Model::new(spatial, Composition::STANDARD).unwrap();
    let poses = |count: usize| generic(&spatial, count, (1.2, 0.35));
    let unknown = [false; 6];
    assert_eq!(ranks(&spatial, &poses(18), &unknown, "frame-anchor,platform-anchor"), [48, 36, 12]);
    assert_eq!(ranks(&spatial, &poses(22), &unknown, "frame-anchor,platform-anchor,length-offset"), [56, 44, 12]);
    let all = "frame-anchor,platform-anchor,length-offset,length-scale";
    assert_eq!(ranks(&spatial, &poses(60), &unknown, all), [64, 51, 13]);
    assert_eq!(ranks(&spatial, &poses(30), &unknown, "frame-anchor"), [24, 18, 6]);
    assert_eq!(ranks(&spatial, &poses(30), &unknown, "frame-anchor,length-offset"), [32, 26, 6]);

    // orientations are known and all the same: only a − b counts
    let upright = generic(&spatial, 30, (1.2, 0.0));
    let turns_known = [false, false, false, true, true, true];
    assert_eq!(ranks(&spatial, &upright, &turns_known, "frame-anchor")[..2], [24, 18]);
    assert_eq!(ranks(&spatial, &upright, &turns_known, "frame-anchor,length-offset")[..2], [32, 26]);
    // the same, not known
    assert_eq!(ranks(&spatial, &upright, &unknown, "frame-anchor,platform-anchor")[..2], [48, 14]);
}

fn elastic_planar() -> Robot {
    let mut robot = builtin("planar-example");
    let stiffness = Some(cdpr_model::robot::CableStiffness::Axial(2e5));
    robot.cables.iter_mut().for_each(|cable| cable.stiffness = stiffness);
    robot
}

/// Five lines to a point.
pub(super) fn five_lines() -> Robot {
    lines(5)
}

fn lines(count: usize) -> Robot {
    let anchors = [[0.0, -1.2, -0.1], [1.1, -0.3, 0.0], [0.7, 1.0, -0.2], [-0.9, 0.8, -0.05], [0.1, 0.05, 2.6]];
    let cable = |(name, anchor): (char, [f64; 3])| {
        format!("[[cable]]\nname = \"{name}\"\nframe_anchor_m = {anchor:?}\nplatform_anchor_m = [0.0, 0.0, 0.0]\n")
    };
    let cables: String = ('A'..).zip(anchors).take(count).map(cable).collect();
    let head = format!("layout_version = 1\nname = \"lines\"\nmotion_pattern = \"3T\"\ncable_count = {count}\n");
    Robot::from_toml(&format!("{head}[home_pose]\nposition_m = [0.0, 0.0, 0.3]\n{cables}"), "lines.toml").unwrap()
}

fn changes(samples: &Samples, model: &Model) -> InternalSamples {
    let origin = exact(model, &[Pose::identity()]).lengths;
    let lengths = samples.lengths.iter().zip(origin.iter().cycle()).map(|(length, origin)| length - origin).collect();
    InternalSamples::without_poses(Samples { lengths, ..samples.clone() }, model.dof(), true)
}

/// Distances of all pairs of anchors, which no gauge changes (m).
fn distances(robot: &Robot) -> Vec<f64> {
    let anchors = || robot.cables.iter().map(|cable| cable.frame_anchor);
    anchors().flat_map(|a| anchors().map(move |b| (a - b).norm())).collect()
}

/// Conventions of the gauge: the same robot up to a motion, anchors nearest to the file's, deviations no larger in all; and what fixes nothing is refused.
#[test]
fn conventions_of_the_gauge_move_the_same_robot() {
    let truth = Model::new(five_lines(), Composition::STANDARD).unwrap();
    let internal = InternalSamples::without_poses(exact(&truth, &generic(&truth, 20, (0.5, 0.0))), 3, false);
    let mut start = five_lines();
    start.cables.iter_mut().enumerate().for_each(|(k, cable)| cable.frame_anchor.y += 0.05 * ((k * k) as f64).sin());
    let model = Model::new(start.clone(), Composition::STANDARD).unwrap();
    let calibrate = |gauge| {
        let settings = Settings { gauge, ..Settings::default() };
        self_calibrate(&model, &internal, &"frame-anchor".parse().unwrap(), &settings, &unobserved)
    };
    let held = calibrate(GaugeConvention::Anchors).unwrap();
    let least = calibrate(GaugeConvention::LeastChange).unwrap();
    assert_eq!((held.gauge.kind, least.gauge.kind), ("anchors", "least-change"));
    assert_eq!((least.parameter_count, least.fit.analysis.rank, least.fit.parameters.len()), (15, 9, 15));
    assert_eq!(held.fit.analysis.rank, 9);
    assert!(least.gauge.held.is_empty() && least.gauge.motions == held.gauge.motions);
    let change = |found: &SelfCalibration| {
        let pairs = found.fit.model.robot().cables.iter().zip(&start.cables);
        pairs.map(|(new, old)| (new.frame_anchor - old.frame_anchor).norm_squared()).sum::<f64>().sqrt()
    };
    // the least change of all rigid motions is the one that Procrustes finds
    let compared = |found: &SelfCalibration, other: &Robot| Comparison::of(&found.fit.model, other, false).unwrap();
    let best = compared(&held, &start).rms_m * (5.0_f64).sqrt();
    assert!((change(&least) - best).abs() < 1e-9 && change(&held) > best + 1e-3, "{} {best}", change(&least));
    for found in [&held, &least] {
        let comparison = compared(found, truth.robot());
        assert!(comparison.rms_m < 1e-8 && (comparison.scale - 1.0).abs() < 1e-8, "{comparison:?}");
    }
    let refused = calibrate(GaugeConvention::Known).unwrap_err();
    assert!(refused.to_string().contains("shift along x, shift along y, shift along z"), "{refused}");
}

/// Walls, levels, planes and distances are equations of the parameters, with derivatives that are their differences: noise-free data keep them.
#[test]
fn what_is_known_of_anchors_fixes_what_lengths_leave_open() {
    let truth = Model::new(five_lines(), Composition::STANDARD).unwrap();
    let mut internal = InternalSamples::without_poses(exact(&truth, &generic(&truth, 20, (0.5, 0.0))), 3, false);
    let height = |k: usize| truth.robot().cables[k].frame_anchor;
    let distance = (height(0) - height(4)).norm();
    internal.facts = vec![format!("distance[1,5]={distance}").parse().unwrap(), "level[1,4]+-0.2".parse().unwrap()];
    let free = "frame-anchor".parse().unwrap();
    let found = self_calibrate(&truth, &internal, &free, &Settings::default(), &unobserved).unwrap();
    // a level takes one turn away
    assert_eq!((found.gauge.motions.len(), found.gauge.held.len()), (5, 5), "{:?}", found.gauge);
    internal.facts = vec!["distance[1,9]=1".parse().unwrap()];
    let refused = self_calibrate(&truth, &internal, &free, &Settings::default(), &unobserved).unwrap_err();
    assert!(matches!(refused, InputError::Known(_)), "{refused}");
}

#[test]
fn without_noise_anchors_come_back_from_any_start() {
    let truth = Model::new(five_lines(), Composition::STANDARD).unwrap();
    let internal = changes(&exact(&truth, &generic(&truth, 20, (0.5, 0.0))), &truth);
    let mut start = five_lines();
    for (k, cable) in start.cables.iter_mut().enumerate() {
        let away = |axis: usize| 0.25 * ((k * 3 + axis) as f64 * 1.7).sin();
        cable.frame_anchor += Vector3::new(away(0), away(1), away(2));
    }
    let model = Model::new(start, Composition::STANDARD).unwrap();
    let settings = Settings { starts: 8, ..Settings::default() };
    let found = self_calibrate(&model, &internal, &"frame-anchor".parse().unwrap(), &settings, &unobserved).unwrap();
    assert_eq!(found.fit.status, Status::Converged, "{}", found.fit.reason);
    let pairs = distances(found.fit.model.robot()).into_iter().zip(distances(truth.robot()));
    let worst = pairs.map(|(found, truth)| (found - truth).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-9, "{worst} m");
}

/// Intervals of 95 % hold the truth, pooled over parameters of 200 calibrations with 0.5 mm of noise; the file has the true anchors, which the gauge keeps.
#[test]
fn intervals_hold_the_truth() {
    use rand::SeedableRng;
    use rand_distr::{Distribution, Normal};
    let model = Model::new(five_lines(), Composition::STANDARD).unwrap();
    let clean = changes(&exact(&model, &generic(&model, 30, (0.5, 0.0))), &model);
    let noise = Normal::new(0.0, 5e-4).unwrap();
    let mut generator = rand_chacha::ChaCha8Rng::seed_from_u64(20);
    let (mut inside, mut count) = (0, 0);
    for _ in 0..200 {
        let mut internal = clean.clone();
        internal.samples.lengths.iter_mut().for_each(|length| *length += noise.sample(&mut generator));
        let settings = Settings::default();
        let found =
            self_calibrate(&model, &internal, &"frame-anchor".parse().unwrap(), &settings, &unobserved).unwrap();
        for estimate in &found.fit.parameters {
            inside += usize::from(estimate.change.abs() <= 1.96 * estimate.sigma.unwrap());
            count += 1;
        }
    }
    let fraction = inside as f64 / count as f64;
    println!("{fraction}");
    assert!((0.93..=0.97).contains(&fraction), "{fraction}");
}

/// One end of every refusal.
#[test]
fn what_no_lengths_can_tell_is_refused_in_words() {
    let refused = |robot: Robot, composition: Composition, free: &str| {
        let model = Model::new(robot, composition).unwrap();
        let poses = generic(&model, 4, (0.1, 0.1));
        let internal = InternalSamples::without_poses(exact(&model, &poses), model.dof(), false);
        self_calibrate(&model, &internal, &free.parse().unwrap(), &Settings::default(), &unobserved).unwrap_err()
    };
    let three = refused(lines(3), Composition::STANDARD, "frame-anchor");
    assert!(matches!(three, InputError::NoEquationLeft { rows: 3, unknowns: 3, .. }), "{three}");
    // lengths and equilibrium tell pose and tensions, and nothing else
    let elastic = refused(elastic_planar(), Composition::ELASTIC, "frame-anchor");
    assert!(matches!(elastic, InputError::NoEquationLeft { rows: 6, unknowns: 6, .. }), "{elastic}");
    let few = refused(five_lines(), Composition::STANDARD, "frame-anchor,length-offset");
    assert!(matches!(few, InputError::TooFewEquations { equations: 8, samples: 4, .. }), "{few}");
}
