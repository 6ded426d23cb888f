//! Calibration without measured poses in `cdpr identify`.

use super::{cdpr_in, root};

/// Lengths of the planar example at the poses of a study, without the columns of the poses.
fn lengths() -> (tempfile::TempDir, usize) {
    let folder = tempfile::tempdir().unwrap();
    let study = root().join("studies/planar-wide-grid.toml");
    let run = cdpr_in(folder.path(), &format!("simulate {} --out measured.csv", study.display()));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let text = std::fs::read_to_string(folder.path().join("measured.csv")).unwrap();
    let heading: Vec<&str> = text.lines().next().unwrap().split(',').collect();
    let kept: Vec<usize> = (0..heading.len()).filter(|&k| heading[k].starts_with("cable_length")).collect();
    // noise of 0.05 mm, the same in every run
    let noisy = |number: usize, k: usize, field: &str| {
        let noise = 1e-4 * ((7 * number + 3 * k) as f64 * 0.618_033_988_749_895).fract() - 0.5e-4;
        field.parse().map_or(field.to_owned(), |length: f64| (length + noise).to_string())
    };
    let row = |(number, line): (usize, &str)| {
        let fields: Vec<&str> = line.split(',').collect();
        kept.iter().map(|&k| noisy(number, k, fields[k])).collect::<Vec<_>>().join(",") + "\n"
    };
    std::fs::write(folder.path().join("lengths.csv"), text.lines().enumerate().map(row).collect::<String>()).unwrap();
    // every fifth pose is known
    let gaps = |(number, line): (usize, &str)| {
        let fields = line.split(',').enumerate();
        let is_gap = |k: usize| number % 5 != 0 && matches!(heading[k], "x_m" | "y_m");
        fields.map(|(k, field)| if is_gap(k) { "" } else { field }).collect::<Vec<_>>().join(",") + "\n"
    };
    std::fs::write(folder.path().join("gaps.csv"), text.lines().enumerate().map(gaps).collect::<String>()).unwrap();
    (folder, text.lines().count() - 1)
}

#[test]
fn lengths_alone_calibrate_and_the_poses_found_are_data() {
    let (folder, count) = lengths();
    let command = "identify planar-example lengths.csv --free frame-anchor --out-poses found.csv --out calibrated.toml";
    let run = cdpr_in(folder.path(), command);
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let told = "no length changes by: shift along x, shift along y, turn about z";
    assert!(!run.stdout.contains("rated by other criteria"), "{}", run.stdout);
    assert!(run.prose().contains(told), "{}", run.stdout);
    let all = cdpr_in(folder.path(), &format!("{command} --verbose"));
    assert!(all.prose().contains(told) && all.stdout.contains("rank 5 of 8"), "{}", all.stdout);
    let answer = cdpr_in(folder.path(), &format!("{command} --format json")).json();
    assert_eq!((answer["parameter_count"].as_u64(), answer["rank"].as_u64()), (Some(8), Some(5)));
    assert_eq!(answer["gauge"]["held"].as_array().unwrap().len(), 3);
    assert_eq!(answer["gauge"]["free"], serde_json::json!(["translation", "rotation", "mirror"]));
    assert_eq!(answer["poses"].as_array().unwrap().len(), count);
    assert_eq!(answer["poses"][0]["position_m"].as_array().unwrap().len(), 2);
    assert_eq!(answer["frame_anchors_m"].as_array().unwrap().len(), 4);
    let cost = answer["cost_m2"].as_f64().unwrap();
    assert!((answer["length_rms_m"].as_f64().unwrap() - (cost / (4 * count) as f64).sqrt()).abs() < 1e-15);
    // at the poses where they fit best, found anew or measured, the lengths have the same errors
    let anew = cdpr_in(folder.path(), "evaluate calibrated.toml lengths.csv --format json").json();
    assert!(
        (anew["length_error_m"]["rms"].as_f64().unwrap() / answer["length_rms_m"].as_f64().unwrap() - 1.0).abs() < 1e-6
    );
    assert!(anew["position_error_m"]["mean"].is_null() && anew["status"] == "converged", "{anew}");
    let again = cdpr_in(folder.path(), "evaluate calibrated.toml found.csv --format json").json();
    let rms = again["length_error_m"]["rms"].as_f64().unwrap();
    assert!((rms / answer["length_rms_m"].as_f64().unwrap() - 1.0).abs() < 1e-6, "{rms}");
}

