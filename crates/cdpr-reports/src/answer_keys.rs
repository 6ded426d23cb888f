//! Keys that many answers share, in their schema.

use serde_json::{Value, json};

/// Descriptions of keys that stand in many answers and mean the same in each.
const SHARED: &[(&str, &str)] = &[
    ("assumptions", "Numbers of the robot file that no source states and nobody measured."),
    ("cable_count", "Number of cables."),
    ("cable_lengths_m", "Lengths of the cables (m)."),
    ("code", "Stable short name, which `cdpr explain` explains."),
    ("control", "Control model."),
    ("data", "Name of the data."),
    ("files", "Names of the files that were written."),
    ("free", "Free parameters."),
    ("layout_version", "Version of the keys of answers: raised when a key goes or changes its meaning."),
    ("machine", "Effects of the machine."),
    ("model", "Effects of the model."),
    ("motion_pattern", "Motion pattern: rotations R and translations T."),
    ("name", "Name."),
    ("out", "File or folder that was written."),
    ("pose", "Pose of the platform."),
    ("program", "Name and version of the program."),
    ("reason", "Reason of the outcome in words; null where it needs none."),
    ("robot", "Name of the robot."),
    ("seed", "Seed of all random numbers."),
    ("status", "Outcome in a word."),
    ("tensions_N", "Tensions of the cables (N)."),
    ("title", "Name in words."),
    ("values", "Values."),
    ("warnings", "Warnings for the reader, doubts about the outcome first."),
    ("winch_offsets_m", "Winch offsets, added to the control model's lengths (m)."),
];

/// Gives the object of an answer the keys that every answer has.
pub(crate) fn enveloped(definition: &mut Value) {
    let texts = json!({ "type": "array", "items": { "type": "string" } });
    let keys = [
        ("program", json!({ "type": "string" }), true),
        ("layout_version", json!({ "type": "integer", "minimum": 0 }), true),
        ("status", json!({ "type": "string" }), true),
        ("robot", json!({ "type": "string" }), false),
        ("warnings", texts, true),
    ];
    for (key, schema, is_required) in keys {
        let properties = &mut definition["properties"];
        if properties[key].is_null() {
            properties[key] = schema;
        }
        if !definition["required"].is_array() {
            definition["required"] = json!([]);
        }
        if let Some(required) = definition["required"].as_array_mut()
            && is_required
            && !required.contains(&json!(key))
        {
            required.push(json!(key));
        }
    }
}

/// Gives properties without a description the one that they share with those of other answers.
pub(crate) fn described(definition: &mut Value) {
    let Some(properties) = definition.get_mut("properties").and_then(Value::as_object_mut) else { return };
    for (key, property) in properties {
        let shared = SHARED.iter().find(|(of, _)| of == key);
        if let (Some((_, text)), Some(property)) = (shared, property.as_object_mut()) {
            property.entry("description").or_insert_with(|| json!(text));
        }
    }
}
