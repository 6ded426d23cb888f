//! Answer of a fit.

use super::frames::RecordingFrames;
use super::shifts::ShiftEstimate;
use crate::clock::ClockOffset;
use crate::identifiability::{Analysis, Correlation};
use crate::likelihood::FittedRows;
use crate::loss::Loss;
use crate::minimize::certificate::Certificate;
use crate::minimize::starts::Starts;
use crate::minimize::trail::Trail;
use crate::outliers::{self, Outlier};
use crate::stopping::StoppedBy;
use cdpr_model::model::Model;
use cdpr_model::reading::keywords;
use cdpr_model::robot::Parameter;

/// Why the fit ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Status {
    /// The optimum is found and every parameter is determined.
    Converged,
    /// The data leave directions in parameter space open; the parameters are one of many optima.
    NotIdentifiable,
    /// The iteration limit was reached.
    NotConverged,
    /// The optimum is a model without a forward problem: more cables than degrees of freedom ended rigid.
    NotPredictive,
}

keywords!(
    Status: Converged = "converged",
    NotIdentifiable = "not-identifiable",
    NotConverged = "not-converged",
    NotPredictive = "not-predictive",
);

/// One identified parameter.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// Name, e.g. `frame-anchor[1].x`.
    pub name: String,
    /// Unit; empty for a ratio.
    pub unit: &'static str,
    /// Value of the robot as given; `None` where its file states none, so that the start is a neutral value or a guess.
    pub nominal: Option<f64>,
    /// Value before the fit.
    pub start: f64,
    /// Optimal value.
    pub value: f64,
    /// Standard deviation; `None` when the data do not determine it.
    pub sigma: Option<f64>,
    /// Value minus start.
    pub change: f64,
    /// Standard deviation of the prior, if there is one.
    pub prior_sigma: Option<f64>,
    /// True when the value lies on a bound, to rounding and the tolerance of the fit.
    pub at_bound: bool,
    /// Which parameter it is.
    pub parameter: Parameter,
}

/// Outcome of a fit; `model` carries the best parameters found whatever the status.
#[must_use = "check `status` before using the parameters"]
#[derive(Clone, Debug)]
pub struct Fit {
    /// The calibrated model.
    pub model: Model,
    /// Why the fit ended.
    pub status: Status,
    /// The status in words, with numbers.
    pub reason: String,
    /// The rule that ended the search; of cables that were identified apart that of the one whose end says least of an optimum.
    pub stopped_by: StoppedBy,
    /// Steps of the cable that needed most.
    pub iterations: u32,
    /// Weighted sum of squared residuals (of their loss) and priors after each step, all cables together.
    pub history: Vec<f64>,
    /// The free parameters, ordered by cable.
    pub parameters: Vec<Estimate>,
    /// Rank, singular values, weak directions, correlations.
    pub analysis: Analysis,
    /// Noise that residuals and priors tell, in units of the stated accuracies, or of the assumed ones where none is stated
    /// (1 mm for lengths, 1 % of the mean for tensions): √((data + prior cost)/(rows + priors − parameters)) at that noise; the robust
    /// deviation of the residuals where the loss is no square.
    /// Near 1 when model and sensors agree with the data; standard deviations of parameters grow with it when it exceeds 1 or
    /// no accuracy is stated. NaN where there are as many parameters as rows and priors.
    pub noise_factor: f64,
    /// The loss of the optimum, as chosen or found.
    pub loss: Loss,
    /// Norm of a sample's residuals, in units of the stated or assumed accuracies, from which on it counts less: C of the loss;
    /// infinite for least squares.
    pub loss_threshold: f64,
    /// Samples beyond 8 robust standard deviations.
    pub outliers: Vec<Outlier>,
    /// Optima that the starts led to. Cables of a kinematic model are identified apart, each from its own best start: the best optimum may then be one that
    /// no start led all cables to.
    pub starts: Starts,
    /// Offset of the clocks, where it was free.
    pub clock_offset: Option<ClockOffset>,
    /// Frames of tracker and marker, where they were free.
    pub frames: Option<RecordingFrames>,
    /// Changes of recorded lengths inside the record, where they were free.
    pub shifts: Vec<ShiftEstimate>,
    /// Proof of the least largest error, where that was asked for.
    pub certificate: Option<Certificate>,
    /// Number of samples that were fitted.
    pub samples: usize,
    /// Warning about the outliers, which stands before every other.
    pub outlier_warning: Option<String>,
    /// Further warnings in words: doubts about noise, bounds and rank.
    pub warnings: Vec<String>,
    /// Way to the optimum.
    pub(crate) trail: Trail,
    /// Rows that were made small by their likelihood; none under another objective.
    pub(crate) rows: Option<FittedRows>,
}

impl Fit {
    /// Indices of those of so many samples of the fit that are no outliers, where its loss lets these count less; all for least squares.
    pub fn trusted_samples(&self, count: usize) -> Vec<usize> {
        let is_named = |index: &usize| self.outliers.iter().any(|outlier| outlier.sample == index + 1);
        (0..count).filter(|index| self.loss == Loss::Squared || !is_named(index)).collect()
    }

    /// Numbers the outliers by the data that the samples of the fit were taken from, at these indices.
    pub fn renumber_outliers(&mut self, indices: &[usize]) {
        self.outliers.iter_mut().for_each(|outlier| outlier.sample = indices[outlier.sample - 1] + 1);
        self.outlier_warning = outliers::warning(&self.outliers, self.samples, self.loss);
    }

    /// Keeps those outliers that another fit to the same samples has as well: what this model alone does not explain is its misfit.
    pub(crate) fn keep_outliers(&mut self, other: &Self) {
        let is_other = |sample: usize| other.outliers.iter().any(|outlier| outlier.sample == sample);
        self.outliers.retain(|outlier| is_other(outlier.sample));
        self.outlier_warning = outliers::warning(&self.outliers, self.samples, self.loss);
    }

    /// States the values of the robot as given: the starts are those of one that may have been completed, with a wrench for instance.
    pub(crate) fn tell_nominal_values(&mut self, model: &Model) {
        self.parameters.iter_mut().for_each(|estimate| estimate.nominal = estimate.parameter.get(model.robot()));
    }

    /// Takes the optimum back: so many samples have no pose at which their measurements agree best, so that the cost says nothing of the least one.
    pub(crate) fn tell_unsettled(&mut self, samples: usize) {
        self.status = Status::NotConverged;
        self.reason = format!(
            "the search for the poses of {samples} of {} samples ended before their measurements agreed best: the geometry is far off, or lengths do not count \
             from where the file says (free length-offset, give start lengths); {}",
            self.samples, self.reason
        );
    }

    /// Correlations above the limit, for reports.
    pub fn correlations(&self) -> &[Correlation] {
        &self.analysis.correlations
    }
}
