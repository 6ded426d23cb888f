//! Rules of the libraries: each room uses only rooms left of it, errors are no text, and doc lines begin with a noun or a verb.

use std::path::{Path, PathBuf};

use crate::circles::circles;
use crate::outcome::Outcome;

/// Rooms of a library, left to right; rooms in one entry do not use each other.
type Rooms = &'static [&'static [&'static str]];

/// The rooms of `crates/cdpr-core/src`.
const CORE_ROOMS: Rooms = &[&["scalar"], &["geometry", "solve"], &["cable"], &["structure"]];

/// The rooms of `crates/cdpr/src`.
const ROOMS: Rooms = &[
    &["notation", "scalar", "reading"],
    &["geometry", "solve"],
    &["robot"],
    &["measurement"],
    &["cable"],
    &["model"],
    &["statics", "tension"],
    &["equilibrium"],
    &["workspace", "compensation"],
    &["metamodel"],
    &["identification"],
    &["plant"],
    &["surrogate"],
    &["export"],
    &["error_code"],
];

/// A library whose rooms have an order.
struct Library {
    folder: &'static str,
    rooms: Rooms,
}

const CORE: Library = Library { folder: "crates/cdpr-core/src", rooms: CORE_ROOMS };
const CDPR: Library = Library { folder: "crates/cdpr/src", rooms: ROOMS };
const LIBRARIES: [&Library; 2] = [&CORE, &CDPR];
/// A library without rooms, whose doc lines follow the same rule.
const REPORTS: Library = Library { folder: "crates/cdpr-reports/src", rooms: &[] };

/// Each crate of the workspace and the workspace crates that it may depend on.
const CRATES: &[(&str, &[&str])] = &[
    ("cdpr-core", &[]),
    ("cdpr", &["cdpr-core"]),
    ("cdpr-reports", &["cdpr"]),
    ("cdpr-cli", &["cdpr", "cdpr-reports"]),
];

/// First words of a doc line that point at its subject instead of naming it.
const POINTERS: &[&str] = &["What", "Where", "Whose", "That", "Something", "Who", "All that", "How much"];

/// Complains of every use to the right, of rooms that are not listed, of text as an error, of doc lines that do not say what a
/// thing is, and of crates that depend the wrong way.
pub(crate) fn check(root: &Path) -> Outcome {
    let mut complaints = Vec::new();
    for library in LIBRARIES {
        let source = root.join(library.folder);
        let files = rust_files(&source);
        let told = |circle: Vec<String>| {
            format!("{}: files that use each other in a circle: {}", library.folder, circle.join(", "))
        };
        complaints.extend(circles(&source, &files).into_iter().map(told));
        for path in files {
            let Ok(inside) = path.strip_prefix(&source) else { continue };
            match std::fs::read_to_string(&path) {
                Ok(text) => {
                    complaints.extend(library.uses_to_the_right(inside, &text));
                    complaints.extend(library.text_as_errors(inside, &text));
                    complaints.extend(library.pointing_doc_lines(inside, &text));
                }
                Err(error) => complaints.push(format!("{}: {error}", path.display())),
            }
        }
    }
    for path in rust_files(&root.join(REPORTS.folder)) {
        let inside = path.strip_prefix(root.join(REPORTS.folder)).unwrap_or(&path);
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        complaints.extend(REPORTS.pointing_doc_lines(inside, &text));
    }
    complaints.extend(crate_complaints(&root.join("crates")));
    Outcome::of(complaints)
}

impl Library {
    /// `inside` is the file's path in the library. The front page lib.rs may use everything.
    fn uses_to_the_right(&self, inside: &Path, text: &str) -> Vec<String> {
        let Some(room) = room_of(inside) else { return Vec::new() };
        let file = format!("{}/{}", self.folder, inside.display());
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

    /// Results of the library whose error is text: callers could not tell one from another.
    fn text_as_errors(&self, inside: &Path, text: &str) -> Vec<String> {
        let code = text.lines().map(|line| line.split("//").next().unwrap_or_default()).enumerate();
        let is_text = |code: &str| code.contains("Result<") && code.contains(", String>");
        let told = |(line, _)| {
            format!("{}/{}:{}: text as an error; give it a type of its own", self.folder, inside.display(), line + 1)
        };
        code.filter(|(_, code)| is_text(code)).map(told).collect()
    }

    /// First lines of doc comments that begin with one of [`POINTERS`].
    fn pointing_doc_lines(&self, inside: &Path, text: &str) -> Vec<String> {
        let mut complaints = Vec::new();
        let mut is_first = true;
        for (line, text) in (1..).zip(text.lines().map(str::trim_start)) {
            let doc = text.strip_prefix("///").or_else(|| text.strip_prefix("//!"));
            if let Some(word) = doc.filter(|_| is_first).and_then(pointer) {
                complaints.push(format!(
                    "{}/{}:{line}: a doc line begins with `{word}`; say what the thing is: noun or verb first",
                    self.folder,
                    inside.display()
                ));
            }
            is_first = doc.is_none();
        }
        complaints
    }

    fn place(&self, room: &str) -> Option<usize> {
        self.rooms.iter().position(|rooms| rooms.contains(&room))
    }
}

/// The pointer that a doc line begins with, as a whole word.
fn pointer(doc: &str) -> Option<&'static str> {
    let is_whole = |rest: &str| !rest.starts_with(|letter: char| letter.is_alphanumeric());
    POINTERS.iter().copied().find(|word| doc.trim_start().strip_prefix(word).is_some_and(is_whole))
}

/// `robot/description.rs` and `robot.rs` belong to the room `robot`; lib.rs belongs to none.
fn room_of(inside: &Path) -> Option<String> {
    let first = inside.iter().next()?.to_str()?;
    let room = first.strip_suffix(".rs").unwrap_or(first);
    (room != "lib").then(|| room.to_owned())
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

fn crate_complaints(crates: &Path) -> Vec<String> {
    let Ok(folders) = std::fs::read_dir(crates) else { return vec![format!("cannot read {}", crates.display())] };
    let mut complaints = Vec::new();
    for folder in folders.filter_map(Result::ok) {
        let name = folder.file_name().to_string_lossy().into_owned();
        let manifest = std::fs::read_to_string(folder.path().join("Cargo.toml")).unwrap_or_default();
        complaints.extend(dependencies_to_the_right(&name, &manifest));
    }
    complaints.sort_unstable();
    complaints
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
        if section.contains("dependencies") && key.starts_with("cdpr") && !allowed.contains(&key) {
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

    fn complaints(file: &str, text: &str) -> Vec<String> {
        CDPR.uses_to_the_right(Path::new(file), text)
    }

    #[test]
    fn a_use_to_the_left_passes_and_a_use_to_the_right_names_its_line() {
        assert!(complaints("model/lengths.rs", "use crate::cable::Outlet;\nuse crate::model::Model;\n").is_empty());
        assert_eq!(
            complaints("cable/pulley.rs", "//! Pulley.\n\nuse crate::model::Model;\n"),
            ["crates/cdpr/src/cable/pulley.rs:3: `cable` uses `model`, which does not stand left of it"]
        );
    }

    #[test]
    fn every_branch_of_a_grouped_use_is_seen_on_its_own_line() {
        let text = "use crate::{\n    geometry::{Pose, Twist},\n    export::{self, C99},\n    workspace,\n};\n";
        let lines: Vec<String> = complaints("robot.rs", text);
        assert_eq!(lines.len(), 2, "{lines:?}");
        assert!(lines[0].contains("robot.rs:3: `robot` uses `export`"));
        assert!(lines[1].contains("robot.rs:4: `robot` uses `workspace`"));
    }

    #[test]
    fn text_is_no_error_of_the_library() {
        let refused = |text: &str| CDPR.text_as_errors(Path::new("robot.rs"), text);
        assert!(refused("fn f() -> Result<String, Error> {\n/// Result<f64, String>\n").is_empty());
        assert_eq!(
            refused("\nfn f() -> Result<Vec<f64>, String> {\n"),
            ["crates/cdpr/src/robot.rs:2: text as an error; give it a type of its own"]
        );
    }

    #[test]
    fn a_doc_line_that_points_at_its_subject_is_refused() {
        let refused = |text: &str| CORE.pointing_doc_lines(Path::new("cable/mod.rs"), text);
        let named =
            "//! Laws of one cable.\n\n/// Length (m).\n/// Where it is slack, 0.\nfn f() {}\n// What is left.\n";
        assert!(refused(named).is_empty());
        assert!(refused("/// Whatever the unit, a length.\n").is_empty(), "a longer word");
        assert_eq!(
            refused("//! What one cable does.\n\n    /// Whose.\n    /// All that is told.\n"),
            [
                "crates/cdpr-core/src/cable/mod.rs:1: a doc line begins with `What`; say what the thing is: noun or verb first",
                "crates/cdpr-core/src/cable/mod.rs:3: a doc line begins with `Whose`; say what the thing is: noun or verb first"
            ]
        );
        for word in POINTERS {
            assert_eq!(refused(&format!("/// {word} is there.\n")).len(), 1, "{word}");
        }
    }

    #[test]
    fn a_path_inside_code_counts_as_a_use() {
        let text = "fn f() -> f64 {\n    crate::identification::fit()\n}\n";
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
        assert!(complaints("lib.rs", "pub use crate::export::C99;").is_empty());
    }

    #[test]
    fn the_library_may_not_depend_on_the_command_line() {
        let manifest = "[dependencies]\nnalgebra = \"1\"\ncdpr-cli.workspace = true\n";
        assert_eq!(dependencies_to_the_right("cdpr", manifest).len(), 1);
        assert!(dependencies_to_the_right("cdpr-cli", "[dependencies]\ncdpr.workspace = true\n").is_empty());
    }
}
