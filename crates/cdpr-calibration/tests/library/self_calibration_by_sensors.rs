//! Calibration without poses by all sensors of a machine: tensions of a known load, swivel angles, an inclinometer; ranks of requirement C21 and the
//! IRMA4U of the University of Bologna.

use super::support::builtin;
use cdpr_calibration::fit::{InputError, Settings, Status};
use cdpr_calibration::unobserved;
use cdpr_calibration::{Evaluation, SelfCalibration, evaluate_lengths, self_calibrate};
use cdpr_model::equilibrium::elastostatics::{Settings as Forward, Solver, Status as Found};
use cdpr_model::geometry::{Pose, Twist};
use cdpr_model::measurement::{InternalSamples, MeasurementFile, ReadingOptions, Samples};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_model::statics::{Load, controlled_lengths};
use cdpr_testing::{property, shared};
use nalgebra::{DVector, Vector3};

const PULLEYS: Composition = Composition { pulley: true, ..Composition::STANDARD };

/// Irrational steps that fill a box evenly, in −1 to 1.
fn fraction(sample: usize, direction: usize) -> f64 {
    let irrational = [2.0_f64, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0][direction % 8].sqrt();
    2.0 * ((sample + 1) as f64 * irrational * (1 + direction / 8) as f64).fract() - 1.0
}

/// Lengths and tensions at poses about home, in equilibrium with the load, without noise.
fn tensed(model: &Model, count: usize, (range, turn): (f64, f64)) -> InternalSamples {
    let (robot, m) = (model.robot(), model.cable_count());
    let (home, load) = (robot.home_or_middle(), Load::of(robot).unwrap());
    let mut samples = Samples { cable_count: m, tensions: Some(Vec::new()), ..Samples::default() };
    for sample in 0..count {
        let twist: Twist = (model.twist_basis().iter().enumerate())
            .map(|(k, twist)| {
                twist * fraction(sample, k) * if twist.fixed_rows::<3>(3).norm() > 0.0 { turn } else { range }
            })
            .sum();
        let pose = home.displaced(&twist);
        let matrix = model.structure_matrix(&pose).unwrap();
        // the next tensions in equilibrium to some that vary from sample to sample
        let wished = DVector::from_fn(m, |cable, _| 3000.0 + 800.0 * fraction(sample, 3 + cable));
        let missing = &matrix * &wished + load.in_pattern(model, &pose);
        let tensions = wished - matrix.clone().pseudo_inverse(1e-12).unwrap() * missing;
        let lengths = controlled_lengths(model, &pose, tensions.as_slice()).unwrap();
        samples.lengths.extend(lengths.iter().enumerate().map(|(cable, q)| model.recorded_length(cable, *q)));
        samples.tensions.as_mut().unwrap().extend(tensions.iter());
        samples.poses.push(pose);
    }
    InternalSamples::without_poses(samples, model.dof(), false)
}

/// Parameters, rank and motions that nothing tells.
fn ranks(model: &Model, internal: &InternalSamples, free: &str) -> [usize; 3] {
    let found = self_calibrate(model, internal, &free.parse().unwrap(), &Settings::default(), &unobserved).unwrap();
    assert!(found.fit.status != Status::NotConverged, "{free}: {}", found.fit.reason);
    [found.parameter_count, found.fit.analysis.rank, found.parameter_count - found.fit.parameters.len()]
}

/// Poses with orientations that an inclinometer measures.
fn inclined(internal: &InternalSamples) -> InternalSamples {
    let mut internal = internal.clone();
    internal.known.iter_mut().for_each(|known| known[3..].fill(true));
    internal.samples.poses.iter_mut().for_each(|pose| pose.position = Vector3::zeros());
    internal.samples.sigmas.rotation = Some(1e-3);
    internal
}

