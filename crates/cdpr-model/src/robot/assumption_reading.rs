//! The `[[assumption]]` tables of a robot file: each names a number that the file states.

use toml::de::DeValue;

use super::file::RobotFile;
use super::parameter::Head;
use super::reader::Reader;
use crate::reading::{ReadError, Step, did_you_mean};

/// Tables with numbers that may be assumed, besides those of the cables.
const TABLES: [&str; 4] = ["platform", "home_pose", "external_wrench", "workspace"];

/// Code of errors in these tables.
const CODE: &str = "robot::assumption";

/// Checks that every assumption names a number of the file, once, and has a reason.
pub(super) fn check_assumptions(reader: &Reader<'_>, file: &RobotFile) -> Result<(), ReadError> {
    for (index, assumption) in file.assumption.iter().enumerate() {
        let error = |key: &str, message: String| {
            reader.document.error_at(&[Step::Key("assumption"), Step::Index(index), Step::Key(key)], CODE, message)
        };
        let key = assumption.key.as_str();
        if assumption.reason.trim().is_empty() {
            return Err(error("reason", format!("the assumption of `{key}` has no reason"))
                .with_help("say in a line why the number is what it is"));
        }
        if file.assumption[..index].iter().any(|other| other.key == key) {
            return Err(error("key", format!("`{key}` is assumed twice")).with_help("keep one of the two"));
        }
        let cables = file.cable.len();
        let head = Head::read(key).filter(|head| head.cables.is_none() || head.word == "cable");
        let beyond = head.iter().flat_map(|head| head.cables.iter().flatten()).find(|cable| **cable >= cables);
        if let Some(cable) = beyond {
            let message = format!("`{key}`: cable {} does not exist", cable + 1);
            return Err(error("key", message).with_help(format!("cables count from 1 to {cables}")));
        }
        if !head.is_some_and(|head| states(reader, &head, cables)) {
            let known = stated_keys(reader, cables);
            let help = match did_you_mean(key, known.iter().map(String::as_str)) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => {
                    "name a number of the file with its table, e.g. `platform.mass_kg` or `cable.drum_inertia_kg_m2`"
                        .to_owned()
                }
            };
            return Err(error("key", format!("`{key}` is no number that this file states")).with_help(help));
        }
    }
    Ok(())
}

/// True if the file states the number: for each of the cables in brackets, or for at least one without brackets.
fn states(reader: &Reader<'_>, head: &Head<'_>, cables: usize) -> bool {
    let number = |path: &[Step<'_>]| reader.document.value(path).is_some_and(is_numeric);
    let Some(key) = head.rest.strip_prefix('.') else {
        let value = reader.document.value(&[Step::Key(head.word)]);
        let is_number = value.is_some_and(|value| is_numeric(value) && !matches!(value, DeValue::Table(_)));
        return head.rest.is_empty() && head.cables.is_none() && is_number;
    };
    let of_cable = |cable: usize| number(&[Step::Key("cable"), Step::Index(cable), Step::Key(key)]);
    match (head.word, &head.cables) {
        ("cable", Some(some)) => some.iter().all(|&cable| of_cable(cable)),
        ("cable", None) => (0..cables).any(of_cable),
        (table, _) => TABLES.contains(&table) && number(&[Step::Key(table), Step::Key(key)]),
    }
}

/// Keys that assumptions may name.
fn stated_keys(reader: &Reader<'_>, cables: usize) -> Vec<String> {
    let inside = |path: &[Step<'_>], table: &str| match reader.document.value(path) {
        Some(DeValue::Table(entries)) => entries
            .iter()
            .filter(|(_, value)| is_numeric(value.get_ref()))
            .map(|(key, _)| format!("{table}.{}", key.get_ref()))
            .collect(),
        _ => Vec::new(),
    };
    let mut keys: Vec<String> = TABLES.iter().flat_map(|table| inside(&[Step::Key(table)], table)).collect();
    keys.extend((0..cables).flat_map(|cable| inside(&[Step::Key("cable"), Step::Index(cable)], "cable")));
    keys.push("gravity_m_s2".to_owned());
    keys
}

/// True for a number, and for lists and tables that contain only numbers: a matrix, a law of stretch.
fn is_numeric(value: &DeValue<'_>) -> bool {
    match value {
        DeValue::Integer(_) | DeValue::Float(_) => true,
        DeValue::Array(list) => !list.is_empty() && list.iter().all(|entry| is_numeric(entry.get_ref())),
        DeValue::Table(table) => !table.is_empty() && table.iter().all(|(_, entry)| is_numeric(entry.get_ref())),
        _ => false,
    }
}
