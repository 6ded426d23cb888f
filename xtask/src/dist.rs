//! The command for people without a compiler: an archive, packed by the program `dist`, and a wheel, made by maturin; installed as users do.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::outcome::Outcome;
use crate::programs::{on_path, output, run};
use crate::{cargo, environments, python, readme};

/// Starts the program that packs and checks.
const PROGRAM: &[&str] = &["run", "--quiet", "--locked", "-p", "dist", "--"];

/// Packs the build for release into `dist/`, and builds it before if it is not there: archive, wheel, source distribution, checksums. With
/// `ziglang` the wheel is for older systems, too.
pub(crate) fn pack(root: &Path, with_zig: bool) -> Result<(), String> {
    let folder = root.join("dist");
    // packages of an earlier version would be taken for those of this one
    let _ = std::fs::remove_dir_all(&folder);
    cargo::succeed(root, &["build", "--release", "--locked", "-p", "cdpr-cli"]).into_result()?;
    start(root, &["pack", &path(&cargo::built(root, "release", "cdpr")), &path(&folder)]).into_result()?;
    let words: &[&str] = if with_zig { &["--zig", "--compatibility", "manylinux_2_17"] } else { &[] };
    if with_zig {
        python::fetch_zig(root)?;
    }
    python::wheel(root, &folder, words)?;
    python::sources(root, &folder)?;
    let made = [python::the_wheel(&folder)?, packed(&folder, &format!("cdpr-{}.tar.gz", env!("CARGO_PKG_VERSION")))?];
    python::check_packages(root, &made)?;
    start(root, &["sums", &path(&folder)]).into_result()
}

/// Complains of what a publication of the crates would stumble over.
pub(crate) fn manifests(root: &Path) -> Outcome {
    start(root, &["manifests"])
}

/// Complains of packages under licences that deny.toml does not allow.
pub(crate) fn licences(root: &Path) -> Outcome {
    start(root, &["licences"])
}

/// Does all of a publication but the upload: every crate is packed and compiled from its package.
pub(crate) fn publish_check(root: &Path) -> Result<(), String> {
    manifests(root).into_result()?;
    cargo::succeed(root, &["publish", "--workspace", "--dry-run", "--locked"]).into_result()
}

/// Packs the build for release under target/, reads the packages back, runs the command out of both, and then all
/// commands of README.md.
pub(crate) fn check(root: &Path) -> Outcome {
    let folder = root.join("target/dist");
    // packages of an earlier version would be taken for those of this one
    let _ = std::fs::remove_dir_all(&folder);
    let packages = folder.join("dist");
    let (mut sum, python) = std::thread::scope(|scope| {
        let python = scope.spawn(|| environments::new(&folder.join("venv")));
        let packed = cargo::the_command(root).map(|command| start(root, &["check", &path(&command), &path(&packages)]));
        (packed.unwrap_or_else(|complaint| Outcome::of(vec![complaint])), python.join().unwrap_or_default())
    });
    if let Err(complaint) = python::wheel(root, &packages, &[]).and_then(|()| {
        python::check_packages(root, &[python::the_wheel(&packages)?])?;
        start(root, &["sums", &path(&packages)]).into_result()
    }) {
        sum.add(Outcome::of(vec![complaint]));
    }
    if sum.failed > 0 {
        return sum;
    }
    for installed in [by_tar(&folder, &packages), by_pip(&folder, &packages, python.as_deref())] {
        sum.add(installed.unwrap_or_else(|complaint| Outcome::of(vec![complaint])));
    }
    if let Some(python) = &python {
        // what the wheel depends on; the command alone did without
        sum.add(Outcome::of(environments::pip(python, &[python::NUMPY]).err().into_iter().collect()));
    }
    sum.add(readme::check(root, &folder, python.as_deref()));
    sum
}

fn start(root: &Path, words: &[&str]) -> Outcome {
    cargo::succeed(root, &[PROGRAM, words].concat())
}

/// The archive as the program tar of the system unpacks it.
fn by_tar(folder: &Path, packages: &Path) -> Result<Outcome, String> {
    let Some(tar) = on_path("tar") else {
        println!("the archive is not unpacked by another program: there is no tar");
        return Ok(Outcome::default());
    };
    let archive = packed(packages, ".tar.gz")?;
    run(within(tar, folder, &["-xzf", &path(&archive)]))?;
    let name = archive.file_name().unwrap_or_default().to_string_lossy().replace(".tar.gz", "");
    works(&folder.join(name).join("cdpr"), folder)
}

/// The wheel as pip puts it into an environment, without network.
fn by_pip(folder: &Path, packages: &Path, python: Option<&Path>) -> Result<Outcome, String> {
    let Some(python) = python else {
        let reason = "there is no Python 3 with its modules venv and pip";
        println!("the wheel is not installed: {reason}");
        let is_broken = std::env::var("CI").as_deref() == Ok("true") && on_path("python3").is_some();
        return if is_broken { Err(format!("CI must install the wheel: {reason}")) } else { Ok(Outcome::default()) };
    };
    let wheel = path(&packed(packages, ".whl")?);
    let words = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-index", "--no-deps", &wheel];
    run(within(python, folder, &words))?;
    works(&python.with_file_name("cdpr"), folder)
}

/// Runs the command: it must print its version and write its demo.
fn works(command: &Path, folder: &Path) -> Result<Outcome, String> {
    let version = output(within(command, folder, &["--version"]))?;
    if version.trim() != concat!("cdpr ", env!("CARGO_PKG_VERSION")) {
        return Err(format!("{} says that it is `{}`", command.display(), version.trim()));
    }
    let result = folder.join("demo");
    // of the package before
    let _ = std::fs::remove_dir_all(&result);
    output(within(command, folder, &["demo", "--out", &path(&result)]))?;
    let page = result.join("report.html");
    let is_there = page.is_file();
    println!("{}: version and demo", command.display());
    if is_there { Ok(Outcome::of(Vec::new())) } else { Err(format!("`cdpr demo` wrote no {}", page.display())) }
}

/// The one package with this ending.
fn packed(folder: &Path, ending: &str) -> Result<PathBuf, String> {
    let entries = std::fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let mut paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let package = paths.find(|path| path.to_string_lossy().ends_with(ending));
    package.ok_or_else(|| format!("{} has no package *{ending}", folder.display()))
}

fn within(program: impl AsRef<std::ffi::OsStr>, folder: &Path, words: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(words).current_dir(folder).stdin(Stdio::null());
    command
}

fn path(path: &Path) -> String {
    path.display().to_string()
}
