//! `robots`, `check`, `ik`, `fk`, `place-pulleys`.

use serde_json::json;

use super::{SQUARE, cdpr, cdpr_in, file_with, listed, numbers};

/// The upper cables of the planar example come up their posts, the lower ones along the ground: each has an axis of its own, and the
/// lengths at the pose differ from those of the point model by the wrapped arcs alone.
#[test]
fn every_cable_may_have_its_own_swivel_axis() {
    let folder = tempfile::tempdir().unwrap();
    let axes = "--axis 0,1 --axis 0,1 --axis=-1,0 --axis 1,0";
    let place = |more: &str| {
        cdpr_in(folder.path(), &format!("place-pulleys planar-example --radius 0.15 --out placed.toml {more}"))
    };
    let run = place(axes);
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let placed =
        cdpr_model::robot::Robot::from_toml(&std::fs::read_to_string(folder.path().join("placed.toml")).unwrap(), "p")
            .unwrap();
    let found: Vec<[f64; 2]> =
        placed.cables.iter().map(|cable| cable.pulley_swivel_axis().unwrap()).map(|axis| [axis.x, axis.y]).collect();
    assert_eq!(found, [[0.0, 1.0], [0.0, 1.0], [-1.0, 0.0], [1.0, 0.0]]);
    let angle = |cable: usize| -> f64 {
        let run = cdpr_in(folder.path(), "ik placed.toml --model pulley --pose 0,5.2 --format json");
        let (with, without) = (run.json(), cdpr("ik planar-example --pose 0,5.2 --format json").json());
        let length = |answer: &serde_json::Value| super::numbers(&answer["cable_lengths_m"])[cable];
        (length(&with) - length(&without)) / 0.15
    };
    // an arc of at most half a turn around each pulley
    assert!((0..4).map(angle).all(|angle| (0.0..std::f64::consts::PI).contains(&angle)));
    // once written, the file's own axes serve
    assert_eq!(cdpr_in(folder.path(), "place-pulleys placed.toml --out again.toml").exit_code, 0);
    for (more, words) in
        [("", "no pulley_swivel_axis"), ("--axis 0,1 --axis 0,1", "given 2 times; the robot has 4 cables")]
    {
        let run = place(more);
        assert!(run.exit_code == 2 && run.stderr.contains(words), "{more}: {}", run.stderr);
    }
}

#[test]
fn every_built_in_robot_passes_its_check() {
    let robots = cdpr("robots --format json").json()["robots"].as_array().unwrap().clone();
    assert!(robots.len() >= 23);
    for robot in robots {
        let name = robot["name"].as_str().unwrap();
        let check = cdpr(&format!("check {name} --format json"));
        assert_eq!(check.exit_code, 0, "{name}");
        let check = check.json_with(&["name", "motion_pattern", "cable_count", "home", "warnings"]);
        assert_eq!((&check["name"], &check["cable_count"]), (&robot["name"], &robot["cable_count"]));
        let home = &check["home"];
        assert!(home["rank"].is_u64() && home.get("condition").is_some() && home.get("feasible").is_some(), "{check}");
    }
}

/// From the middle of the 10 m × 8 m square all cables are √41 m long.
#[test]
fn lengths_and_directions_of_the_square_are_those_of_pythagoras() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    let ik = cdpr_in(folder.path(), "ik square.toml --pose 5,4 --format json");
    let answer = ik.json_with(&["cable_lengths_m", "controlled_lengths_m", "directions", "pose", "status"]);
    let length = 41.0_f64.sqrt();
    assert_eq!(numbers(&answer["cable_lengths_m"]), [length; 4]);
    assert_eq!(answer["controlled_lengths_m"], answer["cable_lengths_m"]);
    // towards the outlet, in the file's components
    assert_eq!(numbers(&answer["directions"][0]), [-5.0 / length, -4.0 / length]);
    assert_eq!(answer["pose"], json!({"position_m": [5.0, 4.0]}));
    assert!(answer.get("recorded_lengths_m").is_none() && answer.get("wrap_angles_rad").is_none());
}

#[test]
fn leading_minus_signs_are_accepted_with_and_without_equals_sign() {
    let spaced = cdpr("ik planar-example --pose -1,2 --format json");
    assert_eq!(spaced.exit_code, 0, "{}", spaced.stderr);
    assert_eq!(spaced.stdout, cdpr("ik planar-example --pose=-1,2 --format json").stdout);
}

#[test]
fn poses_are_answered_in_the_components_of_the_pattern() {
    let spatial = cdpr("ik cogiro --pose 0,0,2,0.1,0.2,0.3 --format json").json();
    let rotation = numbers(&spatial["pose"]["rotation_rad"]);
    assert!(rotation.iter().zip([0.1, 0.2, 0.3]).all(|(found, expected)| (found - expected).abs() < 1e-12));
    assert_eq!(spatial["pose"]["quaternion_xyzw"].as_array().unwrap().len(), 4);
    let planar = cdpr("ik kntu-planar --pose 0.1,0.2,-0.3 --format json").json();
    assert_eq!(planar["pose"]["position_m"].as_array().unwrap().len(), 2);
    assert!((planar["pose"]["angle_rad"].as_f64().unwrap() + 0.3).abs() < 1e-12);
}

