//! Compares what is kept of two answers by the rules of their keys.

use serde_json::{Map, Value};

use crate::answer::{ENTRIES, LENGTH, MAGNITUDES};
use crate::rules::{LARGEST_CONDITION, Rule, rule, tolerance};

/// Compares answers to one call; the differences, and the number of values compared.
#[derive(Default)]
pub(crate) struct Comparison {
    /// Keys, and lists' positions, that lead to the values at hand, for people.
    place: String,
    /// Keys alone, for the rules.
    keys: Vec<String>,
    /// Largest magnitude of the list at hand, 0 outside of lists.
    largest: f64,
    /// Differences, a line each.
    pub(crate) differences: Vec<String>,
    /// Values compared.
    pub(crate) values: usize,
}

impl Comparison {
    /// Compares what is expected with what is found.
    pub(crate) fn of(expected: &Value, found: &Value) -> Self {
        let mut comparison = Self::default();
        comparison.values_of(expected, found);
        comparison
    }

    fn values_of(&mut self, expected: &Value, found: &Value) {
        match (expected, found) {
            (Value::Object(expected), Value::Object(found)) if expected.contains_key(LENGTH) => {
                self.thinned(expected, found)
            }
            (Value::Object(expected), Value::Object(found)) => self.objects(expected, found),
            (Value::Array(expected), Value::Array(found)) => self.lists(expected, found),
            _ => self.single(expected, found),
        }
    }

    fn single(&mut self, expected: &Value, found: &Value) {
        self.values += 1;
        match (expected.as_f64(), found.as_f64()) {
            (Some(wanted), Some(number)) if expected.is_f64() && found.is_f64() => self.numbers(wanted, number, 1.0),
            _ if expected == found => {}
            _ => self.differs(expected, found, "exactly"),
        }
    }

    /// `terms`: numbers that are summed in each, whose floors add up.
    fn numbers(&mut self, expected: f64, found: f64, terms: f64) {
        match tolerance(&self.keys, expected, self.largest) {
            None if found.abs() >= LARGEST_CONDITION => {}
            None => self.differs(&expected.into(), &found.into(), "1e8 or more"),
            // what twelve digits leave out
            Some(most) if (found - expected).abs() <= (terms * most).max(1e-11 * expected.abs()) => {}
            Some(most) => {
                let words = format!("± {most:.1e}, differs by {:.1e}", (found - expected).abs());
                self.differs(&expected.into(), &found.into(), &words);
            }
        }
    }

    fn objects(&mut self, expected: &Map<String, Value>, found: &Map<String, Value>) {
        for (key, wanted) in expected {
            self.inside(key, |inner| match found.get(key) {
                Some(value) => inner.values_of(wanted, value),
                None => inner.tell(&format!("expected {}, is not there", short(wanted))),
            });
        }
        for (key, value) in found.iter().filter(|(key, _)| !expected.contains_key(*key)) {
            self.inside(key, |inner| inner.tell(&format!("is new: {}", short(value))));
        }
    }

    fn lists(&mut self, expected: &[Value], found: &[Value]) {
        if expected.len() != found.len() {
            self.values += 1;
            self.differs(&expected.len().into(), &found.len().into(), "number of entries, exactly");
            return;
        }
        let before = self.largest;
        self.largest = expected.iter().map(largest).fold(self.largest, f64::max);
        self.entries(expected, found);
        self.largest = before;
    }

    fn entries(&mut self, expected: &[Value], found: &[Value]) {
        for (index, (wanted, value)) in expected.iter().zip(found).enumerate() {
            let length = self.place.len();
            self.place += &format!("[{index}]");
            self.values_of(wanted, value);
            self.place.truncate(length);
        }
    }

    /// Lists of which some entries were kept.
    fn thinned(&mut self, expected: &Map<String, Value>, found: &Map<String, Value>) {
        let of = |list: &Map<String, Value>, key: &str| list.get(key).cloned().unwrap_or(Value::Null);
        if of(expected, LENGTH) != of(found, LENGTH) {
            self.values += 1;
            return self.differs(&of(expected, LENGTH), &of(found, LENGTH), "number of entries, exactly");
        }
        if let (Value::Array(wanted), Value::Array(entries)) = (of(expected, ENTRIES), of(found, ENTRIES)) {
            self.lists(&wanted, &entries);
        }
        let sums = (of(expected, MAGNITUDES).as_f64(), of(found, MAGNITUDES).as_f64());
        if let (Some(wanted), Some(sum)) = sums {
            self.values += 1;
            let terms = of(expected, LENGTH).as_f64().unwrap_or(1.0);
            let length = self.place.len();
            self.place += " (sum of magnitudes)";
            self.numbers(wanted, sum, terms);
            self.place.truncate(length);
        }
    }

    fn inside(&mut self, key: &str, compare: impl FnOnce(&mut Self)) {
        let length = self.place.len();
        if length > 0 {
            self.place.push('.');
        }
        self.place.push_str(key);
        self.keys.push(key.to_owned());
        // a number of an object has its own scale
        let before = std::mem::replace(&mut self.largest, 0.0);
        compare(self);
        self.largest = before;
        self.keys.pop();
        self.place.truncate(length);
    }

