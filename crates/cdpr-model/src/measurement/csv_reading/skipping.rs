//! Rows that are left out because a number is missing or invalid.

use std::collections::BTreeMap;

use crate::reading::ReadError;

/// Rows left out, by error code.
#[derive(Debug, Default)]
pub(super) struct Skipped {
    /// Number of rows for every code, and the error of the first.
    rows: BTreeMap<&'static str, (usize, ReadError)>,
}

impl Skipped {
    /// Counts a row.
    pub(super) fn add(&mut self, error: ReadError) {
        self.add_all(1, error);
    }

    /// Counts rows with the error of the first of them.
    pub(super) fn add_all(&mut self, count: usize, error: ReadError) {
        self.rows.entry(error.code).or_insert((0, error)).0 += count;
    }

    /// Number of rows left out.
    pub(super) fn count(&self) -> usize {
        self.rows.values().map(|(count, _)| count).sum()
    }

    /// The first error, in the order of lines.
    pub(super) fn first(&self) -> Option<&ReadError> {
        self.rows.values().map(|(_, error)| error).min_by_key(|error| error.line())
    }

    /// A sentence for the user; `None` if no row is left out.
    pub(super) fn words(&self, file_name: &str, of: usize) -> Option<String> {
        let reason = |(count, error): &(usize, ReadError)| {
            format!("{count} such as line {} ({})", error.line().unwrap_or_default(), error.message)
        };
        let reasons: Vec<String> = self.rows.values().map(reason).collect();
        let count = self.count();
        (count > 0).then(|| format!("{file_name}: {count} of {of} rows are left out: {}", reasons.join("; ")))
    }
}
