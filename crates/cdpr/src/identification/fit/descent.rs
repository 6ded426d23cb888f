//! Damped Gauss–Newton descent of one cable's block, within bounds.

use super::{Settings, prior_sigma};
use crate::identification::blocks::{Block, NormalEquations, SLOTS};
use crate::identification::pose_lanes::{CableValues, PoseLanes};
use crate::scalar::ldl;

/// Steps that are recorded without allocating again; few descents take more.
const HISTORY_CAPACITY: usize = 16;

/// Where the descent of one block ended.
pub(super) struct End {
    pub(super) values: CableValues,
    /// What the parameters moved by.
    pub(super) change: Vec<f64>,
    pub(super) cost: f64,
    pub(super) iterations: u32,
    pub(super) history: Vec<f64>,
    pub(super) converged: bool,
}

/// Descends from the block's start values, or from a change of them that an earlier descent found.
pub(super) fn run(block: &Block, poses: &PoseLanes, settings: &Settings, from: Option<&[f64]>) -> End {
    match block.parameters.len() {
        0 => Search::<0>::new(block, poses, settings).run(from),
        1 => Search::<1>::new(block, poses, settings).run(from),
        2 => Search::<2>::new(block, poses, settings).run(from),
        3 => Search::<3>::new(block, poses, settings).run(from),
        4 => Search::<4>::new(block, poses, settings).run(from),
        5 => Search::<5>::new(block, poses, settings).run(from),
        6 => Search::<6>::new(block, poses, settings).run(from),
        7 => Search::<7>::new(block, poses, settings).run(from),
        8 => Search::<8>::new(block, poses, settings).run(from),
        9 => Search::<9>::new(block, poses, settings).run(from),
        10 => Search::<10>::new(block, poses, settings).run(from),
        _ => Search::<SLOTS>::new(block, poses, settings).run(from),
    }
}

struct Search<'a, const P: usize> {
    block: &'a Block,
    poses: &'a PoseLanes,
    settings: &'a Settings,
    /// 1/σ² of the priors, 0 without one.
    prior_weights: [f64; P],
    /// Metres that one unit of each parameter is worth.
    worth: [f64; P],
    bounds: [(f64, f64); P],
    start: [f64; P],
}

impl<'a, const P: usize> Search<'a, P> {
    fn new(block: &'a Block, poses: &'a PoseLanes, settings: &'a Settings) -> Self {
        let parameter = |k: usize| block.parameters[k];
        Self {
            block,
            poses,
            settings,
            prior_weights: std::array::from_fn(|k| {
                prior_sigma(settings, parameter(k).kind).map_or(0.0, |s| 1.0 / (s * s))
            }),
            worth: std::array::from_fn(|k| block.worth(parameter(k).kind)),
            bounds: std::array::from_fn(|k| parameter(k).bounds()),
            start: std::array::from_fn(|k| block.value(&block.start, &parameter(k))),
        }
    }

    fn equations(&self, change: &[f64; P]) -> (CableValues, NormalEquations<P>) {
        let values = self.block.moved(&self.block.start, change);
        let mut equations = self.block.normal::<P>(self.poses, &values);
        for k in 0..P {
            equations.cost += self.prior_weights[k] * change[k] * change[k];
            equations.gradient[k] += self.prior_weights[k] * change[k];
            equations.matrix[k][k] += self.prior_weights[k];
        }
        (values, equations)
    }