/// Requirement C21: eight cables with recorded lengths and tensions.
#[test]
fn ranks_of_eight_tensed_cables_are_those_of_the_requirement() {
    let robot = builtin("cablerobot-simulator-helicopter-elastostatic-calibrated");
    let model = Model::new(robot, Composition::ELASTIC).unwrap();
    let internal = tensed(&model, 30, (1.0, 0.3));
    assert_eq!(ranks(&model, &internal, "frame-anchor,platform-anchor"), [48, 42, 6]);
    assert_eq!(ranks(&model, &internal, "frame-anchor,platform-anchor,wrench"), [54, 45, 9]);
    assert_eq!(ranks(&model, &internal, "frame-anchor,platform-anchor,compliance,wrench"), [62, 53, 9]);
    let with_offset = "frame-anchor,platform-anchor,compliance,wrench,length-offset";
    assert_eq!(ranks(&model, &internal, with_offset), [70, 61, 9]);
    let all = "frame-anchor,platform-anchor,compliance,wrench";
    assert_eq!(ranks(&model, &inclined(&internal), all), [62, 59, 3]);
}

fn irma(name: &str) -> Option<Robot> {
    let file = format!("{name}.toml");
    Some(Robot::from_toml_bytes(&shared(&format!("robots/{file}"))?, &file).unwrap())
}

/// A platform that hangs still from four cables: lengths and tensions of equilibria without noise.
fn hanging(model: &Model, count: usize) -> InternalSamples {
    let (robot, m) = (model.robot(), model.cable_count());
    let (home, load) = (robot.home_or_middle(), Load::of(robot).unwrap());
    let mut solver = Solver::new(model, &load, &Forward::default()).unwrap();
    let mut samples = Samples { cable_count: m, tensions: Some(Vec::new()), ..Samples::default() };
    for sample in 0.. {
        if samples.poses.len() == count {
            break;
        }
        let shift = Vector3::new(fraction(sample, 0), fraction(sample, 1), fraction(sample, 2)) * 0.4;
        let near = Pose { position: home.position + shift, ..home };
        let lengths: Vec<f64> = (0..m)
            .map(|cable| model.path(cable, &near).unwrap().0.length + 0.02 * fraction(sample, 3 + cable))
            .collect();
        let solution = solver.solve(&lengths, &near).unwrap();
        if solution.status != Found::Converged || solution.tensions.iter().any(|tension| *tension < 5.0) {
            continue;
        }
        samples.lengths.extend(lengths);
        samples.tensions.as_mut().unwrap().extend(&solution.tensions);
        samples.poses.push(solution.pose);
    }
    InternalSamples::without_poses(samples, model.dof(), false)
}

/// Requirement C21: fewer cables than degrees of freedom, held by a known weight.
#[test]
fn ranks_of_a_hanging_platform_are_those_of_the_requirement() {
    let Some(robot) = irma("irma4u-mar25") else { return };
    let model = Model::new(robot.clone(), Composition::STANDARD).unwrap();
    let internal = hanging(&model, 24);
    assert_eq!(ranks(&model, &internal, "length-offset"), [4, 4, 0]);
    assert_eq!(ranks(&model, &internal, "frame-anchor"), [12, 8, 4]);
    assert_eq!(ranks(&model, &internal, "frame-anchor,length-offset"), [16, 12, 4]);
    assert_eq!(ranks(&model, &internal, "frame-anchor,platform-anchor"), [24, 17, 7]);
    assert_eq!(ranks(&model, &internal, "frame-anchor,platform-anchor,length-offset"), [28, 21, 7]);
    let with_angles = inclined(&internal);
    assert_eq!(ranks(&model, &with_angles, "frame-anchor,platform-anchor,length-offset"), [28, 25, 3]);
    // lengths alone
    let alone = InternalSamples { samples: Samples { tensions: None, ..internal.samples.clone() }, ..internal };
    let refused = self_calibrate(&model, &alone, &"frame-anchor".parse().unwrap(), &Settings::default(), &unobserved);
    let refused = refused.unwrap_err();
    assert!(matches!(refused, InputError::NoEquationLeft { rows: 4, unknowns: 6, .. }), "{refused}");
    assert!(refused.to_string().contains("no equation is left"), "{refused}");
}

