//! Programs of the machine: looked for on the search path, installed where a container of CI lacks them.

use std::path::PathBuf;
use std::process::{Command, Stdio};

/// The program of this name on the search path.
pub(crate) fn on_path(name: &str) -> Option<PathBuf> {
    let folders = std::env::var_os("PATH")?;
    std::env::split_paths(&folders).map(|folder| folder.join(name)).find(|path| path.is_file())
}

/// Whether Debian's packages can be installed: as root, as in a container of CI.
pub(crate) fn can_install() -> bool {
    let user = Command::new("id").arg("-u").output().map(|output| output.stdout).unwrap_or_default();
    user.trim_ascii() == b"0" && on_path("apt-get").is_some()
}

/// Installs packages of Debian.
pub(crate) fn install(packages: &[&str]) -> Result<(), String> {
    println!("installing Debian's {}", packages.join(", "));
    let apt = |arguments: &[&str]| {
        let mut command = Command::new("apt-get");
        command.args(arguments).env("DEBIAN_FRONTEND", "noninteractive").stdout(Stdio::null());
        run(command)
    };
    apt(&["update"])?;
    apt(&[&["install", "-y", "--no-install-recommends"], packages].concat())
}

/// Runs a command that must succeed; its output goes to the terminal.
pub(crate) fn run(mut command: Command) -> Result<(), String> {
    let name = format!("{command:?}").replace('"', "");
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("`{name}` ended with {status}")),
        Err(error) => Err(format!("cannot start `{name}`: {error}")),
    }
}

/// Runs a command that must succeed, and gives what it wrote to stdout.
pub(crate) fn output(mut command: Command) -> Result<String, String> {
    let name = format!("{command:?}").replace('"', "");
    let output = command.output().map_err(|error| format!("cannot start `{name}`: {error}"))?;
    match output.status.success() {
        true => Ok(String::from_utf8_lossy(&output.stdout).into_owned()),
        false => Err(format!("`{name}` failed: {}", String::from_utf8_lossy(&output.stderr).trim())),
    }
}
