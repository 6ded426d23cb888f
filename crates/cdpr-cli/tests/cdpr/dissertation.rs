//! The dissertation's figures, computed again: every number of the book's chapter of that name, by the command that it gives.
//!
//! Numbers are those of our own studies, to the last digit shown but one; what the dissertation prints stands beside them in the
//! chapter. Areas are counted on coarser cells than in the chapter, which moves shares by less than a per cent.

use serde_json::Value;

use super::{cdpr, cdpr_in, numbers, root};

pub(super) fn study(name: &str) -> String {
    root().join(format!("studies/{name}.toml")).display().to_string()
}

/// The answer of a command about a study.
fn answer(command: &str, name: &str, options: &str) -> Value {
    let run = cdpr(&format!("{command} {} {options} --format json", study(name)));
    assert!(run.exit_code < 2, "{name}: {}", run.stderr);
    run.json()
}

#[track_caller]
pub(super) fn assert_near(found: &Value, expected: f64, tolerance: f64) {
    let found = found.as_f64().unwrap();
    assert!((found - expected).abs() <= tolerance, "{found}, expected {expected} ± {tolerance}");
}

/// Sec. 4.4: 57.14 and 117.83 mm (printed 5.71 and 11.78), after calibration 29.00 and 80.64 % less, as printed.
#[test]
fn calibrating_the_planar_controller_improves_it_by_the_printed_shares() {
    for (set, mean, calibrated, improvement) in [("wide", 57.14, 40.57, 0.2900), ("low", 117.83, 22.81, 0.8064)] {
        let mean_of =
            |kind: &str| answer("accuracy", &format!("planar-{set}-{kind}"), "")["position_error_m"]["mean"].clone();
        let (before, after) = (mean_of("grid"), mean_of("calibrated"));
        assert_near(&before, 1e-3 * mean, 1e-5);
        assert_near(&after, 1e-3 * calibrated, 1e-5);
        // the print has Δa to a micrometre, means to three digits
        let share = 1.0 - after.as_f64().unwrap() / before.as_f64().unwrap();
        assert!((share - improvement).abs() < 2e-4, "{set}: {share}");
    }
}

/// Eq. 4.26 and 4.30: κ = 3.2, and the least-squares anchors of maths.md from our own record.
#[test]
fn the_planar_anchors_are_identified_from_the_record_of_the_wide_grid() {
    let folder = tempfile::tempdir().unwrap();
    let run = cdpr_in(folder.path(), &format!("simulate {} --out wide.csv", study("planar-wide-grid")));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let run =
        cdpr_in(folder.path(), "identify planar-example wide.csv --free frame-anchor --loss squared --format json");
    let answer = run.json();
    assert_near(&answer["condition"], 3.2, 0.05);
    let change = [14.8, 69.088, -40.866, 74.297, 10.844, -0.003, -13.352, 13.921];
    for (parameter, change) in answer["parameters"].as_array().unwrap().iter().zip(change) {
        let moved = parameter["value"].as_f64().unwrap() - parameter["start"].as_f64().unwrap();
        assert!((1e3 * moved - change).abs() < 2e-3, "{parameter}");
    }
}

/// Eq. 4.26 and 4.28: at the nominal anchors, where a rigid machine leaves them.
#[test]
fn both_sets_of_poses_have_the_printed_conditions() {
    for (set, condition) in [("wide", 3.202), ("low", 19.278)] {
        let folder = tempfile::tempdir().unwrap();
        let text = std::fs::read_to_string(study(&format!("planar-{set}-grid"))).unwrap();
        let text = text.replace("model = \"elastic\"", "model = \"standard\"");
        std::fs::write(folder.path().join("study.toml"), text).unwrap();
        assert_eq!(cdpr_in(folder.path(), "simulate study.toml --out rigid.csv").exit_code, 0);
        let run = cdpr_in(
            folder.path(),
            "identify planar-example rigid.csv --free frame-anchor --loss squared --format json",
        );
        assert_near(&run.json()["condition"], condition, 1e-3);
    }
}