/// Lengths, tensions and swivels of a run at rest.
fn run(model: &Model, name: &str) -> Option<InternalSamples> {
    let bytes = shared(&format!("measurements/{name}/static-poses.csv"))?;
    let options = ReadingOptions::default();
    let file = MeasurementFile { bytes: &bytes, name: "static-poses.csv", options: &options };
    assert!(file.lacks_poses(model.robot()).unwrap());
    let (internal, _) = file.internal_samples(model.robot()).unwrap();
    assert!(internal.swivels.is_some() && internal.samples.tensions.is_some());
    Some(internal)
}

const RUNS: [&str; 3] = ["irma4u-selfcalib-27-medium-a", "irma4u-selfcalib-8-medium-a", "irma4u-selfcalib-8-final"];

fn told(name: &str, errors: &Evaluation) -> (f64, f64) {
    let blocks = errors.blocks();
    let (length, swivel) = (1e3 * blocks.length_error_m.rms, blocks.swivel_error.unwrap().rms.to_degrees());
    println!("{name}: lengths {length:.3} mm rms, swivels {swivel:.3}°");
    (length, swivel)
}

/// The published geometry, and one calibrated on another run: lengths ≤ 0.6 mm and swivels ≤ 0.5°.
#[test]
fn one_run_of_a_hanging_robot_calibrates_it_for_the_others() {
    let Some(robot) = irma("irma4u-mar25") else { return };
    let model = Model::new(robot, PULLEYS).unwrap();
    let runs: Vec<InternalSamples> = RUNS.map(|name| run(&model, name).unwrap()).into();
    // as the requirement has it: 0.78 mm and 0.79°
    let (length, swivel) = told("as published", &evaluate_lengths(&model, &runs[2]).unwrap());
    assert!((0.7..0.85).contains(&length) && (0.7..0.85).contains(&swivel));
    for (free, first) in [("frame-anchor", 0), ("frame-anchor,tension-scale,tension-offset", 1)] {
        let start = std::time::Instant::now();
        let found =
            self_calibrate(&model, &runs[first], &free.parse().unwrap(), &Settings::default(), &unobserved).unwrap();
        println!("{free} from {}: {:?} {}", RUNS[first], start.elapsed(), found.fit.reason);
        println!("{:?} {:?}", found.gauge, found.fit.warnings);
        found.sensors.iter().for_each(|fit| println!("{fit:?}"));
        for other in (0..3).filter(|other| *other != first) {
            let (length, swivel) = told(RUNS[other], &evaluate_lengths(&found.fit.model, &runs[other]).unwrap());
            assert!(length <= 0.6 && swivel <= 0.5);
        }
    }
}

/// Bologna's question: lengths that count from an unknown pose, with tensions and swivels; the winches' zeros come out.
#[test]
fn tensions_and_swivels_tell_where_the_winches_started() {
    let Some(robot) = irma("irma4u-mar25") else { return };
    let model = Model::new(robot, PULLEYS).unwrap();
    let mut internal = run(&model, RUNS[0]).unwrap();
    let first: Vec<f64> = internal.samples.lengths_of(0).to_vec();
    internal.samples.lengths.iter_mut().zip(first.iter().cycle()).for_each(|(length, first)| *length -= first);
    internal.are_changes = true;
    let calibrate =
        |free: &str| self_calibrate(&model, &internal, &free.parse().unwrap(), &Settings::default(), &unobserved);
    assert_eq!(calibrate("frame-anchor").unwrap_err(), InputError::ChangesBesideSensors);
    let found = calibrate("length-offset,tension-scale,tension-offset").unwrap();
    println!("{} {:?}", found.fit.reason, found.fit.warnings);
    for (cable, first) in found.fit.model.robot().cables.iter().zip(&first) {
        let away = -cable.length_offset.unwrap() - first;
        println!("{} mm", 1e3 * away);
        assert!(away.abs() < 0.02, "{away} m");
    }
}

