//! Text that may stand in a page: escaped, printable, with code shown as code.

use minijinja::Value;

/// The text without characters that no page may contain; templates escape the rest.
pub(crate) fn plain(text: &str) -> String {
    text.chars().map(printable).collect()
}

/// Text with `…` shown as code, escaped.
pub(crate) fn prose(text: &str) -> Value {
    let parts: Vec<&str> = text.split('`').collect();
    if parts.len().is_multiple_of(2) {
        return Value::from_safe_string(escape(text));
    }
    let mut html = String::new();
    for (index, part) in parts.into_iter().enumerate() {
        match index % 2 {
            0 => html.push_str(&escape(part)),
            _ => html.push_str(&format!("<code>{}</code>", breakable(part))),
        }
    }
    Value::from_safe_string(html)
}

/// Escaped text with places to break after `:` and `,`.
pub(crate) fn breakable(text: &str) -> String {
    escape(text).replace(':', ":<wbr/>").replace(',', ",<wbr/>")
}

/// The text with the characters of markup written out, and control characters, which no page may contain, as boxes.
fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            other => escaped.push(printable(other)),
        }
    }
    escaped
}

/// The character itself, or a box for what HTML and XML do not allow.
fn printable(character: char) -> char {
    let allowed = matches!(character, '\n' | '\t') || !character.is_control();
    if allowed && !matches!(character, '\u{fffe}' | '\u{ffff}') { character } else { '\u{fffd}' }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markup_in_text_stays_text() {
        assert_eq!(prose("a `b<i>` & c").to_string(), "a <code>b&lt;i&gt;</code> &amp; c");
        assert_eq!(escape("<a href='\"'>\u{0}"), "&lt;a href=&#39;&quot;&#39;&gt;\u{fffd}");
    }
}
