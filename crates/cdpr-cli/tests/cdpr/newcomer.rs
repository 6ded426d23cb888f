//! The first hour with files of one's own: every stumble is answered by its place and the way to mend it.

use super::{Run, SQUARE, cdpr_in, file_with};

const HEADER: &str = "x_m,z_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n";
const ROW: &str = "5,4,6.403,6.403,6.403,6.403\n";

/// `cdpr evaluate` of the square robot on these measurements.
fn evaluated(data: impl AsRef<[u8]>) -> Run {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    std::fs::write(folder.path().join("data.csv"), data).unwrap();
    cdpr_in(folder.path(), "evaluate square.toml data.csv")
}

/// Asserts exit code 2, the place and all words.
fn assert_answered(run: &Run, place: &str, words: &[&str]) {
    assert_eq!(run.exit_code, 2, "{}{}", run.stdout, run.stderr);
    let text = &run.stderr;
    assert!(text.contains(&format!("--> {place}\n")), "`{place}` is missing in:\n{text}");
    words.iter().for_each(|word| assert!(text.contains(word), "`{word}` is missing in:\n{text}"));
}

/// The file of a spreadsheet with decimal commas gives the answer of the plain file, and the way it was read is said.
#[test]
fn a_spreadsheet_with_semicolons_tabs_decimal_commas_utf_16_or_latin_1_is_read_as_it_is() {
    let text = format!("{HEADER}{ROW}");
    let plain = evaluated(&text).stdout;
    let german = text.replace(',', ";").replace('.', ",");
    let utf_16 = |text: &str| -> Vec<u8> {
        [0xff, 0xfe].into_iter().chain(text.encode_utf16().flat_map(u16::to_le_bytes)).collect()
    };
    let named = german.replacen("4\n", "4;Gr\u{f6}\u{df}e\n", 1).replacen("403\n", "403;\u{e4}\n", 1);
    let latin: Vec<u8> = named.chars().map(|character| character as u8).collect();
    for (data, remark) in [
        (german.clone().into_bytes(), "data.csv: read as ; separated with decimal commas"),
        (format!("\u{feff}{german}").replace('\n', "\r\n").into_bytes(), "read as ; separated with decimal commas"),
        (text.replace(',', ";").into_bytes(), "data.csv: read as ; separated"),
        (text.replace(',', "\t").into_bytes(), "data.csv: read as tab separated"),
        (german.replace(';', "\t").into_bytes(), "data.csv: read as tab separated with decimal commas"),
        (utf_16(&text), "data.csv: read as UTF-16"),
        (utf_16(&german), "data.csv: read as ; separated with decimal commas, UTF-16"),
        (latin, "data.csv: read as ; separated with decimal commas, Latin-1"),
        (format!("# May\n{}", text.replace('\n', "\n# pause\n")).into_bytes(), ""),
    ] {
        let run = evaluated(&data);
        assert_eq!((run.exit_code, &run.stdout), (0, &plain), "{}", run.stderr);
        assert!(run.stderr.contains(remark), "`{remark}` is missing in: {}", run.stderr);
    }
}

/// The other decimal mark, or one of thousands, is not guessed at.
#[test]
fn a_number_with_another_mark_than_the_first_one_is_placed_where_it_stands() {
    let german = format!("# May\n{HEADER}{ROW}").replace(',', ";").replace('.', ",");
    for (wrong, place, words) in [
        ("5;4;6.403;6,403;6,403;6,403\n", "data.csv:4:5", "line 3 has a decimal comma"),
        ("5;4;6,403;1.006,403;6,403;6,403\n", "data.csv:4:11", "none a separator of thousands"),
        ("5;4;6,403;;6,403;6,403\n", "data.csv:4:11", "`cable_length_m_2` is empty"),
    ] {
        assert_answered(&evaluated(format!("{german}{wrong}")), place, &[words]);
    }
    let english = german.replace("6,403", "6.403");
    assert_answered(
        &evaluated(format!("{english}5;4;6.403;6,403;6.403;6.403\n")),
        "data.csv:4:11",
        &["`6,403` is not a number", "line 3 has a decimal point"],
    );
}

#[test]
fn a_byte_order_mark_crlf_blanks_and_a_nameless_last_column_do_no_harm() {
    let text = format!("{HEADER}{ROW}");
    let plain = evaluated(&text).stdout;
    for other in [
        format!("\u{feff}{text}").replace('\n', "\r\n"),
        text.replace(',', " , "),
        text.replace('\n', "\n\n"),
        text.replace('\n', ",\n"),
    ] {
        let run = evaluated(&other);
        assert_eq!((run.exit_code, &run.stdout), (0, &plain), "{other}{}", run.stderr);
    }
    assert!(evaluated(text.replace('\n', ",\n")).stderr.contains("ignored columns 7 (without a name)"));
}

