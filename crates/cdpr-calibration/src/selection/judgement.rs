//! A candidate of a selection, judged.

use thiserror::Error;

use super::requirement::{Requirement, RequirementOutcome};
use crate::candidate::Candidate;
use crate::evaluation::{ErrorBlocks, Evaluation, EvaluationError, WorstCable};
use crate::fit::{self, Fit};
use crate::likelihood::Information;
use crate::paired::Difference;
use crate::plausibility::Distrust;
use crate::self_calibration::PredictedBand;
use cdpr_model::finding::Finding;
use cdpr_model::model::ModelError;

/// One candidate with everything known about it.
#[derive(Clone, Debug)]
pub struct JudgedCandidate {
    /// The candidate in the notation of the command line; also its name.
    pub name: String,
    /// The candidate.
    pub candidate: Candidate,
    /// Fit and errors, or the reason for which the candidate cannot be judged.
    pub outcome: Result<Judgement, CandidateFailure>,
}

/// Fit and errors of one candidate.
#[derive(Clone, Debug)]
pub struct Judgement {
    /// Parameters from all training data; from all data when the folds take turns.
    pub fit: Fit,
    /// Errors on the data that `fit` was fitted to.
    pub train: ErrorBlocks,
    /// Errors on data that the predicting fit had not seen, all folds together, without the samples set aside.
    pub validation: ErrorBlocks,
    /// The same fold by fold.
    pub folds: Vec<(String, ErrorBlocks)>,
    /// Validation errors sample by sample, in the order of `validation_samples`.
    pub validation_errors: Evaluation,
    /// Indices of those samples in the data set.
    pub validation_samples: Vec<usize>,
    /// Mean of the criterion on the validation samples that all compared candidates answer; NaN for a disqualified one.
    pub criterion: f64,
    /// Its standard error by block bootstrap.
    pub standard_error: f64,
    /// Mean of the errors by which candidates are compared, on the same samples: those of the criterion, or of the whole pose; NaN for one that is not compared.
    pub compared_mean: f64,
    /// Difference of these errors to those of the best candidate; `None` for one that is not compared.
    pub difference: Option<Difference>,
    /// Unit of these errors: m, rad or N.
    pub compared_unit: &'static str,
    /// True where they are those of the whole pose, not of the criterion.
    pub is_compared_by_pose: bool,
    /// Reason why nobody should rely on the candidate's parameters; `None` for a sound one.
    pub unsound: Option<Finding>,
    /// Number of those samples.
    pub compared_samples: usize,
    /// Places of the validation samples that no candidate explains; they are in no error figure but `validation_errors`.
    pub set_aside: Vec<usize>,
    /// The reason against comparing the candidate at all: it answers too few validation samples.
    pub disqualified: Option<String>,
    /// The limits and how the candidate stands to them.
    pub requirements: Vec<RequirementOutcome>,
    /// Reasons not to trust the candidate with these errors, recommended or not.
    pub distrust: Distrust,
    /// Mean position error on validation data as a share of the diagonal of these positions (eq. 3.5, 3.7); `None` for one position.
    pub relative_position_error: Option<f64>,
    /// Bands of predicted poses, where no pose is measured.
    pub pose_band: Option<PredictedBand>,
    /// Likelihood and information criteria of the reported fit.
    pub information: Option<Information>,
    /// Criterion on regions of the workspace that the fit had not seen, where regions were left out besides.
    pub regions: Option<HeldOut>,
    /// Errors on these regions, sample by sample.
    pub(super) region_errors: Option<Evaluation>,
    /// Names of the folds with their numbers of validation samples.
    pub(super) fold_sizes: Vec<(String, usize)>,
}

impl Judgement {
    /// Cable whose lengths the candidate gets worst on validation data, without the samples set aside; `None` where none were held out.
    pub fn worst_cable(&self) -> Option<WorstCable> {
        let kept: Vec<usize> =
            (0..self.validation_errors.len()).filter(|place| !self.set_aside.contains(place)).collect();
        self.validation_errors.subset(&kept).worst_cable()
    }

