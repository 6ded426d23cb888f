//! All cables at their optimum, with weights that agree with it.

use super::{InputError, Settings, descent, prior_sigma};
use crate::blocks::Block;
use crate::misfit::Misfit;
use crate::norms::Norms;
use crate::pose_lanes::{CableValues, PoseLanes};
use crate::progress::{Progress, Stopped, report};
use crate::starts::{self, Ending, Landscape, Part, Starts};
use crate::stopping::StoppedBy;
use crate::trail::{Trail, side_by_side};
use crate::weights::{Weights, length_weights, weights_of};
use cdpr_model::measurement::Samples;
use cdpr_model::model::{Model, ModelError};
use cdpr_model::robot::Parameter;

/// Most repetitions of a fit with weights from its own optimum; each gains several digits.
const REWEIGHTINGS: u32 = 4;
/// Most repetitions with the noise that its own residuals tell; near the end each doubles the digits.
const RESCALINGS: u32 = 30;
/// The noise is found when it changes by less than this share.
const SAME_NOISE: f64 = 1e-10;

/// All blocks at their optimum.
pub(super) struct Optimum {
    pub(super) poses: PoseLanes,
    pub(super) blocks: Vec<Block>,
    pub(super) ends: Vec<descent::End>,
    /// Optima that the starts led to.
    pub(super) starts: Starts,
    /// Norms of the samples' residuals, with the loss.
    pub(super) norms: Norms,
    /// Rounds of reweighting under a robust loss.
    pub(super) rounds: Rounds,
}

/// Rounds of reweighting under a robust loss.
#[derive(Clone, Debug, Default)]
pub(super) struct Rounds {
    pub(super) count: u32,
    /// End of the last descent; `None` without a robust loss.
    pub(super) stopped: Option<StoppedBy>,
    /// Loss and priors after each round of the last descent.
    pub(super) trail: Trail,
}

/// Problem of a fit.
#[derive(Clone, Copy)]
pub(super) struct Given<'a> {
    pub(super) model: &'a Model,
    pub(super) samples: &'a Samples,
    pub(super) settings: &'a Settings,
}

/// Optimum and the weights it belongs to; `progress` is called after each start.
pub(super) fn find(
    model: &Model,
    samples: &Samples,
    parameters: &[Parameter],
    settings: &Settings,
    progress: &Progress<'_>,
) -> Result<(Optimum, Weights), InputError> {
    let given = Given { model, samples, settings };
    let poses = PoseLanes::new(samples);
    let mut weights = length_weights(model, samples, &poses)?;
    let block = |cable| {
        let own = parameters.iter().filter(|parameter| parameter.cable == cable).copied().collect();
        Block::new(model, cable, own, samples, &weights)
    };
    let blocks: Vec<Block> = (0..model.cable_count()).map(block).collect();
    let ends = blocks.iter().map(|block| descent::run(block, &poses, settings, None)).collect();
    let mut optimum =
        Optimum { poses, blocks, ends, starts: Starts::default(), norms: Norms::default(), rounds: Rounds::default() };
    optimum.try_other_starts(samples, settings, progress)?;
    match (weights.absolute, settings.priors.is_empty()) {
        _ if parameters.is_empty() => {}
        (true, _) => optimum.agree_with_weights(given, &mut weights)?,
        (false, false) => optimum.agree_with_noise(samples, settings, &mut weights),
        // without priors the scale of the noise moves no parameter
        (false, true) => {}
    }
    if !parameters.is_empty() {
        optimum.take_loss(given, &mut weights)?;
    }
    Ok((optimum, weights))
}

/// Cables, each with a cost of its own.
struct Cables<'a> {
    blocks: &'a [Block],
    poses: &'a PoseLanes,
    settings: &'a Settings,
}

impl Landscape for Cables<'_> {
    type End = descent::End;

    fn descend(&mut self, part: usize, change: &[f64]) -> descent::End {
        descent::run(&self.blocks[part], self.poses, self.settings, Some(change))
    }

    fn cost(&mut self, part: usize, place: &[f64], _: &descent::End) -> f64 {
        descent::cost(&self.blocks[part], self.poses, self.settings, place)
    }
}

impl Ending for descent::End {
    fn cost(&self) -> f64 {
        self.cost
    }

    fn converged(&self) -> bool {
        self.stopped.converged()
    }

    fn place(&self) -> &[f64] {
        &self.change
    }
}

impl Optimum {
    /// Descends from other starts too; each cable keeps its lowest end.
    fn try_other_starts(
        &mut self,
        samples: &Samples,
        settings: &Settings,
        progress: &Progress<'_>,
    ) -> Result<(), Stopped> {
        if settings.starts <= 1 {
            self.starts = Starts::of_file(&self.ends);
            return report(progress);
        }
        let part = |block: &Block| Part {
            parameters: block.parameters.clone(),
            start: block.values(&block.start).collect(),
            scale: block.parameters.iter().map(|parameter| block.scale(parameter.kind)).collect(),
        };
        let parts: Vec<Part> = self.blocks.iter().map(part).collect();
        let search = starts::Search { parts: &parts, settings, samples: samples.len(), tension: 0.0 };
        let mut cables = Cables { blocks: &self.blocks, poses: &self.poses, settings };
        self.starts = search.run(&mut cables, &mut self.ends, progress)?;
        Ok(())
    }

