//! Virtual environments of Python.

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::programs::{can_install, install, on_path, run};

/// Python of a virtual environment with the packages of a list, made in a folder where it is missing or was made for another list.
pub(crate) fn with_packages(root: &Path, requirements: &str, folder: &str) -> Result<PathBuf, String> {
    let (requirements, folder) = (root.join(requirements), root.join(folder));
    let (python, stamp) = (folder.join("bin/python"), folder.join("installed-requirements.txt"));
    let read = |path: &Path| std::fs::read(path).ok();
    if python.exists() && read(&stamp).is_some() && read(&stamp) == read(&requirements) {
        return Ok(python);
    }
    if run(create(&folder)).is_err() {
        if !can_install() {
            return Err("there is no Python 3 with its module venv; install python3 and python3-venv".to_owned());
        }
        install(&["python3", "python3-venv"])?;
        run(create(&folder))?;
    }
    pip(&python, &["--requirement", &requirements.display().to_string()])
        .map_err(|error| format!("the packages of {} cannot be installed: {error}", requirements.display()))?;
    std::fs::copy(&requirements, &stamp).map_err(|error| format!("{}: {error}", stamp.display()))?;
    Ok(python)
}

/// Python of a new environment in a folder; `None` where there is no Python 3 with its module venv.
pub(crate) fn new(folder: &Path) -> Option<PathBuf> {
    run(create(folder)).ok().map(|()| folder.join("bin/python"))
}

/// Installs packages into the environment of a Python.
pub(crate) fn pip(python: &Path, words: &[&str]) -> Result<(), String> {
    let mut command = Command::new(python);
    command.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check"]).args(words);
    run(command)
}

fn create(folder: &Path) -> Command {
    let python = on_path("python3").unwrap_or_else(|| "python3".into());
    let mut command = Command::new(python);
    command.args(["-m", "venv", "--clear"]).arg(folder).stdin(Stdio::null()).stdout(Stdio::null());
    command
}
