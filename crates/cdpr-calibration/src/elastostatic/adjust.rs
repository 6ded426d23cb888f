//! Weights and points of linearisation that agree with the optimum they lead to.

use super::descent::{End, Problem};
use super::linearization::Linearization;
use super::noise::Sigmas;
use super::rows::RowModel;
use crate::fit::InputError;
use crate::norms::{Extent, Norms};
use crate::stopping::{StoppedBy, StoppingRule};
use cdpr_model::model::Model;
use cdpr_model::statics::Load;

/// Most descents with corrections between them.
const ADJUSTMENTS: u32 = 12;
/// Most steps with corrections at each; each gains some digits.
const POLISHING_STEPS: u32 = 15;
/// Most repetitions with the noise that the residuals tell; near the end each doubles the digits.
const RESCALINGS: u32 = 30;
/// The noise is found when it changes by less than this share.
const SAME_NOISE: f64 = 1e-7;
/// Share of the cost that the next step may still promise when a descent stops: near the optimum, near enough to go on with corrections.
pub(super) const NEAR_PROMISE: f64 = 1e-1;
/// The same at the end, far below any standard deviation.
const FINAL_REDUCTION: f64 = 1e-7;

/// Weights and points of linearisation that agree with the optimum they lead to.
pub(super) struct Adjust<'a> {
    pub(super) problem: &'a Problem<'a>,
    pub(super) sigmas: Sigmas,
    /// Noise that the weights stand for, as a multiple of `sigmas`.
    pub(super) noise: f64,
}

impl Adjust<'_> {
    pub(super) fn measured(&self, model: &Model) -> Result<Linearization, InputError> {
        let Problem { parameters, samples, tensions, .. } = *self.problem;
        let rows = RowModel::new(model, Load::of(model.robot())?, parameters);
        Linearization::measured(&rows, samples, tensions, &self.sigmas).ok_or(InputError::NotFinite)
    }

    /// Norms of the samples' residuals where a descent ended.
    pub(super) fn norms(&self, end: &End, at: &Linearization, absolute: bool) -> Result<Norms, InputError> {
        let Problem { parameters, samples, loss, .. } = *self.problem;
        let here = self.problem.model_at(&end.values).ok_or(InputError::NotFinite)?;
        let squares = at.squares(&RowModel::new(&here, Load::of(here.robot())?, &[]), samples);
        let extent = Extent { rows: at.informative_rows(), parameters: parameters.len(), absolute };
        Ok(Norms::new(squares, loss, extent))
    }

    /// Corrects the linearisation for the parameters where a descent ended.
    fn correct(&self, end: &End, linearization: &mut Linearization) -> Result<(), InputError> {
        let Problem { parameters, samples, tensions, .. } = *self.problem;
        let here = self.problem.model_at(&end.values).ok_or(InputError::NotFinite)?;
        let rows = RowModel::new(&here, Load::of(here.robot())?, parameters);
        linearization.correct(&rows, samples, tensions, &self.sigmas).ok_or(InputError::NotFinite)?;
        linearization.scale_weights(self.noise);
        Ok(())
    }

    /// The optimum with corrections that agree with it.
    pub(super) fn settle(&self, end: &mut End, linearization: &mut Linearization) -> Result<(), InputError> {
        match self.polish(end, linearization)? {
            true => Ok(()),
            false => self.repeat(end, linearization),
        }
    }

    /// A prior needs the scale of the noise, which the residuals tell: weighs by it and repeats.
    pub(super) fn agree_with_noise(
        &mut self,
        end: &mut End,
        linearization: &mut Linearization,
    ) -> Result<(), InputError> {
        for _ in 0..RESCALINGS {
            let noise = self.problem.misfit(end, linearization).noise();
            if (noise - 1.0).abs() < SAME_NOISE {
                break;
            }
            self.noise *= noise;
            // costs in other units
            end.trail.costs.clear();
            self.settle(end, linearization)?;
        }
        Ok(())
    }

    /// Gauss–Newton steps with corrections at each; false when they do not contract, or need damping.
    fn polish(&self, end: &mut End, linearization: &mut Linearization) -> Result<bool, InputError> {
        let mut last_predicted_reduction = f64::INFINITY;
        for _ in 0..POLISHING_STEPS {
            self.correct(end, linearization)?;
            let Some(step) = self.problem.plain_step(&end.values, linearization) else { return Ok(false) };
            end.iterations += 1;
            end.trail.push(step.cost, || end.values.clone());
            (end.values, end.cost) = (step.values, step.cost);
            if step.predicted_reduction <= FINAL_REDUCTION * step.cost {
                let value = step.predicted_reduction / step.cost;
                end.stopped = StoppedBy { rule: StoppingRule::Cost, value, limit: FINAL_REDUCTION };
                return Ok(true);
            }
            if !(step.predicted_reduction < 0.25 * last_predicted_reduction) {
                return Ok(false);
            }
            last_predicted_reduction = step.predicted_reduction;
        }
        Ok(false)
    }

    /// Whole descents with corrections between them.
    fn repeat(&self, end: &mut End, linearization: &mut Linearization) -> Result<(), InputError> {
        for round in 0..ADJUSTMENTS {
            let before = linearization.clone();
            self.correct(end, linearization)?;
            let more = self.problem.descend(&end.values, linearization, FINAL_REDUCTION);
            let gained = (more.cost - end.cost).abs();
            let trail = std::mem::take(&mut end.trail).then(more.trail);
            *end = End { iterations: end.iterations + more.iterations, trail, ..more };
            if round > 0 && before.distance_to(linearization) < 1e-6 && gained <= 1e-9 * end.cost {
                break;
            }
        }
        Ok(())
    }
}
