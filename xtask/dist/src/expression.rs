//! Expressions of licences as manifests have them (SPDX; `/` of older ones is OR).

/// Whether a package under an expression may be used where some licences are allowed; an error where it cannot be read.
pub(crate) fn is_allowed(expression: &str, allowed: &[&str]) -> Result<bool, String> {
    let spaced = expression.replace('(', " ( ").replace(')', " ) ").replace('/', " OR ");
    let words: Vec<&str> = spaced.split_whitespace().collect();
    let mut reader = Reader { words: &words, allowed };
    match (reader.any(), reader.words) {
        (Some(is_allowed), []) => Ok(is_allowed),
        _ => Err(format!("`{expression}` is no expression of licences")),
    }
}

/// Words that are still to read.
struct Reader<'a> {
    words: &'a [&'a str],
    allowed: &'a [&'a str],
}

impl<'a> Reader<'a> {
    /// Terms joined by OR, which binds less than AND.
    fn any(&mut self) -> Option<bool> {
        let mut sum = self.all()?;
        while self.takes("OR") {
            sum |= self.all()?;
        }
        Some(sum)
    }

    fn all(&mut self) -> Option<bool> {
        let mut product = self.one()?;
        while self.takes("AND") {
            product &= self.one()?;
        }
        Some(product)
    }

    /// A licence, one with an exception, or an expression in brackets.
    fn one(&mut self) -> Option<bool> {
        if self.takes("(") {
            let inner = self.any()?;
            return self.takes(")").then_some(inner);
        }
        let licence = self.next()?;
        let name = if self.takes("WITH") { format!("{licence} WITH {}", self.next()?) } else { licence.to_owned() };
        Some(self.allowed.contains(&name.as_str()))
    }

    fn next(&mut self) -> Option<&'a str> {
        let (first, rest) = self.words.split_first()?;
        self.words = rest;
        (!["AND", "OR", "WITH", "(", ")"].contains(first)).then_some(first)
    }

    fn takes(&mut self, word: &str) -> bool {
        let is_next = self.words.first() == Some(&word);
        self.words = &self.words[usize::from(is_next)..];
        is_next
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn and_binds_more_than_or_and_brackets_more_than_both() {
        let allowed = |expression: &str| is_allowed(expression, &["MIT", "BSD-3-Clause"]);
        for (expression, expected) in [
            ("MIT", true),
            ("GPL-3.0-only", false),
            ("Apache-2.0 OR MIT", true),
            ("Unlicense/MIT", true),
            ("MIT AND GPL-3.0-only", false),
            ("MIT OR GPL-3.0-only AND Zlib", true),
            ("(MIT OR GPL-3.0-only) AND Zlib", false),
            ("(Apache-2.0 OR MIT) AND BSD-3-Clause", true),
            ("MIT WITH LLVM-exception", false),
        ] {
            assert_eq!(allowed(expression), Ok(expected), "{expression}");
        }
        for wrong in ["", "MIT OR", "(MIT", "MIT Apache-2.0", "AND"] {
            assert!(allowed(wrong).is_err(), "{wrong}");
        }
    }
}
