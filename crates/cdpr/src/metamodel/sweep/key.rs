//! Which number of which file a parameter is.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;
use toml::{Table, Value};

/// The place of a number in robot or study files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Key {
    /// Files that hold it.
    pub place: Place,
    steps: Vec<Word>,
}

/// Files that a key changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    /// The robot of the control model.
    Control,
    /// The robot of the machine.
    Machine,
    /// Both robots.
    Both,
    /// The study.
    Study,
    /// The pulleys of the machine, placed at the initial pose.
    PlacedPulleys,
}

impl Place {
    /// True where a key of this place changes what another place names: `both` changes control model and machine.
    pub(super) fn covers(self, other: Self) -> bool {
        self == other || (self == Self::Both && matches!(other, Self::Control | Self::Machine))
    }
}

/// One step into a file.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Word {
    Name(String),
    /// An entry of a list, from 0; all of them.
    Entry(Option<usize>),
}

/// A key that leads nowhere.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum KeyError {
    /// No such file.
    #[error(
        "`{key}` names no file: begin with `control.`, `machine.`, `both.` or `study.`, or write `placed_pulley_radius_m`"
    )]
    Place {
        /// The key.
        key: String,
    },
    /// Brackets without a number.
    #[error("`{key}`: entries are [1], [2], … or [*] for all of them")]
    Entry {
        /// The key.
        key: String,
    },
    /// The file has nothing there.
    #[error("`{key}`: {reason}")]
    Nowhere {
        /// The key.
        key: String,
        /// Fault of its way.
        reason: KeyReason,
    },
}

/// Fault of a key's way through a file.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum KeyReason {
    /// A table or list that is missing on the way.
    #[error("there is no `{name}`")]
    NoTable {
        /// Its name.
        name: String,
    },
    /// A list that is shorter.
    #[error("there are {count} entries, not {entry}")]
    NoEntry {
        /// Entry asked for, from 1.
        entry: usize,
        /// Entries of the list.
        count: usize,
    },
    /// A name behind what is not a table.
    #[error("`{name}` stands in no table")]
    InNoTable {
        /// The name.
        name: String,
    },
    /// Brackets behind what is not a list.
    #[error("brackets stand behind lists only")]
    InNoList,
}

impl FromStr for Key {
    type Err = KeyError;

    fn from_str(key: &str) -> Result<Self, KeyError> {
        if key == "placed_pulley_radius_m" {
            return Ok(Self { place: Place::PlacedPulleys, steps: Vec::new() });
        }
        let nowhere = || KeyError::Place { key: key.to_owned() };
        let (place, rest) = key.split_once('.').ok_or_else(nowhere)?;
        let place = match place {
            "control" => Place::Control,
            "machine" => Place::Machine,
            "both" => Place::Both,
            "study" => Place::Study,
            _ => return Err(nowhere()),
        };
        let mut steps = Vec::new();
        for part in rest.split('.') {
            let mut words = part.split('[');
            steps.push(Word::Name(words.next().unwrap_or_default().to_owned()));
            for word in words {
                let entry = match word.strip_suffix(']') {
                    Some("*") => None,
                    Some(number) => Some(number.parse::<usize>().ok().and_then(|number| number.checked_sub(1))),
                    None => Some(None),
                };
                match entry {
                    Some(None) => return Err(KeyError::Entry { key: key.to_owned() }),
                    Some(number) => steps.push(Word::Entry(number)),
                    None => steps.push(Word::Entry(None)),
                }
            }
        }
        Ok(Self { place, steps })
    }
}

impl fmt::Display for Key {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = match self.place {
            Place::Control => "control",
            Place::Machine => "machine",
            Place::Both => "both",
            Place::Study => "study",
            Place::PlacedPulleys => return formatter.write_str("placed_pulley_radius_m"),
        };
        write!(formatter, "{place}.{}", self.inside())
    }
}

impl Key {
    /// The key inside its file, as `cable[*].pulley_radius_m`.
    pub(super) fn inside(&self) -> String {
        let mut text = String::new();
        for step in &self.steps {
            match step {
                Word::Name(name) if text.is_empty() => text.push_str(name),
                Word::Name(name) => text.extend([".", name]),
                Word::Entry(Some(index)) => text.push_str(&format!("[{}]", index + 1)),
                Word::Entry(None) => text.push_str("[*]"),
            }
        }
        text
    }

    /// Writes a number at the key's place of a file; a key that the last table lacks is added.
    pub(crate) fn set(&self, file: &mut Table, value: f64) -> Result<(), KeyError> {
        let nowhere = |reason| KeyError::Nowhere { key: self.to_string(), reason };
        let mut whole = Value::Table(std::mem::take(file));
        let done = set(&mut whole, &self.steps, value).map_err(nowhere);
        if let Value::Table(table) = whole {
            *file = table;
        }
        done
    }
}

fn set(here: &mut Value, steps: &[Word], value: f64) -> Result<(), KeyReason> {
    let Some((step, rest)) = steps.split_first() else {
        *here = Value::Float(value);
        return Ok(());
    };
    match (step, here) {
        (Word::Name(name), Value::Table(table)) => match table.get_mut(name) {
            Some(next) => set(next, rest, value),
            None if rest.is_empty() => {
                table.insert(name.clone(), Value::Float(value));
                Ok(())
            }
            None => Err(KeyReason::NoTable { name: name.clone() }),
        },
        (Word::Entry(Some(index)), Value::Array(list)) => {
            let count = list.len();
            let entry = list.get_mut(*index).ok_or(KeyReason::NoEntry { entry: index + 1, count })?;
            set(entry, rest, value)
        }
        (Word::Entry(None), Value::Array(list)) => list.iter_mut().try_for_each(|entry| set(entry, rest, value)),
        (Word::Name(name), _) => Err(KeyReason::InNoTable { name: name.clone() }),
        (Word::Entry(_), _) => Err(KeyReason::InNoList),
    }
}
