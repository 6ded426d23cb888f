//! Texts and numbers as SVG writes them.

/// The text with the characters of markup written out, and those that XML does not allow as boxes.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            '\u{fffe}' | '\u{ffff}' => escaped.push('\u{fffd}'),
            other if other.is_control() => escaped.push('\u{fffd}'),
            other => escaped.push(other),
        }
    }
    escaped
}

/// A tenth of a pixel is as exact as the eye.
pub(super) fn coordinate(value: f64) -> String {
    let text = format!("{value:.1}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_have_no_markup_and_numbers_no_needless_digit() {
        assert_eq!(escape("<a href='\"'>\u{0}&"), "&lt;a href=&#39;&quot;&#39;&gt;\u{fffd}&amp;");
        assert_eq!([12.04, 12.06, -0.5].map(coordinate), ["12", "12.1", "-0.5"]);
    }
}
