//! Numbers on the command line, and the reason against words that are none.

use std::error::Error;
use std::fmt;
use std::str::FromStr;

/// Reason against words on the command line, as its user reads it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Unreadable(String);

impl fmt::Display for Unreadable {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(&self.0)
    }
}

impl Error for Unreadable {}

impl<T: Into<String>> From<T> for Unreadable {
    fn from(reason: T) -> Self {
        Self(reason.into())
    }
}

/// Finite numbers separated by commas, e.g. `0.5,-4`.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NumberList(pub(crate) Vec<f64>);

impl FromStr for NumberList {
    type Err = Unreadable;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text.trim().is_empty() {
            return Err("numbers separated by commas expected, e.g. 0.5,-4".into());
        }
        let number = |(index, word): (usize, &str)| {
            let component = index + 1;
            finite_number(word).map_err(|why| Unreadable(format!("component {component}: {why}")))
        };
        Ok(Self(text.split(',').enumerate().map(number).collect::<Result<_, _>>()?))
    }
}

/// A length above 0 m.
pub(crate) fn positive_length(text: &str) -> Result<f64, Unreadable> {
    match finite_number(text)? {
        length if length > 0.0 => Ok(length),
        length => Err(format!("{length} is no length: a number of metres above 0 is expected").into()),
    }
}

/// A number that can be calculated with.
pub(crate) fn finite_number(text: &str) -> Result<f64, Unreadable> {
    let word = text.trim();
    match word.parse::<f64>() {
        _ if word.is_empty() => Err("a number is missing".into()),
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(format!("`{word}` is not a finite number").into()),
        Err(_) => Err(format!("`{word}` is not a number").into()),
    }
}

/// A number of zero or more.
pub(crate) fn number_from_zero(text: &str) -> Result<f64, Unreadable> {
    match finite_number(text)? {
        number if number >= 0.0 => Ok(number),
        number => Err(format!("{number} is below 0").into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_take_signs_exponents_and_spaces() {
        assert_eq!("-1, 2.5,+3e-2".parse(), Ok(NumberList(vec![-1.0, 2.5, 0.03])));
    }

    #[test]
    fn the_component_at_fault_is_named() {
        for (text, component) in [("1,x", 2), ("nan", 1), ("1,2,inf", 3), ("1,,2", 2), ("1,2,", 3), ("1;2", 1)] {
            let message = text.parse::<NumberList>().unwrap_err().to_string();
            assert!(message.starts_with(&format!("component {component}: ")), "{text}: {message}");
        }
    }
}
