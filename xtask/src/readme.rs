//! Commands of README.md, each as it stands there, in a folder of its own.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::outcome::Outcome;
use crate::{cargo, programs};

/// The page at the root.
const FILE: &str = "README.md";

/// Beginnings of commands that are not run, with the reason.
const NOT_RUN: [(&str, &str); 2] =
    [("git clone ", "the clone is here"), ("cargo xtask dist", "the packages were made the same way")];

/// Beginnings of commands of cargo, and what sends them to the clone and keeps what they install under target/.
const OF_CARGO: [(&str, &str); 2] = [
    ("cargo run --release -- ", "cargo run --quiet --release --manifest-path {root}/Cargo.toml -- "),
    (
        "cargo install --locked --path crates/cdpr-cli",
        "cargo install --quiet --locked --offline --path {root}/crates/cdpr-cli --root installed",
    ),
];

/// Files of the user's own that a command reads: the one that makes it, for a virtual machine.
const OF_USERS: [(&str, &str); 1] = [("measurements.csv", "cdpr simulate my-robot/study.toml --out measurements.csv")];

/// Runs the commands in a folder with packages in `dist/`, with the program `cdpr`, and with pip where there is one.
pub(crate) fn check(root: &Path, folder: &Path, python: Option<&Path>) -> Outcome {
    let text = match std::fs::read_to_string(root.join(FILE)) {
        Ok(text) => text,
        Err(error) => return Outcome::of(vec![format!("{FILE}: {error}")]),
    };
    let commands = commands(&text);
    if commands.is_empty() {
        return Outcome::of(vec![format!("{FILE} has no line `$ …` in a block of the language console")]);
    }
    let mut sum = Outcome::default();
    for command in commands {
        sum.add(match how(command, root, python.is_some()) {
            Ok(shell) => Outcome::of(run(root, folder, python, &shell).err().into_iter().collect()),
            Err(reason) => {
                println!("{FILE}: not run, as {reason}: {command}");
                Outcome::default()
            }
        });
    }
    sum
}

/// Commands of the page, without their remarks.
fn commands(text: &str) -> Vec<&str> {
    let blocks = text.split("```console\n").skip(1).filter_map(|rest| rest.split("```").next());
    let lines = blocks.flat_map(str::lines).filter_map(|line| line.strip_prefix("$ "));
    lines.map(|line| line.split(" #").next().unwrap_or(line).trim_end()).collect()
}

/// Words for the shell; the reason where nothing is run.
fn how(command: &str, root: &Path, has_pip: bool) -> Result<String, String> {
    if let Some((_, reason)) = NOT_RUN.iter().find(|(start, _)| command.starts_with(start)) {
        return Err((*reason).to_owned());
    }
    if command.starts_with("pip ") && !has_pip {
        return Err("there is no pip".to_owned());
    }
    let cargo = OF_CARGO.iter().find_map(|(start, there)| Some((there, command.strip_prefix(start)?)));
    let command = cargo.map_or_else(
        || command.to_owned(),
        |(there, rest)| there.replace("{root}", &root.display().to_string()) + rest,
    );
    let files = OF_USERS.iter().filter(|(file, _)| command.contains(file)).map(|(_, makes)| format!("{makes} && "));
    Ok(files.collect::<String>() + &command)
}

fn run(root: &Path, folder: &Path, python: Option<&Path>, shell: &str) -> Result<(), String> {
    let programs = [python.and_then(Path::parent).map(PathBuf::from), Some(cargo::built(root, "release", ""))];
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(programs.into_iter().flatten().chain(std::env::split_paths(&path)));
    let path = path.map_err(|error| format!("PATH: {error}"))?;
    let mut command = Command::new("sh");
    command.args(["-c", shell]).current_dir(folder).env("PATH", path);
    // no question to a registry: the package is the one in the folder
    command.env("PIP_NO_INDEX", "1").env("PIP_DISABLE_PIP_VERSION_CHECK", "1");
    println!("$ {shell}");
    programs::output(command).map(|_| ()).map_err(|error| format!("a command of {FILE} does not work: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commands_are_lines_of_consoles_without_remarks() {
        let text =
            "```console\n$ cdpr demo   # all of it\nits answer\n```\n$ prose\n```console\n$ cdpr check a.toml\n```\n";
        assert_eq!(commands(text), ["cdpr demo", "cdpr check a.toml"]);
    }

    #[test]
    fn commands_of_cargo_are_sent_to_the_clone_and_files_of_users_are_made() {
        let how = |command: &str| how(command, Path::new("/clone"), false);
        assert!(how("cargo run --release -- demo").is_ok_and(|shell| shell.ends_with("/clone/Cargo.toml -- demo")));
        assert!(how("cdpr select a.toml measurements.csv").is_ok_and(|shell| shell.starts_with("cdpr simulate ")));
        assert!(how("pip install dist/*.whl").is_err() && how("git clone X cdpr && cd cdpr").is_err());
    }
}
