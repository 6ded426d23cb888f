//! Laws of the sensors' rows that hold for any noise.

use std::convert::Infallible;
use std::ops::ControlFlow;

use nalgebra::Vector3;

use super::super::tests::simulator;
use super::super::{Scenario, Simulation};
use super::SensorLog;
use super::signal::{Clock, LowPass};
use cdpr_model::robot::Robot;

const START: &str = "[machine]\nrobot = \"simulator\"\n[start]\npose = [0, 0, 1.5, 0, 0, 0]\ndisplacement = [0.02, 0, 0.01, 0, 0.02, 0]\n\
                     twist = [0, 0, 0, 0, 0, 0.1]\n[time]\nduration_s = 0.6\n";

/// Logs of a scenario, and the states of every step.
fn run(text: &str, robot: Robot) -> (Vec<SensorLog>, Vec<super::super::PlantState>, Simulation) {
    let scenario = Scenario::from_toml_bytes(text.as_bytes(), "scenario.toml").unwrap();
    let mut simulation = Simulation::new(&scenario, robot).unwrap();
    let mut states = Vec::new();
    let summary = simulation.run(|_, state| {
        states.push(state.clone());
        Ok::<_, Infallible>(ControlFlow::Continue(()))
    });
    assert_eq!(summary.unwrap().end, super::super::RunEnd::Completed);
    let logs = simulation.sensors.as_ref().unwrap().logs(&simulation.plant);
    (logs, states, simulation)
}

/// Numbers of a log, row by row; empty cells are NaN.
fn numbers(log: &SensorLog) -> (Vec<String>, Vec<Vec<f64>>) {
    let mut lines = log.csv.lines();
    let names = lines.next().unwrap().split(',').map(str::to_owned).collect();
    (names, lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()).collect())
}

#[test]
fn without_noise_sensors_see_the_truth() {
    let tables = "record_s = 0.001\n[sensors]\nrate_Hz = 50\n[sensors.encoders]\n[sensors.load_pins]\n[sensors.tracker]\nrate_Hz = 200\n";
    let (logs, states, simulation) = run(&(START.to_owned() + tables), simulator());
    let (names, rows) = numbers(&logs[0]);
    assert_eq!(
        (logs[0].name, names[1].as_str(), names[9].as_str()),
        ("measurements.csv", "cable_length_m_1", "tension_N_1")
    );
    assert_eq!(rows.len(), 31);
    for row in &rows {
        let state = states.iter().min_by(|a, b| (a.time - row[0]).abs().total_cmp(&(b.time - row[0]).abs())).unwrap();
        for (cable, motion) in state.cables.iter().enumerate() {
            let model = simulation.plant.model();
            assert_eq!(row[1 + cable], model.recorded_length(cable, motion.controlled_length));
            assert_eq!(row[9 + cable], model.recorded_tension(cable, motion.tension));
        }
    }
    let (_, poses) = numbers(&logs[1]);
    assert_eq!(poses.len(), 121);
    let last = states.last().unwrap();
    let seen = Vector3::new(poses[120][1], poses[120][2], poses[120][3]);
    assert!((seen - last.pose.position).norm() < 1e-12, "displaced by no noise");
}

/// The specific force agrees with the acceleration from differences of the path, with dampers and without.
#[test]
fn the_inertial_unit_feels_the_second_difference_of_its_path() {
    let place = Vector3::new(0.3, -0.2, 0.1);
    let tables =
        "step_s = 1e-4\nrecord_s = 1e-4\n[sensors]\n[sensors.imu]\nrate_Hz = 10000\nposition_m = [0.3, -0.2, 0.1]\n";
    for damping in ["", "cable_damping_N_s_per_m = 2000\n"] {
        let text = START
            .replace("duration_s = 0.6", "duration_s = 0.02")
            .replace("[start]", &(damping.to_owned() + "[start]"));
        let (logs, states, simulation) = run(&(text + tables), simulator());
        let (_, rows) = numbers(&logs[0]);
        assert_eq!(rows.len(), states.len());
        let gravity = simulation.plant.model().robot().gravity.unwrap();
        let at = |index: usize| states[index].pose.transform(&place);
        for index in [20, 77, 150] {
            // central difference of h = 1e-3: its error h²/12 a'' with a'' ~ ω² a, ω ~ 200 rad/s, is 3e-3 of a
            let acceleration = (at(index + 10) - 2.0 * at(index) + at(index - 10)) / 1e-6;
            let force = states[index].pose.rotation.inverse() * (acceleration - gravity);
            let felt = Vector3::new(rows[index][1], rows[index][2], rows[index][3]);
            assert!((felt - force).norm() < 0.01 * (1.0 + acceleration.norm()), "{damping} {felt} {force}");
            let omega = states[index].pose.rotation.inverse() * states[index].twist().fixed_rows::<3>(3);
            assert!((Vector3::new(rows[index][4], rows[index][5], rows[index][6]) - omega).norm() < 1e-12);
        }
    }
}