#[test]
fn poses_that_are_known_fix_the_gauge() {
    let (folder, _) = lengths();
    let run =
        cdpr_in(folder.path(), "identify planar-example gaps.csv --free frame-anchor --skip-invalid --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json();
    assert_eq!((answer["parameter_count"].as_u64(), answer["rank"].as_u64()), (Some(8), Some(8)));
    assert!(answer["gauge"]["motions"].as_array().unwrap().is_empty());
}

#[test]
fn what_needs_poses_is_refused() {
    let (folder, _) = lengths();
    for (command, code) in [
        ("identify planar-example lengths.csv --free frame-anchor --split region:3", "data::option-needs-poses"),
        ("identify planar-example lengths.csv --free frame-anchor --path lasso", "data::option-needs-poses"),
        ("identify planar-example measured.csv --free frame-anchor --out-poses found.csv", "data::has-poses"),
        ("identify planar-example measured.csv --free frame-anchor --gauge least-change", "data::has-poses"),
        ("select planar-example lengths.csv --criterion position", "data::option-needs-poses"),
        ("select planar-example lengths.csv --regions 3", "data::option-needs-poses"),
        ("select planar-example lengths.csv --loss huber", "data::option-needs-poses"),
    ] {
        let run = cdpr_in(folder.path(), command);
        assert_eq!(run.exit_code, 2, "{command}");
        assert!(run.stderr.contains(code), "{command}: {}", run.stderr);
    }
}

/// Candidates are judged by what they predict of held-out lengths, and the folder of the result is that of data with poses.
#[test]
fn candidates_are_compared_without_poses() {
    let (folder, count) = lengths();
    let command =
        "select planar-example lengths.csv --candidates standard;standard:frame-anchor --split kfold:3 --out res";
    let run = cdpr_in(folder.path(), command);
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let told = "the pose of a sample is what its own rows tell";
    assert!(run.prose().contains(told) && run.stdout.contains("mean cable-length error"), "{}", run.stdout);
    let answer = cdpr_in(folder.path(), &format!("{command} --format json")).json();
    assert_eq!((answer["criterion"].as_str(), answer["samples"].as_u64()), (Some("length"), Some(count as u64)));
    for candidate in answer["candidates"].as_array().unwrap() {
        let validation = &candidate["validation"];
        let error = validation["length_error_m"]["rms"].as_f64().unwrap();
        assert!((2e-5..2e-4).contains(&error) && validation["position_error_m"]["mean"].is_null(), "{validation}");
    }
    for file in ["result.json", "report.html", "calibrated.toml", "validation-errors.csv"] {
        assert!(folder.path().join("res").join(file).exists(), "{file}");
    }
    let page = std::fs::read_to_string(folder.path().join("res/report.html")).unwrap();
    assert_no_pose_errors(&page);
}

/// The page of data without measured poses has neither rows nor words of pose errors.
fn assert_no_pose_errors(page: &str) {
    assert!(page.contains("cable length, mm</td>") && page.contains("rms, mm"), "tables of lengths");
    for words in [
        "position, mm</td>",
        "position mean, mm",
        "rotation, °</td>",
        "at the measured pose.",
        "at the measured pose,",
        "<em>Position</em>: distance",
        "by other criteria than",
    ] {
        assert!(!page.contains(words), "{words}");
    }
}

/// Held-out parts, page and course of a calibration without poses.
#[test]
fn a_calibration_without_poses_is_judged_on_held_out_parts() {
    let (folder, _) = lengths();
    let command = "identify planar-example lengths.csv --free frame-anchor --split kfold:3 --course --report page.html --format json";
    let run = cdpr_in(folder.path(), command);
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json();
    let error = answer["validation"]["length_error_m"]["rms"].as_f64().unwrap();
    assert!((2e-5..2e-4).contains(&error), "{}", answer["validation"]);
    let course = answer["course"].as_array().unwrap();
    let last = course.last().unwrap()["length_rms_m"].as_f64().unwrap();
    assert!(course.len() > 1 && (last / answer["length_rms_m"].as_f64().unwrap() - 1.0).abs() < 1e-6, "{course:?}");
    let page = std::fs::read_to_string(folder.path().join("page.html")).unwrap();
    assert!(page.contains("mean cable-length error") && page.contains("Course"), "page");
    assert_no_pose_errors(&page);
}

/// A platform under four cables with swivelling pulleys, in a file of its own.
const HANGING: &str = r#"
layout_version = 1
name = "hanging"
motion_pattern = "3R3T"
cable_count = 4
gravity_m_s2 = [0.0, 0.0, -9.81]
[platform]
mass_kg = 12.0
center_of_mass_m = [0.0, 0.0, 0.15]
[home_pose]
position_m = [0.0, 0.0, 0.6]
rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
"#;

/// Robot file and run of a hanging platform: lengths, tensions and swivels at equilibria, to a tenth of a millimetre.
fn hanging_run() -> tempfile::TempDir {
    use cdpr_model::equilibrium::elastostatics::{Settings, Solver, Status};
    use cdpr_model::model::{Composition, Model};
    use cdpr_model::robot::Robot;
    use nalgebra::Vector3;
    let corners = [(1.0, -1.1), (1.1, 1.0), (-1.0, 1.2), (-1.2, -1.0)];
    let cable = |(x, y): (f64, f64)| {
        format!(
            "[[cable]]\nname = \"{x} {y}\"\nframe_anchor_m = [{x:?}, {y:?}, 1.8]\nplatform_anchor_m = [{:?}, {:?}, 0.26]\npulley_radius_m = 0.03\n\
             pulley_swivel_axis = [{:?}, 0.0, 0.0]\n",
            0.08 * x,
            0.08 * y,
            x.signum()
        )
    };
    let text = HANGING.to_owned() + &corners.map(cable).concat();
    let robot = Robot::from_toml(&text, "hanging.toml").unwrap();
    let model = Model::new(robot, Composition { pulley: true, ..Composition::STANDARD }).unwrap();
    let load = cdpr_model::statics::Load::of(model.robot()).unwrap();
    let mut solver = Solver::new(&model, &load, &Settings::default()).unwrap();
    let mut table = String::new();
    for (stem, count) in [("cable_length_m", 4), ("tension_N", 4), ("swivel_rad", 4)] {
        (1..=count).for_each(|k| table.push_str(&format!("{stem}_{k},")));
    }
    table = table.trim_end_matches(',').to_owned() + "\n";
    let home = model.robot().home_or_middle();
    let share = |sample: usize, k: u32| 2.0 * (f64::from(k).sqrt() * (sample + 1) as f64).fract() - 1.0;
    for sample in 0..1000 {
        if table.lines().count() > 15 {
            break;
        }
        let mut near = home;
        near.position += Vector3::new(share(sample, 2), share(sample, 3), share(sample, 5)) * 0.35;
        let length = |k: usize| model.path(k, &near).unwrap().0.length + 0.02 * share(sample, [7, 11, 13, 17][k]);
        let lengths: Vec<f64> = (0..4).map(length).collect();
        let solution = solver.solve(&lengths, &near).unwrap();
        if solution.status != Status::Converged || solution.tensions.iter().any(|tension| *tension < 5.0) {
            continue;
        }
        let swivel = |k: usize| model.swivel_angle(k, &solution.pose, &-Vector3::z()).unwrap();
        let numbers = lengths.iter().map(|q| q + 1e-4 * share(sample, 19)).chain(solution.tensions.iter().copied());
        let numbers = numbers.chain((0..4).map(swivel)).map(|number| number.to_string());
        table.push_str(&(numbers.collect::<Vec<_>>().join(",") + "\n"));
    }
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("hanging.toml"), text.replace("[1.1, 1.0, 1.8]", "[1.12, 1.01, 1.8]")).unwrap();
    std::fs::write(folder.path().join("run.csv"), table).unwrap();
    folder
}

