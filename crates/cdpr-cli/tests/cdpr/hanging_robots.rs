//! `simulate`, `evaluate` and `select` of robots with fewer cables than degrees of freedom.

use super::cdpr_in;
use super::selection::contents;

/// A platform on four cables, and the study that records where it hangs while its winches read 30 mm too much.
const HANGING: &str = r#"layout_version = 1
name = "hanging"
motion_pattern = "3R3T"
gravity_m_s2 = [0.0, 0.0, -9.81]

[platform]
mass_kg = 12.0
center_of_mass_m = [0.0, 0.0, 0.0]

[home_pose]
position_m = [0.0, 0.0, 0.8]
rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
"#;

const HANGING_STUDY: &str = r#"[control]
robot = "hanging.toml"
[machine]
robot = "machine.toml"
[initial]
pose = [0, 0, 0.8, 0, 0, 0]
offset = "none"
[poses.grid]
min = [-0.6, -0.4, 0.6, 0, 0, 0]
max = [0.6, 0.4, 1.0, 0, 0, 0]
count = [4, 4, 4, 1, 1, 1]
[noise]
position_m = 0.001
length_m = 0.0002
"#;

/// The robot, the same without its mass, and what it records as `data.csv`.
fn hanging() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let robot = |offset: f64| {
        let mut text = HANGING.to_owned();
        for index in 0..4 {
            let (x, y) = ([-1.0, 1.0][index % 2], [-1.0, 1.0][index / 2]);
            let (frame, platform) = ([2.0 * x, 1.5 * y, 2.5], [0.2 * x, 0.15 * y, 0.1]);
            text += &format!("\n[[cable]]\nname = \"{}\"\nframe_anchor_m = {frame:?}\n", index + 1);
            text += &format!("platform_anchor_m = {platform:?}\nlength_offset_m = {offset:?}\n");
        }
        text
    };
    let without_mass = robot(0.0).replace("mass_kg = 12.0\n", "");
    for (name, text) in [
        ("hanging.toml", robot(0.0)),
        ("machine.toml", robot(0.03)),
        ("unknown.toml", without_mass),
        ("study.toml", HANGING_STUDY.to_owned()),
    ] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let run = cdpr_in(folder.path(), "simulate study.toml --out data.csv --seed 1");
    assert_eq!(run.exit_code, 0, "{}{}", run.stdout, run.stderr);
    folder
}

fn has_nan(text: &str) -> bool {
    text.split(|c: char| !c.is_ascii_alphanumeric()).any(|word| word == "NaN")
}

/// Fewer cables than degrees of freedom: under a known load every command answers by the equilibrium.
#[test]
fn a_hanging_robot_is_simulated_judged_and_selected_by_its_equilibrium() {
    let folder = hanging();
    let accuracy = cdpr_in(folder.path(), "accuracy study.toml --format json").json();
    assert_eq!(accuracy["statuses"]["converged"], 64, "{accuracy}");
    assert!(accuracy["position_error_m"]["mean"].as_f64().unwrap() > 0.01, "{accuracy}");
    assert!(accuracy["tension_max_N"].as_f64().unwrap() > 10.0, "{accuracy}");
    let run = cdpr_in(folder.path(), "evaluate machine.toml data.csv --format json");
    let evaluated = run.json_with(&["answered", "length_samples", "tension_error_N"]);
    assert_eq!((run.exit_code, &evaluated["answered"]), (0, &64.into()));
    // 1 mm per axis of a pose that swings more easily than 0.2 mm of cable
    assert!((0.001..0.004).contains(&evaluated["position_error_m"]["mean"].as_f64().unwrap()), "{evaluated}");
    let run = cdpr_in(folder.path(), "select hanging.toml data.csv --split kfold:4 --format json");
    let selected = run.json();
    assert_eq!((run.exit_code, &selected["recommended"]), (0, &"standard:length-offset".into()), "{selected}");
    for candidate in selected["candidates"].as_array().unwrap() {
        let error = candidate["criterion"].as_f64();
        assert!(error.is_none_or(|error| error > 5e-4), "{candidate}");
    }
}

