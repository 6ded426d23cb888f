//! Workspaces of an experiment: the reachable one, and those in which control model and machine are wrench-feasible.

use nalgebra::UnitQuaternion;

use super::Experiment;
use crate::reachable::{Reachable, Requirements};
use cdpr_model::control::InputError;
use cdpr_model::equilibrium::ForwardProblem;
use cdpr_model::model::Model;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::criterion::WrenchFeasible;
use cdpr_workspace::grid::{self, Grid};
use cdpr_workspace::{Archetype, Bounds, Region, WorkspaceError};

impl Experiment {
    /// Tension limits of the machine; the error names the missing key.
    pub fn known_limits(&self) -> Result<Limits, InputError> {
        Ok(Limits::of(self.machine.robot(), None, None)?)
    }

    /// Tension limits of the machine, if they are known.
    pub fn limits(&self) -> Option<Limits> {
        self.known_limits().ok()
    }

    /// True if the machine's answer includes tensions.
    pub fn tensions_emerge(&self) -> bool {
        let is_load_known = Load::of(self.machine.robot()).is_ok();
        ForwardProblem::of(&self.machine, is_load_known) == ForwardProblem::Equilibrium
    }

    /// Requirements of the study on a pose that counts as reached.
    pub fn requirements(&self) -> Requirements {
        let limits = self.study.limits.as_ref();
        Requirements {
            tensions: self.limits().filter(|_| self.machine.needs_tensions()),
            position_error_max: limits.and_then(|limits| limits.position_error_max_m),
            rotation_error_max: limits.and_then(|limits| limits.rotation_error_max_rad),
            tension_error_max: limits.and_then(|limits| limits.tension_error_max_N),
        }
    }

    /// Reachable workspace under the requirements of the study.
    pub fn reachable(&self) -> Result<Reachable, InputError> {
        self.reachable_with(self.requirements())
    }

    /// Reachable workspace under other requirements.
    pub(crate) fn reachable_with(&self, requirements: Requirements) -> Result<Reachable, InputError> {
        Reachable::new(self.driving()?, requirements)
    }

    /// Wrench feasibility of one of the models within the machine's limits; `None` if load or limits are unknown.
    pub fn feasible<'m>(&self, model: &'m Model) -> Option<WrenchFeasible<'m>> {
        let load = Load::of(model.robot()).ok()?;
        WrenchFeasible::new(model, &load, &self.limits()?).ok()
    }

    /// The box in which workspaces are searched: these ends along each translation (m), or around the machine.
    pub fn bounds(&self, ends: Option<&[f64]>) -> Result<Bounds, WorkspaceError> {
        match ends {
            Some(ends) => Bounds::new(self.machine.axes().len(), ends),
            None => Bounds::around(&self.machine),
        }
    }

    /// Positions at which the reachable workspace is tested, with the platform in one orientation.
    pub fn region<'a>(
        &self,
        reachable: &'a Reachable,
        orientation: UnitQuaternion<f64>,
    ) -> Result<Region<'a>, WorkspaceError> {
        Region::new(&self.machine, reachable, &Archetype::ConstantOrientation(orientation))
    }

    /// The cells of a grid at which one of the models is wrench-feasible; `None` if load or limits are unknown.
    pub fn feasible_cells(&self, model: &Model, region: &Region<'_>, grid: &Grid) -> Option<grid::Outcome> {
        let criterion = self.feasible(model)?;
        Some(grid::count(&region.with_criterion(&criterion), grid).outcome(grid))
    }
}
