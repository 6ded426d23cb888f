//! Random tests with fresh seeds for as long as one likes: `cargo xtask soak --minutes N [--seed S]`, or records without poses of as many seeds: `cargo xtask soak --poseless N [--seed S]`; or
//! spoilt records: `cargo xtask soak --dirty N [--seed S]`; or what is chosen on 220 clean records: `cargo xtask soak --choices [--seed S]`.
//!
//! The whole golden corpus once, then rounds of the library's property tests (their cases follow `CDPR_SEED` and `CDPR_CASES`, read by
//! `crates/cdpr-testing/src/property.rs` alone), of random robots through the command, of calibrations without measured poses that SciPy judges, and of the fuzz targets where
//! cargo-fuzz and a nightly toolchain are installed. A finding is told with its seed and the smallest case.

mod random;
mod robots;
mod trial;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

use crate::programs::{self, on_path};
use crate::{cargo, dirty, golden, judge};
use trial::Trial;

/// Tests whose random cases follow `CDPR_SEED`: parts of their names, as `cargo test` filters them.
const PROPERTIES: &[&str] = &[
    "no_robot_and_no_numbers_make_the_library_panic",
    "no_robot_and_no_samples_make_selection_panic",
    "no_numbers_make_the_statics_panic",
    "the_programme_keeps_limits_balances_and_is_nearest",
    "extreme_numbers_are_refused_or_end_in_a_status_that_is_true",
    "every_method_balances_within_limits_or_proves_that_none_can",
    "scaling_load_and_limits_scales_the_answer",
    "verdicts_and_optima_are_those_of_an_interior_point_solver",
    "any_bytes_are_read_or_refused",
    "damaged_models_are_read_or_refused",
    "damaged_files_are_refused_or_make_sense",
    "any_orientation_and_direction_comes_back_to_the_bit",
    "more_strain_is_more_tension",
    "the_strain_is_the_inverse_of_the_tension",
    "minor_loops_close",
    "closed_cycles_lose_energy",
    "tensions_stay_between_the_branches",
    "every_sample_is_validated_once_and_never_by_its_own_fit",
    "sizes_of_random_robots_lie_within_their_bounds",
    "random_poses_of_eight_robots_get_the_right_verdict_and_the_optimum",
    "batches_decide_as_an_interior_point_solver_does",
    "intervals_of_stated_lengths_hold_the_truth_with_seven_equations",
    "intervals_of_mass_and_center_of_mass_hold_the_truth",
    "intervals_of_linear_densities_hold_the_truth",
    "intervals_of_swivel_zeros_hold_the_truth",
    "intervals_of_all_sensors_hold_the_truth",
    "intervals_of_cutoff_peak_gain_and_pole_hold_the_truth",
    "intervals_of_friction_hold_the_truth",
    "intervals_of_friction_that_falls_with_speed_hold_the_truth",
    "friction_that_does_not_fall_is_hardly_ever_told_to_fall",
    "plateaus_are_found_in_samples_with_cogging_and_ramps",
];

/// Readers that libFuzzer feeds.
const FUZZ_TARGETS: &[&str] =
    &["robot", "measurements", "study", "sidecar", "compensation", "caspr-bodies", "caspr-cables"];

/// How often the usual number of cases is drawn in one round.
const CASES: &str = "4";
/// Longest part of a round that runs the command, and each fuzz target (s).
const COMMAND_SECONDS: u64 = 120;
const FUZZ_SECONDS: u64 = 15;
/// Findings after which more would not be read.
const MOST_FINDINGS: usize = 10;

/// What is asked for.
#[derive(Debug, PartialEq)]
struct Wishes {
    minutes: f64,
    seed: u64,
    /// Seeds whose records without poses are all that is judged.
    poseless: Option<u64>,
}

