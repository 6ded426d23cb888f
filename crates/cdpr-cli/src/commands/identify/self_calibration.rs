//! Data without poses: calibration by lengths alone.

use std::process::ExitCode;

use cdpr::identification::{Loss, Objective, self_calibrate};
use cdpr::model::Model;
use cdpr_reports::answers::SelfCalibrationAnswer;

use super::Arguments;
use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::progress::Progress;

/// Refuses options that ask for measured poses.
fn refuse_options(arguments: &Arguments) -> Result<(), Failure> {
    let asked = [
        ("--split", arguments.split.is_some()),
        ("--validation", arguments.validation.is_some()),
        ("--compare-objectives", arguments.compare_objectives),
        ("--drive", arguments.drive.is_asked()),
        ("--report", arguments.report.is_some()),
        ("--profile, --bootstrap or --uncertainty", arguments.uncertainty.is_asked()),
        ("--path or --out-reduced", arguments.path.is_asked()),
        ("--scale, --row-weight or --condition-map", arguments.scaling.is_asked()),
        ("--course", arguments.course.is_asked()),
        ("--objective other than length", arguments.settings().objective != Objective::Length),
        ("--loss huber or cauchy", !matches!(arguments.loss, Loss::Auto | Loss::Squared)),
    ];
    let Some((option, _)) = asked.into_iter().find(|(_, is_asked)| *is_asked) else { return Ok(()) };
    Err(Failure::input(
        "data::option-needs-poses",
        format!("{}: {option} needs measured poses, and these data have none", arguments.data.name()),
        "leave it out, or write the poses that are found with --out-poses FILE and ask of that file",
    ))
}

/// Calibrates the robot, and writes what is asked for.
pub(super) fn run(arguments: &Arguments, model: &Model, output: &mut Output) -> Result<ExitCode, Failure> {
    refuse_options(arguments)?;
    let samples = arguments.data.read_internal(model, output)?;
    let progress = Progress::of(arguments.starts as usize, "calibrating");
    let settings = arguments.settings();
    let found = self_calibrate(model, &samples, &arguments.free, &settings, &|| progress.step())
        .map_err(|error| Failure::refused(&arguments.data.name(), &error))?;
    drop(progress);
    let calibrated = found.fit.model.robot().to_toml();
    let poses = found.samples.to_csv(model.robot());
    let (out, out_poses) = (arguments.out.as_deref(), arguments.out_poses.as_deref());
    let files = [(out, calibrated.as_bytes()), (out_poses, poses.as_bytes())];
    files::write_all(&files.into_iter().filter_map(|(path, content)| Some((path?, content))).collect::<Vec<_>>())?;
    let names = [out, out_poses].map(|path| path.map(|path| path.display().to_string()));
    let of_data = (arguments.data.name(), &output.doubts());
    let answer = SelfCalibrationAnswer::new(found, (model, arguments.free.to_string()), of_data, names);
    output.answer(&answer)
}
