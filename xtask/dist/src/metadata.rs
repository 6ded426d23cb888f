//! Answers of `cargo metadata`.

use std::path::{Path, PathBuf};
use std::process::Command;

use serde_json::Value;

/// A package of the workspace or of a registry.
#[derive(Clone, Debug)]
pub(crate) struct Package(pub(crate) Value);

impl Package {
    /// Text of a key, empty where there is none.
    pub(crate) fn text(&self, key: &str) -> &str {
        self.0[key].as_str().unwrap_or_default()
    }

    /// Entries of a list, none where there is none.
    pub(crate) fn list(&self, key: &str) -> &[Value] {
        self.0[key].as_array().map_or(&[], Vec::as_slice)
    }

    /// Name and version.
    pub(crate) fn title(&self) -> String {
        format!("{} {}", self.text("name"), self.text("version"))
    }

    /// Folder of its manifest.
    pub(crate) fn folder(&self) -> PathBuf {
        Path::new(self.text("manifest_path")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
    }

    /// False where the manifest says `publish = false`.
    pub(crate) fn is_published(&self) -> bool {
        self.0["publish"].as_array().is_none_or(|registries| !registries.is_empty())
    }
}

/// All packages of Cargo.lock, or those of the workspace alone.
pub(crate) fn packages(root: &Path, is_workspace_alone: bool) -> Result<Vec<Package>, String> {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(["metadata", "--locked", "--format-version", "1"]).current_dir(root);
    command.args(is_workspace_alone.then_some("--no-deps"));
    let output = command.output().map_err(|error| format!("cannot start cargo: {error}"))?;
    if !output.status.success() {
        return Err(format!("`cargo metadata` failed: {}", String::from_utf8_lossy(&output.stderr).trim()));
    }
    let answer: Value = serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))?;
    let packages: Vec<Package> = answer["packages"].as_array().into_iter().flatten().cloned().map(Package).collect();
    if packages.is_empty() { Err("`cargo metadata` names no package".to_owned()) } else { Ok(packages) }
}
