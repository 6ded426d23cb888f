//! The report of an identification: that of a comparison with the model as given.

use cdpr_calibration::Candidate;
use cdpr_calibration::selection::{SelectionCriterion, Settings, Warnings, select, select_without_poses};
use cdpr_calibration::unobserved;
use cdpr_model::measurement::{Fold, InternalSamples, Samples};
use cdpr_model::model::FreeParameters;

use super::task::Task;
use crate::failure::Failure;
use crate::session::command_line;
use cdpr_reports::comparison::DataDivision;
use cdpr_reports::report::{Addition, Purpose, Report, render};

/// The page: the model as given and the identified one, on data held out where there are any, else on the data of the fit; `internal` are all samples where their
/// poses are not measured.
pub(super) fn page(
    task: &Task<'_>,
    other: Option<&Samples>,
    internal: Option<&InternalSamples>,
    reason: &str,
    warnings: &Warnings,
    additions: &[Addition],
) -> Result<String, Failure> {
    let arguments = task.arguments;
    let name = arguments.data.name();
    let all: Vec<usize> = (0..task.samples.len()).collect();
    let data_count = task.samples.len();
    let (samples, folds) = match (other, arguments.split) {
        (Some(other), _) => {
            let parted = DataDivision::of_two_files(task.samples, other, &task.validation_name().unwrap_or_default())
                .map_err(|error| Failure::refused(&name, &error))?;
            (parted.samples, parted.folds)
        }
        (None, Some(split)) => {
            let folds =
                split.folds(task.samples, arguments.seed).map_err(|error| Failure::refused("--split", &error))?;
            (task.samples.clone(), folds)
        }
        (None, None) => {
            let fold = Fold { name: "all samples".to_owned(), train: all.clone(), validation: all };
            (task.samples.clone(), vec![fold])
        }
    };
    let composition = task.model.composition();
    let free = |free: FreeParameters| Candidate { composition, free };
    let candidates = [free(FreeParameters::default()), free(arguments.free.clone())];
    let criterion = internal.map_or(SelectionCriterion::Position, |_| SelectionCriterion::Length);
    let settings = Settings { fit: task.settings(), seed: arguments.seed, criterion, ..Settings::default() };
    let robot = task.model.robot();
    let compared = match internal {
        Some(internal) => select_without_poses(robot, &candidates, internal, &folds, &settings, &unobserved),
        None => select(robot, &candidates, &samples, &folds, &settings, &unobserved).map(|own| (own, samples)),
    };
    let (mut selection, samples) = compared.map_err(|error| Failure::refused(&name, &error))?;
    // the user has chosen the model: the page is about it, whatever the model as given can do
    selection.recommended = Some(1);
    selection.reason = reason.to_owned();
    let validation = task.validation_name();
    let report = Report {
        purpose: Purpose::Identification,
        command: &command_line(),
        robot,
        samples: &samples,
        data_count,
        folds: &folds,
        is_held_out: validation.is_some(),
        data_name: &name,
        validation_name: validation.as_deref().unwrap_or("none: all figures are of the data of the fit"),
        selection: &selection,
        criterion,
        seed: arguments.seed,
        version: env!("CARGO_PKG_VERSION"),
        warnings,
        additions,
    };
    render(&report).map_err(|error| Failure::unwritable("the report", &error))
}
