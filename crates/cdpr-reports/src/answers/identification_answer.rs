//! Parameters identified from measurements, with the errors that judge them.

use cdpr_calibration::candidate::plain_name;
use cdpr_calibration::fit::Estimate;
use cdpr_calibration::selection::Warnings;
use cdpr_calibration::{Doubt, DoubtKind, ErrorBlocks, Verdict, distrust};
use cdpr_model::geometry::MotionPattern;
use cdpr_model::model::Model;
use cdpr_model::robot::Robot;
use cdpr_study::Identification;
use schemars::JsonSchema;
use serde::Serialize;

use super::UncertaintyAnswer;
use super::course_answer::CourseAnswer;
use super::error_table::convergence_remark;
use super::objective_answer::ObjectiveAnswer;
use super::path_answer::PathAnswer;
use super::reduction_answer::ReductionAnswer;
use super::scaling_answer::ScalingAnswer;
use super::summary_parts::MOST_CHANGES;
use crate::keys::{ErrorBlockKeys, IdentificationKeys, WarningKeys};
use crate::report::Addition;

/// Parameters of a model with errors before and after.
#[derive(Serialize, JsonSchema)]
#[schemars(rename = "Identification")]
pub struct IdentificationAnswer {
    pub(super) robot: String,
    pub(super) model: String,
    #[serde(flatten)]
    pub(super) told: Told,
    pub(super) status: &'static str,
    /// False where nobody should work with the parameters; the warnings say why.
    pub(super) trusted: bool,
    #[serde(skip)]
    pub(super) verdict: Verdict,
    #[serde(flatten, with = "IdentificationKeys")]
    pub(super) found: Identification,
    #[serde(flatten)]
    pub(super) objective: ObjectiveAnswer,
    /// Errors of the calibrated model on the samples of the fit, as `train`.
    #[serde(with = "ErrorBlockKeys")]
    pub(super) predicted: ErrorBlocks,
    /// Steps of the fit, where they are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) course: Option<CourseAnswer>,
    #[serde(flatten)]
    pub(super) uncertainty: UncertaintyAnswer,
    #[serde(flatten)]
    pub(super) path: Option<PathAnswer>,
    /// Smaller model that the data show, where it is asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) reduction: Option<ReductionAnswer>,
    /// Condition of the Jacobian and scales of the parameters, where they are asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) scaling: Option<ScalingAnswer>,
    #[serde(skip)]
    pub(super) pattern: MotionPattern,
    /// Effects and free parameters in plain words.
    #[serde(skip)]
    pub(super) label: String,
    /// Warnings about what options asked for besides the fit.
    #[serde(skip)]
    pub(super) asked_remarks: Vec<String>,
    /// Parameters that changed most.
    #[serde(skip)]
    pub(super) largest_changes: Vec<Estimate>,
}

/// Names of an identification's data, parameters and file, and what the reader is warned of.
#[derive(Serialize, JsonSchema)]
pub struct Told {
    /// Free parameters.
    pub free: String,
    /// Name of the data.
    pub data: String,
    /// Name of the data that were not fitted to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub validation_data: Option<String>,
    /// Warnings, doubts about the outcome first; of data before the answer adds its own.
    #[serde(flatten, with = "WarningKeys")]
    #[schemars(with = "WarningKeys")]
    pub warnings: Warnings,
    /// Name of the calibrated robot's file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub out: Option<String>,
}

impl IdentificationAnswer {
    /// The answer about a model, with its warnings behind those told about the data.
    pub fn new(model: &Model, found: Identification, objective: ObjectiveAnswer, mut told: Told) -> Self {
        told.warnings.doubt(DoubtKind::Frames, found.frame_warning.clone());
        told.warnings.doubts.extend(found.findings.iter().cloned().map(Doubt::from));
        told.warnings.remarks.extend(found.set_aside_warning.clone());
        let before = found.validation_before.unwrap_or(found.train_before);
        let after = found.validation.unwrap_or(found.train);
        let distrust = distrust(model.robot(), &found.fit.model, &found.train_samples, &after);
        let composition = model.composition().to_string();
        let mut warnings = found.fit.warnings_with(&distrust, (&composition, [&before, &after]), &told.warnings);
        let of_objective = objective.doubt().map(|words| Doubt::new(DoubtKind::WorseThanGiven, words));
        warnings.doubts.splice(0..0, of_objective);
        warnings.remarks.extend(convergence_remark(&found.train, "training samples"));
        warnings.remarks.extend(found.validation.and_then(|blocks| convergence_remark(&blocks, "validation samples")));
        let verdict = Verdict::of_fit(&warnings.doubts);
        // the text is the one of the parameters themselves
        let free = told.free.parse().unwrap_or_default();
        Self {
            label: plain_name(model.composition(), &free, Some(found.fit.parameters.len())),
            largest_changes: found
                .fit
                .largest_changes(&found.train_samples, MOST_CHANGES)
                .into_iter()
                .cloned()
                .collect(),
            asked_remarks: Vec::new(),
            robot: model.robot().name.clone(),
            model: composition,
            told: Told { warnings, ..told },
            status: verdict.fit_status(),
            trusted: verdict.is_trusted(),
            verdict,
            predicted: found.train,
            found,
            objective,
            course: None,
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
        self.warn_of_asked(uncertainty.bootstrap.iter().filter_map(|found| found.warning.clone()));
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
        self.warn_of_asked(warning);
        Self { path, reduction, ..self }
    }

    /// Adds warnings about what options asked for, which the summary shows too.
    fn warn_of_asked(&mut self, warnings: impl IntoIterator<Item = String>) {
        for warning in warnings {
            self.asked_remarks.push(warning.clone());
            self.told.warnings.remarks.push(warning);
        }
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
        &self.told.warnings
    }

    /// The calibrated robot, whose file says how far it may be relied on.
    pub fn calibrated(&self) -> Robot {
        self.found.fit.model.robot().clone().with_calibration(self.status)
    }

    /// Parts of the page: errors of the optima, smaller model, path of a penalty, condition, course, profiles and bootstrap.
    pub fn additions(&self) -> Vec<Addition> {
        let blocks = [&self.found.train_before, &self.found.train];
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
        &self.found.fit.reason
    }
}
