//! The steps of `cargo xtask test`, in order; one line of the table each.

use std::path::Path;
use std::time::{Duration, Instant};

use crate::ahead::Ahead;
use crate::outcome::Outcome;
use crate::{
    book, browser, cargo, command, dist, documents, examples, format, generated, golden, ground, instructions,
    interface, judge, layers, python, shells,
};

/// One step of the entrance.
struct Step {
    /// The word after `--only`.
    name: &'static str,
    /// How it is checked.
    action: Action,
    /// What to do when it fails.
    remedy: &'static str,
}

enum Action {
    /// A cargo command that must succeed.
    Cargo(&'static [&'static str]),
    /// A check of our own.
    Own(fn(&Path) -> Outcome),
}

/// All targets.
const CLIPPY: &[&str] = &["clippy", "--workspace", "--lib", "--bins", "--tests", "--benches", "--", "-D", "warnings"];

/// Cheap steps first. Benches compile in `clippy`.
const STEPS: &[Step] = &[
    Step { name: "tools", action: Action::Own(cargo::tools), remedy: "install what is missing, as the message says" },
    Step {
        name: "format",
        action: Action::Own(format::check),
        remedy: "run `cargo fmt --all`; a module that a macro declares is not found by it",
    },
    Step {
        name: "layers",
        action: Action::Own(layers::check),
        remedy: "move the code to the right, or the shared part to the left (ARCHITECTURE.md)",
    },
    Step {
        name: "interface",
        action: Action::Own(interface::check),
        remedy: "make it private again, or `cargo xtask interface --accept` and say in CHANGELOG.md what users may call now",
    },
    Step {
        name: "documents",
        action: Action::Own(documents::check),
        remedy: "mend the link, list the page in SUMMARY.md, or state in the manifest what is missing",
    },
    Step {
        name: "clippy",
        action: Action::Cargo(CLIPPY),
        remedy: "mend the code; an exception is `#[expect(lint, reason = \"…\")]` on the smallest item",
    },
    Step {
        // portable, which takes half as long to compile; what every vector unit makes of it is a test of the build for release
        name: "library",
        action: Action::Own(library),
        remedy: "run the failing test alone: `cargo test -p CRATE NAME`",
    },
    Step {
        name: "command",
        action: Action::Own(command::check),
        remedy: "run the failing test alone: `cargo test --release -p cdpr-cli NAME`; a spoilt record: `cargo xtask soak --dirty 1 --seed SEED --only \
                 KIND/ROBOT --keep`",
    },
    Step {
        name: "golden",
        action: Action::Own(golden::check_part),
        remedy: "mend what changed the numbers, or list them in CHANGELOG.md with the reason, then `cargo xtask golden --accept`",
    },
    Step { name: "doc-tests", action: Action::Own(documentation_tests), remedy: "mend the example in the doc comment" },
    Step {
        name: "docs",
        // with the dependencies as the doc tests have them checked
        action: Action::Cargo(&["doc", "-p", "cdpr-core", "-p", "cdpr", "--lib", "--no-deps"]),
        remedy: "mend the doc comment that rustdoc names",
    },
    Step {
        name: "no-default-features",
        action: Action::Own(without_features),
        remedy: "put the code that needs the feature behind `#[cfg(feature = \"…\")]`",
    },
    Step {
        name: "ground",
        action: Action::Own(ground::check),
        remedy: "cdpr-core takes nothing from std and claims no memory: put what does behind its feature `std`, or to the right",
    },
    Step {
        name: "generated",
        action: Action::Own(generated::check),
        remedy: "run `cargo xtask generate` and commit what it wrote",
    },
    Step {
        name: "examples",
        action: Action::Own(examples::run),
        remedy: "run it alone: `cargo run -p examples --bin NAME`",
    },
    Step {
        name: "dist",
        action: Action::Own(dist::check),
        remedy: "look at target/dist, where the packages are; `cargo xtask dist` packs them again",
    },
    Step {
        name: "python",
        action: Action::Own(python::check),
        remedy: "run the failing test alone in python/tests: `python -m unittest NAME`, with the wheel of target/wheel installed; `cargo xtask python`",
    },
    Step {
        name: "shells",
        action: Action::Own(shells::check),
        remedy: "ask `cdpr complete -- WORDS` yourself; the scripts are in crates/cdpr-cli/src/completion",
    },
    Step { name: "book", action: Action::Own(book::check), remedy: "mend the page that mdbook names" },
    Step {
        name: "instructions",
        action: Action::Own(instructions::check),
        remedy: "make it cheaper again, or `cargo xtask instructions --accept` and say in CHANGELOG.md what the work buys",
    },
    Step {
        name: "judge",
        action: Action::Own(judge::check),
        remedy: "compare with the convention in judges/mujoco/scene.py; a limit is not moved to pass",
    },
    Step {
        name: "browser",
        action: Action::Own(browser::check),
        remedy: "look at target/browser/screenshots; `cargo xtask viewer` builds the viewer anew",
    },
];

/// The tests of the libraries on the portable unit, and that they are no more than that.
fn library(root: &Path) -> Outcome {
    let mut sum = cargo::portable(root);
    if sum.failed == 0 {
        sum.add(cargo::count_tests(root, &[cargo::PORTABLE_TESTS, &["--no-fail-fast"]].concat()));
    }
    sum
}

