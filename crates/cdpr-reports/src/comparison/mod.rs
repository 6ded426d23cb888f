//! A comparison of candidates with all that its folder holds.

mod division;
mod files;
mod tables;

use cdpr_calibration::candidate::Candidate;
use cdpr_calibration::selection::{Selection, Settings, Warnings};
use cdpr_model::measurement::{Fold, InternalSamples, Samples};
use cdpr_model::robot::Robot;

use crate::NamedFile;
use crate::answers::SelectionAnswer;
use crate::report::{Purpose, Report};
pub use division::DataDivision;
pub use files::UnwritableFile;

/// Robot and data on which candidates are compared.
pub struct ComparisonData {
    /// The robot as given.
    pub robot: Robot,
    /// All samples, those of the fits and those of the validation.
    pub samples: Samples,
    /// The same without measured poses, where these are what the comparison finds.
    pub internal: Option<InternalSamples>,
    /// How many of the samples `data_name` has; the others are of another file, for validation alone.
    pub data_count: usize,
    /// Parts of the samples.
    pub folds: Vec<Fold>,
    /// Origin of the samples.
    pub data_name: String,
    /// How validation data were chosen, in words.
    pub validation_name: String,
    /// The command that gives the same result again.
    pub command: String,
    /// Warnings about the data.
    pub warnings: Warnings,
    /// Names and contents of the files read.
    pub inputs: Vec<NamedFile>,
}

/// Candidates that were compared on data.
pub struct Comparison {
    /// Robot and data.
    pub data: ComparisonData,
    /// The candidates, from simple to complex.
    pub candidates: Vec<Candidate>,
    /// Way of comparing.
    pub settings: Settings,
    /// Candidates with their errors, and the choice.
    pub selection: Selection,
    /// Wall time of the comparison (s).
    pub seconds: f64,
    /// Mean wall time of one inverse problem per candidate (s).
    pub inverse_seconds: Vec<Option<f64>>,
}

impl Comparison {
    /// The answer with wall times.
    pub fn answer(&self) -> SelectionAnswer<'_> {
        SelectionAnswer::new(&self.report()).with_timing(self.seconds, &self.inverse_seconds)
    }

    /// Contents of its report.
    pub fn report(&self) -> Report<'_> {
        let data = &self.data;
        Report {
            purpose: Purpose::Selection,
            command: &data.command,
            robot: &data.robot,
            samples: &data.samples,
            data_count: data.data_count,
            folds: &data.folds,
            is_held_out: true,
            data_name: &data.data_name,
            validation_name: &data.validation_name,
            selection: &self.selection,
            criterion: self.settings.criterion,
            seed: self.settings.seed,
            version: env!("CARGO_PKG_VERSION"),
            warnings: &data.warnings,
            additions: &[],
        }
    }
}
