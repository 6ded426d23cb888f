//! Counts instructions of the library's work under callgrind and compares them with the committed counts.

use std::path::Path;
use std::process::Command;

use crate::outcome::Outcome;
use crate::programs::{can_install, install, on_path, output};
use crate::{cargo, instruction_counts::Counts};

/// The committed counts.
const REFERENCE: &str = "crates/cdpr/benches/instructions.toml";

/// The function of the bench that holds the work, as callgrind names it.
const COUNTED: &str = "instructions::counted";

/// Complains of work that takes noticeably more instructions than the committed counts say.
pub(crate) fn check(root: &Path) -> Outcome {
    if let Err(reason) = callgrind() {
        return skipped(&reason);
    }
    let reference = std::fs::read_to_string(root.join(REFERENCE)).map_err(|error| format!("{REFERENCE}: {error}"));
    match reference.and_then(|text| Ok((Counts::from_toml(&text)?, counts(root)?))) {
        Ok((reference, counts)) if reference.unit != counts.unit => {
            skipped(&format!("vectors are {} here and {} in {REFERENCE}", counts.unit, reference.unit))
        }
        Ok((reference, counts)) => reference.compare(&counts),
        Err(complaint) => Outcome::of(vec![complaint]),
    }
}

/// Makes the counts of now the committed ones.
pub(crate) fn accept(root: &Path) -> Result<(), String> {
    callgrind()?;
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
fn callgrind() -> Result<(), String> {
    if on_path("valgrind").is_some() {
        return Ok(());
    }
    if !can_install() {
        return Err("there is no valgrind".to_owned());
    }
    install(&["valgrind"])
}

/// Builds the bench and runs it under callgrind, which writes one file after each return of the counted function.
fn counts(root: &Path) -> Result<Counts, String> {
    let program = build(root)?;
    let folder = root.join("target/instructions");
    match std::fs::remove_dir_all(&folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            return Err(format!("{}: {error}", folder.display()));
        }
        _ => std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?,
    }
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--quiet", "--tool=callgrind", "--collect-atstart=no"]);
    valgrind.args([format!("--toggle-collect={COUNTED}"), format!("--dump-after={COUNTED}")]);
    valgrind.arg(format!("--callgrind-out-file={}", folder.join("part").display())).arg(program);
    let printed = output(valgrind)?;
    let mut rustc = Command::new("rustc");
    rustc.arg("--version").current_dir(root);
    let mut counts = Counts { compiler: output(rustc)?.trim().to_owned(), ..Counts::default() };
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

/// The program to run. Without threads: callgrind counts for each thread, and `counted` is in one of them only. Without
/// vector units beyond those that all machines of the target have: counts do not depend on the machine, and old
/// valgrinds know the instructions.
fn build(root: &Path) -> Result<String, String> {
    let arguments = ["bench", "--no-run", "-p", "cdpr", "--no-default-features", "--bench", "instructions"];
    println!("$ cargo {}", arguments.join(" "));
    let messages =
        output(cargo::command(root, &[&arguments[..], &["--message-format=json-render-diagnostics"]].concat()))?;
    let program = messages.lines().find_map(|line| Some(line.split_once("\"executable\":\"")?.1.split_once('"')?.0));
    program.map(str::to_owned).ok_or_else(|| "cargo names no program for the bench `instructions`".to_owned())
}

fn total(part: &Path) -> Result<u64, String> {
    let text =
        std::fs::read_to_string(part).map_err(|error| format!("callgrind left no {}: {error}", part.display()))?;
    let count = text.lines().find_map(|line| line.strip_prefix("totals: ")?.trim().parse().ok());
    count.filter(|count| *count > 0).ok_or_else(|| format!("{}: callgrind counted nothing", part.display()))
}
