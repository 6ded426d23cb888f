//! Files that say something wrong: exit code 2, the place, and nothing half-written.

use super::{Run, SQUARE, cdpr_in, file_with};

/// Asserts the exit code, the message and the place `file:line:column` (both from 1) or the file alone.
fn assert_refused(run: &Run, place: &str, message: &str) {
    assert_eq!(run.exit_code, 2, "{}{}", run.stdout, run.stderr);
    assert!(run.stderr.contains(message), "`{message}` is missing in:\n{}", run.stderr);
    assert!(run.stderr.contains(&format!("--> {place}")), "`{place}` is missing in:\n{}", run.stderr);
    assert!(run.stdout.is_empty(), "{}", run.stdout);
}

#[test]
fn mistakes_in_robot_files_are_placed_and_nothing_is_written() {
    let replaced = |from: &str, to: &str| SQUARE.replacen(from, to, 1);
    let no_cables = SQUARE.split_once("[[cable]]").unwrap().0.to_owned();
    for (text, place, message) in [
        (String::new(), "robot.toml:1:1", "the file says nothing"),
        (SQUARE[..SQUARE.len() - 8].to_owned(), "robot.toml:29:24", "not TOML"),
        (replaced("[5.0, 4.0]", "\"middle\""), "robot.toml:7:14", "invalid type"),
        (replaced("tension_min_N", "tension_mim_N"), "robot.toml:13:1", "unknown key `tension_mim_N`"),
        (replaced("10.0\ntension_max", "nan\ntension_max"), "robot.toml:13:17", "nan"),
        (replaced("= 100.0", "= inf"), "robot.toml:14:17", "inf"),
        (replaced("tension_min_N = 10.0", "pulley_radius_m = -0.1"), "robot.toml:13:19", "negative"),
        (replaced("tension_min_N = 10.0", "tension_min_N = 1000.0"), "robot.toml:13:17", "is above tension_max_N"),
        (no_cables, "robot.toml:", "no cables"),
        (replaced("name = \"b\"", "name = \"a\""), "robot.toml:17:8", "both named `a`"),
        (replaced("[10.0, 0.0]", "[10.0, 0.0, 0.0]"), "robot.toml:18:18", "2 components expected"),
    ] {
        let (folder, _) = file_with("robot.toml", text.as_bytes());
        let run = cdpr_in(folder.path(), "place-pulleys robot.toml --axis 0,1 --radius 0.1 --out out.toml");
        assert_refused(&run, place, message);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "{message}: nothing is written");
    }
}

#[test]
fn a_misspelt_key_is_answered_by_the_one_meant() {
    let (folder, _) = file_with("robot.toml", SQUARE.replacen("frame_anchor_m", "frame_ancor_m", 1).as_bytes());
    let run = cdpr_in(folder.path(), "check robot.toml");
    assert!(run.stderr.contains("help: did you mean `frame_anchor_m`?"), "{}", run.stderr);
    assert!(run.stderr.contains("11 | frame_ancor_m = [0.0, 0.0]\n   | ^^^^^^^^^^^^^"), "{}", run.stderr);
}

#[test]
fn bytes_that_are_no_text_are_refused_everywhere() {
    let (folder, _) = file_with("robot.toml", b"name = \"\xff\xfe\"");
    assert_refused(&cdpr_in(folder.path(), "check robot.toml"), "robot.toml:1:9", "not UTF-8");
    // of a table, \xff alone would be a letter of Latin-1
    std::fs::write(folder.path().join("data.csv"), b"x_m,y_m\n1,\xff\x00\n").unwrap();
    let run = cdpr_in(folder.path(), "evaluate planar-example data.csv");
    assert_refused(&run, "data.csv:2:3", "not UTF-8");
}

#[test]
fn mistakes_in_measurements_are_placed_and_nothing_is_written() {
    let heading = "x_m,z_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n";
    let row = "5,4,6.4,6.4,6.4,6.4\n";
    let renamed = |from: &str, to: &str| heading.replace(from, to) + row;
    for (text, place, message) in [
        (String::new(), "data.csv", "the file is empty"),
        (heading.to_owned(), "data.csv", "no rows"),
        (renamed("z_m,", "depth,"), "data.csv:1:1", "`z_m` is missing"),
        (renamed("x_m,", "x_furlong,"), "data.csv:1:1", "furlong"),
        (renamed(",cable_length_m_4", ",other"), "data.csv:1:1", "cables, robot"),
        (heading.to_owned() + row + "5,4,6.4,6.4,6.4\n", "data.csv:3:13", "5 fields"),
        (heading.to_owned() + row + "5,four,6.4,6.4,6.4,6.4\n", "data.csv:3:3", "four"),
        (heading.to_owned() + "5,4,6.4,NaN,6.4,6.4\n" + row, "data.csv:2:9", "NaN"),
        (
            heading.trim_end().to_owned() + ",cable_length_m_5\n5,4,6.4,6.4,6.4,6.4,6.4\n",
            "data.csv:1:1",
            "cables, robot",
        ),
    ] {
        let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
        std::fs::write(folder.path().join("data.csv"), &text).unwrap();
        let run = cdpr_in(folder.path(), "evaluate square.toml data.csv --out-errors errors.csv");
        assert_refused(&run, place, message);
        let run = cdpr_in(folder.path(), "identify square.toml data.csv --free length-offset --out out.toml");
        assert_refused(&run, place, message);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2, "{text}: nothing is written");
    }
}

#[test]
fn errors_are_objects_with_their_place_when_json_was_asked_for() {
    let (folder, _) = file_with("robot.toml", SQUARE.replacen("name", "nam", 1).as_bytes());
    let run = cdpr_in(folder.path(), "check robot.toml --format json");
    assert_eq!(run.exit_code, 2);
    let error = run.json_with(&["status", "reason", "help", "file", "line", "column", "code"]);
    assert_eq!(
        (error["file"].as_str(), error["line"].as_u64(), error["column"].as_u64()),
        (Some("robot.toml"), Some(2), Some(1))
    );
    assert!(run.stderr.contains("--> robot.toml:2:1"), "{}", run.stderr);
}
