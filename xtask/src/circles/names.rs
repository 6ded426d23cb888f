//! Names of a module: defined in it, imported, and used in its code.

use std::collections::BTreeSet;

use super::tokens::{Token, after_group};

/// Names from the crate on.
pub(crate) type Path = Vec<String>;

/// A module as its text shows it, with the modules that are written inside it.
#[derive(Debug, Default)]
pub(crate) struct Names {
    /// Types, traits and enumerations that it defines.
    pub(crate) types: BTreeSet<String>,
    /// Functions, constants and macros that it defines.
    pub(crate) values: BTreeSet<String>,
    pub(crate) imports: Vec<Import>,
    pub(crate) used: Vec<Used>,
    pub(crate) inner: Vec<(String, Names)>,
}

/// One branch of a `use` tree.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Import {
    pub(crate) path: Path,
    /// Name by which it is known here, `None` for all names of a module (`*`).
    pub(crate) name: Option<String>,
    pub(crate) is_handed_on: bool,
    pub(crate) line: usize,
}

/// A path in the code itself.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Used {
    pub(crate) path: Path,
    pub(crate) line: usize,
}

impl Names {
    pub(crate) fn of(tokens: &[Token]) -> Self {
        let mut names = Self::default();
        let (mut at, mut depth) = (0, 0_usize);
        while at < tokens.len() {
            let before = at.checked_sub(1).map(|before| &tokens[before]);
            at = match tokens[at].text.as_str() {
                "use" if tokens.get(at + 1).is_some_and(|next| next.is_name() || next.is("::") || next.is("{")) => {
                    names.add_imports(tokens, at)
                }
                "mod" if depth == 0 && tokens.get(at + 2).is_some_and(|open| open.is("{")) => {
                    let after = after_group(tokens, at + 2);
                    let inner = Self::of(&tokens[at + 3..after - 1]);
                    names.inner.push((tokens[at + 1].text.clone(), inner));
                    after
                }
                "extern" if tokens.get(at + 1).is_some_and(|next| next.is("crate")) => names.add_extern(tokens, at),
                mark => {
                    match mark {
                        "{" => depth += 1,
                        "}" => depth = depth.saturating_sub(1),
                        _ => {}
                    }
                    if depth == 0 {
                        names.types.extend(definition(tokens, at, &["struct", "enum", "trait", "type"]));
                        names.values.extend(definition(tokens, at, &["fn", "const", "static", "macro_rules"]));
                    }
                    let starts_path = before.is_none_or(|before| !matches!(before.text.as_str(), "." | "::" | "fn"));
                    if tokens[at].is_name() && starts_path { names.add_used(tokens, at) } else { at + 1 }
                }
            };
        }
        names
    }

    fn add_imports(&mut self, tokens: &[Token], at: usize) -> usize {
        let after = (at..tokens.len()).find(|here| tokens[*here].is(";")).unwrap_or(tokens.len());
        // `pub use` or `pub(crate) use`
        let is_handed_on = tokens[at.saturating_sub(5)..at]
            .iter()
            .rev()
            .take_while(|token| token.is_name() || token.is("(") || token.is(")") || token.is("::"))
            .any(|token| token.is("pub"));
        let mut tree = Tree { tokens: &tokens[at + 1..after], is_handed_on, found: Vec::new() };
        tree.read(0, &[]);
        self.imports.append(&mut tree.found);
        after + 1
    }

    /// `extern crate self as name;`
    fn add_extern(&mut self, tokens: &[Token], at: usize) -> usize {
        if let [path, alias, name] = &tokens[(at + 2).min(tokens.len())..(at + 5).min(tokens.len())]
            && path.is("self")
            && alias.is("as")
        {
            let path = vec!["crate".to_owned()];
            self.imports.push(Import { path, name: Some(name.text.clone()), is_handed_on: false, line: name.line });
        }
        at + 2
    }

