//! Data without poses: calibration by the sensors in the machine.

use std::process::ExitCode;

use cdpr_calibration::{
    Comparison, Loss, Objective, SelfCalibration, cross_validate_without_poses, evaluate_lengths, self_calibrate,
};
use cdpr_model::measurement::{Fold, InternalSamples, Split};
use cdpr_model::model::Model;
use cdpr_model::reading::ErrorCode;
use cdpr_reports::answers::{PoselessJudgement, SelfCalibrationAnswer};

use super::options::FrameArguments;
use super::task::Task;
use super::{Arguments, report};
use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::read_robot;
use crate::measurements::{BY_REGIONS, NO_OUTLIER, NO_POSE, refuse_without_poses};
use crate::progress::Progress;

impl FrameArguments {
    /// The anchors beside those of the other robot.
    fn comparison(&self, found: &SelfCalibration) -> Result<Option<Comparison>, Failure> {
        let Some(name) = &self.compare else { return Ok(None) };
        let (model, other) = (&found.fit.model, read_robot(name)?);
        let may_mirror = found.gauge.free.contains(&"mirror");
        match Comparison::of(model, &other, may_mirror) {
            Some(comparison) => Ok(Some(comparison)),
            None => {
                let (own, others) = (model.cable_count(), other.cables.len());
                let message = format!("--compare {name}: it has {others} cables, the calibrated robot {own}");
                Err(Failure::input("data::cable-count", message, "compare with a robot of the same cables"))
            }
        }
    }
}

/// Refuses options that ask for measured poses, each with what it needs them for.
fn refuse_options(arguments: &Arguments) -> Result<(), Failure> {
    refuse_without_poses(
        &arguments.data.name(),
        &[
            ("--split region:K", matches!(arguments.split, Some(Split::Region(_))), BY_REGIONS),
            ("--compare-objectives", arguments.compare_objectives, "objectives are compared by errors of poses"),
            ("--drive", arguments.drive.is_asked(), "what is driven is compared with what poses tell"),
            (
                "--profile, --bootstrap or --uncertainty",
                arguments.uncertainty.is_asked(),
                "they draw samples at measured poses",
            ),
            ("--path or --out-reduced", arguments.path.is_asked(), "penalties are chosen by errors of poses"),
            (
                "--scale, --row-weight or --condition-map",
                arguments.scaling.is_asked(),
                "rows are weighed by the accuracy of each sensor here",
            ),
            ("--objective other than length", arguments.settings().objective != Objective::Length, NO_POSE),
            ("--loss huber or cauchy", !matches!(arguments.loss, Loss::Auto | Loss::Squared), NO_OUTLIER),
        ],
    )
}

/// Errors of a model as given and of the calibrated one on samples that it was not fitted to.
fn judged(
    (model, calibrated): (&Model, &Model),
    samples: &InternalSamples,
    name: &str,
) -> Result<PoselessJudgement, Failure> {
    let errors = |model: &Model| {
        let errors = evaluate_lengths(model, samples).map_err(|error| Failure::refused(name, &error))?;
        Ok::<_, Failure>(errors.blocks())
    };
    Ok(PoselessJudgement::new(name.to_owned(), errors(calibrated)?, errors(model).ok()))
}

/// Errors on the parts that each fold holds out.
fn cross_validated(
    arguments: &Arguments,
    (model, samples): (&Model, &InternalSamples),
    (folds, found): (&[Fold], &SelfCalibration),
) -> Result<Option<PoselessJudgement>, Failure> {
    let Some(split) = arguments.split else { return Ok(None) };
    let (after, before) =
        cross_validate_without_poses(model, samples, &arguments.free, &arguments.settings(), folds, found)
            .map_err(|error| Failure::refused(&arguments.data.name(), &error))?;
    Ok(Some(PoselessJudgement::of_parts(split, after.blocks(), before.map(|errors| errors.blocks()))))
}

/// Calibrates the robot, and writes what is asked for.
pub(super) fn run(arguments: &Arguments, model: &Model, output: &mut Output) -> Result<ExitCode, Failure> {
    refuse_options(arguments)?;
    let name = arguments.data.name();
    let refused = |error: &dyn ErrorCode| Failure::refused(&name, error);
    let mut samples = arguments.data.read_internal(model, output)?;
    samples.facts.extend(arguments.frame.known.iter().cloned());
    let other = arguments.validation.as_ref().map(|path| arguments.data.read_other_internal(path, model, output));
    let other = other.transpose()?;
    let folds = arguments.split.map(|split| split.folds(&samples.samples, arguments.seed)).transpose();
    let folds = folds.map_err(|error| refused(&error))?.unwrap_or_default();
    let progress = Progress::of(arguments.starts as usize, "calibrating");
    let settings = arguments.settings();
    let part = if let [fold] = &folds[..] { samples.subset(&fold.train) } else { samples.clone() };
    let found = self_calibrate(model, &part, &arguments.free, &settings, &|| progress.step_of_work())
        .map_err(|error| refused(&error))?;
    let comparison = arguments.frame.comparison(&found)?;
    let by_file = arguments
        .validation
        .as_ref()
        .zip(other.as_ref())
        .map(|(path, other)| judged((model, &found.fit.model), other, &path.display().to_string()));
    let validation = by_file.transpose()?.or(cross_validated(arguments, (model, &samples), (&folds, &found))?);
    let poses = found.samples.to_csv(model.robot());
    let (course, mut files) = arguments.course.answer(found.course.clone(), &found.fit);
    let found_samples = found.samples.clone();
    let (out, out_poses) = (&arguments.out, &arguments.out_poses);
    let names = [out, out_poses].map(|path| path.as_ref().map(|path| path.display().to_string()));
    let answer =
        SelfCalibrationAnswer::new(found, model, arguments.free.to_string(), name.clone(), &output.doubts(), names);
    let answer = answer.with_judgements(validation, comparison).with_course(course);
    let calibrated = answer.calibrated().to_toml();
    if let Some(path) = &arguments.report {
        let all = other.as_ref().map_or(Ok(samples.clone()), |other| samples.followed_by(other));
        let all = all.map_err(|error| refused(&error))?;
        let samples = if folds.is_empty() { &found_samples } else { &samples.samples };
        let task = Task { model, samples, arguments, drive: None, progress: &progress };
        let other = other.as_ref().map(|other| &other.samples);
        let page = report::page(&task, other, Some(&all), answer.reason(), answer.warnings(), &answer.additions())?;
        files.push((path.clone(), page.into_bytes()));
    }
    drop(progress);
    files.extend(out.iter().map(|path| (path.clone(), calibrated.clone().into_bytes())));
    files.extend(out_poses.iter().map(|path| (path.clone(), poses.clone().into_bytes())));
    files::write_all(&files.iter().map(|(path, content)| (path.as_path(), &content[..])).collect::<Vec<_>>())?;
    output.answer_accepting(&answer, arguments.trust)
}
