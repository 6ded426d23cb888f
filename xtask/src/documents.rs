//! Links and includes of the book and of the pages at the root, and what manifests say to registries.

use std::path::{Path, PathBuf};

use crate::dist;
use crate::outcome::Outcome;

/// Where book.toml is.
pub(crate) const BOOK_ROOT: &str = "docs/book";

const BOOK: &str = "docs/book/src";

/// Pages that name files of the workspace in code, so that readers find them.
const GUIDES: &[&str] = &["ARCHITECTURE.md", "CONTRIBUTING.md"];

/// Record of changes for users: a page, and folded lists.
const CHANGES: &str = "CHANGELOG.md";

/// Heading of the page, and lines that it has at most.
const PAGE: (&str, usize) = ("### In short", 60);

/// Folders that a path in code begins with.
const FOLDERS: &[&str] =
    &["benches/", "crates/", "docs/", "examples/", "fuzz/", "judges/", "schemas/", "studies/", "viewer/", "xtask/"];

/// Complains of links and includes that lead nowhere, of pages that SUMMARY.md forgets, and of manifests that
/// nobody could publish.
pub(crate) fn check(root: &Path) -> Outcome {
    let mut pages = markdown_files(&root.join("docs"));
    let book: Vec<PathBuf> = markdown_files(&root.join(BOOK));
    pages.extend(["README.md", "ARCHITECTURE.md", "CONTRIBUTING.md", CHANGES].map(|name| root.join(name)));
    let mut complaints = Vec::new();
    for page in &pages {
        let name = page.strip_prefix(root).unwrap_or(page).display().to_string();
        match std::fs::read_to_string(page) {
            Ok(text) => {
                let paths = if GUIDES.contains(&name.as_str()) { lost_paths(root, &text) } else { Vec::new() };
                let dead = dead_targets(page, &text).into_iter().chain(paths);
                complaints.extend(dead.map(|dead| format!("{name}{dead}")));
            }
            Err(error) => complaints.push(format!("{name}: {error}")),
        }
    }
    let guide = std::fs::read_to_string(root.join("CONTRIBUTING.md")).unwrap_or_default();
    complaints.extend(long_recipes(&guide));
    let summary = std::fs::read_to_string(root.join(BOOK).join("SUMMARY.md")).unwrap_or_default();
    complaints.extend(forgotten_pages(&root.join(BOOK), &book, &summary));
    complaints.extend(longer_than_a_page(&std::fs::read_to_string(root.join(CHANGES)).unwrap_or_default()));
    let mut outcome = Outcome::of(complaints);
    outcome.add(dist::manifests(root));
    outcome
}

/// `:line: what` for every link or include whose file, or whose anchor in the file, does not exist.
fn dead_targets(page: &Path, text: &str) -> Vec<String> {
    let folder = page.parent().unwrap_or(page);
    let mut dead = Vec::new();
    let mut code = false;
    for (number, line) in (1..).zip(text.lines()) {
        code ^= line.trim_start().starts_with("```");
        for target in includes(line) {
            let (path, anchor) = target.split_once(':').unwrap_or((target, ""));
            match std::fs::read_to_string(folder.join(path)) {
                Err(error) => dead.push(format!(":{number}: cannot include `{path}`: {error}")),
                Ok(text) if !has_anchor(&text, anchor) => {
                    dead.push(format!(":{number}: `{path}` has no line with `ANCHOR: {anchor}`"));
                }
                Ok(_) => {}
            }
        }
        for target in links(line).into_iter().filter(|_| !code) {
            let path = target.split('#').next().unwrap_or_default();
            if !path.is_empty() && !path.contains(':') && !folder.join(path).exists() {
                dead.push(format!(":{number}: the link to `{path}` leads nowhere"));
            }
        }
    }
    dead
}

/// `:line: what` for every path in code that the workspace does not have.
fn lost_paths(root: &Path, text: &str) -> Vec<String> {
    let mut lost = Vec::new();
    for (number, line) in (1..).zip(text.lines()) {
        let code = line.split('`').skip(1).step_by(2);
        let paths = code
            .filter(|code| FOLDERS.iter().any(|folder| code.starts_with(folder)) && !code.contains([' ', '*', '{']));
        let lost_here = paths.filter(|path| !root.join(path).exists());
        lost.extend(lost_here.map(|path| format!(":{number}: there is no `{path}`")));
    }
    lost
}

/// Most steps of a recipe, a line each.
const RECIPE_LINES: usize = 6;

/// Complains of recipes (`### To add …`) with more steps than anybody follows, and of a guide without recipes.
fn long_recipes(text: &str) -> Vec<String> {
    let recipes: Vec<(&str, usize)> = text
        .split("\n### To add ")
        .skip(1)
        .map(|recipe| {
            let section = recipe.split("\n#").next().unwrap_or_default();
            let name = section.lines().next().unwrap_or_default();
            (name, section.lines().skip(1).filter(|line| !line.trim().is_empty()).count())
        })
        .collect();
    if recipes.is_empty() {
        return vec!["CONTRIBUTING.md has no recipes (`### To add …`)".to_owned()];
    }
    let is_long = |&&(_, lines): &&(&str, usize)| lines > RECIPE_LINES;
    let complaint = |(name, lines): &(&str, usize)| {
        format!("CONTRIBUTING.md: the recipe \"To add {name}\" has {lines} lines, and at most {RECIPE_LINES} are read")
    };
    recipes.iter().filter(is_long).map(complaint).collect()
}