/// Encoders at swivels count from gravity, and an inclinometer measures the platform's orientation.
#[test]
fn swivels_and_inclinometers_see_the_pose() {
    let mut robot = simulator();
    for cable in &mut robot.cables {
        cable.set_pulley_radius(0.1);
        cable.set_pulley_swivel_axis(Vector3::x());
    }
    let gravity = robot.gravity.unwrap();
    let tables = "record_s = 0.01\n[sensors]\n[sensors.swivels]\n[sensors.inclinometer]\n";
    let text = START.replace("[start]", "model = \"pulley+elastic\"\n[start]") + tables;
    let (logs, states, simulation) = run(&text, robot);
    let (names, rows) = numbers(&logs[0]);
    assert_eq!((names.len(), names[1].as_str(), names[5].as_str()), (13, "qx", "swivel_rad_1"));
    assert_eq!(rows.len(), states.len());
    for (row, state) in rows.iter().zip(&states) {
        assert_eq!(row[1..5], *state.pose.rotation.coords.as_slice());
        for (cable, angle) in row[5..].iter().enumerate() {
            let expected = simulation.plant.model().swivel_angle(cable, &state.pose, &gravity).unwrap();
            assert!((angle - expected).abs() < 1e-15, "{cable}");
        }
    }
    let along = |k: usize| rows.iter().map(move |row| row[k]);
    let swing = |k: usize| along(k).fold(f64::NEG_INFINITY, f64::max) - along(k).fold(f64::INFINITY, f64::min);
    assert!(swing(5) > 1e-4 && swing(2) > 1e-3, "{} {}", swing(5), swing(2));
}

/// Noise has its standard deviation, a bias is a mean, and adding a sensor changes no number of the others.
#[test]
fn noise_is_as_stated_and_of_each_sensor_alone() {
    let rest =
        START.replace("displacement = [0.02, 0, 0.01, 0, 0.02, 0]\n", "").replace("twist = [0, 0, 0, 0, 0, 0.1]\n", "");
    let pins =
        "[sensors]\nseed = 4\nrate_Hz = 1000\n[sensors.load_pins]\nnoise_N = 20\nbias_N = [50, 0, 0, 0, 0, 0, 0, 0]\n";
    let (logs, states, simulation) = run(&(rest.clone() + pins), simulator());
    let (_, rows) = numbers(&logs[0]);
    let truth = simulation.plant.model().recorded_tension(0, states[0].cables[0].tension);
    let errors: Vec<f64> = rows.iter().map(|row| row[1] - truth).collect();
    let mean = errors.iter().sum::<f64>() / errors.len() as f64;
    let deviation = (errors.iter().map(|error| (error - mean).powi(2)).sum::<f64>() / errors.len() as f64).sqrt();
    // 601 rows: the mean is known to 20/√601 = 0.8 N, the deviation to 0.6 N; four of each
    assert!((mean - 50.0).abs() < 3.3 && (deviation - 20.0).abs() < 2.4, "{mean} {deviation}");
    let more = pins.to_owned() + "[sensors.imu]\nacceleration_noise_m_s2 = 0.1\n";
    assert_eq!(run(&(rest + &more), simulator()).0[0], logs[0]);
}