    /// A path of several names, the name of a type, or a function that is called.
    fn add_used(&mut self, tokens: &[Token], at: usize) -> usize {
        let mut path = vec![tokens[at].text.clone()];
        let mut here = at + 1;
        while let [separator, name, ..] = &tokens[here..]
            && separator.is("::")
            && name.is_name()
        {
            path.push(name.text.clone());
            here += 2;
        }
        let is_type = path[0].starts_with(char::is_uppercase);
        let is_called = tokens.get(here).is_some_and(|next| next.is("(") || next.is("!") || next.is("::"));
        if path.len() > 1 || is_type || is_called {
            self.used.push(Used { path, line: tokens[at].line });
        }
        here
    }
}

/// The name that an item at `at` defines if it is of one of these kinds.
fn definition(tokens: &[Token], at: usize, kinds: &[&str]) -> Option<String> {
    let name = tokens.get(if tokens[at].is("macro_rules") { at + 2 } else { at + 1 })?;
    (kinds.contains(&tokens[at].text.as_str()) && name.is_name()).then(|| name.text.clone())
}

/// The reader of a `use` tree.
struct Tree<'t> {
    tokens: &'t [Token],
    is_handed_on: bool,
    found: Vec<Import>,
}

impl Tree<'_> {
    /// Reads one branch from `at` on and returns the place after it.
    fn read(&mut self, mut at: usize, before: &[String]) -> usize {
        let mut path = before.to_vec();
        while let Some(token) = self.tokens.get(at) {
            match token.text.as_str() {
                "::" => at += 1,
                "{" => return self.read_group(at, &path),
                "*" => {
                    self.push(path, None, at);
                    return at + 1;
                }
                "as" => {
                    let name = self.tokens.get(at + 1).map(|name| name.text.clone());
                    self.push(path, name, at);
                    return at + 2;
                }
                "," | "}" => break,
                "self" if path.len() == before.len() && !before.is_empty() => at += 1,
                _ => {
                    path.push(token.text.clone());
                    at += 1;
                }
            }
        }
        if let Some(name) = path.last().cloned() {
            self.push(path, Some(name), at);
        }
        at
    }

    fn read_group(&mut self, open: usize, path: &[String]) -> usize {
        let mut at = open + 1;
        while let Some(token) = self.tokens.get(at) {
            match token.text.as_str() {
                "}" => return at + 1,
                "," => at += 1,
                _ => at = self.read(at, path),
            }
        }
        at
    }

    fn push(&mut self, path: Path, name: Option<String>, at: usize) {
        let line = self.tokens[at.min(self.tokens.len() - 1)].line;
        self.found.push(Import { path, name, is_handed_on: self.is_handed_on, line });
    }
}

#[cfg(test)]
mod tests {
    use super::super::tokens::product_tokens;
    use super::*;

    fn names(text: &str) -> Names {
        Names::of(&product_tokens(text))
    }

    #[test]
    fn every_branch_of_a_use_tree_is_an_import_with_its_name() {
        let found = names("pub(crate) use a::{b, c::{self, d as e}, f::*};\nuse super::g;\n").imports;
        let told: Vec<String> = found
            .iter()
            .map(|one| format!("{} {} {}", one.path.join("::"), one.name.as_deref().unwrap_or("*"), one.is_handed_on))
            .collect();
        assert_eq!(told, ["a::b b true", "a::c c true", "a::c::d e true", "a::f * true", "super::g g false"]);
        assert_eq!(found[4].line, 2);
    }

    #[test]
    fn methods_and_fields_are_no_names_of_the_module() {
        let found = names("pub struct Fit { fit: f64 }\nimpl Fit { pub fn run(&self) { self.fit(); step(2) } }\n");
        assert!(found.types.iter().eq(["Fit"]) && found.values.is_empty());
        let used: Vec<String> = found.used.iter().map(|one| one.path.join("::")).collect();
        assert_eq!(used, ["Fit", "Fit", "step"]);
    }
}
