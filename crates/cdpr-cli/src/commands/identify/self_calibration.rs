//! Data without poses: calibration by the sensors in the machine.

use std::process::ExitCode;

use cdpr::identification::{
    Comparison, GaugeConvention, Loss, Objective, SelfCalibration, evaluate_lengths, self_calibrate,
};
use cdpr::measurement::{InternalSamples, Known};
use cdpr::model::Model;
use cdpr_reports::answers::{PoselessJudgement, SelfCalibrationAnswer};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};

use super::Arguments;
use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::read_robot;
use crate::progress::Progress;

/// Convention for the frame of a robot whose poses nobody measured, facts known of it, and a robot to compare with.
#[derive(Debug, Args)]
pub(super) struct FrameArguments {
    /// Convention that fixes what data without poses leave free: anchors holds coordinates at the file's values, least-change keeps all anchors as near to the
    /// file's as the data let them be, known refuses data that leave a motion free.
    #[arg(long, value_name = "GAUGE", default_value = GaugeConvention::default().name(), value_parser = gauges())]
    pub(super) gauge: GaugeConvention,

    /// Fact known besides samples without poses: distance[1,2]=2.412, length[1]=1.597 (where changes count from), plane[1,2,3,4], wall-x[1,2], wall-y[1,2],
    /// level[1,2,3], equal-drum-radius[1,2]; each with a standard deviation in metres, e.g. distance[1,2]=2.412+-0.002 (without: 1 mm). May be repeated.
    #[arg(long, value_name = "FACT")]
    known: Vec<Known>,

    /// Robot whose frame anchors the calibrated ones are compared with, after the motion that brings them together best (Procrustes).
    #[arg(long, value_name = "ROBOT")]
    compare: Option<String>,
}

/// Conventions by their names.
fn gauges() -> impl TypedValueParser<Value = GaugeConvention> {
    let named = |name: String| GaugeConvention::ALL.into_iter().find(|gauge| gauge.name() == name);
    PossibleValuesParser::new(GaugeConvention::ALL.map(GaugeConvention::name))
        .map(move |name| named(name).unwrap_or_default())
}

impl FrameArguments {
    /// The first of them that is asked for.
    pub(super) fn asked(&self) -> Option<&'static str> {
        [
            ("--gauge", self.gauge != GaugeConvention::default()),
            ("--known", !self.known.is_empty()),
            ("--compare", self.compare.is_some()),
        ]
        .into_iter()
        .find_map(|(option, is_asked)| is_asked.then_some(option))
    }

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
    let asked = [
        (
            "--split",
            arguments.split.is_some(),
            "parts of the data are judged by errors of poses; judge by another file with --validation",
        ),
        ("--compare-objectives", arguments.compare_objectives, "objectives are compared by errors of poses"),
        ("--drive", arguments.drive.is_asked(), "what is driven is compared with what poses tell"),
        ("--report", arguments.report.is_some(), "its tables and charts are of errors at measured poses"),
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
        ("--course", arguments.course.is_asked(), "a course tells residuals at measured poses"),
        (
            "--objective other than length",
            arguments.settings().objective != Objective::Length,
            "there is no pose to be compared with",
        ),
        (
            "--loss huber or cauchy",
            !matches!(arguments.loss, Loss::Auto | Loss::Squared),
            "a pose takes up most of an outlier, so that its residual does not show it",
        ),
    ];
    let Some((option, _, reason)) = asked.into_iter().find(|(_, is_asked, _)| *is_asked) else { return Ok(()) };
    Err(Failure::input(
        "data::option-needs-poses",
        format!("{}: {option} needs measured poses, and these data have none: {reason}", arguments.data.name()),
        "leave it out, or write the poses that are found with --out-poses FILE and ask of that file",
    ))
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

/// Calibrates the robot, and writes what is asked for.
pub(super) fn run(arguments: &Arguments, model: &Model, output: &mut Output) -> Result<ExitCode, Failure> {
    refuse_options(arguments)?;
    let mut samples = arguments.data.read_internal(model, output)?;
    samples.facts.extend(arguments.frame.known.iter().cloned());
    let other = arguments.validation.as_ref().map(|path| arguments.data.read_other_internal(path, model, output));
    let other = other.transpose()?;
    let progress = Progress::of(arguments.starts as usize, "calibrating");
    let settings = arguments.settings();
    let found = self_calibrate(model, &samples, &arguments.free, &settings, &|| progress.step())
        .map_err(|error| Failure::refused(&arguments.data.name(), &error))?;
    drop(progress);
    let comparison = arguments.frame.comparison(&found)?;
    let validation = arguments
        .validation
        .as_ref()
        .zip(other.as_ref())
        .map(|(path, other)| judged((model, &found.fit.model), other, &path.display().to_string()));
    let validation = validation.transpose()?;
    let calibrated = found.fit.model.robot().to_toml();
    let poses = found.samples.to_csv(model.robot());
    let (out, out_poses) = (arguments.out.as_deref(), arguments.out_poses.as_deref());
    let files = [(out, calibrated.as_bytes()), (out_poses, poses.as_bytes())];
    files::write_all(&files.into_iter().filter_map(|(path, content)| Some((path?, content))).collect::<Vec<_>>())?;
    let names = [out, out_poses].map(|path| path.map(|path| path.display().to_string()));
    let of_data = (arguments.data.name(), &output.doubts());
    let answer = SelfCalibrationAnswer::new(found, (model, arguments.free.to_string()), of_data, names);
    output.answer(&answer.with_judgements(validation, comparison))
}
