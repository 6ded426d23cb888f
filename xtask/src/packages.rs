//! The Rust packages that are linked into the command and into the module of Python, and their licences.

use std::path::{Path, PathBuf};

use crate::{cargo, programs};

/// Systems whose packages are listed: a list of one machine would differ on the next.
const TARGETS: [&str; 4] =
    ["x86_64-unknown-linux-gnu", "aarch64-unknown-linux-gnu", "aarch64-apple-darwin", "x86_64-pc-windows-msvc"];

/// A licence that goes with ours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Licence {
    Mit,
    Apache,
    /// Terms of its own, which ask for no more than to be shown.
    Own,
}

/// A licence that adds terms to one of ours, looked at by a person, and the file with these terms.
const BESIDES: [(&str, Licence, &str); 2] = [
    ("(Apache-2.0 OR MIT) AND BSD-3-Clause", Licence::Mit, "LICENSE-WHATWG"),
    ("BSD-2-Clause", Licence::Own, "LICENSE"),
];

/// A package whose licence does not name the terms of a part of it, looked at by a person, and the file with these terms.
const PARTS: [(&str, &str); 1] = [("sobol_burley", "licenses/JOE_KUO.txt")];

/// A package of the registry.
#[derive(Clone, Debug)]
pub(crate) struct Package {
    /// Name and version with a space between.
    pub(crate) title: String,
    /// The licence we take it under.
    pub(crate) licence: Licence,
    /// Where its sources are.
    pub(crate) folder: PathBuf,
    /// The file with terms beside those of the licence.
    pub(crate) besides: Option<&'static str>,
}

/// All packages linked into the command and the module of Python, which has those of the command and its own, by name; complains of licences outside the list.
pub(crate) fn linked(root: &Path) -> Result<Vec<Package>, String> {
    let mut arguments = vec!["tree", "--locked", "--package", "cdpr-python", "--edges", "normal,no-proc-macro"];
    arguments.extend(["--prefix", "none", "--format", "{p}|{l}"]);
    TARGETS.iter().for_each(|target| arguments.extend(["--target", *target]));
    let tree = programs::output(cargo::command(root, &arguments))?;
    let metadata = programs::output(cargo::command(root, &["metadata", "--locked", "--format-version", "1"]))?;
    let folders = folders(&metadata);
    let (mut packages, mut refused) = (Vec::new(), Vec::new());
    for (name, version, licences) in listed(&tree) {
        let title = format!("{name} {version}");
        let looked_at = BESIDES.iter().find(|(name, ..)| *name == licences);
        let Some(licence) = looked_at.map(|(_, licence, _)| *licence).or_else(|| chosen(licences)) else {
            refused.push(format!("{title} has the licence `{licences}`, which nobody has looked at"));
            continue;
        };
        let manifest = format!("/{name}-{version}");
        let folder = folders.iter().find(|folder| folder.to_string_lossy().replace('\\', "/").ends_with(&manifest));
        let folder = folder.ok_or_else(|| format!("cargo does not say where {title} is"))?.clone();
        let of_part = PARTS.iter().find(|(package, _)| *package == name).map(|(_, file)| *file);
        let besides = looked_at.map(|(.., file)| *file).or(of_part);
        packages.push(Package { title, licence, folder, besides });
    }
    if refused.is_empty() { Ok(packages) } else { Err(refused.join("\n")) }
}

/// Name, version and licences of the lines of `cargo tree`, sorted, without the packages of the workspace.
fn listed(tree: &str) -> Vec<(&str, &str, &str)> {
    let mut packages: Vec<_> = tree
        .lines()
        .filter_map(|line| {
            let (package, licences) = line.split_once('|')?;
            let (name, version) = package.split_once(" v")?;
            let licences = licences.trim_end_matches("(*)").trim();
            (!version.contains(' ')).then_some((name, version, licences))
        })
        .collect();
    packages.sort_unstable();
    packages.dedup();
    packages
}

/// The folders of all packages, from the paths of their manifests.
fn folders(metadata: &str) -> Vec<PathBuf> {
    let paths = metadata.split("\"manifest_path\":\"").skip(1).filter_map(|rest| rest.split_once('"'));
    paths.filter_map(|(path, _)| Some(Path::new(&path.replace("\\\\", "\\")).parent()?.to_owned())).collect()
}

/// MIT where it is offered, else Apache-2.0, else none: also for `A AND B`, which has to be read by a person.
fn chosen(licences: &str) -> Option<Licence> {
    let offered: Vec<&str> = licences.split(" OR ").flat_map(|part| part.split('/')).map(str::trim).collect();
    if offered.contains(&"MIT") {
        Some(Licence::Mit)
    } else if offered.contains(&"Apache-2.0") {
        Some(Licence::Apache)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_licence_is_chosen_only_among_those_offered() {
        for (licences, expected) in [
            ("MIT OR Apache-2.0", Some(Licence::Mit)),
            ("Unlicense/MIT", Some(Licence::Mit)),
            ("Apache-2.0 OR BSL-1.0", Some(Licence::Apache)),
            ("Apache-2.0 WITH LLVM-exception", None),
            ("(MIT OR Apache-2.0) AND Unicode-3.0", None),
            ("GPL-3.0-only", None),
            ("", None),
        ] {
            assert_eq!(chosen(licences), expected, "{licences}");
        }
    }

    #[test]
    fn packages_of_the_workspace_and_repetitions_are_not_listed() {
        let tree = "cdpr v0.1.0 (/here/cdpr)|MIT\nserde v1.0.2|MIT OR Apache-2.0\n\nabc v2.0.0|MIT\nserde v1.0.2|MIT OR Apache-2.0 (*)\n";
        assert_eq!(listed(tree), [("abc", "2.0.0", "MIT"), ("serde", "1.0.2", "MIT OR Apache-2.0")]);
    }
}