    /// Errors of a fit, on its own data and sample by sample on those that were held out; what is compared with others follows.
    pub(super) fn new(
        fit: Fit,
        train: ErrorBlocks,
        validation_errors: Evaluation,
        validation_samples: Vec<usize>,
        fold_sizes: Vec<(String, usize)>,
    ) -> Self {
        Self {
            fit,
            train,
            validation: validation_errors.blocks(),
            folds: Vec::new(),
            validation_errors,
            validation_samples,
            criterion: f64::NAN,
            standard_error: f64::NAN,
            compared_mean: f64::NAN,
            difference: None,
            compared_unit: "m",
            is_compared_by_pose: false,
            unsound: None,
            compared_samples: 0,
            set_aside: Vec::new(),
            disqualified: None,
            requirements: Vec::new(),
            distrust: Distrust::default(),
            relative_position_error: None,
            pose_band: None,
            information: None,
            regions: None,
            region_errors: None,
            fold_sizes,
        }
    }

    /// Takes the error figures without the samples set aside, and holds them against the requirements.
    pub(super) fn take_figures(&mut self, requirements: &[Requirement]) {
        let kept = |range: std::ops::Range<usize>| -> Vec<usize> {
            range.filter(|place| self.set_aside.binary_search(place).is_err()).collect()
        };
        let mut first = 0;
        let mut of_fold = |(name, size): &(String, usize)| {
            let blocks = self.validation_errors.subset(&kept(first..first + size)).blocks();
            first += size;
            (name.clone(), blocks)
        };
        let folds = self.fold_sizes.iter().map(&mut of_fold).collect();
        if !self.set_aside.is_empty() {
            self.validation = self.validation_errors.subset(&kept(0..self.validation_errors.len())).blocks();
        }
        self.folds = folds;
        self.requirements = requirements.iter().map(|requirement| requirement.judge(&self.validation)).collect();
    }

    /// False where the search of the fit ended before its optimum: such a candidate is never recommended.
    pub(super) fn has_converged(&self) -> bool {
        self.fit.status != fit::Status::NotConverged
    }

    pub(super) fn meets_requirements(&self) -> bool {
        self.requirements.iter().all(|requirement| requirement.met)
    }

    /// Error by which the candidate is compared with the best; `None` for one that is not compared.
    pub fn compared_error(&self) -> Option<ComparedError> {
        let (mean, difference) = (self.compared_mean, self.difference?);
        let best_mean = mean - difference.mean;
        Some(ComparedError {
            unit: self.compared_unit,
            is_of_pose: self.is_compared_by_pose,
            mean,
            difference,
            as_good_within: difference.largest_none(best_mean),
            is_as_good: difference.is_none(best_mean),
        })
    }
}

/// Error by which a candidate is compared with the best one on the same samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ComparedError {
    /// Unit of its numbers: m, rad or N.
    pub unit: &'static str,
    /// True where it is the error of the whole pose (m), false where it is that of the criterion.
    pub is_of_pose: bool,
    /// Mean over the samples.
    pub mean: f64,
    /// Difference to the best.
    pub difference: Difference,
    /// Largest difference that is none: its standard error, or a hundredth of the best's mean where that is larger.
    pub as_good_within: f64,
    /// True where the candidate is as good as the best.
    pub is_as_good: bool,
}

/// Criterion on data held out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeldOut {
    /// Mean over the samples that all compared candidates answer (SI).
    pub criterion: f64,
    /// Its standard error by block bootstrap.
    pub standard_error: f64,
    /// Number of these samples.
    pub samples: usize,
}

/// Reason for which a candidate cannot be judged.
#[derive(Clone, Debug, PartialEq, Error)]
#[error(transparent)]
pub enum CandidateFailure {
    /// A robot that lacks what the composition asks for.
    Model(#[from] ModelError),
    /// Data that do not fit the free parameters.
    Fit(#[from] fit::InputError),
    /// A fitted model that cannot be compared with the data.
    Evaluation(#[from] EvaluationError),
}
