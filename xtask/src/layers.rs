//! Rules of the crates: each room uses only rooms left of it, no file leads back to itself, and crates depend only on those that they may.

use std::path::{Path, PathBuf};

use crate::circles::{self, graph::Graph};
use crate::outcome::Outcome;
use crate::{inlining, sentences, signatures};

/// Crates whose rooms have an order, by their folders.
const LIBRARIES: &[Library] = &[
    Library { folder: "crates/cdpr-core", rooms: &[&["scalar"], &["geometry", "solve"], &["cable"], &["structure"]] },
    Library {
        folder: "crates/cdpr-model",
        rooms: &[
            &["finding", "notation", "scalar", "reading"],
            &["geometry", "solve"],
            &["robot"],
            &["measurement"],
            &["cable"],
            &["model"],
            &["statics", "tension"],
            &["equilibrium"],
            &["compensation"],
            &["control"],
            &["error_code"],
        ],
    },
];

/// A crate and its rooms, left to right; rooms in one entry do not use each other.
struct Library {
    folder: &'static str,
    rooms: &'static [&'static [&'static str]],
}

/// Each crate of the workspace and the workspace crates that it may depend on.
const CRATES: &[(&str, &[&str])] = &[
    ("cdpr-core", &[]),
    ("cdpr-model", &["cdpr-core"]),
    ("cdpr-workspace", &["cdpr-core", "cdpr-model"]),
    ("cdpr-plant", &["cdpr-core", "cdpr-model"]),
    ("cdpr-calibration", &["cdpr-core", "cdpr-model"]),
    ("cdpr-study", &["cdpr-core", "cdpr-model", "cdpr-workspace", "cdpr-plant", "cdpr-calibration"]),
    ("cdpr", &["cdpr-core", "cdpr-model", "cdpr-workspace", "cdpr-plant", "cdpr-calibration", "cdpr-study"]),
    ("cdpr-reports", &["cdpr-model", "cdpr-workspace", "cdpr-plant", "cdpr-calibration", "cdpr-study"]),
    ("cdpr-cli", &["cdpr-model", "cdpr-workspace", "cdpr-plant", "cdpr-calibration", "cdpr-study", "cdpr-reports"]),
    ("cdpr-python", &["cdpr", "cdpr-cli"]),
    ("cdpr-testing", &[]),
];

/// Complains of every use to the right, of rooms that are not listed, of circles of files, of text as an error, of doc lines that do
/// not say what a thing is, of inlining that is forced without a reason, and of crates that depend the wrong way.
pub(crate) fn check(root: &Path) -> Outcome {
    let folders = crate_folders(root);
    let mut complaints = circles::lost(&folders);
    let lost = LIBRARIES.iter().filter(|library| !folders.iter().any(|folder| folder == library.folder));
    complaints
        .extend(lost.map(|library| format!("{}: this crate of xtask/src/layers.rs is not there", library.folder)));
    let mut inlined = inlining::Seen::default();
    for folder in &folders {
        let source = root.join(folder).join("src");
        let files = rust_files(&source);
        let graph = circles::graph(folder, &source, &files);
        complaints.extend(circles::complaints(folder, &graph));
        let library = LIBRARIES.iter().find(|library| library.folder == folder);
        complaints.extend(library.into_iter().flat_map(|library| library.hidden_uses_to_the_right(&graph)));
        for path in &files {
            let inside = path.strip_prefix(&source).unwrap_or(path);
            let name = format!("{folder}/src/{}", inside.display());
            match std::fs::read_to_string(path) {
                Ok(text) => {
                    complaints.extend(library.into_iter().flat_map(|library| library.uses_to_the_right(inside, &text)));
                    complaints.extend(sentences::complaints(&name, &text));
                    complaints.extend(signatures::tuples(&name, &text));
                    complaints.extend(library.into_iter().flat_map(|_| signatures::commands(&name, &text)));
                    complaints.extend(inlined.complaints(&name, &text));
                }
                Err(error) => complaints.push(format!("{name}: {error}")),
            }
        }
        let manifest = std::fs::read_to_string(root.join(folder).join("Cargo.toml")).unwrap_or_default();
        complaints.extend(dependencies_to_the_right(folder.trim_start_matches("crates/"), &manifest));
    }
    complaints.extend(inlined.unused());
    Outcome::of(complaints)
}

/// Folders of the crates, as `crates/NAME`.
fn crate_folders(root: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(root.join("crates")).into_iter().flatten().filter_map(Result::ok);
    let crates = entries.filter(|entry| entry.path().join("Cargo.toml").is_file());
    let mut folders: Vec<String> =
        crates.map(|entry| format!("crates/{}", entry.file_name().to_string_lossy())).collect();
    folders.sort_unstable();
    folders
}

impl Library {
    /// `inside` is the file's path in the library. The front page lib.rs may use everything.
    fn uses_to_the_right(&self, inside: &Path, text: &str) -> Vec<String> {
        let Some(room) = room_of(inside) else { return Vec::new() };
        let file = format!("{}/src/{}", self.folder, inside.display());
        let Some(place) = self.place(&room) else {
            return vec![format!("{file}: the room `{room}` is not listed in xtask/src/layers.rs and ARCHITECTURE.md")];
        };
        let mut complaints = Vec::new();
        for used in used_rooms(text) {
            let (line, name) = (used.line, used.name);
            match self.place(&name) {
                // tests draw their random cases by `property`, wherever they stand
                _ if name == room || name == "nalgebra" || name == "property" => {}
                Some(other) if other < place => {}
                Some(_) => {
                    complaints.push(format!("{file}:{line}: `{room}` uses `{name}`, which does not stand left of it"))
                }
                None => {
                    complaints.push(format!("{file}:{line}: `crate::{name}` is no room; name the room that defines it"))
                }
            }
        }
        complaints
    }