/// Without a load its lengths determine no pose: no value, no recommendation, and every page says so.
#[test]
fn a_robot_whose_pose_nothing_determines_is_not_recommended_with_an_error_of_zero() {
    let folder = hanging();
    let run = cdpr_in(folder.path(), "evaluate unknown.toml data.csv --format json");
    let evaluated = run.json();
    assert_eq!((run.exit_code, &evaluated["status"]), (1, &"not-converged".into()));
    assert!(evaluated["position_error_m"]["mean"].is_null() && evaluated["rotation_error_rad"]["max"].is_null());
    assert_eq!((&evaluated["answered"], &evaluated["not_converged"]), (&0.into(), &64.into()));
    assert!((evaluated["length_error_m"]["mean_abs"].as_f64().unwrap() - 0.03).abs() < 1e-3);
    let run = cdpr_in(folder.path(), "evaluate unknown.toml data.csv");
    assert!(run.stdout.contains("64 of 64 samples has no answer") && !has_nan(&run.stdout), "{}", run.stdout);

    let arguments = "select unknown.toml data.csv --split kfold:4 --require position_mean_m=0.01 --out result";
    let run = cdpr_in(folder.path(), arguments);
    assert_eq!(run.exit_code, 1, "{}", run.stdout);
    assert!(run.stdout.contains("cannot be judged") && !has_nan(&run.stdout), "{}", run.stdout);
    let files = contents(&folder.path().join("result"));
    assert!(!files.contains_key("calibrated.toml"));
    for (name, bytes) in files {
        assert!(name == "report.html" || !has_nan(&String::from_utf8(bytes).unwrap()), "{name}");
    }
    let page = std::fs::read_to_string(folder.path().join("result/report.html")).unwrap();
    let (words, _) = page.split_once("<script").unwrap();
    assert!(words.contains("no candidate can be judged") && !has_nan(words), "{words}");
    let run = cdpr_in(folder.path(), "select unknown.toml data.csv --split kfold:4 --criterion length --format json");
    let by_length = run.json();
    assert_eq!((run.exit_code, &by_length["recommended"]), (0, &"standard:length-offset".into()), "{by_length}");

    let study = HANGING_STUDY.replace("hanging.toml", "unknown.toml").replace("machine.toml", "unknown.toml");
    std::fs::write(folder.path().join("study.toml"), study).unwrap();
    let run = cdpr_in(folder.path(), "accuracy study.toml");
    assert!(run.exit_code == 1 && !has_nan(&run.stdout), "{}", run.stdout);
}

