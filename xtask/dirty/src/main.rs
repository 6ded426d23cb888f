//! Measurement files spoilt in thirty ways by a simulation that shares no code with the product, and what the command `cdpr select` says of
//! them. Started by `cargo xtask soak --dirty N`, and with `--fixed` by `cargo xtask test`.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a terminal program that talks to its developer")]

mod answer;
mod cells;
mod geometry;
mod kinds;
mod options;
mod pose;
mod random;
mod record;
mod robots;
mod scene;
mod solve;
mod spoil;
mod table;
mod trial;
mod verdict;
mod written;

use std::process::ExitCode;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Instant;

use options::Options;
use trial::{Bench, Cell, Outcome};

fn main() -> ExitCode {
    let words: Vec<String> = std::env::args().skip(1).collect();
    match Options::of(&words).and_then(|options| check(&options)) {
        Ok(complaints) if complaints.is_empty() => ExitCode::SUCCESS,
        Ok(complaints) => {
            eprintln!("{}", complaints.join("\n"));
            ExitCode::FAILURE
        }
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(2)
        }
    }
}

/// Runs the cells that are asked for and prints the table; complaints about limits that are not kept.
fn check(options: &Options) -> Result<Vec<String>, String> {
    let command = &options.command;
    let cells = if options.fixed { cells::fixed() } else { cells::all(options.first, options.seeds) };
    let wants = |cell: &Cell| {
        let is_open = !(options.without_kept && cell.kind.kept);
        is_open && options.only.as_ref().is_none_or(|text| cell.name().contains(text))
    };
    let cells: Vec<Cell> = cells.into_iter().filter(wants).collect();
    if cells.is_empty() {
        return Err("no cell has such a name; they are called KIND/ROBOT/SEED".to_owned());
    }
    let bench = Bench {
        command: command.canonicalize().map_err(|error| format!("{}: {error}", command.display()))?,
        folder: std::env::temp_dir().join(format!("cdpr-dirty-{}", std::process::id())),
        keep: options.keep,
    };
    let start = Instant::now();
    let (outcomes, mut complaints) = run(&cells, &bench);
    match bench.keep {
        true => println!("files: {}", bench.folder.display()),
        // of a folder of our own; the next run has another
        false => drop(std::fs::remove_dir_all(&bench.folder)),
    }
    println!("{}", table::text(&outcomes));
    let single = table::single_cells(&outcomes, options.unnamed || options.fixed || options.only.is_some());
    if !single.is_empty() {
        println!("\n{}", single.join("\n"));
    }
    println!("\ndirty: {} cells, {:.1} s", outcomes.len(), start.elapsed().as_secs_f64());
    complaints.extend(table::complaints(&outcomes));
    Ok(complaints)
}

/// Outcomes in the order of the cells, and complaints about cells without one.
fn run(cells: &[Cell], bench: &Bench) -> (Vec<Outcome>, Vec<String>) {
    let (next, done) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    let work = || {
        while let Some(cell) = cells.get(next.fetch_add(1, Ordering::Relaxed)) {
            let outcome = (cell.name(), cell.run(bench));
            if let Ok(mut done) = done.lock() {
                done.push(outcome);
            }
        }
    };
    thread::scope(|scope| {
        let workers = thread::available_parallelism().map_or(1, usize::from);
        (0..workers).for_each(|_| drop(scope.spawn(work)));
    });
    let order = |name: &str| cells.iter().position(|cell| cell.name() == name);
    let mut done = done.into_inner().unwrap_or_default();
    done.sort_by_key(|(name, _)| order(name));
    let (mut outcomes, mut complaints) = (Vec::new(), Vec::new());
    for (_, outcome) in done {
        match outcome {
            Ok(outcome) => outcomes.push(outcome),
            Err(complaint) => complaints.push(complaint),
        }
    }
    (outcomes, complaints)
}
