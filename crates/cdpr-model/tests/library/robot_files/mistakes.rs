//! Mistakes in robot files, told with their place.

use super::*;

/// The error after one replacement, and that it points at the text `at` in the line `line`.
fn mistake(original: &str, from: &str, to: &str, at: &str, code: &str) -> ReadError {
    assert!(original.contains(from), "{from} is not in the file");
    let text = original.replacen(from, to, 1);
    let error = Robot::from_toml(&text, "robot.toml").expect_err(&format!("accepted: {to}"));
    let place = error.place.as_ref().unwrap_or_else(|| panic!("no place: {error}"));
    let pointed: String = place.source_line().chars().skip(place.column() - 1).collect();
    assert!(pointed.starts_with(at), "{error} points at {pointed:?}, not at {at:?}");
    assert_eq!(text.lines().nth(place.line() - 1).unwrap_or_default(), place.source_line(), "{error}");
    assert_eq!(error.code, code, "{error}");
    error
}

#[test]
fn mistakes_of_planar_files_are_told_with_their_place() {
    for (from, to, at, code) in [
        ("layout_version = 1", "layout_version = 2", "2", "robot::layout-version"),
        ("layout_version = 1", "layout_version = \"1\"", "\"1\"", "toml::wrong-type"),
        ("layout_version = 1\n", "", "name", "robot::layout-version"),
        ("name = \"frame\"", "name = \"a frame\"", "\"a frame\"", "robot::name"),
        ("name = \"frame\"", "name = 5", "5", "toml::wrong-type"),
        ("name = \"frame\"", "nam = \"frame\"", "nam =", "toml::unknown-key"),
        ("mass_kg", "mas_kg", "mas_kg", "toml::unknown-key"),
        ("angle_rad", "angle_deg", "angle_deg", "toml::unknown-key"),
        ("tension_min_N", "tension_min_n", "tension_min_n", "toml::unknown-key"),
        ("[workspace]", "[workpsace]", "workpsace", "toml::unknown-key"),
        ("\"1R2T\"", "\"2R1T\"", "\"2R1T\"", "toml::unknown-value"),
        ("\"unstrained\"", "\"unstraind\"", "\"unstraind\"", "toml::unknown-value"),
        ("\"xz\"", "\"xx\"", "\"xx\"", "robot::axes"),
        ("\"xz\"", "\"horizontal\"", "\"horizontal\"", "robot::axes"),
        ("axes = \"xz\"\n", "", "\"1R2T\"", "robot::axes"),
        ("cable_count = 2", "cable_count = 3", "3", "robot::cable-count"),
        ("cable_count = 2", "cable_count = -2", "-2", "toml::wrong-type"),
        ("[0.0, -9.81]", "[0.0, 0.0, -9.81]", "[0.0, 0.0, -9.81]", "robot::component-count"),
        ("frame_anchor_m = [2.0, 2.0]", "frame_anchor_m = [2.0]", "[2.0]", "robot::component-count"),
        ("frame_anchor_m = [2.0, 2.0]", "frame_anchor_m = [2.0, nan]", "nan", "toml::not-finite"),
        ("frame_anchor_m = [2.0, 2.0]", "frame_anchor_m = [2.0, inf]", "inf", "toml::not-finite"),
        ("frame_anchor_m = [2.0, 2.0]", "frame_anchor_m = [2.0, 1e308]", "1e308", "toml::too-large-number"),
        ("frame_anchor_m = [2.0, 2.0]", "frame_anchor_m = [0.0, 2.0]", "[0.0, 2.0]", "robot::coincident-anchors"),
        ("frame_anchor_m = [2.0, 2.0]", "frame_anchor_m = [2.0, \"2\"]", "\"2\"", "toml::wrong-type"),
        ("frame_anchor_m = [2.0, 2.0]\n", "", "[[cable]]", "toml::missing-key"),
        ("frame_anchor_m = [2.0, 2.0]", "frame_anchor_m = [2.0, ", "", "toml::syntax"),
        ("mass_kg = 1.0", "mass_kg = -1.0", "-1.0", "robot::negative"),
        ("mass_kg = 1.0", "mass_kg = 1.0\nmass_kg = 1.0", "mass_kg", "toml::syntax"),
        ("kg_m2 = 0.1", "kg_m2 = -0.1", "-0.1", "robot::inertia"),
        ("kg_m2 = 0.1", "kg_m2 = [[0.1]]", "[[0.1]]", "robot::inertia"),
        ("kg_m2 = 0.1", "kg_m2 = \"0.1\"", "\"0.1\"", "toml::wrong-type"),
        ("angle_rad = 0.3", "rotation = [[1.0]]", "[[1.0]]", "robot::home-pose"),
        ("moment_Nm = 3.0", "moment_Nm = [0.0, 0.0, 3.0]", "[0.0, 0.0, 3.0]", "robot::moment"),
        ("position_min_m = [0.0, 0.0]", "position_min_m = [3.0, 0.0]", "[3.0, 0.0]", "robot::workspace"),
        ("pulley_radius_m = 0.05", "pulley_radius_m = -0.05", "-0.05", "robot::negative"),
        ("[0.0, 1.0]", "[0.0, 1.1]", "[0.0, 1.1]", "robot::swivel-axis"),
        ("tension_min_N = 1.0", "tension_min_N = 11.0", "11.0", "robot::tension-limits"),
        ("tension_min_N = 1.0", "tension_min_N = -1.0", "-1.0", "robot::negative"),
        ("name = \"right\"", "name = \"\"", "\"\"", "robot::cable-name"),
        ("name = \"right\"", "name = \"left\"", "\"left\"", "robot::cable-name"),
        ("per_N = 0.0", "per_N = 0.0\naxial_stiffness_EA_N = 1e6", "0.0", "robot::stiffness-twice"),
        ("per_N = 0.0", "per_N = -1e-6", "-1e-6", "robot::negative"),
        ("axial_compliance_per_N = 0.0", "axial_stiffness_EA_N = 0.0", "0.0", "robot::not-positive"),
        ("hidden_length_m = 1.5", "hidden_length_m = -1.5", "-1.5", "robot::negative"),
        ("length_scale = 1.001", "length_scale = 0.0", "0.0", "robot::not-positive"),
        ("tension_scale = 0.98", "tension_scale = -0.98", "-0.98", "robot::not-positive"),
        ("tension_scale", "winch_radius_m", "winch_radius_m", "toml::unknown-key"),
    ] {
        mistake(PLANAR, from, to, at, code);
    }
}

