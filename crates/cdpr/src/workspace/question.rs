//! Size of the set of positions at which criteria hold, asked of a model in one line.

use super::criterion::registry::{self, CriterionRequest, Setting};
use super::refine::{ByGrid, Goal, refine};
use super::{Archetype, Bounds, Region, WorkspaceError};
use crate::model::Model;
use crate::statics::Load;
use crate::tension::Limits;

/// Criteria asked of a model under a load, in the orientation of its home pose.
#[derive(Clone, Debug)]
pub struct WorkspaceQuestion<'a> {
    model: &'a Model,
    load: &'a Load,
    requests: Vec<CriterionRequest>,
}

/// Size of a workspace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkspaceSize {
    /// Area of planar robots (m²), volume of others (m³).
    pub size: f64,
    /// Bound of its error with the probability [`CONFIDENCE`](super::CONFIDENCE) (m², m³).
    pub error_bound: f64,
}

impl Model {
    /// Positions of the platform under a load; criteria follow, then [`WorkspaceQuestion::volume`].
    ///
    /// ```
    /// use cdpr::{Load, Model, Robot};
    ///
    /// let robot = Robot::builtin("planar-example").ok_or("unknown robot")?;
    /// let load = Load::of(&robot)?;
    /// let model = Model::new(robot, "standard".parse()?)?;
    /// let found = model.workspace(&load).wrench_feasible().volume()?;
    /// assert!(found.error_bound < 0.02 * found.size);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn workspace<'a>(&'a self, load: &'a Load) -> WorkspaceQuestion<'a> {
        WorkspaceQuestion { model: self, load, requests: Vec::new() }
    }
}

impl WorkspaceQuestion<'_> {
    /// Tensions within the limits of the robot's file balance the load (eq. 3.29).
    #[must_use]
    pub fn wrench_feasible(self) -> Self {
        self.criterion(CriterionRequest::wrench_feasible())
    }

    /// One more criterion, as the command reads it: `"stiffness:translation=1e5".parse()?`. All have to hold.
    #[must_use]
    pub fn criterion(mut self, request: CriterionRequest) -> Self {
        self.requests.push(request);
        self
    }

    /// Size of the set, on a grid that is refined until the bound of its error is 1 % or a second of work is done: the number of
    /// `cdpr workspace`. Without a criterion there is no set ([`WorkspaceError::NoCriterion`]).
    pub fn volume(&self) -> Result<WorkspaceSize, WorkspaceError> {
        let robot = self.model.robot();
        let limits = Limits::of(robot, None, None);
        let setting = Setting { model: self.model, load: Ok(*self.load), limits };
        let criterion = registry::all(&self.requests, &setting)?;
        let archetype = Archetype::ConstantOrientation(robot.home_or_middle().rotation);
        let region = Region::new(self.model, criterion.as_ref(), &archetype)?;
        let goal = Goal::usual();
        let bounds = Bounds::about(&region, self.model, 0.25 * goal.poses(&region))?;
        let mut search = ByGrid { region: &region, bounds: &bounds, step: bounds.usual_step() };
        let refined = refine(&region, &bounds, &goal, &mut search)?;
        let (cells, count) = &refined.found;
        Ok(WorkspaceSize { size: count.outcome(cells).size, error_bound: refined.audit.error_bound() })
    }
}
