//! Elastostatic forward problem: pose and tensions that follow from controlled lengths and load (eq. 2.42–2.43).
//!
//! Find (x, f) with Aᵀ(x) f + w(x) = 0 and fᵢ = max(0, (qᵢ(x) − q_θ,ᵢ)/cᵢ): the platform rests where the elastic energy of
//! the cables minus the work of the load is least. Damped Newton steps descend this energy with the symmetric part of
//! its Hessian K_wx = K_C − K_G − ∂w/∂x; near the end the constant moments' skew part joins in, so that convergence is
//! quadratic. A first descent lets cables push, since where none has to that finds the same pose in fewer steps.
//!
//! Rigid cables (fewer than or as many as degrees of freedom) are stiff springs whose rest lengths follow their tensions until
//! no cable is longer than its controlled length, the method of multipliers; the last digits come from Newton steps on pose
//! and tensions together.

mod balance;
pub mod batch;
mod composed;
mod descent;
mod multipliers;
mod polish;
mod search;
mod softening;
mod stability;
#[cfg(test)]
mod tests;
mod unsymmetric;
mod verdict;

use balance::Springs;
use composed::Composed;
use descent::Tensions;
use thiserror::Error;

use super::forward_kinematics;
pub use super::{Solution, Status};
use crate::cable::stretch::hysteresis::Memory;
use crate::geometry::Pose;
use crate::model::Model;
use crate::scalar::LANES;
use crate::statics::Load;

/// When the elastostatic forward problem stops, and what it accepts.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Stop once the pose is this near to the equilibrium, judged by the last steps (m, relative to the mean length above
    /// 1 m; angles times the platform radius).
    pub pose_tolerance: f64,
    /// For rigid cables: how much longer than its controlled length a cable may remain (m).
    pub length_tolerance: f64,
    /// Size of Aᵀ f + w that counts as balance, beside the forces at work; moments divided by the platform radius. A tension
    /// this small beside the others cannot be told from none.
    pub wrench_tolerance: f64,
    /// Steps allowed for each descent.
    pub max_iterations: u32,
    /// Other starts that may be tried when the first one does not lead to a stable equilibrium.
    pub max_restarts: u32,
    /// A cable that stretches by more than this share of its controlled length deserves a remark.
    pub remarkable_strain: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            pose_tolerance: 1e-11,
            length_tolerance: 1e-10,
            wrench_tolerance: 1e-7,
            max_iterations: 200,
            max_restarts: 16,
            remarkable_strain: 0.1,
        }
    }
}

/// Input that no elastostatic forward problem can accept.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum InputError {
    /// Lengths, guess or settings, as for forward kinematics.
    #[error(transparent)]
    Kinematic(#[from] forward_kinematics::InputError),
    /// More rigid cables than degrees of freedom: their tensions do not follow from their lengths.
    #[error(
        "{rigid} cables have no compliance at {dof} degrees of freedom: their tensions do not follow from their lengths; give \
         them a stiffness and use the effect `elastic`, or use forward kinematics for the pose that fits the lengths best"
    )]
    RigidRedundant {
        /// Number of cables without compliance.
        rigid: usize,
        /// Degrees of freedom.
        dof: usize,
    },
}

impl Settings {
    /// Refuses tolerances that are not positive numbers.
    pub fn validate(&self) -> Result<(), InputError> {
        for (name, value) in [
            ("pose_tolerance", self.pose_tolerance),
            ("length_tolerance", self.length_tolerance),
            ("wrench_tolerance", self.wrench_tolerance),
            ("remarkable_strain", self.remarkable_strain),
        ] {
            if !(value > 0.0 && value.is_finite()) {
                return Err(forward_kinematics::InputError::Setting { name, value }.into());
            }
        }
        Ok(())
    }
}

/// Finds pose and tensions for controlled lengths q_θ (m, one per cable) under a load, from a guess.
///
/// Lengths are those of the model, without the recorded scale and offset ([`Model::controlled_length`] removes them).
/// The motion pattern holds: what the pattern cannot move keeps the guess's value. Cables cannot push.
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
    /// Set while a batch asks for taut cables only.
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
    /// Lengths of one item of a batch.
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

    /// True where it has room for the cables of a model.
    pub(super) fn fits(&self, model: &Model) -> bool {
        self.lengths.len() == model.cable_count() && self.composed.is_some() == Composed::serves(model)
    }
}

/// The load in plain arrays, for the kernel.
#[derive(Clone, Copy, Debug)]
struct LoadParts {
    constant: [f64; 6],
    weight: [f64; 3],
    center_of_mass: [f64; 3],
}

impl LoadParts {
    fn of(load: &Load) -> Self {
        let (weight, center_of_mass) = load.weight();
        Self {
            constant: (*load.constant_part()).into(),
            weight: (*weight).into(),
            center_of_mass: (*center_of_mass).into(),
        }
    }
}

/// A model with lengths to obey and a load to carry.
#[derive(Clone, Copy, Debug)]
struct Problem<'a> {
    model: &'a Model,
    settings: &'a Settings,
    load: LoadParts,
    full_load: &'a Load,
    /// A constant moment makes the stiffness unsymmetric.
    has_moment: bool,
    springs: &'a [Springs],
    /// Least stretch with a force (m): 0 for cables, −∞ for bars.
    floor: f64,
    /// Sum of the cables' stiffness (N/m): the unit of damping.
    stiffness_scale: f64,
    mean_length: f64,
    platform_radius: f64,
    /// An equilibrium with slack cables is none.
    only_taut: bool,
}

impl<'a> Solver<'a> {
    /// A solver for this model and load.
    pub fn new(model: &'a Model, load: &Load, settings: &Settings) -> Result<Self, InputError> {
        Self::with(model, load, settings, Scratch::new(model))
    }

    /// [`Solver::new`] in memory that a solver has left, which fits the model.
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

    /// The memory, with the last solution in it.
    pub(super) fn into_scratch(self) -> Scratch {
        self.scratch
    }

    /// Seeks from the guess alone from now on: an answer is what the platform comes to from there.
    #[must_use]
    pub fn without_restarts(mut self) -> Self {
        self.settings.max_restarts = 0;
        self
    }

    /// Another load from now on.
    pub fn set_load(&mut self, load: &Load) {
        self.load = *load;
    }

    /// Cables that start from these memories, one per cable; without effect where laws have none.
    #[must_use]
    pub(super) fn with_memories(mut self, memories: &[Memory]) -> Self {
        if let Some(composed) = &mut self.scratch.composed {
            composed.set_memories(memories);
        }
        self
    }

    /// Finds one pose as [`solve`] does; with elastic cables it allocates nothing unless there is a reason to tell.
    pub fn solve(&mut self, controlled_lengths: &[f64], guess: &Pose) -> Result<&Solution, InputError> {
        forward_kinematics::check_input(self.model, controlled_lengths, guess)?;
        if let Scratch { composed: Some(composed), solution, .. } = &mut self.scratch {
            composed.solve((self.model, &self.load, &self.settings), controlled_lengths, guess, solution)?;
        } else {
            self.search(controlled_lengths, guess);
        }
        Ok(&self.scratch.solution)
    }
}