/// Fig. 3.8, 3.11 and eq. 4.29.
#[test]
fn the_linear_error_of_the_planar_example_follows_the_exact_one_over_its_whole_workspace() {
    let folder = tempfile::tempdir().unwrap();
    let run = cdpr_in(folder.path(), &format!("study {} --out out --format json", study("planar-validation")));
    let answer = run.json();
    assert_eq!((&answer["samples"], &answer["converged"]), (&1587.into(), &1585.into()));
    assert_near(&answer["position_error_m"]["mean"], 0.0634, 1e-4);
    assert_near(&answer["linear_position_error_m"]["mean"], 0.0632, 1e-4);
    assert_near(&answer["linear_residual_m"]["median"], 0.0002, 1e-5);
    assert_near(&answer["linear_trusted_share"], 0.96, 0.01);
    let drawn = std::fs::read(folder.path().join("out/error-map-xy.svg")).unwrap();
    assert!(drawn == figure("dissertation-error-map.svg"), "draw the figure of the chapter again");
}

/// Fig. 3.9, 3.13: "the sensitivity always stays below one".
#[test]
fn no_anchor_of_the_planar_example_moves_the_platform_by_more_than_itself() {
    let answer = answer("sensitivity", "planar-validation", "--robots 0");
    let anchors = answer["parameters"].as_array().unwrap().iter();
    let largest = anchors
        .filter(|parameter| parameter["kind"] == "frame-anchor")
        .map(|parameter| parameter["position_max_m_per_unit"].as_f64().unwrap())
        .collect::<Vec<_>>();
    assert_eq!(largest.len(), 16);
    assert!((largest.iter().copied().fold(0.0, f64::max) - 0.993).abs() < 1e-3, "{largest:?}");
}

/// Sec. 3.6: 20 mm is printed as the largest error, which is that of the printed stiffness; the printed areas are of a tenth of it.
#[test]
fn the_printed_error_and_the_printed_areas_belong_to_different_stiffnesses() {
    assert_near(&answer("accuracy", "planar-stiff", "")["position_error_m"]["max"], 0.0227, 1e-4);
    let stiff = answer("reachable", "planar-stiff", "--method hull --rays 36 --bounds=-6,6,-1,9");
    assert_near(&stiff["share"], 0.709, 0.001);
    let soft = answer("reachable", "planar-wide-grid", "--method hull --rays 36");
    assert_near(&soft["share"], 0.733, 0.001);
    assert_near(&soft["physical_area_m2"], 69.62, 0.01);
    assert_near(&soft["reachable_area_m2"], 51.04, 0.01);
}

/// Cells of 10 cm: parts of 1 m² are 100 cells wide.
#[test]
fn with_a_required_accuracy_the_workspace_has_a_part_around_each_zero_of_the_error() {
    let answer = answer("reachable", "planar-disconnected", "--bounds=-6,6,-1,9 --step 0.1");
    assert_eq!(answer["parts"].as_array().unwrap().len(), 3, "{answer}");
    assert_near(&answer["reachable_area_m2"], 6.06, 0.1);
}

#[test]
fn tensions_along_a_circle_inside_the_physical_workspace_leave_their_limits() {
    let answer = answer("accuracy", "planar-circle", "");
    assert_eq!((&answer["samples"], &answer["statuses"]["converged"]), (&72.into(), &72.into()));
    assert_near(&answer["tension_min_N"], 283.0, 1.0);
    assert_near(&answer["tension_max_N"], 7744.0, 1.0);
    assert_near(&answer["outside_limits_share"], 14.0 / 72.0, 1e-9);
}

/// Fig. 3.18: both initial distributions as printed, to a newton.
#[test]
fn without_load_lower_initial_tensions_are_more_accurate_and_reach_more() {
    let printed = [("8000", [5196.0, 5247.0, 3380.0, 3394.0]), ("3000", [3464.0, 3498.0, 2253.0, 2263.0])];
    let found = printed.map(|(level, printed)| {
        let name = format!("planar-unloaded-{level}");
        let accuracy = answer("accuracy", &name, "");
        for (found, printed) in numbers(&accuracy["initial_tensions_N"]).iter().zip(printed) {
            assert!((found - printed).abs() < 0.6, "{accuracy}");
        }
        let reachable = answer("reachable", &name, "--bounds=-6.4,5.6,-1,9 --step 0.2");
        (accuracy["position_error_m"]["mean"].as_f64().unwrap(), reachable["share"].as_f64().unwrap())
    });
    for ((error, share), (expected_error, expected_share)) in found.into_iter().zip([(12.18, 0.715), (8.15, 0.809)]) {
        assert!((1e3 * error - expected_error).abs() < 0.01, "{error}");
        assert!((share - expected_share).abs() < 0.01, "{share}");
    }
}

