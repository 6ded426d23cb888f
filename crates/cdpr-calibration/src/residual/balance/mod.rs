//! Elastostatic identification in inverse form (eq. 4.38): each sample gives n wrench rows Aᵀ(x_M) f_M + w and m length
//! rows, the recorded length that the model expects at the measured pose and tension minus the recorded one.
//!
//! Pose and tension enter several rows of a sample, so their noise is shared: the rows are weighed with their full
//! covariance, to first order Σ = N diag(σ²) Nᵀ with N the rows' derivatives by everything that is measured.

mod adjust;
mod descent;
mod groups;
mod linear_rows;
mod linearization;
mod measurement_noise;
pub(crate) mod noise;
mod normal;
mod pose_rows;
mod remarks;
pub(crate) mod rows;
pub(crate) mod start;
#[cfg(test)]
mod tests;

use super::Given;
use super::rows::GroupRows;
use super::rows::RowBlock;
use super::rows::{Layout, Rows};
use super::{Outliers, Remarks, Residual, Weighing};
use crate::fit::answer::Estimate;
use crate::fit::{InputError, RowWeights};
use crate::identifiability::Analysis;
use crate::loss::RobustLoss;
use crate::minimize::dense::DenseEquations;
use crate::minimize::descent::End;
use crate::minimize::unknowns::{Pace, Unknowns};
use crate::norms::Norms;
use cdpr_model::measurement::Samples;
use cdpr_model::model::Model;
use cdpr_model::robot::Parameter;
use cdpr_model::solve::ROUNDING_GAIN;
use cdpr_model::statics::Load;
use linearization::Linearization;
use measurement_noise::sigmas;
use noise::Sigmas;
use rows::{RowModel, SampleRows};
use start::{checked_tensions, follow_from_statics};

/// Reduction promised by the next step, as a fraction of the cost, at which a descent ends if there are several starts to compare.
const SEARCH_PROMISE: f64 = 1e-9;
/// The same when a descent stops near the optimum, near enough to go on with corrections.
const NEAR_PROMISE: f64 = 1e-1;

/// Weights of the rows.
#[derive(Clone, Copy, Debug, PartialEq)]
enum WeighedBy {
    /// The accuracies of all that is measured, at corrected poses and tensions that agree with the optimum.
    Optimum,
    /// The accuracies at what was measured and the start values.
    Measured,
    /// A weight for lengths and one for wrenches.
    Rows(RowWeights),
}

/// Wrenches and lengths of an elastic model.
pub(crate) struct BalanceResidual<'a> {
    /// The model before the fit.
    model: Model,
    samples: &'a Samples,
    parameters: &'a [Parameter],
    /// As recorded, sample by sample (N).
    tensions: Vec<f64>,
    sigmas: Sigmas,
    is_stated: bool,
    /// True where statics tells the tensions, of which each takes up a row.
    are_told: bool,
    weighed_by: WeighedBy,
    at: Linearization,
    /// Noise that the weights stand for, as a multiple of `sigmas`.
    noise: f64,
    /// Loss of the samples' norms; `None` for squares.
    loss: Option<RobustLoss>,
    /// Points and noise to come back to.
    kept: Option<(Linearization, f64)>,
}

impl<'a> BalanceResidual<'a> {
    /// With weights that agree with the optimum, or with those of the settings.
    pub(crate) fn new(given: &Given<'a, '_>) -> Result<Self, InputError> {
        match given.settings.row_weights {
            None => Self::weighed(given, WeighedBy::Optimum),
            Some(weights) => Self::by_rows(given, weights),
        }
    }

    /// With the accuracies at what was measured and the start values.
    pub(crate) fn measured(given: &Given<'a, '_>) -> Result<Self, InputError> {
        Self::weighed(given, WeighedBy::Measured)
    }

    /// With a weight for lengths and one for wrenches; measured poses and tensions count as exact.
    pub(crate) fn by_rows(given: &Given<'a, '_>, weights: RowWeights) -> Result<Self, InputError> {
        Self::weighed(given, WeighedBy::Rows(weights))
    }

    fn weighed(given: &Given<'a, '_>, weighed_by: WeighedBy) -> Result<Self, InputError> {
        let Given { model, samples, parameters, .. } = *given;
        let tensions = match weighed_by {
            WeighedBy::Rows(_) => samples.tensions.clone().ok_or(InputError::NoTensions)?,
            _ => checked_tensions(model, samples)?,
        };
        let rows = RowModel::new(model, Load::of(model.robot())?, parameters);
        let mean = tensions.iter().sum::<f64>() / tensions.len() as f64;
        let (sigmas, is_stated) = sigmas(samples, mean);
        let are_told = follow_from_statics(model, samples);
        let sigmas = if are_told { sigmas.told_by_statics(mean) } else { sigmas };
        let at = match weighed_by {
            WeighedBy::Rows(weights) => {
                let of_row = |row: usize| if row < model.dof() { weights.wrench } else { weights.length };
                let of_rows: Vec<f64> = (0..model.dof() + model.cable_count()).map(of_row).collect();
                Linearization::weighted(model, samples, &tensions, &of_rows)
            }
            _ => Linearization::measured(&rows, samples, &tensions, &sigmas).ok_or(InputError::NotFinite)?,
        };
        Ok(Self {
            model: model.clone(),
            samples,
            parameters,
            tensions,
            sigmas,
            is_stated,
            are_told,
            weighed_by,
            at,
            noise: 1.0,
            loss: None,
            kept: None,
        })
    }

