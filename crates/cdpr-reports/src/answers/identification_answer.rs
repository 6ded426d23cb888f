//! Parameters identified from measurements, and what they are worth.

use cdpr_calibration::fit::{Estimate, Fit};
use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{
    Analysis, Doubt, DoubtKind, ErrorBlocks, Loss, Outlier, RecordingFrames, Starts, StoppedBy, Verdict, distrust,
};
use cdpr_model::geometry::MotionPattern;
use cdpr_model::measurement::SensorSigmas;
use cdpr_model::model::Model;
use serde::Serialize;

use super::UncertaintyAnswer;
use super::course_answer::CourseAnswer;
use super::error_table::convergence_remark;
use super::objective_answer::ObjectiveAnswer;
use super::path_answer::PathAnswer;
use super::reduction_answer::ReductionAnswer;
use super::scaling_answer::ScalingAnswer;
use crate::report::Addition;

/// Parameters of a model with errors before and after.
#[derive(Serialize)]
pub struct IdentificationAnswer {
    pub(super) robot: String,
    pub(super) model: String,
    pub(super) free: String,
    pub(super) data: String,
    pub(super) samples: usize,
    pub(super) status: &'static str,
    pub(super) trusted: bool,
    #[serde(skip)]
    pub(super) verdict: Verdict,
    pub(super) reason: String,
    pub(super) stopped_by: StoppedBy,
    pub(super) iterations: u32,
    pub(super) parameter_count: usize,
    #[serde(flatten)]
    pub(super) analysis: Analysis,
    pub(super) parameters: Vec<Estimate>,
    pub(super) noise_factor: f64,
    pub(super) loss: Loss,
    pub(super) loss_threshold: f64,
    pub(super) outliers: Vec<Outlier>,
    pub(super) starts: Starts,
    #[serde(rename = "clock_offset_s", skip_serializing_if = "Option::is_none")]
    pub(super) clock_offset: Option<f64>,
    #[serde(rename = "clock_offset_sigma_s", skip_serializing_if = "Option::is_none")]
    pub(super) clock_sigma: Option<f64>,
    #[serde(flatten)]
    pub(super) frames: Option<RecordingFrames>,
    pub(super) history: Vec<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) course: Option<CourseAnswer>,
    #[serde(flatten)]
    pub(super) objective: ObjectiveAnswer,
    /// Errors of the calibrated model on the samples of the fit, as `train`.
    pub(super) predicted: ErrorBlocks,
    pub(super) train: ErrorBlocks,
    pub(super) train_before: ErrorBlocks,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) validation_data: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) validation: Option<ErrorBlocks>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) validation_before: Option<ErrorBlocks>,
    pub(super) warnings: Warnings,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) out: Option<String>,
    #[serde(flatten)]
    pub(super) uncertainty: UncertaintyAnswer,
    #[serde(flatten)]
    pub(super) path: Option<PathAnswer>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) reduction: Option<ReductionAnswer>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) scaling: Option<ScalingAnswer>,
    #[serde(skip)]
    pub(super) pattern: MotionPattern,
}

/// An identification with the errors that judge it.
pub struct Identification<'a> {
    /// The model as given.
    pub model: &'a Model,
    /// Free parameters.
    pub free: String,
    /// Name of the data.
    pub data: String,
    /// Samples that were fitted to.
    pub samples: usize,
    /// Accuracies of their sensors.
    pub sigmas: SensorSigmas,
    /// The fit.
    pub fit: Fit,
    /// Objective with the errors that it does not look at.
    pub objective: ObjectiveAnswer,
    /// Errors on the samples of the fit, after and before.
    pub train: [ErrorBlocks; 2],
    /// Name of the data that were not fitted to.
    pub validation_data: Option<String>,
    /// Errors on these, after and before.
    pub validation: Option<[ErrorBlocks; 2]>,
    /// Warnings about the data, before those of the fit.
    pub warnings: Warnings,
    /// Name of the calibrated robot's file.
    pub out: Option<String>,
}