    fn differs(&mut self, expected: &Value, found: &Value, tolerance: &str) {
        let by = match rule(&self.keys) {
            Rule::Default => "default".to_owned(),
            rule => format!("{rule:?}"),
        };
        let (expected, found) = (short(expected), short(found));
        self.tell(&format!("expected {expected}, found {found} ({tolerance}; rule: {by})"));
    }

    fn tell(&mut self, words: &str) {
        self.differences.push(format!("{}: {words}", self.place));
    }
}

/// Largest magnitude of the numbers of a list of lists.
fn largest(value: &Value) -> f64 {
    match value {
        Value::Array(list) => list.iter().map(largest).fold(0.0, f64::max),
        Value::Number(number) => number.as_f64().map_or(0.0, f64::abs),
        _ => 0.0,
    }
}

fn short(value: &Value) -> String {
    let text = value.to_string();
    match text.char_indices().nth(80) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::compared;
    use serde_json::json;

    /// Differences of two answers, as they are kept.
    fn differences(expected: &Value, found: &Value) -> Vec<String> {
        let [expected, found] = [expected, found].map(|answer| compared(answer, &mut Vec::new()));
        Comparison::of(&expected, &found).differences
    }

    #[test]
    fn two_billionths_are_found_and_half_a_billionth_is_not() {
        let length = |value: f64| json!({"cable_lengths_m": [value, 2.0]});
        let found = differences(&length(3.0), &length(3.0 * (1.0 + 2e-9)));
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].starts_with("cable_lengths_m[0]: expected 3.0, found 3.000000006"), "{found:?}");
        assert!(differences(&length(3.0), &length(3.0 * (1.0 + 5e-10))).is_empty());
    }

    #[test]
    fn below_the_floor_of_its_unit_a_number_is_zero() {
        let error = |value: f64| json!({"position_error_m": {"mean": value}});
        assert!(differences(&error(3e-13), &error(9e-13)).is_empty());
        assert_eq!(differences(&error(3e-13), &error(3e-12)).len(), 1);
        let tension = |value: f64| json!({"tensions_N": [value]});
        assert!(differences(&tension(0.0), &tension(9e-10)).is_empty());
        assert_eq!(differences(&tension(0.0), &tension(2e-9)).len(), 1);
    }

    #[test]
    fn zeros_of_a_matrix_are_as_exact_as_its_largest_entry() {
        let matrix = |value: f64| json!({"stiffness": [[1e6, value], [value, 1e6]]});
        assert!(differences(&matrix(0.0), &matrix(1e-7)).is_empty());
        assert_eq!(differences(&matrix(0.0), &matrix(1e-5)).len(), 2);
    }

    #[test]
    fn counts_statuses_and_choices_are_compared_exactly() {
        for (expected, found) in [
            (json!({"rank": 12}), json!({"rank": 11})),
            (json!({"status": "converged"}), json!({"status": "not-converged"})),
            (json!({"recommended": "elastic with anchors"}), json!({"recommended": "elastic with offsets"})),
            (json!({"trusted": true}), json!({"trusted": false})),
            (json!({"reason": null}), json!({"reason": "the limits are broken"})),
            (json!({"warnings": ["one thing"]}), json!({"warnings": []})),
            (json!({"a_m": 1.0}), json!({})),
            (json!({}), json!({"a_m": 1.0})),
            (json!({"a_m": 1.0}), json!({"a_m": null})),
        ] {
            assert_eq!(differences(&expected, &found).len(), 1, "{expected} {found}");
        }
    }

    #[test]
    fn iterations_times_sentences_and_coordinates_of_a_fit_are_not_compared() {
        for (expected, found) in [
            (json!({"iterations": 12}), json!({"iterations": 11})),
            (json!({"timing": {"total_s": 0.1}}), json!({"timing": {"total_s": 0.2}})),
            (json!({"reason": "the cables are slack"}), json!({"reason": "cables hang slack"})),
            (json!({"parameters": [{"value": 1.0}]}), json!({"parameters": [{"value": 2.0}]})),
        ] {
            assert!(differences(&expected, &found).is_empty(), "{expected} {found}");
        }
    }

    #[test]
    fn condition_numbers_count_six_digits_up_to_a_hundred_million() {
        let condition = |value: f64| json!({"condition": value});
        assert!(differences(&condition(1e7), &condition(1e7 + 5.0)).is_empty());
        assert_eq!(differences(&condition(1e7), &condition(1e7 + 20.0)).len(), 1);
        assert!(differences(&condition(2e8), &condition(5e11)).is_empty());
        assert_eq!(differences(&condition(2e8), &condition(5e7)).len(), 1);
    }

    #[test]
    fn a_change_that_no_kept_entry_shows_is_in_the_sum() {
        let list = |changed: f64| json!({"z_m": (0..100).map(|index| if index == 40 { changed } else { 1.0 }).collect::<Vec<f64>>()});
        let found = differences(&list(1.0), &list(1.001));
        assert_eq!(found.len(), 1);
        assert!(found[0].contains("sum of magnitudes"), "{found:?}");
        assert!(differences(&list(1.0), &list(1.0)).is_empty());
    }

    #[test]
    fn lists_of_other_lengths_are_one_difference() {
        assert_eq!(differences(&json!({"poses": [1, 2]}), &json!({"poses": [1, 2, 3]})).len(), 1);
    }
}
