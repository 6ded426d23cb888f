//! Tables of a scenario from lists of their keys: the same list reads a table, refuses unknown keys, and describes the
//! table to editors.

mod reading;
mod schema;

pub(super) use reading::TableSeed;
pub(super) use schema::{kinds_schema, table_schema};

use super::error::{PlantError, ScenarioKey};

/// Key of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Key {
    /// Name, with its unit.
    pub(super) name: &'static str,
    /// Description in a line.
    pub(super) summary: &'static str,
    /// Form of the value.
    pub(super) shape: Shape,
    /// Value in a table that does not state the key.
    pub(super) missing: Missing,
}

/// Form of a value.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    /// A number.
    Number,
    /// A number of 0 or more.
    NotNegative,
    /// A number above 0.
    Positive,
    /// A whole number of 0 or more.
    Whole,
    /// The number of a cable, from 1.
    Cable,
    /// A list of numbers.
    Numbers,
    /// Three numbers.
    Vector,
    /// A list of lists of numbers.
    Rows,
    /// One of these words.
    Word(fn() -> Vec<Word>),
    /// A table with these keys.
    Table(&'static [Key]),
    /// A list of tables with these keys.
    Tables(&'static [Key]),
}

/// Effect of a key that is not stated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Missing {
    /// The table is refused.
    Refused,
    /// The reader handles the missing value.
    Allowed,
    /// The key has this default.
    Number(f64),
}

/// Word with its meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Word {
    /// The word.
    pub(super) name: &'static str,
    /// Meaning in a line.
    pub(super) summary: &'static str,
}

/// Kind of a table: its word and the keys that belong to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Kind {
    /// The word.
    pub(super) word: Word,
    /// Keys in addition to those of all kinds.
    pub(super) keys: &'static [Key],
}

impl Key {
    /// A key that every table of its kind must state.
    pub(super) const fn needed(name: &'static str, shape: Shape, summary: &'static str) -> Self {
        Self { name, summary, shape, missing: Missing::Refused }
    }

    /// A key that a table may state.
    pub(super) const fn optional(name: &'static str, shape: Shape, summary: &'static str) -> Self {
        Self { name, summary, shape, missing: Missing::Allowed }
    }

    /// A key of a number with a default.
    pub(super) const fn with_default(name: &'static str, number: f64, shape: Shape, summary: &'static str) -> Self {
        Self { name, summary, shape, missing: Missing::Number(number) }
    }
}

impl Word {
    pub(super) const fn new(name: &'static str, summary: &'static str) -> Self {
        Self { name, summary }
    }
}

/// Value of a key.
#[derive(Clone, Debug, PartialEq)]
enum Value {
    Number(f64),
    Whole(u64),
    Numbers(Vec<f64>),
    Rows(Vec<Vec<f64>>),
    Word(&'static str),
    Table(Stated),
    Tables(Vec<Stated>),
}

/// Values that a table states, by its keys.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Stated {
    values: Vec<(&'static str, Value)>,
}

impl Stated {
    fn value(&self, key: &str) -> Option<&Value> {
        self.values.iter().find(|(name, _)| *name == key).map(|(_, value)| value)
    }

    /// A number; `None` if it is not stated.
    pub(super) fn number(&self, key: &str) -> Option<f64> {
        if let Value::Number(number) = self.value(key)? { Some(*number) } else { None }
    }

    /// A number with a default or a needed one; 0 for a table that was never read.
    pub(super) fn number_or_zero(&self, key: &str) -> f64 {
        self.number(key).unwrap_or(0.0)
    }

    /// A whole number; `None` if it is not stated.
    pub(super) fn whole(&self, key: &str) -> Option<u64> {
        if let Value::Whole(number) = self.value(key)? { Some(*number) } else { None }
    }

    /// A list of numbers; `None` if it is not stated.
    pub(super) fn numbers(&self, key: &str) -> Option<&[f64]> {
        if let Value::Numbers(numbers) = self.value(key)? { Some(numbers) } else { None }
    }

    /// Three numbers; zeros if they are not stated.
    pub(super) fn vector(&self, key: &str) -> [f64; 3] {
        self.numbers(key).and_then(|numbers| numbers.try_into().ok()).unwrap_or_default()
    }