/// The libraries without their default features, and the command without its own.
fn without_features(root: &Path) -> Outcome {
    let libraries = DOCUMENTED.iter().skip(1).flat_map(|package| ["-p", package]);
    let bare = |packages: Vec<&str>, kind: &str| {
        let arguments = [&["clippy"], &packages[..], &[kind, "--no-default-features", "--", "-D", "warnings"]].concat();
        cargo::succeed(root, &arguments)
    };
    let mut sum = bare(libraries.collect(), "--lib");
    sum.add(bare(vec!["-p", "cdpr-cli"], "--bins"));
    sum
}

/// The tests in doc comments, with the library of the build for release: `cargo test --doc` would compile another one.
fn documentation_tests(root: &Path) -> Outcome {
    if let Err(complaint) = cargo::succeed(root, cargo::RELEASE).into_result() {
        return Outcome::of(vec![complaint]);
    }
    let folder = format!("dependency={}", cargo::built(root, "release", "deps").display());
    // examples are written for users: all of them may name the facade
    let library = |package: &str| {
        let name = package.replace('-', "_");
        let file = cargo::built(root, "release", &format!("lib{name}")).with_extension("rlib");
        format!("{name}={}", file.display())
    };
    let (facade, mut sum) = (library("cdpr"), Outcome::default());
    for package in DOCUMENTED {
        let own = library(package);
        let tested = ["rustdoc", "-p", package, "--lib", "--", "--test", "--extern", &facade, "-L", &folder];
        let tested = if package == "cdpr" { tested.to_vec() } else { [&tested[..], &["--extern", &own]].concat() };
        sum.add(cargo::count_tests(root, &tested));
    }
    sum
}

/// Libraries with examples in their documentation.
const DOCUMENTED: [&str; 8] =
    ["cdpr-core", "cdpr-model", "cdpr-workspace", "cdpr-plant", "cdpr-calibration", "cdpr-study", "cdpr-cli", "cdpr"];

/// Steps that need what is fetched ahead.
const FETCHED_FOR: [&str; 7] = ["dist", "python", "shells", "book", "instructions", "judge", "browser"];

/// The first step that needs the builds for release; all steps after it may.
const BUILT_FOR: &str = "command";

/// Runs all steps, or one; prints the closing line `N passed, N failed`.
pub(crate) fn run(root: &Path, only: Option<&str>) -> Result<(), String> {
    let steps: Vec<&Step> = STEPS.iter().filter(|step| only.is_none_or(|name| name == step.name)).collect();
    if steps.is_empty() {
        return Err(format!("no step is called `{}`; there are: {}", only.unwrap_or_default(), names().join(", ")));
    }
    let mut ahead = if only.is_none() { Ahead::start(root) } else { Ahead::default() };
    let (mut passed, mut failed) = (0, 0);
    for step in steps {
        if FETCHED_FOR.contains(&step.name) {
            ahead.fetched();
        }
        if step.name == BUILT_FOR {
            ahead.built();
        }
        println!("\n── {} {}", step.name, "─".repeat(60_usize.saturating_sub(step.name.len())));
        let start = Instant::now();
        let outcome = step.action.run(root);
        passed += outcome.passed;
        failed += outcome.failed;
        report(step, &outcome, start.elapsed());
        if outcome.failed > 0 {
            break;
        }
    }
    println!("\n{passed} passed, {failed} failed");
    if failed == 0 { Ok(()) } else { std::process::exit(1) }
}

/// Prints the names of the steps.
pub(crate) fn list() {
    println!("{}", names().join("\n"));
}

/// Runs one step; an error where it fails.
pub(crate) fn pass(root: &Path, name: &str) -> Result<(), String> {
    let step = STEPS.iter().find(|step| step.name == name).ok_or_else(|| format!("no step is called `{name}`"))?;
    let start = Instant::now();
    let outcome = step.action.run(root);
    report(step, &outcome, start.elapsed());
    if outcome.failed == 0 { Ok(()) } else { Err(format!("the step `{name}` failed")) }
}

fn names() -> Vec<&'static str> {
    STEPS.iter().map(|step| step.name).collect()
}

fn report(step: &Step, outcome: &Outcome, time: Duration) {
    for complaint in &outcome.complaints {
        println!("{complaint}");
    }
    let seconds = time.as_secs_f64();
    if outcome.failed == 0 {
        println!("{}: passed ({seconds:.1} s)", step.name);
    } else {
        println!("{}: FAILED ({seconds:.1} s). What to do: {}.", step.name, step.remedy);
        println!("Then again: cargo xtask test --only {}", step.name);
    }
}

impl Action {
    fn run(&self, root: &Path) -> Outcome {
        match self {
            Self::Cargo(arguments) => cargo::succeed(root, arguments),
            Self::Own(check) => check(root),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A step renamed would run without what is fetched for it.
    #[test]
    fn what_is_made_ahead_is_for_steps_that_exist() {
        FETCHED_FOR.iter().chain([&BUILT_FOR]).for_each(|name| assert!(names().contains(name), "{name}"));
    }

    /// `--only` could not tell two steps of one name apart.
    #[test]
    fn step_names_are_unique() {
        let mut names = names();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), STEPS.len());
    }
}
