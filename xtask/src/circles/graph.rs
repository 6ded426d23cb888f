//! Files and their uses of each other, and the circles among them.

use std::collections::{BTreeMap, BTreeSet, VecDeque};

/// A use of a file by another one, with the line and the path that show it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Use {
    pub(crate) from: String,
    pub(crate) to: String,
    pub(crate) line: usize,
    pub(crate) path: String,
}

/// The uses of a crate's files, the first of each pair of files.
#[derive(Clone, Default)]
pub(crate) struct Graph {
    uses: BTreeMap<String, BTreeMap<String, Use>>,
}

impl Graph {
    pub(crate) fn add(&mut self, one: Use) {
        self.uses.entry(one.from.clone()).or_default().entry(one.to.clone()).or_insert(one);
    }

    pub(crate) fn has(&self, from: &str, to: &str) -> bool {
        self.uses.get(from).is_some_and(|uses| uses.contains_key(to))
    }

    pub(crate) fn remove(&mut self, from: &str, to: &str) {
        if let Some(uses) = self.uses.get_mut(from) {
            uses.remove(to);
        }
    }

    pub(crate) fn uses(&self) -> impl Iterator<Item = &Use> {
        self.uses.values().flat_map(BTreeMap::values)
    }

    /// Sets of files that all lead to each other.
    pub(crate) fn circles(&self) -> Vec<Vec<String>> {
        let reached: BTreeMap<&str, BTreeSet<&str>> =
            self.uses.keys().map(|file| (file.as_str(), self.reached(file))).collect();
        let mut found = BTreeSet::new();
        for (file, targets) in reached.iter().filter(|(file, targets)| targets.contains(*file)) {
            let leads_back = |other: &&&str| reached.get(**other).is_some_and(|back| back.contains(file));
            found.insert(targets.iter().filter(leads_back).map(|other| (*other).to_owned()).collect::<Vec<_>>());
        }
        found.into_iter().collect()
    }

    /// Files that a file uses, and those that they use.
    fn reached<'g>(&'g self, from: &'g str) -> BTreeSet<&'g str> {
        let mut open = vec![from];
        let mut reached = BTreeSet::new();
        while let Some(file) = open.pop() {
            open.extend(self.targets(file).map(|one| one.to.as_str()).filter(|to| reached.insert(*to)));
        }
        reached
    }

    fn targets(&self, file: &str) -> impl Iterator<Item = &Use> {
        self.uses.get(file).into_iter().flat_map(BTreeMap::values)
    }

    /// The uses on the shortest way from one file to another.
    pub(crate) fn shortest(&self, from: &str, to: &str) -> Option<Vec<&Use>> {
        let mut came: BTreeMap<&str, &Use> = BTreeMap::new();
        let mut open = VecDeque::from([from]);
        while let Some(file) = open.pop_front() {
            for one in self.targets(file) {
                if !came.contains_key(one.to.as_str()) {
                    came.insert(&one.to, one);
                    open.push_back(&one.to);
                }
            }
        }
        let mut way = vec![*came.get(to)?];
        while way[way.len() - 1].from != from {
            way.push(came.get(way[way.len() - 1].from.as_str())?);
        }
        way.reverse();
        Some(way)
    }
}