impl IdentificationAnswer {
    /// The answer with its warnings.
    pub fn new(found: Identification<'_>) -> Self {
        let Identification { model, free, data, samples, fit, validation_data, out, .. } = found;
        let ([train, train_before], validation) = (found.train, found.validation);
        let (validation, validation_before) = validation.map(|[after, before]| (after, before)).unzip();
        let (before, after) = (validation_before.unwrap_or(train_before), validation.unwrap_or(train));
        let distrust = distrust(model.robot(), &found.sigmas, &after);
        let composition = model.composition().to_string();
        let mut warnings = fit.warnings_with(&distrust, (&composition, [&before, &after]), &found.warnings);
        let of_objective = found.objective.doubt().map(|words| Doubt::new(DoubtKind::WorseThanGiven, words));
        warnings.doubts.splice(0..0, of_objective);
        warnings.remarks.extend(convergence_remark(&train, "training samples"));
        warnings.remarks.extend(validation.and_then(|blocks| convergence_remark(&blocks, "validation samples")));
        let verdict = Verdict::of_fit(&warnings.doubts);
        Self {
            robot: model.robot().name.clone(),
            model: composition,
            free,
            data,
            samples,
            status: verdict.fit_status(),
            trusted: verdict.is_trusted(),
            verdict,
            reason: fit.reason,
            stopped_by: fit.stopped_by,
            iterations: fit.iterations,
            parameter_count: fit.parameters.len(),
            analysis: fit.analysis,
            parameters: fit.parameters,
            noise_factor: fit.noise_factor,
            loss: fit.loss,
            loss_threshold: fit.loss_threshold,
            outliers: fit.outliers,
            starts: fit.starts,
            clock_offset: fit.clock_offset.map(|clock| clock.seconds),
            clock_sigma: fit.clock_offset.map(|clock| clock.sigma),
            frames: fit.frames,
            history: fit.history,
            course: None,
            objective: found.objective,
            predicted: train,
            train,
            train_before,
            validation_data,
            validation,
            validation_before,
            warnings,
            out,
            uncertainty: UncertaintyAnswer::default(),
            path: None,
            reduction: None,
            scaling: None,
            pattern: model.robot().motion_pattern,
        }
    }

    /// The same with profiles and bootstrap, whose warning joins the others.
    #[must_use]
    pub fn with_uncertainty(mut self, uncertainty: UncertaintyAnswer) -> Self {
        self.warnings.remarks.extend(uncertainty.bootstrap.iter().filter_map(|found| found.warning.clone()));
        Self { uncertainty, ..self }
    }

    /// The same with the path of a penalty, a smaller model, and a warning about them.
    #[must_use]
    pub fn with_path(
        mut self,
        path: Option<PathAnswer>,
        reduction: Option<ReductionAnswer>,
        warning: Option<String>,
    ) -> Self {
        self.warnings.remarks.extend(warning);
        Self { path, reduction, ..self }
    }

    /// The same with the course of the fit.
    #[must_use]
    pub fn with_course(self, course: Option<CourseAnswer>) -> Self {
        Self { course, ..self }
    }

    /// The same with the condition under scales.
    #[must_use]
    pub fn with_scaling(self, scaling: Option<ScalingAnswer>) -> Self {
        Self { scaling, ..self }
    }

    /// Warnings for the reader, doubts about the outcome first.
    pub fn warnings(&self) -> &Warnings {
        &self.warnings
    }

    /// How far it may be relied on.
    pub fn verdict(&self) -> Verdict {
        self.verdict
    }

    /// Parts of the page: errors of the optima, smaller model, path of a penalty, condition, course, profiles and bootstrap.
    pub fn additions(&self) -> Vec<Addition> {
        let blocks = [&self.train_before, &self.train];
        let objective = self.objective.addition(blocks, self.pattern).into_iter();
        let path = self.path.iter().map(PathAnswer::addition);
        let reduction = self.reduction.iter().map(ReductionAnswer::addition);
        let scaling = self.scaling.iter().map(ScalingAnswer::addition);
        let course = self.course.iter().map(CourseAnswer::addition);
        objective
            .chain(reduction)
            .chain(path)
            .chain(scaling)
            .chain(course)
            .chain(self.uncertainty.additions())
            .collect()
    }

    /// Reason of the status.
    pub fn reason(&self) -> &str {
        &self.reason
    }
}
