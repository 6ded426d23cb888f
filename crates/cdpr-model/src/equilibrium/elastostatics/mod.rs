//! Elastostatic forward problem: pose and tensions that follow from controlled lengths and load (eq. 2.42–2.43).
//!
//! Find (x, f) with Aᵀ(x) f + w(x) = 0 and fᵢ = max(0, (qᵢ(x) − q_θ,ᵢ)/cᵢ): the platform rests where the elastic energy
//! of the cables minus the work of the load is least. Damped Newton steps descend this energy with the symmetric part
//! of its Hessian K_wx = K_C − K_G − ∂w/∂x; near the end the skew part from constant moments is added, so that
//! convergence is quadratic. A first descent lets cables push: if none has to, it finds the same pose in fewer steps.
//!
//! Rigid cables (fewer than or as many as degrees of freedom) are stiff springs with rest lengths that follow their
//! tensions until no cable is longer than its controlled length, the method of multipliers; the last digits come from
//! Newton steps on pose and tensions together.

mod attempt;
mod balance;
pub mod batch;
mod composed;
mod descent;
mod multipliers;
mod polish;
mod problem;
mod rigid;
mod search;
mod settings;
mod softening;
mod springs;
mod stability;
mod straight_machine;
#[cfg(test)]
mod tests;
mod unsymmetric;
mod verdict;

use composed::Composed;
use descent::Tensions;
use problem::{LoadParts, Problem};
pub use settings::{InputError, Settings};
use springs::Springs;

use super::forward_kinematics;
pub use super::{Solution, Status};
use crate::cable::stretch::hysteresis::Memory;
use crate::geometry::Pose;
use crate::model::Model;
use crate::scalar::LANES;
use crate::statics::Load;

/// Finds pose and tensions for controlled lengths q_θ (m, one per cable) under a load, from a guess.
///
/// Lengths are those of the model, without the recorded scale and offset ([`Model::controlled_length`] removes them).
/// Coordinates outside the motion pattern keep the guess's value. Cables cannot push.
///
/// Many poses of one model are faster with one [`Solver`].
pub fn solve(
    model: &Model,
    controlled_lengths: &[f64],
    load: &Load,
    guess: &Pose,
    settings: &Settings,
) -> Result<Solution, InputError> {
    let mut solver = Solver::new(model, load, settings)?;
    solver.solve(controlled_lengths, guess)?;
    Ok(solver.scratch.solution)
}

/// A solver for many poses of one model: its memory is claimed once and reused.
#[derive(Clone, Debug)]
pub struct Solver<'a> {
    model: &'a Model,
    settings: Settings,
    load: Load,
    platform_radius: f64,
    /// True while a batch solves for taut cables only.
    only_taut: bool,
    scratch: Scratch,
}

/// Memory of a [`Solver`] without its model.
#[derive(Clone, Debug)]
pub(super) struct Scratch {
    is_rigid: Vec<bool>,
    springs: Vec<Springs>,
    tensions: Tensions,
    composed: Option<Composed>,
    /// Lengths of one problem of a batch (m).
    lengths: Vec<f64>,
    pub(super) solution: Solution,
}

impl Scratch {
    pub(super) fn new(model: &Model) -> Self {
        let (cables, groups) = (model.cable_count(), model.groups().len());
        Self {
            is_rigid: vec![false; cables],
            springs: vec![Springs { rest_length: [1.0; LANES], stiffness: [0.0; LANES] }; groups],
            tensions: Tensions::new(groups),
            composed: Composed::new(model),
            lengths: vec![f64::NAN; cables],
            solution: Solution::unsolved(cables, cables),
        }
    }

    /// True if the memory fits the cables of a model.
    pub(super) fn fits(&self, model: &Model) -> bool {
        self.lengths.len() == model.cable_count() && self.composed.is_some() == Composed::serves(model)
    }
}

impl<'a> Solver<'a> {
    /// A solver for this model and load.
    pub fn new(model: &'a Model, load: &Load, settings: &Settings) -> Result<Self, InputError> {
        Self::with(model, load, settings, Scratch::new(model))
    }

    /// [`Solver::new`] with the memory of an earlier solver, which fits the model.
    pub(super) fn with(
        model: &'a Model,
        load: &Load,
        settings: &Settings,
        mut scratch: Scratch,
    ) -> Result<Self, InputError> {
        settings.validate()?;
        let is_plain = scratch.composed.is_none();
        for (cable, is_rigid) in scratch.is_rigid.iter_mut().enumerate() {
            *is_rigid = is_plain && model.elasticity(cable).is_rigid();
        }
        if let Some(composed) = &mut scratch.composed {
            composed.take_laws(model);
        }
        let (rigid, dof) = (scratch.is_rigid.iter().filter(|rigid| **rigid).count(), model.dof());
        if rigid > dof {
            return Err(InputError::RigidRedundant { rigid, dof });
        }
        let platform_radius = model.platform_radius();
        Ok(Self { model, settings: settings.clone(), load: *load, platform_radius, only_taut: false, scratch })
    }

    /// Returns the memory, with the last solution in it.
    pub(super) fn into_scratch(self) -> Scratch {
        self.scratch
    }

    /// Sets the memories from which cables start, one per cable; no effect for laws without memory.
    #[must_use]
    pub(super) fn with_memories(mut self, memories: &[Memory]) -> Self {
        if let Some(composed) = &mut self.scratch.composed {
            composed.set_memories(memories);
        }
        self
    }

    /// Finds one pose as [`solve`] does; with elastic cables it allocates nothing except for a reason in words.
    pub fn solve(&mut self, controlled_lengths: &[f64], guess: &Pose) -> Result<&Solution, InputError> {
        forward_kinematics::check_input(self.model, controlled_lengths, guess)?;
        if let Scratch { composed: Some(composed), solution, .. } = &mut self.scratch {
            let (model, load, settings, solve_straight) = (self.model, &self.load, &self.settings, solve as _);
            let question = composed::Question { model, load, settings, solve_straight };
            composed.solve(question, controlled_lengths, guess, solution)?;
        } else {
            self.search(controlled_lengths, guess);
        }
        Ok(&self.scratch.solution)
    }
}
