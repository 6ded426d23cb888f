//! The public interface of the libraries, as committed listings: what users may call changes on purpose or not at all.
//!
//! Users meet the names that the facade `cdpr` hands on; their number is limited. Items of the inner crates are read from the source: the lint `unreachable_pub`
//! sees to it that whatever says `pub` can be reached from outside.

use std::path::{Path, PathBuf};

use crate::outcome::Outcome;

/// The facade, whose names are counted.
const FACADE: &str = "cdpr";

/// Inner libraries.
const LIBRARIES: [&str; 6] =
    ["cdpr-core", "cdpr-model", "cdpr-workspace", "cdpr-plant", "cdpr-calibration", "cdpr-study"];

/// Most names that the facade hands on: what an index of two screens shows.
const MOST_NAMES: usize = 420;

/// Words before which an item stands.
const KINDS: [&str; 8] = ["fn", "const fn", "struct", "enum", "trait", "const", "static", "type"];

/// Compares the interface with the committed listings.
pub(crate) fn check(root: &Path) -> Outcome {
    let mut complaints = Vec::new();
    for (library, found) in interfaces(root) {
        let listing = listing(library);
        let committed = std::fs::read_to_string(root.join(&listing)).unwrap_or_default();
        complaints.extend(differences(&listing, &committed, &found.text));
        println!("{library}: {} public items", found.items);
        if library == FACADE && found.items > MOST_NAMES {
            complaints.push(format!("the facade {FACADE} hands on {} names, {MOST_NAMES} are allowed", found.items));
        }
    }
    Outcome::of(complaints)
}

/// Writes the listings.
pub(crate) fn accept(root: &Path) -> Result<(), String> {
    for (library, found) in interfaces(root) {
        let listing = listing(library);
        let path = root.join(&listing);
        path.parent().map_or(Ok(()), std::fs::create_dir_all).map_err(|error| format!("{listing}: {error}"))?;
        std::fs::write(&path, found.text).map_err(|error| format!("{listing}: {error}"))?;
        println!("wrote {listing}: {} public items", found.items);
    }
    Ok(())
}

/// Place of a library's committed listing.
fn listing(library: &str) -> String {
    format!("docs/interface/{library}.txt")
}

fn interfaces(root: &Path) -> Vec<(&'static str, Interface)> {
    let source = |library: &str| root.join("crates").join(library).join("src");
    let inner = LIBRARIES.iter().map(|library| (*library, Interface::of(&source(library))));
    std::iter::once((FACADE, Interface::of_facade(&source(FACADE)))).chain(inner).collect()
}

/// Lines that one listing has and the other has not.
fn differences(listing: &str, committed: &str, found: &str) -> Vec<String> {
    let without = |lines: &str, others: &str, told: &str| -> Vec<String> {
        let others: std::collections::BTreeSet<&str> = others.lines().collect();
        let is_new = |line: &&str| !others.contains(*line) && !line.starts_with('#');
        lines.lines().filter(is_new).map(|line| format!("{listing}: {told}: {}", line.trim())).collect()
    };
    let mut all = without(found, committed, "not listed");
    all.extend(without(committed, found, "listed, but gone"));
    if all.is_empty() && committed != found {
        all.push(format!("{listing}: the order or the number of items is another"));
    }
    all
}

/// Listing of one library.
struct Interface {
    text: String,
    items: usize,
}

impl Interface {
    fn of(source: &Path) -> Self {
        let mut files = Vec::new();
        rust_files(source, &mut files);
        files.sort_unstable();
        let (mut body, mut items) = (String::new(), 0);
        for path in files {
            let Ok(text) = std::fs::read_to_string(&path) else { continue };
            let lines = public_lines(&text);
            if lines.is_empty() {
                continue;
            }
            items += lines.iter().filter(|line| line.is_item).count();
            let inside = path.strip_prefix(source).unwrap_or(&path);
            body.push_str(&format!("\n{}\n", inside.display()));
            lines.iter().for_each(|line| body.push_str(&format!("    {}\n", line.text)));
        }
        Self { text: format!("{HEAD}\n# {items} items.\n{body}"), items }
    }

