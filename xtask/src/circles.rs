//! Circles of files: no file of a room uses another one that leads back to it.
//!
//! Uses are read from the text: `use` trees with `crate::`, `super::` or `self::`, and paths through a file's own submodules. A name that a module
//! hands on is the file's that defines it; what a `mod.rs` only hands on is no use of its own. Tests do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Place of a module: the names from the library on.
type Module = Vec<String>;

/// Circles of files in a library, each as the files in it.
pub(crate) fn circles(source: &Path, files: &[PathBuf]) -> Vec<Vec<String>> {
    let mut library = Library::default();
    for path in files {
        let (Ok(inside), Ok(text)) = (path.strip_prefix(source), std::fs::read_to_string(path)) else { continue };
        library.add(inside, &text);
    }
    library.circles()
}

#[derive(Default)]
struct Library {
    files: BTreeMap<Module, File>,
}

struct File {
    name: String,
    code: String,
    /// Names that it defines.
    defined: BTreeSet<String>,
    uses: Vec<Use>,
}

/// One branch of a `use` tree.
struct Use {
    path: Vec<String>,
    /// Name under which it is known here.
    name: String,
    hands_on: bool,
}

impl Library {
    fn add(&mut self, inside: &Path, text: &str) {
        let mut module: Module =
            inside.with_extension("").iter().map(|part| part.to_string_lossy().into_owned()).collect();
        if module.last().is_some_and(|last| last == "mod") {
            module.pop();
        }
        let is_test = |part: &String| part == "tests" || part == "oracles" || part.ends_with("_tests");
        if module.iter().any(is_test) {
            return;
        }
        let code = plain_code(text);
        let file = File { name: inside.display().to_string(), defined: defined(&code), uses: uses(&code), code };
        self.files.insert(module, file);
    }

    fn circles(&self) -> Vec<Vec<String>> {
        let reached: BTreeMap<&Module, BTreeSet<&Module>> =
            self.files.keys().map(|module| (module, self.reached(module))).collect();
        let mut found: BTreeSet<Vec<String>> = BTreeSet::new();
        for (module, targets) in &reached {
            if targets.contains(*module) {
                let back = |other: &&&Module| reached[**other].contains(*module);
                found.insert(targets.iter().filter(back).map(|other| self.files[*other].name.clone()).collect());
            }
        }
        found.into_iter().collect()
    }

    /// Files of the same room that a file uses, and those that they use.
    fn reached<'l>(&'l self, from: &Module) -> BTreeSet<&'l Module> {
        let mut open = vec![from];
        let mut reached = BTreeSet::new();
        while let Some(module) = open.pop() {
            for target in self.used(module) {
                if target != module && target[0] == from[0] && reached.insert(target) {
                    open.push(target);
                }
            }
        }
        reached
    }

    fn used<'l>(&'l self, module: &Module) -> BTreeSet<&'l Module> {
        let file = &self.files[module];
        let own = file.uses.iter().filter(|one| !one.hands_on).filter_map(|one| self.absolute(module, &one.path));
        let inline = paths(&file.code).into_iter().filter_map(|path| self.absolute(module, &path));
        own.chain(inline).filter_map(|path| self.resolved(&path, 0)).collect()
    }

    /// A path from the library on; nothing for other crates and local names.
    fn absolute(&self, module: &Module, path: &[String]) -> Option<Module> {
        match path.first()?.as_str() {
            "crate" => Some(path[1..].to_vec()),
            "self" => Some([module, &path[1..]].concat()),
            "super" => {
                let up = path.iter().take_while(|part| *part == "super").count();
                let above = module.len().checked_sub(up)?;
                Some([&module[..above], &path[up..]].concat())
            }
            first => {
                let child = [module.as_slice(), &[first.to_owned()]].concat();
                self.files.contains_key(&child).then(|| [module, path].concat())
            }
        }
    }

    /// The module whose file defines what a path names.
    fn resolved(&self, path: &[String], depth: usize) -> Option<&Module> {
        if path.is_empty() || depth > 20 {
            return None;
        }
        if let Some((module, _)) = self.files.get_key_value(path) {
            return Some(module);
        }
        let (name, parent) = path.split_last()?;
        let Some((module, file)) = self.files.get_key_value(parent) else { return self.resolved(parent, depth + 1) };
        if file.defined.contains(name) {
            return Some(module);
        }
        let handed = file.uses.iter().find(|one| one.name == *name);
        match handed.and_then(|one| self.absolute(module, &one.path)) {
            Some(target) if target != path => self.resolved(&target, depth + 1).or(Some(module)),
            _ => Some(module),
        }
    }
}

