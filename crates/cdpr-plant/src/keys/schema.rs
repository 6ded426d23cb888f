//! JSON Schema of tables, from their keys.

use schemars::{Schema, json_schema};

use super::{Key, Kind, Missing, Shape, Word};

/// Schema of a table with these keys.
pub(crate) fn table_schema(description: &str, keys: &[Key]) -> Schema {
    of_keys(description, keys.iter().map(|key| (*key, String::new())))
}

/// Schema of a table whose `kind` determines the keys that it has in addition to its own.
pub(crate) fn kinds_schema(description: &str, own: &[Key], kinds: &[Kind]) -> Schema {
    let mut all: Vec<(Key, Vec<String>)> = Vec::new();
    for kind in kinds {
        for key in kind.keys {
            let word = format!("`{}`", kind.word.name);
            match all.iter_mut().find(|(known, _)| known.name == key.name) {
                Some((_, words)) => words.push(word),
                None => all.push((Key { missing: Missing::Allowed, ..*key }, vec![word])),
            }
        }
    }
    let own = own.iter().map(|key| (*key, String::new()));
    of_keys(description, own.chain(all.into_iter().map(|(key, words)| (key, words.join(", ") + ": "))))
}

/// Schema of keys, each with a prefix for its description.
fn of_keys(description: &str, keys: impl Iterator<Item = (Key, String)>) -> Schema {
    let (mut properties, mut required) = (Schema::default(), Vec::new());
    for (key, before) in keys {
        properties.insert(key.name.to_owned(), of_key(&key, &before).to_value());
        if key.missing == Missing::Refused {
            required.push(key.name);
        }
    }
    let mut schema = json_schema!({ "type": "object", "additionalProperties": false, "properties": properties });
    if !description.is_empty() {
        schema.insert("description".to_owned(), description.into());
    }
    if !required.is_empty() {
        schema.insert("required".to_owned(), required.into());
    }
    schema
}

fn of_key(key: &Key, before: &str) -> Schema {
    let mut schema = of_shape(key.shape);
    schema.insert("description".to_owned(), format!("{before}{}", key.summary).into());
    if let Missing::Number(number) = key.missing {
        schema.insert("default".to_owned(), number.into());
    }
    schema
}

fn of_shape(shape: Shape) -> Schema {
    let number = || json_schema!({ "type": "number", "format": "double" });
    match shape {
        Shape::Number => number(),
        Shape::NotNegative => json_schema!({ "type": "number", "format": "double", "minimum": 0 }),
        Shape::Positive => json_schema!({ "type": "number", "format": "double", "exclusiveMinimum": 0 }),
        Shape::Whole => json_schema!({ "type": "integer", "format": "uint64", "minimum": 0 }),
        Shape::Cable => json_schema!({ "type": "integer", "format": "uint", "minimum": 1 }),
        Shape::Numbers => json_schema!({ "type": "array", "items": number() }),
        Shape::Vector => json_schema!({ "type": "array", "items": number(), "minItems": 3, "maxItems": 3 }),
        Shape::Rows => json_schema!({ "type": "array", "items": { "type": "array", "items": number() } }),
        Shape::Word(words) => json_schema!({ "oneOf": words().iter().map(of_word).collect::<Vec<_>>() }),
        Shape::Table(keys) => table_schema("", keys),
        Shape::Tables(keys) => json_schema!({ "type": "array", "items": table_schema("", keys) }),
    }
}

fn of_word(word: &Word) -> Schema {
    json_schema!({ "const": word.name, "description": word.summary, "type": "string" })
}
