//! `cdpr run`, `cdpr modes` and `cdpr dynamics`: machines in time.

use super::{cdpr, cdpr_in, numbers, root};

/// A plate in a vertical plane on four springs.
pub(super) const PLATE: &str = "layout_version = 1\nname = \"moving-plate\"\nmotion_pattern = \"1R2T\"\naxes = \"xz\"\n\
    gravity_m_s2 = [0, -9.81]\n[platform]\nmass_kg = 5.0\ncenter_of_mass_m = [0.02, 0.05]\ninertia_about_center_of_mass_kg_m2 = 0.2\n\
    [cable_defaults]\nspring_constant_N_per_m = 3000.0\ntension_min_N = 10.0\ntension_max_N = 500.0\n\
    [[cable]]\nname = \"1\"\nframe_anchor_m = [0, 0]\nplatform_anchor_m = [-0.2, 0.1]\n\
    [[cable]]\nname = \"2\"\nframe_anchor_m = [4, 0]\nplatform_anchor_m = [0.2, 0.1]\n\
    [[cable]]\nname = \"3\"\nframe_anchor_m = [4, 3]\nplatform_anchor_m = [0.2, -0.1]\n\
    [[cable]]\nname = \"4\"\nframe_anchor_m = [0, 3]\nplatform_anchor_m = [-0.2, -0.1]\n";

pub(super) const SCENARIO: &str = "[machine]\nrobot = \"plate-in-motion.toml\"\ncable_damping_N_s_per_m = 5.0\n[start]\npose = [1.9, 1.4, 0]\n\
    tension_method = \"closed-form\"\ndisplacement = [0.02, 0, 0.03]\n[[event]]\ntime_s = 0.1\nkind = \"cable-break\"\ncable = 2\n\
    [time]\nduration_s = 0.2\nstep_s = 0.001\nrecord_s = 0.01\n";

pub(super) fn folder(scenario: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("plate-in-motion.toml"), PLATE).unwrap();
    std::fs::write(folder.path().join("scenario.toml"), scenario).unwrap();
    folder
}

/// The log by columns.
fn log(folder: &std::path::Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = std::fs::read_to_string(folder.join("out/log.csv")).unwrap();
    let mut lines = text.lines();
    let names = lines.next().unwrap().split(',').map(str::to_owned).collect();
    (names, lines.map(|line| line.split(',').map(|field| field.parse().unwrap()).collect()).collect())
}