/// Runs rounds until the time is up; an error where something was found.
pub(crate) fn run(root: &Path, words: &[&str]) -> Result<(), String> {
    if words.contains(&"--dirty") || words.contains(&"--choices") {
        return dirty::run(root, words);
    }
    let wishes = Wishes::of(words)?;
    if let Some(seeds) = wishes.poseless {
        println!("soak: records without poses of {seeds} seeds from {} on", wishes.seed);
        return judge::poseless(root, &cargo::the_command(root)?, (wishes.seed, seeds)).into_result();
    }
    let end = Instant::now() + Duration::from_secs_f64(60.0 * wishes.minutes);
    println!(
        "soak: {} min from seed {} on; again: cargo xtask soak --minutes {} --seed {}",
        wishes.minutes, wishes.seed, wishes.minutes, wishes.seed
    );
    let program = cargo::the_command(root)?;
    let fuzz = Fuzz::find(root);
    if let Err(reason) = &fuzz {
        println!("the fuzz targets are skipped: {reason}");
    }
    let mut findings: Vec<String> = golden::check_whole(root, &program).err().into_iter().collect();
    let mut tried = 0;
    for seed in wishes.seed.. {
        println!("\n── round of seed {seed}");
        findings.extend(properties(root, seed));
        let slice = end.min(Instant::now() + Duration::from_secs(COMMAND_SECONDS));
        let most = MOST_FINDINGS.saturating_sub(findings.len());
        let of_robots = trial::run(&Trial { program: &program, seed, end: slice, most })?;
        tried += of_robots.commands;
        findings.extend(of_robots.findings);
        if Instant::now() < end {
            findings.extend(judge::poseless(root, &program, (seed, 1)).into_result().err());
        }
        if let Ok(fuzz) = &fuzz
            && Instant::now() < end
        {
            findings.extend(FUZZ_TARGETS.iter().filter_map(|target| fuzz.run(root, target, seed)));
        }
        if Instant::now() >= end || findings.len() >= MOST_FINDINGS {
            break;
        }
    }
    println!("\n{tried} commands on random robots, {} findings", findings.len());
    if findings.is_empty() { Ok(()) } else { Err(findings.join("\n\n")) }
}

impl Wishes {
    fn of(words: &[&str]) -> Result<Self, String> {
        let now = SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs());
        let mut wishes = Self { minutes: 10.0, seed: now, poseless: None };
        for pair in words.chunks(2) {
            match pair {
                ["--minutes", text] => {
                    wishes.minutes = text.parse().map_err(|_| format!("--minutes: `{text}` is no number"))?
                }
                ["--seed", text] => {
                    wishes.seed = text.parse().map_err(|_| format!("--seed: `{text}` is no whole number"))?
                }
                ["--poseless", text] => {
                    let seeds = text.parse().ok().filter(|seeds| *seeds > 0);
                    wishes.poseless = Some(seeds.ok_or_else(|| format!("--poseless: `{text}` is no number of seeds"))?);
                }
                other => {
                    return Err(format!(
                        "soak takes --minutes N, --poseless N, --dirty N, --choices and --seed S, not `{}`",
                        other.join(" ")
                    ));
                }
            }
        }
        match wishes.minutes > 0.0 && wishes.minutes < 1e5 {
            true => Ok(wishes),
            false => Err(format!("--minutes: {} is no time to run", wishes.minutes)),
        }
    }
}

/// The property tests with the cases of a seed; what failed, with the smallest case as the test prints it.
fn properties(root: &Path, seed: u64) -> Vec<String> {
    let mut found = Vec::new();
    let mut arguments = cargo::PORTABLE_TESTS.to_vec();
    arguments.push("--");
    arguments.extend(PROPERTIES);
    let mut command = cargo::command(root, &arguments);
    command.env("CDPR_SEED", seed.to_string()).env("CDPR_CASES", CASES);
    let again = format!("CDPR_SEED={seed} CDPR_CASES={CASES} cargo {}", arguments.join(" "));
    match command.stderr(Stdio::inherit()).output() {
        Ok(output) => {
            let text = String::from_utf8_lossy(&output.stdout).into_owned();
            text.lines()
                .filter(|line| line.starts_with("test ") && !line.contains("result:"))
                .for_each(|line| println!("{line}"));
            if !output.status.success() {
                found.push(format!("{}\n{again}", text.trim()));
            }
        }
        Err(error) => found.push(format!("cannot start cargo: {error}")),
    }
    found
}

/// cargo-fuzz under a nightly toolchain; installed into target/tools where the toolchain is there and it is not.
struct Fuzz {
    program: PathBuf,
}