/// Mistakes of the defaults are shown where they stand, not at the cable.
#[test]
fn mistakes_among_the_defaults_are_told_with_their_place() {
    for (from, to, at, code) in [
        ("tension_min_N = 2.0", "tension_min_N = 90.0", "90.0", "robot::tension-limits"),
        ("tension_min_N = 2.0", "tension_min_N = -2.0", "-2.0", "robot::negative"),
        ("axial_stiffness_EA_N = 5e4", "axial_stiffness_EA_N = 0.0", "0.0", "robot::not-positive"),
        ("150.0", "450.0", "[0.0, 450", "stretch::branches-cross"),
    ] {
        let error = mistake(WITH_DEFAULTS, from, to, at, code);
        assert!(error.message.contains("[cable_defaults]"), "{error}");
    }
    for (from, to, at, code) in [
        ("tension_min_N = 2.0", "tension_mim_N = 2.0", "tension_mim_N", "toml::unknown-key"),
        ("tension_min_N = 2.0", "tension_min_N = \"2\"", "\"2\"", "toml::wrong-type"),
        ("tension_min_N = 2.0", "platform_anchor_m = [0.0, 0.0, 0.0]", "[0.0", "robot::cable-defaults"),
        ("tension_min_N = 2.0", "name = \"all\"", "\"all\"", "robot::cable-defaults"),
        ("[cable_defaults]", "[[cable_defaults]]", "[[cable_defaults]]", "toml::wrong-type"),
        ("tension_max_N = 50.0", "tension_max_N = -50.0", "-50.0", "robot::negative"),
        ("\"3T\"", "\"3R3T\"", "[[cable]]", "toml::missing-key"),
    ] {
        let error = mistake(WITH_DEFAULTS, from, to, at, code);
        assert!(!error.message.contains("states this"), "{error}");
    }
    let error = mistake(WITH_DEFAULTS, "\"3T\"", "\"3R3T\"", "[[cable]]", "toml::missing-key");
    assert!(error.message.contains("cable 1 (`a`)") && error.help.unwrap().contains("point platforms"));
    let endless = format!("tension_of_strain_N = [{}]", "1.0, ".repeat(400_000));
    mistake(WITH_DEFAULTS, "tension_min_N = 2.0", &endless, "[cable_defaults]", "robot::cable-defaults");
}