/// Assumed numbers are told where they count: all of a file by `check`, those that the motion rests on by `run` (text, JSON, page) and `modes`.
#[test]
fn assumed_numbers_are_told_where_they_count() {
    let assumed = "[[assumption]]\nkey = \"platform.mass_kg\"\nreason = \"weighed by eye\"\n[[assumption]]\nkey = \"cable.drum_inertia_kg_m2\"\n\
                   reason = \"a guess\"\n[[assumption]]\nkey = \"cable.cable_damping_N_s_per_m\"\nreason = \"of a rope\"\n[platform]\n";
    let more =
        "drum_radius_m = 0.05\ndrum_inertia_kg_m2 = 0.02\ncable_damping_N_s_per_m = 2.0\n[[cable]]\nname = \"1\"";
    let plate = PLATE.replace("[platform]\n", assumed).replace("[[cable]]\nname = \"1\"", more);
    let folder = folder(SCENARIO);
    std::fs::write(folder.path().join("plate-in-motion.toml"), plate).unwrap();
    let keys = |answer: &serde_json::Value| -> Vec<String> {
        let all = answer["assumptions"].as_array().unwrap().iter();
        all.map(|one| one["key"].as_str().unwrap().to_owned()).collect()
    };
    let [mass, inertia, damping] = ["platform.mass_kg", "cable.drum_inertia_kg_m2", "cable.cable_damping_N_s_per_m"];
    let check = cdpr_in(folder.path(), "check plate-in-motion.toml --format json").json();
    assert_eq!(keys(&check), [mass, inertia, damping]);
    assert_eq!(check["assumptions"][0]["reason"], "weighed by eye");
    assert!(cdpr_in(folder.path(), "check plate-in-motion.toml").stdout.contains("cable.drum_inertia_kg_m2: a guess"));
    // the scenario has a damping of its own, and ideal winches
    let run = cdpr_in(folder.path(), "run scenario.toml --out out");
    assert!(run.stdout.contains("rests on assumed numbers\n  platform.mass_kg: weighed by eye\n"), "{}", run.stdout);
    let result = std::fs::read(folder.path().join("out/result.json")).unwrap();
    assert_eq!(keys(&serde_json::from_slice(&result).unwrap()), [mass]);
    let page = std::fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    assert!(page.contains("Assumed numbers") && page.contains("platform.mass_kg (weighed by eye)"));
    let modes = |winches: &str| {
        let command = format!("modes plate-in-motion.toml --pose 1.9,1.4,0 --winches {winches} --format json");
        keys(&cdpr_in(folder.path(), &command).json())
    };
    assert_eq!((modes("ideal"), modes("drums").len()), (vec![mass.to_owned(), damping.to_owned()], 3));
    let dynamics = |more: &str| {
        let run =
            cdpr_in(folder.path(), &format!("dynamics plate-in-motion.toml --pose 1.9,1.4,0{more} --format json"));
        keys(&run.json())
    };
    assert_eq!(
        (dynamics(""), dynamics(" --model elastic --lengths 2.1,2.2,2.3,2.2")),
        (vec![mass.to_owned()], vec![mass.to_owned(), damping.to_owned()])
    );
    let told = cdpr_in(folder.path(), "dynamics plate-in-motion.toml --pose 1.9,1.4,0").stdout;
    assert!(told.contains("rests on assumed numbers\n  platform.mass_kg: weighed by eye\n"), "{told}");
    let robots = cdpr("robots --format json").json();
    let macarm = robots["robots"].as_array().unwrap().iter().find(|robot| robot["name"] == "macarm").unwrap();
    assert_eq!(macarm["assumptions"][0], mass);
}

/// 1 kg·m² about every axis is what nobody measured; dynamics used to answer without a word.
#[test]
fn dynamics_warns_of_placeholder_inertias() {
    for (robot, part) in
        [("ipanema-2", "1.000 kg·m² about every axis, for 10.00 kg"), ("kntu-planar", "0.1000 kg·m², for")]
    {
        let home = cdpr(&format!("check {robot} --format json")).json();
        assert_eq!(home["status"], "checked");
        let pose = if robot == "kntu-planar" { "0,0,0" } else { "0,0,1,0,0,0" };
        let run = cdpr(&format!("dynamics {robot} --pose {pose} --format json"));
        let warnings = run.json()["warnings"].to_string();
        assert!(warnings.contains("looks like a placeholder") && warnings.contains(part), "{robot}: {warnings}");
    }
    let measured = cdpr("dynamics cogiro --pose 0,0,2,0,0,0 --format json").json();
    assert!(!measured["warnings"].to_string().contains("placeholder"), "{measured}");
    let assumed = cdpr("dynamics macarm --pose 0,0,0,0,0,0 --format json").json();
    assert_eq!(assumed["assumptions"][0]["key"], "platform.mass_kg", "{assumed}");
}

