//! Reading of tables from a file, by their keys.

use std::fmt;

use serde::Deserialize;
use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::{Key, Missing, Shape, Stated, Value, Word};

/// Reader of a table with these keys; it refuses unknown keys and missing needed ones.
pub(crate) struct TableSeed<'k>(pub(crate) &'k [Key]);

impl<'de> DeserializeSeed<'de> for TableSeed<'_> {
    type Value = Stated;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Stated, D::Error> {
        deserializer.deserialize_map(self)
    }
}

impl<'de> Visitor<'de> for TableSeed<'_> {
    type Value = Stated;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a table")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Stated, A::Error> {
        let mut stated = Stated::default();
        while let Some(key) = map.next_key_seed(NameSeed(self.0))? {
            stated.values.push((key.name, map.next_value_seed(ValueSeed(key.shape))?));
        }
        for key in self.0.iter().filter(|key| stated.value(key.name).is_none()).collect::<Vec<_>>() {
            match key.missing {
                Missing::Refused => return Err(A::Error::custom(format!("missing field `{}`", key.name))),
                Missing::Number(number) => stated.values.push((key.name, Value::Number(number))),
                Missing::Allowed => {}
            }
        }
        Ok(stated)
    }
}

/// The names, formatted as in the errors of derived readers.
fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names.map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

struct NameSeed<'k>(&'k [Key]);

impl<'de, 'k> DeserializeSeed<'de> for NameSeed<'k> {
    type Value = &'k Key;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<&'k Key, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl<'k> Visitor<'_> for NameSeed<'k> {
    type Value = &'k Key;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a key")
    }

    fn visit_str<E: Error>(self, name: &str) -> Result<&'k Key, E> {
        self.0.iter().find(|key| key.name == name).ok_or_else(|| {
            E::custom(format!("unknown field `{name}`, expected one of {}", listed(self.0.iter().map(|key| key.name))))
        })
    }
}

struct ValueSeed(Shape);

impl<'de> DeserializeSeed<'de> for ValueSeed {
    type Value = Value;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Value, D::Error> {
        Ok(match self.0 {
            Shape::Number | Shape::NotNegative | Shape::Positive => Value::Number(f64::deserialize(deserializer)?),
            Shape::Whole | Shape::Cable => Value::Whole(u64::deserialize(deserializer)?),
            Shape::Numbers => Value::Numbers(Vec::deserialize(deserializer)?),
            Shape::Vector => Value::Numbers(<[f64; 3]>::deserialize(deserializer)?.to_vec()),
            Shape::Rows => Value::Rows(Vec::deserialize(deserializer)?),
            Shape::Word(words) => Value::Word(deserializer.deserialize_str(WordVisitor(words()))?),
            Shape::Table(keys) => Value::Table(TableSeed(keys).deserialize(deserializer)?),
            Shape::Tables(keys) => Value::Tables(deserializer.deserialize_seq(TablesVisitor(keys))?),
        })
    }
}

struct WordVisitor(Vec<Word>);

impl Visitor<'_> for WordVisitor {
    type Value = &'static str;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a word")
    }

    fn visit_str<E: Error>(self, text: &str) -> Result<&'static str, E> {
        let names = || self.0.iter().map(|word| word.name);
        let known = names().find(|name| *name == text);
        known.ok_or_else(|| E::custom(format!("unknown variant `{text}`, expected one of {}", listed(names()))))
    }
}

struct TablesVisitor(&'static [Key]);

impl<'de> Visitor<'de> for TablesVisitor {
    type Value = Vec<Stated>;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a sequence")
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut sequence: A) -> Result<Vec<Stated>, A::Error> {
        let mut tables = Vec::new();
        while let Some(table) = sequence.next_element_seed(TableSeed(self.0))? {
            tables.push(table);
        }
        Ok(tables)
    }
}