#[test]
fn a_column_that_is_nearly_named_right_is_shown_with_its_right_name() {
    for (wrong, place, words) in [
        (HEADER.replace("z_m", "z"), "data.csv:1:5", ["`z_m` is missing; is it this one, `z`?", "name it `z_m`"]),
        (
            HEADER.replace("x_m", "X [mm]"),
            "data.csv:1:1",
            ["`X [mm]`?", "name it `x_mm`; names are in small letters with the unit at its place (also accepted: mm"],
        ),
        (HEADER.replace("length_m_", "length_"), "data.csv:1:9", ["`cable_length_1`?", "name it `cable_length_m_1`"]),
        (HEADER.replace("cable_length_m_", "L"), "data.csv:1:9", ["`L1`?", "name it `cable_length_m_1`"]),
        (HEADER.to_uppercase(), "data.csv:1:1", ["`X_M`?", "small letters"]),
        (HEADER.replace("z_m", "depth"), "data.csv:1:1", ["`z_m` is missing", "columns x_m, z_m, cable_length_m_1 …"]),
        (
            HEADER.replace("length_m", "length_cm"),
            "data.csv:1:9",
            ["the unit `cm` is not known", "`cable_length_mm_1`"],
        ),
    ] {
        assert_answered(&evaluated(wrong + ROW), place, &words);
    }
}

#[test]
fn a_row_that_does_not_fit_says_why() {
    for (rows, place, words) in [
        (format!("m,m,m,m,m,m\n{ROW}"), "data.csv:2:1", ["line one of units?", "part of the column's name"]),
        (format!("{ROW}5,4,6.4,,6.4,6.4\n"), "data.csv:3:9", ["`cable_length_m_2` is empty", "remove the row"]),
        (format!("{}\n", ROW.trim_end().to_owned() + ","), "data.csv:2:23", ["7 fields", "the comma at the end"]),
        (ROW.replace("6.403", "6,403").replace("5,4", "5,0,4,0"), "data.csv:2:11", ["12 fields", "decimal commas?"]),
        (ROW.replacen("6.403", "\"6,403\"", 1), "data.csv:2:5", ["`6,403` is not a number", "not with a comma"]),
    ] {
        assert_answered(&evaluated(format!("{HEADER}{rows}")), place, &words);
    }
}

/// Samples of a spatial robot with eight cables: poses with turns of some degrees, and the lengths that belong to them.
fn spatial_samples(folder: &std::path::Path) -> String {
    let study = "[control]\nrobot = \"ipanema-1\"\n[machine]\nrobot = \"ipanema-1\"\n[initial]\npose = [0, 0, 0, 0, 0, 0]\n\
                 offset = \"none\"\n[poses.grid]\nmin = [-0.3, -0.3, -0.3, 0.02, 0.04, 0.06]\n\
                 max = [0.3, 0.3, 0.3, 0.1, 0.1, 0.1]\ncount = [2, 2, 2, 2, 1, 2]\n";
    std::fs::write(folder.join("study.toml"), study).unwrap();
    let run = cdpr_in(folder, "simulate study.toml --out simulated.csv");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
    std::fs::read_to_string(folder.join("simulated.csv")).unwrap()
}

/// The numbers of some columns, each multiplied.
fn scaled(text: &str, columns: std::ops::Range<usize>, factor: f64) -> String {
    let field = |(index, field): (usize, &str)| match field.parse::<f64>() {
        Ok(number) if columns.contains(&index) => (number * factor).to_string(),
        _ => field.to_owned(),
    };
    let row = |line: &str| line.split(',').enumerate().map(field).collect::<Vec<_>>().join(",") + "\n";
    text.lines().map(row).collect()
}

