//! Whether a cell's dirt was named, and whether an answer is wrong without a word.

use crate::answer::{Answer, Found};
use crate::kinds::{Kind, Naming, Place};
use crate::written::Errors;

/// An error below is never called wrong (m and rad).
const HARMLESS: Errors = Errors { position: 3e-3, rotation: 0.2 * std::f64::consts::PI / 180.0 };
/// How many times the told band an error may be.
const FACTOR: f64 = 2.0;
/// Lines beside the right one that count as right.
const NEAR: usize = 2;

/// Verdict on one cell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Verdict {
    /// Exit code 0 without a caution, and the written robot misses.
    pub(crate) silent_wrong: bool,
    /// The first finding has kind, cable and line of the dirt.
    pub(crate) named: bool,
    /// A finding is a caution or worse, or the input is refused.
    pub(crate) cautioned: bool,
    /// The answer is not to be trusted.
    pub(crate) not_trusted: bool,
}

impl Verdict {
    /// `errors` are those of the written robot, where there is one.
    pub(crate) fn of(kind: &Kind, place: &Place, answer: &Answer, errors: Option<Errors>) -> Self {
        let wrong = errors.is_some_and(|errors| is_wrong(errors, answer.told));
        Self {
            silent_wrong: answer.is_trusted() && !answer.cautions() && wrong,
            named: named(kind.naming, place, answer),
            cautioned: answer.cautions() || !answer.is_trusted(),
            not_trusted: !answer.is_trusted(),
        }
    }
}

/// More than twice the told band, and more than 3 mm or 0.2°. An error that is no number is wrong.
fn is_wrong(errors: Errors, told: Option<Errors>) -> bool {
    let told = told.unwrap_or(Errors { position: 0.0, rotation: 0.0 });
    let within = |error: f64, told: f64, harmless: f64| error <= harmless.max(FACTOR * told);
    !within(errors.position, told.position, HARMLESS.position)
        || !within(errors.rotation, told.rotation, HARMLESS.rotation)
}

fn named(naming: Naming, place: &Place, answer: &Answer) -> bool {
    let first = answer.findings.first();
    match naming {
        Naming::Clean => !answer.cautions() && answer.is_trusted(),
        Naming::Kinds(kinds) => first.is_some_and(|found| is_right(found, kinds, place)),
        Naming::Trusted(kinds) => answer.is_trusted() && first.is_some_and(|found| is_right(found, kinds, place)),
        Naming::Refusal(kinds, code, words) => {
            let says = |text: &str| words.iter().any(|word| text.contains(word));
            let refused = answer.is_refusal() && answer.code.starts_with(code) && says(&answer.reason);
            refused || first.is_some_and(|found| is_right(found, kinds, place))
        }
        Naming::Column(name) => {
            let says = |text: &str| text.contains(&format!("`{name}`")) || text.contains(&format!("column {name}"));
            answer.warnings.iter().any(|text| says(text)) || (answer.is_refusal() && says(&answer.reason))
        }
    }
}

/// Kind, cable and line of a finding are those of the dirt, as far as it has them.
fn is_right(found: &Found, kinds: &[&str], place: &Place) -> bool {
    let near = |line: usize| place.lines.iter().any(|right| right.abs_diff(line) <= NEAR);
    kinds.contains(&found.kind.as_str())
        && (place.cable.is_none() || found.cable == place.cable)
        && (place.lines.is_empty() || found.line.is_some_and(near))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn answer(kind: &str, cable: Option<usize>, line: Option<usize>) -> Answer {
        let (severity, text) = ("caution".to_owned(), String::new());
        Answer { findings: vec![Found { kind: kind.to_owned(), cable, line, severity, text }], ..Answer::default() }
    }

    #[test]
    fn kind_cable_and_line_have_to_be_right() {
        let (naming, place) = (Naming::Kinds(&["step"]), Place { cable: Some(3), lines: vec![52] });
        assert!(named(naming, &place, &answer("step", Some(3), Some(54))));
        assert!(!named(naming, &place, &answer("step", Some(3), Some(55))));
        assert!(!named(naming, &place, &answer("step", Some(2), Some(52))));
        assert!(!named(naming, &place, &answer("step", Some(3), None)));
        assert!(!named(naming, &place, &answer("drift", Some(3), Some(52))));
        assert!(!named(naming, &place, &Answer::default()));
    }

    #[test]
    fn small_errors_and_told_ones_are_not_wrong() {
        let errors = |millimetres: f64| Errors { position: millimetres * 1e-3, rotation: 0.0 };
        assert!(!is_wrong(errors(2.9), Some(errors(0.1))) && !is_wrong(errors(9.9), Some(errors(5.0))));
        assert!(is_wrong(errors(3.1), Some(errors(1.5))) && is_wrong(errors(3.1), None));
        assert!(is_wrong(errors(f64::NAN), Some(errors(5.0))));
        let turned = Errors { position: 0.0, rotation: 0.004 };
        assert!(is_wrong(turned, Some(errors(1.0))));
    }
}
