//! The completions of bash, zsh and fish, as those shells propose them.

use std::collections::BTreeSet;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::cargo;
use crate::outcome::Outcome;
use crate::programs::{can_install, install, on_path, output};

/// A shell, and the script in its language that prints the words it proposes for a line.
struct Shell {
    name: &'static str,
    arguments: &'static [&'static str],
    asks: &'static str,
}

const SHELLS: [Shell; 3] = [
    Shell { name: "bash", arguments: &["--norc"], asks: include_str!("shells/ask.bash") },
    Shell { name: "zsh", arguments: &["-f"], asks: include_str!("shells/ask.zsh") },
    Shell { name: "fish", arguments: &["--no-config"], asks: include_str!("shells/ask.fish") },
];

/// A line, words that are proposed for it (whole, or the part after the last `=` or `:`, from which bash goes on), and
/// words that are not.
type Case = (&'static str, &'static [&'static str], &'static [&'static str]);

const CASES: &[Case] = &[
    ("cdpr iden", &["identify"], &["fk"]),
    ("cdpr fk ", &["planar-example", "own robot.toml", "folder"], &["data.csv", "--lengths"]),
    ("cdpr fk --mod", &["--model"], &["--lengths"]),
    ("cdpr ik cogiro --model pulley+e", &["pulley+elastic"], &["pulley"]),
    ("cdpr ik cogiro --model=pulley+e", &["--model=pulley+elastic"], &[]),
    ("cdpr identify r d --free frame-anchor[1,2],length-o", &["frame-anchor[1,2],length-offset"], &[]),
    ("cdpr workspace cogiro --criterion wrench-set-feasible:fo", &["wrench-set-feasible:force="], &[]),
    ("cdpr select r d --candidates 'standard;pulley:len", &["standard;pulley:length-offset"], &[]),
    ("cdpr explain csv::ragged", &["csv::ragged-row"], &[]),
    ("cdpr study s.toml --out ", &["folder"], &["data.csv", "own robot.toml"]),
    ("cdpr identify r d --out=da", &["--out=data.csv"], &[]),
];

/// Asks every shell that is there or can be installed.
pub(crate) fn check(root: &Path) -> Outcome {
    let missing = fetch().err();
    if let Some(reason) = &missing {
        println!("completions are not tried in every shell: {reason}");
    }
    let found = cargo::the_command(root).and_then(|command| try_all(root, &command));
    let mut outcome = found.unwrap_or_else(|complaint| Outcome::of(vec![complaint]));
    if let (Some(reason), Ok("true")) = (missing, std::env::var("CI").as_deref()) {
        outcome.add(Outcome::of(vec![format!("CI must not skip a shell: {reason}")]));
    }
    outcome
}

/// Sees to it that all shells are there.
pub(crate) fn fetch() -> Result<(), String> {
    let missing: Vec<&str> = SHELLS.iter().map(|shell| shell.name).filter(|name| on_path(name).is_none()).collect();
    match missing.as_slice() {
        [] => Ok(()),
        _ if can_install() => install(&missing),
        _ => Err(format!("there is no {}; install it", missing.join(", no "))),
    }
}

/// The words of every case in every shell that is there.
fn try_all(root: &Path, command: &Path) -> Result<Outcome, String> {
    let place = Place::made(root.join("target/shells"), command)?;
    let mut outcome = Outcome::default();
    for shell in SHELLS.iter().filter(|shell| on_path(shell.name).is_some()) {
        let mut printed = Command::new(command);
        printed.args(["completions", shell.name]);
        place.write(shell.name, &output(printed)?)?;
        place.write(&format!("ask.{}", shell.name), shell.asks)?;
        for case in CASES {
            let proposed = place.asked(shell, case.0)?;
            outcome.add(Outcome::of(complaint(shell, case, &proposed).into_iter().collect()));
        }
    }
    Ok(outcome)
}

/// Difference between what a shell proposes and what it should; `None` if there is none.
fn complaint(shell: &Shell, (line, expected, refused): &Case, proposed: &BTreeSet<String>) -> Option<String> {
    let has = |word: &&&str| {
        let is_it = |found: &String| {
            word.strip_suffix(found.as_str()).is_some_and(|kept| kept.is_empty() || kept.ends_with(['=', ':']))
        };
        proposed.iter().any(is_it)
    };
    let wrong: Vec<String> = (expected.iter().filter(|word| !has(word)).map(|word| format!("no `{word}`")))
        .chain(refused.iter().filter(has).map(|word| format!("`{word}`")))
        .collect();
    let list = || proposed.iter().map(String::as_str).collect::<Vec<_>>().join(", ");
    (!wrong.is_empty()).then(|| format!("{} proposes {} for `{line}`, but {}", shell.name, wrong.join(" and "), list()))
}

/// Folder of the scripts, with the folder `work` that the shells stand in.
struct Place {
    scripts: PathBuf,
    work: PathBuf,
    /// The search path, with the command that is tried before others.
    path: OsString,
}

impl Place {
    fn made(scripts: PathBuf, command: &Path) -> Result<Self, String> {
        let folders = std::env::var_os("PATH").unwrap_or_default();
        let own = command.parent().map(Path::to_path_buf);
        let path = std::env::join_paths(own.into_iter().chain(std::env::split_paths(&folders)));
        let path = path.map_err(|error| error.to_string())?;
        let place = Self { work: scripts.join("work"), scripts, path };
        let folder = place.work.join("folder");
        std::fs::create_dir_all(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        place.write("work/own robot.toml", "")?;
        place.write("work/data.csv", "")?;
        Ok(place)
    }

    fn write(&self, name: &str, text: &str) -> Result<(), String> {
        let path = self.scripts.join(name);
        std::fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))
    }

    /// Words that a shell proposes for a line, without what it quotes them by.
    fn asked(&self, shell: &Shell, line: &str) -> Result<BTreeSet<String>, String> {
        let mut command = Command::new(shell.name);
        command.args(shell.arguments).arg(self.scripts.join(format!("ask.{}", shell.name)));
        command.arg(self.scripts.join(shell.name)).arg(line);
        // nobody's own settings
        command.env("PATH", &self.path).env("HOME", &self.work).env_remove("ZDOTDIR").env_remove("XDG_CONFIG_HOME");
        command.current_dir(&self.work).stdin(Stdio::null());
        let printed = output(command)?;
        Ok(printed.lines().map(|word| word.replace('\\', "").trim_end_matches('/').to_owned()).collect())
    }
}
