//! Runs cargo and counts what its tests say.

use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::outcome::Outcome;
use crate::programs::output;

/// A cargo command at the workspace root; doc warnings are errors.
pub(crate) fn command(root: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(arguments).current_dir(root).stdin(Stdio::null()).env("RUSTDOCFLAGS", "-D warnings");
    if std::env::var("CI").as_deref() == Ok("true") {
        // what helps to compile again is of no use where everything is compiled once, and takes half of the space
        command.env("CARGO_INCREMENTAL", "0");
        // a fifth of the compiler's time; panics name their line without it
        command.env("CARGO_PROFILE_DEV_DEBUG", "0").env("CARGO_PROFILE_RELEASE_DEBUG", "0");
    }
    command
}

/// Passes when the command exits with 0; its output goes to the terminal.
pub(crate) fn succeed(root: &Path, arguments: &[&str]) -> Outcome {
    println!("$ cargo {}", arguments.join(" "));
    match command(root, arguments).status() {
        Ok(status) if status.success() => Outcome::of(Vec::new()),
        Ok(status) => Outcome::of(vec![format!("`cargo {}` ended with {status}", arguments.join(" "))]),
        Err(error) => Outcome::of(vec![format!("cannot start cargo: {error}")]),
    }
}

/// Runs tests, shows their output as it comes, and counts the tests passed and failed.
pub(crate) fn count_tests(root: &Path, arguments: &[&str]) -> Outcome {
    println!("$ cargo {}", arguments.join(" "));
    let mut child = match command(root, arguments).stdout(Stdio::piped()).spawn() {
        Ok(child) => child,
        Err(error) => return Outcome::of(vec![format!("cannot start cargo: {error}")]),
    };
    let mut outcome = Outcome::default();
    for line in
        child.stdout.take().into_iter().flat_map(|output| BufReader::new(output).split(b'\n')).map_while(Result::ok)
    {
        let line = String::from_utf8_lossy(&line);
        println!("{line}");
        if let Some((passed, failed)) = test_result(&line) {
            outcome.passed += passed;
            outcome.failed += failed;
        }
    }
    let success = child.wait().is_ok_and(|status| status.success());
    if !success && outcome.failed == 0 {
        outcome.failed = 1; // it did not compile, or a test ended the whole process
        outcome.complaints.push(format!("`cargo {}` failed outside its tests", arguments.join(" ")));
    }
    outcome
}

/// A program of tests that cargo has built.
#[derive(Debug, PartialEq)]
pub(crate) struct TestProgram {
    /// Package whose tests it has.
    pub(crate) package: String,
    /// Folder of the package, from which it is started.
    pub(crate) folder: PathBuf,
    /// The program.
    pub(crate) path: PathBuf,
}

