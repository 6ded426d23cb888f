//! The optimum of all cables together under a robust loss, by reweighting.
//!
//! Both losses are concave in z², so that the weighted squares with the weights ρ′ of a place lie above the loss and touch it there: the
//! least weighted squares never raise it (Huber 1981, section 7.8). A cable's descent stays its own; the weights tie the cables together.

use std::ops::Range;

use super::LengthResidual;
use super::blocks::Block;
use super::descent::{advance, run};
use crate::loss::RobustLoss;
use crate::minimize::descent::End;
use crate::minimize::trail::Trail;
use crate::minimize::unknowns::{Pace, Shape, Unknowns};
use crate::stopping::{StoppedBy, StoppingRule};
use cdpr_model::scalar::LANES;
use cdpr_model::solve::{ROUNDING_GAIN, minimizer};

/// Most steps of a damped descent between reweightings.
const MOST_DAMPED_STEPS: u32 = 10;
/// Rise of the loss that is rounding.
const ROUNDING_RISE: f64 = 1e-12;

impl LengthResidual<'_> {
    /// Descends under one loss, its scale fixed, from where the cables are.
    pub(super) fn descend_under(&mut self, loss: RobustLoss, end: &mut End, unknowns: &Unknowns<'_>) {
        let settings = unknowns.settings;
        let (limit, before) = (settings.max_iterations, self.rounds);
        end.stopped =
            StoppedBy { rule: StoppingRule::IterationLimit, value: f64::from(limit), limit: f64::from(limit) };
        let mut trail = Trail::new(settings.keeps_course, 0);
        let (mut least, mut is_damped) = (f64::INFINITY, false);
        let mut best = end.values.clone();
        let mut factors = vec![0.0; self.rows.samples.next_multiple_of(LANES)];
        while self.rounds < limit {
            let mut squares = self.squares_at(&end.values);
            let cost = squares.iter().map(|&square| loss.cost(square)).sum::<f64>() + unknowns.prior_cost(&end.values);
            let helps = cost <= least * (1.0 + ROUNDING_RISE);
            if helps {
                least = cost;
                trail.push(cost, || end.values.clone());
                best.copy_from_slice(&end.values);
            } else {
                end.values.copy_from_slice(&best);
                squares = self.squares_at(&end.values);
                // whole descents cannot raise the loss: what they raise is rounding
                if is_damped {
                    let value = (cost - least) / least;
                    end.stopped = StoppedBy { rule: StoppingRule::Rounding, value: value.abs(), limit: ROUNDING_RISE };
                    break;
                }
            }
            is_damped = !helps;
            factors.iter_mut().zip(&squares).for_each(|(factor, &square)| *factor = loss.weight(square).sqrt());
            let Self { rows, weights, .. } = self;
            rows.blocks.iter_mut().for_each(|block| block.set_weights_times(weights, &factors));
            self.rounds += 1;
            let reduction = self.move_all(&mut end.values, unknowns, is_damped);
            let change: Vec<f64> = end.values.iter().zip(&best).map(|(now, before)| now - before).collect();
            let size = minimizer::size(&change, &unknowns.scale);
            if size <= settings.tolerance {
                end.stopped = StoppedBy { rule: StoppingRule::Step, value: size, limit: settings.tolerance };
                break;
            }
            if reduction <= ROUNDING_GAIN * least {
                end.stopped = StoppedBy { rule: StoppingRule::Cost, value: reduction / least, limit: ROUNDING_GAIN };
                break;
            }
        }
        end.cost = least;
        end.iterations += self.rounds - before;
        end.trail = std::mem::take(&mut end.trail).then(trail);
    }

    /// Moves all cables by an undamped step each, or by a whole descent: where a step is not determined, and where it did not help. Answers
    /// the reduction of the weighted squares that is promised, infinite for descents.
    fn move_all(&self, values: &mut [f64], unknowns: &Unknowns<'_>, is_damped: bool) -> f64 {
        // any gain is enough before weights change again
        let few = Pace { shape: Shape::Square, least_gain: ROUNDING_GAIN, patience: Some(MOST_DAMPED_STEPS) };
        let mut reduction = 0.0;
        let with_parameters = |(_, range): &(&Block, Range<usize>)| !range.is_empty();
        for (block, range) in self.rows.blocks.iter().zip(self.rows.ranges()).filter(with_parameters) {
            let (own, here) = (unknowns.within(range.clone()), &mut values[range]);
            let step = if is_damped { None } else { advance(block, &self.rows.poses, &own, here) };
            let (moved, promised) =
                step.unwrap_or_else(|| (run(block, &self.rows.poses, &own, here, &few).values, f64::INFINITY));
            here.copy_from_slice(&moved);
            reduction += promised;
        }
        reduction
    }
}
