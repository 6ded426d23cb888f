//! Measurement files spoilt in thirty ways by a simulation that shares no code with the product, and what the command `cdpr select` says of
//! them. Started by `cargo xtask soak --dirty N`, and with `--fixed` by `cargo xtask test`. `cargo xtask soak --choices` counts what is chosen on clean records.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a terminal program that talks to its developer")]

mod answer;
mod cells;
mod choices;
mod geometry;
mod in_turn;
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
use std::time::Instant;

use in_turn::in_turn;
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

/// Runs the cells, or the choices, that are asked for and prints what they come to; complaints about limits that are not kept.
fn check(options: &Options) -> Result<Vec<String>, String> {
    let command = &options.command;
    let bench = Bench {
        command: command.canonicalize().map_err(|error| format!("{}: {error}", command.display()))?,
        folder: std::env::temp_dir().join(format!("cdpr-dirty-{}", std::process::id())),
        keep: options.keep,
    };
    let start = Instant::now();
    let complaints = match options.choices {
        true => choices::check(&bench, options.first),
        false => check_cells(options, &bench)?,
    };
    match bench.keep {
        true => println!("files: {}", bench.folder.display()),
        // of a folder of our own; the next run has another
        false => drop(std::fs::remove_dir_all(&bench.folder)),
    }
    println!("\ndirty: {:.1} s", start.elapsed().as_secs_f64());
    Ok(complaints)
}

fn check_cells(options: &Options, bench: &Bench) -> Result<Vec<String>, String> {
    let cells = if options.fixed { cells::fixed() } else { cells::all(options.first, options.seeds) };
    let wants = |cell: &Cell| {
        let is_open = !(options.without_kept && cell.kind.kept);
        is_open && options.only.as_ref().is_none_or(|text| cell.name().contains(text))
    };
    let cells: Vec<Cell> = cells.into_iter().filter(wants).collect();
    if cells.is_empty() {
        return Err("no cell has such a name; they are called KIND/ROBOT/SEED".to_owned());
    }
    let (outcomes, mut complaints) = run(&cells, bench);
    println!("{}", table::text(&outcomes));
    let single = table::single_cells(&outcomes, options.unnamed || options.fixed || options.only.is_some());
    if !single.is_empty() {
        println!("\n{}", single.join("\n"));
    }
    println!("\n{} cells", outcomes.len());
    complaints.extend(table::complaints(&outcomes));
    Ok(complaints)
}

/// Outcomes in the order of the cells, and complaints about cells without one.
fn run(cells: &[Cell], bench: &Bench) -> (Vec<Outcome>, Vec<String>) {
    let (mut outcomes, mut complaints) = (Vec::new(), Vec::new());
    for outcome in in_turn(cells, |cell| cell.run(bench)) {
        match outcome {
            Ok(outcome) => outcomes.push(outcome),
            Err(complaint) => complaints.push(complaint),
        }
    }
    (outcomes, complaints)
}
