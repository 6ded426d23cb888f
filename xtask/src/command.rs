//! The tests of what users get: of the command, and of the library as it is compiled into it; and forty spoilt records that the command has
//! to notice.

use std::path::Path;
use std::process::Stdio;

use crate::outcome::Outcome;
use crate::{cargo, dirty};

/// Builds the command as users do, runs its tests for release, and complains if they ran another program: one whose dependencies have
/// features that only tests ask for.
pub(crate) fn check(root: &Path) -> Outcome {
    let command = match cargo::the_command(root) {
        Ok(command) => command,
        Err(complaint) => return Outcome::of(vec![complaint]),
    };
    let users_program = match read(&command) {
        Ok(program) => program,
        Err(complaint) => return Outcome::of(vec![complaint]),
    };
    let mut outcome = Outcome::default();
    for tests in TESTS {
        outcome.add(cargo::count_tests(root, &[tests, &["--no-fail-fast"]].concat()));
    }
    let same = match read(&cargo::built(root, "release", "cdpr")) {
        Ok(tested) if tested == users_program => Outcome::of(Vec::new()),
        Ok(_) => Outcome::of(vec![ANOTHER.to_owned()]),
        Err(complaint) => Outcome::of(vec![complaint]),
    };
    outcome.add(same);
    outcome.add(dirty::check_fixed(root, &command));
    outcome
}

/// Those that link the program and the library of users, and the command's unit tests, which link that library too: compiled with little
/// optimisation themselves, in half of the time.
const TESTS: [&[&str]; 2] = [
    &["test", "--release", "-p", "cdpr-cli", "-p", "instructions", "--test", "*"],
    &["test", "--release", "-p", "cdpr-cli", "-p", "cdpr-reports", "--lib", "--config", UNOPTIMISED],
];

const UNOPTIMISED: &str = "profile.release.package.cdpr-cli.opt-level=0";

/// Compiles what [`check`] runs, without a word: where that fails, `check` says why.
pub(crate) fn build(root: &Path) {
    let tests = TESTS.map(|tests| [tests, &["--no-run"]].concat());
    for arguments in [cargo::RELEASE].into_iter().chain(tests.iter().map(Vec::as_slice)) {
        let mut command = cargo::command(root, arguments);
        let _ = command.stdout(Stdio::null()).stderr(Stdio::null()).status();
    }
}

const ANOTHER: &str = "the tests ran a `cdpr` whose dependencies have other features than users get: compare \
                       `cargo tree -p cdpr-cli -e normal,features` with `-e normal,dev,features`";

fn read(path: &Path) -> Result<Vec<u8>, String> {
    std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()))
}