    /// Variances depend on the parameters: weighs anew at the optimum and repeats.
    fn agree_with_weights(&mut self, given: Given<'_>, weights: &mut Weights) -> Result<(), InputError> {
        let Given { model, samples, settings } = given;
        for _ in 0..REWEIGHTINGS {
            let again = self.own_weights(model, samples)?;
            if weights.is_close_to(&again) {
                break;
            }
            *weights = again;
            self.reweigh(weights, settings);
        }
        Ok(())
    }

    /// A prior needs the scale of the noise, which the residuals tell: weighs by it and repeats.
    fn agree_with_noise(&mut self, samples: &Samples, settings: &Settings, weights: &mut Weights) {
        for _ in 0..RESCALINGS {
            let noise = self.misfit(samples, settings).noise();
            if (noise - 1.0).abs() < SAME_NOISE {
                break;
            }
            *weights = weights.for_noise(noise);
            self.reweigh(weights, settings);
        }
    }

    /// Descends again from where it stands, with other weights.
    fn reweigh(&mut self, weights: &Weights, settings: &Settings) {
        for (block, end) in self.blocks.iter_mut().zip(&mut self.ends) {
            block.set_weights(weights);
            let before = std::mem::take(&mut end.trail);
            *end = descent::run(block, &self.poses, settings, Some(&end.change));
            end.trail = before.then(std::mem::take(&mut end.trail));
        }
    }

    /// Misfit in units of the weights.
    pub(super) fn misfit(&self, samples: &Samples, settings: &Settings) -> Misfit {
        let parameters = || self.blocks.iter().flat_map(|block| &block.parameters);
        let priors = parameters().filter(|parameter| prior_sigma(settings, parameter.kind).is_some()).count();
        Misfit {
            cost: self.ends.iter().map(|end| end.cost).sum(),
            prior_cost: self.prior_cost(settings),
            freedom: (samples.lengths.len() + priors).saturating_sub(parameters().count()),
        }
    }

    /// Σ ((p − p_start)/σ_prior)².
    pub(super) fn prior_cost(&self, settings: &Settings) -> f64 {
        let prior = |block: &Block, k: usize| prior_sigma(settings, block.parameters[k].kind);
        let squares = self.blocks.iter().zip(&self.ends).flat_map(|(block, end)| {
            let change = end.change.iter().enumerate();
            change.filter_map(move |(k, change)| Some((change / prior(block, k)?).powi(2)))
        });
        squares.sum()
    }

    /// Way of all cables together.
    pub(super) fn trail(&self) -> Trail {
        let of_cables = side_by_side(&self.ends.iter().map(|end| &end.trail).collect::<Vec<_>>());
        match self.rounds.trail.costs.is_empty() {
            true => of_cables,
            false => of_cables.then(self.rounds.trail.clone()),
        }
    }

    /// Steps of the cable that needed most.
    pub(super) fn iterations(&self) -> u32 {
        self.ends.iter().map(|end| end.iterations).max().unwrap_or(0) + self.rounds.count
    }

    /// The rule that ended the search, of the cable whose end says least of an optimum.
    pub(super) fn stopped(&self) -> StoppedBy {
        let of_rounds = self.rounds.stopped.filter(|_| self.norms.loss.is_some());
        let cables = StoppedBy::worst(self.ends.iter().map(|end| end.stopped)).unwrap_or(StoppedBy::at_start(0.0));
        match of_rounds {
            // descents between reweightings end where they may
            Some(rounds) if cables.converged() => rounds,
            _ => cables,
        }
    }

    /// The calibrated model.
    pub(super) fn calibrated(&self, model: &Model) -> Result<Model, ModelError> {
        let mut robot = model.robot().clone();
        for (block, end) in self.blocks.iter().zip(&self.ends) {
            for (parameter, value) in block.parameters.iter().zip(block.values(&end.values)) {
                parameter.set(&mut robot, value);
            }
        }
        robot.forget_assumptions(self.blocks.iter().flat_map(|block| block.parameters.iter().copied()));
        Model::new(robot, model.composition())
    }

    /// Weights at the optimum, platform anchors as given: weakly determined ones may end metres away, and a variance that grows with the
    /// moment arm would reward them for it.
    pub(super) fn own_weights(&self, model: &Model, samples: &Samples) -> Result<Weights, InputError> {
        let levers = |cable: usize| CableValues {
            platform_anchor: self.blocks[cable].start.platform_anchor,
            ..self.ends[cable].values
        };
        match weights_of(model, levers, samples, &self.poses) {
            (weights, true) => Ok(weights),
            _ => {
                let mut robot = self.calibrated(model)?.robot().clone();
                for (cable, given) in robot.cables.iter_mut().zip(&model.robot().cables) {
                    cable.platform_anchor = given.platform_anchor;
                }
                length_weights(&Model::new(robot, model.composition())?, samples, &self.poses)
            }
        }
    }
}
