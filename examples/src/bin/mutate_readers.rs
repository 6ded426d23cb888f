//! The long run of the reader tests: millions of damaged files for every reader, in time and memory.
//!
//! `cargo run --release -p examples --bin mutate_readers -- [COUNT] [FIRST_SEED] [READER]`
//!
//! A panic names its seed: add the bytes to `tests/readers/found` and mend the reader.
#![expect(clippy::print_stdout, clippy::print_stderr, reason = "a program that shows its figures")]

#[path = "../../../crates/cdpr/tests/readers/mod.rs"]
mod readers;

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::process::ExitCode;
use std::time::{Duration, Instant};

use readers::{READERS, Reader, mutated};

/// What one file may take.
const LONGEST: Duration = Duration::from_secs(1);

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let number = |index: usize, default: u64| {
        arguments.get(index).map_or(Some(default), |text| text.replace('_', "").parse().ok())
    };
    let (Some(count), Some(first)) = (number(0, 1_000), number(1, 0)) else {
        eprintln!("COUNT and FIRST_SEED are whole numbers");
        return ExitCode::FAILURE;
    };
    let wanted = |reader: &&Reader| arguments.get(2).is_none_or(|name| name == reader.name);
    let faults: u64 = READERS.iter().filter(wanted).map(|reader| run(reader, first..first + count)).sum();
    if let Ok(status) = std::fs::read_to_string("/proc/self/status") {
        status.lines().filter(|line| line.starts_with("VmHWM")).for_each(|line| println!("peak memory: {line}"));
    }
    if faults == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Runs seeds through a reader; the number of faults.
fn run(reader: &Reader, seeds: std::ops::Range<u64>) -> u64 {
    let corpus = (reader.corpus)();
    let start = Instant::now();
    let one = |seed: u64| {
        let bytes = mutated(&corpus, seed);
        let (mut panicked, mut time) = timed(reader, &bytes);
        if time > LONGEST {
            // the machine may have been busy
            (panicked, time) = timed(reader, &bytes);
        }
        let is_fault = panicked || time > LONGEST;
        if is_fault {
            eprintln!("{}: seed {seed}: {}, {time:?}", reader.name, if panicked { "panic" } else { "too slow" });
        }
        (u64::from(is_fault), time)
    };
    let threads = std::thread::available_parallelism().map_or(1, |count| count.get() as u64);
    let of_thread = &|thread: u64| {
        let own = (seeds.start + thread..seeds.end).step_by(threads as usize);
        own.map(one).fold((0, Duration::ZERO), |all, this| (all.0 + this.0, all.1.max(this.1)))
    };
    let results: Vec<(u64, Duration)> = std::thread::scope(|scope| {
        let running: Vec<_> = (0..threads).map(|thread| scope.spawn(move || of_thread(thread))).collect();
        running.into_iter().map(|one| one.join().unwrap_or((1, Duration::ZERO))).collect()
    });
    let faults: u64 = results.iter().map(|result| result.0).sum();
    let longest = results.iter().map(|result| result.1).max().unwrap_or_default();
    let count = seeds.end - seeds.start;
    println!("{}: {count} files in {:.0?}, longest {longest:.1?}, {faults} faults", reader.name, start.elapsed());
    faults
}

/// Whether the check panicked, and its time.
fn timed(reader: &Reader, bytes: &[u8]) -> (bool, Duration) {
    let start = Instant::now();
    let panicked = catch_unwind(AssertUnwindSafe(|| (reader.check)(bytes))).is_err();
    (panicked, start.elapsed())
}
