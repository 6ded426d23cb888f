//! `model`: what each effect changes at a pose.

use serde_json::Value;

use super::{SQUARE, cdpr, cdpr_in, file_with, listed, numbers};

/// The square with elastic cables that weigh 0.1 kg/m, under 10 kg in an upright plane.
fn heavy_square() -> String {
    let plain = SQUARE.replace("tension_min_N = 10.0\ntension_max_N = 100.0\n", "");
    let cable =
        "tension_min_N = 100.0\ntension_max_N = 2000.0\naxial_stiffness_EA_N = 1e5\nlinear_density_kg_per_m = 0.1\n";
    plain
        .replace("platform_anchor_m", &format!("{cable}platform_anchor_m"))
        .replace("[home_pose]", "gravity_m_s2 = [0.0, -9.81]\n\n[platform]\nmass_kg = 10.0\n\n[home_pose]")
}

fn effect<'a>(answer: &'a Value, name: &str) -> &'a Value {
    let is_it = |effect: &&Value| effect["effect"] == name && effect["replaced_by"].is_null();
    answer["effects"].as_array().unwrap().iter().find(is_it).unwrap_or_else(|| panic!("{name}: {answer}"))
}

#[test]
fn every_effect_is_either_compared_or_missing_with_its_key() {
    let (folder, _) = file_with("heavy.toml", heavy_square().as_bytes());
    let run = cdpr_in(folder.path(), "model heavy.toml --pose 6,3 --format json");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["robot", "model", "status", "reason", "pose", "tensions_N", "effects", "missing"]);
    assert_eq!(answer["model"], "elastic+catenary");
    let of = |list: &str| -> Vec<String> {
        answer[list].as_array().unwrap().iter().map(|entry| entry["effect"].as_str().unwrap().to_owned()).collect()
    };
    let laws = cdpr_model::robot::LAWS.iter().map(|law| law.word);
    for name in laws.chain(["pulley", "drum", "catenary"]) {
        let places = [of("effects").contains(&name.to_owned()), of("missing").contains(&name.to_owned())];
        assert!(places[0] != places[1], "{name}: {answer}");
    }
    // exact and discrete sag exclude each other, so one is compared in the other's place
    let replaced = answer["effects"].as_array().unwrap().iter().find(|effect| !effect["replaced_by"].is_null());
    assert_eq!(replaced.unwrap()["control_model"], "elastic+finite-element");
    for entry in answer["effects"].as_array().unwrap() {
        assert!(entry["length_change_m"]["max"].as_f64().unwrap() > 0.0, "{entry}");
        assert!(entry["platform"]["translation_m"].as_f64().unwrap() > 0.0, "{entry}");
        assert!(entry["tension_change_N"].is_number() && !entry["cost"].as_str().unwrap().is_empty(), "{entry}");
    }
    let words = cdpr_in(folder.path(), "model heavy.toml --pose 6,3").stdout;
    for text in ["elastic+catenary", "beyond home", "what an effect costs", "tension_of_strain_N"] {
        assert!(words.contains(text), "{text}: {words}");
    }
}

/// Stretch is the difference that `ik` tells between geometric and controlled lengths, and `fk` finds where it leads.
#[test]
fn the_answer_agrees_with_ik_and_fk() {
    let (robot, pose) = ("planar-example", [0.5, 4.0]);
    let point = listed(&pose);
    let answer = cdpr(&format!("model {robot} --pose {point} --format json")).json();
    let elastic = effect(&answer, "elastic");
    let lengths = cdpr(&format!("ik {robot} --pose {point} --model elastic --format json")).json();
    let [geometric, controlled] = ["cable_lengths_m", "controlled_lengths_m"].map(|key| numbers(&lengths[key]));
    let stretch = numbers(&elastic["length_change_m"]["cables"]);
    for cable in 0..4 {
        assert!((geometric[cable] - controlled[cable] - stretch[cable]).abs() < 1e-12, "{elastic}");
    }
    let given = listed(&geometric);
    let there = cdpr(&format!("fk {robot} --lengths {given} --model elastic --guess {point} --format json")).json();
    let found = numbers(&there["pose"]["position_m"]);
    let distance = f64::hypot(found[0] - pose[0], found[1] - pose[1]);
    assert_eq!(elastic["platform"]["method"], "exact");
    // two searches that each end within 1e-11 m
    assert!((elastic["platform"]["translation_m"].as_f64().unwrap() - distance).abs() < 1e-9, "{elastic} {distance}");
}

/// Offsets set at the home pose take up everything there.
#[test]
fn at_the_home_pose_nothing_is_left_beyond_it() {
    let answer = cdpr("model planar-example --pose 0,5.2 --format json").json();
    let elastic = effect(&answer, "elastic");
    assert!(elastic["length_change_m"]["max"].as_f64().unwrap() > 1e-3, "{elastic}");
    assert_eq!(elastic["length_change_beyond_home_m"]["max"], 0.0);
    assert!(elastic["platform_beyond_home"]["translation_m"].as_f64().unwrap() < 1e-9, "{elastic}");
}

#[test]
fn a_load_that_no_tensions_balance_is_a_negative_answer() {
    let run = cdpr("model planar-example --pose 0,5.2 --wrench 0,-1e9 --format json");
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    let answer = run.json();
    assert_eq!(answer["status"], "infeasible");
    assert!(answer["reason"].as_str().unwrap().contains("--tensions"), "{answer}");
    let both = cdpr("model planar-example --pose 0,5.2 --wrench 0,-1 --tensions 1,2,3,4");
    assert_eq!(both.exit_code, 2, "tensions tell the load: {}", both.stdout);
}

/// A file that says nothing of its cables supports the standard model alone.
#[test]
fn without_any_effect_the_missing_keys_are_the_answer() {
    let run = cdpr("model cogiro --pose 0,0,1.5,0,0,0.1");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    for key in ["pulley_swivel_axis", "axial_stiffness_EA_N", "linear_density_kg_per_m"] {
        assert!(run.stdout.contains(key), "{key}: {}", run.stdout);
    }
}

/// A guided drum pays out along its helix: by √(r² + (pitch/2π)²)/r more than an ideal winch of its radius.
#[test]
fn a_drum_left_out_is_an_ideal_winch() {
    let drum = "drum_radius_m = 0.1\ndrum_pitch_m = 0.008\ndrum_guided = true\n";
    let text = SQUARE.replace("platform_anchor_m", &format!("{drum}platform_anchor_m"));
    let (folder, _) = file_with("drums.toml", text.as_bytes());
    let run = cdpr_in(folder.path(), "model drums.toml --pose 4,3 --format json");
    assert_eq!(run.exit_code, 0, "{}{}", run.stdout, run.stderr);
    let answer = run.json();
    let changes = numbers(&effect(&answer, "drum")["length_change_m"]["cables"]);
    let lengths = numbers(&cdpr_in(folder.path(), "ik drums.toml --pose 4,3 --format json").json()["cable_lengths_m"]);
    let surplus = f64::hypot(0.1, 0.008 / std::f64::consts::TAU) / 0.1 - 1.0;
    for (change, length) in changes.iter().zip(&lengths) {
        assert!((change - length * surplus).abs() < 1e-12, "{change} {length}");
    }
    // rigid cables: no tension belongs to a length, and without limits there is no distribution
    assert!(effect(&answer, "drum")["platform"]["tension_change_N"].is_null());
    assert!(effect(&answer, "drum")["tension_change_N"].is_null());
}
