//! Files that go into packages, with their bytes.

use std::path::Path;
use std::process::Command;

use crate::platform;

/// A file of a package.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Packed {
    /// Place in the package, with slashes.
    pub(crate) path: String,
    /// Content.
    pub(crate) bytes: Vec<u8>,
    /// True of programs.
    pub(crate) is_program: bool,
}

impl Packed {
    /// A file that is only read.
    pub(crate) fn data(path: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { path: path.into(), bytes: bytes.into(), is_program: false }
    }

    /// A file that is started.
    pub(crate) fn program(path: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { is_program: true, ..Self::data(path, bytes) }
    }

    /// Bits of Unix: who may read, write and start it.
    pub(crate) fn mode(&self) -> u32 {
        if self.is_program { 0o755 } else { 0o644 }
    }
}

/// Seconds since 1970 that all files of packages have: 1980-01-01, the first day that a zip archive can state.
pub(crate) const TIME: u64 = 315_532_800;

/// Licences of the command and of what is linked into it; place in the clone, name in a package.
pub(crate) const LICENCES: [(&str, &str); 4] = [
    ("LICENSE-APACHE", "LICENSE-APACHE"),
    ("LICENSE-MIT", "LICENSE-MIT"),
    ("THIRD-PARTY.txt", "THIRD-PARTY.txt"),
    ("crates/cdpr-model/robots/NOTICE.md", "ROBOTS-NOTICE.md"),
];

/// Pages besides the licences.
const PAGES: [&str; 3] = ["CHANGELOG.md", "CITATION.cff", "README.md"];

/// A shell and the name by which it finds its completions.
const SHELLS: [(&str, &str); 5] = [
    ("bash", "cdpr.bash"),
    ("elvish", "cdpr.elv"),
    ("fish", "cdpr.fish"),
    ("powershell", "_cdpr.ps1"),
    ("zsh", "_cdpr"),
];

/// Contents of the packages.
#[derive(Debug)]
pub(crate) struct Contents {
    /// Version of the command.
    pub(crate) version: String,
    /// Target that the command is for, as rustc calls it.
    pub(crate) target: String,
    /// The program.
    pub(crate) program: Packed,
    /// Licences by their names in a package.
    pub(crate) licences: Vec<Packed>,
    /// README, changes, citation.
    pub(crate) pages: Vec<Packed>,
    /// Completions and man pages, by their places in the archive.
    pub(crate) helps: Vec<Packed>,
}

impl Contents {
    /// Reads the clone, and asks the command for its version, completions and man pages.
    pub(crate) fn read(root: &Path, command: &Path) -> Result<Self, String> {
        let program = read(command)?;
        let target = platform::target(&program)?;
        let words = output(command, &["--version"])?;
        let words = String::from_utf8_lossy(&words).trim().to_owned();
        let version = words.strip_prefix("cdpr ").filter(|version| *version == env!("CARGO_PKG_VERSION"));
        let version = version.ok_or_else(|| {
            let (path, expected) = (command.display(), env!("CARGO_PKG_VERSION"));
            format!("{path} says that it is `{words}`, not `cdpr {expected}`; build it again: cargo build --release")
        })?;
        let of_clone = |(path, name): (&str, &str)| Ok(Packed::data(name, read(&root.join(path))?));
        Ok(Self {
            version: version.to_owned(),
            target,
            program: Packed::program(format!("cdpr{}", std::env::consts::EXE_SUFFIX), program),
            licences: LICENCES.into_iter().map(of_clone).collect::<Result<_, String>>()?,
            pages: PAGES.into_iter().map(|page| of_clone((page, page))).collect::<Result<_, String>>()?,
            helps: helps(command)?,
        })
    }
}

/// Completions of every shell and the man page of every command.
fn helps(command: &Path) -> Result<Vec<Packed>, String> {
    let completions = SHELLS.iter().map(|(shell, name)| {
        Ok(Packed::data(format!("completions/{name}"), output(command, &["completions", shell])?))
    });
    let mut helps = completions.collect::<Result<Vec<_>, String>>()?;
    let folder = std::env::temp_dir().join(format!("cdpr-man-{}", std::process::id()));
    let pages = output(command, &["man", "--out", &folder.display().to_string()]).and_then(|_| man_pages(&folder));
    // a folder of our own: what stays there after an error is in nobody's way
    let _ = std::fs::remove_dir_all(&folder);
    helps.extend(pages?);
    Ok(helps)
}

fn man_pages(folder: &Path) -> Result<Vec<Packed>, String> {
    let entries = std::fs::read_dir(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    let page = |entry: std::io::Result<std::fs::DirEntry>| {
        let entry = entry.map_err(|error| format!("{}: {error}", folder.display()))?;
        Ok(Packed::data(format!("man/man1/{}", entry.file_name().to_string_lossy()), read(&entry.path())?))
    };
    entries.map(page).collect()
}

fn output(command: &Path, words: &[&str]) -> Result<Vec<u8>, String> {
    let name = format!("{} {}", command.display(), words.join(" "));
    let output = Command::new(command).args(words).output();
    let output = output.map_err(|error| format!("cannot start `{name}`: {error}"))?;
    match output.status.success() {
        true => Ok(output.stdout),
        false => Err(format!("`{name}` failed: {}", String::from_utf8_lossy(&output.stderr).trim())),
    }
}

fn read(path: &Path) -> Result<Vec<u8>, String> {
    std::fs::read(path).map_err(|error| format!("cannot read {}: {error}", path.display()))
}
