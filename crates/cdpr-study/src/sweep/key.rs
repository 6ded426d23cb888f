//! Key of a number in a robot or another file that a parameter of a sweep changes.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;
use toml::{Table, Value};

use cdpr_model::robot::{Parameter, Robot};

/// Key of a number in robot or study files.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Key {
    /// Files that have the number.
    pub place: KeyTarget,
    steps: Vec<Word>,
}

/// Files that a key changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum KeyTarget {
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

impl KeyTarget {
    /// True if a key of this place changes the other place: `both` changes control model and machine.
    pub(super) fn covers(self, other: Self) -> bool {
        self == other || (self == Self::Both && matches!(other, Self::Control | Self::Machine))
    }
}

/// One step into a file.
#[derive(Clone, Debug, PartialEq, Eq)]
enum Word {
    Name(String),
    /// An entry of a list, from 0; `None` stands for all entries.
    Entry(Option<usize>),
}

/// A key that does not exist.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum KeyError {
    /// The key names no file.
    #[error(
        "`{key}` names no file: begin with `control.`, `machine.`, `both.` or `study.`, or write `placed_pulley_radius_m`"
    )]
    Place {
        /// The key.
        key: String,
    },
    /// A parameter that the robot does not have.
    #[error("`{key}`: the robot has no parameter of this name: no such cable, component or axis")]
    NoParameter {
        /// The key.
        key: String,
    },
    /// Brackets without a valid number.
    #[error("`{key}`: entries are [1], [2], … or [*] for all of them")]
    Entry {
        /// The key.
        key: String,
    },
    /// The file has no such key.
    #[error("`{key}`: {reason}")]
    Nowhere {
        /// The key.
        key: String,
        /// Reason for which the path does not exist.
        reason: KeyReason,
    },
}

/// Reason for which the path of a key does not exist.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum KeyReason {
    /// A table or list on the path is missing.
    #[error("there is no `{name}`")]
    NoTable {
        /// Name of the table or list.
        name: String,
    },
    /// A list with fewer entries.
    #[error("there are {count} entries, not {entry}")]
    NoEntry {
        /// Requested entry, from 1.
        entry: usize,
        /// Number of entries of the list.
        count: usize,
    },
    /// A name after a value that is not a table.
    #[error("`{name}` stands in no table")]
    InNoTable {
        /// The name.
        name: String,
    },
    /// Brackets after a value that is not a list.
    #[error("brackets stand behind lists only")]
    InNoList,
}

impl FromStr for Key {
    type Err = KeyError;

    fn from_str(key: &str) -> Result<Self, KeyError> {
        if key == "placed_pulley_radius_m" {
            return Ok(Self { place: KeyTarget::PlacedPulleys, steps: Vec::new() });
        }
        let nowhere = || KeyError::Place { key: key.to_owned() };
        let (place, rest) = key.split_once('.').ok_or_else(nowhere)?;
        let place = match place {
            "control" => KeyTarget::Control,
            "machine" => KeyTarget::Machine,
            "both" => KeyTarget::Both,
            "study" => KeyTarget::Study,
            _ => return Err(nowhere()),
        };
        Ok(Self { place, steps: steps_of(rest, key)? })
    }
}

/// Steps of a key inside its file; `whole` is the key in errors.
fn steps_of(inside: &str, whole: &str) -> Result<Vec<Word>, KeyError> {
    let mut steps = Vec::new();
    for part in inside.split('.') {
        let mut words = part.split('[');
        steps.push(Word::Name(words.next().unwrap_or_default().to_owned()));
        for word in words {
            let entry = match word.strip_suffix(']') {
                Some("*") => None,
                Some(number) => Some(number.parse::<usize>().ok().and_then(|number| number.checked_sub(1))),
                None => Some(None),
            };
            match entry {
                Some(None) => return Err(KeyError::Entry { key: whole.to_owned() }),
                Some(number) => steps.push(Word::Entry(number)),
                None => steps.push(Word::Entry(None)),
            }
        }
    }
    Ok(steps)
}

impl fmt::Display for Key {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let place = match self.place {
            KeyTarget::Control => "control",
            KeyTarget::Machine => "machine",
            KeyTarget::Both => "both",
            KeyTarget::Study => "study",
            KeyTarget::PlacedPulleys => return formatter.write_str("placed_pulley_radius_m"),
        };
        write!(formatter, "{place}.{}", self.inside())
    }
}

impl Key {
    /// The name or the key inside its file, e.g. `frame-anchor[1].x` or `cable[*].pulley_radius_m`.
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

    /// Parameters of a robot that the key names, by name or by key of files; `None` for a key that is no parameter.
    pub(super) fn parameters(&self, robot: &Robot) -> Result<Option<Vec<Parameter>>, KeyError> {
        // turning an axis that the robot does not state has no effect
        let is_there = |parameter: &Parameter| parameter.key(robot).is_some() || parameter.get(robot).is_some();
        match Parameter::named(&self.inside(), robot) {
            Some(found) if found.iter().all(is_there) => Ok(Some(found)),
            None if !self.is_name(robot) => Ok(None),
            _ => Err(KeyError::NoParameter { key: self.to_string() }),
        }
    }

    /// True for names of parameters, e.g. `frame-anchor[1].x` or `axial-stiffness` of all cables; false for keys of
    /// files.
    fn is_name(&self, robot: &Robot) -> bool {
        let is_of = |name: &str| robot.parameters().any(|parameter| parameter.kind.name() == name);
        matches!(self.steps.first(), Some(Word::Name(name)) if is_of(name))
    }

    /// Writes a number at the key's place in a file; a key that the last table lacks is added. Names of parameters of
    /// the file's robot are written at their keys; those without a key are skipped.
    pub(crate) fn set(&self, file: &mut Table, value: f64, robot: Option<&Robot>) -> Result<(), KeyError> {
        let nowhere = |reason| KeyError::Nowhere { key: self.to_string(), reason };
        let places = match robot.filter(|robot| self.is_name(robot)) {
            None => vec![self.steps.clone()],
            Some(robot) => {
                let parameters = self.parameters(robot)?.unwrap_or_default();
                let keys = parameters.iter().filter_map(|parameter| parameter.key(robot));
                keys.map(|key| steps_of(&key, &key)).collect::<Result<Vec<_>, _>>()?
            }
        };
        let mut whole = Value::Table(std::mem::take(file));
        let done = places.iter().try_for_each(|steps| set(&mut whole, steps, value)).map_err(nowhere);
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