#[test]
fn tensions_and_swivels_calibrate_a_platform_that_hangs() {
    let folder = hanging_run();
    let command = "identify hanging.toml run.csv --model pulley --free frame-anchor --sigma length_m=0.0002,tension_N=0.1,swivel_rad=0.001 \
                   --validation run.csv --compare hanging.toml --out calibrated.toml";
    let run = cdpr_in(folder.path(), command);
    assert_eq!(run.exit_code, 0, "{}\n{}", run.stdout, run.stderr);
    for words in
        ["no measurement changes by: shift along x", "swivel: ", "on run.csv: lengths", "beside hanging: anchors are"]
    {
        assert!(run.stdout.contains(words), "{words}: {}", run.stdout);
    }
    let answer = cdpr_in(folder.path(), &format!("{command} --format json")).json();
    assert_eq!(answer["sensors"].as_array().unwrap().len(), 3);
    assert_eq!(answer["gauge"]["free"], serde_json::json!(["translation"]));
    let figures = |answer: &serde_json::Value| {
        let rms = |key: &str| answer[key]["rms"].as_f64().unwrap();
        (rms("length_error_m"), rms("swivel_error_rad"))
    };
    let (before, after) = (figures(&answer["validation"]["before"]), figures(&answer["validation"]));
    assert!(after.0 < 2e-4 && after.1 < 1e-3 && before.0 > 3.0 * after.0, "{before:?} {after:?}");
    let evaluated = cdpr_in(
        folder.path(),
        "evaluate calibrated.toml run.csv --model pulley --sigma length_m=0.0002,swivel_rad=0.001 --format json",
    );
    let again = figures(&evaluated.json());
    assert!((again.0 / after.0 - 1.0).abs() < 1e-3, "{again:?} {after:?}");
    let least = cdpr_in(folder.path(), &format!("{command} --gauge least-change --format json")).json();
    assert_eq!(
        (least["gauge"]["kind"].as_str(), least["rank"].as_u64()),
        (Some("least-change"), answer["rank"].as_u64())
    );
    let cost = |answer: &serde_json::Value| answer["history"].as_array().unwrap().last().unwrap().as_f64().unwrap();
    assert!((cost(&least) / cost(&answer) - 1.0).abs() < 1e-6, "{} {}", cost(&least), cost(&answer));
    let known = "--known level[1,2,3,4]+-0.01 --known distance[1,2]=2.1+-0.05";
    assert_eq!(cdpr_in(folder.path(), &format!("{command} {known}")).exit_code, 0);
}

