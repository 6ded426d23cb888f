//! What a step of the entrance found.

/// Counts and complaints of one step.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Outcome {
    /// Checks that passed.
    pub(crate) passed: usize,
    /// Checks that failed.
    pub(crate) failed: usize,
    /// One line for each thing found wrong, with its place.
    pub(crate) complaints: Vec<String>,
}

impl Outcome {
    /// One check: passed when there is nothing to complain about.
    pub(crate) fn of(complaints: Vec<String>) -> Self {
        let failed = usize::from(!complaints.is_empty());
        Self { passed: 1 - failed, failed, complaints }
    }

    /// Counts and complaints of another part of the same step.
    pub(crate) fn add(&mut self, part: Self) {
        self.passed += part.passed;
        self.failed += part.failed;
        self.complaints.extend(part.complaints);
    }

    /// The complaints as one error text.
    pub(crate) fn into_result(self) -> Result<(), String> {
        if self.failed == 0 { Ok(()) } else { Err(self.complaints.join("\n")) }
    }
}