#[test]
fn numbers_in_another_unit_than_their_column_says_are_recognised_by_the_robots_size() {
    let folder = tempfile::tempdir().unwrap();
    let text = spatial_samples(folder.path());
    let evaluated = |data: &str| {
        std::fs::write(folder.path().join("data.csv"), data).unwrap();
        cdpr_in(folder.path(), "evaluate ipanema-1 data.csv")
    };
    assert!(text.starts_with("x_m,y_m,z_m,qx,qy,qz,qw,cable_length_m_1,"), "{text}");
    assert_eq!(evaluated(&text).exit_code, 0);
    for (data, place, words) in [
        (scaled(&text, 7..15, 1e3), "data.csv:1:25", ["the cable lengths look like millimetres", "cable_length_mm_1"]),
        (scaled(&text, 7..15, 1e2), "data.csv:1:25", ["the cable lengths look like centimetres", "divide them by 100"]),
        (scaled(&text, 0..3, 1e3), "data.csv:1:1", ["the positions look like millimetres", "x_mm, y_mm, z_mm"]),
        (scaled(&scaled(&text, 0..3, 1e3), 7..15, 1e3), "data.csv:1:25", ["positions and cable lengths look", "x_mm"]),
        (scaled(&scaled(&text, 0..3, 1e-3), 7..15, 1e-3), "data.csv:1:25", ["anchors of the robot file", "by 1000"]),
    ] {
        assert_answered(&evaluated(&data), place, &words);
    }
    let moved: String = text
        .lines()
        .enumerate()
        .map(|(line, row)| {
            let mut fields: Vec<&str> = row.split(',').collect();
            if line > 0 {
                fields[3..7].rotate_right(1);
            }
            fields.join(",") + "\n"
        })
        .collect();
    let run = evaluated(&moved);
    assert!(run.stderr.contains("as if the scalar came first"), "{}", run.stderr);
}

#[test]
fn one_number_without_its_decimal_point_is_found() {
    let run = evaluated(format!("{HEADER}{ROW}{ROW}{}", ROW.replacen("6.403", "6403", 1)));
    assert_answered(
        &run,
        "data.csv:4:5",
        &["6403 m is more than 50 times the size of the robot", "decimal point lost"],
    );
}

/// Angles of an example platform, ±5° about the middle of a square frame.
#[test]
fn degrees_in_a_column_of_radians_are_recognised() {
    let robot =
        SQUARE.replace("2T", "1R2T").replace("position_m = [5.0, 4.0]", "position_m = [5.0, 4.0]\nangle_rad = 0.0");
    let corners = [[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]];
    let mut parts = robot.split("platform_anchor_m = [0.0, 0.0]");
    let mut turned = parts.next().unwrap().to_owned();
    for (rest, [x, z]) in parts.zip(corners) {
        turned += &format!("platform_anchor_m = [{x}, {z}]{rest}");
    }
    let mut rows = String::new();
    for degrees in [-5.0_f64, -3.0, 2.0, 5.0] {
        rows += &format!("5,4,{degrees}");
        for ([b_x, b_z], [a_x, a_z]) in corners.iter().zip([[0.0, 0.0], [10.0, 0.0], [10.0, 8.0], [0.0, 8.0]]) {
            let (sin, cos) = degrees.to_radians().sin_cos();
            rows += &format!(",{}", (a_x - 5.0 - cos * b_x + sin * b_z).hypot(a_z - 4.0 - sin * b_x - cos * b_z));
        }
        rows += "\n";
    }
    let (folder, _) = file_with("turning.toml", turned.as_bytes());
    let evaluated = |column: &str| {
        let data = HEADER.replace("z_m,", &format!("z_m,{column},")) + &rows;
        std::fs::write(folder.path().join("data.csv"), data).unwrap();
        cdpr_in(folder.path(), "evaluate turning.toml data.csv")
    };
    assert_answered(
        &evaluated("angle_rad"),
        "data.csv:1:9",
        &["the angles look like degrees", "name the column angle_deg"],
    );
    let run = evaluated("angle_deg");
    assert_eq!(run.exit_code, 0, "{}", run.stderr);
}

#[test]
fn the_file_of_a_built_in_robot_is_a_start_for_ones_own() {
    let printed = cdpr_in(std::path::Path::new("."), "robots planar-example");
    assert_eq!(printed.exit_code, 0, "{}", printed.stderr);
    let (folder, _) = file_with("my-robot.toml", printed.stdout.as_bytes());
    assert_eq!(cdpr_in(folder.path(), "check my-robot.toml").exit_code, 0);
    let json = cdpr_in(folder.path(), "robots planar-example --format json").json_with(&["name", "toml"]);
    assert_eq!(json["toml"].as_str(), Some(printed.stdout.as_str()));
    let wrong = cdpr_in(folder.path(), "robots planar-exampel");
    assert!(wrong.exit_code == 2 && wrong.stderr.contains("did you mean `planar-example`?"), "{}", wrong.stderr);
}

