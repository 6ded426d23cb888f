//! The first hour with files of one's own: every stumble is answered by its place and the way to mend it.

use super::{Run, SQUARE, cdpr_in, file_with};

const HEADER: &str = "x_m,y_m,cable_length_m_1,cable_length_m_2,cable_length_m_3,cable_length_m_4\n";
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

#[test]
fn a_spreadsheet_with_semicolons_tabs_or_utf_16_is_told_how_to_save_it() {
    let text = format!("{HEADER}{ROW}");
    let german = text.replace(',', ";").replace('.', ",");
    assert_answered(&evaluated(&german), "data.csv:1:4", &["separated by `;`", "sed 's/,/./g; s/;/,/g'"]);
    assert_answered(&evaluated(format!("\u{feff}{german}").replace('\n', "\r\n")), "data.csv:1:4", &["separated by"]);
    assert_answered(&evaluated(text.replace(',', "\t")), "data.csv:1:4", &["separated by tabs"]);
    let utf_16: Vec<u8> = [0xff, 0xfe].into_iter().chain(text.bytes().flat_map(|byte| [byte, 0])).collect();
    assert_answered(&evaluated(utf_16), "data.csv:1:1", &["UTF-16", "save the file as UTF-8"]);
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
        (HEADER.replace("y_m", "y"), "data.csv:1:5", ["`y_m` is missing; is it this one, `y`?", "name it `y_m`"]),
        (HEADER.replace("x_m", "X [mm]"), "data.csv:1:1", ["`X [mm]`?", "also accepted: mm"]),
        (HEADER.replace("length_m_", "length_"), "data.csv:1:9", ["`cable_length_1`?", "name it `cable_length_m_1`"]),
        (HEADER.replace("cable_length_m_", "L"), "data.csv:1:9", ["`L1`?", "name it `cable_length_m_1`"]),
        (HEADER.to_uppercase(), "data.csv:1:1", ["`X_M`?", "small letters"]),
        (HEADER.replace("y_m", "depth"), "data.csv:1:1", ["`y_m` is missing", "columns x_m, y_m, cable_length_m_1 …"]),
        (
            HEADER.replace("length_m", "length_cm"),
            "data.csv:1:9",
            ["the unit `cm` is not known", "`cable_length_mm_1`"],
        ),
        (format!("# May\n{HEADER}"), "data.csv:1:1", ["is a comment", "remove the lines above"]),
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
