//! `cdpr identify`: optimal parameters of one model from measurements.

mod course;
mod driving;
mod path;
mod report;
mod scaling;
mod self_calibration;
mod uncertainty;

use std::path::PathBuf;
use std::process::ExitCode;

use cdpr::identification::fit::{self, Fit, Minimizer, Prior, descent_count, fit_observed};
use cdpr::identification::selection::Warnings;
use cdpr::identification::{
    CourseStep, Driven, ErrorBlocks, Evaluation, EvaluationError, Loss, ObjectiveValues, clock_warning,
    compare_objectives, course, evaluate_fitted, frame_warning,
};
use cdpr::measurement::{Samples, Split};
use cdpr::model::{FreeParameters, Model};
use cdpr::robot::ParameterKind;
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};

use crate::answer::Output;
use crate::failure::Failure;
use crate::files;
use crate::inputs::ModelArguments;
use crate::measurements::DataArguments;
use crate::progress::Progress;
use crate::selecting::{ObjectiveArguments, losses};
use cdpr_reports::answers::{self, IdentificationAnswer, ObjectiveAnswer};
use driving::{Drive, DriveArguments};

const EXAMPLES: &str = "\
Examples:
  cdpr identify robot.toml samples.csv --free length-offset --out calibrated.toml
  cdpr identify robot.toml samples.csv --free 'frame-anchor[1,3]' --split blocks:5
  cdpr identify robot.toml samples.csv --free pulley-radius --model pulley \\
      --validation other.csv --sigma position_m=0.001,length_m=0.0002
  cdpr identify robot.toml samples.csv --free frame-anchor,platform-anchor \\
      --prior platform-anchor=0.02
  cdpr identify robot.toml samples.csv --free frame-anchor --objective pose --drive study.toml
  cdpr identify robot.toml samples.csv --free frame-anchor,platform-anchor \\
      --path lasso --path-figure path.svg --out-path sparse.toml
  cdpr identify robot.toml lengths.csv --free frame-anchor --gauge least-change \
      --known 'distance[1,2]=2.412+-0.002' --out-poses found.csv
  cdpr identify robot.toml samples.csv --model elastic --starts 10 \\
      --free frame-anchor,platform-anchor,compliance,wrench --prior platform-anchor=0.02";

const FREE_HELP: &str = "\
Parameters to identify, separated by commas: frame-anchor, platform-anchor, length-offset, length-scale; \
with pulleys pulley-radius, swivel-axis; with recorded motor angles drum-radius, spool-build-up, start-length, with drums also drum-pitch, drum-axis, start-angle; \
with an elastic model and recorded tensions also compliance (1/EA), hidden-length, wrench (constant, weight included), \
tension-scale, tension-offset, without poses these three of rigid models, too; with times (t_s) clock-offset; of the tracker tracker-frame, marker-frame; `frame-anchor[1,3]` frees cables 1 and 3 only";

/// Identify the parameters of a model from measured poses and recorded lengths.
///
/// The exit code is 1 when the data do not determine all free parameters; the calibrated file is written all the same.
#[derive(Debug, Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(flatten)]
    model: ModelArguments,

    #[command(flatten)]
    data: DataArguments,

    #[arg(long, value_name = "LIST", help = FREE_HELP)]
    free: FreeParameters,

    /// Parameters that stay as they are although --free names them, e.g. `frame-anchor[1]`.
    #[arg(long, value_name = "LIST", default_value = "", hide_default_value = true)]
    hold: FreeParameters,

    /// Ridges towards the file's values with these standard deviations, e.g. platform-anchor=0.02.
    #[arg(long, value_name = "NAME=SIGMA,…", value_delimiter = ',', allow_hyphen_values = true)]
    prior: Vec<Prior>,

    /// Measurements to judge the calibrated model by; they are not fitted to.
    #[arg(long, value_name = "FILE", conflicts_with = "split")]
    validation: Option<PathBuf>,

    /// Hold parts of DATA out to judge by: column (`set`), blocks:K, kfold:K or region:K.
    #[arg(long, value_name = "SPLIT")]
    split: Option<Split>,

    /// Starts: the file's values and others by a Sobol sequence (anchors up to 0.5 m away, compliances up to 10/3 times larger or
    /// smaller); the optima they lead to are listed.
    #[arg(long, value_name = "N", default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    starts: u32,

    /// Way to the optimum; all lead to the same one.
    #[arg(long, value_name = "METHOD", default_value = Minimizer::default().name(), value_parser = minimizers())]
    minimizer: Minimizer,

    /// Loss of a sample's residuals. Auto: squared, unless samples lie beyond 8 robust standard deviations; Huber then.
    #[arg(long, value_name = "LOSS", default_value = Loss::default().name(), value_parser = losses())]
    loss: Loss,

    #[command(flatten)]
    objective: ObjectiveArguments,

    /// Fit by every objective and cost, and judge each optimum by all of them.
    #[arg(long)]
    compare_objectives: bool,

    #[command(flatten)]
    drive: DriveArguments,

    /// Seed of the split kfold:K and of other starts.
    #[arg(long, value_name = "SEED", default_value_t = 0)]
    seed: u64,

    /// Calibrated robot file to write.
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,

    /// Samples to write with the poses that were found (CSV), where the data have none.
    #[arg(long, value_name = "FILE")]
    out_poses: Option<PathBuf>,

    #[command(flatten)]
    frame: Box<self_calibration::FrameArguments>,

    /// Report to write: tables and charts in one HTML file.
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,

    #[command(flatten)]
    uncertainty: uncertainty::UncertaintyArguments,

    #[command(flatten)]
    path: Box<path::PathArguments>,

    #[command(flatten)]
    scaling: Box<scaling::ScalingArguments>,

    #[command(flatten)]
    course: course::CourseArguments,
}

