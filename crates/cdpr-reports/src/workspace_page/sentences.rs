//! Reasons of thousands of nodes: the few sentences they are made of, and the numbers in them.

use std::collections::HashMap;

/// Stands for a number in a sentence.
const SLOT: char = '§';

/// Sentences that were met, each once, in the order of their first use.
#[derive(Default)]
pub(super) struct Sentences {
    pub(super) list: Vec<String>,
    known: HashMap<String, usize>,
}

impl Sentences {
    /// The index of the text's sentence, and its numbers joined by spaces.
    pub(super) fn take(&mut self, text: &str) -> (usize, String) {
        let (sentence, numbers) = parted(text);
        let next = self.list.len();
        let index = *self.known.entry(sentence.clone()).or_insert(next);
        if index == next {
            self.list.push(sentence);
        }
        (index, numbers.join(" "))
    }
}

/// The text with `§` for each number, and the numbers. A `§` of the text itself counts as one.
fn parted(text: &str) -> (String, Vec<&str>) {
    let (mut sentence, mut numbers) = (String::new(), Vec::new());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let length = if first == SLOT { SLOT.len_utf8() } else { number_length(rest) };
        if length == 0 {
            sentence.push(first);
            rest = &rest[first.len_utf8()..];
        } else {
            sentence.push(SLOT);
            numbers.push(&rest[..length]);
            rest = &rest[length..];
        }
    }
    (sentence, numbers)
}

/// Bytes of the digits, with points between them, that the text starts with.
fn number_length(text: &str) -> usize {
    let end = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
    let number = text[..end].trim_end_matches('.');
    if number.starts_with('.') { 0 } else { number.len() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Counterpart of the page's program.
    fn joined(sentence: &str, numbers: &str) -> String {
        let mut numbers = numbers.split(' ');
        let mut text = String::new();
        for c in sentence.chars() {
            match c {
                SLOT => text.push_str(numbers.next().unwrap_or_default()),
                c => text.push(c),
            }
        }
        text
    }

    #[test]
    fn every_reason_comes_back_word_for_word_from_few_sentences() {
        let reasons = [
            "cable 3 would need 1234.5 N, 12 N above its 1000 N.",
            "cable 12 would need 0.5 N, 1e3 N above its 7 N.",
            "cable 3 would need −4.25 N (§ 7), see .5 and 1.2.3.",
            "no number at all",
            "",
        ];
        let mut sentences = Sentences::default();
        for reason in reasons.iter().chain(&reasons) {
            let (index, numbers) = sentences.take(reason);
            assert_eq!(joined(&sentences.list[index], &numbers), *reason);
        }
        assert_eq!(sentences.list.len(), reasons.len());
        let (a, _) = sentences.take("cable 1 pulls 5 N");
        let (b, _) = sentences.take("cable 22 pulls 5.75 N");
        assert_eq!(a, b, "numbers make no new sentence");
    }
}
