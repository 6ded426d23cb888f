//! The `cdpr` command as scripts see it: exit codes, JSON keys, messages.

#![expect(clippy::unwrap_used, reason = "a test that cannot go on fails")]

mod advise;
mod answer_schema;
mod bad_input;
mod book;
mod capability;
mod command_line;
mod compensation;
mod course;
mod criteria;
mod dissertation;
mod dissertation_sweeps;
mod effects;
mod elastic_models;
mod envelope;
mod equilibrium;
mod error_tables;
mod explanations;
mod export;
mod faults;
mod force_tracking;
mod frames;
mod frequency_response;
mod friction;
mod hanging_robots;
mod import;
mod in_memory;
mod initial_tension;
#[cfg(unix)]
mod interruption;
mod kinematics;
mod machine_verdicts;
mod map_edges;
mod measurements;
mod mistaken_inputs;
mod newcomer;
mod objectives;
mod other_kinds;
mod parted_commands;
mod partial_poses;
mod penalties;
mod planning;
mod rating;
mod reachable;
mod running;
mod scaling;
mod selection;
mod self_calibration;
mod sensitivity;
mod shells;
mod starting;
mod statics;
mod studies;
mod study_page;
mod sweeps;
mod tension;
mod test_bench;
mod undetermined_tensions;
mod verdicts;
mod width;
mod winches;
mod workspace;
mod workspace_page;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

use assert_cmd::Command;
use serde_json::Value;

/// What a run of `cdpr` left behind.
struct Run {
    arguments: Vec<String>,
    exit_code: i32,
    stdout: String,
    stderr: String,
}

/// Runs `cdpr` with arguments separated by spaces.
fn cdpr(arguments: &str) -> Run {
    let arguments: Vec<String> = arguments.split_whitespace().map(str::to_owned).collect();
    let words = std::iter::once("cdpr".to_owned()).chain(arguments.iter().cloned());
    let (mut stdout, mut stderr) = (Vec::new(), Vec::new());
    let exit = cdpr_cli::run(words.map(Into::into), &mut stdout, &mut stderr);
    let exit_code = (0..=u8::MAX).find(|&code| ExitCode::from(code) == exit).unwrap().into();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    Run { arguments, exit_code, stdout: text(stdout), stderr: text(stderr) }
}

/// Folder of the repository.
fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

/// As [`cdpr`], in a folder.
fn cdpr_in(folder: &Path, arguments: &str) -> Run {
    run(Command::cargo_bin("cdpr").unwrap().current_dir(folder).args(arguments.split_whitespace()))
}

fn run(command: &mut Command) -> Run {
    let arguments = command.get_args().map(|word| word.to_string_lossy().into_owned()).collect();
    let output = command.output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    let exit_code = output.status.code().unwrap();
    Run { arguments, exit_code, stdout: text(&output.stdout), stderr: text(&output.stderr) }
}

impl Run {
    /// Sentences on stdout, each in one line however they are folded.
    fn prose(&self) -> String {
        self.stdout.split_whitespace().collect::<Vec<_>>().join(" ")
    }

    /// Returns the one JSON object on stdout, after checking it against the schema of answers.
    fn json(&self) -> Value {
        let value: Value =
            serde_json::from_str(&self.stdout).unwrap_or_else(|error| panic!("{error}: {}", self.stdout));
        assert!(value.is_object(), "{value}");
        answer_schema::assert_fits(&self.arguments, &value);
        value
    }

    /// Asserts that the keys are there.
    fn json_with(&self, keys: &[&str]) -> Value {
        let value = self.json();
        keys.iter().for_each(|key| assert!(value.get(key).is_some(), "`{key}` is missing in {value}"));
        value
    }
}

/// The numbers of a JSON list.
fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

/// Numbers as an option takes them.
fn listed(numbers: &[f64]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(",")
}

/// A file in a fresh folder; both go when the folder is dropped.
fn file_with(name: &str, content: &[u8]) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, content).unwrap();
    (folder, path)
}

/// A square 2T robot with four cables: anchors at the corners of 10 m × 8 m.
const SQUARE: &str = r#"layout_version = 1
name = "square"
motion_pattern = "2T"
axes = "xz"

[home_pose]
position_m = [5.0, 4.0]

[[cable]]
name = "a"
frame_anchor_m = [0.0, 0.0]
platform_anchor_m = [0.0, 0.0]
tension_min_N = 10.0
tension_max_N = 100.0

[[cable]]
name = "b"
frame_anchor_m = [10.0, 0.0]
platform_anchor_m = [0.0, 0.0]

[[cable]]
name = "c"
frame_anchor_m = [10.0, 8.0]
platform_anchor_m = [0.0, 0.0]

[[cable]]
name = "d"
frame_anchor_m = [0.0, 8.0]
platform_anchor_m = [0.0, 0.0]
"#;
