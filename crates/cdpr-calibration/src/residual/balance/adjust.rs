//! Weights and points of linearisation that agree with the optimum they lead to.

use super::rows::RowModel;
use super::{BalanceResidual, NEAR_PROMISE};
use crate::fit::InputError;
use crate::loss::RobustLoss;
use crate::minimize::descent::End;
use crate::minimize::unknowns::Unknowns;
use crate::residual::Weighing;
use crate::stopping::{StoppedBy, StoppingRule};
use cdpr_model::statics::Load;

/// Most descents with corrections between them.
const ADJUSTMENTS: u32 = 12;
/// Most steps with corrections at each; each gains some digits.
const POLISHING_STEPS: u32 = 15;
/// The noise is found when it changes by less than this share.
const SAME_NOISE: f64 = 1e-7;
/// Share of the cost that the next step may still promise at the end, far below any standard deviation.
const FINAL_REDUCTION: f64 = 1e-7;
/// The same with weights of the rows, where nothing is corrected.
const FINAL_PROMISE: f64 = 1e-14;

impl Weighing for BalanceResidual<'_> {
    fn noise(&self) -> f64 {
        self.noise
    }

    fn same_noise(&self) -> Option<f64> {
        (!self.has_row_weights()).then_some(SAME_NOISE)
    }

    fn scale_noise(&mut self, factor: f64) {
        self.noise *= factor;
        self.at.scale_weights(factor);
    }

    fn settle(&mut self, end: &mut End, unknowns: &Unknowns<'_>) -> Result<(), InputError> {
        if self.has_row_weights() {
            let more = self.descend_from(&end.values, unknowns, FINAL_PROMISE);
            let trail = std::mem::take(&mut end.trail).joined(more.trail);
            *end = End { iterations: end.iterations + more.iterations, trail, ..more };
            return Ok(());
        }
        match self.polish(end, unknowns)? {
            true => Ok(()),
            false => self.repeat(end, unknowns),
        }
    }

    fn settle_again(&mut self, end: &mut End, unknowns: &Unknowns<'_>) -> Result<(), InputError> {
        // costs in other units
        end.trail.costs.clear();
        self.settle(end, unknowns)
    }

    /// Corrections of poses and tensions are the same as with least squares: they make each sample's norm the least, and with it any loss
    /// that grows with the norm.
    fn follow(&mut self, loss: RobustLoss, end: &mut End, unknowns: &Unknowns<'_>) -> Result<bool, InputError> {
        self.loss = Some(loss);
        let near = self.descend_from(&end.values, unknowns, NEAR_PROMISE);
        let trail = std::mem::take(&mut end.trail).then(near.trail);
        *end = End { iterations: end.iterations + near.iterations, trail, ..near };
        self.settle(end, unknowns)?;
        Ok(true)
    }

    fn keep(&mut self) {
        self.kept = Some((self.at.clone(), self.noise));
    }

    fn come_back(&mut self) {
        if let Some((at, noise)) = self.kept.take() {
            (self.at, self.noise) = (at, noise);
        }
    }

    fn finish(&mut self) {
        self.loss = None;
    }
}

impl BalanceResidual<'_> {
    /// Corrects the points of linearisation for the parameters where a descent ended.
    fn correct(&mut self, end: &End) -> Result<(), InputError> {
        let here = self.model.with_parameters(self.parameters, &end.values).ok_or(InputError::NotFinite)?;
        let rows = RowModel::new(&here, Load::of(here.robot())?, self.parameters);
        self.at.correct(&rows, self.samples, &self.tensions, &self.sigmas).ok_or(InputError::NotFinite)?;
        self.at.scale_weights(self.noise);
        Ok(())
    }

    /// Gauss–Newton steps with corrections at each; false when they do not contract, or need damping.
    fn polish(&mut self, end: &mut End, unknowns: &Unknowns<'_>) -> Result<bool, InputError> {
        let mut last_predicted_reduction = f64::INFINITY;
        for _ in 0..POLISHING_STEPS {
            self.correct(end)?;
            let Some(step) = self.plain_step(&end.values, unknowns) else { return Ok(false) };
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
    fn repeat(&mut self, end: &mut End, unknowns: &Unknowns<'_>) -> Result<(), InputError> {
        for round in 0..ADJUSTMENTS {
            let before = self.at.clone();
            self.correct(end)?;
            let more = self.descend_from(&end.values, unknowns, FINAL_REDUCTION);
            let gained = (more.cost - end.cost).abs();
            let trail = std::mem::take(&mut end.trail).then(more.trail);
            *end = End { iterations: end.iterations + more.iterations, trail, ..more };
            if round > 0 && before.distance_to(&self.at) < 1e-6 && gained <= 1e-9 * end.cost {
                break;
            }
        }
        Ok(())
    }
}