#[test]
fn a_stretch_that_is_no_law_is_told_with_its_place() {
    for (from, to, at, code) in [
        ("[1e5, 2e6]", "[1e5, -2e6]", "[1e5", "stretch::not-rising"),
        ("[1e5, 2e6]", "[0.0, 2e6]", "[0.0", "stretch::not-rising"),
        ("[1e5, 2e6]", "[]", "[]", "stretch::entries"),
        ("1100.0, 5000.0", "5100.0, 5000.0", "[0.0, 5100", "stretch::not-rising"),
        ("900.0, 4500.0", "900.0, 5500.0", "[0.0, 900", "stretch::branches-cross"),
        ("900.0, 4500.0", "900.0", "[0.0, 900", "stretch::entries"),
        ("strain = [0.0, 0.01", "strain = [0.001, 0.01", "[0.001", "stretch::value"),
        ("[0.001, 0.003]", "[0.001, -0.003]", "[0.001, -0.003]", "stretch::value"),
        ("[0.75, 0.25]", "[0.75, 0.75]", "[0.75", "stretch::value"),
    ] {
        let error = mistake(PLANAR, from, to, at, code);
        assert!(error.help.is_some() && error.message.contains("cable 2 (`right`)"), "{error}");
    }
    // a polynomial that turns beyond the largest tension, 1250 N here, is used up to there
    let softening = PLANAR.replace("[1e5, 2e6]", "[1e5, -2e6]\ntension_max_N = 1000.0");
    assert!(Robot::from_toml(&softening, "robot.toml").is_ok());
}

#[test]
fn mistakes_of_spatial_files_are_told_with_their_place() {
    for (from, to, at, code) in [
        ("name = \"box\"", "name = \"box\"\naxes = \"xz\"", "\"xz\"", "robot::axes"),
        ("\"3R3T\"", "\"3T\"", "[[1.0", "robot::home-pose"),
        ("[0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\n[home", "[0.0, 1.0, 0.0]]\n[home", "[[1.0", "robot::inertia"),
        ("[[1.0, 0.0, 0.0]", "[[1.0, 0.5, 0.0]", "[[1.0", "robot::inertia"),
        ("rotation = [[1.0", "rotation = [[1.1", "[[1.1", "robot::home-pose"),
        ("rotation = [[1.0", "rotation = [[-1.0", "[[-1.0", "robot::home-pose"),
        ("rotation = ", "angle_rad = 0.0 #", "0.0", "robot::home-pose"),
        ("moment_Nm = [0.0, 0.0, 0.0]", "moment_Nm = 0.0", "0.0", "robot::moment"),
        ("[0.0, 2.0, 3.0]", "[0.0, 2.0]", "[0.0, 2.0]", "robot::component-count"),
        ("swivel_axis = ", "wrap_side = \"left\"\npulley_swivel_axis = ", "\"left\"", "robot::wrap-side"),
    ] {
        mistake(SPATIAL, from, to, at, code);
    }
}

