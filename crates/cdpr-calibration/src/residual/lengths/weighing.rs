//! Weights of lengths that agree with the optimum they lead to.

use super::LengthResidual;
use super::descent;
use super::pose_lanes::CableValues;
use super::weights::{Weights, length_weights, weights_of};
use crate::fit::InputError;
use crate::loss::RobustLoss;
use crate::minimize::descent::End;
use crate::minimize::unknowns::{Pace, Shape, Unknowns};
use crate::residual::Weighing;
use cdpr_model::model::Model;
use cdpr_model::solve::ROUNDING_GAIN;

/// Most repetitions of a fit with weights from its own optimum; each gains several digits.
const REWEIGHTINGS: u32 = 4;
/// The noise is found when it changes by less than this share.
const SAME_NOISE: f64 = 1e-10;

impl Weighing for LengthResidual<'_> {
    fn noise(&self) -> f64 {
        self.weights.noise
    }

    fn same_noise(&self) -> Option<f64> {
        Some(SAME_NOISE)
    }

    fn scale_noise(&mut self, factor: f64) {
        self.take_weights(self.weights.for_noise(factor));
    }

    /// Variances depend on the parameters: weighs anew at the optimum and repeats.
    fn settle(&mut self, end: &mut End, unknowns: &Unknowns<'_>) -> Result<(), InputError> {
        for _ in 0..REWEIGHTINGS {
            if !self.weights.absolute || self.weigh_anew(end)? {
                break;
            }
            self.descend_all(end, unknowns);
        }
        Ok(())
    }

    fn settle_again(&mut self, end: &mut End, unknowns: &Unknowns<'_>) -> Result<(), InputError> {
        self.descend_all(end, unknowns);
        Ok(())
    }

    fn follow(&mut self, loss: RobustLoss, end: &mut End, unknowns: &Unknowns<'_>) -> Result<bool, InputError> {
        self.descend_under(loss, end, unknowns);
        if self.weights.absolute { self.weigh_anew(end) } else { Ok(true) }
    }

    fn keep(&mut self) {
        (self.kept, self.rounds) = (Some(self.weights.clone()), 0);
    }

    fn come_back(&mut self) {
        if let Some(weights) = self.kept.take() {
            self.take_weights(weights);
        }
    }

    fn finish(&mut self) {
        self.take_weights(self.weights.clone());
    }
}

impl LengthResidual<'_> {
    pub(super) fn take_weights(&mut self, weights: Weights) {
        self.weights = weights;
        self.rows.blocks.iter_mut().for_each(|block| block.set_weights(&self.weights));
    }

    /// Weighs at an end; true where the weights were those of it already.
    fn weigh_anew(&mut self, end: &End) -> Result<bool, InputError> {
        let again = self.own_weights(&end.values)?;
        let is_close = self.weights.is_close_to(&again);
        if !is_close {
            self.take_weights(again);
        }
        Ok(is_close)
    }

    /// Descends again from where the cables are, with other weights.
    fn descend_all(&self, end: &mut End, unknowns: &Unknowns<'_>) {
        let pace = Pace { shape: Shape::Square, least_gain: ROUNDING_GAIN, patience: None };
        let of_block = |(block, range): (&_, std::ops::Range<usize>)| {
            let own = unknowns.within(range.clone());
            descent::run(block, &self.rows.poses, &own, &end.values[range], &pace)
        };
        let mut again = End::joined(self.rows.blocks.iter().zip(self.rows.ranges()).map(of_block).collect());
        again.trail = std::mem::take(&mut end.trail).then(again.trail);
        *end = again;
    }

    /// Weights at parameter values, platform anchors as given: weakly determined ones may end metres away, and a variance that grows with the
    /// moment arm would reward them for it.
    fn own_weights(&self, values: &[f64]) -> Result<Weights, InputError> {
        let blocks = self.rows.blocks.iter().zip(self.rows.ranges());
        let at: Vec<CableValues> = blocks.map(|(block, range)| block.at(&values[range])).collect();
        let levers =
            |cable: usize| CableValues { platform_anchor: self.rows.blocks[cable].start.platform_anchor, ..at[cable] };
        match weights_of(&self.model, levers, self.samples, &self.rows.poses) {
            (weights, true) => Ok(weights),
            _ => {
                let calibrated = self.model.with_parameters(self.parameters, values).ok_or(InputError::NotFinite)?;
                let mut robot = calibrated.robot().clone();
                for (cable, given) in robot.cables.iter_mut().zip(&self.model.robot().cables) {
                    cable.platform_anchor = given.platform_anchor;
                }
                length_weights(&Model::new(robot, self.model.composition())?, self.samples, &self.rows.poses)
            }
        }
    }
}