    /// Uses to the right that do not begin with `crate::`: by `super::` or by a name for a module.
    fn hidden_uses_to_the_right(&self, graph: &Graph) -> Vec<String> {
        let mut complaints = Vec::new();
        for one in graph.uses().filter(|one| !one.path.starts_with("crate::")) {
            let rooms = (room_of(Path::new(&one.from)), room_of(Path::new(&one.to)));
            let (Some(room), Some(other)) = rooms else { continue };
            if room != other && self.place(&other) >= self.place(&room) {
                complaints.push(format!(
                    "{}/src/{}:{}: `{room}` uses `{other}`, which does not stand left of it",
                    self.folder, one.from, one.line
                ));
            }
        }
        complaints
    }

    fn place(&self, room: &str) -> Option<usize> {
        self.rooms.iter().position(|rooms| rooms.contains(&room))
    }
}

/// `robot/description.rs` and `robot.rs` belong to the room `robot`; lib.rs and main.rs belong to none.
fn room_of(inside: &Path) -> Option<String> {
    let first = inside.iter().next()?.to_str()?;
    let room = first.strip_suffix(".rs").unwrap_or(first);
    (room != "lib" && room != "main").then(|| room.to_owned())
}

struct Used {
    name: String,
    line: usize,
}

/// Every first name after `crate::`, also inside `crate::{…}`, with its line; comments do not count.
fn used_rooms(text: &str) -> Vec<Used> {
    let code: String = text.lines().map(|line| format!("{}\n", line.split("//").next().unwrap_or_default())).collect();
    let mut found = Vec::new();
    for (start, path) in code.match_indices("crate::") {
        let before = code[..start].chars().next_back();
        if before.is_some_and(|letter| letter.is_alphanumeric() || letter == '_') {
            continue; // the end of a longer name
        }
        let after = start + path.len();
        let offsets = if code[after..].starts_with('{') { branches(&code[after..]) } else { vec![0] };
        for offset in offsets {
            let name: String = code[after + offset..]
                .chars()
                .take_while(|letter| letter.is_alphanumeric() || *letter == '_')
                .collect();
            let line = 1 + code[..after + offset].matches('\n').count();
            found.push(Used { name, line });
        }
    }
    found
}

/// Where the branches of `{a::X, b::{Y, Z}}` begin.
fn branches(group: &str) -> Vec<usize> {
    let (mut depth, mut fresh, mut starts) = (0_usize, false, Vec::new());
    for (offset, letter) in group.char_indices() {
        match letter {
            '{' => {
                depth += 1;
                fresh = depth == 1;
            }
            '}' if depth == 1 => break,
            '}' => depth -= 1,
            ',' if depth == 1 => fresh = true,
            _ if letter.is_whitespace() => {}
            _ if fresh => {
                starts.push(offset);
                fresh = false;
            }
            _ => {}
        }
    }
    starts
}

/// Names of the workspace begin with `cdpr`; a crate may depend only on those in its line of the table.
fn dependencies_to_the_right(name: &str, manifest: &str) -> Vec<String> {
    let Some((_, allowed)) = CRATES.iter().find(|(listed, _)| *listed == name) else {
        return vec![format!("crates/{name}: this crate is not listed in xtask/src/layers.rs and ARCHITECTURE.md")];
    };
    let mut section = "";
    let mut complaints = Vec::new();
    for (line, text) in (1..).zip(manifest.lines()) {
        if text.starts_with('[') {
            section = text;
        }
        let key = text.split(['.', '=', ' ']).next().unwrap_or_default();
        let is_for_tests = section == "[dev-dependencies]" && key == "cdpr-testing";
        if section.contains("dependencies") && key.starts_with("cdpr") && !allowed.contains(&key) && !is_for_tests {
            complaints.push(format!("crates/{name}/Cargo.toml:{line}: `{name}` may not depend on `{key}`"));
        }
    }
    complaints
}

fn rust_files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut files = Vec::new();
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        if path.is_dir() {
            files.extend(rust_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files.sort_unstable();
    files
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::circles::graph::Use;

    const MODEL: Library = Library {
        folder: "crates/cdpr-model",
        rooms: &[
            &["notation", "reading", "scalar"],
            &["geometry", "solve"],
            &["robot"],
            &["measurement"],
            &["cable"],
            &["model"],
            &["statics", "tension"],
            &["equilibrium"],
            &["compensation"],
            &["control"],
        ],
    };

    fn complaints(file: &str, text: &str) -> Vec<String> {
        MODEL.uses_to_the_right(Path::new(file), text)
    }

    #[test]
    fn a_use_to_the_right_by_super_or_by_a_name_for_a_module_is_seen() {
        let refused = |path: &str, to: &str| {
            let mut graph = Graph::default();
            let (from, to, path) = ("model/lengths.rs".to_owned(), to.to_owned(), path.to_owned());
            graph.add(Use { from, to, line: 7, path });
            MODEL.hidden_uses_to_the_right(&graph)
        };
        assert_eq!(
            refused("super::super::tension::Method", "tension/method.rs"),
            ["crates/cdpr-model/src/model/lengths.rs:7: `model` uses `tension`, which does not stand left of it"]
        );
        assert!(refused("winch::Drum", "cable/winch.rs").is_empty());
    }

    #[test]
    fn a_use_to_the_left_passes_and_a_use_to_the_right_names_its_line() {
        assert!(complaints("model/lengths.rs", "use crate::cable::Outlet;\nuse crate::model::Model;\n").is_empty());
        assert_eq!(
            complaints("cable/pulley.rs", "//! Pulley.\n\nuse crate::model::Model;\n"),
            ["crates/cdpr-model/src/cable/pulley.rs:3: `cable` uses `model`, which does not stand left of it"]
        );
    }

    #[test]
    fn every_branch_of_a_grouped_use_is_seen_on_its_own_line() {
        let text = "use crate::{\n    geometry::{Pose, Twist},\n    control::{self, C99},\n    equilibrium,\n};\n";
        let lines: Vec<String> = complaints("robot.rs", text);
        assert_eq!(lines.len(), 2, "{lines:?}");
        assert!(lines[0].contains("robot.rs:3: `robot` uses `control`"));
        assert!(lines[1].contains("robot.rs:4: `robot` uses `equilibrium`"));
    }

    #[test]
    fn a_path_inside_code_counts_as_a_use() {
        let text = "fn f() -> f64 {\n    crate::control::fit()\n}\n";
        assert_eq!(complaints("geometry/mod.rs", text).len(), 1);
    }

    #[test]
    fn comments_and_longer_names_are_no_uses() {
        let text = "/// See [`crate::model::Model`].\nuse subcrate::model::X;\n";
        assert!(complaints("geometry/mod.rs", text).is_empty());
    }

    #[test]
    fn rooms_of_one_place_do_not_use_each_other() {
        assert_eq!(complaints("statics/mod.rs", "use crate::tension::solve;").len(), 1);
    }

    #[test]
    fn unlisted_rooms_and_names_of_the_crate_root_are_refused() {
        assert!(complaints("helpers/mod.rs", "")[0].contains("not listed"));
        assert!(complaints("model/mod.rs", "use crate::Robot;")[0].contains("is no room"));
        assert!(complaints("lib.rs", "pub use crate::control::Control;").is_empty());
    }

    #[test]
    fn the_library_may_not_depend_on_the_command_line() {
        let manifest = "[dependencies]\nnalgebra = \"1\"\ncdpr-cli.workspace = true\n";
        assert_eq!(dependencies_to_the_right("cdpr", manifest).len(), 1);
        assert!(dependencies_to_the_right("cdpr-cli", "[dependencies]\ncdpr-model.workspace = true\n").is_empty());
    }
}