#[test]
fn a_run_leaves_its_rows_and_its_end() {
    let folder = folder(SCENARIO);
    let run = cdpr_in(folder.path(), "run scenario.toml --out out --format json");
    let answer = run.json_with(&["status", "steps", "final", "tension_min_N", "tension_max_N", "events"]);
    assert_eq!((answer["status"].as_str(), answer["steps"].as_u64()), (Some("completed"), Some(200)));
    assert_eq!(answer["events"][0]["kind"], "cable-break");
    assert_eq!(answer["events"][0]["cable"], 2);
    let (names, rows) = log(folder.path());
    let expected = "t_s x_m z_m angle_rad tension_N_1 tension_N_2 tension_N_3 tension_N_4 cable_length_m_1";
    assert!(names.join(" ").starts_with(expected), "{names:?}");
    assert_eq!(rows.len(), 21);
    // before the event, then after it
    assert!(rows[10][0] == 0.1 && rows[10][5] > 0.0 && rows[11][5] == 0.0);
    let last = &answer["final"];
    assert_eq!(numbers(&last["position_m"]), rows[20][1..3]);
    assert_eq!(last["angle_rad"].as_f64(), Some(rows[20][3]));
    assert_eq!(numbers(&last["tensions_N"]), rows[20][4..8]);
    assert!(last["angular_velocity_rad_s"].is_f64() && numbers(&last["velocity_m_s"]).len() == 2);
    let file: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("out/result.json")).unwrap()).unwrap();
    assert_eq!(file, answer);
    for name in ["report.html", "log.mcap", "tensions.svg", "pose.svg"] {
        assert!(std::fs::metadata(folder.path().join("out").join(name)).unwrap().len() > 1000, "{name}");
    }
    let violations = answer["violations"].as_array().unwrap();
    assert!(violations.iter().all(|one| one["cable"] != 2), "a broken cable breaks no limit: {violations:?}");
    assert_eq!(answer["warnings"].as_array().unwrap().is_empty(), violations.is_empty());
    assert_eq!(run.exit_code, i32::from(!violations.is_empty()), "{}", run.stderr);
    // the same input, the same bytes
    let bytes = std::fs::read(folder.path().join("out/log.csv")).unwrap();
    assert_eq!(cdpr_in(folder.path(), "run scenario.toml --out out --quiet").exit_code, run.exit_code);
    assert_eq!(std::fs::read(folder.path().join("out/log.csv")).unwrap(), bytes);
}

