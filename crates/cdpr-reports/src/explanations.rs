//! A page of explanation for every error code. The pages are part of the book too.

/// One page per code under a heading `## area::mistake`: what happened, causes, cure, example.
const PAGES: [&str; 6] = [
    include_str!("explanations/arrays.md"),
    include_str!("explanations/command_line.md"),
    include_str!("explanations/files.md"),
    include_str!("explanations/findings.md"),
    include_str!("explanations/robots.md"),
    include_str!("explanations/workspaces.md"),
];

/// Explanation of a code.
#[derive(Clone, Copy, Debug)]
pub struct Explanation {
    /// The code, `area::mistake`.
    pub code: &'static str,
    /// The page below the heading.
    pub text: &'static str,
}

impl Explanation {
    /// The first sentence: what happened.
    pub fn summary(&self) -> String {
        let paragraph = self.text.split("\n\n").next().unwrap_or_default().replace('\n', " ");
        match paragraph.split_once(". ") {
            Some((first, _)) => format!("{first}."),
            None => paragraph,
        }
    }
}

/// All explanations, in the order of the pages.
pub fn all() -> impl Iterator<Item = Explanation> {
    let sections = PAGES.iter().flat_map(|page| page.split("## ")).filter(|section| !section.trim().is_empty());
    sections.filter_map(|section| {
        let (code, text) = section.split_once('\n')?;
        Some(Explanation { code: code.trim(), text: text.trim() })
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::path::{Path, PathBuf};

    use super::*;

    /// Sources of the library and of the command.
    fn sources() -> Vec<(PathBuf, String)> {
        fn collect(folder: &Path, found: &mut Vec<(PathBuf, String)>) {
            for path in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
                if path.is_dir() {
                    collect(&path, found);
                } else if path.extension().is_some_and(|ending| ending == "rs") {
                    found.push((path.clone(), std::fs::read_to_string(&path).unwrap()));
                }
            }
        }
        let mut found = Vec::new();
        let crates = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
        for member in std::fs::read_dir(crates).unwrap() {
            collect(&member.unwrap().path().join("src"), &mut found);
        }
        assert!(found.len() > 100, "the sources are not where they were");
        found
    }

    /// Words in quotes of the form `area::mistake`, before the tests of a file.
    fn codes_in(text: &str) -> Vec<String> {
        let before_tests = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
        let is_code = |word: &&str| {
            let plain =
                |part: &str| !part.is_empty() && part.chars().all(|c| c.is_ascii_lowercase() || "-8".contains(c));
            word.split_once("::").is_some_and(|(area, mistake)| plain(area) && plain(mistake))
        };
        // a code stands between two quotes, so both halves of a pairing that went astray are tried
        before_tests.split('"').filter(is_code).map(str::to_owned).collect()
    }

    #[test]
    fn every_code_has_a_page_and_every_page_a_code() {
        let explained: BTreeSet<String> = all().map(|explanation| explanation.code.to_owned()).collect();
        let is_test = |path: &Path| path.ends_with("tests.rs") || path.ends_with("explanations.rs");
        let used: BTreeSet<String> =
            sources().iter().filter(|(path, _)| !is_test(path)).flat_map(|(_, text)| codes_in(text)).collect();
        let missing: Vec<_> = used.difference(&explained).collect();
        let left_over: Vec<_> = explained.difference(&used).collect();
        assert!(missing.is_empty(), "without a page in src/explanations: {missing:?}");
        assert!(left_over.is_empty(), "pages of codes that nothing gives: {left_over:?}");
        assert_eq!(all().count(), explained.len(), "a code has two pages");
    }

    #[test]
    fn every_page_tells_what_happened_why_how_to_mend_it_and_an_example() {
        for Explanation { code, text } in all() {
            let lines = || text.lines();
            assert!(!text.starts_with("Causes:"), "{code} does not say what happened");
            assert!(lines().any(|line| line.starts_with("Causes: ")), "{code} has no causes");
            assert!(lines().any(|line| line.starts_with("Mend: ")), "{code} has no cure");
            assert!(lines().any(|line| line.starts_with("    ")), "{code} has no example");
        }
    }

    /// `Failure::refused` takes nothing without a code; this is for errors that nobody has met yet.
    #[test]
    fn every_error_type_of_the_library_has_codes() {
        let sources = sources();
        let is_of_codes = |path: &Path| path.iter().any(|part| part == "error_code" || part == "error_code.rs");
        let codes: String =
            sources.iter().filter(|(path, _)| is_of_codes(path)).map(|(_, text)| text.as_str()).collect();
        let given = |name: &str| {
            codes.lines().any(|line| {
                line.strip_prefix("impl ErrorCode for ")
                    .is_some_and(|rest| rest.trim_end_matches(" {").rsplit("::").next() == Some(name))
            })
        };
        let count = |name: &str| codes.matches(&format!("{name} {{\n    fn code")).count();
        let mut inputs = 0;
        for (path, text) in &sources {
            let derived = text.split("#[derive(").skip(1).filter(|rest| {
                rest.split_once(')').is_some_and(|(list, _)| list.split(", ").any(|item| item.ends_with("Error")))
            });
            for rest in derived {
                let declaration =
                    rest.lines().find(|line| line.starts_with("pub enum ") || line.starts_with("pub struct "));
                let Some(name) = declaration.and_then(|line| line.split([' ', '(', '<']).nth(2)) else { continue };
                assert!(given(name), "{}: {name} has no codes in error_code", path.display());
                inputs += usize::from(name == "InputError");
            }
        }
        assert_eq!(count("InputError"), inputs, "each InputError has its own codes");
    }
}
