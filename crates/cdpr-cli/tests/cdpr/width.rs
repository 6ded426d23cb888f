//! Text of commands fits 80 columns: examples of the book; files and tables on stdout are not folded.

use std::path::Path;

use assert_cmd::Command;
use unicode_width::UnicodeWidthStr;

use super::book::{chapters, commands};
use super::{Run, cdpr_in, root, run};

/// The narrowest terminal.
const COLUMNS: usize = 80;

/// Beginnings of commands that take longer than anybody waits for a test.
const LONG: [&str; 6] =
    ["cdpr advise", "cdpr benchmark", "cdpr campaign", "cdpr chain", "cdpr reachable", "cdpr sensitivity"];

/// Studies of the repository, and a robot and measurements by the names that the book gives those of its readers.
fn with_files_of_readers(folder: &Path) {
    std::fs::create_dir(folder.join("studies")).unwrap();
    let studies = root().join("studies");
    for place in ["", "robots"] {
        std::fs::create_dir_all(folder.join("studies").join(place)).unwrap();
        for entry in std::fs::read_dir(studies.join(place)).unwrap() {
            let path = entry.unwrap().path();
            if path.is_file() {
                std::fs::copy(&path, folder.join("studies").join(place).join(path.file_name().unwrap())).unwrap();
            }
        }
    }
    for command in ["new suspended-camera --out my-robot", "simulate my-robot/study.toml --out samples.csv"] {
        let made = cdpr_in(folder, command);
        assert_eq!(made.exit_code, 0, "{}", made.stderr);
    }
    std::fs::write(folder.join("winch.csv"), super::friction::record()).unwrap();
    std::fs::write(folder.join("record.csv"), super::frequency_response::record()).unwrap();
    for (file, copy) in [("my-robot/robot.toml", "robot.toml"), ("samples.csv", "measurements.csv")] {
        std::fs::copy(folder.join(file), folder.join(copy)).unwrap();
    }
}

/// A command by the shell's rule of quotation marks, in a terminal of 80 columns.
fn shown(folder: &Path, command: &str) -> Run {
    let mut quote = None;
    let words: Vec<String> = command
        .split(|letter: char| {
            let mark = matches!(letter, '\'' | '"');
            quote = if mark && quote.is_none() { Some(letter) } else { quote.filter(|open| *open != letter) };
            letter == ' ' && quote.is_none()
        })
        .filter(|word| !word.is_empty())
        .map(|word| word.replace(['\'', '"'], ""))
        .collect();
    let mut program = Command::cargo_bin("cdpr").unwrap();
    run(program.current_dir(folder).env("COLUMNS", COLUMNS.to_string()).args(&words[1..]))
}

/// Lines that do not fit, but for those of a single word, which nobody could break.
fn too_wide(text: &str) -> Vec<&str> {
    text.lines().filter(|line| line.width() > COLUMNS && line.trim().contains(' ')).collect()
}

#[test]
fn every_example_of_the_book_fits_into_eighty_columns() {
    let folder = tempfile::tempdir().unwrap();
    with_files_of_readers(folder.path());
    let mut examples: Vec<String> = chapters().iter().flat_map(|text| commands(text)).collect();
    examples.retain(|command| !LONG.iter().any(|long| command.starts_with(long)) && !command.contains("sweep"));
    assert!(examples.len() > 60, "{}", examples.len());
    let (mut answered, mut count) = (0, 0);
    for command in examples {
        let command = command.split(" #").next().unwrap().split(" > ").next().unwrap();
        let run = shown(folder.path(), command);
        for text in [&run.stdout, &run.stderr] {
            let wide = too_wide(text);
            assert!(wide.is_empty(), "{command}: {} of {}", wide.join("\n"), text.lines().count());
        }
        count += 1;
        answered += usize::from(run.exit_code <= 1);
    }
    assert!(answered * 10 > count * 6, "{answered} of {count} examples are answered; the others lack files");
}

/// The summary is kept to one screen and says by `--verbose` what it leaves out; JSON is the same with both.
#[test]
fn a_selection_takes_one_screen_and_all_of_it_is_a_word_away() {
    let folder = tempfile::tempdir().unwrap();
    let short = shown(folder.path(), "cdpr demo --out result");
    assert_eq!(short.exit_code, 0, "{}", short.stderr);
    for part in [
        "recommended with caution: elastic · frame and platform anchors, offsets, stiffness, load (70)",
        "candidates by ",
        "largest changes (10 of 70 parameters)",
        "worst cable: ",
        "poses of the fit: x ",
        "more with --verbose",
    ] {
        assert!(short.prose().contains(part), "`{part}` is not in {}", short.stdout);
    }
    assert!(
        !short.stdout.contains("noise factor") && !short.stdout.contains("the criteria disagree"),
        "{}",
        short.stdout
    );
    let all = shown(folder.path(), "cdpr demo --out result --verbose");
    for part in
        ["condition", "rated by other criteria", "all 9 criteria choose", "elastic:frame-anchor,platform-anchor"]
    {
        assert!(all.prose().contains(part), "`{part}` is not in {}", all.stdout);
    }
    let [plain, verbose] = ["", " --verbose"].map(|option| {
        let mut answer = shown(folder.path(), &format!("cdpr demo --out result --format json{option}")).json();
        answer["timing"] = serde_json::Value::Null;
        answer
    });
    assert_eq!(plain, verbose);
    let labels: Vec<&str> =
        plain["candidates"].as_array().unwrap().iter().map(|one| one["label"].as_str().unwrap()).collect();
    assert_eq!((labels[0], labels.len()), ("rigid · as given", plain["candidates"].as_array().unwrap().len()));
    assert_eq!(plain["candidates"][0]["name"], "standard");
}

/// Colour says what weighs; the words are the same.
#[test]
fn colour_marks_the_outcome_and_its_doubts() {
    let folder = tempfile::tempdir().unwrap();
    let [coloured, plain] =
        ["always", "never"].map(|choice| shown(folder.path(), &format!("cdpr demo --color {choice}")).stdout);
    assert!(coloured.contains("\x1b[33mrecommended with caution: "), "{coloured}");
    assert!(coloured.contains("\x1b[33mcaution: "), "{coloured}");
    let without =
        coloured.replace("\x1b[33m", "").replace("\x1b[1;31m", "").replace("\x1b[1m", "").replace("\x1b[0m", "");
    assert_eq!(without, plain);
}

/// Output for other programs keeps its lines.
#[test]
fn files_and_tables_on_stdout_are_not_folded() {
    let folder = tempfile::tempdir().unwrap();
    let robot = shown(folder.path(), "cdpr robots cogiro").stdout;
    assert_eq!(robot.parse::<toml::Table>().unwrap()["name"].as_str(), Some("cogiro"));
    assert!(robot.lines().any(|line| line.width() > COLUMNS), "no line of the file is long");
    let schema = shown(folder.path(), "cdpr schema robot");
    assert!(schema.json().get("properties").is_some());
}
