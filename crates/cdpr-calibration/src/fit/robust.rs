//! The optimum of all cables together under a robust loss, by reweighting.
//!
//! Both losses are concave in z², so that the weighted squares with the weights ρ′ of a place lie above the loss and touch it there: the
//! least weighted squares never raise it (Huber 1981, section 7.8). A cable's descent stays its own; the weights tie the cables together.

use super::descent::{End, advance, run};
use super::optimum::{Given, Optimum, Rounds};
use super::{InputError, Settings};
use crate::blocks::Block;
use crate::loss::{RobustLoss, Tail};
use crate::norms::{Extent, Norms, RESCALINGS, SAME_SCALE};
use crate::pose_lanes::CableValues;
use crate::stopping::{StoppedBy, StoppingRule};
use crate::trail::Trail;
use crate::weights::Weights;
use cdpr_model::solve::ROUNDING_GAIN;

/// Most steps of a damped descent between reweightings.
const MOST_DAMPED_STEPS: u32 = 10;
/// Rise of the loss that is rounding.
const ROUNDING_RISE: f64 = 1e-12;

/// Values of a cable and their change from its start.
type Place = (CableValues, Vec<f64>);

impl Optimum {
    /// Takes the loss of the settings at the optimum of least squares.
    pub(super) fn take_loss(&mut self, given: Given<'_>, weights: &mut Weights) -> Result<(), InputError> {
        let Given { samples, settings, .. } = given;
        let parameters = self.blocks.iter().map(|block| block.parameters.len()).sum();
        let extent = Extent { rows: samples.lengths.len(), parameters, absolute: weights.absolute };
        self.norms = Norms::new(vec![0.0; samples.len()], None, extent);
        self.measure(weights);
        let Some(tail) = self.norms.to_ask(settings.loss, self.stopped().converged()) else { return Ok(()) };
        let squared = (self.ends.clone(), self.norms.clone(), weights.clone());
        self.minimise(tail, given, weights)?;
        if !self.norms.answer(settings.loss) {
            (self.ends, self.norms, *weights) = squared;
            self.rounds = Rounds::default();
        }
        // what is told of the rows is told by their accuracies
        self.blocks.iter_mut().for_each(|block| block.set_weights(weights));
        Ok(())
    }

    /// The least loss at a scale that agrees with its residuals.
    fn minimise(&mut self, tail: Tail, given: Given<'_>, weights: &mut Weights) -> Result<(), InputError> {
        let Given { model, samples, settings } = given;
        for round in 0..RESCALINGS {
            let mut is_same = round > 0;
            if round > 0 && weights.absolute {
                let again = self.own_weights(model, samples)?;
                if !weights.is_close_to(&again) {
                    *weights = again;
                    self.measure(weights);
                    is_same = false;
                }
            }
            let mut deviation = self.norms.deviation;
            let is_found = |scale: f64| (deviation / scale - 1.0).abs() < SAME_SCALE;
            is_same &= self
                .norms
                .loss
                .is_some_and(|loss| is_found(loss.threshold / tail.at(self.norms.dimension(), 1.0).threshold));
            if is_same {
                break;
            }
            if !weights.absolute && !settings.priors.is_empty() {
                // a prior needs the scale of the noise
                *weights = weights.for_noise(deviation);
                deviation = 1.0;
            }
            self.descend_under(tail.at(self.norms.dimension(), deviation), weights, settings);
        }
        Ok(())
    }

