//! Data with poses: parameters that explain the recorded lengths at measured poses.

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_reports::answers::{IdentificationAnswer, Told};

use super::task::Task;
use super::{Arguments, path, report, scaling, uncertainty};
use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::measurements::{screen, unseen};
use crate::progress::Progress;

/// Fits the model, judges it, and writes the files that are asked for.
pub(super) fn run(arguments: &Arguments, model: &Model, output: &mut Output) -> Result<ExitCode, Failure> {
    if let Some(option) = arguments.frame.asked().or(arguments.out_poses.as_ref().map(|_| "--out-poses")) {
        return Err(poses_are_there(&arguments.data.name(), option));
    }
    let samples = arguments.data.read(model, output)?;
    samples.check().map_err(|error| Failure::refused(&arguments.data.name(), &error))?;
    let samples = screen(samples, model, output);
    let read_other = |path: &PathBuf| -> Result<Samples, Failure> {
        let other = screen(arguments.data.read_other(path, model, output)?, model, output);
        unseen(&samples, other, path, output)
    };
    let other = arguments.validation.as_ref().map(read_other).transpose()?;
    let drive = arguments.drive.read(arguments.seed)?;
    let progress = Progress::of(1, "identifying");
    let task = Task { model, samples: &samples, arguments, drive: drive.as_ref(), progress: &progress };
    progress.expect(task.descents(1));
    task.tell_about_unused_column(output);
    let found = task.identify(other.as_ref())?;
    let fit = &found.fit;
    let uncertainty = uncertainty::find(&task, fit)?;
    let files = uncertainty.files(&fit.model);
    let (scaling, map) = scaling::find(&task, fit)?;
    let mut path = path::find(&task, fit, other.as_ref())?;
    let (course, course_files) = arguments.course.answer(found.course.clone(), fit);
    let objective = task.objective(&found)?;
    let told = Told {
        free: arguments.free.to_string(),
        data: arguments.data.name(),
        validation_data: task.validation_name(),
        warnings: output.doubts(),
        out: arguments.out.as_ref().map(|path| path.display().to_string()),
    };
    let answer = IdentificationAnswer::new(model, found, objective, told)
        .with_uncertainty(uncertainty)
        .with_path(path.path.take(), path.reduction.take(), path.warning.take())
        .with_scaling(scaling)
        .with_course(course);
    let calibrated = answer.calibrated().to_toml();
    arguments.uncertainty.write(&files)?;
    let page = arguments
        .report
        .as_ref()
        .map(|_| report::page(&task, other.as_ref(), None, answer.reason(), answer.warnings(), &answer.additions()))
        .transpose()?;
    drop(progress);
    let calibrated_file = arguments.out.as_deref().map(|path| (path, calibrated.as_bytes()));
    let report_file = arguments.report.as_deref().zip(page.as_deref().map(str::as_bytes));
    let further = map.iter().chain(&course_files).map(|(path, content)| (path.as_path(), &content[..]));
    files::write_all(
        &calibrated_file.into_iter().chain(report_file).chain(path.files()).chain(further).collect::<Vec<_>>(),
    )?;
    output.answer_accepting(&answer, arguments.trust)
}

/// Refuses options that are of poses nobody measured.
fn poses_are_there(data: &str, option: &str) -> Failure {
    let message = format!("{data}: {option} is of calibration without measured poses, and these data have them");
    Failure::input("data::has-poses", message, "leave it out")
}
