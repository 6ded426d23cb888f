//! `test-bench`.

use std::fmt::Write;

use super::{SQUARE, cdpr_in, file_with};

/// Two cycles of a stiffening cable with friction, by Bouc's and Wen's equation, in millimetres and kilonewtons.
pub(crate) fn record() -> String {
    let mut text = "t_s,elongation_mm,tension_kN\n".to_owned();
    let (mut before, mut z) = (0.0, -1.0_f64);
    for row in 0..1204 {
        let (cycle, place) = (row / 301, f64::from(row % 301) / 300.0);
        let elongation: f64 = 30.0 * if cycle % 2 == 0 { place } else { 1.0 - place };
        let step: f64 = elongation - before;
        z = step.signum() + (z - step.signum()) * (-step.abs() / 2.0).exp();
        before = elongation;
        let elastic = 0.3 + 0.08 * elongation + 1.2e-4 * elongation.powi(3);
        writeln!(text, "{row},{elongation},{}", elastic + z * (0.03 + 0.05 * elastic)).unwrap();
    }
    text
}

#[test]
fn the_table_of_a_record_is_a_part_of_a_robot_file() {
    let (folder, _) = file_with("record.csv", record().as_bytes());
    let run = cdpr_in(folder.path(), "test-bench record.csv --length 10 --out cable.toml --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    assert!(run.stderr.contains("ignored columns `t_s`"), "{}", run.stderr);
    let answer = run.json();
    // a cubic, fitted up to exponentials: within the 0.5 % of the range that the dissertation reports for its fit
    let error = |law: &str| answer[law]["rms_percent_of_range"].as_f64().unwrap();
    assert!(error("loading_error") < 0.5 && error("unloading_error") < 0.5, "{answer}");
    assert!(error("linear_error") > 2.0 && error("polynomial_error") < error("linear_error"), "{answer}");
    assert!(answer["loss_per_cycle_J"].as_f64().unwrap() > 0.0);
    let keys = std::fs::read_to_string(folder.path().join("cable.toml")).unwrap();
    // the last cable of the file gets the keys
    std::fs::write(folder.path().join("robot.toml"), format!("{SQUARE}\n{keys}")).unwrap();
    let check = cdpr_in(folder.path(), "check robot.toml --format json");
    assert_eq!(check.exit_code, 0, "{}{}", check.stdout, check.stderr);
}

#[test]
fn the_words_compare_the_laws() {
    let (folder, _) = file_with("record.csv", record().as_bytes());
    let run = cdpr_in(folder.path(), "test-bench record.csv --length 10");
    for part in ["straight line", "both branches", "energy lost", "[cable.hysteresis]", "transition_strain"] {
        assert!(run.stdout.contains(part), "{part} is not in {}", run.stdout);
    }
}

#[test]
fn records_that_will_not_do_are_answered_by_what_to_do() {
    let whole = record();
    let lines = |range: std::ops::Range<usize>| {
        let rows: Vec<&str> = whole.lines().skip(1).collect();
        format!("t_s,elongation_mm,tension_kN\n{}\n", rows[range].join("\n"))
    };
    let reversed = {
        let rows: Vec<&str> = whole.lines().skip(1).collect();
        let turned: Vec<&str> = rows.iter().rev().copied().collect();
        format!("t_s,elongation_mm,tension_kN\n{}\n", turned.join("\n"))
    };
    for (text, code, part) in [
        (lines(0..301), "record::too-few-cycles", "record a whole cycle"),
        (lines(0..20), "record::too-few-rows", "fewer pieces"),
        (reversed, "record::branches-cross", "order of rows"),
        (whole.replace("tension_kN", "tension_klbf"), "csv::unknown-unit", "tension_kN"),
        (whole.replacen(",0.3", ",abc", 1), "csv::not-a-number", "abc"),
    ] {
        let (folder, _) = file_with("record.csv", text.as_bytes());
        let run = cdpr_in(folder.path(), "test-bench record.csv --length 10 --format json");
        assert_eq!((run.exit_code, run.json()["code"].as_str()), (2, Some(code)), "{}", run.stderr);
        assert!(run.stderr.contains(part), "{part} is not in {}", run.stderr);
    }
    let (folder, _) = file_with("record.csv", whole.as_bytes());
    assert_eq!(cdpr_in(folder.path(), "test-bench record.csv --length 0").exit_code, 2);
}