pub(super) fn figure(name: &str) -> Vec<u8> {
    std::fs::read(root().join("docs/book/src/figures").join(name)).unwrap()
}

/// Eq. 6.25–6.26 against sec. 6.5: printed 34.5 mm, 1.03°, 2427 N before and 2.73 mm, 0.11°, 582 N after.
#[test]
fn the_elastostatic_identification_of_the_twin_improves_its_nominal_model_at_least_as_much_as_printed() {
    let folder = tempfile::tempdir().unwrap();
    let run = cdpr_in(folder.path(), &format!("simulate {} --out twin.csv", study("twin-elastostatic-measurements")));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let robot = root().join("studies/robots/twin-elastostatic-nominal.toml").display().to_string();
    let run = cdpr_in(
        folder.path(),
        &format!(
            "identify {robot} twin.csv --model elastic --free frame-anchor,platform-anchor,compliance,wrench --prior platform-anchor=0.02 --loss squared --starts 1 --format json"
        ),
    );
    let answer = run.json();
    for (block, statistic, before, after, printed) in [
        ("position_error_m", "mean", 0.0367, 0.00174, 34.5 / 2.73),
        ("rotation_error_rad", "mean", 0.0193, 0.00159, 1.03 / 0.11),
        ("tension_error_N", "mean_norm", 2558.0, 162.3, 2427.0 / 582.0),
    ] {
        let (found_before, found_after) =
            (&answer["train_before"][block][statistic], &answer["train"][block][statistic]);
        assert_near(found_before, before, 5e-3 * before);
        assert_near(found_after, after, 1e-2 * after);
        assert!(found_before.as_f64().unwrap() / found_after.as_f64().unwrap() > printed, "{block}");
    }
    // printed 2839 to 2856, of other columns
    assert_near(&answer["condition_scaled"], 2976.0, 30.0);
}

/// Sec. 6.2: printed 39.80 mm, 1.19°, 23.52 mm before, 9.66 mm, 0.29°, 4.08 mm after, κ = 31.9.
#[test]
fn the_kinematic_calibration_of_the_twin_improves_its_nominal_controller_at_least_as_much_as_printed() {
    let folder = tempfile::tempdir().unwrap();
    let run = cdpr_in(folder.path(), &format!("simulate {} --out twin.csv", study("twin-kinematic-measurements")));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let run = cdpr_in(
        folder.path(),
        "identify cablerobot-simulator-helicopter twin.csv --free frame-anchor --loss squared --format json",
    );
    let answer = run.json();
    assert_eq!(answer["samples"], 91);
    for (block, statistic, before, after, printed) in [
        ("position_error_m", "mean", 0.03723, 0.00390, 39.80 / 9.66),
        ("rotation_error_rad", "mean", 0.02084, 0.00489, 1.19 / 0.29),
        ("length_error_m", "mean_abs", 0.02285, 0.00274, 23.52 / 4.08),
    ] {
        let (found_before, found_after) =
            (&answer["train_before"][block][statistic], &answer["train"][block][statistic]);
        assert_near(found_before, before, 5e-3 * before);
        assert_near(found_after, after, 1e-2 * after);
        assert!(found_before.as_f64().unwrap() / found_after.as_f64().unwrap() > printed, "{block}");
    }
    assert_near(&answer["condition"], 28.7, 0.1);
}

/// Eq. 6.24, printed to a millimetre.
#[test]
fn the_winch_offsets_of_the_twin_are_those_printed() {
    let offsets = numbers(&answer("accuracy", "twin-winch-offsets", "")["winch_offsets_m"]);
    for (offset, printed) in offsets.iter().zip([-19.0, -11.0, -22.0, -8.0, -19.0, -10.0, -23.0, -8.0]) {
        assert!((1e3 * offset - printed).abs() < 0.8, "{offsets:?}");
    }
}

