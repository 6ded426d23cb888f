//! Golden corpus: answers of the command `cdpr` to calls of every subcommand, compared number by number with the committed ones. Started by
//! `cargo xtask golden`.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a terminal program that talks to its developer")]

mod answer;
mod compare;
mod corpus;
mod dirt;
mod group;
mod options;
mod rules;
mod run;
mod store;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use serde_json::Value;

use compare::Comparison;
use group::Group;
use options::Options;
use run::{Answers, Places};

/// Differences of one call that are printed.
const SHOWN: usize = 8;
const HOW_TO_ACCEPT: &str = "Numbers that shall change: list them in CHANGELOG.md under \"Results that change\" with the reason, then \
     `cargo xtask golden --accept`, and commit xtask/golden/corpus.json.gz.";

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let complaints = Options::of(&words).and_then(|options| check(&options));
    match complaints {
        Ok(complaints) if complaints.is_empty() => ExitCode::SUCCESS,
        Ok(complaints) => {
            eprintln!("{}\n\n{} calls or inputs differ. {HOW_TO_ACCEPT}", complaints.join("\n"), complaints.len());
            ExitCode::FAILURE
        }
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

/// Runs the groups that are asked for and compares or stores their answers; complaints, one for each call that differs.
fn check(options: &Options) -> Result<Vec<String>, String> {
    let (root, groups) = (root(), corpus::groups());
    let places = places(&root, options)?;
    let mut wanted: Vec<&Group> = groups.iter().filter(|group| options.wants(group)).collect();
    if wanted.is_empty() {
        return Err("no group has such a name; `xtask/golden/src/corpus` has them all".to_owned());
    }
    if !places.shared.is_dir() {
        println!("{}", without_shared(&mut wanted)?);
    }
    let is_whole = wanted.len() == groups.len();
    if options.accept && !is_whole {
        return Err("answers are accepted where ../shared is, so that the corpus is whole".to_owned());
    }
    let start = Instant::now();
    let answers = run::run(&wanted, &places);
    if !options.keep {
        // of a folder of our own; the next run has another
        let _ = std::fs::remove_dir_all(&places.scratch);
    }
    if options.times {
        tell_times(&answers);
    }
    let path = root.join("xtask/golden/corpus.json.gz");
    let mut expected = store::read(&path)?;
    if !is_whole {
        let names: BTreeSet<String> = wanted.iter().flat_map(|group| group.names().collect::<Vec<_>>()).collect();
        expected.retain(|name, _| names.contains(name));
    }
    let (differences, values) = compared(&expected, &answers);
    println!(
        "golden: {} calls in {} groups, {values} values, {:.1} s; {} differ",
        answers.values.len(),
        wanted.len(),
        start.elapsed().as_secs_f64(),
        differences.len()
    );
    if options.accept { accept(&path, &answers, &differences) } else { Ok(differences) }
}

fn places(root: &Path, options: &Options) -> Result<Places, String> {
    let shared = root.join("../shared");
    Ok(Places {
        command: options.command.canonicalize().map_err(|error| format!("{}: {error}", options.command.display()))?,
        studies: root.join("studies"),
        scratch: std::env::temp_dir().join(format!("cdpr-golden-{}", std::process::id())),
        shared: shared.canonicalize().unwrap_or(shared),
    })
}

/// Leaves out groups that read `../shared`; an error on the machine that has to have it.
fn without_shared(wanted: &mut Vec<&Group>) -> Result<String, String> {
    let before = wanted.len();
    wanted.retain(|group| !group.reads_shared());
    let told = format!("{} groups of calls are skipped: ../shared is not there", before - wanted.len());
    if std::env::var("CI").as_deref() == Ok("true") { Err(told) } else { Ok(told) }
}

/// Differences call by call, and the number of values compared.
fn compared(expected: &BTreeMap<String, Value>, answers: &Answers) -> (Vec<String>, usize) {
    let (mut complaints, mut values) = (answers.complaints.clone(), 0);
    for (name, found) in &answers.values {
        let Some(wanted) = expected.get(name) else {
            complaints.push(format!("{name}\n    is not in the stored file"));
            continue;
        };
        let comparison = Comparison::of(wanted, found);
        values += comparison.values;
        let count = comparison.differences.len();
        if count > 0 {
            let more = if count > SHOWN { format!("\n    … {} more", count - SHOWN) } else { String::new() };
            let shown: Vec<String> = comparison.differences.into_iter().take(SHOWN).collect();
            complaints.push(format!("{name}\n    {}{more}", shown.join("\n    ")));
        }
    }
    let absent = expected.keys().filter(|name| !answers.values.contains_key(*name));
    complaints.extend(absent.map(|name| format!("{name}\n    is stored, and no call any more")));
    (complaints, values)
}

fn accept(path: &Path, answers: &Answers, differences: &[String]) -> Result<Vec<String>, String> {
    if !answers.complaints.is_empty() {
        return Err(answers.complaints.join("\n"));
    }
    let size = store::write(path, &answers.values)?;
    println!("{}\naccepted: {} calls, {size} bytes", differences.join("\n"), answers.values.len());
    if size > store::LARGEST {
        return Err(format!("{} has more than {} bytes: keep fewer numbers", path.display(), store::LARGEST));
    }
    Ok(Vec::new())
}

fn tell_times(answers: &Answers) {
    let mut times: Vec<_> = answers.times.iter().collect();
    times.sort();
    for (time, name) in times.iter().rev().take(30) {
        println!("{:7.2} s  {name}", time.as_secs_f64());
    }
}

/// The workspace root. Cargo tells it when the program runs, so a moved clone needs no rebuild.
fn root() -> PathBuf {
    let manifest =
        std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| env!("CARGO_MANIFEST_DIR").into(), PathBuf::from);
    manifest.ancestors().nth(2).map_or_else(|| manifest.clone(), Path::to_path_buf)
}
