//! Part of an answer that is compared: what a rule ignores is left out, long lists are thinned, numbers have twelve digits.

use std::path::Path;

use serde_json::{Map, Number, Value};

use crate::rules::{Rule, rule};

/// Longest lists of numbers, and of anything else, that are kept whole.
const MOST_NUMBERS: usize = 24;
const MOST_ENTRIES: usize = 12;
/// Entries kept of longer lists, evenly spread with the first and the last.
const KEPT_NUMBERS: usize = 12;
const KEPT_ENTRIES: usize = 6;

/// Keys of a thinned list: its length, the entries kept, the sum of the magnitudes of its numbers.
pub(crate) const LENGTH: &str = "#";
pub(crate) const ENTRIES: &str = "@";
pub(crate) const MAGNITUDES: &str = "+";
/// Stands for any sentence.
const SENTENCE: &str = "a sentence";

/// Part of a value that is compared; `path` has the keys that lead to it.
pub(crate) fn compared(value: &Value, path: &mut Vec<String>) -> Value {
    match value {
        Value::Object(entries) => {
            let mut kept = Map::new();
            for (key, value) in entries {
                path.push(key.clone());
                if rule(path) != Rule::Ignored {
                    kept.insert(key.clone(), compared(value, path));
                }
                path.pop();
            }
            Value::Object(kept)
        }
        Value::Array(list) => thinned(list, path),
        Value::String(text) if rule(path) != Rule::Exact && is_sentence(text) => Value::from(SENTENCE),
        Value::Number(number) => twelve_digits(number),
        other => other.clone(),
    }
}

/// Names of anything have no blanks.
fn is_sentence(text: &str) -> bool {
    text.contains(char::is_whitespace)
}

fn thinned(list: &[Value], path: &mut Vec<String>) -> Value {
    let of_numbers = list.iter().all(|value| value.is_number() || value.is_null());
    let (most, count) = if of_numbers { (MOST_NUMBERS, KEPT_NUMBERS) } else { (MOST_ENTRIES, KEPT_ENTRIES) };
    if list.len() <= most {
        return list.iter().map(|value| compared(value, path)).collect();
    }
    let spread = (0..count).map(|index| &list[index * (list.len() - 1) / (count - 1)]);
    let mut kept = Map::new();
    kept.insert(LENGTH.to_owned(), list.len().into());
    kept.insert(ENTRIES.to_owned(), spread.map(|value| compared(value, path)).collect());
    if of_numbers {
        let sum: f64 = list.iter().filter_map(Value::as_f64).map(f64::abs).sum();
        kept.insert(MAGNITUDES.to_owned(), Number::from_f64(sum).map_or(Value::Null, |sum| twelve_digits(&sum)));
    }
    Value::Object(kept)
}

/// Whole numbers as they are; others with twelve digits.
fn twelve_digits(number: &Number) -> Value {
    match number.as_f64() {
        Some(value) if number.is_f64() => format!("{value:.11e}").parse::<f64>().map_or(Value::Null, Value::from),
        _ => Value::Number(number.clone()),
    }
}

/// Part of a file that is compared: columns of a table (CSV), the numbers of any other text.
pub(crate) fn of_file(path: &Path) -> Value {
    let Ok(text) = std::fs::read_to_string(path) else { return Value::Null };
    let table = path.extension().is_some_and(|ending| ending == "csv");
    compared(&if table { columns(&text) } else { numbers(&text) }, &mut Vec::new())
}

fn columns(text: &str) -> Value {
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let mut columns = vec![Vec::new(); names.len()];
    for line in lines {
        for (column, cell) in columns.iter_mut().zip(line.split(',')) {
            column.push(number_or_text(cell));
        }
    }
    names.iter().map(|name| (*name).to_owned()).zip(columns.into_iter().map(Value::Array)).collect()
}

/// A number of a table is no count, even if it is whole.
fn number_or_text(cell: &str) -> Value {
    match cell.trim().parse::<f64>() {
        Ok(number) => Number::from_f64(number).map_or(Value::Null, Value::Number),
        Err(_) => Value::from(cell),
    }
}

fn numbers(text: &str) -> Value {
    let is_part = |letter: char| letter.is_ascii_digit() || ".-+eE".contains(letter);
    let words = text.split(|letter| !is_part(letter));
    let found = words.filter(|word| word.contains(|letter: char| letter.is_ascii_digit()));
    let mut entries = Map::new();
    entries.insert("numbers".to_owned(), found.map(number_or_text).filter(Value::is_number).collect());
    Value::Object(entries)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    fn kept(value: &Value) -> Value {
        compared(value, &mut Vec::new())
    }

    #[test]
    fn iterations_and_times_are_left_out_and_sentences_are_one_word() {
        let answer =
            json!({"iterations": 7, "timing": {"fit_s": 0.1}, "status": "found", "reason": "it is so", "rank": 2});
        assert_eq!(kept(&answer), json!({"status": "found", "reason": "a sentence", "rank": 2}));
    }

    #[test]
    fn a_long_list_keeps_its_length_its_ends_and_the_sum_of_its_magnitudes() {
        let list: Vec<f64> = (0..100).map(|number| -f64::from(number)).collect();
        let kept = kept(&json!({"lengths_m": list}));
        let list = &kept["lengths_m"];
        assert_eq!((&list[LENGTH], &list[MAGNITUDES]), (&json!(100), &json!(4950.0)));
        assert_eq!((&list[ENTRIES][0], &list[ENTRIES][11]), (&json!(-0.0), &json!(-99.0)));
    }

    #[test]
    fn twelve_digits_are_kept_and_whole_numbers_stay_whole() {
        assert_eq!(kept(&json!([1.0 / 3.0, 7, 2.0])), json!([0.333333333333, 7, 2.0]));
    }

    #[test]
    fn tables_are_columns_and_other_texts_their_numbers() {
        assert_eq!(columns("x_m,set\n1,train\n2.5,\n"), json!({"x_m": [1.0, 2.5], "set": ["train", ""]}));
        assert_eq!(numbers("M669 K6 A0.0:-1.25e-3\n"), json!({"numbers": [669.0, 6.0, 0.0, -0.00125]}));
    }
}
