//! Robot files: all of the shared collection load and come back, and every mistake is told with its place.

mod mistakes;

use std::path::{Path, PathBuf};

use cdpr_model::geometry::MotionPattern;
use cdpr_model::reading::{FileError, ReadError};
use cdpr_model::robot::{DrumSide, Robot, StiffnessBasis, WrapSide, builtin};

/// The collection beside the project; `None`, said aloud, when it is absent outside CI.
fn shared_robots() -> Option<Vec<PathBuf>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/data/robots");
    let Ok(entries) = std::fs::read_dir(&folder) else {
        assert!(std::env::var_os("CI").is_none_or(|ci| ci != "true"), "{} is absent", folder.display());
        eprintln_skip(&folder);
        return None;
    };
    let files = entries.map(|entry| entry.expect("the folder is readable").path());
    Some(files.filter(|path| path.extension().is_some_and(|extension| extension == "toml")).collect())
}

#[expect(clippy::print_stderr, reason = "a skipped test says so")]
fn eprintln_skip(folder: &Path) {
    eprintln!("skipped: {} is absent", folder.display());
}

#[test]
fn every_file_of_the_collection_loads_and_comes_back_unchanged() {
    let Some(files) = shared_robots() else { return };
    assert_eq!(files.len(), 36);
    for path in files {
        let (text, name) = (std::fs::read_to_string(&path).unwrap(), path.display().to_string());
        let robot = Robot::from_toml(&text, &name).unwrap_or_else(|error| panic!("{error}"));
        let written = robot.to_toml();
        let again = Robot::from_toml(&written, &name).unwrap_or_else(|error| panic!("{error}\n{written}"));
        assert_eq!(robot, again, "{name}");
        assert_eq!(written, again.to_toml(), "{name}");
    }
}

/// The original differs from what is written by comments and by the width of notes only.
#[test]
fn a_written_file_has_the_lines_of_the_original() {
    for name in builtin::names() {
        let original = builtin::find(name).unwrap();
        let without_comment = |line: &str| line.split("   #").next().unwrap_or_default().to_owned();
        let is_data = |line: &&str| !line.starts_with('#') && !line.starts_with("  ") && !line.starts_with("title");
        let lines = |text: &str| text.lines().filter(is_data).map(without_comment).collect::<Vec<_>>();
        assert_eq!(lines(&Robot::builtin(name).unwrap().to_toml()), lines(original), "{name}");
    }
}

const PLANAR: &str = r#"layout_version = 1
name = "frame"
motion_pattern = "1R2T"
cable_count = 2
axes = "xz"
gravity_m_s2 = [0.0, -9.81]

[platform]
mass_kg = 1.0
inertia_about_center_of_mass_kg_m2 = 0.1

[home_pose]
position_m = [1.0, 1.0]
angle_rad = 0.3

[external_wrench]
force_N = [1.0, 2.0]
moment_Nm = 3.0

[workspace]
position_min_m = [0.0, 0.0]
position_max_m = [2.0, 2.0]

[[cable]]
name = "left"
frame_anchor_m = [0.0, 2.0]
platform_anchor_m = [-0.1, 0.0]
pulley_radius_m = 0.05
pulley_swivel_axis = [0.0, 1.0]
pulley_wrap_side = "right"
tension_min_N = 1.0
tension_max_N = 10.0

[[cable]]
name = "right"
frame_anchor_m = [2.0, 2.0]
platform_anchor_m = [0.1, 0.0]
axial_compliance_per_N = 0.0
hidden_length_m = 1.5
series_compliance_m_per_N = 1e-7
stiffness_by = "unstrained"
length_scale = 1.001
length_offset_m = -0.02
tension_scale = 0.98
tension_offset_N = 3.0
tension_of_strain_N = [1e5, 2e6]

[cable.hysteresis]
strain = [0.0, 0.01, 0.02]
loading_N = [0.0, 1100.0, 5000.0]
unloading_N = [0.0, 900.0, 4500.0]
transition_strain = [0.001, 0.003]
transition_share = [0.75, 0.25]
"#;