/// Forward undoes inverse, to the tolerance of the search.
#[test]
fn fk_finds_the_pose_that_ik_came_from() {
    for (robot, pose) in [
        ("planar-example", vec![1.0, 3.0]),
        ("kntu-planar", vec![0.1, -0.2, 0.1]),
        ("cogiro", vec![0.5, -0.5, 2.5, 0.05, -0.05, 0.1]),
    ] {
        let ik = cdpr(&format!("ik {robot} --pose {} --format json", listed(&pose))).json();
        let lengths = listed(&numbers(&ik["controlled_lengths_m"]));
        let fk = cdpr(&format!("fk {robot} --lengths {lengths} --format json"));
        assert_eq!(fk.exit_code, 0, "{robot}: {}", fk.stdout);
        let fk = fk.json_with(&["status", "pose", "residuals_m", "iterations", "restarts", "reason"]);
        assert_eq!(fk["status"], "converged");
        let mut found = numbers(&fk["pose"]["position_m"]);
        found.extend(fk["pose"].get("rotation_rad").map(numbers).unwrap_or_default());
        found.extend(fk["pose"]["angle_rad"].as_f64());
        assert!(found.iter().zip(&pose).all(|(found, asked)| (found - asked).abs() < 1e-7), "{robot}: {found:?}");
    }
}

/// From guesses turned upside down some searches end where lengths fit badly: the answer stays there, and the pose that the lengths
/// were made of is the alternative, in JSON and in words.
#[test]
fn a_better_fit_elsewhere_is_told_beside_the_pose_that_belongs_to_the_guess() {
    let robot = "cablerobot-simulator-helicopter";
    let ik = cdpr(&format!("ik {robot} --pose 0.2,-0.1,0.3,0,0,0 --format json")).json();
    let lengths = listed(&numbers(&ik["controlled_lengths_m"]));
    let mut told = 0;
    for turn in ["2.8,0,0", "0,2.8,0", "0,0,2.8", "2,2,0", "0,2,2", "2,0,2"] {
        let command = format!("fk {robot} --lengths {lengths} --guess 1,1,1,{turn}");
        let fk = cdpr(&format!("{command} --format json")).json();
        assert_eq!(fk["sought_from"], "guess");
        let Some(alternative) = fk.get("alternative") else { continue };
        told += 1;
        assert!(alternative["residual_rms_m"].as_f64().unwrap() < fk["residual_rms_m"].as_f64().unwrap(), "{fk}");
        let words = cdpr(&command).stdout;
        assert!(words.contains("fit better elsewhere") && words.contains("belongs to --guess"), "{words}");
    }
    assert!(told > 0, "no guess of these leads elsewhere");
    let home = cdpr(&format!("fk {robot} --lengths {lengths}")).stdout;
    assert!(home.contains("sought from the home pose") && !home.contains("elsewhere"), "{home}");
}

/// Scale 2 and offset 0.5 m of cable a: the record says 2 q + 0.5.
#[test]
fn recorded_lengths_carry_the_scale_and_offset_of_the_file() {
    let text = SQUARE.replacen("tension_min_N = 10.0", "length_scale = 2.0\nlength_offset_m = 0.5", 1);
    let (folder, _) = file_with("square.toml", text.as_bytes());
    let ik = cdpr_in(folder.path(), "ik square.toml --pose 3,4 --format json").json();
    let recorded = numbers(&ik["recorded_lengths_m"]);
    assert_eq!(recorded[0], 2.0 * 5.0 + 0.5);
    assert_eq!(recorded[1..], numbers(&ik["cable_lengths_m"])[1..]);
    let fk =
        cdpr_in(folder.path(), &format!("fk square.toml --recorded --lengths {} --format json", listed(&recorded)));
    let position = numbers(&fk.json()["pose"]["position_m"]);
    assert!((position[0] - 3.0).abs() < 1e-8 && (position[1] - 4.0).abs() < 1e-8, "{position:?}");
}

#[test]
fn a_pose_without_course_is_a_negative_answer_with_its_reason() {
    let run = cdpr("ik planar-example --pose -6,8 --format json");
    assert_eq!(run.exit_code, 1);
    let answer = run.json();
    assert_eq!(answer["status"], "singular");
    assert!(answer["reason"].as_str().unwrap().contains("cable 1"), "{answer}");
    assert!(answer["cable_lengths_m"][0].is_null() && answer["cable_lengths_m"][1].is_number());
    assert_eq!(cdpr("ik planar-example --pose -6,8").exit_code, 1);
}