#[test]
fn encoders_count_lose_counts_and_pins_end_at_their_range() {
    let tables = "[sensors]\n[sensors.encoders]\nresolution_m = 0.001\nloss = [{ time_s = 0.3, cable = 3, length_m = 0.005 }]\n\
                  [sensors.load_pins]\nrange_N = 3000\n";
    let (logs, states, simulation) = run(&(START.to_owned() + tables), simulator());
    let (_, rows) = numbers(&logs[0]);
    for row in &rows {
        let truth = simulation.plant.model().recorded_length(2, states[0].cables[2].controlled_length);
        let lost = if row[0] > 0.3 + 1e-9 { 0.005 } else { 0.0 };
        assert!((row[3] + lost - truth).abs() <= 0.0005 + 1e-12, "{} s", row[0]);
        assert!((((row[3] + lost) / 0.001).round() * 0.001 - row[3] - lost).abs() < 1e-9);
        assert!(row[9..].iter().all(|tension| (0.0..=3000.0).contains(tension)));
    }
    assert!(rows.iter().any(|row| row[9..].contains(&3000.0)), "some cable pulls more");
}

/// Without sight for half of the time: half of the rows are missing, and the others are late.
#[test]
fn trackers_are_late_and_blind_at_times() {
    let tables = "[sensors]\nseed = 1\n[sensors.tracker]\nrate_Hz = 500\nlatency_s = 0.02\ndropouts_per_s = 20\ndropout_s = 0.05\n";
    let text = START.replace("duration_s = 0.6", "duration_s = 6") + tables;
    let (logs, ..) = run(&text, simulator());
    let (_, rows) = numbers(&logs[0]);
    let fraction = rows.len() as f64 / 3001.0;
    // sight and blindness take 0.05 s each on average, 60 of each: 0.5 ± 0.05
    assert!((fraction - 0.5).abs() < 0.2, "{fraction}");
    assert!(rows[0][0] >= 0.02);
}

#[test]
fn clocks_and_low_passes_keep_their_time() {
    let mut clock = Clock::new(30.0);
    let read = (0..=1000).filter(|step| clock.is_due(1e-3 * f64::from(*step))).count();
    assert_eq!(read, 31, "thirty a second and the first");
    let mut filter = LowPass::new(Some(5.0));
    filter.pass(0.0, 1e-3);
    for step in 1..=100 {
        filter.pass(1e-3 * f64::from(step), 1e-3);
    }
    // a ramp, and a step after it; a jump between two looks counts as a line
    let omega = std::f64::consts::TAU * 5.0;
    let ramp = |time: f64| time - (1.0 - (-omega * time).exp()) / omega;
    assert!((filter.output() - ramp(0.1)).abs() < 1e-14, "{} {}", filter.output(), ramp(0.1));
    filter.pass(1.0, 0.0);
    assert!((filter.output() - ramp(0.1)).abs() < 1e-14);
    (0..100).for_each(|_| filter.pass(1.0, 1e-3));
    let expected = 1.0 + (ramp(0.1) - 1.0) * (-omega * 0.1).exp();
    assert!((filter.output() - expected).abs() < 1e-14, "{} {expected}", filter.output());
}

#[test]
fn sensors_that_cannot_be_are_refused() {
    for (tables, words) in [
        ("[sensors]\nrate_Hz = 0\n", "above 0"),
        ("[sensors]\n[sensors.load_pins]\nnoise_N = -1\n", "0 or more"),
        ("[sensors]\n[sensors.load_pins]\nbias_N = [1, 2]\n", "8 cables"),
        ("[sensors]\n[sensors.encoders]\nloss = [{ time_s = 1, cable = 9, length_m = 0.1 }]\n", "count from 1 to 8"),
        ("[sensors]\n[sensors.swivels]\n", "no pulleys that swivel"),
    ] {
        let scenario = Scenario::from_toml_bytes((START.to_owned() + tables).as_bytes(), "a").unwrap();
        let error = Simulation::new(&scenario, simulator()).unwrap_err();
        assert!(error.to_string().contains(words), "{error}");
        assert!(error.key().is_some(), "placed in the file");
    }
}
