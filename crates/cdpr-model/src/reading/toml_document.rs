//! A parsed TOML file with the positions of all its values.

use std::ops::Range;

use serde::de::DeserializeOwned;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::{MAGNITUDE_LIMIT, ReadError, Size, TextPlace, help_for_unknown};

/// One step of the path to a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Step<'a> {
    /// Into a table.
    Key(&'a str),
    /// Into an array, from 0.
    Index(usize),
}

/// A TOML file that serde converts to any type; later errors are located by the path of their key.
#[derive(Clone, Debug)]
pub struct TomlDocument<'a> {
    text: &'a str,
    file_name: &'a str,
    root: Spanned<DeTable<'a>>,
}

/// Key of the table from which gathered keys are read; unknown if a file states it.
const GATHERED: &str = "gathered keys";

/// Keys in every table of a list that are read as a table inside it, since no type has them as fields.
#[derive(Clone, Debug)]
pub struct Gathering<'k> {
    /// Key of the list.
    pub(crate) list: &'k str,
    /// The keys.
    pub(crate) keys: Vec<&'k str>,
}

impl Gathering<'_> {
    fn apply<'a>(&self, root: &mut DeTable<'a>) {
        let Some(DeValue::Array(tables)) = root.get_mut(self.list).map(Spanned::get_mut) else { return };
        for entry in tables.iter_mut() {
            let span = entry.span();
            let DeValue::Table(table) = entry.get_mut() else { continue };
            // one pass over the keys costs less than a search for each of ours
            let is_ours = |key: &str| key == GATHERED || self.keys.contains(&key);
            if !table.keys().any(|key| is_ours(key.get_ref())) {
                continue;
            }
            if let Some((key, value)) = table.remove_entry(GATHERED) {
                table.insert(Spanned::new(key.span(), format!("\"{GATHERED}\"").into()), value);
            }
            let mut inside = DeTable::new();
            inside.extend(self.keys.iter().filter_map(|key| table.remove_entry(*key)));
            if !inside.is_empty() {
                table.insert(Spanned::new(span.clone(), GATHERED.into()), Spanned::new(span, DeValue::Table(inside)));
            }
        }
    }

    /// Names in an error, with the gathered keys in place of their table.
    fn spelled<'w>(&'w self, words: Vec<&'w str>) -> Vec<&'w str> {
        let spelled = |word| if word == GATHERED { self.keys.clone() } else { vec![word] };
        words.into_iter().flat_map(spelled).collect()
    }
}

impl<'a> TomlDocument<'a> {
    /// Parses a file that is not empty, with numbers that can be calculated with.
    pub fn parse(text: &'a str, file_name: &'a str) -> Result<Self, ReadError> {
        Size::Text.check(text.len() as u64, file_name)?;
        let root = DeTable::parse(text).map_err(|error| {
            let span = error.span().unwrap_or(text.len()..text.len());
            ReadError::new(file_name, "toml::syntax", format!("this is not TOML: {}", error.message()))
                .at(TextPlace::of_span(text, span))
        })?;
        if root.get_ref().is_empty() {
            return Err(ReadError::new(file_name, "toml::empty", "the file says nothing")
                .at(TextPlace::of_span(text, 0..0))
                .with_help("is the path right, and was the file written completely?"));
        }
        let document = Self { text, file_name, root };
        document.root.get_ref().iter().try_for_each(|(_, value)| document.check_numbers(value))?;
        Ok(document)
    }

    /// The file as a value of `T`; unknown keys, missing keys and wrong types are errors with their position.
    pub fn deserialize<T: DeserializeOwned>(&self) -> Result<T, ReadError> {
        self.deserialize_gathering(&Gathering { list: "", keys: Vec::new() })
    }

    /// As [`TomlDocument::deserialize`], with some keys of every table of a list moved to a table [`GATHERED`].
    pub(crate) fn deserialize_gathering<T: DeserializeOwned>(&self, gathering: &Gathering<'_>) -> Result<T, ReadError> {
        let mut root = self.root.clone();
        gathering.apply(root.get_mut());
        let deserializer = toml::de::Deserializer::from(root);
        T::deserialize(deserializer).map_err(|error| self.explain(&error, gathering))
    }

