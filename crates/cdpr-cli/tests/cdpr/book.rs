//! The book is true: its commands run, and every key that a reader knows stands in its chapter.

use std::collections::BTreeSet;
use std::path::Path;

use serde_json::Value;

use super::{cdpr, cdpr_in};

fn chapter(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/book/src").join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// All chapters, by their names.
pub(super) fn chapters() -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/book/src");
    let mut names: Vec<String> =
        std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.retain(|name| name.ends_with(".md"));
    names.sort_unstable();
    names.iter().map(|name| chapter(name)).collect()
}

/// Names of all properties of a JSON Schema, nested ones too.
fn keys(schema: &Value, found: &mut BTreeSet<String>) {
    match schema {
        Value::Object(object) => {
            if let Some(Value::Object(properties)) = object.get("properties") {
                found.extend(properties.keys().cloned());
            }
            object.values().for_each(|value| keys(value, found));
        }
        Value::Array(list) => list.iter().for_each(|value| keys(value, found)),
        _ => {}
    }
}

#[test]
fn every_key_that_a_reader_knows_stands_in_its_chapter() {
    for (format, name) in [
        ("robot", "robot-files.md"),
        ("study", "simulate.md"),
        ("sweep", "reachable.md"),
        ("measurement", "measurements.md"),
    ] {
        let text = chapter(name);
        // a key stands alone: `name` must not be found in `file_name`
        let words: BTreeSet<&str> =
            text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).filter(|word| !word.is_empty()).collect();
        let mut known = BTreeSet::new();
        keys(&cdpr(&format!("schema {format}")).json(), &mut known);
        assert!(known.len() > 8, "{format}: {known:?}");
        let missing: Vec<&String> = known.iter().filter(|key| !words.contains(key.as_str())).collect();
        assert!(missing.is_empty(), "{name} lacks keys of the schema of {format}: {missing:?}");
    }
}

/// The tables of effects and of keys are those of the list of laws, and the help of `--model` names each.
#[test]
fn every_law_of_stretch_stands_in_the_tables_of_the_book_and_in_the_help() {
    let (effects, keys) = (chapter("effects.md"), chapter("robot-files.md"));
    // without the breaks of lines
    let [help, free] = ["ik --help", "identify --help"]
        .map(|command| cdpr(command).stdout.split_whitespace().collect::<Vec<_>>().join(" "));
    for law in cdpr_model::robot::LAWS {
        let is_row = |line: &&str| line.starts_with('|') && line.contains(&format!("| `{}` |", law.word));
        let row = effects.lines().find(is_row).unwrap_or_else(|| panic!("effects.md has no row of `{}`", law.word));
        assert!(row.contains(law.keys[0]), "{row}");
        assert!(law.keys.iter().all(|key| keys.contains(key)), "robot-files.md lacks a key of `{}`", law.word);
        assert!(help.contains(law.word) && help.contains(law.summary), "{}: {help}", law.word);
        assert!(law.numbers.iter().all(|number| free.contains(number.name)), "{}: {free}", law.word);
    }
}

/// The lines `$ cdpr …` of console blocks, continued lines joined.
pub(super) fn commands(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let joined = text.replace("\\\n", " ");
    let mut in_console = false;
    for line in joined.lines().map(str::trim) {
        match line.strip_prefix("```") {
            Some(language) => in_console = language == "console",
            None if in_console => {
                found.extend(line.strip_prefix("$ ").filter(|command| command.starts_with("cdpr ")).map(str::to_owned));
            }
            None => {}
        }
    }
    found
}

