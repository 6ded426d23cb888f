//! The Python package: its wheel, made by maturin of what was built for release, and its tests from that wheel.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::outcome::Outcome;
use crate::programs::{can_install, install, on_path, run};
use crate::{cargo, environments};

/// Checks of types: of the package, and of the compiled part against what is said of it.
const TYPES: [&[&str]; 2] =
    [&["-m", "mypy", "src/cdpr"], &["-m", "mypy.stubtest", "cdpr._cdpr", "--mypy-config-file", "pyproject.toml"]];

/// The one package that the package needs.
pub(crate) const NUMPY: &str = "numpy>=1.23";

/// Sees to it that the package's Python is there.
pub(crate) fn fetch(root: &Path) -> Result<(), String> {
    environment(root).map(|_| ())
}

/// Python with what the package and its tests need.
fn environment(root: &Path) -> Result<PathBuf, String> {
    environments::with_packages(root, "python/requirements.txt", "target/python-venv")
}

/// Builds the wheel into a folder, with the profile and the folder of the build for release, and further words for maturin.
pub(crate) fn wheel(root: &Path, folder: &Path, words: &[&str]) -> Result<(), String> {
    let python = environment(root)?;
    let mut maturin = Command::new(&python);
    maturin.args(["-m", "maturin", "build", "--quiet", "--release", "--locked", "--out"]).arg(folder).args(words);
    // the module ziglang of this Python is asked for where there is no zig on the path
    maturin.env("CARGO_ZIGBUILD_PYTHON_PATH", &python);
    run(as_cargo(root, maturin))
}

/// Writes the source distribution into a folder.
pub(crate) fn sources(root: &Path, folder: &Path) -> Result<(), String> {
    let mut maturin = Command::new(environment(root)?);
    maturin.args(["-m", "maturin", "sdist", "--out"]).arg(folder);
    run(as_cargo(root, maturin))
}

/// Sees to it that wheels can be made for older systems.
pub(crate) fn fetch_zig(root: &Path) -> Result<(), String> {
    environments::pip(&environment(root)?, &["ziglang"])
}

/// Checks the packages in a folder as PyPI does.
pub(crate) fn check_packages(root: &Path, packages: &[PathBuf]) -> Result<(), String> {
    let mut twine = Command::new(environment(root)?);
    twine.args(["-m", "twine", "check", "--strict"]).args(packages).stdout(Stdio::null());
    run(twine)
}

/// The command with the folder, and the surroundings that cargo has in other steps: what it compiled there is not compiled again.
fn as_cargo(root: &Path, mut command: Command) -> Command {
    command.current_dir(root.join("python")).stdin(Stdio::null()).env("CARGO_TARGET_DIR", root.join("target"));
    for (name, value) in cargo::command(root, &[]).get_envs() {
        if let Some(value) = value {
            command.env(name, value);
        }
    }
    command
}

/// Types, and the tests that take little time, from the wheel.
pub(crate) fn check(root: &Path) -> Outcome {
    checked(root, false)
}

/// The same with what takes more time or programs that not every machine has: all notebooks, recipes of schedulers, benches.
pub(crate) fn check_all(root: &Path) -> Outcome {
    checked(root, true)
}

fn checked(root: &Path, is_all: bool) -> Outcome {
    let python = match environment(root) {
        Ok(python) => python,
        Err(reason) => return skipped(&reason),
    };
    let folder = root.join("target/wheel");
    // wheels of an earlier version would be installed, too
    let _ = std::fs::remove_dir_all(&folder);
    let installed = wheel(root, &folder, &[]).and_then(|()| {
        let wheel = the_wheel(&folder)?;
        environments::pip(&python, &["--force-reinstall", "--no-deps", &wheel.display().to_string()])?;
        readme(root, &wheel)
    });
    if let Err(complaint) = installed {
        return Outcome::of(vec![complaint]);
    }
    if is_all && let Err(complaint) = fetch_recipes(&python) {
        return Outcome::of(vec![complaint]);
    }
    let mut sum = Outcome::of(Vec::new());
    for words in TYPES {
        let mut command = Command::new(&python);
        command.current_dir(root.join("python")).args(words);
        sum.add(Outcome::of(run(command).err().into_iter().collect()));
    }
    sum.add(tests(root, &python, is_all));
    if is_all {
        sum.add(Outcome::of(times(root, &python).err().into_iter().collect()));
    }
    sum
}

