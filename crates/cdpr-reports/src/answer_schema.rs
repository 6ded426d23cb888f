//! Schema of the answers of all commands.

use schemars::generate::{SchemaGenerator, SchemaSettings};
use schemars::{JsonSchema, Schema};
use serde_json::{Map, Value, json};

use crate::answer_keys::{described, enveloped};

/// Answers gathered command by command, for one schema of them all.
pub struct AnswerSchemas {
    generator: SchemaGenerator,
    /// References to the answers of each command.
    commands: Vec<(&'static str, Vec<Value>)>,
}

impl Default for AnswerSchemas {
    fn default() -> Self {
        Self { generator: SchemaSettings::draft2020_12().for_serialize().into_generator(), commands: Vec::new() }
    }
}

impl AnswerSchemas {
    /// The same with an answer of a command besides those that it has already.
    #[must_use]
    pub fn with<T: JsonSchema>(mut self, command: &'static str) -> Self {
        let answer = self.generator.subschema_for::<T>().to_value();
        match self.commands.iter_mut().find(|(known, _)| *known == command) {
            Some((_, answers)) => answers.push(answer),
            None => self.commands.push((command, vec![answer])),
        }
        self
    }

    /// One definition per answer and per part of an answer, and the commands with their answers as properties.
    pub fn schema(mut self) -> Schema {
        let mut definitions = self.generator.take_definitions(true);
        for answer in self.commands.iter().flat_map(|(_, answers)| answers) {
            let name = answer["$ref"].as_str().and_then(|path| path.strip_prefix("#/$defs/"));
            if let Some(definition) = name.and_then(|name| definitions.get_mut(name)) {
                enveloped(definition);
            }
        }
        definitions.values_mut().for_each(described);
        let properties: Map<String, Value> =
            self.commands.into_iter().map(|(command, answers)| (command.to_owned(), one_of(answers))).collect();
        let schema = json!({
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "title": "Answers",
            "description": "Answers of the commands of cdpr with --format json: each property is a command with its answers.",
            "type": "object",
            "properties": properties,
            "$defs": definitions,
        });
        Schema::try_from(schema).unwrap_or_default()
    }
}

fn one_of(mut answers: Vec<Value>) -> Value {
    match answers.len() {
        1 => answers.remove(0),
        _ => json!({ "anyOf": answers }),
    }
}
