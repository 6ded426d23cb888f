//! Answers beside their schema: every key is described, every value has a type that the schema gives it.

use std::sync::OnceLock;

use serde_json::{Map, Value, json};

use super::cdpr;

/// The schema of all answers, as the command prints it.
fn schema() -> &'static Value {
    static SCHEMA: OnceLock<Value> = OnceLock::new();
    SCHEMA.get_or_init(|| serde_json::from_str(&cdpr("schema answers").stdout).unwrap())
}

/// Asserts that the answer to these arguments is valid by the schema of its command, without unknown keys.
pub(super) fn assert_fits(arguments: &[String], answer: &Value) {
    let commands = &schema()["properties"];
    // of `schema` the answer is a schema itself
    let mut words = arguments.iter().map(String::as_str);
    let Some(command) = words.find(|word| *word == "schema" || !commands[word].is_null()) else { return };
    if command == "schema" {
        return;
    }
    let command = if answer["status"] == "error" { "error" } else { command };
    let faults = faults(answer, &commands[command], schema(), command);
    assert!(faults.is_empty(), "{arguments:?}: {faults:#?}");
}

/// Returns the places where a value breaks its schema, each with its path; `root` holds the definitions.
fn faults(value: &Value, schema: &Value, root: &Value, path: &str) -> Vec<String> {
    if let Some(name) = schema["$ref"].as_str() {
        let definition = root.pointer(name.trim_start_matches('#'));
        return definition.map_or_else(
            || vec![format!("{path}: {name} is not defined")],
            |definition| faults(value, definition, root, path),
        );
    }
    if let Some(choices) = schema.get("anyOf").or_else(|| schema.get("oneOf")).and_then(Value::as_array) {
        let all = choices.iter().map(|choice| faults(value, choice, root, path));
        return all.min_by_key(Vec::len).unwrap_or_default();
    }
    if let Some(constant) = schema.get("const") {
        return fault(value == constant, || format!("{path}: {value} is not {constant}"));
    }
    if let Some(words) = schema["enum"].as_array() {
        return fault(words.contains(value), || format!("{path}: {value} is none of {words:?}"));
    }
    let types = match &schema["type"] {
        Value::Array(types) => types.iter().filter_map(Value::as_str).collect(),
        one => one.as_str().into_iter().collect::<Vec<_>>(),
    };
    if !types.iter().any(|name| is_of_type(value, name)) {
        return vec![format!("{path}: {value} is none of {types:?}")];
    }
    match value {
        Value::Array(items) => items_faults(items, schema, root, path),
        Value::Object(entries) => entry_faults(entries, schema, root, path),
        _ => Vec::new(),
    }
}

fn fault(is_right: bool, words: impl FnOnce() -> String) -> Vec<String> {
    if is_right { Vec::new() } else { vec![words()] }
}

fn is_of_type(value: &Value, name: &str) -> bool {
    match name {
        "null" => value.is_null(),
        "boolean" => value.is_boolean(),
        "string" => value.is_string(),
        "number" => value.is_number(),
        "integer" => value.is_i64() || value.is_u64(),
        "array" => value.is_array(),
        "object" => value.is_object(),
        _ => false,
    }
}

fn items_faults(items: &[Value], schema: &Value, root: &Value, path: &str) -> Vec<String> {
    let limit = |key: &str| schema[key].as_u64().map(|number| number as usize);
    let fits = limit("minItems").is_none_or(|least| items.len() >= least)
        && limit("maxItems").is_none_or(|most| items.len() <= most);
    let mut all = fault(fits, || format!("{path}: {} entries", items.len()));
    for (index, item) in items.iter().enumerate() {
        let of_place = schema["prefixItems"].get(index).unwrap_or(&schema["items"]);
        all.extend(faults(item, of_place, root, &format!("{path}[{index}]")));
    }
    all
}

fn entry_faults(entries: &Map<String, Value>, schema: &Value, root: &Value, path: &str) -> Vec<String> {
    let required = schema["required"].as_array().into_iter().flatten().filter_map(Value::as_str);
    let lacking = required.filter(|key| !entries.contains_key(*key));
    let mut all: Vec<String> = lacking.map(|key| format!("{path}: `{key}` is missing")).collect();
    for (key, value) in entries {
        let path = format!("{path}.{key}");
        match (schema["properties"].get(key), schema.get("additionalProperties")) {
            (Some(own), _) => all.extend(faults(value, own, root, &path)),
            (None, Some(values)) if values.is_object() => all.extend(faults(value, values, root, &path)),
            _ => all.push(format!("{path}: the schema lacks this key")),
        }
    }
    all
}

#[test]
fn a_key_or_a_type_that_the_schema_lacks_is_a_fault() {
    let answer = cdpr("check planar-example --format json").json();
    let check = |answer: &Value| faults(answer, &schema()["properties"]["check"], schema(), "check");
    assert_eq!(check(&answer), Vec::<String>::new());
    let mut wrong = answer;
    wrong["home"]["colour"] = json!("red");
    wrong["cable_count"] = json!("four");
    wrong["models"].as_object_mut().unwrap().remove("richest");
    let expected = [
        "check.cable_count: \"four\" is none of [\"integer\"]",
        "check.home.colour: the schema lacks this key",
        "check.models: `richest` is missing",
    ];
    assert_eq!(check(&wrong), expected);
}

#[test]
fn every_key_has_a_description_and_no_two_parts_the_same_name() {
    let definitions = schema()["$defs"].as_object().unwrap();
    for (name, definition) in definitions {
        assert!(definition["description"].is_string(), "{name} has no description");
        assert!(!name.ends_with(|letter: char| letter.is_ascii_digit()), "{name} is the name of two");
        for (key, property) in definition["properties"].as_object().into_iter().flatten() {
            assert!(property["description"].is_string(), "{name}.{key} has no description");
        }
    }
}

#[test]
fn every_subcommand_has_answers() {
    let commands = schema()["properties"].as_object().unwrap();
    for command in super::envelope::commands() {
        assert!(commands.contains_key(&command) || command == "schema", "{command}");
    }
}