    /// Copies the entries of a table to every table of a list that lacks them. `alternatives` are forms of one value:
    /// if the list's table states one, none of them is copied. Copies keep their position, for errors.
    pub(crate) fn fill_in(&mut self, list: &str, defaults: &str, alternatives: &[&str]) {
        let root = self.root.get_mut();
        let Some(DeValue::Table(defaults)) = root.get(defaults).map(|value| value.get_ref().clone()) else { return };
        let Some(DeValue::Array(tables)) = root.get_mut(list).map(Spanned::get_mut) else { return };
        for entry in tables.iter_mut() {
            let DeValue::Table(table) = entry.get_mut() else { continue };
            let has_chosen = alternatives.iter().any(|key| table.contains_key(*key));
            let lacks = |key: &str| !(table.contains_key(key) || has_chosen && alternatives.contains(&key));
            let lacking: Vec<_> = defaults.iter().filter(|(key, _)| lacks(key.get_ref())).collect();
            table.extend(lacking.into_iter().map(|(key, value)| (key.clone(), value.clone())));
        }
    }

    /// True if a value of a table, or one inside its values, is at this position.
    pub(crate) fn stands_in(&self, table: &str, place: &TextPlace) -> bool {
        let is_here = |value: &Spanned<DeValue<'a>>| TextPlace::of_span(self.text, value.span()) == *place;
        self.root.get_ref().get(table).is_some_and(|table| any_inside(table, &is_here))
    }

    /// Number of values in a table, including those inside its values.
    pub(crate) fn values_in(&self, table: &str) -> usize {
        self.root.get_ref().get(table).map_or(0, count_inside)
    }