/// A reader who copies them in order has done everything with a robot and measurements of their own.
#[test]
fn the_commands_of_getting_started_run_in_their_order() {
    let commands = commands(&chapter("getting-started.md"));
    assert!(commands.len() >= 8, "{commands:?}");
    let folder = tempfile::tempdir().unwrap();
    let study = "[control]\nrobot = \"planar-example\"\n[machine]\nrobot = \"planar-example-calibrated\"\nmodel = \"elastic\"\n\
                 [initial]\npose = [0, 5.2]\ntension_method = \"closed-form\"\n[poses.grid]\nmin = [-2, 4]\nmax = [2, 6]\n\
                 count = [5, 5]\n[noise]\nposition_m = 0.001\nlength_m = 0.0005\n";
    std::fs::write(folder.path().join("study.toml"), study).unwrap();
    let simulated = cdpr_in(folder.path(), "simulate study.toml --out measurements.csv");
    assert_eq!(simulated.exit_code, 0, "{}", simulated.stderr);
    for command in commands {
        let (arguments, file) = command.split_once(" > ").unwrap_or((&command, ""));
        let run = cdpr_in(folder.path(), arguments.strip_prefix("cdpr ").unwrap());
        assert_eq!(run.exit_code, 0, "{command}: {}{}", run.stdout, run.stderr);
        if !file.is_empty() {
            std::fs::write(folder.path().join(file), run.stdout).unwrap();
        }
    }
    assert!(folder.path().join("result/report.html").is_file());
    let written: BTreeSet<String> = std::fs::read_dir(folder.path().join("result"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    let text = chapter("getting-started.md");
    let untold: Vec<&String> = written.iter().filter(|name| !text.contains(&format!("`{name}`"))).collect();
    assert!(
        untold.is_empty() || untold == ["calibrated"],
        "files of a result that the chapter does not tell: {untold:?}"
    );
}

/// Files that a chapter writes out: blocks of TOML that begin with a comment of their name.
fn written_out(text: &str) -> Vec<(&str, &str)> {
    let blocks = text.split("```toml\n# ").skip(1).map(|rest| rest.split("\n```").next().unwrap());
    let named = blocks.filter_map(|block| Some((block.split_once(": ")?.0, block)));
    named.filter(|(name, _)| name.ends_with(".toml")).collect()
}

/// Somebody who starts in an empty folder, copies the files and runs the commands has the lines that the chapter shows, and the exit
/// code that it says: 1 where an answer is not to be trusted.
#[test]
fn the_camera_of_ones_own_is_built_as_its_chapter_says() {
    let text = chapter("tutorial.md");
    let folder = tempfile::tempdir().unwrap();
    let files = written_out(&text);
    assert_eq!(files.len(), 5, "{:?}", files.iter().map(|(name, _)| name).collect::<Vec<_>>());
    for (name, block) in files {
        std::fs::write(folder.path().join(name), format!("# {block}\n")).unwrap();
    }
    let joined = text.replace("\\\n", " ");
    let blocks: Vec<&str> =
        joined.split("```console\n").skip(1).map(|rest| rest.split("```").next().unwrap()).collect();
    assert!(blocks.len() >= 13, "{blocks:?}");
    for block in blocks {
        let (command, shown) = block.split_once('\n').unwrap();
        let run = cdpr_in(folder.path(), command.strip_prefix("$ cdpr ").unwrap());
        let is_denied = shown.contains("not to be trusted");
        assert_eq!(run.exit_code, i32::from(is_denied), "{command}: {}{}", run.stdout, run.stderr);
        for line in shown.lines() {
            assert!(run.stdout.lines().any(|told| told == line), "{command}: `{line}` is not in {}", run.stdout);
        }
    }
    // what the chapter finds is what the machine has
    let robot = |name: &str| {
        let text = std::fs::read_to_string(folder.path().join(name)).unwrap();
        cdpr_model::robot::Robot::from_toml(&text, name).unwrap()
    };
    let (found, machine) = (robot("calibrated.toml"), robot("machine.toml"));
    for (found, machine) in found.cables.iter().zip(&machine.cables) {
        assert!((found.frame_anchor - machine.frame_anchor).norm() < 0.015, "{}", found.name);
    }
}
