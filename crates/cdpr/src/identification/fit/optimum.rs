//! All cables at their optimum, with weights that agree with it.

use super::{InputError, Settings, descent};
use crate::identification::blocks::Block;
use crate::identification::pose_lanes::PoseLanes;
use crate::identification::weights::{Weights, length_weights};
use crate::measurement::Samples;
use crate::model::{Model, ModelError, Parameter};

/// Most repetitions of a fit with weights from its own optimum; each gains several digits.
const REWEIGHTINGS: u32 = 4;

/// All blocks at their optimum.
pub(super) struct Optimum {
    pub(super) poses: PoseLanes,
    pub(super) blocks: Vec<Block>,
    pub(super) ends: Vec<descent::End>,
}

/// Optimum and the weights it belongs to.
pub(super) fn find(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
) -> Result<(Optimum, Weights), InputError> {
    let poses = PoseLanes::new(samples);
    let mut weights = length_weights(model, samples, &poses)?;
    let block = |cable| {
        let own = parameters.iter().filter(|parameter| parameter.cable == cable).copied().collect();
        Block::new(model, cable, own, samples, &weights)
    };
    let blocks: Vec<Block> = (0..model.cable_count()).map(block).collect();
    let ends = blocks.iter().map(|block| descent::run(block, &poses, settings, None)).collect();
    let mut optimum = Optimum { poses, blocks, ends };
    // variances depend on the parameters, and a prior needs the scale of the noise: weigh anew at the optimum and repeat
    for _ in 0..REWEIGHTINGS {
        let again = match weights.absolute {
            true => length_weights(&optimum.with_given_levers(model)?, samples, &optimum.poses)?,
            false if settings.priors.is_empty() => break,
            false => weights.scaled(1.0 / optimum.noise_factor(samples, parameters.len()).max(1e-6)),
        };
        if parameters.is_empty() || weights.is_close_to(&again) {
            break;
        }
        weights = again;
        optimum.reweigh(&weights, settings);
    }
    Ok((optimum, weights))
}

impl Optimum {
    /// Descends again from where it stands, with other weights.
    fn reweigh(&mut self, weights: &Weights, settings: &Settings) {
        for (block, end) in self.blocks.iter_mut().zip(&mut self.ends) {
            block.set_weights(weights);
            *end = descent::run(block, &self.poses, settings, Some(&end.change));
        }
    }

    /// Root of the weighted sum of squares per degree of freedom.
    pub(super) fn noise_factor(&self, samples: &Samples, parameter_count: usize) -> f64 {
        let cost: f64 = self.ends.iter().map(|end| end.cost).sum();
        let rows = samples.lengths.len() as f64;
        (cost / (rows - parameter_count as f64).max(1.0)).sqrt()
    }

    pub(super) fn history(&self) -> Vec<f64> {
        let steps = self.ends.iter().map(|end| end.history.len()).max().unwrap_or(0);
        let at = |end: &descent::End, step: usize| end.history[step.min(end.history.len() - 1)];
        (0..steps).map(|step| self.ends.iter().map(|end| at(end, step)).sum()).collect()
    }

    /// Steps of the cable that needed most.
    pub(super) fn iterations(&self) -> u32 {
        self.ends.iter().map(|end| end.iterations).max().unwrap_or(0)
    }

    pub(super) fn converged(&self) -> bool {
        self.ends.iter().all(|end| end.converged)
    }

    /// The calibrated model.
    pub(super) fn calibrated(&self, model: &Model) -> Result<Model, ModelError> {
        let mut robot = model.robot().clone();
        for (block, end) in self.blocks.iter().zip(&self.ends) {
            for parameter in &block.parameters {
                parameter.assign(model, &mut robot, block.value(&end.values, parameter));
            }
        }
        Model::new(robot, model.composition())
    }

    /// The calibrated model with the platform anchors as given: weakly determined ones may end metres away, and a variance
    /// that grows with the lever would reward them for it.
    fn with_given_levers(&self, model: &Model) -> Result<Model, ModelError> {
        let mut robot = self.calibrated(model)?.robot().clone();
        for (cable, given) in robot.cables.iter_mut().zip(&model.robot().cables) {
            cable.platform_anchor = given.platform_anchor;
        }
        Model::new(robot, model.composition())
    }
}