impl Arguments {
    fn settings(&self) -> fit::Settings {
        let Arguments { hold, prior, starts, minimizer, loss, seed, .. } = self;
        self.scaling.of(self.objective.of(fit::Settings {
            hold: hold.clone(),
            priors: prior.clone(),
            starts: *starts,
            minimizer: *minimizer,
            loss: *loss,
            seed: *seed,
            keeps_course: self.course.is_asked(),
            gauge: self.frame.gauge,
            ..fit::Settings::default()
        }))
    }
}

/// Minimizers by their names, short ones too.
fn minimizers() -> impl TypedValueParser<Value = Minimizer> {
    let short = |name: &str| match name {
        "levenberg-marquardt" => Some("lm"),
        "trust-region" => Some("trf"),
        _ => None,
    };
    let possible =
        Minimizer::ALL.map(|minimizer| PossibleValue::new(minimizer.name()).aliases(short(minimizer.name())));
    let is_named =
        move |minimizer: &Minimizer, name: &str| minimizer.name() == name || short(minimizer.name()) == Some(name);
    let named = move |name: String| Minimizer::ALL.into_iter().find(|minimizer| is_named(minimizer, &name));
    PossibleValuesParser::new(possible).map(move |name| named(name).unwrap_or_default())
}

pub(crate) fn run(arguments: Arguments, output: &mut Output) -> Result<ExitCode, Failure> {
    let model = arguments.model.read()?;
    if arguments.data.lacks_poses(&model)? {
        return self_calibration::run(&arguments, &model, output);
    }
    if let Some(option) = arguments.frame.asked().or(arguments.out_poses.as_ref().map(|_| "--out-poses")) {
        return Err(poses_are_there(&arguments.data.name(), option));
    }
    let samples = arguments.data.read(&model, output)?;
    samples.check().map_err(|error| Failure::refused(&arguments.data.name(), &error))?;
    let other = arguments.validation.as_ref().map(|path| arguments.data.read_other(path, &model, output));
    let other = other.transpose()?;
    let drive = arguments.drive.read(arguments.seed)?;
    let progress = Progress::of(1, "identifying");
    let task =
        Task { model: &model, samples: &samples, arguments: &arguments, drive: drive.as_ref(), progress: &progress };
    progress.expect(task.descents(1));
    task.tell_about_unused_column(output);
    let result = task.identify(other.as_ref())?;
    let calibrated = result.fit.model.robot().to_toml();
    let uncertainty = uncertainty::find(&task, &result.fit)?;
    let files = uncertainty.files(&result.fit.model);
    let (scaling, map) = scaling::find(&task, &result.fit)?;
    let mut path = path::find(&task, &result.fit, other.as_ref())?;
    let found = (path.path.take(), path.reduction.take(), path.warning.take());
    let (course, course_files) = arguments.course.answer(&result);
    let answer = task.answer(result, output.doubts())?.with_uncertainty(uncertainty).with_path(found);
    let answer = answer.with_scaling(scaling).with_course(course);
    arguments.uncertainty.write(&files)?;
    let page = arguments
        .report
        .as_ref()
        .map(|_| report::page(&task, other.as_ref(), answer.reason(), &answer.warnings(), &answer.additions()))
        .transpose()?;
    drop(progress);
    let calibrated_file = arguments.out.as_deref().map(|path| (path, calibrated.as_bytes()));
    let report_file = arguments.report.as_deref().zip(page.as_deref().map(str::as_bytes));
    let further = map.iter().chain(&course_files).map(|(path, content)| (path.as_path(), &content[..]));
    files::write_all(
        &calibrated_file.into_iter().chain(report_file).chain(path.files()).chain(further).collect::<Vec<_>>(),
    )?;
    output.answer(&answer)
}