/// Eq. 6.9: printed 431 N in the mean.
#[test]
fn calibrating_the_controller_of_the_twin_changes_its_tensions_little() {
    let folder = tempfile::tempdir().unwrap();
    let tensions = |name: &str| -> Vec<f64> {
        let run = cdpr_in(folder.path(), &format!("study {} --out {name}", study(name)));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        let table = std::fs::read_to_string(folder.path().join(name).join("errors.csv")).unwrap();
        let columns: Vec<usize> = (0..)
            .zip(table.lines().next().unwrap().split(','))
            .filter(|(_, heading)| heading.starts_with("tension_N_"))
            .map(|(column, _)| column)
            .collect();
        let row = |line: &str| -> Vec<f64> {
            let cells: Vec<&str> = line.split(',').collect();
            columns.iter().map(|&column| cells[column].parse().unwrap()).collect()
        };
        table.lines().skip(1).flat_map(row).collect()
    };
    let (nominal, calibrated) = (tensions("twin-nominal"), tensions("twin-kinematic-calibrated"));
    assert_eq!((nominal.len(), calibrated.len()), (600, 600));
    let squares: f64 =
        nominal.iter().zip(&calibrated).map(|(nominal, calibrated)| (nominal - calibrated).powi(2)).sum();
    assert!(((squares / 600.0).sqrt() - 400.0).abs() < 1.0, "{}", (squares / 600.0).sqrt());
    let sum: f64 = nominal.iter().zip(&calibrated).map(|(nominal, calibrated)| (nominal - calibrated).abs()).sum();
    assert!((sum / 600.0 - 298.0).abs() < 1.0, "{}", sum / 600.0);
}

/// A study that no chapter names would be forgotten.
#[test]
fn every_study_says_what_it_shows_and_stands_in_the_list() {
    let list = std::fs::read_to_string(root().join("studies/README.md")).unwrap();
    for entry in std::fs::read_dir(root().join("studies")).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_str().unwrap().to_owned();
        if !name.ends_with(".toml") {
            continue;
        }
        assert!(std::fs::read_to_string(&path).unwrap().starts_with("# "), "{name}");
        assert!(list.contains(&format!("`{name}`")), "{name} is missing in studies/README.md");
    }
}

/// The chapter's commands name studies that are there, and its sweeps can be planned.
#[test]
fn the_commands_of_the_chapter_find_their_studies() {
    let chapter = std::fs::read_to_string(root().join("docs/book/src/dissertation.md")).unwrap();
    let studies = chapter.split([' ', '`', '\n']).filter(|word| word.starts_with("studies/"));
    let studies: std::collections::BTreeSet<&str> = studies.collect();
    assert!(studies.len() > 15, "{studies:?}");
    let folder = tempfile::tempdir().unwrap();
    for study in studies {
        assert!(root().join(study).is_file(), "{study}");
        if study.starts_with("studies/sweep") {
            let run = cdpr_in(folder.path(), &format!("sweep plan {} --out out", root().join(study).display()));
            assert_eq!(run.exit_code, 0, "{study}: {}", run.stderr);
        }
    }
}

