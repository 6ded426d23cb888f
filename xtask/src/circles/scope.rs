//! Modules of a crate, and the files that define the names in their scope.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path as FilePath;

use super::graph::{Graph, Use};
use super::names::{Import, Names, Path};
use super::tokens::{product_tokens, test_modules};

/// The modules of one crate.
pub(crate) struct Crate {
    /// Its name in paths.
    name: String,
    modules: BTreeMap<Path, Module>,
    tests: Vec<Path>,
}

struct Module {
    file: String,
    names: Names,
}

/// The thing that a name stands for: a module, or an item by the file that defines it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Thing {
    Module(Path),
    /// Item with names inside: a type, or one that no text shows.
    Type(String),
    /// Function, constant or macro.
    Value(String),
}

/// Imports that are being followed, by module, place and the name in question.
type Followed = BTreeSet<(Path, usize, String)>;

impl Crate {
    /// `folder` is the crate's folder, which has its name.
    pub(crate) fn new(folder: &str) -> Self {
        let name = folder.rsplit('/').next().unwrap_or_default().replace('-', "_");
        Self { name, modules: BTreeMap::new(), tests: Vec::new() }
    }

    /// Adds a file by its place under `src`.
    pub(crate) fn add(&mut self, inside: &FilePath, text: &str) {
        let mut path: Path = inside.with_extension("").iter().map(|part| part.to_string_lossy().into_owned()).collect();
        if path.last().is_some_and(|last| last == "mod") || path == ["lib"] || path == ["main"] {
            path.pop();
        }
        self.tests.extend(test_modules(text).into_iter().map(|name| child(&path, &name)));
        self.add_module(path, &inside.display().to_string(), Names::of(&product_tokens(text)));
    }

    fn add_module(&mut self, path: Path, file: &str, mut names: Names) {
        for (name, inner) in std::mem::take(&mut names.inner) {
            self.add_module(child(&path, &name), file, inner);
        }
        self.modules.insert(path, Module { file: file.to_owned(), names });
    }

    /// Uses of files by files, without tests.
    pub(crate) fn graph(&self) -> Graph {
        let mut graph = Graph::default();
        let is_test = |path: &Path| self.tests.iter().any(|test| path.starts_with(test));
        for (path, module) in self.modules.iter().filter(|(path, _)| !is_test(path)) {
            let imports = module.names.imports.iter().filter(|import| !import.is_handed_on);
            let imports = imports.map(|import| (&import.path, import.line));
            for (used, line) in imports.chain(module.names.used.iter().map(|used| (&used.path, used.line))) {
                for thing in self.resolved(path, used, &mut Followed::new()) {
                    if let Thing::Type(file) | Thing::Value(file) = thing
                        && file != module.file
                    {
                        graph.add(Use { from: module.file.clone(), to: file, line, path: used.join("::") });
                    }
                }
            }
        }
        graph
    }

    /// Things that a path in a module names; none for other crates and local names.
    fn resolved(&self, module: &Path, path: &[String], followed: &mut Followed) -> BTreeSet<Thing> {
        let up = path.iter().take_while(|part| *part == "super").count();
        let (start, rest) = match path.first().map(String::as_str) {
            None => return BTreeSet::new(),
            Some("crate") => (BTreeSet::from([Thing::Module(Path::new())]), &path[1..]),
            Some("self") => (BTreeSet::from([Thing::Module(module.clone())]), &path[1..]),
            Some("super") => {
                let above = &module[..module.len().saturating_sub(up)];
                (BTreeSet::from([Thing::Module(above.to_vec())]), &path[up..])
            }
            Some(first) => match self.named(module, first, followed) {
                none if none.is_empty() && first == self.name => {
                    (BTreeSet::from([Thing::Module(Path::new())]), &path[1..])
                }
                found => (found, &path[1..]),
            },
        };
        rest.iter().fold(start, |things, name| {
            things.into_iter().flat_map(|thing| self.member(thing, name, followed)).collect()
        })
    }

    /// Things of a name inside another one. A name that a module does not show, as those that macros write, is its file's.
    fn member(&self, thing: Thing, name: &str, followed: &mut Followed) -> BTreeSet<Thing> {
        let Thing::Module(path) = &thing else {
            return if matches!(thing, Thing::Type(_)) { BTreeSet::from([thing]) } else { BTreeSet::new() };
        };
        let found = self.named(path, name, followed);
        match self.modules.get(path) {
            Some(module) if found.is_empty() => BTreeSet::from([Thing::Type(module.file.clone())]),
            _ => found,
        }
    }

    /// Things that a name in a module stands for.
    fn named(&self, path: &Path, name: &str, followed: &mut Followed) -> BTreeSet<Thing> {
        let inner = child(path, name);
        let mut found: BTreeSet<Thing> =
            self.modules.contains_key(&inner).then_some(Thing::Module(inner)).into_iter().collect();
        let Some(module) = self.modules.get(path) else { return found };
        if module.names.types.contains(name) {
            found.insert(Thing::Type(module.file.clone()));
        }
        if module.names.values.contains(name) {
            found.insert(Thing::Value(module.file.clone()));
        }
        let is_named = |import: &Import| import.name.as_deref() == Some(name);
        for (place, import) in module.names.imports.iter().enumerate().filter(|(_, import)| is_named(import)) {
            let step = (path.clone(), place, name.to_owned());
            if followed.insert(step.clone()) {
                found.extend(self.resolved(path, &import.path, followed));
                followed.remove(&step);
            }
        }
        if found.is_empty() {
            found = self.named_by_all(path, module, name, followed);
        }
        found
    }

    /// Things of a name that comes by `*`.
    fn named_by_all(&self, path: &Path, module: &Module, name: &str, followed: &mut Followed) -> BTreeSet<Thing> {
        let mut found = BTreeSet::new();
        for (place, import) in module.names.imports.iter().enumerate().filter(|(_, import)| import.name.is_none()) {
            let step = (path.clone(), place, name.to_owned());
            if followed.insert(step.clone()) {
                for thing in self.resolved(path, &import.path, followed) {
                    if let Thing::Module(other) = thing {
                        found.extend(self.named(&other, name, followed));
                    }
                }
                followed.remove(&step);
            }
        }
        found
    }
}

fn child(path: &Path, name: &str) -> Path {
    path.iter().cloned().chain([name.to_owned()]).collect()
}
