//! Residuals of samples as functions of the free parameters: a file or a room for each objective, and their table.

pub(crate) mod balance;
mod both;
pub(crate) mod entries;
pub(crate) mod length_errors;
pub(crate) mod lengths;
mod metric;
mod pose_in_task;
pub(crate) mod poseless;
mod poses;
pub(crate) mod rows;
pub(crate) mod sensors;
#[cfg(test)]
pub(crate) mod tests;

use std::ops::Range;

use crate::fit::answer::Estimate;
use crate::fit::{InputError, Settings};
use crate::identifiability::Analysis;
use crate::loss::RobustLoss;
use crate::minimize::dense::DenseEquations;
use crate::minimize::descent::End;
use crate::minimize::unknowns::{Pace, Unknowns};
use crate::norms::Norms;
use cdpr_model::geometry::Pose;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::solve::ROUNDING_GAIN;
pub(crate) use metric::default_length;
use rows::{GroupRows, Layout, Missing, RowBlock, Rows};

/// Model, samples and settings that residuals are made of.
#[derive(Clone, Copy)]
pub(crate) struct Given<'a, 'm> {
    /// The model before the fit, with the load that its parameters need.
    pub(crate) model: &'m Model,
    pub(crate) samples: &'a Samples,
    /// The free parameters, ordered by cable.
    pub(crate) parameters: &'a [Parameter],
    pub(crate) settings: &'a Settings,
}

/// Which samples are named as outliers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outliers {
    /// Those beyond the limit at the optimum.
    Own,
    /// Those beyond it at the optimum of least squares, too: errors of predicted poses are large where the model lacks something or cables hold the
    /// platform weakly, and a robust loss drives such errors into few samples, of which no row is wrong.
    Witnessed,
    /// Those beyond the limit, which count as the others do: rows have weights of their own.
    Counted,
}

/// Pose and tensions of the platform in one sample, where they are eliminated from its rows.
#[derive(Clone, Debug)]
pub(crate) struct Latent {
    pub(crate) pose: Pose,
    /// As they would be recorded (N); empty if tensions are no unknowns.
    pub(crate) tensions: Vec<f64>,
}

/// Remarks of rows about the optimum that they led to.
#[derive(Clone, Debug, Default)]
pub(crate) struct Remarks {
    /// Warnings about their noise.
    pub(crate) of_noise: Vec<String>,
    /// Warnings about priors that they contradict.
    pub(crate) of_priors: Vec<String>,
    /// Reason for which the calibrated model predicts nothing.
    pub(crate) objection: Option<String>,
}

/// Residuals of samples, in standard deviations, as functions of the free parameters.
///
/// [`Residual::write`] is enough. The other methods are for rows that know a shorter way, leave parameters independent of each other, eliminate
/// unknowns of a sample, or have weights that depend on the parameters ([`Weighing`]).
pub(crate) trait Residual {
    /// The model before the fit, with the load that its parameters need.
    fn model(&self) -> &Model;

    /// Number of rows, and of what is eliminated from them.
    fn layout(&self) -> Layout;

    /// Writes residuals and derivatives at parameter values; false where a sample has none.
    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool;

    /// True where the accuracies are stated that weigh the rows, so that smaller residuals are luck.
    fn is_absolute(&self) -> bool;

    /// Metres of cable that one unit of each parameter is worth; `None` if the means over all cables are as good.
    fn scales(&self) -> Option<Vec<f64>> {
        None
    }

    /// Tensions that the rows are about, recorded or told by statics (N); `None` for rows of lengths or poses alone.
    fn tensions(&self) -> Option<&[f64]> {
        None
    }

    /// Metres that are one unit of the rows; `None` where these are standard deviations of several quantities.
    fn unit(&self) -> Option<f64> {
        None
    }

    /// Sample without a prediction (from 0) where rows were written last, with the reason.
    fn unpredicted(&self) -> Option<(usize, String)> {
        None
    }

    /// Leaves out the samples without a prediction at these values and returns them; their rows are zero from then on.
    fn leave_out_missing(&mut self, _values: &[f64]) -> Vec<Missing> {
        Vec::new()
    }

    /// Rows that say something.
    fn informative_rows(&self) -> usize {
        self.layout().free_rows()
    }

    /// Outliers among the samples; `None` if none is looked for.
    fn outliers(&self) -> Option<Outliers> {
        None
    }

    /// Places of the parameters that no row ties to those of other blocks.
    fn blocks(&self, parameters: usize) -> Vec<Range<usize>> {
        std::iter::once(0..parameters).collect()
    }

    /// Writes Σ rᵀr, Jᵀr and JᵀJ of a block in a shorter way than by the rows; false where there is none.
    fn normal(&mut self, _block: usize, _values: &[f64], _equations: &mut DenseEquations) -> bool {
        false
    }

