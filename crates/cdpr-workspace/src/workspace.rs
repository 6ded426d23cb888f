//! The set of positions at which criteria hold, and its size, in one line.

use nalgebra::UnitQuaternion;

use crate::criterion::registry::{self, CriterionRequest, Setting};
use crate::refine::{ByGrid, Goal, refine};
use crate::{Archetype, Bounds, Region, WorkspaceError};
use cdpr_model::model::Model;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;

/// Criteria for a model under a load, in one orientation of the platform.
#[derive(Clone, Debug)]
pub struct Workspace {
    model: Model,
    load: Load,
    requests: Vec<CriterionRequest>,
    orientation: UnitQuaternion<f64>,
}

/// Size of a workspace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkspaceSize {
    /// Area of planar robots (m²), volume of others (m³).
    pub size: f64,
    /// Bound of the size's error with the probability [`CONFIDENCE`](super::CONFIDENCE) (m², m³).
    pub error_bound: f64,
    /// True if the set reaches the faces of the box that was searched, so that more of it may lie outside.
    pub reaches_bounds: bool,
}

impl Workspace {
    /// Positions of a model's platform under a load, its axes parallel to those of the world; add criteria, then call
    /// [`Workspace::volume`].
    ///
    /// ```
    /// use cdpr::workspace::Workspace;
    /// use cdpr::{Load, Model, Robot};
    ///
    /// let robot = Robot::builtin("planar-example").ok_or("unknown robot")?;
    /// let load = Load::of(&robot)?;
    /// let model = Model::new(robot, "standard".parse()?)?;
    /// let found = Workspace::of(&model, &load).wrench_feasible().volume()?;
    /// assert!(found.error_bound < 0.02 * found.size);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(model: &Model, load: &Load) -> Self {
        Self { model: model.clone(), load: *load, requests: Vec::new(), orientation: UnitQuaternion::identity() }
    }
}

impl Workspace {
    /// Requires that tensions within the limits of the robot's file balance the load (eq. 3.29).
    #[must_use]
    pub fn wrench_feasible(self) -> Self {
        self.criterion(CriterionRequest::wrench_feasible())
    }

    /// Adds a criterion in the notation of the command: `"stiffness:least=1e5".parse()?`. All have to hold.
    #[must_use]
    pub fn criterion(mut self, request: CriterionRequest) -> Self {
        self.requests.push(request);
        self
    }

    /// Sets the orientation of the platform.
    #[must_use]
    pub fn orientation(mut self, orientation: UnitQuaternion<f64>) -> Self {
        self.orientation = orientation;
        self
    }

    /// Size of the set, on a grid that is refined until the bound of its error is 1 % or a second of work is done;
    /// `cdpr workspace` prints the same number. Without a criterion the error is [`WorkspaceError::NoCriterion`].
    pub fn volume(&self) -> Result<WorkspaceSize, WorkspaceError> {
        let limits = Limits::of(self.model.robot(), None, None);
        let setting = Setting { model: &self.model, load: Ok(self.load), limits };
        let criterion = registry::all(&self.requests, &setting)?;
        let archetype = Archetype::ConstantOrientation(self.orientation);
        let region = Region::new(&self.model, criterion.as_ref(), &archetype)?;
        let goal = Goal::usual();
        let bounds = Bounds::about(&region, &self.model, &goal)?;
        let mut search = ByGrid { region: &region, bounds: &bounds, step: bounds.usual_step() };
        let refined = refine(&region, &bounds, &goal, &mut search)?;
        let (cells, count) = &refined.found;
        let outcome = count.outcome(cells);
        let error_bound = refined.audit.error_bound();
        Ok(WorkspaceSize { size: outcome.size, error_bound, reaches_bounds: outcome.reaches_bounds })
    }
}
