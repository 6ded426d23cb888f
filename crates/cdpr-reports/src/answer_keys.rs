//! Keys that many answers share, in their schema.

use serde_json::{Value, json};

/// Descriptions of keys that stand in many answers and mean the same in each.
const SHARED: &[(&str, &str)] = &[
    ("angle_rad", "Angle from the first to the second axis (rad)."),
    ("assumptions", "Numbers of the robot file that no source states and nobody measured."),
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
    let Some(properties) = definition["properties"].as_object_mut() else { return };
    for (key, property) in properties {
        let shared = SHARED.iter().find(|(of, _)| of == key);
        if let (Some((_, text)), Some(property)) = (shared, property.as_object_mut()) {
            property.entry("description").or_insert_with(|| json!(text));
        }
    }
}