/// The text without comments, contents of strings and unit tests.
fn plain_code(text: &str) -> String {
    let text = text.split("\n#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let mut code = String::new();
    for line in text.lines() {
        let (mut in_string, mut is_escaped) = (false, false);
        let line = if line.trim_start().starts_with("//") { "" } else { line };
        let mut letters = line.chars().peekable();
        while let Some(letter) = letters.next() {
            match letter {
                '/' if !in_string && letters.peek() == Some(&'/') => break,
                '"' if !is_escaped => in_string = !in_string,
                _ if !in_string => code.push(letter),
                _ => {}
            }
            is_escaped = letter == '\\' && !is_escaped;
        }
        code.push('\n');
    }
    code
}

fn words(code: &str) -> Vec<&str> {
    code.split(|letter: char| !(letter.is_alphanumeric() || letter == '_')).filter(|word| !word.is_empty()).collect()
}

fn defined(code: &str) -> BTreeSet<String> {
    const KINDS: [&str; 7] = ["fn", "struct", "enum", "trait", "const", "static", "type"];
    let names = |line: &str| {
        let all = words(line);
        let at = all.iter().rposition(|word| KINDS.contains(word))?;
        all.get(at + 1).map(|name| (*name).to_owned())
    };
    let head = |line: &&str| {
        let first = line.trim_start();
        ["pub", "fn ", "struct ", "enum ", "trait ", "const ", "static ", "type "]
            .iter()
            .any(|word| first.starts_with(word))
    };
    code.lines().filter(head).filter_map(|line| names(line.split(['(', '{', '=', ':', '<', ';']).next()?)).collect()
}

fn uses(code: &str) -> Vec<Use> {
    let mut all = Vec::new();
    for statement in code.split(';') {
        let Some(start) = statement.find("use ").filter(|&start| {
            let before = statement[..start].trim_end();
            let line = before.rsplit('\n').next().unwrap_or_default().trim();
            line.is_empty() || line.starts_with("pub")
        }) else {
            continue;
        };
        let line = statement[..start].rsplit('\n').next().unwrap_or_default();
        let hands_on = line.contains("pub");
        for branch in branches(statement[start + 4..].trim()) {
            let (path, alias) =
                branch.split_once(" as ").map_or((branch.as_str(), None), |(path, name)| (path, Some(name)));
            let path: Vec<String> =
                path.split("::").map(|part| part.trim().to_owned()).filter(|part| !part.is_empty()).collect();
            let Some(last) = path.last().cloned() else { continue };
            all.push(Use { name: alias.map_or(last, |name| name.trim().to_owned()), path, hands_on });
        }
    }
    all
}

/// `a::{b, c::{d, self}}` as `a::b`, `a::c::d`, `a::c`.
fn branches(tree: &str) -> Vec<String> {
    let Some(open) = tree.find('{') else { return vec![tree.trim_end_matches("::self").to_owned()] };
    let (before, inside) = (&tree[..open], tree[open + 1..].trim_end().trim_end_matches('}'));
    let (mut depth, mut part, mut parts) = (0_usize, String::new(), Vec::new());
    for letter in inside.chars() {
        match letter {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            ',' if depth == 0 => {
                parts.push(std::mem::take(&mut part));
                continue;
            }
            _ => {}
        }
        part.push(letter);
    }
    parts.push(part);
    let whole = |part: &String| match part.matches('{').count() > part.matches('}').count() {
        true => format!("{part}}}"),
        false => part.clone(),
    };
    let parts = parts.iter().filter(|part| !part.trim().is_empty()).map(whole);
    parts.flat_map(|part| branches(&format!("{before}{}", part.trim()))).collect()
}

/// `module::name` in the code itself.
fn paths(code: &str) -> Vec<Vec<String>> {
    let is_of_name = |letter: char| letter.is_alphanumeric() || letter == '_';
    let lines = code.split(';').filter(|statement| !statement.trim_start().trim_start_matches("pub").contains("use "));
    let mut found = Vec::new();
    for statement in lines {
        for (at, _) in statement.match_indices("::") {
            let first: String = statement[..at].chars().rev().take_while(|letter| is_of_name(*letter)).collect();
            let first: String = first.chars().rev().collect();
            let before = statement[..at - first.len()].chars().next_back();
            let second: String = statement[at + 2..].chars().take_while(|letter| is_of_name(*letter)).collect();
            let is_module = first.starts_with(|letter: char| letter.is_ascii_lowercase());
            if is_module && before != Some(':') && !second.is_empty() {
                found.push(vec![first, second]);
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(files: &[(&str, &str)]) -> Vec<Vec<String>> {
        let mut library = Library::default();
        files.iter().for_each(|(name, text)| library.add(Path::new(name), text));
        library.circles()
    }

    #[test]
    fn two_files_that_use_each_other_are_a_circle() {
        let drum = ("winch/drum.rs", "use super::layers::Layer;\npub struct Drum(Layer);\n");
        let layers = ("winch/layers.rs", "use super::drum::Drum;\npub struct Layer;\nfn f(drum: &Drum) {}\n");
        assert_eq!(found(&[drum, layers]), [["winch/drum.rs", "winch/layers.rs"]]);
        let alone = ("winch/layers.rs", "pub struct Layer;\n// use super::drum::Drum;\n");
        assert!(found(&[drum, alone]).is_empty());
    }

    #[test]
    fn names_that_a_module_hands_on_are_those_of_the_file_that_defines_them() {
        let module = ("mesh/mod.rs", "mod field;\nmod writing;\npub use field::{Field, Unit as Measure};\n");
        let field = ("mesh/field.rs", "pub struct Field;\npub struct Unit;\n");
        let writing = ("mesh/writing.rs", "use super::{Field, Measure};\nfn write(field: &Field) {}\n");
        assert!(found(&[module, field, writing]).is_empty());
        let back = (
            "mesh/field.rs",
            "use crate::mesh::writing;\npub struct Field;\npub struct Unit;\nfn f() { writing::write() }\n",
        );
        assert_eq!(found(&[module, back, writing]).len(), 1);
    }

    #[test]
    fn a_module_that_calls_a_child_which_uses_it_is_a_circle() {
        let module = ("solve/mod.rs", "mod descend;\npub struct Rules;\npub fn f() { descend::descend(&Rules) }\n");
        let child = ("solve/descend.rs", "use super::Rules;\npub fn descend(rules: &Rules) {}\n");
        assert_eq!(found(&[module, child]).len(), 1);
        let apart = ("solve/mod.rs", "mod descend;\nmod rules;\npub use descend::descend;\npub use rules::Rules;\n");
        assert!(found(&[apart, child, ("solve/rules.rs", "pub struct Rules;\n")]).is_empty());
    }

    #[test]
    fn other_rooms_tests_and_strings_do_not_count() {
        let one = ("cable/law.rs", "use crate::model::Model;\nconst CODE: &str = \"winch::drum\";\n");
        let other = ("model/model.rs", "use crate::cable::law;\npub struct Model;\n");
        let tests = ("cable/tests.rs", "use super::law;\n");
        assert!(found(&[one, other, tests]).is_empty());
    }
}