/// Refuses options that are of poses nobody measured.
fn poses_are_there(data: &str, option: &str) -> Failure {
    let message = format!("{data}: {option} is of calibration without measured poses, and these data have them");
    Failure::input("data::has-poses", message, "leave it out")
}

/// One identification with its data.
struct Task<'a> {
    model: &'a Model,
    samples: &'a Samples,
    arguments: &'a Arguments,
    drive: Option<&'a Drive>,
    progress: &'a Progress,
}

/// The reported fit, how many samples it was fitted to, those of them that are no outliers, and errors on data that it was not fitted
/// to (after, before).
struct Identification {
    fit: Fit,
    samples: usize,
    frame_warning: Option<String>,
    train: Samples,
    train_on_one_clock: Samples,
    validation: Option<(Evaluation, Evaluation)>,
    course: Vec<CourseStep>,
}

impl Task<'_> {
    fn tell_about_unused_column(&self, output: &Output) {
        let Arguments { split, validation, .. } = self.arguments;
        if split.is_none() && validation.is_none() && Split::Column.folds(self.samples, 0).is_ok() {
            output.remark("all rows are fitted to; `--split column` holds out those that the column `set` names");
        }
    }

    /// A fit to all samples.
    fn of_all(&self, fit: Fit, validation: Option<(Evaluation, Evaluation)>) -> Result<Identification, Failure> {
        self.of(fit, self.samples, validation)
    }

    /// A fit to these samples.
    fn of(
        &self,
        fit: Fit,
        samples: &Samples,
        validation: Option<(Evaluation, Evaluation)>,
    ) -> Result<Identification, Failure> {
        let trusted = fit.trusted_samples(samples.len());
        let train_on_one_clock = fit.as_fitted(samples).subset(&trusted);
        let train = fit.in_robot_frame(samples).subset(&trusted);
        let frame_warning = frame_warning(self.model.robot(), &fit, samples, &self.settings());
        let course = course(samples, (&fit, &self.settings()))
            .map_err(|error| Failure::refused(&self.arguments.data.name(), &error))?;
        Ok(Identification { fit, samples: samples.len(), frame_warning, train, train_on_one_clock, validation, course })
    }

    /// Fits to all samples or to those of the one fold; several folds are only fitted to for judging.
    fn identify(&self, other: Option<&Samples>) -> Result<Identification, Failure> {
        if let Some(other) = other {
            let fit = self.fit(self.samples)?;
            let validation = Some((
                self.evaluate(&fit.model, &fit.as_fitted(other))?,
                self.evaluate_given(&fit.in_robot_frame(other))?,
            ));
            return self.of_all(fit, validation);
        }
        let Some(split) = self.arguments.split else {
            return self.of_all(self.fit(self.samples)?, None);
        };
        let folds = split
            .folds(self.samples, self.arguments.seed)
            .map_err(|error| Failure::refused(&format!("{}: --split", self.arguments.data.name()), &error))?;
        self.progress.expect(self.descents(if folds.len() == 1 { 1 } else { folds.len() + 1 }));
        let (mut after, mut before) = (Evaluation::default(), Evaluation::default());
        // the loss is chosen once, by all data of the reported fit
        let everything: Vec<usize> = (0..self.samples.len()).collect();
        let part = if let [fold] = &folds[..] { &fold.train } else { &everything };
        let train = self.samples.subset(part);
        let reported = self.fit(&train)?;
        for fold in &folds {
            let held = self.samples.subset(&fold.validation);
            let of_fold = match folds.len() {
                1 => None,
                _ => Some(self.fit_under(reported.loss, &self.samples.subset(&fold.train))?),
            };
            let fit = of_fold.as_ref().unwrap_or(&reported);
            // the whole recording has the neighbours of a pose at the edge of a part
            let as_fitted = match fit.clock_offset {
                Some(_) => fit.as_fitted(self.samples).subset(&fold.validation),
                None => fit.as_fitted(&held),
            };
            after.extend(&self.evaluate(&fit.model, &as_fitted)?);
            before.extend(&self.evaluate_given(&fit.in_robot_frame(&held))?);
        }
        let mut result = self.of(reported, &train, Some((after, before)))?;
        result.fit.renumber_outliers(part);
        Ok(result)
    }

    fn settings(&self) -> fit::Settings {
        self.arguments.settings()
    }

    /// Descents of this many fits.
    fn descents(&self, fits: usize) -> usize {
        fits * descent_count(&self.settings())
    }

    fn fit(&self, samples: &Samples) -> Result<Fit, Failure> {
        self.fit_under(self.arguments.loss, samples)
    }

    fn fit_under(&self, loss: Loss, samples: &Samples) -> Result<Fit, Failure> {
        let step = || self.progress.step();
        let (free, settings) = (&self.arguments.free, fit::Settings { loss, ..self.settings() });
        let mut fit = fit_observed(self.model, samples, free, &settings, &step).map_err(|error| match error {
            fit::InputError::Parameters(error) => Failure::refused("--free or --hold", &error),
            error => Failure::refused(&self.arguments.data.name(), &error),
        })?;
        fit.warnings.extend(clock_warning(&fit, samples, free, &settings));
        Ok(fit)
    }

    /// Errors of a model that was fitted.
    fn evaluate(&self, model: &Model, samples: &Samples) -> Result<Evaluation, Failure> {
        evaluate_fitted(model, samples).map_err(|error| Failure::refused(&self.model.robot().name, &error))
    }

    /// Errors of the model as given; none where a file that a free wrench completes says nothing of the load.
    fn evaluate_given(&self, samples: &Samples) -> Result<Evaluation, Failure> {
        match evaluate_fitted(self.model, samples) {
            Err(EvaluationError::Load(_)) if self.arguments.free.names(ParameterKind::Wrench) => {
                Ok(Evaluation::default())
            }
            other => other.map_err(|error| Failure::refused(&self.model.robot().name, &error)),
        }
    }

    /// Error figures without the samples that neither model explains, which a warning counts.
    fn blocks(&self, after: Evaluation, before: Evaluation, warnings: &mut Warnings) -> [ErrorBlocks; 2] {
        let aside = if self.arguments.loss == Loss::Squared { Vec::new() } else { after.unexplained_with(&before) };
        if aside.is_empty() {
            return [after.blocks(), before.blocks()];
        }
        let (count, all) = (aside.len(), after.len());
        warnings.list.push(format!(
            "outliers: {count} of {all} validation samples are left out of the errors, since neither the model as given nor the \
             identified one explains them"
        ));
        let kept: Vec<usize> = (0..all).filter(|place| !aside.contains(place)).collect();
        [&after, &before].map(|errors| if errors.is_empty() { errors.blocks() } else { errors.subset(&kept).blocks() })
    }

    /// The objective, with the errors of the calibrated model on the samples and on a machine.
    fn objective(&self, fit: &Fit, train: [&Evaluation; 2], samples: &Samples) -> Result<ObjectiveAnswer, Failure> {
        let settings = self.settings();
        let values = |errors| ObjectiveValues::of(self.model, samples, errors, settings.rotation_length);
        let driven = |model: &Model| self.drive.map(|drive| drive.of(model)).transpose();
        let drive = |model: &Model| match driven(model) {
            Ok(None) => Driven::Nowhere,
            Ok(Some(accuracy)) => Driven::To(Box::new(accuracy)),
            Err(failure) => Driven::Refused(failure.message().to_owned()),
        };
        let objectives = match self.arguments.compare_objectives {
            true => compare_objectives(self.model, samples, &self.arguments.free, &settings, &drive)
                .map_err(|error| Failure::refused(&self.arguments.data.name(), &error))?,
            false => Vec::new(),
        };
        Ok(ObjectiveAnswer {
            objective: settings.objective,
            minimize: settings.minimize,
            objective_values: values(train[0]),
            objective_values_before: values(train[1]),
            certificate: fit.certificate.clone(),
            converged: fit.status != fit::Status::NotConverged,
            driven: driven(&fit.model)?,
            driven_before: driven(self.model)?,
            objectives,
        })
    }

    /// What the validation errors are of.
    fn validation_name(&self) -> Option<String> {
        let Arguments { validation, split, .. } = self.arguments;
        let file = validation.as_ref().map(|path| path.display().to_string());
        file.or_else(|| split.map(|split| format!("held-out parts ({split})")))
    }

    fn answer(&self, result: Identification, mut warnings: Warnings) -> Result<IdentificationAnswer, Failure> {
        let Identification { fit, samples, frame_warning, train, train_on_one_clock, validation, .. } = result;
        warnings.doubt(frame_warning);
        let validation = validation.map(|(after, before)| self.blocks(after, before, &mut warnings));
        let errors = [self.evaluate(&fit.model, &train_on_one_clock)?, self.evaluate_given(&train)?];
        let objective = self.objective(&fit, [&errors[0], &errors[1]], &train)?;
        Ok(IdentificationAnswer::new(answers::Identification {
            model: self.model,
            free: self.arguments.free.to_string(),
            data: self.arguments.data.name(),
            samples,
            sigmas: train.sigmas,
            train: errors.map(|errors| errors.blocks()),
            fit,
            objective,
            validation_data: self.validation_name(),
            validation,
            warnings,
            out: self.arguments.out.as_ref().map(|path| path.display().to_string()),
        }))
    }
}