    /// Rows of numbers; `None` if they are not stated.
    pub(super) fn rows(&self, key: &str) -> Option<&[Vec<f64>]> {
        if let Value::Rows(rows) = self.value(key)? { Some(rows) } else { None }
    }

    /// A word; `None` if it is not stated.
    pub(super) fn word(&self, key: &str) -> Option<&'static str> {
        if let Value::Word(word) = self.value(key)? { Some(word) } else { None }
    }

    /// A table; `None` if it is not stated.
    pub(super) fn table(&self, key: &str) -> Option<&Stated> {
        if let Value::Table(table) = self.value(key)? { Some(table) } else { None }
    }

    /// A list of tables; empty if it is not stated.
    pub(super) fn tables(&self, key: &str) -> &[Stated] {
        if let Some(Value::Tables(tables)) = self.value(key) { tables } else { &[] }
    }

    /// Checks that numbers lie in the ranges of their keys; `place` gives the scenario key for a key of the table.
    pub(super) fn check_ranges(
        &self,
        keys: &[Key],
        place: impl Fn(&'static str) -> ScenarioKey,
    ) -> Result<(), PlantError> {
        for key in keys {
            let Some(value) = self.number(key.name) else { continue };
            let (allowed, words) = match key.shape {
                Shape::NotNegative => (value >= 0.0, "0 or more"),
                Shape::Positive => (value > 0.0, "above 0"),
                _ => (true, "a finite number"),
            };
            if !allowed || !value.is_finite() {
                let message = format!("{} is {value}; it is {words}", key.name);
                return Err(PlantError::Value { key: place(key.name), message });
            }
        }
        Ok(())
    }
}

impl Kind {
    /// Checks that a table has the needed keys of this kind and none of another; the error names the key.
    #[cfg(feature = "files")]
    pub(super) fn check(&self, stated: &Stated, all: &[Kind]) -> Result<(), (&'static str, String)> {
        let word = self.word.name;
        let is_own = |name: &str| self.keys.iter().any(|key| key.name == name);
        for kind in all {
            let strange = kind.keys.iter().find(|key| stated.value(key.name).is_some() && !is_own(key.name));
            if let Some(key) = strange {
                return Err((key.name, format!("{} does not belong to kind = \"{word}\"", key.name)));
            }
        }
        let lacks = |key: &&Key| key.missing == Missing::Refused && stated.value(key.name).is_none();
        match self.keys.iter().find(lacks) {
            Some(key) => Err(("kind", format!("kind = \"{word}\" needs the key {}", key.name))),
            None => Ok(()),
        }
    }
}

/// Keys that a table may state before its kind is known: its own, then those of all kinds.
pub(super) fn allowed_keys(own: &[Key], kinds: &[Kind]) -> Vec<Key> {
    let mut all = own.to_vec();
    for key in kinds.iter().flat_map(|kind| kind.keys) {
        if all.iter().all(|known| known.name != key.name) {
            all.push(Key { missing: Missing::Allowed, ..*key });
        }
    }
    all
}

/// Rows of the book's table of kinds: word, meaning, keys.
#[cfg(test)]
pub(super) fn book_rows<'a>(kinds: impl Iterator<Item = (Word, &'a [Key])>) -> Vec<String> {
    let row = |(word, keys): (Word, &[Key])| {
        let key = |key: &Key| match key.missing {
            Missing::Refused => format!("`{}`", key.name),
            _ => format!("[`{}`]", key.name),
        };
        let keys: Vec<String> = keys.iter().map(key).collect();
        format!("| `{}` | {} | {} |", word.name, word.summary, keys.join(", "))
    };
    kinds.map(row).collect()
}

/// Rows that are missing in the book's chapter on machines in time.
#[cfg(test)]
pub(super) fn missing_in_book(rows: Vec<String>) -> Vec<String> {
    let chapter = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/book/src/dynamics.md");
    let chapter = std::fs::read_to_string(chapter).unwrap_or_default();
    rows.into_iter().filter(|row| !chapter.lines().any(|line| line == row)).collect()
}
