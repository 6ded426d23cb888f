//! A report with its answer, and the candidate that its details are about.

use cdpr_calibration::selection::Judgement;

use super::contents::Report;
use crate::answers::SelectionAnswer;

/// Report with its answer, of which tables, sentences and drawings are made.
pub(super) struct ReportPage<'a> {
    pub(super) report: &'a Report<'a>,
    pub(super) answer: SelectionAnswer<'a>,
}

/// A candidate that was judged.
#[derive(Clone, Copy)]
pub(super) struct Named<'a> {
    pub(super) index: usize,
    pub(super) name: &'a str,
    pub(super) judgement: &'a Judgement,
}

/// The candidate that the details are about, and the one to compare it with.
pub(super) struct Shown<'a> {
    pub(super) index: usize,
    pub(super) name: &'a str,
    pub(super) judgement: &'a Judgement,
    /// The model that the robot runs without calibration, if that is a candidate.
    pub(super) as_given: Option<Named<'a>>,
}

impl<'a> Shown<'a> {
    /// The recommended candidate, else the best, else the first that could be identified.
    pub(super) fn of(answer: &SelectionAnswer<'a>) -> Option<Self> {
        let judged = |index: usize| {
            let candidate = answer.candidates.get(index)?;
            Some(Named { index, name: candidate.name, judgement: candidate.judged? })
        };
        let Named { index, name, judgement } = judged(answer.places.shown?)?;
        let as_given = answer.places.as_given.and_then(judged);
        Some(Self { index, name, judgement, as_given })
    }

    /// The robot as given where it is another candidate.
    pub(super) fn before(&self) -> Option<Named<'a>> {
        self.as_given.filter(|given| given.index != self.index)
    }
}
