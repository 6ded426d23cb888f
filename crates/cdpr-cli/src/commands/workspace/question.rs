//! The question: robot, criteria, orientations and box.

use cdpr_model::geometry::Pose;
use cdpr_model::model::Model;
use cdpr_model::statics::Load;
use cdpr_model::tension::Limits;
use cdpr_workspace::criterion::registry::{self, CriterionRequest, Setting};
use cdpr_workspace::hull::{self, Center};
use cdpr_workspace::refine::Goal;
use cdpr_workspace::{Archetype, Bounds, Criterion, Point, Region, WorkspaceError};

use super::{Arguments, Method};
use crate::failure::Failure;
use crate::inputs::{pose_of, wrench_of};
use cdpr_reports::answers::Asked;

/// A hull may take so many times the work of all refinements: fewer rays than usual are for criteria of seconds only.
const HULL_SHARE: f64 = 8.0;

pub(super) struct Question<'a> {
    pub(super) model: &'a Model,
    pub(super) archetype: Archetype,
    pub(super) bounds: Bounds,
    /// Largest side of a cell (m), at first.
    pub(super) step: f64,
    /// How small the bound of the error shall be.
    pub(super) goal: Goal,
    /// Rays that `--rays` asks for.
    rays: Option<usize>,
    /// Tolerance that `--tolerance` asks for (m).
    tolerance: Option<f64>,
    setting: Setting<'a>,
    /// The criteria as they were asked for, with their numbers.
    criteria: String,
    /// The pose that `--center` gives.
    given: Option<Pose>,
}

impl<'a> Question<'a> {
    pub(super) fn new(arguments: &Arguments, model: &'a Model) -> Result<Self, Failure> {
        let robot = model.robot();
        let given = arguments.center.as_ref().map(|numbers| pose_of(robot, "--center", numbers)).transpose()?;
        let archetype = arguments.orientations.archetype(model, given.map(|pose| pose.rotation))?;
        let bounds = match &arguments.bounds {
            Some(numbers) => Bounds::new(model.axes().len(), &numbers.0),
            None => Bounds::around(model),
        };
        let bounds = bounds.map_err(|error| Failure::refused("--bounds", &error))?;
        let load = match &arguments.wrench {
            Some(numbers) => Ok(Load::constant(wrench_of(robot, "--wrench", numbers)?)),
            None => Load::of(robot),
        };
        let limits = Limits::of(robot, arguments.min, arguments.max);
        let step = arguments.step.unwrap_or(bounds.usual_step());
        let is_asked = match arguments.method {
            Method::Hull => arguments.rays.is_some(),
            Method::Grid | Method::Octree => arguments.step.is_some() || arguments.resume.is_some(),
        };
        let goal = Goal { refines: !is_asked, ..Goal::usual() };
        let (rays, tolerance) = (arguments.rays, arguments.tolerance);
        let setting = Setting { model, load, limits };
        let criteria = arguments.criterion.join(" ");
        Ok(Self { model, archetype, bounds, step, goal, rays, tolerance, setting, criteria, given })
    }

    pub(super) fn criterion(&self, wanted: &[CriterionRequest]) -> Result<Box<dyn Criterion + 'a>, Failure> {
        registry::all(wanted, &self.setting).map_err(|error| {
            let source = match error {
                WorkspaceError::Limits(_)
                | WorkspaceError::Load(_)
                | WorkspaceError::Payload(_)
                | WorkspaceError::MissingKey { .. } => "ROBOT",
                _ => "--criterion",
            };
            Failure::refused(source, &error)
        })
    }

    pub(super) fn region<'c>(&self, criterion: &'c dyn Criterion) -> Result<Region<'c>, Failure> {
        Region::new(self.model, criterion, &self.archetype).map_err(|error| Failure::refused("--archetype", &error))
    }

    /// Looks closer around the region, unless a box was given, or a center that lies further out.
    pub(super) fn look_closer(&mut self, arguments: &Arguments, region: &Region<'_>) -> Result<(), Failure> {
        if arguments.bounds.is_none() {
            let closer =
                Bounds::about(region, self.model, &self.goal).map_err(|error| Failure::refused("--bounds", &error))?;
            if self.given.is_none_or(|pose| closer.contain(&region.point(&pose.position))) {
                self.step = arguments.step.unwrap_or(closer.usual_step());
                self.bounds = closer;
            }
        }
        Ok(())
    }

    /// Point from which rays start: the one given, the home pose where it belongs to the region, or the middle of a coarse grid.
    pub(super) fn center(&self, region: &Region<'_>) -> Result<Center, Failure> {
        if let Some(pose) = &self.given {
            return Ok(Center::At(region.point(&pose.position)));
        }
        let home = self.home(region);
        if self.bounds.contain(&home) && region.holds(&home) {
            return Ok(Center::At(home));
        }
        let points = (0.5 * self.goal.poses(region)) as u64;
        hull::find_center(region, &self.bounds, points).map_err(|error| Failure::refused("--bounds", &error))
    }

    /// Rays of a hull, at first.
    pub(super) fn rays(&self, region: &Region<'_>) -> hull::Settings {
        let usual = hull::Settings::within(&self.bounds, HULL_SHARE * self.goal.poses(region));
        let (rays, tolerance) = (self.rays.unwrap_or(usual.rays), self.tolerance.unwrap_or(usual.tolerance));
        hull::Settings { rays, tolerance, ..usual }
    }

    /// The home position, where it is looked for first.
    pub(super) fn home(&self, region: &Region<'_>) -> Point {
        let home = region.point(&self.model.robot().home_or_middle().position);
        if self.bounds.contain(&home) { home } else { self.bounds.middle() }
    }

    /// The question as the answer tells it.
    pub(super) fn asked<'c>(&'c self, region: &'c Region<'c>) -> Asked<'c> {
        Asked { model: self.model, region, bounds: &self.bounds, goal: &self.goal, home: self.home(region) }
    }

    /// Load and limits, where both are known.
    pub(super) fn statics(&self) -> Option<(&Load, &Limits)> {
        Some((self.setting.load.as_ref().ok()?, self.setting.limits.as_ref().ok()?))
    }

    /// Everything that decides the answer, in words: two counts with the same words may be one.
    pub(super) fn words(&self) -> String {
        let Setting { load, limits, .. } = &self.setting;
        format!(
            "{}\n{}\n{load:?}\n{limits:?}\n{}\n{:?}\n{:?}\n{}",
            self.model.robot().to_toml(),
            self.model.composition(),
            self.criteria,
            self.archetype,
            self.bounds,
            self.step
        )
    }
}
