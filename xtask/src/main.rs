//! Development tasks of the workspace. `cargo xtask test` checks everything that a change has to pass.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a terminal program that talks to its developer")]

mod ahead;
mod book;
mod browser;
mod cargo;
mod circles;
mod command;
mod dirty;
mod dist;
mod documents;
mod environments;
mod examples;
mod format;
mod generated;
mod golden;
mod ground;
mod inlining;
mod instruction_counts;
mod instructions;
mod interface;
mod judge;
mod layers;
mod notices;
mod outcome;
mod packages;
mod programs;
mod python;
mod quick;
mod readme;
mod sentences;
mod shells;
mod signatures;
mod soak;
mod steps;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "\
Usage: cargo xtask TASK

Tasks:
  test                 everything a change has to pass, cheapest steps first; stops at the first failure
  test --only STEP     one step of it
  quick                gates, clippy, and the tests of crates that differ from HEAD and of those that stand on them; --since COMMIT
  steps                the steps of `test`
  soak --minutes N     random tests with fresh seeds for N minutes; --seed S begins where an earlier run did
  soak --poseless N    calibrations without measured poses of N seeds, judged by SciPy; --seed S begins there
  soak --dirty N       measurement files spoilt in thirty ways, of N seeds: the table of what `select` notices; --seed S, --without-kept,
                       --only TEXT, --unnamed, --keep, --command PATH
  soak --choices       what `select` recommends on 240 clean records of known truth: counts with the seeds that miss; --seed S, --command, --keep
  golden               compare the command's answers to all calls of the corpus with the committed ones
  golden --part        the part of it that `test` runs; --only GROUP groups of it; --times, --keep to look closer
  golden --accept      make them the committed ones; --command PATH asks another command than that of the build for release
  layers               what each room of the libraries may use, and how their doc lines begin
  generate             write the generated files (schemas, THIRD-PARTY.txt)
  notices              write THIRD-PARTY.txt alone
  instructions         count instructions of the library's work with valgrind, compare with the committed counts
  instructions --accept   make them the committed counts
  interface            compare the libraries' public interfaces with the committed listings
  interface --accept   make them the committed listings
  dist                 pack into dist/: an archive of the command, wheel and source distribution for Python, checksums; --zig for older systems
  python               types and tests of the Python package, from its wheel; --all for all notebooks, recipes of schedulers and benches
  publish-check        all of a publication but the upload: every crate is compiled from its package; asks the registry
  judge                let other programs judge our numbers and times (`judges/`, in a Python environment under target/)
  viewer               build viewer/ with an installed npm into the files that reports include
  book                 build the book into target/book; installs mdbook into target/tools where there is none";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let root = root();
    let result = match arguments.as_slice() {
        ["test"] => steps::run(&root, None),
        ["test", "--only", step] => steps::run(&root, Some(step)),
        ["quick"] => quick::run(&root, "HEAD"),
        ["quick", "--since", commit] => quick::run(&root, commit),
        ["soak", wishes @ ..] => soak::run(&root, wishes),
        ["steps"] => {
            steps::list();
            Ok(())
        }
        ["layers"] => layers::check(&root).into_result(),
        ["generate"] => generated::write(&root),
        ["golden", words @ ..] => golden::run(&root, words),
        ["notices"] => notices::write(&root),
        ["instructions"] => instructions::check(&root).into_result(),
        ["instructions", "--accept"] => instructions::accept(&root),
        ["interface"] => interface::check(&root).into_result(),
        ["interface", "--accept"] => interface::accept(&root),
        ["dist"] => dist::pack(&root, false),
        ["dist", "--zig"] => dist::pack(&root, true),
        ["publish-check"] => dist::publish_check(&root),
        ["python"] => python::check(&root).into_result(),
        ["python", "--all"] => python::check_all(&root).into_result(),
        ["judge"] => judge::check_with_times(&root).into_result(),
        ["viewer"] => browser::build(&root),
        ["book"] => book::build(&root),
        [] | ["help" | "--help" | "-h"] => {
            println!("{USAGE}");
            Ok(())
        }
        other => Err(format!("unknown task `{}`\n\n{USAGE}", other.join(" "))),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::FAILURE
        }
    }
}

/// The workspace root. Cargo tells it when the task runs, so a moved clone needs no rebuild.
fn root() -> PathBuf {
    let manifest =
        std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| env!("CARGO_MANIFEST_DIR").into(), PathBuf::from);
    manifest.parent().map_or_else(|| manifest.clone(), Path::to_path_buf)
}