#[test]
fn mistakes_of_a_first_robot_file_say_how_to_mend_them() {
    let replaced = |from: &str, to: &str| SQUARE.replacen(from, to, 1);
    for (text, place, words) in [
        (replaced("[10.0, 8.0]", "[10,0, 8,0]"), "robot.toml:23:18", ["found 4", "decimal commas?"]),
        (
            replaced("= 10.0", "= \"10 N\""),
            "robot.toml:13:17",
            ["expected a number", "without quotes and without unit"],
        ),
        (
            replaced("frame_anchor_m = [0.0, 0.0]\n", ""),
            "robot.toml:9:1",
            ["`frame_anchor_m` is missing", "add `frame"],
        ),
        (replaced("[5.0, 4.0]", "5.0"), "robot.toml:7:14", ["expected a sequence", "a list in brackets"]),
    ] {
        let (folder, _) = file_with("robot.toml", text.as_bytes());
        assert_answered(&cdpr_in(folder.path(), "check robot.toml"), place, &words);
    }
}

#[test]
fn anchors_in_millimetres_are_a_warning_of_check() {
    let warned = |text: String, words: &str| {
        let (folder, _) = file_with("robot.toml", text.as_bytes());
        let run = cdpr_in(folder.path(), "check robot.toml");
        assert!(run.exit_code == 0 && run.stdout.contains(words), "{words}: {}{}", run.stdout, run.stderr);
    };
    warned(SQUARE.replace("[10.0, ", "[10000.0, ").replace(", 8.0]", ", 8000.0]"), "are they millimetres?");
    warned(SQUARE.replacen("platform_anchor_m = [0.0, 0.0]", "platform_anchor_m = [200.0, 0.0]", 1), "in a frame of");
}

/// Commands that write positions of the square robot, which moves in the plane xz, and those that read them.
#[test]
fn data_of_a_plane_carry_the_names_of_its_axes_and_older_files_are_read() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    let study = "[control]\nrobot = \"square.toml\"\n[machine]\nrobot = \"square.toml\"\n[initial]\npose = [5, 4]\n\
                 offset = \"none\"\n[poses.file]\npath = \"poses.csv\"\n";
    std::fs::write(folder.path().join("study.toml"), study).unwrap();
    for heading in ["x_m,z_m", "x_m,y_m", "z_mm,x_m"] {
        let row = if heading == "z_mm,x_m" { "3000,4" } else { "4,3" };
        std::fs::write(folder.path().join("poses.csv"), format!("{heading}\n{row}\n")).unwrap();
        let run = cdpr_in(folder.path(), "simulate study.toml --out data.csv");
        assert_eq!(run.exit_code, 0, "{heading}: {}", run.stderr);
        let data = std::fs::read_to_string(folder.path().join("data.csv")).unwrap();
        assert!(data.starts_with("x_m,z_m,cable_length_m_1,") && data.contains("\n4,3,5,"), "{heading}: {data}");
    }
    let plain = evaluated(format!("{HEADER}{ROW}"));
    let former = evaluated(format!("{}{ROW}", HEADER.replace("z_m", "y_m")));
    assert_eq!((former.exit_code, &former.stdout), (0, &plain.stdout), "{}", former.stderr);
    assert!(former.stderr.contains("plane xz of the robot; name the columns x_m, z_m"), "{}", former.stderr);
    assert!(plain.stderr.is_empty(), "{}", plain.stderr);
    for (header, row, place, words) in [
        (
            "x_m,y_m,z_m,",
            "5,4,4,",
            "data.csv:1:5",
            ["three coordinates, but the robot's are x_m, z_m", "remove the column `y_m`"],
        ),
        ("y_m,z_m,", "5,4,", "data.csv:1:1", ["the column `x_m` is missing", "columns x_m, z_m, cable_length_m_1"]),
    ] {
        let data = HEADER.replace("x_m,z_m,", header) + &ROW.replace("5,4,", row);
        assert_answered(&evaluated(data), place, &words);
    }
    // the plane of the example is xy: a third coordinate is across it, whatever file it is from
    let example =
        "x_m,y_m,z_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n0,5,0,7.2,6.4,7.2,6.4\n";
    std::fs::write(folder.path().join("example.csv"), example).unwrap();
    let run = cdpr_in(folder.path(), "evaluate planar-example example.csv");
    assert!(run.stderr.contains("ignored column `z_m`, across the robot's plane"), "{}", run.stderr);
}

/// A platform that all cables hold at one point turns freely about it.
#[test]
fn a_singular_home_is_a_negative_answer_of_check() {
    let turning =
        SQUARE.replace("2T", "1R2T").replace("position_m = [5.0, 4.0]", "position_m = [5.0, 4.0]\nangle_rad = 0.0");
    let (folder, _) = file_with("turning.toml", turning.as_bytes());
    let run = cdpr_in(folder.path(), "check turning.toml --format json");
    let answer = run.json();
    assert_eq!((run.exit_code, answer["status"].as_str()), (1, Some("singular")), "{answer}");
    assert!(answer["reason"].as_str().unwrap().contains("only 2 of 3 degrees of freedom"), "{answer}");
    let fine = cdpr_in(folder.path(), "check planar-example --format json");
    assert_eq!((fine.exit_code, fine.json()["status"].as_str()), (0, Some("checked")));
}