    /// Names that a facade hands on, each with its module.
    fn of_facade(source: &Path) -> Self {
        let mut names = Vec::new();
        handed_on(&read(&source.join("lib.rs")), source, "", &mut names);
        names.sort_unstable();
        let body: String = names.iter().map(|name| format!("{name}\n")).collect();
        Self { text: format!("{HEAD}\n# {} items.\n\n{body}", names.len()), items: names.len() }
    }
}

const HEAD: &str = "# Public interface; `cargo xtask interface --accept` writes this file.";

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_default()
}

/// Adds the names of `pub use` in a module and in its modules, whether they stand in its text or in a file of their own.
fn handed_on(text: &str, source: &Path, module: &str, names: &mut Vec<String>) {
    let code: String = text.lines().map(|line| format!("{}\n", line.split("//").next().unwrap_or_default())).collect();
    let mut modules: Vec<String> = module.split("::").filter(|name| !name.is_empty()).map(str::to_owned).collect();
    let mut statement = String::new();
    for line in code.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("#[")) {
        statement.push_str(line);
        if let Some(name) = statement.strip_prefix("pub mod ") {
            let name = name.trim_end_matches(['{', ';', ' ']).to_owned();
            if statement.ends_with(';') {
                let file = source.join(&name).with_extension("rs");
                handed_on(&read(&file), source, &[modules.as_slice(), &[name]].concat().join("::"), names);
            } else {
                modules.push(name);
            }
        } else if statement == "}" {
            modules.pop();
        } else if !statement.ends_with(';') {
            continue;
        } else if let Some(path) = statement.strip_prefix("pub use ") {
            let list = path.rsplit_once("::").map_or(path, |(_, list)| list);
            let list = list.trim_matches(|letter| matches!(letter, '{' | '}' | ';')).trim_end_matches("};");
            let list = list.split(',').map(|name| name.trim_matches(|letter: char| "{}; ".contains(letter)));
            let full = |name: &str| [modules.as_slice(), &[name.to_owned()]].concat().join("::");
            names.extend(list.filter(|name| !name.is_empty()).map(full));
        }
        statement.clear();
    }
}

/// One public line of a file.
#[derive(Debug, PartialEq)]
struct Line {
    text: String,
    /// Not a field, a variant or a re-export.
    is_item: bool,
}