impl Fuzz {
    fn find(root: &Path) -> Result<Self, String> {
        let mut nightly = Command::new("rustc");
        nightly.arg("--version").env("RUSTUP_TOOLCHAIN", "nightly").stdout(Stdio::null()).stderr(Stdio::null());
        if !nightly.status().is_ok_and(|status| status.success()) {
            return Err("there is no nightly toolchain: run `rustup toolchain install nightly`".to_owned());
        }
        let name = format!("cargo-fuzz{}", std::env::consts::EXE_SUFFIX);
        let folder = root.join("target/tools");
        let own = folder.join("bin").join(&name);
        if let Some(program) = on_path(&name).or_else(|| own.is_file().then(|| own.clone())) {
            return Ok(Self { program });
        }
        println!("there is no cargo-fuzz: cargo installs it into target/tools");
        let mut command = cargo::command(root, &["install", "--quiet", "--locked", "--debug", "cargo-fuzz", "--root"]);
        command.arg(&folder);
        programs::run(command)?;
        Ok(Self { program: own })
    }

    fn command(&self, root: &Path) -> Command {
        let mut command = Command::new(&self.program);
        command.current_dir(root).stdin(Stdio::null()).env("RUSTUP_TOOLCHAIN", "nightly");
        // those of the toolchain that runs this program
        for name in ["CARGO", "RUSTC", "RUSTDOC"] {
            command.env_remove(name);
        }
        command
    }
    /// A fuzz target for a while; libFuzzer's words where it found something.
    fn run(&self, root: &Path, target: &str, seed: u64) -> Option<String> {
        let mut command = self.command(root);
        // libFuzzer's seed has 32 bits, and 0 is the time
        let (seconds, seed) =
            (format!("-max_total_time={FUZZ_SECONDS}"), format!("-seed={}", seed % u64::from(u32::MAX) + 1));
        command.args(["run", target, "--", &seconds, &seed, "-rss_limit_mb=4096"]);
        let output = match command.output() {
            Ok(output) => output,
            Err(error) => return Some(format!("fuzz target {target}: {error}")),
        };
        println!("fuzz {target}: {}", output.status);
        let words = String::from_utf8_lossy(&output.stderr);
        let tail: Vec<&str> = words.lines().rev().take(30).collect();
        (!output.status.success()).then(|| {
            format!("fuzz target {target}, {seed}:\n{}", tail.into_iter().rev().collect::<Vec<_>>().join("\n"))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::root;

    fn sources(folder: &Path, found: &mut Vec<(String, String)>) {
        for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
            if path.is_dir() {
                sources(&path, found);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let text = std::fs::read_to_string(&path).unwrap_or_default();
                found.push((path.display().to_string(), text));
            }
        }
    }

    /// proptest draws fresh cases in every run unless it is told not to: a test would fail on one machine in twenty.
    #[test]
    fn no_property_test_draws_its_own_seed() {
        let mut found = Vec::new();
        sources(&root().join("crates"), &mut found);
        let (mut groups, mut variables) = (0, 0);
        for (path, text) in &found {
            variables += text.matches("\"CDPR_SEED\"").count();
            assert!(!text.contains("rand::rng()") && !text.contains("from_os_rng"), "{path}: random without a seed");
            for group in text.split("proptest! {").skip(1) {
                groups += 1;
                let first = group.trim_start().lines().next().unwrap_or_default();
                assert!(first.contains("proptest_config(property::cases("), "{path}: {first}");
            }
        }
        assert!(groups >= 8 && variables == 1, "{groups} {variables}");
    }

    /// A filter that fits nothing would run nothing.
    #[test]
    fn every_property_of_the_soak_is_a_test() {
        let mut found = Vec::new();
        sources(&root().join("crates"), &mut found);
        for name in PROPERTIES {
            assert!(found.iter().any(|(_, text)| text.contains(&format!("fn {name}("))), "{name}");
        }
    }

    #[test]
    fn minutes_and_seed_are_read() {
        let wishes = Wishes::of(&["--seed", "7", "--minutes", "0.5"]);
        assert_eq!(wishes, Ok(Wishes { minutes: 0.5, seed: 7, poseless: None }));
        assert_eq!(Wishes::of(&["--poseless", "20"]).map(|wishes| wishes.poseless), Ok(Some(20)));
        assert!(Wishes::of(&["--minutes", "0"]).is_err() && Wishes::of(&["--hours", "1"]).is_err());
        assert!(Wishes::of(&["--poseless", "0"]).is_err());
    }
}