/// Keys of machines in time that stand in `[platform]`.
#[test]
fn damping_of_the_platform_is_read_and_written() {
    let more = "mass_kg = 1.0\ndamping_N_s_per_m = 12.0\nrotational_damping_Nm_s_per_rad = 3.0";
    let text = PLANAR.replace("mass_kg = 1.0", more);
    let robot = Robot::from_toml(&text, "frame.toml").unwrap();
    assert_eq!((robot.platform.damping, robot.platform.rotational_damping), (Some(12.0), Some(3.0)));
    assert_eq!(Robot::from_toml(&robot.to_toml(), "frame.toml").unwrap(), robot);
    let error = Robot::from_toml(&text.replace("= 12.0", "= -12.0"), "frame.toml").unwrap_err();
    assert!(error.code == "robot::negative" && error.to_string().contains("damping_N_s_per_m"), "{error}");
}

const SPATIAL: &str = r#"layout_version = 1
name = "box"
motion_pattern = "3R3T"
[platform]
inertia_about_center_of_mass_kg_m2 = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
[home_pose]
position_m = [0.0, 0.0, 1.0]
rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
[external_wrench]
force_N = [0.0, 0.0, -10.0]
moment_Nm = [0.0, 0.0, 0.0]
[[cable]]
name = "1"
frame_anchor_m = [0.0, 2.0, 3.0]
platform_anchor_m = [-0.1, 0.0, 0.0]
pulley_swivel_axis = [0.0, 0.0, 1.0]
"#;

#[test]
fn every_calibrated_key_is_read_and_written() {
    let robot = Robot::from_toml(PLANAR, "frame.toml").unwrap();
    let cable = &robot.cables[1];
    assert_eq!(robot.motion_pattern, MotionPattern::Planar);
    assert_eq!((cable.axial_compliance(), cable.hidden_length), (Some(0.0), Some(1.5)));
    assert_eq!((cable.series_compliance, cable.stiffness_by), (Some(1e-7), Some(StiffnessBasis::Unstrained)));
    assert_eq!((cable.length_scale, cable.length_offset), (Some(1.001), Some(-0.02)));
    assert_eq!((cable.tension_scale, cable.tension_offset), (Some(0.98), Some(3.0)));
    assert_eq!(robot.cables[0].pulley_wrap_side, Some(WrapSide::Right));
    // in the xz plane a cable that comes up turns right towards +x
    assert_eq!(robot.pulley_side(&robot.cables[0]), Some(nalgebra::Vector3::x()));
    assert_eq!(cable.tension_of_strain, Some(vec![1e5, 2e6]));
    assert_eq!(cable.hysteresis.as_ref().unwrap().unloading_N, [0.0, 900.0, 4500.0]);
    // in the xz plane the moment is about −y
    assert_eq!(robot.external_wrench.as_ref().unwrap().wrench.as_slice(), [1.0, 0.0, 2.0, 0.0, -3.0, 0.0]);
    assert_eq!(Robot::from_toml(&robot.to_toml(), "frame.toml").unwrap(), robot);
    assert!(Robot::from_toml(SPATIAL, "box.toml").is_ok());
}

const SURROUNDED: &str = r#"diameter_m = 0.006
length_min_m = 0.5
length_max_m = 12.0
pulley_wrap_min_rad = 0.1
pulley_wrap_max_rad = 3.0
[[obstacle]]
name = "crate"
position_min_m = [1.0, 1.0, 0.0]
position_max_m = [2.0, 2.0, 1.5]
[[obstacle]]
name = "beam"
from_m = [-4.0, 5.0, 6.0]
to_m = [4.0, 5.0, 6.0]
radius_m = 0.1
"#;

/// The spatial robot with a body and everything that its cables may touch.
fn surrounded() -> String {
    let hull = "[platform]\nhull_m = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\n";
    SPATIAL.replace("[platform]\n", hull) + SURROUNDED
}

#[test]
fn bodies_obstacles_and_limits_of_cables_are_read_and_written() {
    let robot = Robot::from_toml(&surrounded(), "box.toml").unwrap();
    let cable = &robot.cables[0];
    assert_eq!((cable.diameter, cable.length_min, cable.length_max), (Some(0.006), Some(0.5), Some(12.0)));
    assert_eq!((cable.pulley_wrap_min, cable.pulley_wrap_max), (Some(0.1), Some(3.0)));
    assert_eq!(robot.platform.hull.as_ref().map(Vec::len), Some(4));
    assert_eq!((robot.obstacles[0].name.as_str(), robot.obstacles.len()), ("crate", 2));
    assert!(matches!(robot.obstacles[1].shape, cdpr_model::robot::ObstacleShape::Strut { radius: 0.1, .. }));
    assert_eq!(Robot::from_toml(&robot.to_toml(), "box.toml").unwrap(), robot);
}