/// A machine that rests is measured as a robot is: the log is a measurement file.
#[test]
fn rows_are_measurements() {
    let folder =
        folder(&SCENARIO.replace("displacement = [0.02, 0, 0.03]\n", "").replace("time_s = 0.1", "time_s = 0.2"));
    assert_eq!(cdpr_in(folder.path(), "run scenario.toml --out out").exit_code, 0);
    let run = cdpr_in(folder.path(), "evaluate plate-in-motion.toml out/log.csv --model elastic --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let worst = run.json()["position_error_m"]["max"].as_f64().unwrap();
    assert!(worst < 1e-9, "at rest the plant is the forward problem: {worst:e}");
}

#[test]
fn what_cannot_run_says_where_and_why() {
    for (old, new, line, told) in [
        ("step_s = 0.001\nrecord_s = 0.01", "step_s = 0.05", 14, "use step_s = "),
        ("= 5.0", "= -5.0", 3, "0 or more"),
        ("cable = 2", "cable = 7", 11, "from 1 to 4"),
        ("[1.9, 1.4, 0]", "[1.9, 9.4, 0]", 4, "no equilibrium"),
        ("kind = \"cable-break\"", "kind = \"cable-brake\"", 10, "cable-break"),
    ] {
        let folder = folder(&SCENARIO.replace(old, new));
        let run = cdpr_in(folder.path(), "run scenario.toml --out out");
        assert_eq!(run.exit_code, 2, "{new}: {}", run.stderr);
        assert!(run.stderr.contains(&format!("scenario.toml:{line}:")), "{new}: {}", run.stderr);
        assert!(run.stderr.contains(told), "{new}: {}", run.stderr);
        assert!(!folder.path().join("out/result.json").exists());
    }
    let folder = folder(SCENARIO);
    let without = PLATE.replace("inertia_about_center_of_mass_kg_m2 = 0.2\n", "");
    std::fs::write(folder.path().join("plate-in-motion.toml"), without).unwrap();
    let run = cdpr_in(folder.path(), "run scenario.toml --out out");
    assert!(run.exit_code == 2 && run.stderr.contains("inertia_about_center_of_mass_kg_m2"), "{}", run.stderr);
}

/// A run that is killed leaves whole rows up to then, and no result.
#[cfg(unix)]
#[test]
fn a_killed_run_leaves_a_readable_log() {
    let long =
        SCENARIO.replace("duration_s = 0.2", "duration_s = 20000").replace("record_s = 0.01", "record_s = 0.001");
    let folder = folder(&long);
    let path = folder.path().join("out/log.csv");
    let program = assert_cmd::cargo::cargo_bin("cdpr");
    let mut command = std::process::Command::new(program);
    command.current_dir(folder.path()).args(["run", "scenario.toml", "--out", "out", "--quiet", "--yes"]);
    let mut child = command.spawn().unwrap();
    while std::fs::metadata(&path).map_or(0, |file| file.len()) < 200_000 {
        assert!(child.try_wait().unwrap().is_none(), "it ended by itself");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.ends_with('\n'));
    let (names, rows) = log(folder.path());
    assert!(rows.len() > 500 && rows.iter().all(|row| row.len() == names.len()));
    assert!(!folder.path().join("out/result.json").exists());
}

#[test]
fn the_scenario_of_the_book_runs() {
    let folder = tempfile::tempdir().unwrap();
    let scenario = root().join("studies/scenario-cable-break.toml");
    let run = cdpr_in(folder.path(), &format!("run {} --out out --format json", scenario.display()));
    let answer = run.json();
    assert_eq!((run.exit_code, answer["status"].as_str()), (1, Some("completed")), "{}", run.stderr);
    assert!(answer["reason"].as_str().unwrap().starts_with("limits are broken: "), "{}", answer["reason"]);
    let (_, rows) = log(folder.path());
    assert_eq!(rows.len(), 301);
    assert!(rows[101..].iter().all(|row| row[10] == 0.0), "cable 3 is broken");
}

/// The same scenario by the integrator with error control: as many rows, the same end to the error of the fixed steps, fewer steps.
#[test]
fn a_run_with_error_control_ends_where_the_fixed_steps_do() {
    let run = |text: &str| {
        let folder = folder(text);
        let run = cdpr_in(folder.path(), "run scenario.toml --out out --format json");
        // cable 4 ends below its least tension
        assert_eq!((run.exit_code, &run.json()["status"]), (1, &"completed".into()), "{}", run.stderr);
        (log(folder.path()).1, run.json())
    };
    let (fixed, _) = run(SCENARIO);
    let (controlled, answer) = run(&(SCENARIO.to_owned() + "integrator = \"error-controlled\"\n"));
    assert_eq!(answer["integrator"], "error-controlled");
    assert!(answer["steps"].as_u64().unwrap() < 200, "{}", answer["steps"]);
    assert_eq!(fixed.len(), controlled.len());
    for (one, other) in fixed.iter().zip(&controlled) {
        // time and pose; a cable that goes slack within a step costs the fixed one its order
        let gap = (0..4).map(|column| (one[column] - other[column]).abs()).fold(0.0, f64::max);
        assert!(gap < 1e-6, "{gap:e} at {} s", one[0]);
    }
    let folder = folder(&(SCENARIO.to_owned() + "tolerance = 1e-9\n"));
    let refused = cdpr_in(folder.path(), "run scenario.toml --out out");
    assert!(refused.exit_code == 2 && refused.stderr.contains("scenario.toml:16:"), "{}", refused.stderr);
}

/// Forward dynamics give the acceleration that inverse dynamics were asked for; cables at rest carry the load; lengths are those of the tensions.
#[test]
fn forward_and_inverse_dynamics_are_told() {
    let folder = folder(SCENARIO);
    let ask = |options: &str| {
        let asked = format!("dynamics plate-in-motion.toml --pose 1.9,1.4,0.1 {options} --format json");
        let run = cdpr_in(folder.path(), &asked);
        assert!(run.exit_code <= 1, "{}", run.stderr);
        run.json_with(&["status", "mass_matrix", "bias", "acceleration_m_s2", "cables", "tensions_N"])
    };
    let near = |found: &[f64], expected: &[f64]| found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9);
    let list = |answer: &serde_json::Value| {
        let words: Vec<String> = numbers(answer).iter().map(f64::to_string).collect();
        words.join(",")
    };
    let acceleration = |answer: &serde_json::Value| {
        let turning = answer["angular_acceleration_rad_s2"].as_f64().unwrap();
        [numbers(&answer["acceleration_m_s2"]), vec![turning]].concat()
    };
    let wanted = [0.5, -1.0, 2.0];
    let inverse = ask("--twist 1,2,3 --acceleration=0.5,-1,2");
    assert!(near(&acceleration(&inverse), &wanted), "{inverse}");
    assert!((inverse["mass_matrix"][0][0].as_f64().unwrap() - 5.0).abs() < 1e-12);
    // m a of the centre of mass, which ω = 3 rad/s pulls inwards, and the weight of 5 kg: by hand
    let (sin, cos) = 0.1_f64.sin_cos();
    let center = [0.02 * cos - 0.05 * sin, 0.02 * sin + 0.05 * cos];
    let force = [
        5.0 * (0.5 - 2.0 * center[1] - 9.0 * center[0]),
        5.0 * (-1.0 + 2.0 * center[0] - 9.0 * center[1]) + 5.0 * 9.81,
    ];
    assert!(near(&numbers(&inverse["cables"]["force_N"]), &force), "{inverse} {force:?}");
    let forward = ask(&format!("--twist 1,2,3 --tensions {}", list(&inverse["tensions_N"])));
    assert!(near(&acceleration(&forward), &wanted), "{forward}");
    // winches hold the lengths that ik tells for tensions: the cables have these tensions, and the platform stays
    let rest = ask("");
    assert!(near(&acceleration(&rest), &[0.0; 3]), "{rest}");
    let tensions = list(&rest["tensions_N"]);
    let told =
        format!("ik plate-in-motion.toml --pose 1.9,1.4,0.1 --model elastic --tensions {tensions} --format json");
    let lengths = list(&cdpr_in(folder.path(), &told).json()["controlled_lengths_m"]);
    let held = ask(&format!("--model elastic --lengths {lengths}"));
    assert!(near(&acceleration(&held), &[0.0; 3]), "{held}");
    assert!(near(&numbers(&held["tensions_N"]), &numbers(&rest["tensions_N"])), "{held}");
    let beyond = ask("--acceleration 0,5000,0");
    assert!(beyond["status"] == "infeasible" && beyond["tensions_N"].is_null(), "{beyond}");
    let words = cdpr_in(folder.path(), "dynamics plate-in-motion.toml --pose 1.9,1.4,0 --acceleration 0,1,0").stdout;
    assert!(words.contains("mass matrix") && words.contains("tension N"), "{words}");
    let rigid = cdpr_in(folder.path(), &format!("dynamics plate-in-motion.toml --pose 1.9,1.4,0 --lengths {lengths}"));
    assert!(rigid.exit_code == 2 && rigid.stderr.contains("does not stretch"), "{}", rigid.stderr);
    let short = cdpr_in(folder.path(), "dynamics plate-in-motion.toml --pose 1.9,1.4,0 --twist 1");
    assert!(short.exit_code == 2 && short.stderr.contains("--twist"), "{}", short.stderr);
}

