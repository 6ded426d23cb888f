//! Other programs judge our numbers: `judges/` in a Python environment of its own.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::cargo;
use crate::environments;
use crate::outcome::Outcome;

/// What each judge is given: the example that writes its cases, and the script that judges them.
const JUDGES: [(&str, &str); 6] = [
    ("judge_cases", "judges/mujoco/judge.py"),
    ("judge_motion", "judges/motion/judge.py"),
    ("judge_tensions", "judges/tensions/judge.py"),
    ("judge_losses", "judges/losses/judge.py"),
    ("judge_paths", "judges/paths/judge.py"),
    ("judge_optima", "judges/optima/judge.py"),
];
/// Judge of calibrations without measured poses: makes its records itself and runs the command on them.
const POSELESS: &str = "judges/self_calibration/judge.py";
/// Judge of what boxes allow: runs the command on robot files, and searches dense grids itself.
const CAPABILITY: &str = "judges/capability/judge.py";
/// Judge of dry friction in motion: runs the command on scenarios of a robot, and integrates them itself from event to event.
const FRICTION: (&str, &str) = ("judges/friction/judge.py", "studies/robots/simulator-in-motion.toml");
/// Robot files that come with the command.
const ROBOTS: &str = "crates/cdpr-model/robots";
/// The judges that also compare times.
const TIMED: [&str; 2] = ["judge_motion", "judge_tensions"];

/// Passes when MuJoCo finds our lengths, equilibria and motions, DAQP and SciPy our tensions, SciPy our robust calibrations, least largest errors and fits within bounds, calibrations without poses, what boxes allow and dry friction in motion, and scikit-learn our paths of a lasso; says why where they cannot be asked. Times
/// are shown and not judged.
pub(crate) fn check(root: &Path) -> Outcome {
    all(root, false)
}

/// The same, and times are judged too.
pub(crate) fn check_with_times(root: &Path) -> Outcome {
    all(root, true)
}

/// Sees to it that the judges have their Python.
pub(crate) fn fetch(root: &Path) -> Result<(), String> {
    packages(root).map(|_| ())
}

fn all(root: &Path, with_times: bool) -> Outcome {
    let python = match packages(root) {
        Ok(python) => python,
        Err(reason) => return skipped(&reason),
    };
    let folder = root.join("target/judge");
    if let Err(error) = std::fs::create_dir_all(&folder) {
        return Outcome::of(vec![format!("{}: {error}", folder.display())]);
    }
    let mut sum = Outcome::default();
    for (example, script) in JUDGES {
        let cases = folder.join(example).with_extension("json");
        let is_untimed = TIMED.contains(&example) && !with_times;
        let one = match cargo::run_example(root, example, &[&cases.display().to_string()]) {
            Ok(()) => {
                let mut judge = script_of(root, &python, script);
                judge.args(is_untimed.then_some("--untimed")).arg(&cases);
                verdict(judge)
            }
            Err(complaint) => Outcome::of(vec![complaint]),
        };
        sum.add(one);
    }
    match cargo::the_command(root) {
        Ok(program) => {
            sum.add(poseless_by(root, &python, (&program, &["--ten"])));
            let mut judge = script_of(root, &python, CAPABILITY);
            judge.arg(&program).arg(root.join(ROBOTS));
            sum.add(verdict(judge));
            let mut judge = script_of(root, &python, FRICTION.0);
            judge.arg(&program).arg(root.join(FRICTION.1));
            sum.add(verdict(judge));
        }
        Err(complaint) => sum.add(Outcome::of(vec![complaint])),
    }
    sum
}

/// Judges calibrations without measured poses by a command, on the records of as many seeds from a first one on.
pub(crate) fn poseless(root: &Path, program: &Path, (first, count): (u64, u64)) -> Outcome {
    let python = match packages(root) {
        Ok(python) => python,
        Err(reason) => return skipped(&reason),
    };
    let mut outcome = poseless_by(root, &python, (program, &["--seeds", &first.to_string(), &count.to_string()]));
    if outcome.failed > 0 {
        let again = format!("cargo xtask soak --poseless {count} --seed {first}");
        outcome.complaints.push(format!("calibrations without poses: {} failures; again: {again}", outcome.failed));
    }
    outcome
}

fn poseless_by(root: &Path, python: &Path, (program, words): (&Path, &[&str])) -> Outcome {
    let mut judge = script_of(root, python, POSELESS);
    judge.arg(program).args(words);
    verdict(judge)
}

fn script_of(root: &Path, python: &Path, script: &str) -> Command {
    let mut command = Command::new(python);
    command.arg("-B").arg(root.join(script)).stdin(Stdio::null()).stderr(Stdio::inherit());
    command
}

/// Runs a judge, shows its table, and counts its verdicts.
fn verdict(mut command: Command) -> Outcome {
    let output = match command.output() {
        Ok(output) => output,
        Err(error) => return Outcome::of(vec![format!("cannot start {command:?}: {error}")]),
    };
    let table = String::from_utf8_lossy(&output.stdout);
    print!("{table}");
    let counted = table.lines().last().and_then(counts);
    match counted {
        Some((passed, failed)) if output.status.success() == (failed == 0) => {
            Outcome { passed, failed, complaints: Vec::new() }
        }
        _ => Outcome::of(vec![format!("the judge ended with {} and without a verdict", output.status)]),
    }
}

/// Counts in the closing line `judged: 12 passed, 0 failed`.
fn counts(line: &str) -> Option<(usize, usize)> {
    let (passed, failed) = line.strip_prefix("judged: ")?.split_once(" passed, ")?;
    Some((passed.parse().ok()?, failed.strip_suffix(" failed")?.parse().ok()?))
}

/// Python with the packages of the judges.
fn packages(root: &Path) -> Result<PathBuf, String> {
    environments::with_packages(root, "judges/mujoco/requirements.txt", "target/judge-venv")
}

/// Nobody was asked: a failure in CI, where somebody relies on it.
fn skipped(reason: &str) -> Outcome {
    println!("the judges are skipped: {reason}");
    if std::env::var("CI").as_deref() == Ok("true") {
        return Outcome::of(vec![format!("CI must not skip the judges: {reason}")]);
    }
    Outcome::default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn verdicts_are_counted_from_the_closing_line() {
        assert_eq!(counts("judged: 25 passed, 2 failed"), Some((25, 2)));
        assert_eq!(counts("Traceback (most recent call last):"), None);
    }
}