    fn run(&self, from: Option<&[f64]>) -> End {
        let mut change = [0.0; P];
        change.iter_mut().zip(from.into_iter().flatten()).for_each(|(value, &earlier)| *value = earlier);
        let (mut values, mut equations) = self.equations(&change);
        let mut history = Vec::with_capacity(HISTORY_CAPACITY);
        history.push(equations.cost);
        // last_size 0: no step yet, so no rate of contraction to judge by
        let (mut damping, mut last_size, mut iterations) = (0.0, 0.0, 0);
        let (mut settled, mut converged) = (false, P == 0);
        while !converged && iterations < self.settings.max_iterations {
            iterations += 1;
            let Some((step, ratio)) = self.step(&change, &equations, damping) else {
                damping = f64::max(10.0 * damping, 1e-9);
                converged = damping > 1e9; // a parameter that moves no length at all: analysis names it
                continue;
            };
            // undamped, unidentifiable directions would wander on rounding errors
            if ratio < 1e-11 && damping < 1e-9 {
                damping = 1e-9;
                continue;
            }
            let size = (0..P).map(|k| (step[k] * self.worth[k]).abs()).fold(0.0, f64::max);
            let promise: f64 = -(0..P).map(|k| step[k] * equations.gradient[k]).sum::<f64>();
            // no reduction that the rounding of the cost would show
            if settled || promise <= 1e-13 * equations.cost || size <= 1e-3 * self.settings.tolerance {
                if damping == 0.0 {
                    // the gradient still knows the way to more digits, and the step costs no evaluation
                    change = add(&change, &step);
                    values = self.block.moved(&self.block.start, &change);
                }
                converged = true;
                break;
            }
            let trial = add(&change, &step);
            let (trial_values, next) = self.equations(&trial);
            if next.cost <= equations.cost * (1.0 + 1e-12) {
                let contraction = size / last_size;
                (change, values, equations, last_size) = (trial, trial_values, next, size);
                history.push(equations.cost);
                damping = if damping <= 1e-9 { damping } else { damping * 0.1 };
                // what the remaining steps add up to if they go on shrinking at this rate; they may not, so one more follows
                settled = contraction < 0.5 && size * contraction <= self.settings.tolerance * (1.0 - contraction);
            } else {
                damping = f64::max(10.0 * damping, 1e-4);
                converged = damping > 1e12 && size <= self.settings.tolerance;
            }
        }
        End { values, change: change.to_vec(), cost: equations.cost, iterations, history, converged }
    }

    /// Damped step that respects the bounds, with the smallest pivot ratio of the normal equations.
    fn step(&self, change: &[f64; P], equations: &NormalEquations<P>, damping: f64) -> Option<([f64; P], f64)> {
        let room: [(f64, f64); P] = std::array::from_fn(|k| {
            let value = self.start[k] + change[k];
            (self.bounds[k].0 - value, self.bounds[k].1 - value)
        });
        // a parameter on a bound that the gradient pushes outwards stays there
        let mut held: [bool; P] = std::array::from_fn(|k| {
            (room[k].0 >= 0.0 && equations.gradient[k] > 0.0) || (room[k].1 <= 0.0 && equations.gradient[k] < 0.0)
        });
        loop {
            let mut matrix = equations.matrix;
            let mut step = equations.gradient.map(|x| -x);
            for k in 0..P {
                if held[k] {
                    step[k] = 0.0;
                    (0..P).for_each(|j| (matrix[k][j], matrix[j][k]) = (0.0, 0.0));
                    matrix[k][k] = 1.0;
                } else {
                    matrix[k][k] *= 1.0 + damping;
                }
            }
            let ratio = ldl::solve(&mut matrix, &mut step)?;
            let outside = |k: usize| !held[k] && (step[k] < room[k].0 || step[k] > room[k].1);
            match (0..P).find(|&k| outside(k) && (room[k].0 >= 0.0 || room[k].1 <= 0.0)) {
                // already on the bound: hold it and solve for the others
                Some(k) => held[k] = true,
                None => {
                    let clamped = std::array::from_fn(|k| step[k].clamp(room[k].0.min(0.0), room[k].1.max(0.0)));
                    return Some((clamped, ratio));
                }
            }
        }
    }
}

fn add<const P: usize>(a: &[f64; P], b: &[f64; P]) -> [f64; P] {
    std::array::from_fn(|k| a[k] + b[k])
}
