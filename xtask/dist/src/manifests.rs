//! Manifests of published crates: required entries and allowed dependencies.

use std::path::Path;

use serde_json::Value;

use crate::includes;
use crate::metadata::{self, Package};

/// Texts that a registry asks for or shows.
const TEXTS: [&str; 3] = ["description", "license", "readme"];

/// Lists that a registry sorts crates by.
const LISTS: [&str; 2] = ["keywords", "categories"];

/// Most entries of such a list, as crates.io has it.
const MOST: usize = 5;

/// Files beside the manifest that go into the package of a crate.
const LICENCES: [&str; 2] = ["LICENSE-APACHE", "LICENSE-MIT"];

/// Complaints about the manifests of the workspace and the files that published crates include.
pub(crate) fn check(root: &Path) -> Result<Vec<String>, String> {
    let packages = metadata::packages(root, true)?;
    let published: Vec<&Package> = packages.iter().filter(|package| package.is_published()).collect();
    let mut complaints = of_manifests(&packages);
    for package in &published {
        let folder = package.folder();
        let files = LICENCES.into_iter().chain([package.text("readme")]).filter(|file| !file.is_empty());
        let lacking = files.filter(|file| !folder.join(file).is_file());
        complaints.extend(lacking.map(|file| format!("{}: there is no file {file}", package.text("name"))));
        complaints.extend(includes::leaving(&folder)?);
    }
    let names: Vec<&str> = published.iter().map(|package| package.text("name")).collect();
    println!("{} crates are published: {}", names.len(), names.join(", "));
    Ok(complaints)
}

fn of_manifests(packages: &[Package]) -> Vec<String> {
    let published = packages.iter().filter(|package| package.is_published());
    let told = |package: &Package| {
        let name = package.text("name").to_owned();
        let complaints = lacking(package).into_iter().chain(dependencies(package, packages));
        complaints.map(move |complaint| format!("{name}: {complaint}")).collect::<Vec<_>>()
    };
    published.flat_map(told).collect()
}

/// Keys that a published crate lacks.
fn lacking(package: &Package) -> Vec<String> {
    let texts = TEXTS.iter().filter(|key| package.text(key).is_empty());
    let mut complaints: Vec<String> = texts.map(|key| format!("its Cargo.toml lacks `{key}`")).collect();
    for key in LISTS {
        let count = package.list(key).len();
        if !(1..=MOST).contains(&count) {
            complaints.push(format!("its Cargo.toml has {count} `{key}`; 1 to {MOST} are needed"));
        }
    }
    let is_library = package.list("targets").iter().any(|target| target["kind"][0] == "lib");
    if is_library && package.0["metadata"]["docs"]["rs"].is_null() {
        complaints
            .push("its Cargo.toml lacks `[package.metadata.docs.rs]` with the features that docs.rs shows".to_owned());
    }
    complaints
}

/// Dependencies on crates of the workspace that a registry would refuse or that would mix versions.
fn dependencies(package: &Package, packages: &[Package]) -> Vec<String> {
    let complaint = |dependency: &Value| {
        let (name, wish) = (dependency["name"].as_str()?, dependency["req"].as_str()?);
        let other = packages.iter().find(|package| package.text("name") == name && !dependency["path"].is_null())?;
        let exact = format!("={}", other.text("version"));
        match (other.is_published(), dependency["kind"] == "dev") {
            (true, _) if wish == exact => None,
            (true, _) => Some(format!("asks for {name} `{wish}`; versions between our crates are exact: `{exact}`")),
            (false, true) if wish == "*" => None,
            (false, true) => Some(format!(
                "asks for {name} `{wish}` in its tests; a crate that is not published has no version there"
            )),
            (false, false) => Some(format!("depends on {name}, which is not published")),
        }
    };
    package.list("dependencies").iter().filter_map(complaint).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn package(name: &str, rest: Value) -> Package {
        let mut package = json!({
            "name": name, "version": "0.1.0", "description": "d", "license": "MIT", "readme": "README.md",
            "keywords": ["k"], "categories": ["c"], "targets": [{"kind": ["lib"]}],
            "metadata": {"docs": {"rs": {"all-features": true}}},
        });
        rest.as_object().unwrap().iter().for_each(|(key, value)| package[key] = value.clone());
        Package(package)
    }

    fn on(name: &str, wish: &str, kind: Value) -> Value {
        json!({"dependencies": [{"name": name, "req": wish, "path": "/x", "kind": kind}]})
    }

    #[test]
    fn a_whole_manifest_passes_and_every_key_is_missed() {
        assert!(of_manifests(&[package("a", json!({}))]).is_empty());
        for key in ["description", "license", "readme", "keywords", "categories", "metadata"] {
            assert_eq!(of_manifests(&[package("a", json!({ key: null }))]).len(), 1, "{key}");
            assert!(of_manifests(&[package("a", json!({ key: null, "publish": [] }))]).is_empty(), "{key}");
        }
    }

    #[test]
    fn versions_between_published_crates_are_exact() {
        let of = |wish: &str| of_manifests(&[package("a", json!({})), package("b", on("a", wish, json!(null)))]).len();
        assert_eq!([of("=0.1.0"), of("^0.1.0"), of("=0.2.0"), of("*")], [0, 1, 1, 1]);
    }

    #[test]
    fn crates_that_are_not_published_serve_tests_alone_and_without_a_version() {
        let inner = package("t", json!({"publish": []}));
        let of = |wish: &str, kind: Value| of_manifests(&[inner.clone(), package("b", on("t", wish, kind))]).len();
        assert_eq!([of("*", json!("dev")), of("^0.1.0", json!("dev")), of("*", json!(null))], [0, 1, 1]);
    }
}
