//! Files that the product itself writes: kept in the repository for editors, compared in every test run.

use std::path::Path;
use std::process::Command;

use crate::outcome::Outcome;
use crate::{cargo, dist, notices};

/// A file and the `cdpr` command whose standard output it is.
struct Generated {
    path: &'static str,
    command: &'static [&'static str],
}

const FILES: &[Generated] = &[
    Generated { path: ANSWER_SCHEMA, command: &["schema", "answers"] },
    Generated { path: COMMANDS, command: &["schema", "command-line"] },
    Generated { path: "schemas/measurement.schema.json", command: &["schema", "measurement"] },
    Generated { path: SCHEMA, command: &["schema", "page"] },
    Generated { path: "schemas/robot.schema.json", command: &["schema", "robot"] },
    Generated { path: "schemas/scenario.schema.json", command: &["schema", "scenario"] },
    Generated { path: "schemas/study.schema.json", command: &["schema", "study"] },
    Generated { path: "schemas/sweep.schema.json", command: &["schema", "sweep"] },
];

/// Types in another language, and the words after `page-types` that make them of a committed schema.
struct Types {
    path: &'static str,
    words: &'static [&'static str],
}

/// Types of the data that pages draw from, for `viewer/`, and answers and questions, for `python/`.
const TYPES: &[Types] = &[
    Types { path: "viewer/src/data.ts", words: &[SCHEMA] },
    Types { path: "python/src/cdpr/_answers.py", words: &["--python", ANSWER_SCHEMA] },
    Types { path: "python/src/cdpr/_questions.py", words: &["--functions", COMMANDS] },
];
const SCHEMA: &str = "schemas/page.schema.json";
const COMMANDS: &str = "schemas/command-line.json";
const ANSWER_SCHEMA: &str = "schemas/answers.schema.json";

/// Complains of every file that differs from what the program writes now.
pub(crate) fn check(root: &Path) -> Outcome {
    let program = match cargo::the_command(root) {
        Ok(program) => program,
        Err(message) => return Outcome::of(vec![message]),
    };
    let complaints = FILES.iter().filter_map(|file| {
        let expected = match output(root, &program, file) {
            Ok(expected) => expected,
            Err(message) => return Some(message),
        };
        stale(root, file.path, &expected)
    });
    let types = TYPES.iter().filter_map(|of| match types(root, of) {
        Ok(types) => stale(root, of.path, &types),
        Err(message) => Some(message),
    });
    let mut outcome = Outcome::of(complaints.chain(types).chain(notices::check(root)).collect());
    outcome.add(dist::licences(root));
    outcome
}

/// Writes every file.
pub(crate) fn write(root: &Path) -> Result<(), String> {
    let program = cargo::the_command(root)?;
    for file in FILES {
        put(root, file.path, &output(root, &program, file)?)?;
    }
    for of in TYPES {
        put(root, of.path, &types(root, of)?)?;
    }
    notices::write(root)
}

/// Complaint of a file that is not what it should be.
fn stale(root: &Path, path: &str, expected: &[u8]) -> Option<String> {
    match std::fs::read(root.join(path)) {
        Ok(found) if found == expected => None,
        Ok(_) => Some(format!("{path} is out of date")),
        Err(error) => Some(format!("{path}: {error}")),
    }
}

fn put(root: &Path, name: &str, content: &[u8]) -> Result<(), String> {
    let path = root.join(name);
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    }
    std::fs::write(&path, content).map_err(|error| format!("{}: {error}", path.display()))?;
    println!("wrote {name}");
    Ok(())
}

/// Types of the committed schema.
fn types(root: &Path, of: &Types) -> Result<Vec<u8>, String> {
    let words = [&["run", "--quiet", "-p", "page-types", "--"], of.words].concat();
    let output = cargo::command(root, &words).output();
    let output = output.map_err(|error| format!("cannot start cargo: {error}"))?;
    match output.status.success() {
        true => Ok(output.stdout),
        false => Err(format!("{}: {}", of.path, String::from_utf8_lossy(&output.stderr).trim())),
    }
}

fn output(root: &Path, program: &Path, file: &Generated) -> Result<Vec<u8>, String> {
    let output = Command::new(program).args(file.command).current_dir(root).output();
    let output = output.map_err(|error| format!("cannot start {}: {error}", program.display()))?;
    if output.status.success() {
        Ok(output.stdout)
    } else {
        let reason = String::from_utf8_lossy(&output.stderr);
        Err(format!("{}: `cdpr {}` failed: {}", file.path, file.command.join(" "), reason.trim()))
    }
}
