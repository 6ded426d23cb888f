//! Tables as data: the template turns them into HTML.

use minijinja::{Value, context};

/// A table with caption and head.
pub(super) struct Table {
    caption: String,
    head: Vec<Value>,
    rows: Vec<Value>,
}

/// One cell.
pub(super) struct Cell {
    text: Value,
    class: &'static str,
    /// Columns it spans.
    span: usize,
}

impl Cell {
    /// Words, left-aligned.
    pub(super) fn text(text: impl Into<String>) -> Self {
        Self { text: prose(&text.into()), class: "", span: 1 }
    }

    /// A few words that should stay on one line.
    pub(super) fn short(text: &str) -> Self {
        Self { class: "short", ..Self::text(text) }
    }

    /// A name in the notation of the command line.
    pub(super) fn code(text: &str) -> Self {
        Self { text: code(text), class: "name", span: 1 }
    }

    /// A number, right-aligned.
    pub(super) fn number(text: impl Into<String>) -> Self {
        Self { text: Value::from(text.into()), class: "number", span: 1 }
    }

    /// What it shows.
    pub(super) fn into_text(self) -> Value {
        self.text
    }

    /// Over several columns.
    pub(super) fn spanning(self, span: usize) -> Self {
        Self { span, ..self }
    }
}

impl Table {
    /// An empty table; columns are titles with the anchor of their definition, or "" for none. A title that starts with `#`
    /// is a column of numbers.
    pub(super) fn new(caption: impl Into<String>, columns: &[(&str, &str)]) -> Self {
        let head = columns.iter().map(|(title, definition)| {
            let (title, class) = title.strip_prefix('#').map_or((*title, ""), |title| (title, "number"));
            context! { title, class, definition => *definition }
        });
        Self { caption: caption.into(), head: head.collect(), rows: Vec::new() }
    }

    /// Appends a row; `class` marks it, e.g. as recommended.
    pub(super) fn push(&mut self, class: &str, cells: Vec<Cell>) {
        let cells: Value = cells
            .into_iter()
            .map(|cell| context! { text => cell.text, class => cell.class, span => cell.span })
            .collect();
        self.rows.push(context! { class, cells });
    }

    /// Number of rows.
    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// For the template.
    pub(super) fn into_value(self) -> Value {
        let rows: Value = self.rows.into_iter().collect();
        let head: Value = self.head.into_iter().collect();
        let label = self.caption.replace('`', "");
        context! { label => super::plain(&label), caption => prose(&self.caption), head, rows }
    }
}

/// Text with `…` shown as code, escaped.
pub(super) fn prose(text: &str) -> Value {
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

/// A name as code that may break after its separators.
fn code(text: &str) -> Value {
    Value::from_safe_string(format!("<code>{}</code>", breakable(text)))
}

fn breakable(text: &str) -> String {
    escape(text).replace(':', ":<wbr/>").replace(',', ",<wbr/>")
}

/// The text with the characters of markup written out, and control characters, which no page may contain, as boxes.
pub(super) fn escape(text: &str) -> String {
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
pub(super) fn printable(character: char) -> char {
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