/// The public declarations of a file, without those of its tests.
fn public_lines(text: &str) -> Vec<Line> {
    let code = text.split("\n#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let mut found = Vec::new();
    let (mut owner, mut is_enum) = (String::new(), false);
    let mut lines = code.lines();
    while let Some(line) = lines.next() {
        let trimmed = line.split("//").next().unwrap_or_default().trim();
        if line.starts_with("impl") {
            owner = owner_of(trimmed);
        } else if line.starts_with('}') {
            (owner, is_enum) = (String::new(), false);
        }
        let is_variant = is_enum && line.starts_with("    ") && !line.starts_with("     ");
        if is_variant && trimmed.starts_with(|letter: char| letter.is_ascii_uppercase()) {
            found
                .push(Line { text: format!("{owner}::{}", trimmed.trim_end_matches([',', '{', ' '])), is_item: false });
            continue;
        }
        let Some(after) = trimmed.strip_prefix("pub ") else { continue };
        let is_item = KINDS.iter().any(|kind| after.strip_prefix(kind).is_some_and(|rest| rest.starts_with(' ')));
        let is_whole = |text: &str| text.ends_with(['{', ';', ',', '}']) && (!text.ends_with(',') || !is_item);
        let mut declaration = trimmed.to_owned();
        while !is_whole(&declaration) {
            let Some(next) = lines.next() else { break };
            declaration.push(' ');
            declaration.push_str(next.split("//").next().unwrap_or_default().trim());
        }
        if line.starts_with("pub ") && is_item {
            (owner, is_enum) = (name_of(after), after.starts_with("enum ") && declaration.ends_with('{'));
        }
        let of = if line.starts_with("pub ") || owner.is_empty() { String::new() } else { format!("{owner}: ") };
        found.push(Line { text: format!("{of}{}", declaration.trim_end_matches([' ', '{', ';', ','])), is_item });
        if line.starts_with("pub ") && !declaration.ends_with('{') {
            (owner, is_enum) = (String::new(), false);
        }
    }
    found
}

/// `Model` of `impl Model {`, `T: Real` of generics left out; the type of `impl Trait for Type`.
fn owner_of(line: &str) -> String {
    let mut depth = 0_usize;
    let mut words = String::new();
    for letter in line.trim_start_matches("impl").chars() {
        match letter {
            '<' => depth += 1,
            '>' => depth = depth.saturating_sub(1),
            '{' => break,
            _ if depth == 0 => words.push(letter),
            _ => {}
        }
    }
    let of = words.split(" for ").last().unwrap_or_default();
    of.split_whitespace().next().unwrap_or_default().to_owned()
}

/// The name in `struct Name<T> {`.
fn name_of(after: &str) -> String {
    let words = after.split_whitespace().find(|word| !KINDS.contains(word) && *word != "const");
    let is_of_name = |letter: char| letter.is_alphanumeric() || letter == '_';
    words.unwrap_or_default().chars().take_while(|letter| is_of_name(*letter)).collect()
}

/// Files of a library without those that hold tests alone.
fn rust_files(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if name == "tests" || name.ends_with("_tests") {
            continue;
        }
        if path.is_dir() {
            rust_files(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = "\
//! A drum.

pub use other::Thing;

/// A drum.
#[derive(Clone)]
pub struct Drum<'a> {
    /// Radius (m).
    pub radius: f64,
    inside: &'a str,
}

pub enum Side {
    /// Left.
    Left,
    Right { angle: f64 },
}

impl<'a> Drum<'a> {
    /// A drum.
    pub fn new(
        radius: f64, // m
        inside: &'a str,
    ) -> Self {
        Self { radius, inside }
    }

    pub(crate) fn hidden(&self) {}

    pub const ZERO: f64 = 0.0;
}

#[cfg(test)]
mod tests {
    pub fn not_seen() {}
}
";

    #[test]
    fn declarations_are_listed_with_their_owner_and_tests_are_not() {
        let lines = public_lines(SOURCE);
        let texts: Vec<&str> = lines.iter().map(|line| line.text.as_str()).collect();
        let expected = [
            "pub use other::Thing",
            "pub struct Drum<'a>",
            "Drum: pub radius: f64",
            "pub enum Side",
            "Side::Left",
            "Side::Right { angle: f64 }",
            "Drum: pub fn new( radius: f64, inside: &'a str, ) -> Self",
            "Drum: pub const ZERO: f64 = 0.0",
        ];
        assert_eq!(texts, expected);
        assert_eq!(lines.iter().filter(|line| line.is_item).count(), 4);
    }

    #[test]
    fn names_of_a_facade_are_listed_with_their_modules() {
        let text = "//! Facade.\n\npub use inner::Robot;\n\npub mod tension {\n    //! Tensions.\n\n    #[doc(inline)]\n    pub use inner::tension::{\n        \
                    Limits, solve,\n    };\n\n    pub mod quadratic {\n        pub use inner::quadratic::Solver;\n    }\n}\npub use inner::Model;\n";
        let mut names = Vec::new();
        handed_on(text, Path::new("nowhere"), "", &mut names);
        assert_eq!(names, ["Robot", "tension::Limits", "tension::solve", "tension::quadratic::Solver", "Model"]);
    }

    #[test]
    fn what_came_and_what_went_is_named() {
        let complaints = differences("list.txt", "# 1 items.\npub fn old()\n", "# 1 items.\npub fn new()\n");
        assert_eq!(complaints, ["list.txt: not listed: pub fn new()", "list.txt: listed, but gone: pub fn old()"]);
        assert!(differences("list.txt", "pub fn f()\n", "pub fn f()\n").is_empty());
        assert_eq!(differences("list.txt", "# 2 items.\npub fn f()\n", "# 1 items.\npub fn f()\n").len(), 1);
    }
}
