//! `cdpr capability`: what a robot can do in a box.

use super::{cdpr, cdpr_in};

const CAMERA: &str = "\
layout_version = 1
name = \"camera\"
motion_pattern = \"3T\"
gravity_m_s2 = [0.0, 0.0, -10.0]
[platform]
mass_kg = 5.0
[cable_defaults]
tension_min_N = 0.0
tension_max_N = 500.0
speed_max_m_s = 4.0
[[cable]]
name = \"1\"
frame_anchor_m = [-3.0, -4.0, 5.0]
[[cable]]
name = \"2\"
frame_anchor_m = [3.0, -4.0, 5.0]
[[cable]]
name = \"3\"
frame_anchor_m = [3.0, 4.0, 5.0]
motor_speed_max_rad_per_s = 250.0
gear_ratio = 10.0
drum_radius_m = 0.1
[[cable]]
name = \"4\"
frame_anchor_m = [-3.0, 4.0, 5.0]
";

/// A small box about the middle: 4 · 500 N/√2 over g less 5 kg, and 2.5 m/s of the drive of cable 3.
#[test]
fn payload_acceleration_and_speed_of_a_camera_are_those_of_closed_forms() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::write(folder.join("camera.toml"), CAMERA).unwrap();
    let asked = "capability camera.toml --box=-0.001,0.001,-0.001,0.001,-0.001,0.001 --report page.html";
    let run = cdpr_in(folder, &format!("{asked} --format json"));
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    let answer = run.json_with(&["payload_kg", "acceleration_m_s2", "speed_m_s", "payload", "acceleration", "speed"]);
    assert_eq!(answer["status"], "found");
    let payload = answer["payload_kg"].as_f64().unwrap();
    assert!((payload - (200.0 / 2.0_f64.sqrt() - 5.0)).abs() < 0.1, "{answer}");
    assert_eq!(answer["payload"]["limited_by"]["limit"], "tension-max");
    assert!(answer["payload"]["at_least_kg"].as_f64().unwrap() >= 0.99 * payload);
    let axes = answer["acceleration_m_s2"]["per_axis"].as_array().unwrap();
    assert!((axes[2].as_f64().unwrap() - 10.0).abs() < 1e-6, "down no faster than gravity: {answer}");
    assert!((answer["speed_m_s"].as_f64().unwrap() - 2.5).abs() < 1e-12, "{answer}");
    let limit = &answer["speed"]["limited_by"];
    assert!(limit["limit"] == "drive-speed" && limit["cable"] == 3, "{answer}");
    assert_eq!(answer["speed"]["at_pose"]["position_m"].as_array().unwrap().len(), 3);
    let page = std::fs::read_to_string(folder.join("page.html")).unwrap();
    assert!(page.contains("Payload at z = ") && page.contains("least value"), "maps");
    // the words say the same
    let words = cdpr_in(folder, asked).prose();
    assert!(words.contains("speed of the drive") && words.contains("gap"), "{words}");
}

/// Beyond its anchors the camera does not hang: exit code 1, with the pose and the limit.
#[test]
fn a_box_in_which_the_load_is_not_held_is_infeasible() {
    let folder = tempfile::tempdir().unwrap();
    let folder = folder.path();
    std::fs::write(folder.join("camera.toml"), CAMERA).unwrap();
    let run = cdpr_in(folder, "capability camera.toml --box=-4,1,-1,1,0,2 --format json --report page.html");
    assert_eq!(run.exit_code, 1, "{}", run.stderr);
    let answer = run.json_with(&["payload_kg", "not_held", "reason"]);
    assert!(answer["status"] == "not-held" && answer["payload_kg"].is_null(), "{answer}");
    assert_eq!(answer["not_held"]["at_pose"]["position_m"][0], -4.0);
    assert_eq!(answer["not_held"]["limited_by"]["limit"], "no-wrench-closure");
    assert!(std::fs::read_to_string(folder.join("page.html")).unwrap().contains("the own load is not held here"));
}

/// Null with a reason for what a file does not state, a warning with the gap for too few poses, and errors with the option's name.
#[test]
fn what_is_unknown_is_told() {
    let run = cdpr("capability planar-example --box=-1,1,3,5 --format json");
    let answer = run.json_with(&["speed_m_s", "acceleration_m_s2"]);
    assert!(run.exit_code == 0 && answer["speed_m_s"].is_null() && answer["acceleration_m_s2"]["ball"].is_null());
    assert!(answer["speed"]["reason"].as_str().unwrap().contains("speed_max_m_s"), "{answer}");
    assert!(answer["acceleration"]["ball"]["reason"].as_str().unwrap().contains("mass_kg"), "{answer}");
    let few = cdpr("capability cogiro --box=-3,3,-2,2,1,3 --poses 500 --format json");
    let answer = few.json_with(&["status", "warnings"]);
    assert!(few.exit_code == 0 && answer["status"] == "poses-used-up", "{answer}");
    assert!(answer["warnings"][0].as_str().unwrap().contains("--poses"), "{answer}");
    for (words, told) in [
        ("--box=-1,1,5,3", "--box"),
        ("--box=-1,1,3,5 --gap 0", "--gap"),
        ("--box=-1,1,3,5 --payload-place=-1", "--payload-place"),
        ("--box=-1,1,3,5 --rotation 0.1", "--rotation"),
    ] {
        let run = cdpr(&format!("capability planar-example {words}"));
        assert!(run.exit_code == 2 && run.stderr.contains(told), "{words}: {}", run.stderr);
    }
}
