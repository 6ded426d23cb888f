//! `friction`.

use std::fmt::Write;

use serde_json::Value;

use super::{cdpr_in, file_with};

/// Plateaus of a winch under two loads: T = 0.95 load + 0.02 ± (0.04 + 0.05 load + 8e-4 |v|), within a millinewton-metre.
pub(crate) fn record() -> String {
    let mut text = "motor_speed_rad_per_s,motor_torque_Nm,load_Nm\n".to_owned();
    let mut row = 0;
    for load in [0.2, 1.0] {
        for speed in [3.0, 7.0, 14.0, 25.0] {
            for direction in [1.0, -1.0] {
                row += 1;
                let shake = 1e-3 * (f64::from((row * 7919 + 13) % 101) / 50.0 - 1.0);
                let torque = 0.95 * load + 0.02 + direction * (0.04 + 0.05 * load + 8e-4 * speed) + shake;
                writeln!(text, "{},{torque:.6},{load}", direction * speed).unwrap();
            }
        }
    }
    text
}

fn assert_told(answer: &Value, key: &str, truth: f64) {
    let interval = &answer["interval_95"][key];
    let (low, high) = (interval[0].as_f64().unwrap(), interval[1].as_f64().unwrap());
    let value = answer[key].as_f64().unwrap();
    // 99.9 % of intervals as wide again on both sides hold the truth
    let half = high - low;
    assert!((value - truth).abs() <= half, "{key}: {value} in {low} to {high}, not {truth}");
    assert!(answer["sigma"][key].as_f64().unwrap() > 0.0, "{key}");
}

#[test]
fn friction_and_loads_come_with_their_deviations() {
    let (folder, _) = file_with("winch.csv", record().as_bytes());
    let run = cdpr_in(folder.path(), "friction winch.csv --format json");
    let answer = run.json();
    assert_eq!((run.exit_code, answer["status"].as_str()), (0, Some("converged")), "{answer}");
    let truth = [
        ("load_scale", 0.95),
        ("load_offset_Nm", 0.02),
        ("coulomb_Nm", 0.04),
        ("coulomb_by_load", 0.05),
        ("viscous_Nm_s_per_rad", 8e-4),
    ];
    truth.iter().for_each(|(key, truth)| assert_told(&answer, key, *truth));
    assert!(answer["static_Nm"].is_null() && answer["sigma"]["static_Nm"].is_null());
    let open: Vec<&str> = answer["undetermined"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
    assert_eq!(open, ["coulomb_by_direction", "static_Nm", "stribeck_speed_rad_per_s"]);
    assert_eq!(answer["loads"].as_array().unwrap().len(), 2);
}

#[test]
fn the_words_tell_doubts_first_and_what_is_open() {
    let (folder, _) = file_with("winch.csv", record().as_bytes());
    let run = cdpr_in(folder.path(), "friction winch.csv");
    for part in
        ["8 plateaus lift and 8 lower", "Coulomb friction", "not told by these records", "static_Nm", "3.0000 rad/s"]
    {
        assert!(run.stdout.contains(part), "{part} is not in {}", run.stdout);
    }
}

#[test]
fn lifting_alone_is_a_no_with_the_reason() {
    let lifting: String =
        record().lines().filter(|line| !line.starts_with('-')).map(|line| format!("{line}\n")).collect();
    let (folder, _) = file_with("winch.csv", lifting.as_bytes());
    let run = cdpr_in(folder.path(), "friction winch.csv --format json");
    let answer = run.json();
    assert_eq!((run.exit_code, answer["status"].as_str()), (1, Some("not-identifiable")), "{answer}");
    assert!(
        answer["reason"].as_str().unwrap().contains("lifting alone cannot tell friction from the load"),
        "{answer}"
    );
    assert!(answer["coulomb_Nm"].is_null() && answer["viscous_Nm_s_per_rad"].is_f64(), "{answer}");
    let text = cdpr_in(folder.path(), "friction winch.csv").stdout;
    assert!(text.lines().nth(1).unwrap().contains("lifting alone"), "{text}");
}

#[test]
fn records_that_will_not_do_are_answered_by_what_to_do() {
    let whole = record();
    let constant = "motor_speed_rad_per_s,motor_torque_Nm\n1,0.3\n2,0.3\n-1,0.3\n-2,0.3\n".to_owned();
    let turned = "motor_speed_rad_per_s,motor_torque_Nm,direction\n-1,0.3,up\n2,0.3,up\n".to_owned();
    for (text, code, part) in [
        (whole.replace("motor_speed_rad_per_s", "motor_speed_m_per_s"), "csv::unknown-unit", "motor_speed_rad_per_s"),
        (whole.replace("motor_torque_Nm", "torque"), "csv::missing-column", "motor_torque_Nm"),
        (whole.replacen("3,0.", "NaN,0.", 1), "csv::not-a-number", "winch.csv:2:1"),
        (constant, "record::constant-torque", "a commanded torque"),
        (turned, "csv::direction", "winch.csv:2:8"),
        ("motor_speed_rad_per_s,motor_torque_Nm\n".to_owned(), "csv::no-rows", "no rows"),
    ] {
        let (folder, _) = file_with("winch.csv", text.as_bytes());
        let run = cdpr_in(folder.path(), "friction winch.csv --format json");
        assert_eq!((run.exit_code, run.json()["code"].as_str()), (2, Some(code)), "{}", run.stderr);
        assert!(run.stderr.contains(part), "{part} is not in {}", run.stderr);
    }
    let (folder, _) = file_with("winch.csv", whole.as_bytes());
    let bare: String = whole.lines().map(|line| format!("{}\n", line.rsplit_once(',').unwrap().0)).collect();
    std::fs::write(folder.path().join("bare.csv"), bare).unwrap();
    let run = cdpr_in(folder.path(), "friction winch.csv bare.csv --format json");
    assert_eq!(run.json()["code"], "record::mixed-loads", "{}", run.stderr);
}

#[test]
fn speeds_that_positions_contradict_are_not_trusted() {
    let mut text = "t_s,motor_position_rad,motor_speed_rad_per_s,motor_torque_Nm\n".to_owned();
    let mut time = 0.0;
    for speed in [3.0, -3.0, 9.0, -9.0, 15.0, -15.0_f64] {
        for row in 0..60 {
            time += 0.05;
            let torque = 0.5 + speed.signum() * (0.05 + 1e-3 * speed.abs()) + 1e-3 * f64::from((row * 37) % 11 - 5);
            // the speed is in turns per second
            let (position, written) = (speed * 0.05 * f64::from(row), speed / std::f64::consts::TAU);
            writeln!(text, "{time:.3},{position:.4},{written:.5},{torque:.5}").unwrap();
        }
    }
    let (folder, _) = file_with("winch.csv", text.as_bytes());
    let run = cdpr_in(folder.path(), "friction winch.csv --format json");
    let answer = run.json();
    assert_eq!((run.exit_code, answer["status"].as_str()), (1, Some("not-trusted")), "{answer}");
    assert!(answer["reason"].as_str().unwrap().contains("turns/s"), "{answer}");
}
