//! Schemas of tables of keys.

use std::borrow::Cow;
use std::marker::PhantomData;

use schemars::generate::SchemaGenerator;
use schemars::{JsonSchema, Schema};
use serde_json::{Map, Value, json};

/// Schema of a table in the making.
pub(crate) struct TableSchema {
    description: String,
    properties: Map<String, Value>,
    required: Vec<Value>,
}

impl TableSchema {
    /// The schema of a table without entries, of lines of documentation.
    pub(crate) fn new(lines: &[&str]) -> Self {
        Self { description: text(lines), properties: Map::new(), required: Vec::new() }
    }

    /// Adds a key, which may be left out where it is not required, with the lines of its documentation.
    pub(crate) fn add(&mut self, key: &str, mut schema: Schema, is_required: bool, lines: &[&str]) {
        if !lines.is_empty() {
            schema.insert("description".to_owned(), text(lines).into());
        }
        self.properties.insert(key.to_owned(), schema.to_value());
        if is_required {
            self.required.push(key.into());
        }
    }

    /// Adds the keys of another table.
    pub(crate) fn add_all(&mut self, schema: &Schema, is_required: bool) {
        if let Some(Value::Object(properties)) = schema.get("properties") {
            self.properties.extend(properties.clone());
        }
        if let Some(Value::Array(required)) = schema.get("required")
            && is_required
        {
            self.required.extend(required.iter().cloned());
        }
    }

    /// The whole schema; any of its numbers is null where it is not finite.
    pub(crate) fn schema(self) -> Schema {
        let mut schema = Map::new();
        schema.insert("description".to_owned(), self.description.into());
        schema.insert("type".to_owned(), "object".into());
        schema.insert("properties".to_owned(), self.properties.into());
        if !self.required.is_empty() {
            schema.insert("required".to_owned(), self.required.into());
        }
        let mut schema = Schema::from(schema);
        nullable_numbers(&mut schema);
        schema
    }
}

/// Numbers of a table that are null where they are not finite.
pub(crate) fn nullable_numbers(schema: &mut Schema) {
    let Some(Value::Object(properties)) = schema.get_mut("properties") else { return };
    for property in properties.values_mut() {
        if property.get("type") == Some(&"number".into()) {
            property["type"] = json!(["number", "null"]);
        }
    }
}

/// Lines of documentation as one text.
fn text(lines: &[&str]) -> String {
    lines.iter().map(|line| line.trim()).collect::<Vec<_>>().join(" ")
}

/// Name of the schema of a table: `PoseErrors` of `PoseErrorsKeys`.
pub(crate) fn table_name(keys: &'static str) -> Cow<'static, str> {
    keys.strip_suffix("Keys").unwrap_or(keys).into()
}

/// The type of a value.
pub(crate) fn type_of<T>(_: &T) -> PhantomData<T> {
    PhantomData
}

/// Schema of what a function, which is not called, takes from a value.
pub(crate) fn schema_of<V, T: JsonSchema>(_: fn(&V) -> PhantomData<T>, generator: &mut SchemaGenerator) -> Schema {
    generator.subschema_for::<T>()
}

/// Entry of the schema of a table that `keys` makes.
macro_rules! entry_schema {
    ($generator:ident, $table:ident, $of:expr, $name:expr, [none], $key:tt, $by:tt, $inner:tt, $doc:tt) => {
        $crate::keys::table_schema::entry_schema!(@ $generator, $table, $of, $name, false, $key, $by, $inner, $doc)
    };
    ($generator:ident, $table:ident, $of:expr, $name:expr, [], $key:tt, $by:tt, $inner:tt, $doc:tt) => {
        $crate::keys::table_schema::entry_schema!(@ $generator, $table, $of, $name, true, $key, $by, $inner, $doc)
    };
    (@ $generator:ident, $table:ident, $of:expr, $name:expr, $required:expr, [], [], [$inner:ident], $doc:tt) => {
        $table.add_all(&<$inner as schemars::JsonSchema>::json_schema($generator), $required)
    };
    (@ $generator:ident, $table:ident, $of:expr, $name:expr, $required:expr, [], $by:tt, [], $doc:tt) => {
        $crate::keys::table_schema::entry_schema!(@ $generator, $table, $of, $name, $required, [$name], $by, [], $doc)
    };
    (@ $generator:ident, $table:ident, $of:expr, $name:expr, $required:expr, [$key:expr], [], [], $doc:tt) => {
        $table.add($key, $crate::keys::table_schema::schema_of($of, $generator), $required, &$doc)
    };
    (@ $generator:ident, $table:ident, $of:expr, $name:expr, $required:expr, [$key:expr], [$by:ty], [], $doc:tt) => {
        $table.add($key, $generator.subschema_for::<$by>(), $required, &$doc)
    };
}
pub(crate) use entry_schema;

/// Types that stand for an area or a volume of a name in schemas: the one key or the other is there.
macro_rules! size_schemas {
    ($($size:ident: $name:literal, $value:ty;)+) => {$(
        #[doc = concat!("Schema of a size named `", $name, "`.")]
        pub(crate) struct $size;

        impl schemars::JsonSchema for $size {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($size).into()
            }

            fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
                $crate::keys::table_schema::size($name, generator.subschema_for::<$value>())
            }
        }
    )+};
}

size_schemas! {
    PartSize: "", f64;
    EmergingSize: "emerging", Option<f64>;
    LinearSize: "linear", Option<f64>;
    ModelSize: "model", Option<f64>;
    PhysicalSize: "physical", Option<f64>;
    ReachableSize: "reachable", Option<f64>;
    ByAccuracySize: "by_accuracy", Vec<f64>;
}

/// Schema of an area or a volume.
pub(crate) fn size(name: &'static str, value: Schema) -> Schema {
    let value = value.to_value();
    let mut properties = Map::new();
    for (is_planar, quantity, unit) in [(true, "Area", "m²"), (false, "Volume", "m³")] {
        let key = crate::answers::Size { name, is_planar, value: () }.key();
        let of = if name.is_empty() { String::new() } else { format!(" `{name}`") };
        let mut schema = value.clone();
        schema["description"] = format!("{quantity}{of} ({unit}), of a robot with that kind of size.").into();
        properties.insert(key, schema);
    }
    Schema::from(json!({ "type": "object", "properties": properties }).as_object().cloned().unwrap_or_default())
}
