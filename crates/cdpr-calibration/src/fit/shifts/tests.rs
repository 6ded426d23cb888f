//! Steps and drifts of recorded lengths, with their deviations, beside geometry, frames, clocks and elasticity.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal};

use crate::fit::{Fit, InputError, Settings, Status, fit};
use crate::recorded_curves::{curve, points};
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::{Samples, SensorSigmas};
use cdpr_model::model::{Composition, Model};
use cdpr_model::robot::Robot;
use cdpr_model::statics::Load;
use cdpr_model::tension::{Limits, closed_form};

const COUNT: usize = 60;
const NOISE: f64 = 1e-3;
const STEP: f64 = 0.02;
/// Ten-thousandth of a deviation (1 to 2 mm), at which the search ends, twice.
const EXACT: f64 = 4e-7;

/// A record whose cable 3 reads 20 mm more from line 32 on and whose cable 5 drifts by −20 mm, with noise of the lengths.
fn record(model: &Model, seed: u64, noise: f64) -> Samples {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let normal = Normal::new(0.0, noise).unwrap();
    let poses = curve(model, COUNT, 1.0);
    let exact = poses.iter().flat_map(|pose| model.cable_lengths(pose).unwrap());
    let lengths = exact.enumerate().map(|(index, length)| {
        let (sample, cable) = (index / 8, index % 8);
        let step = if cable == 2 && sample >= 30 { STEP } else { 0.0 };
        let drift = if cable == 4 { -STEP * sample as f64 / (COUNT - 1) as f64 } else { 0.0 };
        length + step + drift + normal.sample(&mut random)
    });
    let sigmas =
        SensorSigmas { length: Some(NOISE), position: Some(1e-5), rotation: Some(1e-6), ..SensorSigmas::default() };
    let lengths = lengths.collect();
    let time = Some((0..COUNT).map(|sample| 0.5 * sample as f64).collect());
    let lines = Some((2..COUNT + 2).collect());
    Samples { poses, lengths, cable_count: 8, time, lines, sigmas, ..Samples::default() }
}

fn found(samples: &Samples, free: &str) -> Result<Fit, InputError> {
    fit(&points(), samples, &free.parse().unwrap(), &Settings::default())
}

#[test]
fn exact_data_have_exact_shifts() {
    let samples = record(&points(), 0, 0.0);
    for free in ["length-offset", "frame-anchor,length-offset", "frame-anchor,length-offset,length-scale"] {
        let fit = found(&samples, &format!("{free},length-offset[3]@32,length-drift[5]")).unwrap();
        assert_eq!(fit.status, Status::Converged, "{}", fit.reason);
        let [step, drift] = fit.shifts[..] else { panic!("{:?}", fit.shifts) };
        assert!((step.change - STEP).abs() < EXACT && (drift.change + STEP).abs() < EXACT, "{free}: {:?}", fit.shifts);
        assert!((drift.rate().unwrap() + STEP / (0.5 * (COUNT - 1) as f64)).abs() < EXACT);
        assert_eq!((step.line(), step.shift.to_string().as_str()), (Some(32), "length-offset[3]@32"));
        // the file's offset is that of the end
        let offset = |cable: usize| fit.model.robot().cables[cable].length_offset.unwrap();
        assert!((offset(2) - STEP).abs() < EXACT && (offset(4) + STEP).abs() < EXACT);
        assert!(step.offset_before().abs() < EXACT && step.offset_after == offset(2));
        let after = fit.as_fitted(&samples);
        assert!((after.lengths[2] - samples.lengths[2] - STEP).abs() < EXACT);
        // another record is one after the step
        let other = fit.as_fitted(&samples.clone().of_another_record());
        assert_eq!(other.lengths, samples.lengths);
    }
}

/// A tracker that stands elsewhere hides no step.
#[test]
fn steps_are_found_beside_a_frame() {
    let mut samples = record(&points(), 0, 0.0);
    let frame = Pose::from_xyz_angles(nalgebra::Vector3::new(3.0, -2.0, 0.5), [0.02, -0.01, 0.6]);
    samples.poses.iter_mut().for_each(|pose| {
        *pose = Pose {
            position: frame.rotation * pose.position + frame.position,
            rotation: frame.rotation * pose.rotation,
        };
    });
    let fit = found(&samples, "length-offset,tracker-frame,length-offset[3]@32,length-drift[5]").unwrap();
    assert_eq!(fit.status, Status::Converged, "{}", fit.reason);
    assert!((fit.shifts[0].change - STEP).abs() < EXACT, "{:?}", fit.shifts);
    assert!((fit.shifts[1].change + STEP).abs() < EXACT, "{:?}", fit.shifts);
}