/// The frequencies of `modes` are those of the criterion, whose lowest one has its own derivation.
#[test]
fn modes_are_told_slowest_first() {
    let folder = folder(SCENARIO);
    let run = cdpr_in(folder.path(), "modes plate-in-motion.toml --pose 1.9,1.4,0 --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["status", "modes", "system_matrix", "input_matrix", "mass_matrix", "step_max_s"]);
    let frequencies: Vec<f64> =
        answer["modes"].as_array().unwrap().iter().map(|mode| mode["frequency_Hz"].as_f64().unwrap()).collect();
    assert_eq!(frequencies.len(), 3);
    assert!(frequencies.is_sorted() && frequencies[0] > 1.0, "{frequencies:?}");
    let shares: f64 = numbers(&answer["modes"][0]["participation"]).iter().sum();
    assert!((shares - 1.0).abs() < 1e-12);
    let words = cdpr_in(folder.path(), "modes plate-in-motion.toml --pose 1.9,1.4,0").stdout;
    assert!(words.contains("Hz") && words.contains("turn"), "{words}");
    assert!(cdpr("schema scenario").stdout.contains("cable_damping_N_s_per_m"));
}

/// One set of sec. 5.4: load of eq. 5.12, stator and cabin with two passengers of eq. 5.13 and 5.14. Without the stator the machine turned at up to 12.9 Hz.
#[test]
fn the_simulator_in_motion_turns_with_stator_and_cabin() {
    let robot = root().join("studies/robots/simulator-in-motion.toml");
    let run = cdpr(&format!("modes {} --pose 0,0,1.5,0,0,0 --format json", robot.display()));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json();
    for (axis, inertia) in [90.8 + 117.0, 87.0 + 121.0, 4.7 + 62.5].into_iter().enumerate() {
        // about the origin: the centre of mass lies 0.08 m behind it
        let shift = if axis == 0 { 0.0 } else { 764.5 * 0.08 * 0.08 };
        let found = answer["mass_matrix"][3 + axis][3 + axis].as_f64().unwrap();
        assert!((found - inertia - shift).abs() < 1e-9, "{axis}: {found}");
    }
    let modes: Vec<f64> =
        answer["modes"].as_array().unwrap().iter().map(|mode| mode["frequency_Hz"].as_f64().unwrap()).collect();
    for (found, expected) in modes[3..].iter().zip([8.991, 9.289, 9.996]) {
        // recomputed elsewhere by central differences
        assert!((found - expected).abs() < 2e-3, "{modes:?}");
    }
}

/// Machine, data, model: what sensors see of a machine that stands at places leads back to its anchors.
#[test]
fn what_sensors_see_identifies_the_machine() {
    let folder = tempfile::tempdir().unwrap();
    let scenario = root().join("studies/scenario-measuring.toml");
    let run = cdpr_in(folder.path(), &format!("run {} --out out --format json", scenario.display()));
    assert_eq!((run.exit_code, &run.json()["violations"]), (0, &serde_json::json!([])), "{}", run.stdout);
    // somebody measured the first anchor badly
    let truth = std::fs::read_to_string(root().join("studies/robots/simulator-in-motion.toml")).unwrap();
    let wrong = truth.replace("frame_anchor_m = [-5.431, 7.505, 6.496]", "frame_anchor_m = [-5.331, 7.455, 6.496]");
    assert_ne!(truth, wrong);
    std::fs::write(folder.path().join("wrong.toml"), wrong).unwrap();
    let identify = "identify wrong.toml out/measurements.csv --merge out/tracker.csv --static --model elastic --free frame-anchor --out calibrated.toml --format json";
    let found = cdpr_in(folder.path(), identify);
    assert_eq!(found.exit_code, 0, "{}", found.stderr);
    let answer = found.json_with(&["status", "parameters", "train", "warnings"]);
    // sixteen places; twelve were found, with rows of motion in their means
    let told = answer["warnings"].to_string();
    assert!(answer["samples"] == 16 && told.contains("16 poses are held"), "{told}");
    // no motion of the winches is averaged: lengths scatter by the encoders' resolution of 0.1 mm, 0.03 mm as a deviation (positions by the swing of the platform, too)
    let scatter = told.split("scatters about its pose by ").nth(1).unwrap();
    let length = scatter.split(", ").find_map(|part| part.strip_suffix(" mm of length")).unwrap();
    assert!(length.parse::<f64>().unwrap() < 0.03, "{scatter}");
    let parameters = answer["parameters"].as_array().unwrap();
    for (axis, expected) in [-5.431, 7.505, 6.496].into_iter().enumerate() {
        let (value, sigma) = (&parameters[axis]["value"], &parameters[axis]["sigma"]);
        let error = (value.as_f64().unwrap() - expected).abs();
        // rows of a hold are averaged, so that the stated deviations of single rows are generous
        assert!(
            error < 3.0 * sigma.as_f64().unwrap() && error < 0.005,
            "{} {value} ± {sigma}",
            parameters[axis]["name"]
        );
    }
    // noise of 1 mm in some 120 rows a hold, and what is left of the platform's swing: 0.29 mm
    assert!(answer["train"]["position_error_m"]["mean"].as_f64().unwrap() < 4e-4);
    // a calibration makes no assumption a measurement
    let assumed = |file: &str| {
        let check = cdpr_in(folder.path(), &format!("check {file} --format json")).json();
        check["assumptions"].as_array().unwrap().clone()
    };
    assert!(assumed("wrong.toml").len() == 5 && assumed("calibrated.toml") == assumed("wrong.toml"));
}
