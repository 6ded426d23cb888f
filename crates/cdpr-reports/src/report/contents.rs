//! Contents of a report, and the candidate that its details are about.

use cdpr_calibration::Verdict;
use cdpr_calibration::selection::{Selection, SelectionCriterion, Warnings};
use cdpr_model::measurement::{Fold, Samples};
use cdpr_model::robot::Robot;

use super::addition::Addition;

/// Question of a report: which model to take, or the parameters of one that was chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Purpose {
    /// Candidates were compared and one may be recommended.
    Selection,
    /// One model was identified; another candidate is there to compare it with.
    Identification,
}

/// Contents of a report.
pub struct Report<'a> {
    /// The question.
    pub purpose: Purpose,
    /// The command that makes the same result again.
    pub command: &'a str,
    /// The robot as given, before any fit.
    pub robot: &'a Robot,
    /// All samples, those of the fit and those of the validation.
    pub samples: &'a Samples,
    /// How many of the samples `data_name` has.
    pub data_count: usize,
    /// How the samples were parted.
    pub folds: &'a [Fold],
    /// False where the model is judged by the data that it was fitted to.
    pub is_held_out: bool,
    /// Origin of the samples.
    pub data_name: &'a str,
    /// How validation data were chosen.
    pub validation_name: &'a str,
    /// The candidates and the choice.
    pub selection: &'a Selection,
    /// The error that decides.
    pub criterion: SelectionCriterion,
    /// Seed of the bootstrap.
    pub seed: u64,
    /// Version of the program.
    pub version: &'a str,
    /// Warnings about the data, or all of an identification; text between backticks is shown as code.
    pub warnings: &'a Warnings,
    /// Parts that options of this run ask for.
    pub additions: &'a [Addition],
}

impl Report<'_> {
    pub(super) fn title(&self) -> String {
        let name = &self.robot.name;
        match self.purpose {
            Purpose::Selection => format!("Control models for {name}"),
            Purpose::Identification => format!("Identification of {name}"),
        }
    }

    /// Warnings of text, JSON and page.
    pub(crate) fn told_warnings(&self) -> Warnings {
        match self.purpose {
            Purpose::Selection => self.selection.warnings(self.samples, self.warnings),
            Purpose::Identification => self.warnings.clone(),
        }
    }

    /// How far the recommended or identified model may be relied on, as text and JSON have it.
    pub(crate) fn verdict(&self, warnings: &Warnings) -> Verdict {
        match self.purpose {
            Purpose::Selection => Verdict::of_choice(&warnings.doubts),
            Purpose::Identification => Verdict::of_fit(&warnings.doubts),
        }
    }

    /// Word for a verdict on that model.
    pub(crate) fn status(&self, verdict: Verdict) -> &'static str {
        match self.purpose {
            Purpose::Selection => verdict.choice_status(),
            Purpose::Identification => verdict.fit_status(),
        }
    }

    /// Name of the data by which the models are judged.
    pub(super) fn data_words(&self) -> &'static str {
        if self.is_held_out { "validation data" } else { "the data of the fit" }
    }
}