#[test]
fn a_misspelt_key_or_value_is_answered_by_the_one_meant() {
    for (from, to, meant) in [
        ("axial_compliance_per_N", "axial_complience_per_N", "did you mean `axial_compliance_per_N`?"),
        ("\"1R2T\"", "\"1r2t\"", "did you mean `1R2T`? allowed: 2T, 3T, 1R2T, 3R3T"),
        ("\"right\"\ntension", "\"rigth\"\ntension", "did you mean `right`? allowed: left, right"),
        ("\"unstrained\"", "\"unstraind\"", "did you mean `unstrained`? allowed: actual, unstrained"),
    ] {
        let error = Robot::from_toml(&PLANAR.replacen(from, to, 1), "robot.toml").unwrap_err();
        assert!(error.help.as_deref().unwrap_or_default().starts_with(meant), "{error}");
    }
}

#[test]
fn an_error_reads_well_as_a_whole() {
    let text = PLANAR.replacen("tension_min_N = 1.0", "tension_min_N = 11.0", 1);
    assert_eq!(
        Robot::from_toml(&text, "frame.toml").unwrap_err().to_string(),
        "frame.toml:31:17: cable 1 (`left`): tension_min_N = 11 is above tension_max_N = 10\n  \
         help: swap them, or mend the wrong one"
    );
}

#[test]
fn files_that_are_no_robot_are_refused_as_a_whole() {
    let code = |bytes: &[u8]| Robot::from_toml_bytes(bytes, "robot.toml").unwrap_err().code;
    assert_eq!(code(b""), "toml::empty");
    assert_eq!(code(b"# only a comment\n"), "toml::empty");
    assert_eq!(code(b"name = \"\xff\""), "file::not-utf8");
    assert_eq!(code(&vec![b'#'; 17 * 1024 * 1024]), "file::too-large");
    assert_eq!(
        code(PLANAR.split("[[cable]]").next().unwrap().replace("cable_count = 2", "").as_bytes()),
        "robot::no-cables"
    );
    let cables = "[[cable]]\nname = \"1\"\nframe_anchor_m = []\nplatform_anchor_m = []\n".repeat(10_001);
    assert_eq!(
        code(format!("layout_version = 1\nname = \"a\"\nmotion_pattern = \"3T\"\n{cables}").as_bytes()),
        "robot::too-many-cables"
    );
}

/// A file that was cut off anywhere is refused, but where only the keys at its very end are gone.
#[test]
fn a_truncated_file_is_refused_or_is_a_robot_with_all_its_cables() {
    let text = builtin::find("caroca-pulleys").unwrap();
    for (end, _) in text.char_indices() {
        if let Ok(robot) = Robot::from_toml(&text[..end], "cut.toml") {
            assert_eq!(robot.cable_count(), 8, "cut at {end}");
        }
    }
}

#[test]
fn mistakes_of_winches_are_told_with_their_place() {
    let text = with_drum();
    for (from, to, at, code) in [
        ("drum_radius_m = 0.1", "drum_radius_m = 0.0", "0.0", "robot::not-positive"),
        ("drum_radius_m = 0.1", "drum_radius_m = 5e-324", "5e-324", "robot::not-positive"),
        ("drum_radius_m = 0.1", "drum_radius_m = 10.0", "[-1.0, -0.5", "robot::drum-place"),
        ("drum_pitch_m = 0.008", "drum_pitch_m = -0.008", "-0.008", "robot::negative"),
        ("drum_pitch_m = 0.008", "drum_pitch_m = 0.0", "0.2", "robot::groove"),
        ("drum_axis = [0.0, 1.0, 0.0]", "drum_axis = [0.0, 2.0, 0.0]", "[0.0, 2.0", "robot::drum-axis"),
        ("drum_axis = [0.0, 1.0, 0.0]", "drum_axis = [1.0]", "[1.0]", "robot::component-count"),
        ("drum_groove_length_m = 0.2\n", "", "0.007", "robot::groove"),
        ("gear_ratio = -12.0", "gear_ratio = 0.0", "0.0", "robot::gear-ratio"),
        ("\"right\"", "\"top\"", "\"top\"", "toml::unknown-value"),
        ("encoder_counts_per_turn = 4096.0", "encoder_counts_per_turn = -1.0", "-1.0", "robot::not-positive"),
        ("speed_max_m_s = 3.0", "speed_max_m_s = 0.0", "0.0", "robot::not-positive"),
        ("drum_radius_m = 0.1\n", "", "300.0", "robot::motor-speed"),
    ] {
        mistake(&text, from, to, at, code);
    }
}