#[test]
fn check_doubts_numbers_that_nobody_means() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    assert_eq!(cdpr_in(folder.path(), "new suspended-camera --out .").exit_code, 0);
    let path = folder.path().join("robot.toml");
    let mistaken = std::fs::read_to_string(&path).unwrap().replacen("[6.0, 4.0, 6.0]", "[6.0, 4.0, 9.0]", 1);
    std::fs::write(&path, mistaken.replace("tension_max_N = 300.0", "tension_max_N = 10.0")).unwrap();
    let answer = cdpr_in(folder.path(), "check robot.toml --format json").json_with(&["findings", "warnings"]);
    let findings = answer["findings"].as_array().unwrap();
    let of = |place: usize| (&findings[place]["kind"], &findings[place]["cable"], &findings[place]["severity"]);
    assert_eq!(of(0), (&"anchor".into(), &3.into(), &"remark".into()), "{answer}");
    assert_eq!(of(1), (&"unit".into(), &serde_json::Value::Null, &"caution".into()), "{answer}");
    assert_eq!(findings[0]["text"], answer["warnings"][0]);
    let words = cdpr_in(folder.path(), "check robot.toml").stdout;
    assert!(words.contains("3.000 m beside (6.000, 4.000, 6.000) m") && words.contains("in kilonewtons?"), "{words}");
}

#[test]
fn check_lists_the_models_that_a_file_supports_and_what_it_lacks() {
    let (folder, _) = file_with("square.toml", SQUARE.as_bytes());
    let run = cdpr_in(folder.path(), "check square.toml");
    assert!(run.stdout.contains("models            standard\n"), "{}", run.stdout);
    let words = run.prose();
    let lacking =
        &words[words.find("not supported pulley (pulley_swivel_axis), ").unwrap_or_else(|| panic!("{words}"))..];
    assert!(lacking.contains("elastic ("), "{lacking}");
    assert_eq!(run.stdout.matches("pulley").count(), 2, "the line is all: {}", run.stdout);
    let models = cdpr_in(folder.path(), "check planar-example --format json").json()["models"].clone();
    assert_eq!((models["richest"].as_str(), &models["effects"]), (Some("elastic"), &serde_json::json!(["elastic"])));
    let missing = models["missing"].as_array().unwrap();
    let catenary = missing.iter().find(|entry| entry["effect"] == "catenary").unwrap();
    assert!(catenary["reason"].as_str().unwrap().contains("linear_density_kg_per_m"), "{catenary}");
}

/// Two cables hold a loaded point in space where lengths and load put it: `fk` finds it, and `check` says no other.
#[test]
fn fewer_cables_than_degrees_of_freedom_are_no_singular_home() {
    let (kept, _) = SQUARE.split_once("[[cable]]\nname = \"c\"").unwrap();
    let spatial = kept
        .replace("2T", "3T")
        .replace("axes = \"xz\"\n", "")
        .replace("[5.0, 4.0]", "[5.0, 0.0, -4.0]")
        .replace("[0.0, 0.0]", "[0.0, 0.0, 0.0]")
        .replace("[10.0, 0.0]", "[10.0, 0.0, 0.0]");
    let loaded =
        spatial.replace("[home_pose]", "gravity_m_s2 = [0.0, 0.0, -9.81]\n\n[platform]\nmass_kg = 10.0\n\n[home_pose]");
    let (folder, _) = file_with("loaded.toml", loaded.as_bytes());
    std::fs::write(folder.path().join("unloaded.toml"), spatial).unwrap();
    for (file, words, status) in [
        ("loaded.toml", "answers where cables and load are in equilibrium", "converged"),
        ("unloaded.toml", "while the file states no load", "singular"),
    ] {
        let check = cdpr_in(folder.path(), &format!("check {file} --format json"));
        let warnings = check.json()["warnings"].to_string();
        assert_eq!(check.exit_code, 0, "{warnings}");
        assert!(
            warnings.contains("2 cables cannot hold 3 degrees of freedom") && warnings.contains(words),
            "{warnings}"
        );
        let fk = cdpr_in(folder.path(), &format!("fk {file} --lengths 6.4,6.4 --format json")).json();
        assert_eq!(fk["status"], status, "{fk}");
    }
}
