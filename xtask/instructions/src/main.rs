//! Work whose instructions are counted, as a guard against regressions: `cargo xtask instructions` runs this program under
//! callgrind and compares with `counts.toml`.
//!
//! A package of its own, so that no dependency of the library's tests is compiled for it; run with `RAYON_NUM_THREADS=1`, because callgrind
//! tells the threads apart. Without callgrind it does the work twice. `--portable`: on the vector unit that every machine of the target has.
//! `--stepped`: the batches alone, counted by stepping through another run, on units that valgrind does not have. `--batches`: that other run.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "the names in the order of the counts")]

mod batches;
mod counting;
mod fits;
mod motion;
mod robots;
mod single_poses;
#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
mod stepping;

use std::process::ExitCode;

use cdpr::scalar::Unit;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match arguments.as_slice() {
        [] => all(),
        ["--portable"] => {
            Unit::limit(Unit::Portable);
            all();
        }
        ["--batches"] => {
            counting::wait_for_start();
            counting::print_unit();
            batches::count();
        }
        ["--stepped"] => return stepped(),
        _ => {
            eprintln!("instructions: {arguments:?} is none of --portable, --stepped, --batches");
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}

fn all() {
    counting::print_unit();
    single_poses::count();
    batches::count();
    fits::count();
    motion::count();
}

#[cfg(all(target_os = "linux", target_arch = "x86_64"))]
fn stepped() -> ExitCode {
    match stepping::count("--batches") {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("instructions: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Nothing: other systems step in other ways, and other processors have no unit that valgrind lacks.
#[cfg(not(all(target_os = "linux", target_arch = "x86_64")))]
fn stepped() -> ExitCode {
    ExitCode::SUCCESS
}
