//! Licences and sources of all packages of Cargo.lock against deny.toml, which cargo-deny reads too.

use std::path::Path;

use toml::{Table, Value};

use crate::expression::is_allowed;
use crate::metadata::{self, Package};

const FILE: &str = "deny.toml";

/// Complaints about packages under other licences than deny.toml allows, and about licences there that no package has.
pub(crate) fn check(root: &Path) -> Result<Vec<String>, String> {
    let path = root.join(FILE);
    let text = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let rules = Rules::read(&text)?;
    let packages = metadata::packages(root, false)?;
    println!("{} packages, licences allowed by {FILE}: {}", packages.len(), rules.allowed.join(", "));
    Ok(complaints(&rules, &packages))
}

/// Licences that everybody, or one package, may have.
struct Rules {
    allowed: Vec<String>,
    exceptions: Vec<(String, Vec<String>)>,
}

impl Rules {
    fn read(text: &str) -> Result<Self, String> {
        let table: Table = text.parse().map_err(|error| format!("{FILE}: {error}"))?;
        let names = |list: &Value| -> Option<Vec<String>> {
            list.as_array()?.iter().map(|name| name.as_str().map(str::to_owned)).collect()
        };
        let licences = table.get("licenses").and_then(Value::as_table);
        let allowed = licences.and_then(|licences| names(licences.get("allow")?));
        let allowed = allowed.ok_or_else(|| format!("{FILE} lacks a list `allow` of names in `[licenses]`"))?;
        let exceptions = licences.and_then(|licences| licences.get("exceptions")?.as_array());
        let exception = |entry: &Value| Some((entry.get("crate")?.as_str()?.to_owned(), names(entry.get("allow")?)?));
        let exceptions: Option<Vec<_>> = exceptions.into_iter().flatten().map(exception).collect();
        let exceptions = exceptions.ok_or_else(|| format!("{FILE}: an exception lacks `crate` or `allow`"))?;
        Ok(Self { allowed, exceptions })
    }
}

fn complaints(rules: &Rules, packages: &[Package]) -> Vec<String> {
    let mut complaints = Vec::new();
    for package in packages {
        let own = rules.exceptions.iter().filter(|(name, _)| *name == package.text("name"));
        let allowed: Vec<&str> =
            rules.allowed.iter().chain(own.flat_map(|(_, names)| names)).map(String::as_str).collect();
        let (title, licence, source) = (package.title(), package.text("license"), package.text("source"));
        match is_allowed(licence, &allowed) {
            Ok(true) => {}
            Ok(false) => complaints.push(format!(
                "{title} is under `{licence}`, which {FILE} does not allow; take another one, or let a person read it"
            )),
            Err(message) => complaints.push(format!("{title}: {message}")),
        }
        if !source.is_empty() && !source.starts_with("registry+") {
            complaints.push(format!("{title} comes from {source}; packages come from the registry alone"));
        }
    }
    let is_met = |licence: &&String| packages.iter().any(|package| package.text("license").contains(licence.as_str()));
    let unmet = rules.allowed.iter().filter(|licence| !is_met(licence));
    complaints.extend(unmet.map(|licence| format!("{FILE} allows `{licence}`, which no package has; take it out")));
    let is_there = |name: &str| packages.iter().any(|package| package.text("name") == name);
    let gone = rules.exceptions.iter().filter(|(name, _)| !is_there(name));
    complaints.extend(
        gone.map(|(name, _)| format!("{FILE} has an exception for {name}, which no package uses; take it out")),
    );
    complaints
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    const RULES: &str = "[licenses]\nallow = [\"MIT\"]\nexceptions = [{ crate = \"b\", allow = [\"BSD-3-Clause\"] }]\n";

    fn package(name: &str, license: &str, source: &str) -> Package {
        Package(json!({"name": name, "version": "1.0.0", "license": license, "source": source}))
    }

    #[test]
    fn an_exception_is_for_its_package_alone() {
        let rules = Rules::read(RULES).unwrap();
        let of = |name: &str| {
            let registry = "registry+index";
            let packages =
                [package("a", "MIT", registry), package("b", "MIT", registry), package(name, "BSD-3-Clause", "")];
            complaints(&rules, &packages).len()
        };
        assert_eq!([of("b"), of("c")], [0, 1]);
    }

    #[test]
    fn sources_elsewhere_and_rules_without_use_are_told() {
        let rules = Rules::read(RULES).unwrap();
        assert_eq!(complaints(&rules, &[package("b", "MIT", "git+elsewhere")]).len(), 1);
        assert_eq!(complaints(&rules, &[package("a", "BSD-3-Clause", "")]).len(), 3);
    }

    #[test]
    fn a_list_that_is_missing_is_named() {
        assert!(Rules::read("[bans]\n").is_err_and(|message| message.contains("`allow`")));
        assert!(Rules::read("[licenses]\nallow = [\"MIT\"]\nexceptions = [{ crate = \"b\" }]\n").is_err());
    }
}