    /// The value at a path; `None` if there is none.
    pub(crate) fn value(&self, path: &[Step<'_>]) -> Option<&DeValue<'a>> {
        let (first, rest) = path.split_first()?;
        let Step::Key(name) = first else { return None };
        let mut value = self.root.get_ref().get(*name)?;
        for step in rest {
            value = child(value, step)?;
        }
        Some(value.get_ref())
    }

    /// An error at the value of a path, or at the innermost existing part of the path.
    pub fn error_at(&self, path: &[Step<'_>], code: &'static str, message: impl Into<String>) -> ReadError {
        ReadError::new(self.file_name, code, message).at(TextPlace::of_span(self.text, self.span(path)))
    }

    /// Byte range of the innermost existing part of a path: the value of a key, the header of a table.
    fn span(&self, path: &[Step<'_>]) -> Range<usize> {
        let mut steps = path.iter();
        let Some(Step::Key(name)) = steps.next() else { return 0..0 };
        let Some(mut value) = self.root.get_ref().get(*name) else { return 0..0 };
        for step in steps {
            let Some(inner) = child(value, step) else { break };
            value = inner;
        }
        value.span()
    }

    /// Refuses NaN, infinities and numbers that overflow when squared.
    fn check_numbers(&self, value: &Spanned<DeValue<'a>>) -> Result<(), ReadError> {
        let at_value = |code, message: String| {
            ReadError::new(self.file_name, code, message).at(TextPlace::of_span(self.text, value.span()))
        };
        match value.get_ref() {
            DeValue::Float(float) => {
                let number: f64 = float.as_str().parse().unwrap_or(f64::NAN);
                if number.abs() <= MAGNITUDE_LIMIT {
                    return Ok(());
                }
                Err(if number.is_nan() || float.as_str().contains("inf") {
                    at_value("toml::not-finite", format!("{} is not a number to calculate with", float.as_str()))
                        .with_help("leave the key out when its value is unknown")
                } else {
                    at_value("toml::too-large-number", format!("{} is beyond ±{MAGNITUDE_LIMIT:e}", float.as_str()))
                        .with_help("numbers are in SI units; is the exponent right?")
                })
            }
            DeValue::Array(array) => array.iter().try_for_each(|item| self.check_numbers(item)),
            DeValue::Table(table) => table.iter().try_for_each(|(_, item)| self.check_numbers(item)),
            _ => Ok(()),
        }
    }

    /// A serde error in words for users.
    fn explain(&self, error: &toml::de::Error, gathering: &Gathering<'_>) -> ReadError {
        let span = error.span().unwrap_or(0..0);
        let (message, quoted) = (error.message(), gathering.spelled(quoted_words(error.message())));
        let at_span = |code, message: String| {
            ReadError::new(self.file_name, code, message).at(TextPlace::of_span(self.text, span.clone()))
        };
        match quoted.split_first() {
            Some((wrong, known)) if message.starts_with("unknown field") => {
                at_span("toml::unknown-key", format!("unknown key `{wrong}`")).with_help(help_for_unknown(wrong, known))
            }
            Some((wrong, known)) if message.starts_with("unknown variant") => {
                at_span("toml::unknown-value", format!("unknown value `{wrong}`"))
                    .with_help(help_for_unknown(wrong, known))
            }
            Some((missing, _)) if message.starts_with("missing field") => {
                at_span("toml::missing-key", format!("the key `{missing}` is missing here"))
                    .with_help(format!("add `{missing} = …` to this table"))
            }
            _ => {
                let error = at_span("toml::wrong-type", in_plain_words(message));
                match () {
                    () if message.contains("expected a sequence") => {
                        error.with_help("write a list in brackets, e.g. [0.0, 0.0, -9.81]")
                    }
                    () if message.contains("expected a number") || message.contains("expected f64") => {
                        error.with_help("a number stands without quotes and without unit: the unit is in the key")
                    }
                    () => error,
                }
            }
        }
    }
}

/// Value to which a step leads.
fn child<'t, 'a>(value: &'t Spanned<DeValue<'a>>, step: &Step<'_>) -> Option<&'t Spanned<DeValue<'a>>> {
    match (step, value.get_ref()) {
        (Step::Key(name), DeValue::Table(table)) => table.get(*name),
        (Step::Index(index), DeValue::Array(array)) => array.get(*index),
        _ => None,
    }
}

/// True if a condition holds for one of the values inside a table or a list.
fn any_inside<'a>(value: &Spanned<DeValue<'a>>, condition: &impl Fn(&Spanned<DeValue<'a>>) -> bool) -> bool {
    let holds = |inner: &Spanned<DeValue<'a>>| condition(inner) || any_inside(inner, condition);
    match value.get_ref() {
        DeValue::Array(array) => array.iter().any(holds),
        DeValue::Table(table) => table.iter().any(|(_, inner)| holds(inner)),
        _ => false,
    }
}

/// Number of values inside a table or a list.
fn count_inside(value: &Spanned<DeValue<'_>>) -> usize {
    match value.get_ref() {
        DeValue::Array(array) => array.iter().map(|inner| 1 + count_inside(inner)).sum(),
        DeValue::Table(table) => table.iter().map(|(_, inner)| 1 + count_inside(inner)).sum(),
        _ => 0,
    }
}

/// The words between backticks: serde quotes the name found and then the known names.
fn quoted_words(message: &str) -> Vec<&str> {
    message.split('`').skip(1).step_by(2).collect()
}

/// A message with names of Rust types replaced by words.
fn in_plain_words(message: &str) -> String {
    [
        ("a map", "a table"),
        ("f64", "a number"),
        ("u32", "a whole number ≥ 0"),
        ("u64", "a whole number ≥ 0"),
        ("usize", "a whole number ≥ 0"),
    ]
    .iter()
    .fold(message.to_owned(), |text, (rust, words)| {
        text.replace(&format!("expected {rust}"), &format!("expected {words}"))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Debug, serde::Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Section {
        #[serde(rename = "length_m")]
        _length: f64,
    }

    #[derive(Debug, serde::Deserialize)]
    #[serde(deny_unknown_fields)]
    struct File {
        #[serde(rename = "section")]
        _sections: Vec<Section>,
    }

    fn error_of(text: &str) -> ReadError {
        TomlDocument::parse(text, "a.toml").and_then(|document| document.deserialize::<File>()).unwrap_err()
    }

    #[test]
    fn mistakes_are_placed_and_named() {
        for (text, place, code) in [
            ("", (1, 1), "toml::empty"),
            ("[section]\nlength_m = ", (2, 12), "toml::syntax"),
            ("[[section]]\nlength_m = 1\n[[section]]\nlenght_m = 1", (4, 1), "toml::unknown-key"),
            ("[[section]]\nlength_m = \"1\"", (2, 12), "toml::wrong-type"),
            ("[[section]]\nlength_m = nan", (2, 12), "toml::not-finite"),
            ("[[section]]\nlength_m = -inf", (2, 12), "toml::not-finite"),
            ("[[section]]\nlength_m = 1e400", (2, 12), "toml::too-large-number"),
            ("[[section]]\n", (1, 1), "toml::missing-key"),
        ] {
            let error = error_of(text);
            assert_eq!((error.line().unwrap(), error.column().unwrap()), place, "{error}");
            assert_eq!(error.code, code, "{error}");
        }
    }

    #[test]
    fn a_misspelt_key_is_answered_by_the_one_meant() {
        let help = error_of("[[section]]\nlenght_m = 1").help.unwrap();
        assert_eq!(help, "did you mean `length_m`? allowed: length_m");
    }

    #[derive(Debug, serde::Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Gathered {
        #[serde(rename = "section")]
        sections: Vec<GatheredSection>,
    }

    #[derive(Debug, serde::Deserialize)]
    #[serde(deny_unknown_fields)]
    struct GatheredSection {
        length_m: f64,
        #[serde(rename = "gathered keys", default)]
        numbers: std::collections::BTreeMap<String, f64>,
    }

    /// Keys without a field are read, misspelt ones are reported with similar names, and errors are at their positions.
    #[test]
    fn gathered_keys_are_keys_like_others() {
        let read = |text: &str| {
            let gathering = Gathering { list: "section", keys: vec!["knee", "slope_N"] };
            TomlDocument::parse(text, "a.toml").unwrap().deserialize_gathering::<Gathered>(&gathering)
        };
        let file = read("[[section]]\nlength_m = 1\nslope_N = 2\n[[section]]\nlength_m = 3\n").unwrap();
        assert_eq!((file.sections[0].length_m, file.sections[0].numbers["slope_N"]), (1.0, 2.0));
        assert!(file.sections[1].numbers.is_empty());
        for (text, place, code) in [
            ("[[section]]\nlength_m = 1\nslope = 1", (3, 1), "toml::unknown-key"),
            ("[[section]]\nlength_m = 1\nknee = \"1\"", (3, 8), "toml::wrong-type"),
            ("[[section]]\nlength_m = 1\n\"gathered keys\" = { knee = 1 }", (3, 1), "toml::unknown-key"),
        ] {
            let error = read(text).unwrap_err();
            assert_eq!(
                (error.line().unwrap(), error.column().unwrap(), error.code),
                (place.0, place.1, code),
                "{error}"
            );
        }
        let help = read("[[section]]\nlength_m = 1\nslope = 1").unwrap_err().help.unwrap();
        assert!(help.contains("did you mean `slope_N`?"), "{help}");
    }

    #[test]
    fn deep_nesting_is_an_error_not_an_overflow() {
        assert_eq!(error_of(&format!("a = {}", "[".repeat(1_000_000))).code, "toml::syntax");
        assert_eq!(error_of(&format!("{}a = 1", "a.".repeat(1_000_000))).code, "toml::syntax");
        assert_eq!(error_of(&format!("[{}a]", "a.".repeat(1_000_000))).code, "toml::syntax");
        assert_eq!(error_of(&"a = {".repeat(1_000_000)).code, "toml::syntax");
    }
}
