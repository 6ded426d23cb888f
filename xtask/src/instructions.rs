//! Counts instructions of the library's work under callgrind and compares them with the committed counts.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::cargo;
use crate::instruction_counts::{Counts, Reference};
use crate::outcome::Outcome;
use crate::programs::{can_install, install, on_path, output};

/// The committed counts.
const REFERENCE: &str = "xtask/instructions/counts.toml";

/// The function of the program that holds the work, as callgrind names it.
const COUNTED: &str = "instructions::counted";

/// A run of the counted program.
struct Run {
    arguments: &'static [&'static str],
    /// Whether a valgrind may stumble over it: the one of Debian 12 does not know every AVX2 instruction that compilers choose.
    may_be_unknown: bool,
}

/// On the vectors that every machine of the target has, and on the widest that valgrind has. The first may not fail.
const RUNS: [Run; 2] =
    [Run { arguments: &["--portable"], may_be_unknown: false }, Run { arguments: &[], may_be_unknown: true }];

/// Complains of work that takes noticeably more instructions than the committed counts say.
pub(crate) fn check(root: &Path) -> Outcome {
    if let Err(reason) = fetch() {
        return skipped(&reason);
    }
    let reference = std::fs::read_to_string(root.join(REFERENCE)).map_err(|error| format!("{REFERENCE}: {error}"));
    match reference.and_then(|text| Ok((Reference::from_toml(&text)?, counts(root)?))) {
        Ok((reference, now)) => {
            let common = now.units.iter().any(|counts| reference.unit(&counts.unit).is_some());
            if common {
                reference.compare(&now)
            } else {
                skipped(&format!("{REFERENCE} has no counts of this machine"))
            }
        }
        Err(complaint) => Outcome::of(vec![complaint]),
    }
}

/// Makes the counts of now the committed ones.
pub(crate) fn accept(root: &Path) -> Result<(), String> {
    fetch()?;
    let counts = counts(root)?;
    std::fs::write(root.join(REFERENCE), counts.to_toml()).map_err(|error| format!("{REFERENCE}: {error}"))?;
    println!("wrote {REFERENCE}");
    Ok(())
}

/// Nothing was counted: a failure in CI, where somebody relies on it.
fn skipped(reason: &str) -> Outcome {
    println!("instructions are not counted: {reason}");
    if std::env::var("CI").as_deref() == Ok("true") {
        return Outcome::of(vec![format!("CI must not skip counting instructions: {reason}")]);
    }
    Outcome::default()
}

/// Sees to it that there is a valgrind.
pub(crate) fn fetch() -> Result<(), String> {
    if on_path("valgrind").is_some() {
        return Ok(());
    }
    if !can_install() {
        return Err("there is no valgrind".to_owned());
    }
    install(&["valgrind"])
}

/// Counts of every unit that this valgrind understands.
fn counts(root: &Path) -> Result<Reference, String> {
    let mut rustc = Command::new("rustc");
    rustc.arg("--version").current_dir(root);
    let mut now = Reference { compiler: output(rustc)?.trim().to_owned(), units: Vec::new() };
    let program = program(root)?;
    for run in &RUNS {
        match count(root, &program, run.arguments) {
            Ok(counts) if !run.may_be_unknown && counts.unit != "Portable" => {
                return Err(format!("`instructions {}` ran on {}", run.arguments.join(" "), counts.unit));
            }
            // where the machine has no wider vectors both count the same
            Ok(counts) if now.unit(&counts.unit).is_none() => now.units.push(counts),
            Ok(_) => {}
            Err(reason) if run.may_be_unknown => {
                println!("not counted on wider vectors, this valgrind does not know them: {reason}");
            }
            Err(reason) => return Err(reason),
        }
    }
    Ok(now)
}

/// Runs the program under callgrind, which writes one file after each return of the counted function.
fn count(root: &Path, program: &Path, arguments: &[&str]) -> Result<Counts, String> {
    let folder = root.join("target/instructions");
    match std::fs::remove_dir_all(&folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            return Err(format!("{}: {error}", folder.display()));
        }
        _ => std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?,
    }
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--quiet", "--tool=callgrind", "--collect-atstart=no"]).env("RAYON_NUM_THREADS", "1");
    valgrind.args([format!("--toggle-collect={COUNTED}"), format!("--dump-after={COUNTED}")]);
    valgrind.arg(format!("--callgrind-out-file={}", folder.join("part").display())).arg(program).args(arguments);
    let printed = output(valgrind)?;
    let mut counts = Counts::default();
    for line in printed.lines() {
        if let Some(name) = line.strip_prefix("count ") {
            let part = folder.join(format!("part.{}", counts.works.len() + 1));
            counts.works.push((name.to_owned(), total(&part)?));
        } else if let Some(unit) = line.strip_prefix("unit ") {
            unit.clone_into(&mut counts.unit);
        }
    }
    Ok(counts)
}

/// Compiles the program together with the command, so that both link one library, and tells where it is.
fn program(root: &Path) -> Result<PathBuf, String> {
    cargo::succeed(root, cargo::RELEASE).into_result()?;
    Ok(cargo::built(root, "release", "instructions"))
}

fn total(part: &Path) -> Result<u64, String> {
    let text =
        std::fs::read_to_string(part).map_err(|error| format!("callgrind left no {}: {error}", part.display()))?;
    let count = text.lines().find_map(|line| line.strip_prefix("totals: ")?.trim().parse().ok());
    count.filter(|count| *count > 0).ok_or_else(|| format!("{}: callgrind counted nothing", part.display()))
}
