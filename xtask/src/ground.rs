//! The crate `cdpr-core` without a standard library: compiled, linked to a program without a C library, and compiled for a bare target.

use std::path::Path;
use std::process::Command;

use crate::cargo;
use crate::outcome::Outcome;
use crate::programs::{on_path, output, run};

/// Without default features, in a folder of its own: together with other packages the features would be theirs. Panics abort, since there is
/// nothing that could unwind.
const BARE: &[&str] =
    &["-p", "cdpr-core", "--no-default-features", "--features", "libm", "--target-dir", "target/ground"];
/// A controller without an operating system: ARM Cortex-M with a floating-point unit.
const BARE_TARGET: &str = "thumbv7em-none-eabihf";

/// Passes when it compiles for the host and for a bare target, and a program without a C library finds its numbers. What the machine cannot do is
/// skipped, and said.
pub(crate) fn check(root: &Path) -> Outcome {
    let mut sum = cargo_with_aborts(root, "build", &[]);
    if sum.failed == 0 {
        sum.add(linked(root));
    }
    sum.add(for_bare_target(root));
    sum
}

fn cargo_with_aborts(root: &Path, task: &str, more: &[&str]) -> Outcome {
    let arguments = [&[task, "--quiet"], BARE, more].concat();
    println!("$ cargo {}", arguments.join(" "));
    let mut command = cargo::command(root, &arguments);
    command.env("CARGO_PROFILE_DEV_PANIC", "abort");
    Outcome::of(run(command).err().into_iter().collect())
}

/// `xtask/ground/program.rs` linked with `-nostdlib`, and run.
fn linked(root: &Path) -> Outcome {
    if !cfg!(all(target_arch = "x86_64", target_os = "linux")) {
        println!("skipped: the program without a C library is written for Linux on x86-64");
        return Outcome::default();
    }
    let built = root.join("target/ground/debug");
    let program = built.join("ground-program");
    let mut compiler = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    compiler
        .args(["--edition", "2024", "-C", "opt-level=1", "-C", "panic=abort", "-C", "relocation-model=static"])
        .args(["-C", "link-arg=-nostdlib", "-C", "link-arg=-nostartfiles", "-C", "link-arg=-static"])
        .arg(root.join("xtask/ground/program.rs"))
        .arg("-o")
        .arg(&program)
        .arg("--extern")
        .arg(format!("cdpr_core={}", built.join("libcdpr_core.rlib").display()))
        .arg("-L")
        .arg(format!("dependency={}", built.join("deps").display()));
    let found = run(compiler).and_then(|()| match Command::new(&program).status().map(|status| status.code()) {
        Ok(Some(0)) => Ok(()),
        Ok(Some(number)) => Err(format!("xtask/ground/program.rs: check {number} found another number")),
        Ok(None) => Err("xtask/ground/program.rs: the program was killed by a signal".to_owned()),
        Err(error) => Err(format!("cannot start {}: {error}", program.display())),
    });
    Outcome::of(found.err().into_iter().collect())
}

fn for_bare_target(root: &Path) -> Outcome {
    if let Err(reason) = bare_target() {
        println!("skipped: {BARE_TARGET} cannot be had here ({reason})");
        return Outcome::default();
    }
    cargo_with_aborts(root, "check", &["--target", BARE_TARGET])
}

/// Sees to it that the toolchain has the bare target.
fn bare_target() -> Result<(), String> {
    on_path("rustup").ok_or("no rustup on the search path")?;
    let mut list = Command::new("rustup");
    list.args(["target", "list", "--installed"]);
    if output(list)?.lines().any(|line| line == BARE_TARGET) {
        return Ok(());
    }
    let mut add = Command::new("rustup");
    add.args(["target", "add", BARE_TARGET]);
    output(add).map(|_| ())
}