/// Sees to it that the programs of the book's recipes are there, where they can be installed; a recipe without its program is skipped aloud.
fn fetch_recipes(python: &Path) -> Result<(), String> {
    environments::pip(python, &["joblib", "dask-jobqueue", "snakemake"])?;
    if on_path("sbatch").is_none() && can_install() {
        install(&["parallel", "munge", "slurm-wlm"])?;
    }
    Ok(())
}

/// Tells the times of the package beside those of Rust, numba and numpy; none is judged.
fn times(root: &Path, python: &Path) -> Result<(), String> {
    cargo::succeed(root, &["build", "--quiet", "--release", "-p", "examples", "--bin", "row_times"]).into_result()?;
    environments::pip(python, &["numba"])?;
    let mut times = Command::new(python);
    times.arg("benches/times.py").arg(cargo::built(root, "release", "row_times")).arg(root.join("studies"));
    times.current_dir(root.join("python")).env("RAYON_NUM_THREADS", "1").stdin(Stdio::null());
    run(times)
}

/// The one wheel of a folder.
pub(crate) fn the_wheel(folder: &Path) -> Result<PathBuf, String> {
    let entries = std::fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut wheels =
        entries.flatten().map(|entry| entry.path()).filter(|path| path.extension().is_some_and(|end| end == "whl"));
    wheels.next().ok_or_else(|| format!("{} has no wheel", folder.display()))
}

/// Runs the lines of Python in README.md from the wheel in an environment with nothing else, where numpy comes as its dependency.
fn readme(root: &Path, wheel: &Path) -> Result<(), String> {
    let text = std::fs::read_to_string(root.join("README.md")).map_err(|error| format!("README.md: {error}"))?;
    let blocks: Vec<&str> = text.split("```python\n").skip(1).filter_map(|rest| rest.split("```").next()).collect();
    if blocks.is_empty() {
        return Err("README.md has no lines of Python".to_owned());
    }
    let folder = root.join("target/readme-venv");
    let python = environments::new(&folder).ok_or("there is no Python 3 with its module venv")?;
    environments::pip(&python, &[&wheel.display().to_string()])?;
    let mut lines = Command::new(&python);
    lines.args(["-W", "error", "-c", &blocks.concat()]).current_dir(&folder).stdin(Stdio::null());
    run(lines)?;
    let mut command = Command::new(folder.join("bin/cdpr"));
    command.arg("--version").stdin(Stdio::null());
    run(command)
}

/// Runs the tests of the package and counts them.
fn tests(root: &Path, python: &Path, is_all: bool) -> Outcome {
    let mut command = Command::new(python);
    command.args(["-B", "-W", "ignore", "-m", "unittest", "discover", "--start-directory", "tests", "--verbose"]);
    command.current_dir(root.join("python")).stdin(Stdio::null());
    command.env("CDPR", cargo::built(root, "release", "cdpr")).env("MPLBACKEND", "Agg");
    if is_all {
        command.env("CDPR_ALL", "1");
    }
    let output = match command.output() {
        Ok(output) => output,
        Err(error) => return Outcome::of(vec![format!("cannot start {command:?}: {error}")]),
    };
    let text = String::from_utf8_lossy(&output.stderr);
    let (passed, failed) = counts(&text);
    let skipped = text.lines().filter(|line| line.contains(" ... skipped "));
    skipped.for_each(|line| println!("{line}"));
    println!("python: {passed} passed, {failed} failed");
    if output.status.success() && failed == 0 && passed > 0 {
        return Outcome { passed, failed, complaints: Vec::new() };
    }
    println!("{text}");
    Outcome { passed, failed: failed.max(1), complaints: vec!["tests of the Python package failed".to_owned()] }
}

/// Tests passed and failed, by the lines that unittest writes of each.
fn counts(text: &str) -> (usize, usize) {
    let count = |end: &str| text.lines().filter(|line| line.trim_end().ends_with(end)).count();
    (count("... ok"), count("... FAIL") + count("... ERROR"))
}

/// Nobody was asked: a failure in CI, where somebody relies on it.
fn skipped(reason: &str) -> Outcome {
    println!("the Python package is not tested: {reason}");
    if std::env::var("CI").as_deref() == Ok("true") {
        return Outcome::of(vec![format!("CI must test the Python package: {reason}")]);
    }
    Outcome::default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tests_are_counted_by_their_lines() {
        let text = "test_a (m.T) ... ok\ntest_b (m.T) ... FAIL\ntest_c (m.T) ... skipped 'no sbatch'\ntest_d (m.T)\nWords. ... ok\n";
        assert_eq!(counts(text), (2, 1));
    }
}
