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
const COUNTED: &str = "instructions::counting::counted";

/// One thread, since callgrind tells them apart; and copies by loops over vectors, since an instruction that repeats itself counts for every byte, of
/// which lengths the C library takes from the processor.
const ENVIRONMENT: [(&str, &str); 2] = [
    ("RAYON_NUM_THREADS", "1"),
    ("GLIBC_TUNABLES", "glibc.cpu.x86_rep_movsb_threshold=0x7fffffff:glibc.cpu.x86_rep_stosb_threshold=0x7fffffff"),
];

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

/// Makes the counts of now the committed ones; units that only other machines have keep theirs.
pub(crate) fn accept(root: &Path) -> Result<(), String> {
    fetch()?;
    let mut counts = counts(root)?;
    // what cannot be read is renewed
    let before = std::fs::read_to_string(root.join(REFERENCE)).ok().and_then(|text| Reference::from_toml(&text).ok());
    before.into_iter().for_each(|before| counts.keep_units_of(before));
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

/// Counts on the vectors that every machine of the target has, on the widest that this valgrind understands, and on the widest of the machine.
fn counts(root: &Path) -> Result<Reference, String> {
    let mut rustc = Command::new("rustc");
    rustc.arg("--version").current_dir(root);
    let mut now = Reference { compiler: output(rustc)?.trim().to_owned(), units: Vec::new() };
    let program = program(root)?;
    let portable = by_callgrind(root, &program, Some("--portable"))?;
    if portable.unit != "Portable" {
        return Err(format!("`instructions --portable` ran on {}", portable.unit));
    }
    now.units.push(portable);
    // the valgrind of Debian 12 does not know every AVX2 instruction that compilers choose
    match by_callgrind(root, &program, None) {
        Ok(counts) => now.add(counts),
        Err(reason) => println!("not counted on wider vectors, this valgrind does not know them: {reason}"),
    }
    now.add(by_steps(&program)?);
    Ok(now)
}

/// Runs the program under callgrind, which writes one file after each return of the counted function.
fn by_callgrind(root: &Path, program: &Path, argument: Option<&str>) -> Result<Counts, String> {
    let folder = root.join("target/instructions");
    match std::fs::remove_dir_all(&folder) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            return Err(format!("{}: {error}", folder.display()));
        }
        _ => std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?,
    }
    let mut valgrind = Command::new("valgrind");
    valgrind.args(["--quiet", "--tool=callgrind", "--collect-atstart=no"]).envs(ENVIRONMENT);
    valgrind.args([format!("--toggle-collect={COUNTED}"), format!("--dump-after={COUNTED}")]);
    valgrind.arg(format!("--callgrind-out-file={}", folder.join("part").display())).arg(program).args(argument);
    let printed = output(valgrind)?;
    let mut counts = Counts { unit: unit(&printed), works: Vec::new() };
    for (part, name) in (1..).zip(printed.lines().filter_map(|line| line.strip_prefix("count "))) {
        counts.works.push((name.to_owned(), total(&folder.join(format!("part.{part}")))?));
    }
    Ok(counts)
}

/// Lets the program count its batches by steps, on the unit that no valgrind has; nothing where the machine has none.
fn by_steps(program: &Path) -> Result<Counts, String> {
    let mut stepped = Command::new(program);
    stepped.arg("--stepped").envs(ENVIRONMENT);
    let printed = output(stepped)?;
    let mut counts = Counts { unit: unit(&printed), works: Vec::new() };
    let (mut name, unreadable) = (None, |line: &str| format!("`{}` printed `{line}`", program.display()));
    for line in printed.lines() {
        if let Some(of) = line.strip_prefix("count ") {
            name = Some(of.to_owned());
        } else if let Some(number) = line.strip_prefix("instructions ") {
            let number = number.parse().map_err(|_| unreadable(line))?;
            counts.works.push((name.take().ok_or_else(|| unreadable(line))?, number));
        } else if let Some(reason) = line.strip_prefix("refused ") {
            println!(
                "batches are not counted on the widest vectors, programs cannot be stepped through here: {reason}"
            );
        }
    }
    Ok(counts)
}

/// The unit that the program says it runs on.
fn unit(printed: &str) -> String {
    printed.lines().find_map(|line| line.strip_prefix("unit ")).unwrap_or_default().to_owned()
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