const ASSUMED: &str = r#"
[[assumption]]
key = "platform.mass_kg"
reason = "weighed by eye"
[[assumption]]
key = "cable[1].tension_min_N"
reason = "a guess"
[[assumption]]
key = "cable.hysteresis"
reason = "of another rope"
[[assumption]]
key = "gravity_m_s2"
reason = "of the equator"
"#;

/// Assumed numbers are kept by whatever is done to the robot and written again; what the file does not state cannot be assumed.
#[test]
fn assumed_numbers_are_read_and_written() {
    let robot = Robot::from_toml(&(PLANAR.to_owned() + ASSUMED), "frame.toml").unwrap();
    let keys: Vec<&str> = robot.assumptions.iter().map(|assumption| assumption.key.as_str()).collect();
    assert_eq!(keys, ["platform.mass_kg", "cable[1].tension_min_N", "cable.hysteresis", "gravity_m_s2"]);
    assert_eq!(Robot::from_toml(&robot.to_toml(), "frame.toml").unwrap(), robot);
    let assumed = ["macarm", "nist-robocrane", "caroca", "cablerobot-simulator-icosahedron"];
    for name in builtin::names() {
        assert_eq!(!Robot::builtin(name).unwrap().assumptions.is_empty(), assumed.contains(&name), "{name}");
    }
}

/// A planar robot whose drums stand across its plane, with every winch key.
fn with_drum() -> String {
    PLANAR.replacen(
        "platform_anchor_m = ",
        "drum_radius_m = 0.1\ndrum_pitch_m = 0.008\ndrum_axis = [0.0, 1.0, 0.0]\ndrum_position_m = [-1.0, -0.5, 0.2]\n\
         drum_side = \"right\"\ndrum_guided = false\ndrum_pulley_m = [-1.0, 2.5]\ndrum_start_angle_rad = 0.3\n\
         drum_start_length_m = 1.5\ndrum_groove_length_m = 0.2\ndrum_layer_height_m = 0.007\ngear_ratio = -12.0\n\
         encoder_counts_per_turn = 4096.0\nspeed_max_m_s = 3.0\nmotor_speed_max_rad_per_s = 300.0\ndrum_inertia_kg_m2 = 0.6\ndrum_coulomb_friction_Nm = 10.0\n\
         drum_static_friction_Nm = 15.0\ndrum_stribeck_speed_rad_per_s = 0.25\npulley_friction = 0.03\n\
         pulley_inertia_kg_m2 = 0.02\nplatform_anchor_m = ",
        1,
    )
}

#[test]
fn every_winch_key_is_read_and_written() {
    let robot = Robot::from_toml(&with_drum(), "frame.toml").unwrap();
    let cable = &robot.cables[0];
    assert_eq!((cable.winch.static_friction, cable.winch.stribeck_speed), (Some(15.0), Some(0.25)));
    assert_eq!((cable.pulley_friction, cable.pulley_inertia), (Some(0.03), Some(0.02)));
    assert_eq!((cable.winch.radius, cable.winch.pitch(), cable.winch.guided), (Some(0.1), Some(0.008), Some(false)));
    assert_eq!(cable.winch.axis.unwrap().as_slice(), [0.0, 1.0, 0.0]);
    assert_eq!(cable.winch.position.unwrap().as_slice(), [-1.0, -0.5, 0.2]);
    assert_eq!(cable.winch.first_pulley.unwrap().as_slice(), [-1.0, 0.0, 2.5]);
    assert_eq!((cable.winch.side, cable.winch.gear_ratio), (Some(DrumSide::Right), Some(-12.0)));
    assert_eq!((cable.winch.start_angle, cable.winch.start_length), (Some(0.3), Some(1.5)));
    assert_eq!((cable.winch.groove_length(), cable.winch.layer_height()), (Some(0.2), Some(0.007)));
    assert_eq!(cable.winch.encoder_counts_per_turn, Some(4096.0));
    assert_eq!((cable.speed_max, cable.winch.motor_speed_max), (Some(3.0), Some(300.0)));
    assert_eq!(Robot::from_toml(&robot.to_toml(), "frame.toml").unwrap(), robot);
}