/// Angles, belts and tensions of SciPy's statics (case `mural-carriage`), to the decimals that are printed there.
#[test]
fn a_position_alone_is_completed_by_the_load() {
    let Some(folder) = super::mistaken_inputs::case("mural-carriage") else { return };
    for (position, angle, lengths) in
        [("0.3,-0.5", -0.414_089, [0.549_787, 1.090_615]), ("1.0,-0.9", 0.567_044, [1.331_337, 0.916_574])]
    {
        let run = cdpr_in(folder.path(), &format!("ik robot.toml --position {position} --format json"));
        let answer = run.json();
        assert_eq!((run.exit_code, &answer["status"]), (0, &"solved".into()), "{}", run.stderr);
        assert!((answer["pose"]["angle_rad"].as_f64().unwrap() - angle).abs() < 6e-7, "{answer}");
        for (own, wanted) in answer["cable_lengths_m"].as_array().unwrap().iter().zip(lengths) {
            assert!((own.as_f64().unwrap() - wanted).abs() < 6e-7, "{answer}");
        }
        let stability: Vec<&str> =
            answer["solutions"].as_array().unwrap().iter().map(|one| one["stability"].as_str().unwrap()).collect();
        assert_eq!(stability, ["stable", "unstable"]);
        // with these lengths it hangs there
        let own = &answer["cable_lengths_m"];
        let fk = cdpr_in(folder.path(), &format!("fk robot.toml --lengths {},{} --format json", own[0], own[1])).json();
        assert!((fk["pose"]["angle_rad"].as_f64().unwrap() - angle).abs() < 6e-7, "{fk}");
    }
    // level, the pen cannot be there
    let level = cdpr_in(folder.path(), "ik robot.toml --pose 0.3,-0.5,0");
    assert!(
        level.stdout.contains("caution: the load does not let the platform rest")
            && level.stdout.contains("22.7° away"),
        "{}",
        level.stdout
    );
    assert_eq!(cdpr_in(folder.path(), "ik robot.toml --pose 0.65,-0.61,0").stdout.matches("caution").count(), 0);
    std::fs::write(folder.path().join("two.csv"), "x_m,z_m,angle_rad\n0.3,-0.5,0\n0.65,-0.61,0\n").unwrap();
    let table = cdpr_in(folder.path(), "export lengths robot.toml --poses two.csv");
    assert!(
        table.stderr.contains("1 of 2 poses") || table.stdout.contains("1 of 2 poses"),
        "{}{}",
        table.stdout,
        table.stderr
    );
    let none = cdpr_in(folder.path(), "ik robot.toml --position 0.5,1");
    assert!(none.exit_code == 1 && none.stdout.contains("no-equilibrium"), "{}", none.stdout);
    let fixed = cdpr_in(folder.path(), "ik cogiro --position 0,0,1");
    assert!(fixed.exit_code == 2 && fixed.stderr.contains("equilibrium::position"), "{}", fixed.stderr);
}

/// Start lengths and swivel zeros of a homing run without load cells, to a tenth of their deviation beside SciPy's (case `three-cable-homing`), which
/// weighs equilibrium by 1 N and 1 N·m and has swivel zeros of its own convention.
#[test]
fn a_homing_run_of_three_cables_needs_no_load_cells() {
    let Some(folder) = super::mistaken_inputs::case("three-cable-homing") else { return };
    let sigma = "--sigma length_m=0.001,swivel_rad=0.002";
    for (data, free, wanted) in [
        ("data.csv", "length-offset,swivel-offset", [1.7227, 1.6227, 1.4108]),
        ("data-swivel-absolute.csv", "length-offset", [1.713, 1.627, 1.415]),
    ] {
        let balance = if data == "data.csv" { ",balance_N=1,balance_Nm=1" } else { "" };
        let command = format!("identify robot.toml {data} --model pulley --free {free} {sigma}{balance} --format json");
        let run = cdpr_in(folder.path(), &command);
        let answer = run.json();
        // a band of 58 mm of the predicted poses is not to be trusted, and is told
        assert_eq!((run.exit_code, &answer["status"]), (1, &"not-trusted".into()), "{}", run.stderr);
        let parameters = answer["parameters"].as_array().unwrap();
        for (cable, wanted) in wanted.into_iter().enumerate() {
            let name = format!("length-offset[{}]", cable + 1);
            let own = parameters.iter().find(|one| one["name"] == name.as_str()).unwrap();
            let (length, sigma) = (-own["value"].as_f64().unwrap(), own["sigma"].as_f64().unwrap());
            assert!(
                (length - wanted).abs() < f64::max(0.2 * sigma, 5e-3) && sigma < 0.03,
                "{data} {name}: {length} {sigma}"
            );
        }
        assert!(parameters.iter().all(|one| one["sigma"].is_number()));
    }
    let poses = cdpr_in(folder.path(), "identify robot.toml data.csv --model pulley --free length-offset");
    assert!(!poses.stderr.contains("data::no-equations"), "{}", poses.stderr);
}
