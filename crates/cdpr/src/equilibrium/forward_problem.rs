//! Forward problem that belongs to a composition: one rule for everything that asks where a platform goes.
//!
//! Elastic cables, and fewer rigid ones than degrees of freedom under a known load, rest where cables and load are in
//! equilibrium ([`elastostatics`]). Rigid cables otherwise fit their lengths as well as possible ([`forward_kinematics`]);
//! with fewer cables than degrees of freedom that determines no pose.

use super::{elastostatics, forward_kinematics};
use crate::model::Model;
use crate::statics::{Load, LoadError};

/// Forward problem of a composition.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ForwardProblem {
    /// The pose whose lengths fit best, whatever the load.
    LeastSquares,
    /// Pose and tensions in equilibrium with the load.
    Equilibrium,
}

impl ForwardProblem {
    /// Forward problem of a model whose load is known or not.
    pub fn of(model: &Model, is_load_known: bool) -> Self {
        let is_underactuated = model.cable_count() < model.dof();
        match model.composition().depends_on_tension() || (is_underactuated && is_load_known) {
            true => Self::Equilibrium,
            false => Self::LeastSquares,
        }
    }
}

/// Solver of a model's forward problem, for one set of lengths after the other.
#[derive(Clone, Debug)]
pub enum ForwardSolver<'a> {
    /// See [`ForwardProblem::LeastSquares`].
    LeastSquares(Box<forward_kinematics::Solver<'a>>),
    /// See [`ForwardProblem::Equilibrium`].
    Equilibrium(Box<elastostatics::Solver<'a>>),
}

impl<'a> ForwardSolver<'a> {
    /// Solver under the load of the model's robot; `settings` are those of a least-squares pose.
    ///
    /// Fails for elastic models of unknown load, and where tensions do not follow from the lengths.
    pub fn new<E>(model: &'a Model, settings: &forward_kinematics::Settings) -> Result<Self, E>
    where
        E: From<LoadError> + From<elastostatics::InputError>,
    {
        let load = Load::of(model.robot());
        Ok(match ForwardProblem::of(model, load.is_ok()) {
            ForwardProblem::Equilibrium => {
                let settings = elastostatics::Settings::default();
                Self::Equilibrium(Box::new(elastostatics::Solver::new(model, &load?, &settings)?))
            }
            ForwardProblem::LeastSquares => {
                let solver = forward_kinematics::Solver::new(model, settings);
                Self::LeastSquares(Box::new(solver.map_err(elastostatics::InputError::from)?))
            }
        })
    }

    /// True where tensions follow from lengths and load.
    pub fn knows_tensions(&self) -> bool {
        matches!(self, Self::Equilibrium(_))
    }
}