/// Sec. 4.4: the anchors of eq. 4.30 make the mean error 29.00 % and 80.64 % smaller (printed), and the map of the chapter is the one that is drawn.
#[test]
fn two_controllers_on_one_machine_differ_as_printed() {
    let folder = tempfile::tempdir().unwrap();
    let study = |name: &str| root().join("studies").join(name).display().to_string();
    for (set, printed) in [("wide", -0.2900), ("low", -0.8064)] {
        let (own, other) = (study(&format!("planar-{set}-calibrated.toml")), study(&format!("planar-{set}-grid.toml")));
        let run = cdpr_in(folder.path(), &format!("accuracy {own} --against {other} --map {set}.svg --format json"));
        assert_eq!(run.exit_code, 0, "{}", run.stderr);
        let difference = &run.json()["difference"];
        let position = &difference["position_error_m"];
        // the dissertation has four digits of both errors, a share of which is known to a unit of the last
        let change = position["relative_change"].as_f64().unwrap();
        assert!((change - printed).abs() < 5e-4, "{set}: {change}");
        let means = [&position["own"]["mean"], &position["other"]["mean"]].map(|mean| mean.as_f64().unwrap());
        assert!((position["mean_change"].as_f64().unwrap() - (means[0] - means[1])).abs() < 1e-15);
        assert_eq!(difference["samples"], difference["compared"]);
    }
    let drawn = std::fs::read(folder.path().join("wide.svg")).unwrap();
    assert!(drawn == figure("dissertation-difference.svg"), "draw the map of two controllers again");
    // Δε_f of two force controllers: the change of what each of them answers alone, at poses that both reach
    let (own, other) = (study("planar-force-tracking-identified.toml"), study("planar-force-tracking.toml"));
    let answer = cdpr_in(folder.path(), &format!("accuracy {own} --against {other} --format json")).json();
    let alone = cdpr_in(folder.path(), &format!("accuracy {other} --format json")).json();
    let (tension, number) = (&answer["difference"]["tension_error_N"], |value: &Value| value.as_f64().unwrap());
    let means = [&answer, &alone].map(|answer| number(&answer["tension_error_N"]["mean_norm"]));
    assert!((number(&tension["mean_change"]) - (means[0] - means[1])).abs() < 1e-9 * means[1], "{means:?} {tension}");
    assert!((number(&tension["other"]["mean"]) - means[1]).abs() < 1e-9 * means[1], "{tension}");
    let (own, other) = (study("planar-wide-calibrated.toml"), study("planar-stiff.toml"));
    let run = cdpr_in(folder.path(), &format!("accuracy {own} --against {other} --format json"));
    let warnings = run.json()["warnings"].to_string();
    assert!(warnings.contains("the machine is another one"), "{warnings}");
    let alone = cdpr_in(folder.path(), &format!("accuracy {own} --map map.svg"));
    assert_eq!(alone.exit_code, 2, "{}", alone.stdout);
}

/// Chapter 6 as one study: stages and printed numbers in JSON, the page, and a study that has nothing for some stages.
#[test]
fn chapter_six_runs_as_one_study() {
    let folder = tempfile::tempdir().unwrap();
    let study = |name: &str| root().join("studies").join(name).display().to_string();
    let chain = format!("chain {} --region=-2,2,-2,2,0.75,2.75 --report chain.html", study("twin-chain.toml"));
    let run = cdpr_in(folder.path(), &format!("{chain} --format json"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json();
    let steps = answer["steps"].as_array().unwrap();
    let step = |name: &str| steps.iter().find(|step| step["name"] == name).unwrap();
    let edges = step("force-control-edges");
    // 0.939 mm and 199.6 N by hand, from the record of the printed anchors (see the library's test)
    assert!((edges["position_mean_m"].as_f64().unwrap() / 0.924e-3 - 1.0).abs() < 0.01, "{edges}");
    assert!((edges["tension_mean_norm_N"].as_f64().unwrap() / 200.0 - 1.0).abs() < 0.01, "{edges}");
    assert_eq!((&answer["status"], &answer["force_tracking"]["verdict"]), (&"done".into(), &"better".into()));
    assert_eq!(answer["force_tracking"]["after_mean_norm_N"], step("force-control")["tension_mean_norm_N"]);
    assert!((step("reference")["printed"]["position_mean_m"].as_f64().unwrap() - 0.0398).abs() < 1e-12);
    assert_eq!(answer["region_m"][2], serde_json::json!([0.75, 2.75]));
    let page = std::fs::read_to_string(folder.path().join("chain.html")).unwrap();
    assert!(page.contains("37.2 (39.8)") && !page.contains("src=\"http"), "printed numbers stand beside ours");
    assert!(page.contains("published: 39.8</title>") && page.contains("orientation, °"));
    assert_eq!(page.matches("here: ").count(), 13 + 11 + 5, "errors of position, orientation and tensions");
    let planar = cdpr_in(folder.path(), &format!("chain {} --format json", study("planar-wide-grid.toml"))).json();
    assert_eq!(planar["left_out"].as_array().unwrap().len(), 2);
    assert!(planar["steps"][0]["printed"].is_null(), "another machine has nothing printed of it");
    assert!(!page.contains("more than before the identification") && planar["force_tracking"].is_null());
    let wrong = cdpr_in(folder.path(), &format!("chain {} --region 1,2", study("twin-chain.toml")));
    assert_eq!(wrong.exit_code, 2);
    assert!(wrong.stderr.contains("6 numbers"), "{}", wrong.stderr);
}