/// Without noise the zeros of winches and load cells come out whole, from lengths that count from the first sample.
#[test]
fn without_noise_zeros_of_winches_and_load_cells_come_out() {
    let Some(robot) = irma("irma4u-mar25") else { return };
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let mut internal = hanging(&model, 20);
    let first: Vec<f64> = internal.samples.lengths_of(0).to_vec();
    internal.samples.lengths.iter_mut().zip(first.iter().cycle()).for_each(|(length, first)| *length -= first);
    internal.samples.tensions.as_mut().unwrap().iter_mut().for_each(|tension| *tension = 1.1 * *tension + 2.0);
    internal.are_changes = true;
    let free = "length-offset,tension-scale,tension-offset".parse().unwrap();
    let found = self_calibrate(&model, &internal, &free, &Settings::default(), &unobserved).unwrap();
    assert_eq!(found.fit.status, Status::Converged, "{}", found.fit.reason);
    for (cable, first) in found.fit.model.robot().cables.iter().zip(&first) {
        let zeros = [cable.length_offset.unwrap() + first, cable.tension_scale.unwrap() - 1.1];
        assert!(zeros.iter().all(|away| away.abs() < 1e-6), "{zeros:?}");
        assert!((cable.tension_offset.unwrap() - 2.0).abs() < 1e-4, "{:?}", cable.tension_offset);
    }
}

/// Two runs of a planar engraver at one pose each, with four loads: equilibrium alone determines no load cell, bench values as prior do.
#[test]
fn load_cells_are_tared_only_beside_bench_values() {
    let Some(bytes) = shared("robots/laser-engraver-planar.toml") else { return };
    let mut robot = Robot::from_toml_bytes(&bytes, "laser-engraver-planar.toml").unwrap();
    let bench = [(4.558, 0.04138), (4.804, 0.04071), (-3.449, 0.03961), (-7.385, 0.04032)];
    for (cable, (newtons, per_count)) in robot.cables.iter_mut().zip(bench) {
        // f = offset + scale · counts
        (cable.tension_scale, cable.tension_offset) = (Some(1.0 / per_count), Some(-newtons / per_count));
    }
    let bytes = shared("measurements/laser-engraver-loadcell/static-loads.csv").unwrap();
    let columns = (1..=4).map(|k| (format!("tension_N_{k}"), format!("load_cell_counts_{k}"))).collect();
    let options = ReadingOptions { columns, skip_invalid: false };
    let file = MeasurementFile { bytes: &bytes, name: "static-loads.csv", options: &options };
    let (mut internal, _) = file.internal_samples(&robot).unwrap();
    assert_eq!(internal.masses.as_ref().unwrap()[1], 2.751);
    // lengths by hand and poses of one run each: what lengths say of a pose is not what forces are to change
    internal.samples.sigmas.length = Some(1e-4);
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let calibrate = |priors: &[&str]| {
        let priors = priors.iter().map(|prior| prior.parse().unwrap()).collect();
        let settings = Settings { priors, ..Settings::default() };
        self_calibrate(&model, &internal, &"tension-scale,tension-offset".parse().unwrap(), &settings, &unobserved)
            .unwrap()
    };
    let scales = |found: &SelfCalibration| {
        found.fit.model.robot().cables.iter().map(|cable| 1.0 / cable.tension_scale.unwrap()).collect::<Vec<f64>>()
    };
    let told = |found: &SelfCalibration| {
        let tension = found.sensors.iter().find(|fit| fit.sensor == "tension").unwrap();
        println!("{} {:?} {:?} {}", found.fit.reason, scales(found), tension, found.fit.analysis.condition_scaled);
        println!("{:?}", found.fit.warnings);
        tension.rms * 0.0405
    };
    let alone = calibrate(&[]);
    told(&alone);
    // 44.6 where equilibrium is counted in what the cells miss, rows (AᵀA)^−½ (Aᵀ f + w); the reference's 148.2 counts a N·m as a N
    let condition = alone.fit.analysis.condition_scaled;
    assert!((43.0..47.0).contains(&condition), "{condition}");
    assert!(alone.fit.warnings.iter().any(|words| words.contains("load cells are not determined")));
    // 3 N and 2.5 % of the bench
    let beside = calibrate(&["tension-scale=0.62", "tension-offset=74"]);
    let rms = told(&beside);
    assert!(beside.fit.warnings.iter().all(|words| !words.contains("load cells are not determined")));
    println!("{rms} N");
    // per cell; the reference's 1.9 N are per row of equilibrium, N and N·m alike, 1.6 N with rows as above
    assert!((1.2..1.6).contains(&rms), "{rms}");
    for (found, expected) in scales(&beside).into_iter().zip([0.0402, 0.0399, 0.0385, 0.0413]) {
        // the reference weighs equilibrium and bench otherwise
        assert!((found / expected - 1.0).abs() < 0.035, "{found} {expected}");
    }
}