#[test]
fn lengths_that_overflow_are_a_numerical_failure() {
    let run = cdpr("ik planar-example --pose 1e300,0 --format json");
    assert_eq!((run.exit_code, run.json()["status"].as_str()), (3, Some("error")));
}

#[test]
fn too_few_cables_are_called_singular_not_converged() {
    let (kept, _) = SQUARE.split_once("[[cable]]\nname = \"b\"").unwrap();
    let (folder, _) = file_with("one.toml", kept.as_bytes());
    let run = cdpr_in(folder.path(), "fk one.toml --lengths 2 --format json");
    assert_eq!((run.exit_code, run.json()["status"].as_str()), (1, Some("singular")));
    let check = cdpr_in(folder.path(), "check one.toml --format json").json();
    assert_eq!(check["home"]["rank"], 1);
    assert!(check["home"]["condition"].is_null(), "infinite is null: {check}");
}

/// The pulleys are placed to leave directions at the pose as they were.
#[test]
fn placed_pulleys_pull_in_the_same_direction_at_their_pose() {
    let folder = tempfile::tempdir().unwrap();
    let run =
        cdpr_in(folder.path(), "place-pulleys planar-example --axis 0,1 --pose 1,4 --out placed.toml --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let before = cdpr("ik planar-example --pose 1,4 --format json").json();
    let after = cdpr_in(folder.path(), "ik placed.toml --model pulley --pose 1,4 --format json");
    let after = after.json_with(&["wrap_angles_rad"]);
    for cable in 0..4 {
        let (old, new) = (numbers(&before["directions"][cable]), numbers(&after["directions"][cable]));
        assert!(old.iter().zip(&new).all(|(old, new)| (old - new).abs() < 1e-9), "{old:?} {new:?}");
    }
    assert!(numbers(&after["wrap_angles_rad"]).iter().all(|&angle| angle > 0.0));
}

#[test]
fn an_effect_whose_keys_are_missing_names_the_key() {
    let run = cdpr("ik cogiro --model pulley --pose 0,0,2,0,0,0");
    assert_eq!(run.exit_code, 2);
    assert!(run.stderr.contains("pulley_swivel_axis") && run.stderr.contains("place-pulleys"), "{}", run.stderr);
    let radius = cdpr("place-pulleys cogiro --axis 0,0,1 --out /dev/null");
    assert_eq!(radius.exit_code, 2);
    assert!(radius.stderr.contains("pulley_radius_m") && radius.stderr.contains("--radius"), "{}", radius.stderr);
}

/// Free part and arc change by what the length does; rigid differences of `ik` itself are the judge, good to 1e-6 at a step of 1e-4 m.
#[test]
fn jacobians_of_contact_points_are_those_of_neighbouring_answers() {
    let at = |x: f64| {
        cdpr(&format!("ik caroca-pulleys --model pulley --pose {x},0.3,1.2,0.1,-0.2,0.3 --format json")).json()
    };
    let (middle, before, after) = (at(0.2), at(0.2 - 1e-4), at(0.2 + 1e-4));
    for cable in 0..8 {
        let of = |answer: &serde_json::Value| answer["jacobians"]["cables"][cable].clone();
        let [middle, before, after] = [&middle, &before, &after].map(of);
        for (value, row) in [("free_length_m", "free_length"), ("arc_length_m", "arc_length")] {
            let slope = (after[value].as_f64().unwrap() - before[value].as_f64().unwrap()) / 2e-4;
            assert!((slope - numbers(&middle[row])[0]).abs() < 1e-6, "cable {cable}, {row}: {slope} {middle}");
        }
        for axis in 0..3 {
            let place = |answer: &serde_json::Value| numbers(&answer["contact_point_m"])[axis];
            let slope = (place(&after) - place(&before)) / 2e-4;
            assert!((slope - numbers(&middle["contact_point"][axis])[0]).abs() < 1e-6, "cable {cable}, axis {axis}");
        }
    }
}

#[test]
fn the_map_of_angle_rates_has_no_inverse_at_gimbal_lock() {
    let angles = |ry: &str| {
        cdpr(&format!("ik cogiro --pose 0,0,2,0.1,{ry},0 --format json")).json()["jacobians"]["angles"].clone()
    };
    let locked = angles("1.5707963267948966");
    assert!(locked["inverse"].is_null() && locked["reason"].as_str().unwrap().contains("±90°"), "{locked}");
    let free = angles("0.2");
    assert!((free["matrix"][0][2].as_f64().unwrap() - 0.2_f64.sin()).abs() < 1e-12, "{free}");
    assert!(free["inverse"].is_array() && free["reason"].is_null(), "{free}");
    assert!(cdpr("ik kntu-planar --pose 0.1,0.2,-0.3 --format json").json()["jacobians"]["angles"].is_null());
    let text = cdpr("ik cogiro --pose 0,0,2,0.1,0.2,0 --jacobians").stdout;
    assert!(text.contains("J_P") && text.contains("free length"), "{text}");
}
