//! Sweeps of the dissertation's chapter, computed again on coarser cells.

use serde_json::Value;

use super::cdpr_in;
use super::dissertation::{assert_near, figure, study};

/// Rows of a sweep of the folder with other cells and values.
fn swept(name: &str, step: &str, values: &str) -> Vec<Value> {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study(name)).unwrap();
    let lines = text
        .lines()
        .filter(|line| !["from", "to ", "count", "spacing", "values"].iter().any(|key| line.starts_with(key)));
    let lines = lines.map(|line| match line.split_once(" = ") {
        Some(("study", file)) => {
            let name = file.trim_matches('"').trim_end_matches(".toml");
            format!("study = '{}'", study(name))
        }
        Some(("step_m", _)) => format!("step_m = {step}"),
        _ => line.to_owned(),
    });
    let text = format!("{}\nvalues = {values}\n", lines.collect::<Vec<_>>().join("\n"));
    std::fs::write(folder.path().join("sweep.toml"), text).unwrap();
    let run = cdpr_in(folder.path(), "sweep all sweep.toml --out out");
    assert_eq!(run.exit_code, 0, "{name}: {}", run.stderr);
    let merged: Value = serde_json::from_slice(&std::fs::read(folder.path().join("out/result.json")).unwrap()).unwrap();
    merged["rows"].as_array().unwrap().clone()
}

/// Fig. 3.17, on cells of 10 cm.
#[test]
fn stiffer_cables_do_not_reach_more_of_the_planar_workspace_but_more_accurately() {
    let rows = swept("sweep-planar-stiffness-four", "0.1", "[2e5, 1e6, 2e6, 3.5e6]");
    for (row, (share, within_5_mm)) in rows.iter().zip([(0.728, 0.005), (0.708, 0.139), (0.706, 0.473), (0.705, 0.588)])
    {
        assert_near(&row["share"], share, 0.005);
        assert_near(&row["share_by_accuracy"][2], within_5_mm, 0.005);
    }
}

/// Fig. 3.9: the differential hull, on cells of 10 cm.
#[test]
fn an_anchor_moved_in_the_controller_changes_what_is_reached_as_its_sweep_tells() {
    let rows = swept("sweep-planar-anchor", "0.1", "[-6.05, -6, -5.95]");
    for (row, share) in rows.iter().zip([0.711, 0.728, 0.732]) {
        assert_near(&row["share"], share, 0.005);
    }
}

/// Fig. 3.21 to 3.23: printed 98.95 % of the physical area at 0.15 m; 97.54 % at 0.4 m, where 97.4 % and, by our cells, 96.9 % were found.
#[test]
fn pulleys_that_the_controller_does_not_know_cost_reachable_workspace_and_force_control_wins_some_of_it_back() {
    let kinematic = swept("sweep-planar-pulleys", "0.2", "[0, 0.15, 0.4]");
    let area = |row: usize| {
        kinematic[row]["physical_area_m2"].as_f64().unwrap() / kinematic[0]["physical_area_m2"].as_f64().unwrap()
    };
    assert!((area(1) - 0.9895).abs() < 0.005 && (area(2) - 0.9754).abs() < 0.01, "{} {}", area(1), area(2));
    let force = swept("sweep-planar-force-control", "0.2", "[0, 0.15, 0.4]");
    // control model and machine are alike without pulleys: eq. 3.26
    assert_near(&force[0]["share"], 1.0, 0.0);
    for (rows, shares, within_5_mm) in
        [(&kinematic, [0.705, 0.604, 0.486], [0.472, 0.275, 0.203]), (&force, [1.0, 0.693, 0.462], [1.0, 0.571, 0.341])]
    {
        for (row, (share, within)) in rows.iter().zip(shares.into_iter().zip(within_5_mm)) {
            assert_near(&row["share"], share, 0.02);
            assert_near(&row["share_by_accuracy"][2], within, 0.02);
        }
    }
}

/// Sec. 4.5: around 74 % of the physical workspace with pulleys of 0.15 m and 200 kN; on cells of 10 cm.
#[test]
fn soft_cables_over_pulleys_reach_the_printed_share() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(study("sweep-planar-pulleys-soft")).unwrap();
    let text = text
        .replace("step_m = 0.05", "step_m = 0.1")
        .replace("\"planar-pulleys.toml\"", &format!("'{}'", study("planar-pulleys")));
    std::fs::write(folder.path().join("sweep.toml"), text).unwrap();
    let run = cdpr_in(folder.path(), "sweep all sweep.toml --out out --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let merged = run.json();
    for (row, share) in merged["rows"].as_array().unwrap().iter().zip([0.728, 0.744, 0.767]) {
        assert_near(&row["share"], share, 0.005);
    }
}

/// What the sweep of this name draws, and the chart of the chapter.
fn assert_drawn(name: &str) {
    let folder = tempfile::tempdir().unwrap();
    let sweep = study(&format!("sweep-planar-{name}"));
    let run = cdpr_in(folder.path(), &format!("sweep all {sweep} --out out"));
    assert_eq!(run.exit_code, 0, "{name}: {}", run.stderr);
    let drawn = std::fs::read(folder.path().join("out/result.svg")).unwrap();
    assert!(drawn == figure(&format!("dissertation-{name}.svg")), "draw the chart of {name} again");
}

#[test]
fn the_chart_of_pulleys_is_drawn_by_its_sweep() {
    assert_drawn("pulleys");
}

#[test]
fn the_chart_of_force_control_is_drawn_by_its_sweep() {
    assert_drawn("force-control");
}

#[test]
fn the_chart_of_initial_tensions_is_drawn_by_its_sweep() {
    assert_drawn("tension-stiff");
}

/// Fig. 3.20: without a limit of the error most is reached at 6000 N, with one at less.
#[test]
fn the_tighter_the_accuracy_the_lower_is_the_best_initial_tension() {
    let rows = swept("sweep-planar-tension-stiff", "0.1", "[4000, 4500, 5000, 5500, 6000, 6500]");
    let best = |share: &dyn Fn(&Value) -> f64| {
        let best = rows.iter().max_by(|a, b| share(a).total_cmp(&share(b))).unwrap();
        best["values"][0].as_f64().unwrap()
    };
    let within = |index: usize| move |row: &Value| row["share_by_accuracy"][index].as_f64().unwrap();
    assert_eq!(best(&|row| row["share"].as_f64().unwrap()), 6000.0);
    assert_eq!((best(&within(2)), best(&within(1))), (5500.0, 4500.0), "to 5 mm and to 2 mm");
}