    /// Descends in a block by normal equations of its own kind; `None` where those of the rows are as good.
    fn descend(&mut self, _block: usize, _from: &[f64], _own: &Unknowns<'_>, _pace: &Pace) -> Option<End> {
        None
    }

    /// ‖r‖² of every sample at these values, or, unless they must be exact, within a micrometre of them; `None` if they follow from the rows alone.
    fn squares(&mut self, _values: &[f64], _unknowns: &Unknowns<'_>, _is_exact: bool) -> Option<Vec<f64>> {
        None
    }

    /// Share of the cost that the next step may still promise where the first descents end, of so many.
    fn least_gain(&self, _starts: u32) -> f64 {
        ROUNDING_GAIN
    }

    /// Weights that depend on the parameters; `None` where they are fixed.
    fn weighing(&mut self) -> Option<&mut dyn Weighing> {
        None
    }

    /// A descent begins: it shall not depend on those before.
    fn restart(&mut self) {}

    /// Steps after which a descent from another start than the file's values is given up; `None` if it has as many as any.
    fn patience(&self) -> Option<u32> {
        None
    }

    /// A descent has ended at these values: seeks what is eliminated from the rows from other places, too; true where a sample's rows are shorter
    /// there, which is taken.
    fn seek_again(&mut self, _values: &[f64]) -> bool {
        false
    }

    /// Pose and tensions that are eliminated from each sample's rows, as found last; empty if no unknown is.
    fn latents(&self) -> Vec<Latent> {
        Vec::new()
    }

    /// Goes on from what another descent has found.
    fn go_on_from(&mut self, _latents: &[Latent]) {}

    /// Rows at an optimum for every block of parameters, as its analysis takes them; `None` if those of [`Residual::write`] are what it takes.
    fn groups(&mut self, _model: &Model, _values: &[f64]) -> Option<Result<Vec<GroupRows>, InputError>> {
        None
    }

    /// 1/σ of every row over the samples, each given those of its sample before it, 0 where it says nothing; `None` if the rows have no likelihood.
    fn row_weights(&self) -> Option<Vec<Vec<f64>>> {
        None
    }

    /// Rows at an optimum by the motion of the platform besides the parameters; `None` if frames cannot be found with them.
    fn pose_rows(
        &mut self,
        _model: &Model,
        _values: &[f64],
        _norms: &Norms,
    ) -> Option<Result<Vec<RowBlock>, InputError>> {
        None
    }

    /// True where wrenches are rows besides lengths.
    fn has_wrenches(&self) -> bool {
        false
    }

    /// Remarks about an optimum, with what its analysis lacks.
    fn remarks(&self, _model: &Model, _estimates: &[Estimate], _noise: f64, _analysis: &mut Analysis) -> Remarks {
        Remarks::default()
    }
}

/// Residuals of samples at poses that nobody measured, which are eliminated.
pub(crate) trait Poseless: Residual {
    /// Poses found last, one of each sample.
    fn poses(&self) -> Vec<Pose>;

    /// Begins searches at poses that were found before, one of each sample.
    fn begin_at(&mut self, poses: &[Pose]);

    /// Samples at whose pose and tensions the sensors agree well, but not best: their searches ended on the way.
    fn unsettled(&self) -> usize {
        0
    }

    /// Share of each row's residual that its own pose and tensions take up, where was written last; empty where only lengths are rows.
    fn leverages(&self) -> Vec<f64> {
        Vec::new()
    }
}

/// Weights that depend on the parameters, with the points at which rows are linear.
pub(crate) trait Weighing {
    /// Noise that the weights stand for, as a multiple of what is stated or assumed.
    fn noise(&self) -> f64;

    /// Relative change of the noise that is none; `None` if the noise of these rows is not asked.
    fn same_noise(&self) -> Option<f64>;

    /// Takes the noise for so many times as large.
    fn scale_noise(&mut self, factor: f64);

    /// Agrees weights and points with the optimum that they lead to.
    fn settle(&mut self, end: &mut End, unknowns: &Unknowns<'_>) -> Result<(), InputError>;

    /// The same after another noise.
    fn settle_again(&mut self, end: &mut End, unknowns: &Unknowns<'_>) -> Result<(), InputError>;

    /// Descends under a loss of fixed scale; false where the weights have changed with its end.
    fn follow(&mut self, loss: RobustLoss, end: &mut End, unknowns: &Unknowns<'_>) -> Result<bool, InputError>;

    /// Keeps weights and points, to come back to them.
    fn keep(&mut self);

    /// Comes back to the weights and points that were kept.
    fn come_back(&mut self);

    /// Ends the search under a loss: samples weigh by their accuracies alone again.
    fn finish(&mut self) {}
}