/// Errors over stated deviations of 60 records have a mean square of 1 within four of its standard errors, √(2/60), and so have those of the offset beside them.
#[test]
fn deviations_are_those_of_the_errors() {
    let model = points();
    let (mut of_step, mut of_offset) = (0.0, 0.0);
    let records = 60;
    for seed in 0..records {
        let fit = found(&record(&model, seed, NOISE), "frame-anchor,length-offset,length-offset[3]@32,length-drift[5]")
            .unwrap();
        of_step += ((fit.shifts[0].change - STEP) / fit.shifts[0].sigma).powi(2);
        let offset = fit.parameters.iter().find(|estimate| estimate.name == "length-offset[3]").unwrap();
        of_offset += ((offset.value - STEP) / offset.sigma.unwrap()).powi(2);
    }
    let band = 4.0 * (2.0 / records as f64).sqrt();
    for mean_square in [of_step, of_offset].map(|sum| sum / records as f64) {
        assert!((mean_square - 1.0).abs() < band, "{of_step} {of_offset} {mean_square}");
    }
}

#[test]
fn shifts_that_no_data_tell_are_refused() {
    let samples = record(&points(), 0, NOISE);
    for free in ["length-offset,length-offset[3]@900", "length-offset[9]@32"] {
        assert!(found(&samples, free).is_err(), "{free}");
    }
    // two steps at one line of one cable are one
    let twice = found(&samples, "length-offset,length-offset@32,length-offset[3]@32,length-drift").unwrap();
    assert_eq!(twice.shifts.len(), 16);
    let held = Settings { hold: "length-offset[1,2,4,5,6,7,8]@32".parse().unwrap(), ..Settings::default() };
    let fit = fit(&points(), &samples, &"length-offset,length-offset@32".parse().unwrap(), &held).unwrap();
    assert_eq!(fit.shifts.len(), 1);
    assert!((fit.shifts[0].change - STEP).abs() < 5.0 * fit.shifts[0].sigma);
}

/// Steps of elastic cables: lengths f = (q − q_θ)/(c q) under tensions between 1 and 9 kN that hold the load.
#[test]
fn steps_of_elastic_cables_are_found() {
    let robot = Robot::builtin("cablerobot-simulator-helicopter-elastostatic-calibrated").unwrap();
    let model = Model::new(robot, "elastic".parse().unwrap()).unwrap();
    let load = Load::of(model.robot()).unwrap();
    let near = Limits::uniform(8, 1000.0, 9000.0).unwrap();
    let mut samples = record(&model, 0, 0.0);
    let mut tensions = Vec::new();
    for (sample, pose) in samples.poses.iter().enumerate() {
        let matrix = model.structure_matrix(pose).unwrap();
        let found = closed_form::solve(&matrix, load.in_pattern(&model, pose).as_slice(), &near).unwrap();
        for (cable, tension) in found.tensions.iter().enumerate() {
            let length = model.cable_lengths(pose).unwrap()[cable];
            samples.lengths[8 * sample + cable] += model.elasticity(cable).controlled_length(length, *tension) - length;
        }
        tensions.extend(found.tensions);
    }
    samples.tensions = Some(tensions);
    samples.sigmas.tension = Some(10.0);
    let free = "length-offset,compliance,length-offset[3]@32,length-drift[5]".parse().unwrap();
    let fit = fit(&model, &samples, &free, &Settings::default()).unwrap();
    assert_eq!(fit.status, Status::Converged, "{}", fit.reason);
    assert!((fit.shifts[0].change - STEP).abs() < EXACT, "{:?}", fit.shifts);
    assert!((fit.shifts[1].change + STEP).abs() < EXACT, "{:?}", fit.shifts);
}

/// A step beside a clock 40 ms late, with 0.5 mm of noise: both within four deviations.
#[test]
fn steps_are_found_beside_a_clock() {
    let robot = Robot::builtin("planar-example").unwrap();
    let model = Model::new(robot.clone(), Composition::STANDARD).unwrap();
    let at = |t: f64| {
        robot.motion_pattern.pose(robot.plane, &[0.5 + 0.8 * (0.7 * t).sin(), 4.0 + 0.5 * (1.1 * t).cos()]).unwrap()
    };
    let (count, late) = (500, 0.04);
    let mut random = ChaCha8Rng::seed_from_u64(3);
    let normal = Normal::new(0.0, 5e-4).unwrap();
    let mut samples = Samples { cable_count: 4, lines: Some((2..count + 2).collect()), ..Samples::default() };
    let time: Vec<f64> = (0..count).map(|row| 0.02 * row as f64).collect();
    for (row, t) in time.iter().enumerate() {
        samples.poses.push(at(t - late));
        for (cable, length) in model.cable_lengths(&at(*t)).unwrap().into_iter().enumerate() {
            let step = if cable == 1 && row >= 200 { STEP } else { 0.0 };
            samples.lengths.push(length + step + normal.sample(&mut random));
        }
    }
    samples.time = Some(time);
    samples.sigmas.length = Some(5e-4);
    let free = "length-offset,clock-offset,length-offset[2]@202".parse().unwrap();
    let fit = fit(&model, &samples, &free, &Settings::default()).unwrap();
    let (clock, step) = (fit.clock_offset.unwrap(), fit.shifts[0]);
    assert!((clock.seconds - late).abs() < 4.0 * clock.sigma && clock.sigma < 1e-3, "{clock:?}");
    assert!((step.change - STEP).abs() < 4.0 * step.sigma && step.sigma < 1e-4, "{step:?}");
}
