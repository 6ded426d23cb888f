//! Squares of one cable's lengths, as the loop of all descents sees them.

use super::blocks::{Block, SLOTS};
use super::further::FURTHER;
use super::normal_equations::{NormalEquations, exact};
use super::pose_lanes::PoseLanes;
use crate::minimize::dense::DenseEquations;
use crate::minimize::descent::{End, Equations, System, descend};
use crate::minimize::unknowns::{Pace, Ridge, Unknowns};
use cdpr_model::scalar::ldl;
use cdpr_model::solve::{NormalSystem, OF_SINGULAR, REGULAR};

/// Calls a function with room for the parameters of a block: exact for what is chosen most often.
macro_rules! with_room {
    ($block:expr, $function:ident($($argument:expr),+)) => {
        match $block.parameters.len() {
            3 => $function::<3>($($argument),+),
            4 => $function::<4>($($argument),+),
            6 => $function::<6>($($argument),+),
            8 => $function::<8>($($argument),+),
            _ => $function::<{ SLOTS + FURTHER }>($($argument),+),
        }
    };
}

/// Descends from values of the block's parameters.
pub(super) fn run(block: &Block, poses: &PoseLanes, own: &Unknowns<'_>, from: &[f64], pace: &Pace) -> End {
    with_room!(block, run_in(block, poses, own, from, pace))
}

/// Takes one undamped step without asking what it helped: the values behind it and the reduction of the weighted squares that it promises; `None`
/// where the normal equations do not determine it.
pub(super) fn advance(block: &Block, poses: &PoseLanes, own: &Unknowns<'_>, values: &[f64]) -> Option<(Vec<f64>, f64)> {
    with_room!(block, advance_in(block, poses, own, values))
}

/// Writes the weighted squares at values of the block's parameters, without priors.
pub(super) fn write(block: &Block, poses: &PoseLanes, values: &[f64], to: &mut DenseEquations) {
    with_room!(block, write_in(block, poses, values, to));
}

/// Weighted squares of one cable's lengths and priors.
struct CableSquares<'a, const P: usize> {
    block: &'a Block,
    poses: &'a PoseLanes,
    start: [f64; P],
    /// 1/σ² of the priors, 0 without one.
    prior_weights: [f64; P],
}

impl<'a, const P: usize> CableSquares<'a, P> {
    fn new(block: &'a Block, poses: &'a PoseLanes, own: &Unknowns<'_>) -> Self {
        let (mut start, mut prior_weights) = ([0.0; P], [0.0; P]);
        start[..own.len()].copy_from_slice(&own.start);
        own.ridges().for_each(|Ridge { parameter, weight, .. }| prior_weights[parameter] = weight);
        Self { block, poses, start, prior_weights }
    }
}

impl<const P: usize> System for CableSquares<'_, P> {
    type Equations = NormalEquations<P>;

    fn write(&mut self, values: &[f64], equations: &mut NormalEquations<P>) -> bool {
        let count = exact::<P>(values.len());
        let mut change = [0.0; P];
        (0..count).for_each(|k| change[k] = values[k] - self.start[k]);
        let at = self.block.moved(&self.block.start, &change[..count]);
        *equations = self.block.normal::<P>(self.poses, &at);
        for k in 0..count {
            equations.cost += self.prior_weights[k] * change[k] * change[k];
            equations.gradient[k] += self.prior_weights[k] * change[k];
            equations.matrix[k][k] += self.prior_weights[k];
        }
        equations.cost.is_finite()
    }
}

fn run_in<const P: usize>(block: &Block, poses: &PoseLanes, own: &Unknowns<'_>, from: &[f64], pace: &Pace) -> End {
    let mut squares = CableSquares::<P>::new(block, poses, own);
    descend(&mut squares, &own.around(false), from, NormalEquations::empty(own.len()), &own.rules(pace))
}

fn advance_in<const P: usize>(
    block: &Block,
    poses: &PoseLanes,
    own: &Unknowns<'_>,
    values: &[f64],
) -> Option<(Vec<f64>, f64)> {
    let mut equations = NormalEquations::empty(own.len());
    CableSquares::<P>::new(block, poses, own).write(values, &mut equations);
    let step = own.around(false).plain_step(values, &equations)?;
    let reduction = -(0..step.len()).map(|k| step[k] * equations.gradient[k]).sum::<f64>();
    Some((values.iter().zip(&step).map(|(value, step)| value + step).collect(), reduction))
}

fn write_in<const P: usize>(block: &Block, poses: &PoseLanes, values: &[f64], to: &mut DenseEquations) {
    let NormalEquations { cost, gradient, matrix, .. } = block.normal::<P>(poses, &block.at(values));
    to.cost = cost;
    for i in 0..values.len() {
        to.gradient[i] = gradient[i];
        (0..=i).for_each(|j| (to.hessian[(i, j)], to.hessian[(j, i)]) = (matrix[i][j], matrix[i][j]));
    }
}

impl<const P: usize> Equations for NormalEquations<P> {
    fn cost(&self) -> f64 {
        self.cost
    }
}

impl<const P: usize> NormalSystem for NormalEquations<P> {
    fn gradient(&self, k: usize) -> f64 {
        self.gradient[k]
    }

    fn entry(&self, i: usize, j: usize) -> f64 {
        self.matrix[i.max(j)][i.min(j)]
    }

    #[inline]
    fn damped(&self, held: &[bool], damping: f64, step: &mut [f64]) -> Option<()> {
        let mut matrix = self.matrix;
        let mut right = self.gradient.map(|x| -x);
        let count = exact::<P>(self.count);
        for k in 0..count {
            if held[k] {
                right[k] = 0.0;
                (0..count).for_each(|j| (matrix[k][j], matrix[j][k]) = (0.0, 0.0));
                matrix[k][k] = 1.0;
            } else {
                matrix[k][k] *= 1.0 + damping;
            }
        }
        let ratio = ldl::solve_leading(count, &mut matrix, &mut right)?;
        step.copy_from_slice(&right[..count]);
        (ratio >= REGULAR || damping >= OF_SINGULAR).then_some(())
    }
}