/// Builds programs of tests without running them, and tells where they are.
pub(crate) fn test_programs(root: &Path, tests: &[&str]) -> Result<Vec<TestProgram>, String> {
    let arguments = [tests, &["--no-run", "--message-format=json-render-diagnostics"]].concat();
    println!("$ cargo {}", arguments.join(" "));
    let output = command(root, &arguments).stderr(Stdio::inherit()).output();
    let output = output.map_err(|error| format!("cannot start cargo: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout);
    if !output.status.success() {
        return Err(format!("`cargo {}` failed", tests.join(" ")));
    }
    Ok(text.lines().filter_map(|message| test_program(root, message)).collect())
}

/// The program that a message of cargo is about; `None` where it is about something else.
fn test_program(root: &Path, message: &str) -> Option<TestProgram> {
    let field = |name: &str| message.split_once(&format!("\"{name}\":\"")).and_then(|(_, rest)| rest.split_once('"'));
    let (path, (manifest, _)) = (field("executable")?.0, field("manifest_path")?);
    let folder = Path::new(manifest).parent()?;
    let package = folder.file_name()?.to_string_lossy().into_owned();
    Some(TestProgram { package, folder: root.join(folder), path: PathBuf::from(path) })
}

/// Runs a program of tests and counts those that passed and failed; the names of those that failed are shown.
pub(crate) fn run_tests(program: &TestProgram) -> Outcome {
    let name = program.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let output = Command::new(&program.path).arg("--quiet").current_dir(&program.folder).output();
    let output = match output {
        Ok(output) => output,
        Err(error) => return Outcome::of(vec![format!("cannot start {name}: {error}")]),
    };
    let text = String::from_utf8_lossy(&output.stdout);
    let (passed, failed) = text.lines().filter_map(test_result).fold((0, 0), |sum, of| (sum.0 + of.0, sum.1 + of.1));
    println!("{} ({name}): {passed} passed, {failed} failed", program.package);
    if output.status.success() {
        return Outcome { passed, failed, complaints: Vec::new() };
    }
    print!("{text}{}", String::from_utf8_lossy(&output.stderr));
    Outcome { passed, failed: failed.max(1), complaints: vec![format!("tests of {} failed", program.package)] }
}

/// Builds for release what needs no dependency of tests: the command as users get it with its library, the program whose instructions are
/// counted, and the examples. Together with the tests of the library their dependencies would have features that users do not get.
pub(crate) const RELEASE: &[&str] = &[
    "build",
    "--quiet",
    "--release",
    "-p",
    "cdpr-core",
    "-p",
    "cdpr-model",
    "-p",
    "cdpr-workspace",
    "-p",
    "cdpr-plant",
    "-p",
    "cdpr-calibration",
    "-p",
    "cdpr-study",
    "-p",
    "cdpr",
    "-p",
    "cdpr-cli",
    "-p",
    "instructions",
    "-p",
    "examples",
];

/// The tests of the libraries, from inside and from outside, and those of the tasks. Without the wide vectors, which give the
/// same bits (`xtask/instructions/tests`).
pub(crate) const PORTABLE_TESTS: &[&str] = &[
    "test",
    "-p",
    "cdpr-core",
    "-p",
    "cdpr-model",
    "-p",
    "cdpr-workspace",
    "-p",
    "cdpr-plant",
    "-p",
    "cdpr-calibration",
    "-p",
    "cdpr-study",
    "-p",
    "cdpr",
    "-p",
    "xtask",
    "-p",
    "dirty",
    "-p",
    "golden",
    "-p",
    "dist",
    "--lib",
    "--bins",
    "--tests",
    "--no-default-features",
    "--features",
    "cdpr/files,cdpr/parallel,cdpr/error-control,cdpr-core/std",
];

/// Complains of crates that would have the wide vectors in [`PORTABLE_TESTS`]: a feature of one manifest gives them to all, and doubles the
/// time of compiling.
pub(crate) fn portable(root: &Path) -> Outcome {
    let selection: Vec<&str> =
        PORTABLE_TESTS[1..].iter().copied().filter(|word| !["--lib", "--bins", "--tests"].contains(word)).collect();
    let shown = ["tree", "--edges", "normal,dev", "--prefix", "none", "--format", "{p}|{f}"];
    match output(command(root, &[&shown[..], &selection].concat())) {
        Ok(tree) => Outcome::of(with_vectors(&tree)),
        Err(complaint) => Outcome::of(vec![complaint]),
    }
}

/// A complaint for each package in lines `NAME VERSION (PATH)|FEATURES` that has the feature `vectors`.
fn with_vectors(tree: &str) -> Vec<String> {
    let named = tree.lines().filter_map(|line| {
        let (package, features) = line.split_once('|')?;
        let has = features.trim_end_matches(" (*)").split(',').any(|feature| feature == "vectors");
        has.then(|| package.split(' ').next().unwrap_or_default())
    });
    let names: std::collections::BTreeSet<&str> = named.collect();
    let complaint = |name| {
        format!(
            "the portable tests compile {name} with `vectors`: look for who asks for its default features with `cargo tree -e features -i {name}`"
        )
    };
    names.into_iter().map(complaint).collect()
}

/// Builds the command for release and tells where it is.
pub(crate) fn the_command(root: &Path) -> Result<PathBuf, String> {
    succeed(root, RELEASE).into_result()?;
    Ok(built(root, "release", "cdpr"))
}

/// Place of a program that cargo built.
pub(crate) fn built(root: &Path, folder: &str, name: &str) -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), |folder| root.join(folder));
    target.join(folder).join(name).with_extension(std::env::consts::EXE_EXTENSION)
}

/// Builds and runs an example; its output goes to the terminal.
pub(crate) fn run_example(root: &Path, name: &str, arguments: &[&str]) -> Result<(), String> {
    succeed(root, RELEASE).into_result()?;
    let program = built(root, "release", name);
    match Command::new(&program).args(arguments).current_dir(root).stdin(Stdio::null()).status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("{name} ended with {status}")),
        Err(error) => Err(format!("cannot start {}: {error}", program.display())),
    }
}

/// The components that a machine with nothing but rustup may lack.
pub(crate) fn tools(root: &Path) -> Outcome {
    let missing = [("fmt", "rustfmt"), ("clippy", "clippy")].into_iter().filter(|(subcommand, _)| {
        let output = command(root, &[subcommand, "--version"]).stdout(Stdio::null()).stderr(Stdio::null()).status();
        !output.is_ok_and(|status| status.success())
    });
    Outcome::of(
        missing.map(|(_, name)| format!("{name} is not installed: run `rustup component add {name}`")).collect(),
    )
}

/// Counts in a line such as `test result: ok. 12 passed; 0 failed; 1 ignored; …`.
fn test_result(line: &str) -> Option<(usize, usize)> {
    let counts = line.strip_prefix("test result: ")?.split_once(". ")?.1;
    let count = |word: &str| counts.split("; ").find_map(|part| part.strip_suffix(word)?.trim().parse().ok());
    Some((count("passed")?, count("failed")?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_are_read_from_the_closing_line_of_a_test_binary() {
        let line = "test result: FAILED. 12 passed; 3 failed; 1 ignored; 0 measured; 0 filtered out; finished in 0.00s";
        assert_eq!(test_result(line), Some((12, 3)));
        assert_eq!(test_result("test identification::recovers_offsets ... ok"), None);
    }

    #[test]
    fn packages_with_vectors_are_named_once() {
        let tree = "cdpr-core v0.1.0 (/here/cdpr-core)|default,std\ncdpr-model v0.1.0 (/here)|files,vectors\n\n\
                    cdpr-model v0.1.0 (/here)|files,vectors (*)\npulp v0.22.3|std,x86-v4\n";
        let found = with_vectors(tree);
        assert_eq!((found.len(), found[0].contains("compile cdpr-model with")), (1, true), "{found:?}");
    }
}
