//! Tables for people: columns aligned by spaces.

/// Rows of cells under a heading; the first column is aligned left, the others right unless asked for.
pub(crate) struct Table {
    heading: Vec<String>,
    rows: Vec<Vec<String>>,
    left: Vec<usize>,
}

impl Table {
    pub(crate) fn new<const N: usize>(heading: [&str; N]) -> Self {
        Self::with_heading(heading.into_iter().map(str::to_owned).collect())
    }

    pub(crate) fn with_heading(heading: Vec<String>) -> Self {
        Self { heading, rows: Vec::new(), left: vec![0] }
    }

    /// The same table with this column aligned left too.
    pub(crate) fn left_column(mut self, column: usize) -> Self {
        self.left.push(column);
        self
    }

    pub(crate) fn row(&mut self, cells: Vec<String>) {
        self.rows.push(cells);
    }

    /// The table as lines that end with a newline.
    pub(crate) fn text(&self) -> String {
        let columns = self.heading.len();
        let lines = || std::iter::once(&self.heading).chain(&self.rows);
        let width = |column: usize| lines().filter_map(|line| line.get(column)).map(|cell| cell.chars().count()).max();
        let widths: Vec<usize> = (0..columns).map(|column| width(column).unwrap_or(0)).collect();
        let mut text = String::new();
        for line in lines() {
            let cells = line.iter().zip(&widths).enumerate().map(|(column, (cell, width))| {
                let padding = " ".repeat(width.saturating_sub(cell.chars().count()));
                if self.left.contains(&column) { format!("{cell}{padding}") } else { format!("{padding}{cell}") }
            });
            text.push_str(cells.collect::<Vec<_>>().join("  ").trim_end());
            text.push('\n');
        }
        text
    }
}

/// A number with this many decimals; a dash for none.
pub(crate) fn cell(number: Option<f64>, decimals: usize) -> String {
    match number {
        Some(number) if number.is_finite() => {
            let text = format!("{number:.decimals$}");
            // rounded to zero, a number has no sign
            let is_zero = text.bytes().all(|byte| matches!(byte, b'-' | b'0' | b'.'));
            if is_zero { text.trim_start_matches('-').to_owned() } else { text }
        }
        Some(number) if number.is_infinite() => "∞".to_owned(),
        _ => "–".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_align_by_characters_not_bytes() {
        let mut table = Table::new(["name", "σ mm"]);
        table.row(vec!["é".to_owned(), "–".to_owned()]);
        table.row(vec!["long".to_owned(), "12.5".to_owned()]);
        assert_eq!(table.text(), "name  σ mm\né        –\nlong  12.5\n");
    }
}