    /// Descends under one loss, its scale fixed, from where the cables are.
    fn descend_under(&mut self, loss: RobustLoss, weights: &Weights, settings: &Settings) {
        self.norms.loss = Some(loss);
        self.rounds.trail = std::mem::take(&mut self.rounds.trail).then(Trail::new(settings.keeps_course, 0));
        let limit = settings.max_iterations;
        self.rounds.stopped =
            Some(StoppedBy { rule: StoppingRule::IterationLimit, value: f64::from(limit), limit: f64::from(limit) });
        let (mut least, mut is_damped) = (f64::INFINITY, false);
        let mut best = self.places();
        let mut factors = vec![0.0; weights.padded_samples()];
        while self.rounds.count < settings.max_iterations {
            self.write_squares(weights);
            let cost =
                self.norms.squares.iter().map(|&square| loss.cost(square)).sum::<f64>() + self.prior_cost(settings);
            let helps = cost <= least * (1.0 + ROUNDING_RISE);
            if helps {
                least = cost;
                self.push(cost);
                self.remember(&mut best);
            } else {
                self.return_to(&best);
                self.write_squares(weights);
                // whole descents cannot raise the loss: what they raise is rounding
                if is_damped {
                    let value = (cost - least) / least;
                    self.rounds.stopped =
                        Some(StoppedBy { rule: StoppingRule::Rounding, value: value.abs(), limit: ROUNDING_RISE });
                    break;
                }
            }
            is_damped = !helps;
            factors
                .iter_mut()
                .zip(&self.norms.squares)
                .for_each(|(factor, &square)| *factor = loss.weight(square).sqrt());
            self.blocks.iter_mut().for_each(|block| block.set_weights_times(weights, &factors));
            self.rounds.count += 1;
            let reduction = self.move_all(settings, is_damped);
            let (size, gain) = (self.size_of_move(&best), reduction / least);
            if size <= settings.tolerance {
                self.rounds.stopped =
                    Some(StoppedBy { rule: StoppingRule::Step, value: size, limit: settings.tolerance });
                break;
            }
            if reduction <= ROUNDING_GAIN * least {
                self.rounds.stopped = Some(StoppedBy { rule: StoppingRule::Cost, value: gain, limit: ROUNDING_GAIN });
                break;
            }
        }
        self.measure(weights);
    }

    /// Moves all cables by an undamped step each, or by a whole descent: where a step is not determined, and where it did not help. Answers
    /// the reduction of the weighted squares that is promised, infinite for descents.
    fn move_all(&mut self, settings: &Settings, is_damped: bool) -> f64 {
        let Self { blocks, poses, ends, .. } = self;
        let mut reduction = 0.0;
        // any gain is enough before weights change again
        let few = Settings { max_iterations: settings.max_iterations.min(MOST_DAMPED_STEPS), ..settings.clone() };
        for (block, end) in blocks.iter().zip(ends).filter(|(block, _)| !block.parameters.is_empty()) {
            let step = if is_damped { None } else { advance(block, poses, settings, end) };
            reduction += step.unwrap_or(f64::INFINITY);
            if step.is_none() {
                let (stopped, trail) = (end.stopped, std::mem::take(&mut end.trail));
                *end = End { stopped, trail, ..run(block, poses, &few, Some(&end.change)) };
            }
        }
        reduction
    }

    /// Largest change since other places (m).
    fn size_of_move(&self, since: &[Place]) -> f64 {
        let of_block = |((block, end), (_, before)): ((&Block, &End), &Place)| {
            let scaled = block.parameters.iter().zip(end.change.iter().zip(before));
            scaled
                .map(|(parameter, (now, before))| ((now - before) * block.scale(parameter.kind)).abs())
                .fold(0.0, f64::max)
        };
        self.blocks.iter().zip(&self.ends).zip(since).map(of_block).fold(0.0, f64::max)
    }

    /// Goes on to the place where the cables are.
    fn push(&mut self, cost: f64) {
        let Self { blocks, ends, rounds, .. } = self;
        rounds
            .trail
            .push(cost, || blocks.iter().zip(&*ends).flat_map(|(block, end)| block.values(&end.values)).collect());
    }

    fn places(&self) -> Vec<Place> {
        self.ends.iter().map(|end| (end.values, end.change.clone())).collect()
    }

    fn remember(&self, places: &mut [Place]) {
        for (place, end) in places.iter_mut().zip(&self.ends) {
            place.0 = end.values;
            place.1.copy_from_slice(&end.change);
        }
    }

    fn return_to(&mut self, places: &[Place]) {
        for (end, place) in self.ends.iter_mut().zip(places) {
            end.values = place.0;
            end.change.copy_from_slice(&place.1);
        }
    }

    /// Norms at the ends, and their size.
    fn measure(&mut self, weights: &Weights) {
        self.write_squares(weights);
        self.norms.measure();
    }

    /// Squared norm of each sample's residuals at the ends.
    fn write_squares(&mut self, weights: &Weights) {
        let samples = self.norms.squares.len();
        let mut squares = std::mem::take(&mut self.norms.squares);
        squares.clear();
        squares.resize(weights.padded_samples(), 0.0);
        for (block, end) in self.blocks.iter().zip(&self.ends) {
            block.add_squares(&self.poses, &end.values, weights, &mut squares);
        }
        squares.truncate(samples);
        self.norms.squares = squares;
    }
}
