//! The effect `drum`: motor angles out of `ik`, into `fk`, and in measurement files.

use super::{Run, SQUARE, cdpr_in, file_with, listed, numbers};

/// The square robot with a drum below every corner, geared 10 : 1.
fn square_with_drums() -> String {
    let drum = |text: String, (anchor, position): (&str, &str)| {
        let keys = format!(
            "drum_radius_m = 0.1\ndrum_pitch_m = 0.008\ndrum_axis = [0.0, 1.0, 0.0]\ndrum_position_m = {position}\n\
             gear_ratio = 10.0\nencoder_counts_per_turn = 4096.0\n"
        );
        text.replacen(&format!("{anchor}\n"), &format!("{anchor}\n{keys}"), 1)
    };
    [
        ("frame_anchor_m = [0.0, 0.0]", "[0.0, -0.1, -1.5]"),
        ("frame_anchor_m = [10.0, 0.0]", "[10.0, -0.1, -1.5]"),
        ("frame_anchor_m = [10.0, 8.0]", "[10.0, -0.1, 6.5]"),
        ("frame_anchor_m = [0.0, 8.0]", "[0.0, -0.1, 6.5]"),
    ]
    .into_iter()
    .fold(SQUARE.to_owned(), drum)
}

fn on_square(arguments: &str) -> Run {
    let (folder, _) = file_with("square.toml", square_with_drums().as_bytes());
    cdpr_in(folder.path(), arguments)
}

#[test]
fn motor_angles_of_ik_lead_fk_back_to_the_pose() {
    let ik = on_square("ik square.toml --pose 4,3 --model drum --format json");
    let answer = ik.json_with(&["motor_angles_rad", "encoder_counts"]);
    let (angles, counts) = (numbers(&answer["motor_angles_rad"]), numbers(&answer["encoder_counts"]));
    assert!((counts[0] - angles[0] / std::f64::consts::TAU * 4096.0).abs() < 1e-6);
    let fk = on_square(&format!("fk square.toml --model drum --motor-angles {} --format json", listed(&angles)));
    let position = numbers(&fk.json()["pose"]["position_m"]);
    // the tolerance of the search
    assert!((position[0] - 4.0).abs() < 1e-8 && (position[1] - 3.0).abs() < 1e-8, "{position:?}");
}

/// An ideal winch of the same radius is some millimetres off, and says that it is one.
#[test]
fn without_the_effect_angles_are_those_of_an_ideal_winch() {
    let angles = on_square("ik square.toml --pose 4,3 --model drum --format json").json()["motor_angles_rad"].clone();
    let fk = on_square(&format!("fk square.toml --motor-angles {} --format json", listed(&numbers(&angles))));
    assert!(fk.stderr.contains("ideal winches"), "{}", fk.stderr);
    let position = numbers(&fk.json()["pose"]["position_m"]);
    let error = f64::hypot(position[0] - 4.0, position[1] - 3.0);
    assert!(error > 1e-4 && error < 0.02, "{error}");
}

#[test]
fn what_a_winch_cannot_do_is_told_with_a_cure() {
    let refused = |robot: &str, arguments: &str, said: &[&str]| {
        let (folder, _) = file_with("square.toml", robot.as_bytes());
        let run = cdpr_in(folder.path(), arguments);
        assert_eq!(run.exit_code, 2, "{}{}", run.stdout, run.stderr);
        said.iter().for_each(|part| assert!(run.stderr.contains(part), "{part} is not in {}", run.stderr));
    };
    refused(SQUARE, "ik square.toml --pose 4,3 --model drum", &["drum_radius_m", "cable 1"]);
    refused(SQUARE, "fk square.toml --motor-angles 1,2,3,4", &["drum_radius_m", "[winch::no-radius]"]);
    refused(&square_with_drums(), "fk square.toml --motor-angles 1,2,3", &["[winch::angle-count]"]);
    // 10 turns of 0.63 m hold 6.29 m, and the second corner is √45 m away
    let short = square_with_drums().replacen("gear_ratio", "drum_groove_length_m = 0.08\ngear_ratio", 4);
    let said = ["cable 2", "holds 6.2869 m", "6.7082 m", "drum_groove_length_m", "[winch::groove]"];
    refused(&short, "ik square.toml --pose 4,3 --model drum", &said);
    let no_pitch = square_with_drums().replacen("drum_pitch_m = 0.008\n", "", 1);
    refused(&no_pitch, "ik square.toml --pose 4,3 --model drum", &["drum_pitch_m"]);
}
