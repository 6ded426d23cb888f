//! Robots and models under the same rules.

use super::*;

fn robots(names: &[&str]) -> Vec<Robot> {
    names.iter().map(|name| Robot::builtin(name).expect("is built in")).collect()
}

/// Calibration helps every robot, force control beats kinematics if the file has the stiffness, and the same rules give
/// the same numbers.
#[test]
fn identification_makes_every_robot_more_accurate() {
    let all = robots(&["cablerobot-simulator-helicopter", "planar-example", "ipanema-1", "caroca-pulleys"]);
    let found = benchmark(&all, None, &BenchmarkRules::default());
    assert!(found.left_out.is_empty(), "{:?}", found.left_out);
    let models: Vec<&str> =
        found.rows.iter().filter(|row| row.robot == all[0].name).map(|row| row.model.as_str()).collect();
    assert_eq!(models, ["standard", "elastic"]);
    for row in &found.rows {
        let identified = row.identified.unwrap_or_else(|| panic!("{row:?}"));
        assert!(identified.position_mean_m < 0.7 * row.nominal.position_mean_m, "{row:?}");
        assert!((row.nominal.position_relative - row.nominal.position_mean_m / row.diagonal_m).abs() < 1e-15);
        assert!(row.nominal.position_max_m >= row.nominal.position_mean_m && row.samples > 0);
        assert_eq!(
            row.nominal.rotation_mean_rad.is_some(),
            row.motion_pattern == "3R3T" || row.motion_pattern == "1R2T"
        );
    }
    let of = |robot: usize, model: &str| {
        let is_meant = |row: &&BenchmarkRow| row.robot == all[robot].name && row.model == model;
        found.rows.iter().find(is_meant).and_then(|row| row.identified).unwrap()
    };
    for robot in [0, 1] {
        assert!(of(robot, "elastic").position_mean_m < 0.5 * of(robot, "standard").position_mean_m);
        assert!(
            of(robot, "elastic").tension_mean_norm_N.is_some() && of(robot, "standard").tension_mean_norm_N.is_none()
        );
    }
    assert_eq!(benchmark(&all[1..2], None, &BenchmarkRules::default()).rows[..], found.rows[2..4]);
}

/// A machine without deviations that is no richer than its control model is driven without error, to rounding; models
/// that were not requested are left out.
#[test]
fn a_machine_as_its_file_says_is_met() {
    let rules = BenchmarkRules { anchor_deviation: 0.0, stiffness_deviation: 0.0, ..BenchmarkRules::default() };
    let found = benchmark(&robots(&["planar-example"]), Some(&[Composition::ELASTIC]), &rules);
    let [row] = &found.rows[..] else { panic!("{found:?}") };
    // the search for the machine's equilibrium ends at a nanometre
    assert!(row.nominal.position_max_m < 1e-8 && row.nominal.tension_mean_norm_N.unwrap() < 1e-3, "{row:?}");
    assert_eq!(row.nominal.reach_share, 1.0);
}

#[test]
fn robots_that_cannot_take_part_are_told() {
    let mut without = robots(&["planar-example"]);
    without[0].cables[2].tension_max = None;
    let found = benchmark(&without, None, &BenchmarkRules::default());
    assert!(found.rows.is_empty() && found.left_out[0].1.contains("no tension limits"), "{found:?}");
}
