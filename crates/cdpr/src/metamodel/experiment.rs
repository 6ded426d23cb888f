//! A study with its models and its winches set: the one place that says how a study is run.

use super::control::Control;
use super::driving::Driving;
use super::input_error::InputError;
use super::operate::Operation;
use super::reachable::{Reachable, Requirements};
use super::study::{History, RobotModel, Study};
use super::winches::{initial_tensions, winch_offsets};
use crate::geometry::Pose;
use crate::model::{Composition, Model, StretchEffect};
use crate::robot::Robot;
use crate::tension::Limits;

/// A study with its models, and what follows from them before the first pose is commanded.
#[derive(Clone, Debug)]
pub struct Experiment {
    /// The study as its file states it.
    pub study: Study,
    /// The model that computes the lengths.
    pub control: Model,
    /// The model that answers.
    pub machine: Model,
    /// The model in use when the winches were set, where it is not the control model.
    pub former: Option<Model>,
    /// The pose at which the winches were set.
    pub start: Pose,
    /// Winch offsets added to the commanded lengths, one a cable (m).
    pub offsets: Vec<f64>,
}

impl Study {
    /// A robot with the effects of one side and the limits of the study.
    pub fn model_of(&self, side: &RobotModel, robot: Robot) -> Result<Model, InputError> {
        Ok(Model::new(self.limited(robot), side.model.parse::<Composition>()?)?)
    }

    /// The robot that was in use when the winches were set, with the effects of the control model; nothing where it is the
    /// control model's own.
    pub fn former(&self) -> Option<RobotModel> {
        let robot = self.initial.offset_robot.clone()?;
        Some(RobotModel { robot, model: self.control.model.clone() })
    }
}

impl History {
    /// How a machine comes to the poses: as stated, or from the initial pose; nothing where its cables do not remember.
    pub fn of(machine: &Model, stated: Option<Self>) -> Option<Self> {
        let remembers = machine.composition().stretch == StretchEffect::Hysteresis;
        remembers.then(|| stated.unwrap_or_default())
    }
}

impl Experiment {
    /// Sets the winches of the machine as the study says; `former` is the model in use then, where it is not the control model.
    pub fn new(study: Study, control: Model, machine: Model, former: Option<Model>) -> Result<Self, InputError> {
        let start = study.initial_pose(machine.robot())?;
        let offsets = winch_offsets(&study.initial, former.as_ref().unwrap_or(&control), &machine, &start)?;
        Ok(Self { study, control, machine, former, start, offsets })
    }

    /// The control model with its way to choose tensions.
    pub fn controller(&self) -> Control<'_> {
        Control { model: &self.control, tension_method: self.study.control.tension_method.unwrap_or_default() }
    }

    /// The model in use when the winches are set.
    pub fn set_with(&self) -> &Model {
        self.former.as_ref().unwrap_or(&self.control)
    }

    /// How the machine comes to the poses, where its cables remember.
    pub fn history(&self) -> Option<History> {
        History::of(&self.machine, self.study.history)
    }

    /// The machine under its control model, to be asked pose by pose.
    pub fn operation(&self) -> Result<Operation<'_>, InputError> {
        let operation = Operation::new(self.controller(), &self.machine, &self.offsets)?;
        Ok(match self.history() {
            Some(history) => operation.with_history(&history, &self.start),
            None => operation,
        })
    }

    /// The machine under its control model, to be asked from several threads.
    pub fn driving(&self) -> Result<Driving<'_>, InputError> {
        let driving = Driving::new(self.controller(), &self.machine, &self.offsets)?;
        Ok(match self.history() {
            Some(history) => driving.with_history(&history, &self.start),
            None => driving,
        })
    }

    /// Tension limits of the machine, if they are known.
    pub fn limits(&self) -> Option<Limits> {
        Limits::of(self.machine.robot(), None, None).ok()
    }

    /// Requirements of the study on a pose that counts as reached.
    pub fn requirements(&self) -> Requirements {
        let limits = self.study.limits.as_ref();
        Requirements {
            tensions: self.limits().filter(|_| self.machine.composition().depends_on_tension()),
            position_error_max: limits.and_then(|limits| limits.position_error_max_m),
            rotation_error_max: limits.and_then(|limits| limits.rotation_error_max_rad),
        }
    }

    /// Which poses count as reached.
    pub fn reachable(&self, requirements: Requirements) -> Result<Reachable<'_>, InputError> {
        Reachable::new(self.driving()?, requirements)
    }

    /// The tensions at which the winches were set (N); nothing where the study states offsets, or cables have none.
    pub fn initial_tensions(&self) -> Result<Option<Vec<f64>>, InputError> {
        let initial = &self.study.initial;
        let elastic =
            [&self.machine, self.set_with()].into_iter().find(|model| model.composition().depends_on_tension());
        match elastic.filter(|_| initial.offset.is_none() && initial.offset_m.is_none()) {
            Some(model) => initial_tensions(initial, model, &self.start).map(Some),
            None => Ok(None),
        }
    }
}