/// Targets of `{{#include …}}` in a line.
fn includes(line: &str) -> Vec<&str> {
    line.split("{{#include ").skip(1).filter_map(|rest| Some(rest.split_once("}}")?.0.trim())).collect()
}

/// Targets of `[text](target)` in a line, outside `code`.
fn links(line: &str) -> Vec<&str> {
    let prose = line.split('`').step_by(2); // every second piece stands between backticks
    let code_in_text = line.contains("`](").then_some(line); // [`code`](target)
    let targets = |piece: &'_ str| -> Vec<(usize, usize)> {
        let starts = piece.match_indices("](").map(|(start, _)| start + 2);
        starts.filter_map(|start| Some((start, start + piece[start..].find(')')?))).collect()
    };
    match code_in_text {
        Some(line) => targets(line).into_iter().map(|(start, end)| &line[start..end]).collect(),
        None => prose.flat_map(|piece| targets(piece).into_iter().map(|(start, end)| &piece[start..end])).collect(),
    }
}

/// True for a whole file, a range of lines, and an anchor that the text marks.
fn has_anchor(text: &str, anchor: &str) -> bool {
    anchor.chars().all(|letter| letter.is_ascii_digit() || letter == ':')
        || text.lines().any(|line| line.trim_end().ends_with(&format!("ANCHOR: {anchor}")))
}

fn forgotten_pages(folder: &Path, pages: &[PathBuf], summary: &str) -> Vec<String> {
    let listed: Vec<&str> = summary.lines().flat_map(links).collect();
    let names = pages.iter().filter_map(|page| page.strip_prefix(folder).ok()?.to_str());
    names
        .filter(|name| *name != "SUMMARY.md" && !listed.contains(name))
        .map(|name| format!("{BOOK}/SUMMARY.md does not list {name}"))
        .collect()
}

/// Complaint about the newest changes where their first part is no page.
fn longer_than_a_page(changes: &str) -> Option<String> {
    let (heading, most) = PAGE;
    let newest = changes.split("\n## ").nth(1).unwrap_or_default();
    let page = newest.split_once(heading).map(|(_, rest)| rest.split("\n### ").next().unwrap_or(rest));
    let Some(page) = page else {
        return Some(format!("{CHANGES}: the newest version has no part `{heading}` for users"));
    };
    let lines = page.lines().count();
    (lines > most).then(|| {
        format!("{CHANGES}: `{heading}` has {lines} lines, more than {most}; the lists below it have room for the rest")
    })
}

/// All pages under a folder, but not those that mdbook built.
fn markdown_files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut files = Vec::new();
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        if path.is_dir() && !path.ends_with("book/book") {
            files.extend(markdown_files(&path));
        } else if path.extension().is_some_and(|extension| extension == "md") {
            files.push(path);
        }
    }
    files.sort_unstable();
    files
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_recipe_has_six_lines_at_most() {
        let steps = |count: usize| (1..=count).map(|k| format!("{k}. Do.\n")).collect::<String>();
        let guide = |count| format!("# Guide\n\n### To add a law\n\n{}\n### To add a page\n\n1. Do.\n", steps(count));
        assert_eq!(long_recipes(&guide(6)), Vec::<String>::new());
        assert_eq!(long_recipes(&guide(7)).len(), 1);
        assert_eq!(long_recipes("# Guide\n").len(), 1);
    }

    #[test]
    fn a_dead_link_is_named_with_its_line_and_a_web_address_is_not_followed() {
        let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("page.md");
        let text = "[here](Cargo.toml) [web](https://example.org)\n[dead](nowhere.md#part) [part](#part)\n";
        assert_eq!(dead_targets(&page, text), [":2: the link to `nowhere.md` leads nowhere"]);
    }

    #[test]
    fn code_is_not_searched_for_links_but_code_may_be_a_links_text() {
        assert!(links("`[a](b)`").is_empty());
        assert_eq!(links("[`robot`](robot-files.md)"), ["robot-files.md"]);
    }

    #[test]
    fn an_include_needs_its_file_and_its_anchor() {
        let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("page.md");
        assert!(dead_targets(&page, "{{#include Cargo.toml}}").is_empty());
        assert_eq!(dead_targets(&page, "{{#include Cargo.toml:fit}}").len(), 1);
        assert_eq!(dead_targets(&page, "{{#include absent.rs}}").len(), 1);
        assert!(has_anchor("    // ANCHOR: fit\n", "fit"));
    }

    #[test]
    fn a_page_that_the_summary_forgets_is_found() {
        let folder = Path::new("src");
        let pages = [folder.join("SUMMARY.md"), folder.join("a.md"), folder.join("b.md")];
        assert_eq!(forgotten_pages(folder, &pages, "- [A](a.md)"), ["docs/book/src/SUMMARY.md does not list b.md"]);
    }

    #[test]
    fn the_page_of_changes_is_one_page() {
        let changes =
            |lines: usize| format!("# C\n\n## [1]\n\n### In short\n{}\n### Added\n- a\n", "a\n".repeat(lines));
        assert_eq!(longer_than_a_page(&changes(50)), None);
        assert!(longer_than_a_page(&changes(70)).is_some_and(|complaint| complaint.contains("more than 60")));
        assert!(longer_than_a_page("# C\n\n## [1]\n\n### Added\n").is_some());
    }

    #[test]
    fn paths_in_code_exist() {
        let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        let lost =
            lost_paths(root, "`xtask/src/main.rs` and `cargo xtask test`\nand `crates/nowhere/src/`, `crates/*/src`\n");
        assert_eq!(lost, [":2: there is no `crates/nowhere/src/`"]);
    }
}
