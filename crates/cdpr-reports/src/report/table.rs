//! Tables as data: the template turns them into HTML.

use minijinja::{Value, context};

use crate::html_page::{breakable, plain, prose};

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

    /// Content of the table.
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
        context! { label => plain(&label), caption => prose(&self.caption), head, rows }
    }
}

/// A name as code that may break after its separators.
fn code(text: &str) -> Value {
    Value::from_safe_string(format!("<code>{}</code>", breakable(text)))
}
