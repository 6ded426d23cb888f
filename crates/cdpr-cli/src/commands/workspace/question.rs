//! What is asked: robot, criteria, orientations and box.

use cdpr::geometry::Pose;
use cdpr::model::Model;
use cdpr::statics::Load;
use cdpr::tension::Limits;
use cdpr::workspace::criterion::registry::{self, Setting, Wanted};
use cdpr::workspace::{Archetype, Bounds, Criterion, Point, Region, WorkspaceError, hull};

use super::{Arguments, Method};
use crate::failure::Failure;
use crate::inputs::{pose_of, wrench_of};

pub(super) struct Question<'a> {
    pub(super) model: &'a Model,
    pub(super) archetype: Archetype,
    pub(super) bounds: Bounds,
    /// Largest side of a cell (m).
    pub(super) step: f64,
    pub(super) method: Method,
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
        let longest = (0..bounds.dimension()).map(|axis| bounds.extent(axis)).fold(0.0, f64::max);
        let cells = if bounds.dimension() == 2 { 100.0 } else { 50.0 };
        let step = arguments.step.unwrap_or(longest / cells);
        let setting = Setting { model, load, limits };
        let (method, criteria) = (arguments.method, arguments.criterion.join(" "));
        Ok(Self { model, archetype, bounds, step, method, setting, criteria, given })
    }

    pub(super) fn criterion(&self, wanted: &[Wanted]) -> Result<Box<dyn Criterion + 'a>, Failure> {
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

    /// Where rays start: the point given, the home pose where it belongs to the region, or the middle of a coarse grid.
    pub(super) fn center(&self, region: &Region<'_>) -> Result<Option<Point>, Failure> {
        if let Some(pose) = &self.given {
            return Ok(Some(region.point(&pose.position)));
        }
        let home = self.home(region);
        if self.bounds.contain(&home) && region.holds(&home) {
            return Ok(Some(home));
        }
        hull::find_center(region, &self.bounds).map_err(|error| Failure::refused("--bounds", &error))
    }

    /// The home position, where it is looked for first.
    pub(super) fn home(&self, region: &Region<'_>) -> Point {
        let home = region.point(&self.model.robot().home_or_middle().position);
        if self.bounds.contain(&home) { home } else { self.bounds.middle() }
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
