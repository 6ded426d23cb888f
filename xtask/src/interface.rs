//! The public interface of the libraries, as a committed listing: what users may call changes on purpose or not at all.
//!
//! Items are read from the source: the lint `unreachable_pub` sees to it that whatever says `pub` can be reached from outside.

use std::path::{Path, PathBuf};

use crate::outcome::Outcome;

/// Libraries, and where the listing of each is committed.
const LIBRARIES: [(&str, &str); 2] =
    [("crates/cdpr/src", "docs/interface/cdpr.txt"), ("crates/cdpr-core/src", "docs/interface/cdpr-core.txt")];

/// Most items of the library that users see whole: types, functions, methods, constants; fields and variants belong to their type. They may only become
/// fewer.
const MOST_ITEMS: usize = 1019;
const COUNTED: &str = LIBRARIES[0].0;

/// Words before which an item stands.
const KINDS: [&str; 8] = ["fn", "const fn", "struct", "enum", "trait", "const", "static", "type"];

/// Compares the interface with the committed listings.
pub(crate) fn check(root: &Path) -> Outcome {
    let mut complaints = Vec::new();
    for (folder, listing) in LIBRARIES {
        let found = Interface::of(&root.join(folder));
        let committed = std::fs::read_to_string(root.join(listing)).unwrap_or_default();
        complaints.extend(differences(listing, &committed, &found.text));
        if folder == COUNTED && found.items > MOST_ITEMS {
            complaints.push(format!("{folder}: {} public items, {MOST_ITEMS} are allowed", found.items));
        }
        println!("{folder}: {} public items", found.items);
    }
    Outcome::of(complaints)
}

/// Writes the listings.
pub(crate) fn accept(root: &Path) -> Result<(), String> {
    for (folder, listing) in LIBRARIES {
        let path = root.join(listing);
        let found = Interface::of(&root.join(folder));
        path.parent().map_or(Ok(()), std::fs::create_dir_all).map_err(|error| format!("{listing}: {error}"))?;
        std::fs::write(&path, found.text).map_err(|error| format!("{listing}: {error}"))?;
        println!("wrote {listing}: {} public items", found.items);
    }
    Ok(())
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
        let head = "# Public interface; `cargo xtask interface --accept` writes this file.";
        Self { text: format!("{head}\n# {items} items.\n{body}"), items }
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
    fn what_came_and_what_went_is_named() {
        let complaints = differences("list.txt", "# 1 items.\npub fn old()\n", "# 1 items.\npub fn new()\n");
        assert_eq!(complaints, ["list.txt: not listed: pub fn new()", "list.txt: listed, but gone: pub fn old()"]);
        assert!(differences("list.txt", "pub fn f()\n", "pub fn f()\n").is_empty());
        assert_eq!(differences("list.txt", "# 2 items.\npub fn f()\n", "# 1 items.\npub fn f()\n").len(), 1);
    }
}