/// Intervals of 95 % hold the truth, pooled over the parameters of calibrations by lengths, tensions and swivels with noise;
/// a soak draws four times as many, 280.
#[test]
fn intervals_of_all_sensors_hold_the_truth() {
    use rand::SeedableRng;
    use rand_distr::{Distribution, Normal};
    let Some(robot) = irma("irma4u-mar25") else { return };
    let model = Model::new(robot, Composition::STANDARD).unwrap();
    let mut clean = hanging(&model, 20);
    let gravity = model.robot().gravity.unwrap();
    let pulleys = Model::new(model.robot().clone(), PULLEYS).unwrap();
    let angle = |pose: &Pose, cable: usize| pulleys.swivel_angle(cable, pose, &gravity).unwrap();
    clean.swivels = Some(
        clean.samples.poses.iter().flat_map(|pose| (0..4).map(move |k| (pose, k))).map(|(p, k)| angle(p, k)).collect(),
    );
    clean.samples.poses.iter_mut().for_each(|pose| *pose = Pose::identity());
    let sigmas = &mut clean.samples.sigmas;
    (sigmas.length, sigmas.tension, sigmas.swivel) = (Some(5e-4), Some(0.5), Some(5e-3));
    let mut generator = rand_chacha::ChaCha8Rng::seed_from_u64(21 + property::first_seed());
    let [of_length, of_tension, of_swivel] = [5e-4, 0.5, 5e-3].map(|sigma| Normal::new(0.0, sigma).unwrap());
    let (mut inside, mut count) = (0, 0);
    let settings = Settings::default();
    for run in 0..property::sample(70) {
        let mut internal = clean.clone();
        internal.samples.lengths.iter_mut().for_each(|value| *value += of_length.sample(&mut generator));
        let tensions = internal.samples.tensions.iter_mut().flatten();
        tensions.for_each(|value| *value += of_tension.sample(&mut generator));
        internal.swivels.iter_mut().flatten().for_each(|value| *value += of_swivel.sample(&mut generator));
        let free = ["length-offset,tension-scale", "frame-anchor,tension-scale"][run % 2].parse().unwrap();
        let found = self_calibrate(&model, &internal, &free, &settings, &unobserved).unwrap();
        for estimate in &found.fit.parameters {
            inside += usize::from(estimate.change.abs() <= 1.96 * estimate.sigma.unwrap());
            count += 1;
        }
    }
    let fraction = inside as f64 / count as f64;
    println!("{fraction} of {count}");
    // of 700 and more intervals: a standard deviation of at most 0.8 %
    assert!((0.93..=0.97).contains(&fraction), "{fraction}");
}