#[test]
fn friction_that_cannot_be_is_refused_at_its_place() {
    let text = with_drum();
    for (from, to, at, code) in [
        ("drum_static_friction_Nm = 15.0", "drum_static_friction_Nm = 9.0", "9.0", "robot::friction"),
        ("drum_static_friction_Nm = 15.0", "drum_static_friction_Nm = -1.0", "-1.0", "robot::negative"),
        ("drum_static_friction_Nm = 15.0\n", "", "0.25", "robot::friction"),
        ("drum_stribeck_speed_rad_per_s = 0.25\n", "", "15.0", "robot::friction"),
        ("rad_per_s = 0.25", "rad_per_s = 0.0", "0.0", "robot::not-positive"),
        ("pulley_friction = 0.03", "pulley_friction = -0.03", "-0.03", "robot::negative"),
        ("pulley_radius_m = 0.05", "pulley_radius_m = 0.0", "0.02", "robot::pulley-inertia"),
    ] {
        mistake(&text, from, to, at, code);
    }
}

#[test]
fn assumptions_of_what_a_file_does_not_state_are_refused_at_their_place() {
    let text = PLANAR.to_owned() + ASSUMED;
    for (from, to, told) in [
        ("platform.mass_kg", "platform.mass", "did you mean `platform.mass_kg`?"),
        ("platform.mass_kg", "cable.drum_inertia_kg_m2", "no number that this file states"),
        ("platform.mass_kg", "platform", "did you mean `platform.mass_kg`?"),
        ("platform.mass_kg", "zzz", "name a number of the file"),
        ("platform.mass_kg", "platform[1].mass_kg", "no number"),
        ("platform.mass_kg", "cable.name", "no number"),
        ("platform.mass_kg", "cable.hysteresis", "assumed twice"),
        ("cable[1].tension", "cable[2].tension", "did you mean `cable.tension_min_N`?"),
        ("cable[1].tension", "cable[3].tension", "cable 3 does not exist"),
        ("cable[1].tension", "cable[1,2].tension", "no number"),
    ] {
        let at = if to == "cable.hysteresis" { to.to_owned() } else { to.split('.').next().unwrap().to_owned() };
        let error = mistake(&text, from, to, &format!("\"{at}"), "robot::assumption");
        assert!(error.to_string().contains(told), "{error}");
    }
    let error = mistake(&text, "\"a guess\"", "\" \"", "\" \"", "robot::assumption");
    assert!(error.to_string().contains("no reason"), "{error}");
}

#[test]
fn bodies_obstacles_and_limits_that_cannot_be_are_refused_at_their_place() {
    for (from, to, code) in [
        ("length_min_m = 0.5", "length_min_m = 13.0", "robot::length-limits"),
        ("pulley_wrap_min_rad = 0.1", "pulley_wrap_min_rad = 3.5", "robot::wrap-limits"),
        ("diameter_m = 0.006", "diameter_m = 0.0", "robot::not-positive"),
        ("radius_m = 0.1", "radius_m = -0.1", "robot::negative"),
        ("radius_m = 0.1", "", "robot::obstacle"),
        ("position_min_m = [1.0,", "position_min_m = [3.0,", "robot::obstacle"),
        ("from_m = [-4.0, 5.0, 6.0]", "from_m = [-4.0, 5.0]", "robot::component-count"),
        (", [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]\ninertia", "]\ninertia", "robot::hull"),
        ("hull_m = [[0.0, 0.0, 0.0]", "hull_m = [[0.0, 0.0]", "robot::component-count"),
    ] {
        let text = surrounded();
        assert!(text.contains(from), "{from}");
        let error = Robot::from_toml(&text.replacen(from, to, 1), "box.toml").unwrap_err();
        assert_eq!(error.code, code, "{from}: {error}");
    }
}