#[test]
fn the_schema_describes_every_key_of_the_files() {
    let schema = serde_json::to_value(cdpr_model::robot::schema()).unwrap();
    let described = |properties: &serde_json::Value, key: &str| {
        assert!(properties[key]["description"].is_string(), "{key} has no description: {}", properties[key]);
    };
    for key in ["layout_version", "motion_pattern", "axes", "gravity_m_s2", "home_pose", "cable", "reference_check"] {
        described(&schema["properties"], key);
    }
    let cable = &schema["$defs"]["CableSection"];
    for key in [
        "name",
        "frame_anchor_m",
        "pulley_swivel_axis",
        "axial_compliance_per_N",
        "tension_offset_N",
        "stiffness_by",
        "tension_of_strain_N",
        "hysteresis",
    ] {
        described(&cable["properties"], key);
    }
    assert_eq!(cable["additionalProperties"], false);
    let defaults = &schema["properties"]["cable_defaults"];
    assert_eq!(defaults["additionalProperties"], false);
    let keys = |section: &serde_json::Value| section["properties"].as_object().unwrap().len();
    assert_eq!(keys(defaults), keys(cable) - 3, "all but the cable's own: {defaults}");
}

const WITH_DEFAULTS: &str = r#"layout_version = 1
name = "camera"
motion_pattern = "3T"

[cable_defaults]
tension_min_N = 2.0
tension_max_N = 80.0
axial_stiffness_EA_N = 5e4
hysteresis = { strain = [0.0, 0.1, 0.2], loading_N = [0.0, 200.0, 500.0], unloading_N = [0.0, 150.0, 500.0], transition_strain = [0.001, 0.003] }

[[cable]]
name = "a"
frame_anchor_m = [0.0, 0.0, 3.0]

[[cable]]
name = "b"
frame_anchor_m = [4.0, 0.0, 3.0]
tension_max_N = 50.0
axial_compliance_per_N = 0.0

[[cable]]
name = "c"
frame_anchor_m = [2.0, 4.0, 3.0]
platform_anchor_m = [0.1, 0.0, 0.0]
"#;

/// A file with defaults is the file in which every cable states them, and is written as that.
#[test]
fn keys_of_all_cables_hold_for_those_that_do_not_state_them() {
    let robot = Robot::from_toml(WITH_DEFAULTS, "camera.toml").unwrap_or_else(|error| panic!("{error}"));
    let limits = |index: usize| (robot.cables[index].tension_min, robot.cables[index].tension_max);
    assert_eq!([limits(0), limits(1), limits(2)], [80.0, 50.0, 80.0].map(|max| (Some(2.0), Some(max))));
    assert_eq!([0, 1, 2].map(|cable| robot.cables[cable].axial_stiffness()), [Some(5e4), None, Some(5e4)]);
    assert_eq!(robot.cables[1].axial_compliance(), Some(0.0), "stated in another way");
    assert!(robot.cables.iter().all(|cable| cable.hysteresis.is_some()));
    let anchors = [0, 1, 2].map(|cable| robot.cables[cable].platform_anchor.x);
    assert_eq!(anchors, [0.0, 0.0, 0.1], "a point platform's anchors are its origin");
    let written = robot.to_toml();
    assert!(!written.contains("cable_defaults"), "{written}");
    assert_eq!(written.matches("tension_min_N = 2.0").count(), 3, "{written}");
    assert_eq!(Robot::from_toml(&written, "camera.toml").unwrap(), robot);
}

#[test]
fn a_robot_is_read_from_a_path_and_a_missing_file_is_told() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let robot = Robot::from_file(folder.join("robots/planar-example.toml")).unwrap();
    assert_eq!(robot, Robot::builtin("planar-example").unwrap());
    let missing = folder.join("robots/nowhere.toml");
    assert!(matches!(Robot::from_file(&missing), Err(FileError::Unreadable { path, .. }) if path == missing));
    // a text, but no robot
    let refused = Robot::from_file(folder.join("Cargo.toml")).unwrap_err();
    assert!(matches!(&refused, FileError::Refused(error) if error.code.starts_with("robot::")), "{refused}");
}