#[test]
fn what_no_sensor_tells_is_refused_in_words() {
    let folder = hanging_run();
    let text = std::fs::read_to_string(folder.path().join("run.csv")).unwrap();
    let part = |kept: usize, head: &dyn Fn(&str) -> String| -> String {
        let row = |(number, line): (usize, &str)| {
            let line = line.split(',').take(kept).collect::<Vec<_>>().join(",") + "\n";
            if number == 0 { head(&line) } else { line }
        };
        text.lines().enumerate().map(row).collect()
    };
    std::fs::write(folder.path().join("lengths.csv"), part(4, &str::to_owned)).unwrap();
    let changes = part(8, &|head: &str| head.replace("cable_length_m", "cable_length_change_m"));
    std::fs::write(folder.path().join("changes.csv"), changes).unwrap();
    for (command, code) in [
        ("identify hanging.toml lengths.csv --model pulley --free frame-anchor", "data::no-equations"),
        ("evaluate hanging.toml lengths.csv --model pulley", "data::no-equations"),
        ("identify hanging.toml changes.csv --model pulley --free frame-anchor", "data::no-start-lengths"),
        ("identify hanging.toml run.csv --model pulley --free frame-anchor --gauge known", "data::gauge-open"),
        ("identify hanging.toml run.csv --model pulley --free frame-anchor --known height[1]", "known::syntax"),
        ("identify hanging.toml run.csv --model pulley --free frame-anchor --known level[1,7]", "known::not-of-robot"),
        ("identify hanging.toml run.csv --model pulley --free frame-anchor --drive s.toml", "data::option-needs-poses"),
        ("identify planar-example run.csv --free frame-anchor", "data::no-swivel-zero"),
        ("select hanging.toml lengths.csv", "candidate::all-failed"),
    ] {
        let run = cdpr_in(folder.path(), command);
        assert_eq!(run.exit_code, 2, "{command}: {}", run.stdout);
        assert!(run.stderr.contains(code), "{command}: {}", run.stderr);
    }
}

/// A copy of a case beside the project; `None` where it is absent.
fn case(name: &str) -> Option<tempfile::TempDir> {
    let source = root().join("../shared/cases").join(name);
    let Ok(files) = std::fs::read_dir(&source) else {
        assert!(std::env::var("CI").as_deref() != Ok("true"), "CI must have {}", source.display());
        return None;
    };
    let folder = tempfile::tempdir().unwrap();
    for file in files.flatten() {
        std::fs::copy(file.path(), folder.path().join(file.file_name())).unwrap();
    }
    Some(folder)
}

/// Recorded lengths of a gear that is off by 5 % fit as well as any, and the poses of the fit are 832 mm off: no answer is silent about the scale, and a
/// distance is named that tells it.
#[test]
fn a_wrong_gear_is_told_where_no_pose_shows_it() {
    let Some(folder) = case("07-selfcalibration-gear-5-percent-camera") else { return };
    for data in ["data.csv", "right-gear.csv"] {
        let run = cdpr_in(folder.path(), &format!("select robot.toml {data} --format json"));
        let answer = run.json();
        assert_ne!(answer["status"], "recommended", "{data}: {}", answer["reason"]);
        let warnings = answer["warnings"].to_string();
        assert!(warnings.contains("a common scale of the recorded lengths"), "{data}: {warnings}");
        assert!(warnings.contains("measure the distance"), "{data}: {warnings}");
        for candidate in answer["candidates"].as_array().unwrap() {
            let told = candidate["pose_band_m"].as_f64().unwrap();
            assert!(told > 0.01, "{data}: {} has a band of {told} m", candidate["name"]);
        }
    }
    let run = cdpr_in(folder.path(), "identify robot.toml data.csv --free length-offset --format json");
    let answer = run.json();
    assert!(answer["warnings"].to_string().contains("a common scale of the recorded lengths"), "{answer}");
    // an accuracy that is stated is no assumption
    let stated = "identify robot.toml data.csv --free length-offset --sigma length_scale=0.05 --format json";
    let run = cdpr_in(folder.path(), stated);
    let told = run.json()["warnings"].to_string();
    assert!(told.contains("stated: 5 %") && run.exit_code == 1, "{told}");
}