    fn has_row_weights(&self) -> bool {
        matches!(self.weighed_by, WeighedBy::Rows(_))
    }

    /// Mean recorded tension (N).
    fn mean_tension(&self) -> f64 {
        self.tensions.iter().sum::<f64>() / self.tensions.len() as f64
    }

    /// Rows of one sample.
    fn size(&self) -> usize {
        self.model.dof() + self.model.cable_count()
    }
}

impl Residual for BalanceResidual<'_> {
    fn model(&self) -> &Model {
        &self.model
    }

    fn layout(&self) -> Layout {
        Layout::of(self.samples.len(), self.size())
    }

    fn write(&mut self, values: &[f64], rows: &mut Rows) -> bool {
        let Some(model) = self.model.with_parameters(self.parameters, values) else { return false };
        let Ok(load) = Load::of(model.robot()) else { return false };
        let row_model = RowModel::new(&model, load, self.parameters);
        let mut own = SampleRows::new(&model, self.parameters.len());
        for sample in 0..self.samples.len() {
            self.at.write_whitened(&row_model, self.samples, sample, &mut own);
            for (row, derivatives) in own.derivatives().enumerate() {
                let place = sample * own.count + row;
                rows.residuals[place] = own.residual(row);
                derivatives.iter().enumerate().for_each(|(k, entry)| rows.jacobian[(place, k)] = *entry);
            }
        }
        rows.is_finite()
    }

    fn is_absolute(&self) -> bool {
        match self.weighed_by {
            WeighedBy::Optimum => self.is_stated,
            WeighedBy::Measured => self.samples.sigmas.position.is_some_and(|sigma| sigma > 0.0),
            WeighedBy::Rows(_) => false,
        }
    }

    fn informative_rows(&self) -> usize {
        match self.weighed_by {
            WeighedBy::Measured => self.layout().free_rows(),
            _ if self.are_told => self.at.informative_rows().saturating_sub(self.tensions.len()),
            _ => self.at.informative_rows(),
        }
    }

    fn tensions(&self) -> Option<&[f64]> {
        Some(&self.tensions)
    }

    fn outliers(&self) -> Option<Outliers> {
        Some(if self.has_row_weights() { Outliers::Counted } else { Outliers::Own })
    }

    fn normal(&mut self, _: usize, values: &[f64], equations: &mut DenseEquations) -> bool {
        self.weighed_by != WeighedBy::Measured && self.write_dense(values, equations)
    }

    fn descend(&mut self, _: usize, from: &[f64], own: &Unknowns<'_>, pace: &Pace) -> Option<End> {
        (self.weighed_by != WeighedBy::Measured).then(|| self.descend_from(from, own, pace.least_gain))
    }

    fn squares(&mut self, values: &[f64], _: &Unknowns<'_>, _: bool) -> Option<Vec<f64>> {
        if self.weighed_by == WeighedBy::Measured {
            return None;
        }
        let here = self.model.with_parameters(self.parameters, values)?;
        let load = Load::of(here.robot()).ok()?;
        Some(self.at.squares(&RowModel::new(&here, load, &[]), self.samples))
    }

    fn least_gain(&self, starts: u32) -> f64 {
        match self.weighed_by {
            WeighedBy::Measured => ROUNDING_GAIN,
            // one start only has to come near; several must be told apart
            _ if starts > 1 => SEARCH_PROMISE,
            _ => NEAR_PROMISE,
        }
    }

    fn weighing(&mut self) -> Option<&mut dyn Weighing> {
        if self.weighed_by == WeighedBy::Measured { None } else { Some(self) }
    }

    fn groups(&mut self, model: &Model, _: &[f64]) -> Option<Result<Vec<GroupRows>, InputError>> {
        (self.weighed_by != WeighedBy::Measured).then(|| self.group_rows(model))
    }

    fn row_weights(&self) -> Option<Vec<Vec<f64>>> {
        (self.weighed_by != WeighedBy::Measured).then(|| self.all_row_weights())
    }

    fn pose_rows(&mut self, model: &Model, _: &[f64], norms: &Norms) -> Option<Result<Vec<RowBlock>, InputError>> {
        (self.weighed_by != WeighedBy::Measured).then(|| Ok(vec![self.all_pose_rows(model, norms)?]))
    }

    fn has_wrenches(&self) -> bool {
        true
    }

    fn remarks(&self, model: &Model, estimates: &[Estimate], noise: f64, analysis: &mut Analysis) -> Remarks {
        match self.weighed_by {
            WeighedBy::Measured => Remarks::default(),
            _ => self.all_remarks(model, estimates, noise, analysis),
        }
    }
}
